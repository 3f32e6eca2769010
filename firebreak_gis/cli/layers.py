"""How commands read the layers that their options describe, and what they record of the options."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from firebreak_gis import plugins
from firebreak_gis.cli import parsing
from firebreak_gis.cli.session import Session
from firebreak_gis.errors import ParameterError
from firebreak_gis.rasters import file_of

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.grid import Grid
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.progress import Progress

#: The layers of a landscape, as the command line names them.
LAYERS = ("dem", "vegetation", "density")
#: Options that may name a file.
_FILES = (
    "dem",
    "vegetation",
    "density",
    "legend",
    "density_legend",
    "like",
    "ignitions",
    "wind_speed",
    "wind_from",
    "moisture",
)
#: Options for wind and moisture, and the parameters of spread models that they set.
WEATHER = {"wind_speed": "wind_speed", "wind_from": "wind_from_direction", "moisture": "moisture"}
#: Options that do not shape the result.
_TRANSIENT = ("output", "overwrite", "max_memory", "creation_options", "dry_run")


def input_files(given: Mapping[str, Any]) -> list[str]:
    """Files among the inputs of a command."""
    named = [file_of(str(given[k])) for k in _FILES if given.get(k) is not None]
    return list(dict.fromkeys(name for name in named if Path(name).is_file()))


def read_layers(given: Mapping[str, Any], session: Session, *, progress: Progress) -> xr.Dataset:
    """Read the landscape that the options describe and say what was done."""
    from firebreak_gis.landscape import read_landscape

    landscape = read_landscape(
        *(given[name] for name in LAYERS),
        **grid_options(given),
        unknown=given["unknown"],
        max_memory=parsing.byte_size(given["max_memory"]),
        progress=progress,
    )
    for sentence in landscape.attrs["alignment"]:
        session.say(sentence)
    for sentence in landscape.attrs["warnings"]:
        session.warn(sentence)
    return landscape


def grid_options(given: Mapping[str, Any]) -> dict[str, Any]:
    """What the options say of the layers and the grid, as `landscape.survey` takes it."""
    return {
        "legend": given["legend"],
        "density_legend": given["density_legend"],
        "crs": given["crs"],
        "resolution": given["resolution"],
        "bounds": given["bounds"] or None,
        "like": given["like"],
        "src_crs": _layer_crs(given["src_crs"]),
        "src_nodata": _layer_values(given["src_nodata"], "--src-nodata", float),
        "band": {layer: values[-1] for layer, values in _layer_values(given["bidx"], "--bidx", int).items()},
        "strict": given["strict"],
        "remote": given["remote"],
    }


def spread_params(given: Mapping[str, Any], grid: Grid) -> dict[str, Any]:
    """Parameters of the spread model from the options; rasters of wind and moisture are laid on the grid.

    Raises
    ------
    ParameterError
        If the model does not know what an option gives.
    InputError
        If a raster cannot be laid on the grid.
    """
    from firebreak_gis.landscape.planes import moisture_plane, wind_planes

    params = parsing.pairs(given["model_params"], "--model-param")
    known = {p["name"] for p in plugins.describe("spread", given["model"])["parameters"]}
    values = weather(given)
    speed, direction = wind_planes(values["wind_speed"], values["wind_from"], grid)
    planes = {"wind_speed": speed, "wind_from": direction, "moisture": moisture_plane(values["moisture"], grid)}
    if given.get("clock"):
        if "clock" not in known and given["model"] != "raster":
            raise ParameterError(f"the spread model {given['model']!r} tells no times; leave --clock out")
        params = ({"clock": True} if "clock" in known else {}) | params
    return {**{WEATHER[option]: plane for option, plane in planes.items() if WEATHER[option] in known}, **params}


def weather(given: Mapping[str, Any]) -> dict[str, float | str]:
    """Numbers, or names of rasters, of the options for wind and moisture.

    Raises
    ------
    ParameterError
        If a word is neither, or the spread model does not know what an option gives.
    """
    known = {p["name"] for p in plugins.describe("spread", given["model"])["parameters"]}
    values = {option: _number_or_path(given[option]) for option in WEATHER}
    for option, name in WEATHER.items():
        if name not in known and values[option] != 0.0:
            flag = option.replace("_", "-")
            raise ParameterError(f"the spread model {given['model']!r} knows no {name}; leave --{flag} out")
    return values


def _number_or_path(value: Any) -> float | str:
    try:
        return float(value)
    except (TypeError, ValueError):
        if not Path(file_of(str(value))).exists():
            raise ParameterError(f"{value!r} is neither a number nor a raster that exists") from None
        return str(value)


def checked_fires(given: Mapping[str, Any], network: SpreadNetwork) -> dict[str, Any]:
    """What the options say of the fires, looked at before hours of ranking.

    Raises
    ------
    InputError
        If no fire can start where it should.
    ParameterError
        If a number is impossible.
    """
    from firebreak_gis.landscape.planes import ignition_source
    from firebreak_gis.simulation.ignitions import resolve_ignitions

    ignitions = ignition_source(given["ignitions"], network.grid)
    mode, n_runs, seed = given["ignition_mode"], given["n_runs"], given["seed"]
    resolve_ignitions(network, ignitions, mode=mode, n_runs=n_runs, seed=seed)
    return {"ignitions": ignitions, "ignition_mode": mode, "n_runs": n_runs, "seed": seed}


def recorded(given: Mapping[str, Any]) -> dict[str, Any]:
    """Parameters worth keeping in run.json: those that shape the result, set ones only."""
    return {k: v for k, v in sorted(given.items()) if k not in _TRANSIENT and v is not None and v != () and v != {}}


def _layer_crs(words: Any) -> dict[str, str]:
    """Read LAYER=CRS words; a word without a layer (its CRS may hold "=" itself, as +proj=utm) is for all."""
    result: dict[str, str] = {}
    for word in [f"{k}={v}" for k, v in words.items()] if isinstance(words, Mapping) else words:
        layer, _, crs = str(word).partition("=")
        result.update({layer: crs} if layer in LAYERS else dict.fromkeys(LAYERS, str(word)))
    return result


def _layer_values(words: Any, option: str, kind: type) -> dict[str, list[Any]]:
    """Read LAYER=VALUE,VALUE words; what is given twice for a layer is added up."""
    result: dict[str, list[Any]] = {}
    for word in [f"{k}={v}" for k, v in words.items()] if isinstance(words, Mapping) else words:
        ((layer, text),) = parsing.pairs((word,), option).items()
        if layer not in LAYERS:
            raise ParameterError(f"{option} names {layer!r}, expected dem, vegetation or density")
        try:
            result.setdefault(layer, []).extend(kind(value) for value in str(text).split(","))
        except ValueError:
            raise ParameterError(f"{option} {layer} is {text!r}, expected a number") from None
    return result
