"""What goes to the field: segments to build, pieces of break, compartments; in the format that the extension says."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Literal

from firebreak_gis.errors import InputError
from firebreak_gis.files.features import read_frame
from firebreak_gis.files.formats import Labels, format_of, require_kinds
from firebreak_gis.styles.vectors import Symbol, graduated
from firebreak_gis.vectors import write_layers, write_vector

if TYPE_CHECKING:
    import os

    import geopandas as gpd

#: What of segments goes into a format that holds one layer.
What = Literal["lines", "polygons"]

#: From the first stage of construction to the last, and from the least expected loss to the largest.
STAGE_COLOURS = ("#67001f", "#d6604d", "#f4a582", "#4393c3", "#2166ac")
LOSS_COLOURS = ("#ffffcc99", "#fecc5c99", "#e31a1c99")
#: Kind of geometry by layer, for empty ones.
KINDS: Mapping[str, str] = MappingProxyType(
    {"lines": "LineString", "polygons": "MultiPolygon", "compartments": "MultiPolygon", "breaks": "MultiPolygon"}
)
#: How each layer is called where people see it.
LABELS: Mapping[str, Labels] = MappingProxyType(
    {
        "lines": Labels("Segment", "order", "stage", STAGE_COLOURS),
        "polygons": Labels("Segment", "order", "stage", STAGE_COLOURS),
        "compartments": Labels("Compartment", "compartment", colours=("#8c510a",)),
        "breaks": Labels("Break", "order", colours=("#1f4fd8",)),
    }
)


def write_segments(
    path: str | os.PathLike[str],
    lines: gpd.GeoDataFrame,
    polygons: gpd.GeoDataFrame,
    *,
    what: What | None = None,
    **options: Any,
) -> Path:
    """Write segments: as a GeoPackage with the layers `lines` and `polygons`, coloured by stage, or as one of the two.

    Parameters
    ----------
    path
        Target; the extension chooses the format, see `vectors.write_vector`.
    lines, polygons
        As `segments.segments` returns them.
    what
        The one layer to write. Default: both in a GeoPackage, else the lines.
    **options
        `overwrite` and `forbid` of `vectors.write_layers`.
    """
    frames = {"lines": lines, "polygons": polygons}
    return _write(path, frames if what is None else {what: frames[what]}, **options)


def require_what(path: str | os.PathLike[str], what: What | None) -> None:
    """Refuse, before the work, a format that cannot hold what of segments is asked for.

    Raises
    ------
    OutputError
        Naming one that can.
    """
    require_kinds(Path(path), {KINDS[what or "lines"]})


def write_compartments(path: str | os.PathLike[str], table: gpd.GeoDataFrame, **options: Any) -> Path:
    """Write compartments in the layer `compartments`, in a GeoPackage coloured by expected loss.

    Parameters
    ----------
    path
        Target; the extension chooses the format, see `vectors.write_vector`.
    table
        As `compartments.compartments` returns it.
    **options
        `overwrite` and `forbid` of `vectors.write_layers`.
    """
    return _write(path, {"compartments": table}, **options)


def write_breaks(path: str | os.PathLike[str], pieces: gpd.GeoDataFrame, **options: Any) -> Path:
    """Write pieces of break in the layer `breaks`.

    Parameters
    ----------
    path
        Target; the extension chooses the format, see `vectors.write_vector`.
    pieces
        As `pieces.break_polygons` returns them.
    **options
        `overwrite` and `forbid` of `vectors.write_vector`.
    """
    return write_vector(path, pieces, layer="breaks", labels=LABELS["breaks"], kind=KINDS["breaks"], **options)


def read_written(path: str | os.PathLike[str]) -> dict[str, gpd.GeoDataFrame]:
    """Read the layers of a GeoPackage that one of these functions wrote, in its own CRS, by name.

    Raises
    ------
    InputError
        If it holds none of them, or cannot be read.
    """
    import pyogrio
    from pyogrio.errors import DataSourceError

    from firebreak_gis.files.gate import offline, vector_settings
    from firebreak_gis.grid import parse_crs

    target = parse_crs("EPSG:4326")  # of tables without a CRS, which these are not
    try:
        with offline(vector_settings):
            found = [str(row[0]) for row in pyogrio.list_layers(path) if row[0] in KINDS] if Path(path).exists() else []
    except DataSourceError:
        found = []
    if not found:
        read_frame(str(path), target, [])  # in its words, if it is missing or broken
        raise InputError(
            f"{path} holds none of the layers {', '.join(KINDS)}; give a GeoPackage that firebreak plan, segments or "
            "breaks wrote"
        )
    return {name: read_frame(f"{path}|layername={name}", target, [])[1] for name in found}


def write_layers_of(
    path: str | os.PathLike[str], frames: Mapping[str, gpd.GeoDataFrame], *, what: What | None = None, **options: Any
) -> Path:
    """Write what `read_written` read in another format; `what` chooses between the layers of segments.

    Raises
    ------
    InputError
        If there is no such layer.
    """
    if what is not None and what not in frames:
        raise InputError(f"there are no {what}, but {', '.join(frames)}; leave --what out")
    if "breaks" in frames:
        return write_breaks(path, frames["breaks"], **options)
    return _write(path, frames if what is None else {what: frames[what]}, **options)


def _write(path: str | os.PathLike[str], frames: Mapping[str, gpd.GeoDataFrame], **options: Any) -> Path:
    """All layers in a GeoPackage with their styles; the first in other formats."""
    if not format_of(Path(path)).several:
        name = next(iter(frames))
        return write_vector(path, frames[name], layer=name, labels=LABELS[name], kind=KINDS[name], **options)
    styles = {name: _STYLES[name](frame) for name, frame in frames.items()}
    return write_layers(path, frames, styles=styles, kinds={name: KINDS[name] for name in frames}, **options)


def _by_stage(frame: gpd.GeoDataFrame, symbol: Symbol, label: str | None) -> str:
    return graduated(
        frame["stage"].to_numpy(),
        column="stage",
        symbol=symbol,
        colours=STAGE_COLOURS,
        label=label,
        columns=frame.columns,
    )


def _by_loss(table: gpd.GeoDataFrame) -> str:
    return graduated(
        table["expected_loss"].to_numpy(),
        column="expected_loss",
        symbol="fill",
        colours=LOSS_COLOURS,
        label="compartment",
        columns=table.columns,
    )


_STYLES = {
    "lines": lambda frame: _by_stage(frame, "line", "order"),
    "polygons": lambda frame: _by_stage(frame, "fill", None),
    "compartments": _by_loss,
}
