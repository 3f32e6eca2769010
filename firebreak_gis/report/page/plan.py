"""The report page of a plan, from what its folder holds."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.breaks import Budget
from firebreak_gis.grid import Grid, crs_name
from firebreak_gis.report.figures import EXISTING_COLOUR, thin
from firebreak_gis.report.page import pictures
from firebreak_gis.report.page.content import Curve, Outlines, Page, Picture, Row
from firebreak_gis.report.page.values import plain, provenance
from firebreak_gis.schema import percent

if TYPE_CHECKING:
    import geopandas as gpd
    import pandas as pd

#: Colours of stages of construction, first to last, told apart on light and dark ground.
_STAGE_COLOURS = ("#7a0177", "#c51b8a", "#f768a1", "#2c7fb8", "#1f4fd8")


#: Segments, and compartments, that a page shows at most.
MOST = 4000


def plan_page(parts: Mapping[str, Any], account: Mapping[str, Any]) -> Page:
    """Return the page of a plan.

    Parameters
    ----------
    parts
        By file name, what the plan was written as: rasters as (y, x) DataArrays, `segments.gpkg` and
        `compartments.gpkg` as GeoDataFrames (of segments the polygons), tables as DataFrames. What is not there is
        left out of the page.
    account
        As `run.json` holds it.

    Returns
    -------
    Page
    """
    grid = Grid.of(parts["breaks.tif"])
    transform = grid.transform
    size = (grid.shape[1] * grid.cell_size, grid.shape[0] * grid.cell_size)
    origin = (float(transform.c), float(transform.f) - size[1])
    summary = account.get("summary", {})
    parts, left_out = _first(parts)
    drawn = _outlines(parts, origin)
    return Page(
        title=plan_title(account),
        headline=tuple(account.get("headline") or _headline(summary)),
        assumptions=tuple(account.get("assumptions", ())),
        warnings=(*account.get("warnings", ()), *left_out),
        figures=_figures(summary),
        size=size,
        origin=(*origin, "" if grid.crs is None else crs_name(grid.crs)),
        pictures=_pictures(parts, grid),
        outlines=drawn,
        curve=_curve(parts.get("evaluation.csv"), account),
        segments=_segments(_scheduled(parts["segments.gpkg"]) if "segments.gpkg" in parts else None),
        goals=_goals(summary.get("goals", ())),
        years=_years(summary.get("years", ())),
        files=tuple((name, label) for name, label in account.get("files", ()) if name != "report.html"),
        provenance=provenance(account),
    )


def _first(parts: Mapping[str, Any]) -> tuple[dict[str, Any], list[str]]:
    """What a browser can show of very many segments and compartments, and sentences on what is left out."""
    shown, told = dict(parts), []
    for file, what, number in (
        ("segments.gpkg", "segments", "order"),
        ("compartments.gpkg", "compartments", "compartment"),
    ):
        frame = parts.get(file)
        if frame is not None and len(frame) > MOST:
            shown[file] = frame[frame[number].rank(method="first") <= MOST]
            told.append(f"this page shows the first {MOST:,} of {len(frame):,} {what}; {file} holds all")
    return shown, told


def plan_title(account: Mapping[str, Any]) -> str:
    """What the account of a plan calls it: its method and its budget."""
    asked = account.get("parameters", {})
    asked_for = asked.get("budget", 0.1)
    budget = Budget.of(asked_for, None if isinstance(asked_for, str) else asked.get("budget_unit"))
    words = {"share": f"{100 * budget.amount:.3g} % of the fuel", "ha": f"{budget.amount:g} ha"}
    amount = words.get(budget.unit) or (asked_for if isinstance(asked_for, str) else f"{budget.amount:,.0f} (cost)")
    return f"Fire breaks by {asked.get('method', 'dissection')}, {amount}"


def _headline(summary: Mapping[str, Any]) -> tuple[str, ...]:
    if "burnt_share_without_breaks" not in summary:
        return ()
    before, after = (percent(summary[f"burnt_share_{side}_breaks"]) for side in ("without", "with"))
    return (f"In the mean of the simulated fires {before} of the fuel burns without the breaks and {after} with them.",)


def _figures(summary: Mapping[str, Any]) -> tuple[tuple[str, str, str], ...]:
    shown = []
    breaks = "if all breaks were built" if summary.get("unbuilt_segments") else "with the breaks"
    if "ha_cut" in summary:
        share = 100 * summary["ha_cut"] / max(summary.get("burnable_ha", 0.0), 1e-9)
        shown.append(
            ("Cut", f"{summary['ha_cut']:,.0f} ha", f"{share:.3g} % of {summary['burnable_ha']:,.0f} ha of fuel")
        )
    judged = summary.get("judged", {})
    for name, key, note in (
        ("Burnt in the mean", "burnt_ha", f"a fire, {breaks}"),
        ("Burnt in the worst tenth", "cvar_ha", f"mean of these fires, {breaks}"),
        ("Saved per hectare cut", "leverage", "hectares a fire"),
    ):
        if key in judged:
            low, high = judged[f"{key}_low"], judged[f"{key}_high"]
            digits = 1 if key == "leverage" else 0
            interval = f"{note}; 95 % interval {low:,.{digits}f} to {high:,.{digits}f}"
            shown.append((name, f"{judged[key]:,.{digits}f}" + ("" if key == "leverage" else " ha"), interval))
    return tuple(shown)


def _pictures(parts: Mapping[str, Any], grid: Grid) -> tuple[Picture, ...]:
    shown: list[Picture] = []
    if "elevation.tif" in parts:
        elevation = parts["elevation.tif"].to_numpy()
        water = None
        if "vegetation.tif" in parts:
            # Flat ground without fuel at the foot of the range is the sea, as in the overview.
            water = (thin(elevation) <= 0.0) & (thin(parts["vegetation.tif"].to_numpy()) == 0)
        shown.append(pictures.of_terrain(elevation, grid.cell_size, water))
        shown.append(
            pictures.of_numbers(
                "elevation", elevation, key="elevation", label="Elevation [m]", base=True, form="{:.0f} m".format
            )
        )
    for name, label in (("vegetation", "Vegetation type"), ("density", "Vegetation density")):
        if f"{name}.tif" in parts:
            shown.append(pictures.of_classes(name, parts[f"{name}.tif"].to_numpy(), key=name, label=label, base=True))
    frequencies = [parts[name].to_numpy() for name in _SIDES if name in parts]
    top = float(np.ceil(20 * max([0.05, *(float(np.nanmax(f, initial=0.0)) for f in frequencies)])) / 20)
    for (key, label), values in zip(_SIDES.values(), frequencies, strict=False):
        shown.append(
            pictures.of_numbers(
                "burn_frequency",
                np.where(thin(values) > 0, thin(values), np.nan),
                key=key,
                label=label,
                low=0.0,
                high=top,
                shown=True,
                form=lambda share: f"{100 * share:.3g} %",
            )
        )
    for file, data in parts.items():
        if file.startswith("arrival") and hasattr(data, "to_numpy"):
            hours = thin(data.to_numpy()).astype(np.float64) / 3600.0
            shown.append(
                pictures.of_numbers(
                    "burn_frequency",
                    hours,
                    key=file.removesuffix(".tif"),
                    low=0.0,
                    label="Arrival time of fire [h]",
                    form="{:.1f} h".format,
                )
            )
    return tuple(shown)


#: The two sides of the slider.
_SIDES = {
    "burn_frequency.tif": ("before", "Burn probability without the breaks"),
    "burn_frequency_with_breaks.tif": ("after", "Burn probability with the breaks"),
}


def _outlines(parts: Mapping[str, Any], origin: tuple[float, float]) -> tuple[Outlines, ...]:
    shown = []
    if "compartments.gpkg" in parts:
        frame = parts["compartments.gpkg"]
        cards = [
            {"number": len(parts.get("segments.gpkg", ())) + k, "card": _card(row, _COMPARTMENT)}
            for k, row in enumerate(frame.to_dict("records"))
        ]
        features = pictures.outlines(frame, origin, cards)
        shown.append(Outlines("compartments", "Compartments", features, "#4a3b20"))
    if "existing.gpkg" in parts:
        frame = parts["existing.gpkg"]
        before = sum(len(parts.get(name, ())) for name in ("segments.gpkg", "compartments.gpkg"))
        cards = [
            {"number": before + k, "card": _card(row, _EXISTING)} for k, row in enumerate(frame.to_dict("records"))
        ]
        features = pictures.outlines(frame, origin, cards)
        shown.append(Outlines("existing", "Existing breaks", features, EXISTING_COLOUR, shown=True))
    if "segments.gpkg" in parts:
        frame = _scheduled(parts["segments.gpkg"])
        stages = max(int(frame["stage"].max()), 1) if len(frame) else 1
        cards = [
            {
                "number": k,
                "colour": _STAGE_COLOURS[_stage_class(int(row["stage"]), stages)],
                "card": _card(row, _SEGMENT),
            }
            for k, row in enumerate(frame.to_dict("records"))
        ]
        features = pictures.outlines(frame, origin, cards)
        shown.append(Outlines("segments", "Segments to build", features, shown=True, legend=_stage_legend(stages)))
    return tuple(shown)


def _stage_class(stage: int, stages: int) -> int:
    """Which fifth of the stages a stage belongs to, from 0; the same for the map and its legend."""
    return min(4, 5 * (stage - 1) // stages)


def _stage_legend(stages: int) -> tuple[tuple[str, str], ...]:
    """A colour and its stages, first ones first.

    Examples
    --------
    >>> _stage_legend(7)[:2]
    (('#7a0177', 'stages 1 to 2'), ('#c51b8a', 'stage 3'))
    """
    entries = []
    for k, colour in enumerate(_STAGE_COLOURS):
        own = [stage for stage in range(1, stages + 1) if _stage_class(stage, stages) == k]
        if own:
            text = f"stage {own[0]}" if len(own) == 1 else f"stages {own[0]} to {own[-1]}"
            entries.append((colour, text))
    return tuple(entries)


#: Column, its name, the digits behind the point and the unit, of what a card and the table show.
_SEGMENT = (
    ("order", "Segment", 0, ""),
    ("stage", "Stage", 0, ""),
    ("year", "Year", 0, ""),
    ("length_m", "Length", 0, "m"),
    ("width_m", "Width", 0, "m"),
    ("area_ha", "Area", 2, "ha"),
    ("mean_slope_deg", "Slope", 1, "\N{DEGREE SIGN}"),
    ("cost", "Cost", 0, ""),
    ("gain_share", "Share of what is saved", 2, "%"),
    ("treatment_yearly", "Treatment a year", 0, ""),
)
_EXISTING = (
    ("number", "Existing break", 0, ""),
    ("length_m", "Length", 0, "m"),
    ("area_ha", "Area", 2, "ha"),
    ("worth_ha", "Burns more in the mean fire without it", 1, "ha"),
    ("upkeep_year", "Upkeep a year", 1, ""),
    ("stands_until", "Stands until year", 0, ""),
)
_COMPARTMENT = (
    ("compartment", "Compartment", 0, ""),
    ("area_ha", "Area", 1, "ha"),
    ("ignition_share", "Share of ignitions", 2, "%"),
    ("value", "Value", 0, ""),
    ("expected_loss", "Expected loss", 1, ""),
    ("burnt_value", "Value burnt in the simulated fires", 1, ""),
)


#: When a segment is built: what the table is grouped by.
_WHEN = (("year", "Year"), ("stage", "Stage"))


def _scheduled(frame: gpd.GeoDataFrame) -> gpd.GeoDataFrame:
    """Segments; those that are never built (year 0) have no year, so that they come last."""
    return frame.assign(year=frame["year"].where(frame["year"] > 0)) if "year" in frame else frame


def _card(row: Mapping[Any, Any], columns: tuple[tuple[str, str, int, str], ...]) -> dict[str, str]:
    card = {}
    for name, text, digits, unit in columns:
        if name in row:
            value = plain(row[name])
            if unit == "%" and value is not None:
                value = 100 * float(value)
            card[text] = "\N{EN DASH}" if value is None else f"{value:,.{digits}f} {unit}".strip()
    if "treatment" in row:
        card["Treatment"] = str(row["treatment"])
    return card


def _segments(frame: gpd.GeoDataFrame | None) -> tuple[Row, ...]:
    if frame is None or not len(frame):
        return ()
    known = [
        (name, f"{text} [{unit}]" if unit else text, digits, 100.0 if unit == "%" else 1.0)
        for name, text, digits, unit in _SEGMENT
        if name in frame
    ]
    decimals = {text: digits for _, text, digits, _ in known}
    summed = frozenset(text for name, text, _, _ in known if name in ("area_ha", "cost", "gain_share", "length_m"))
    rows = []
    for number, row in enumerate(frame.to_dict("records")):
        cells = {}
        for name, text, digits, factor in known:
            value = plain(row[name])
            cells[text] = None if value is None else round(factor * float(value), digits + 2)
        when = {text: plain(row[name]) for name, text in _WHEN if name in row}
        group = ", ".join(f"{text} {value:.0f}" for text, value in when.items() if value is not None)
        place = tuple(math.inf if value is None else value for value in when.values())
        rows.append(((*place, row["order"]), Row(cells, decimals, summed, number, group)))
    return tuple(row for _, row in sorted(rows, key=lambda pair: pair[0]))


def _years(rows: Sequence[Mapping[str, Any]]) -> tuple[Row, ...]:
    names = {
        "year": "Year",
        "built_ha": "Built [ha]",
        "standing_ha": "Standing [ha]",
        "spent_building": "Spent on building",
        "spent_upkeep": "Spent on upkeep",
        "burnt_ha": "Burnt [ha]",
        "value_lost": "Value lost",
        "saved_ha": "Saved [ha]",
    }
    if all(row["value_lost"] is None for row in rows):
        del names["value_lost"]
    decimals = {text: 1 for name, text in names.items() if name != "year"}
    summed = frozenset(text for name, text in names.items() if name not in ("year", "standing_ha"))
    return tuple(Row({text: row[name] for name, text in names.items()}, decimals, summed) for row in rows)


def _goals(rows: Sequence[Mapping[str, Any]]) -> tuple[Row, ...]:
    decimals = {"Without the breaks": 1, "With them": 1, "Saved [%]": 1, "At least [%]": 1, "At most [%]": 1}
    names = ("without_breaks", "with_breaks", "saved_share", "saved_share_low", "saved_share_high")
    shown = []
    for row in rows:
        of = "mean fire" if row["of"] == "mean" else "worst tenth of the fires"
        cells: dict[str, Any] = {"What": f"{row['loss']}, {of}" + (" (planned for)" if row["planned_for"] else "")}
        for name, text in zip(names, decimals, strict=True):
            number = row[name]
            cells[text] = None if number is None else (100 * number if "%" in text else number)
        shown.append(Row(cells, decimals))
    return tuple(shown)


def _curve(table: pd.DataFrame | None, account: Mapping[str, Any]) -> Curve | None:
    if table is None or not len(table):
        return None
    lines = [
        (str(method), rows["d_f"].tolist(), rows["mean"].tolist())
        for method, rows in table.groupby("method", sort=False)
    ]
    summary = account.get("summary", {})
    share = summary.get("cells_cut", 0) / max(summary.get("burnable_cells", 1), 1)
    if "line_km" in summary:  # lines take less than the cells that they pass
        share = summary["ha_cut"] / max(summary["burnable_ha"], 1e-9)
    note = account.get("curve_note") or (
        "Mean burnt share of the fuel when the first cells of each ranking are cut, burning until no fire can go on "
        "and breaks perfect. The dashed line is this plan."
    )
    return Curve("Burnt share against share cut", note, "share of the fuel cut", lines, share or None)
