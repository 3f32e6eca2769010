"""A plan as files: one table. A new output of a plan is an `Output` in it, and a row in docs/commands-and-files.md."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis import memory
from firebreak_gis.construction.writing import write_breaks, write_compartments, write_segments
from firebreak_gis.files import write_text
from firebreak_gis.files.outputs import Output, Writing, labels, names, write_all
from firebreak_gis.landscape.folder import OUTPUTS as LAYERS
from firebreak_gis.manifest import account, provenance, told
from firebreak_gis.progress import Progress
from firebreak_gis.rasters import files_behind, write_raster
from firebreak_gis.schema import annotate
from firebreak_gis.vectors import write_vector

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

    from firebreak_gis.planning.made import Plan


def _raster(
    name: str, label: str, get: Callable[[Plan], xr.DataArray], *, needs: str = "", main: bool = False
) -> Output[Plan]:
    def write(plan: Plan, path: Path, how: Writing) -> None:
        write_raster(
            path,
            get(plan),
            overwrite=how.overwrite,
            forbid=how.forbid,
            provenance=how.tags,
            creation_options=how.creation_options,
        )

    return Output(name, label, write, needs, main)


def _table(name: str, label: str, get: Callable[[Plan], pd.DataFrame]) -> Output[Plan]:
    def write(plan: Plan, path: Path, how: Writing) -> None:
        write_text(path, get(plan).to_csv(index=False, lineterminator="\n"), overwrite=how.overwrite)

    return Output(name, label, write)


def _evaluation_runs(plan: Plan) -> pd.DataFrame:
    from firebreak_gis.evaluation.curves import runs_table

    return runs_table(plan.evaluation)


def _evaluation(result: xr.Dataset) -> pd.DataFrame:
    from firebreak_gis.evaluation.curves import table

    return table(result)


def _years(plan: Plan) -> pd.DataFrame:
    """A row a year; none where all is built at once."""
    import pandas as pd

    return pd.DataFrame(columns=["year"]) if plan.years is None else plan.years.table


def _breaks(plan: Plan, path: Path, how: Writing) -> None:
    write_breaks(path, plan.polygons, overwrite=how.overwrite, forbid=how.forbid)


def _segments(plan: Plan, path: Path, how: Writing) -> None:
    write_segments(path, *plan.segments, overwrite=how.overwrite, forbid=how.forbid)


def _compartments(plan: Plan, path: Path, how: Writing) -> None:
    write_compartments(path, plan.compartments, overwrite=how.overwrite, forbid=how.forbid)


def _existing(plan: Plan, path: Path, how: Writing) -> None:
    write_vector(path, plan.existing, layer="existing", overwrite=how.overwrite, forbid=how.forbid)


def _present(plan: Plan) -> set[str]:
    """What of `Output.needs` there is."""
    there = {"existing": plan.standing is not None, "kept_share": np.ndim(plan.judged.fires.residual) > 0}
    return {str(name) for name in plan.landscape} | {name for name, made in there.items() if made}


def _overview(plan: Plan, path: Path, how: Writing) -> None:
    from firebreak_gis.report.figures import save

    save(plan.plot(), path, overwrite=how.overwrite)


def _page(plan: Plan, path: Path, how: Writing) -> None:
    from firebreak_gis.report.page import render
    from firebreak_gis.report.page.plan import plan_page

    parts = {
        **{f"{name}.tif": plan.landscape[name] for name in ("elevation", "vegetation", "density")},
        "breaks.tif": plan.breaks,
        "burn_frequency.tif": plan.before["burn_frequency"],
        "burn_frequency_with_breaks.tif": plan.after["burn_frequency"],
        "segments.gpkg": plan.segments[1],
        "compartments.gpkg": plan.compartments,
        "evaluation.csv": _evaluation(plan.evaluation),
    }
    if plan.standing is not None:
        parts["existing.gpkg"] = plan.existing
    present = names(OUTPUTS, _present(plan))
    files = [(name, label) for name, label in labels(OUTPUTS).items() if name in present]
    text = render(plan_page(parts, told("plan", how, _account(plan)) | {"files": files}))
    write_text(path, text, overwrite=how.overwrite)


def _kept(plan: Plan) -> xr.DataArray:
    kept = np.where(plan.network.burnable, plan.judged.fires.residual, np.nan)
    return annotate(plan.network.grid.dataarray(kept, "kept_share"))


def _note(plan: Plan) -> dict[str, str]:
    """What the curve shows, where it is not that of the paper's fires."""
    if not plan.judged.reburnt:
        return {}
    note = "Mean burnt share of the fuel when the first cells of each ranking are cut"
    return {"curve_note": f"{note}; {plan.judged.short}. The dashed line is this plan."}


