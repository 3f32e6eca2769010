"""The report page of a folder that a plan or a comparison was written into."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from firebreak_gis.errors import InputError
from firebreak_gis.report.page import render
from firebreak_gis.report.page.comparison import comparison_page
from firebreak_gis.report.page.plan import plan_page

#: Rasters of a plan, and the variable that each holds.
_RASTERS = {
    "elevation.tif": "elevation",
    "vegetation.tif": "vegetation",
    "density.tif": "density",
    "breaks.tif": "breaks",
    "burn_frequency.tif": "burn_frequency",
    "burn_frequency_with_breaks.tif": "burn_frequency",
}
#: Vector files of a plan, and the layer that the page shows.
_VECTORS = {"segments.gpkg": "polygons", "compartments.gpkg": "compartments"}
#: The page that the run wrote itself.
_PAGE = "report.html"
#: Commands whose folders have a page.
COMMANDS = ("plan", "compare")


def report_page(folder: str | os.PathLike[str], labels: Mapping[str, str] | None = None) -> str:
    """Return the page of a folder as HTML.

    Parameters
    ----------
    folder
        What `firebreak plan` or `firebreak compare` wrote, its `run.json` among it.
    labels
        What each file is, by name, for the list of files; without it they stand there by name.

    Raises
    ------
    InputError
        If the folder holds no such run, or a file of it is missing or broken.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> landscape = fb.read_landscape(**fb.sample_layers(), resolution=250.0)
    >>> files = fb.write_plan(fb.plan(landscape, method="degree", n_runs=5), "out")
    >>> "Segments to build" in fb.report_page("out")
    True
    """
    import pandas as pd

    from firebreak_gis.grid import Grid
    from firebreak_gis.manifest import read_account
    from firebreak_gis.rasters import read_variable
    from firebreak_gis.vectors import read_features, read_polygons

    place, labels = Path(folder), labels or {}
    account = read_account(place / "run.json")
    command = account.get("command")
    if command not in COMMANDS:
        raise InputError(f"{place} holds a run of {command!r}; a report is made of those of {' or '.join(COMMANDS)}")
    written = [*(entry["path"] for entry in account.get("outputs", ())), "run.json"]
    missing = [name for name in written if name != _PAGE and not (place / name).is_file()]
    if missing:
        raise InputError(f"{place} lacks {', '.join(missing)}, which its run.json names; make the plan again")
    known = [name for name in labels if name in written]
    account["files"] = [(name, labels.get(name, "")) for name in (*known, *(n for n in written if n not in labels))]
    if command == "compare":
        return render(comparison_page(pd.read_csv(place / "comparison.csv"), account))
    parts: dict[str, Any] = {name: read_variable(place / name, kind) for name, kind in _RASTERS.items()}
    crs = Grid.of(parts["breaks.tif"]).crs
    for name, layer in _VECTORS.items():
        parts[name] = read_polygons(f"{place / name}|layername={layer}", crs)
    if "existing.gpkg" in written:
        parts["existing.gpkg"] = read_features(place / "existing.gpkg", crs)
    parts["evaluation.csv"] = pd.read_csv(place / "evaluation.csv")
    return render(plan_page(parts, account))
