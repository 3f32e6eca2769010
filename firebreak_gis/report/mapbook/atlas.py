"""What a map book shows, from the folder of a plan or from segments alone."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.construction.writing import read_written
from firebreak_gis.errors import InputError
from firebreak_gis.grid import Grid
from firebreak_gis.schema import COLUMNS

if TYPE_CHECKING:
    import geopandas as gpd

#: Ground shown around segments that come without a landscape, as a share of their extent, and its cells at most.
_AROUND, _CELLS = 0.05, 1500


@dataclass(frozen=True)
class Atlas:
    """What a map book shows.

    Parameters
    ----------
    title
        Of the book.
    lines, polygons
        Segments, as `construction.segments` makes them; polygons may be missing.
    grid
        Of the ground.
    elevation, vegetation
        (rows, cols), or None.
    compartments
        As `construction.compartments` makes them, or None.
    roads, water
        Lines and areas to draw, in the CRS of the grid, or None.
    headline, assumptions, warnings
        Sentences of the plan.
    sources
        Lines that say where it comes from.
    """

    title: str
    lines: gpd.GeoDataFrame
    grid: Grid
    polygons: gpd.GeoDataFrame | None = None
    elevation: np.ndarray | None = None
    vegetation: np.ndarray | None = None
    compartments: gpd.GeoDataFrame | None = None
    roads: gpd.GeoDataFrame | None = None
    water: gpd.GeoDataFrame | None = None
    headline: tuple[str, ...] = ()
    assumptions: tuple[str, ...] = ()
    warnings: tuple[str, ...] = ()
    sources: tuple[str, ...] = field(default=())

    @cached_property
    def has_cost(self) -> bool:
        """Whether the costs say more than the cells do; without prices each cell costs 1."""
        table = self.lines
        return "cost" in table and not ("cells" in table and np.allclose(table["cost"], table["cells"]))

    @cached_property
    def neighbours(self) -> dict[int, list[int]]:
        """Segments that touch each one, by place in the table."""
        import shapely

        shapes = (self.lines if self.polygons is None else self.polygons).geometry.to_numpy()
        one, other = shapely.STRtree(shapes).query(shapes, predicate="intersects")
        found: dict[int, list[int]] = {k: [] for k in range(len(shapes))}
        for a, b in zip(one.tolist(), other.tolist(), strict=True):
            if a != b:
                found[a].append(b)
        return {k: sorted(near) for k, near in found.items()}

    def facts(self, k: int) -> list[tuple[str, str]]:
        """Name and value of what is known of a segment, by its place in the table."""
        row = self.lines.iloc[k]
        shown = []
        for name, text in _FACTS.items():
            if name in row and (name != "cost" or self.has_cost) and not _missing(row[name]):
                shown.append((text, COLUMNS[name].told(row[name])))
        return shown

    def why(self, k: int) -> list[str]:
        """Sentences on what a segment is for."""
        row = self.lines.iloc[k]
        sides = [int(row.get(f"compartment_{side}", 0)) for side in "ab"]
        if sides[1] == 0:
            first = "Separates nothing: a spur or a patch that burns less. Build it last."
        else:
            first = f"Keeps fire from passing between {self._compartment(sides[0])} and {self._compartment(sides[1])}."
        sentences = [first]
        members = self.lines["order"][self.lines["stage"] == row["stage"]].astype(int).tolist()
        whole = f"adds {percent(row['stage_gain_share'])} of all that the breaks save" if "gain_share" in row else ""
        if len(members) == 1:
            sentences += [f"Built at its turn it {whole}."] if whole else []
        else:
            # The last of a stage gets its whole gain: what one of them adds by itself says nothing.
            stage = f"all {len(members)} segments of stage {int(row['stage'])} ({_ranges(members)}) stand"
            sentences.append(f"Works only when {stage}{whole and '; the stage ' + whole}.")
        if near := self.neighbours[k]:
            sentences.append(f"Meets {_ranges(sorted(self.lines['order'].iloc[near].astype(int)))}.")
        return sentences

    def _compartment(self, number: int) -> str:
        table = self.compartments
        if table is None or not (found := table[table["compartment"] == number]).shape[0]:
            return f"compartment {number}"
        return f"compartment {number} ({found['area_ha'].iloc[0]:,.1f} ha)"


#: What the box of a segment says, in order, and in which words.
_FACTS: Mapping[str, str] = {
    "year": "Year",
    "length_m": "Length",
    "width_m": "Width, mean",
    "area_ha": "Area",
    "mean_slope_deg": "Slope, mean",
    "max_slope_deg": "Slope, steepest",
    "treatment": "Treatment",
    "treatment_cost": "Cost of treatment",
    "treatment_yearly": "Cost a year",
    "cost": "Cost",
    "flame_length_m": "Flames to stop",
    "width_flames_m": "Width, 1.5 flames",
}


def read_atlas(
    source: str | os.PathLike[str],
    *,
    title: str = "",
    date: str = "",
    dem: str | None = None,
    roads: str | None = None,
    water: str | None = None,
) -> Atlas:
    """Read what a map book shows.

    Parameters
    ----------
    source
        Folder that `firebreak plan` wrote, or the GeoPackage of segments.
    title
        Of the book; by default what the plan says of itself.
    date
        Of the data or the print, as text.
    dem
        Elevation on any grid, for segments without a folder.
    roads, water
        Vector files to draw.

    Raises
    ------
    InputError
        If there is no plan, or a file of it is missing or broken.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> made = fb.plan(fb.read_landscape(**fb.sample_layers(), resolution=250.0), method="compartments", n_runs=5)
    >>> files = fb.write_plan(made, "out")
    >>> len(fb.read_atlas("out").lines) == len(made.segments.lines)
    True
    """
    place = Path(source)
    found = _folder(place) if place.is_dir() else _segments(place, dem)
    crs = found["grid"].crs
    if not len(found["lines"]):
        raise InputError(f"{place} holds no segment; a map book of nothing has no pages")
    for name, path in (("roads", roads), ("water", water)):
        if path is not None:
            from firebreak_gis.vectors import read_features

            found[name] = read_features(path, crs)
            found["sources"] += (f"{name.capitalize()}: {Path(path).name}",)
    if title:
        found["title"] = title
    if date:
        found["sources"] = (f"Date: {date}", *found["sources"])
    return Atlas(**found)


def _folder(place: Path) -> dict[str, Any]:
    from firebreak_gis.manifest import read_account
    from firebreak_gis.rasters import read_variable
    from firebreak_gis.report.page.plan import plan_title

    account = read_account(place / "run.json")
    if account["command"] != "plan":
        raise InputError(f"{place} holds a run of {account['command']!r}; a map book is made of one of plan")
    needed = ("elevation.tif", "vegetation.tif", "segments.gpkg", "compartments.gpkg")
    if missing := [name for name in needed if not (place / name).is_file()]:
        raise InputError(f"{place} lacks {', '.join(missing)}; make the plan again")
    elevation = read_variable(place / "elevation.tif", "elevation")
    segments = read_written(place / "segments.gpkg")
    inputs = [f"{Path(e['path']).name} (SHA-256 {e['sha256'][:12]})" for e in account.get("inputs", ())]
    return {
        "title": plan_title(account),
        "grid": Grid.of(elevation),
        "elevation": elevation.to_numpy().astype(np.float64),
        "vegetation": read_variable(place / "vegetation.tif", "vegetation").to_numpy(),
        "lines": segments["lines"],
        "polygons": segments["polygons"],
        "compartments": read_written(place / "compartments.gpkg")["compartments"],
        "headline": tuple(account.get("headline", ())),
        "assumptions": tuple(account.get("assumptions", ())),
        "warnings": tuple(account.get("warnings", ())),
        "sources": (
            f"Made by {account['software']} {account['version']}",
            *([f"From {', '.join(inputs)}"] if inputs else []),
        ),
    }


def _segments(place: Path, dem: str | None) -> dict[str, Any]:
    from affine import Affine

    from firebreak_gis.landscape.planes import elevation_plane

    frames = read_written(place)
    if "lines" not in frames:
        raise InputError(f"{place} holds {', '.join(frames)}, expected the layer lines of segments")
    lines = frames["lines"]
    if not len(lines):
        raise InputError(f"{place} holds no segment; a map book of nothing has no pages")
    left, bottom, right, top = lines.total_bounds
    side = max(right - left, top - bottom)
    cell = max(float(lines["width_m"].median()) if "width_m" in lines else 0.0, side / _CELLS)
    margin = _AROUND * side + 2 * cell
    shape = tuple(math.ceil((high - low + 2 * margin) / cell) for low, high in ((bottom, top), (left, right)))
    grid = Grid((shape[0], shape[1]), Affine(cell, 0, left - margin, 0, -cell, top + margin), lines.crs)
    return {
        "title": f"Fire breaks: {place.stem}",
        "grid": grid,
        "elevation": None if dem is None else elevation_plane(dem, grid),
        "lines": lines,
        "polygons": frames.get("polygons"),
        "sources": (f"From {place.name}", *([f"Elevation: {Path(dem).name}"] if dem else [])),
    }


def percent(share: float) -> str:
    """A share in per cent, with as many digits as make sense."""
    value = 100.0 * float(share)
    return "less than 0.01 %" if 0 < value < 0.01 else f"{value:.2g} %" if value < 10 else f"{value:.0f} %"


def _missing(value: Any) -> bool:
    return value is None or value != value or value == ""


def _ranges(numbers: list[int]) -> str:
    """Numbers with runs put together, the first dozen runs.

    Examples
    --------
    >>> _ranges([1, 2, 3, 7, 9, 10])
    '1-3, 7, 9, 10'
    """
    runs: list[list[int]] = []
    for number in numbers:
        if runs and number == runs[-1][-1] + 1:
            runs[-1].append(number)
        else:
            runs.append([number])
    words = [f"{run[0]}-{run[-1]}" if len(run) > 2 else ", ".join(map(str, run)) for run in runs]
    return ", ".join(words[:12]) + (" and more" if len(words) > 12 else "")