def _account(plan: Plan) -> dict[str, Any]:
    return {
        "grid": plan.network.grid.describe(),
        "alignment": plan.landscape.attrs.get("alignment", []),
        "warnings": [*plan.landscape.attrs.get("warnings", []), *plan.feasibility.warnings],
        "feasibility": plan.feasibility.account,
        "headline": plan.headline,
        "assumptions": plan.judged.assumptions,
        "summary": plan.summary,
        **_note(plan),
        **_treatments(plan),
    }


def _treatments(plan: Plan) -> dict[str, Any]:
    """What each treatment does, and what that assumes, where a table of them is given."""
    if plan.request.design.treatments is None:
        return {}
    from firebreak_gis.construction.treatments import ASSUMED, totals

    return {"treatments": {"assumed": ASSUMED, **totals(plan.segments[1])}}


#: What a plan is written as.
OUTPUTS: tuple[Output[Plan], ...] = (
    *(layer.of(lambda plan: plan.landscape) for layer in LAYERS),
    _raster("priority.tif", "Cutting priority", lambda plan: plan.priority),
    _raster("breaks.tif", "Fire breaks", lambda plan: plan.breaks, main=True),
    _raster("kept.tif", "What each cell would keep of its spread once treated", _kept, needs="kept_share"),
    _raster("burn_frequency.tif", "Burn frequency without breaks", lambda plan: plan.before["burn_frequency"]),
    _raster(
        "burn_frequency_with_breaks.tif",
        "Burn frequency with the breaks",
        lambda plan: plan.after["burn_frequency"],
    ),
    Output("breaks.gpkg", "Fire breaks as polygons", _breaks, main=True),
    Output("segments.gpkg", "Segments to build, in order", _segments, main=True),
    Output("compartments.gpkg", "Compartments between the breaks", _compartments, main=True),
    Output("existing.gpkg", "Existing breaks, what each is worth, and whether it is kept up", _existing, "existing"),
    _table("goals.csv", "What the plan does for its goal and for all others", lambda plan: plan.goals),
    _table("years.csv", "What is built, kept up and burnt in each year", _years),
    _table("fire_sizes.csv", "Size of every fire without and with the breaks", lambda plan: plan.fire_sizes),
    _table("evaluation.csv", "Burnt share at every budget", lambda plan: _evaluation(plan.evaluation)),
    _table("evaluation_runs.csv", "Cells burnt in every run of it", _evaluation_runs),
    _table(
        "evaluation_timeless.csv",
        "Burnt share at every budget, without a clock and with perfect breaks",
        lambda plan: _evaluation(plan.paper),
    ),
    Output("overview.png", "Picture of the plan", _overview),
    Output("report.html", "The plan on one page: map, segments, doubt; opens in any browser", _page, main=True),
    account("plan", _account),
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
        The files of `OUTPUTS`, each raster with a QGIS style beside it.

    Raises
    ------
    OutputError
        If a file exists and `overwrite` is not set, or cannot be written; checked for all before the first is
        written.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> made = fb.plan(fb.read_landscape(**fb.sample_layers(), resolution=250.0), method="degree", n_runs=5)
    >>> "report.html" in [file.name for file in fb.write_plan(made, "out")]
    True
    """
    memory.give_back()
    recorded = parameters or result.parameters
    how = Writing(
        overwrite,
        inputs,
        files_behind(map(str, inputs)),
        creation_options or {},
        recorded,
        provenance(recorded, seed=result.request.fires.seed),
    )
    return write_all(OUTPUTS, result, folder, how, variables=_present(result), progress=progress)
