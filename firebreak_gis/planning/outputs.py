"""A plan as files: rasters, vectors, tables, the picture, and the account of the run."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from firebreak_gis.construction.writing import write_compartments, write_segments
from firebreak_gis.evaluation.curves import table
from firebreak_gis.files import make_folder, require_writable, together, write_text
from firebreak_gis.landscape import write_landscape
from firebreak_gis.manifest import provenance, write_manifest
from firebreak_gis.progress import Progress, part
from firebreak_gis.rasters import write_raster
from firebreak_gis.vectors import write_vector

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.planning.pipeline import Plan

#: What a plan is written as.
PLAN_FILES = (
    "elevation.tif",
    "vegetation.tif",
    "density.tif",
    "priority.tif",
    "breaks.tif",
    "burn_frequency.tif",
    "burn_frequency_with_breaks.tif",
    "breaks.gpkg",
    "segments.gpkg",
    "compartments.gpkg",
    "fire_sizes.csv",
    "evaluation.csv",
    "overview.png",
    "run.json",
)


def write_plan(
    result: Plan,
    folder: str | os.PathLike[str],
    *,
    parameters: Mapping[str, Any] | None = None,
    inputs: Sequence[str | os.PathLike[str]] = (),
    creation_options: Mapping[str, Any] | None = None,
    overwrite: bool = False,
    progress: Progress | None = None,
) -> list[Path]:
    """Write every file of a plan into a folder: all of them appear together, or none.

    Parameters
    ----------
    result
        The plan.
    folder
        Made if it does not exist.
    parameters
        Parameters to record, by default those of the plan.
    inputs
        Files that went in; never overwritten, their hashes are recorded.
    creation_options
        More options of GDAL's COG driver.
    overwrite
        Whether existing files may be replaced.
    progress
        Callback (share done, message).

    Returns
    -------
    list of Path
        The files of `PLAN_FILES`, each raster with a QGIS style beside it.

    Raises
    ------
    OutputError
        If a file exists and `overwrite` is not set, or cannot be written; checked for all before the first is
        written.
    """
    report = part(progress, 0.0, 1.0, "write ")
    recorded = parameters or result.parameters
    with together(make_folder(folder), alone=True) as target:
        for name in PLAN_FILES:
            require_writable(target / name, overwrite=overwrite, forbid=inputs)
        written = _write_layers(result, target, recorded, creation_options, overwrite, report)
        written += _write_tables(result, target, overwrite, report)
        account = {
            "grid": result.network.grid.describe(),
            "alignment": result.landscape.attrs.get("alignment", []),
            "warnings": [*result.landscape.attrs.get("warnings", []), *result.feasibility.warnings],
            "feasibility": result.feasibility.account,
            "summary": result.summary,
        }
        written.append(
            write_manifest(
                target / "run.json",
                command="plan",
                parameters=recorded,
                inputs=inputs,
                outputs=written,
                account=account,
                overwrite=overwrite,
            )
        )
        # The last look at a stop: once the files are in place the run is done.
        report(1.0, "done")
    return written


def _write_layers(
    result: Plan,
    target: Path,
    recorded: Mapping[str, Any],
    creation_options: Mapping[str, Any] | None,
    overwrite: bool,
    report: Progress,
) -> list[Path]:
    tags = provenance(recorded, seed=result.request.fires.seed)
    rasters: dict[str, xr.DataArray] = {
        "priority.tif": result.priority,
        "breaks.tif": result.breaks,
        "burn_frequency.tif": result.before["burn_frequency"],
        "burn_frequency_with_breaks.tif": result.after["burn_frequency"],
    }
    report(0.0, "landscape")
    written = write_landscape(
        result.landscape, target, overwrite=overwrite, provenance=tags, creation_options=creation_options
    )
    for i, (name, data) in enumerate(rasters.items()):
        report(0.2 + 0.1 * i, name)
        write_raster(target / name, data, overwrite=overwrite, provenance=tags, creation_options=creation_options)
        written.append(target / name)
    return written


def _write_tables(result: Plan, target: Path, overwrite: bool, report: Progress) -> list[Path]:
    from firebreak_gis.report.figures import save
    from firebreak_gis.report.overview import overview_figure

    report(0.6, "breaks.gpkg")
    write_vector(target / "breaks.gpkg", result.polygons, layer="breaks", overwrite=overwrite)
    write_segments(target / "segments.gpkg", *result.segments, overwrite=overwrite)
    write_compartments(target / "compartments.gpkg", result.compartments, overwrite=overwrite)
    for name, frame in (("fire_sizes.csv", result.fire_sizes), ("evaluation.csv", table(result.evaluation))):
        write_text(target / name, frame.to_csv(index=False, lineterminator="\n"), overwrite=overwrite)
    report(0.7, "overview.png")
    figure = overview_figure(
        result.landscape,
        result.breaks,
        result.before,
        result.after,
        result.evaluation,
        title=_headline(result),
        budget=float(result.share),
    )
    save(figure, target / "overview.png", overwrite=overwrite)
    return [target / name for name in PLAN_FILES if not name.endswith(".tif") and name != "run.json"]


def _headline(result: Plan) -> str:
    summary = result.summary
    return (
        f"Fire breaks by {result.request.design.method}: "
        f"{100 * result.share:.3g} % of the fuel cut ({summary['ha_cut']:,.0f} ha), "
        f"mean burnt share {100 * summary['burnt_share_without_breaks']:.1f} % "
        f"\N{RIGHTWARDS ARROW} {100 * summary['burnt_share_with_breaks']:.1f} %"
    )
