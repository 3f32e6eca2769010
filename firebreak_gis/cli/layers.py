"""How commands read the layers that their options describe, and what they record of the options."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from firebreak_gis.cli import options
from firebreak_gis.cli.session import Session
from firebreak_gis.errors import ParameterError

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.progress import Progress

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
)
#: Options that do not shape the result.
_TRANSIENT = ("output", "overwrite", "max_memory", "creation_options")


def input_files(given: Mapping[str, Any]) -> list[str]:
    """Files among the inputs of a command."""
    return [str(given[k]) for k in _FILES if given.get(k) is not None and Path(str(given[k])).is_file()]


def read_layers(given: Mapping[str, Any], session: Session, *, progress: Progress) -> xr.Dataset:
    """Read the landscape that the options describe and say what was done."""
    from firebreak_gis.landscape import read_landscape

    landscape = read_landscape(
        given["dem"],
        given["vegetation"],
        given["density"],
        legend=given["legend"],
        density_legend=given["density_legend"],
        crs=given["crs"],
        resolution=given["resolution"],
        bounds=given["bounds"] or None,
        like=given["like"],
        src_nodata=_layer_values(given["src_nodata"], "--src-nodata", float),
        band=_layer_values(given["bidx"], "--bidx", int),
        unknown=given["unknown"],
        strict=given["strict"],
        max_memory=options.byte_size(given["max_memory"]),
        progress=progress,
    )
    for sentence in landscape.attrs["alignment"]:
        session.say(sentence)
    for sentence in landscape.attrs["warnings"]:
        session.warn(sentence)
    return landscape


def recorded(given: Mapping[str, Any]) -> dict[str, Any]:
    """Parameters worth keeping in run.json: those that shape the result, set ones only."""
    return {k: v for k, v in sorted(given.items()) if k not in _TRANSIENT and v is not None and v != () and v != {}}


def _layer_values(words: Any, option: str, kind: type) -> dict[str, Any] | None:
    values = options.pairs(words, option)
    result: dict[str, Any] = {}
    for layer, value in values.items():
        if layer not in ("dem", "vegetation", "density"):
            raise ParameterError(f"{option} names {layer!r}, expected dem, vegetation or density")
        try:
            result[layer] = kind(value)
        except (TypeError, ValueError):
            raise ParameterError(f"{option} {layer} is {value!r}, expected a number") from None
    return result or None
