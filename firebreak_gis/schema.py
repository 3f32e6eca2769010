"""Every variable that passes between the stages: name, dims, dtype, units, range, meaning; columns of vector files.

`annotate` writes the CF attributes, `validate` collects every problem before it raises, and the
raster writer takes units, nodata and colours from here, so a name never changes its unit. `Shown` is how the objects
that hold them print.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from html import escape
from types import MappingProxyType
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from firebreak_gis.errors import InputError
from firebreak_gis.lattice import DIRECTIONS

if TYPE_CHECKING:
    import geopandas as gpd
    import xarray as xr

#: Classes of `vegetation`; 0 holds no fuel.
VEGETATION: Mapping[int, str] = MappingProxyType({0: "none", 1: "agricultural", 2: "shrubs", 3: "pines"})
#: Classes of `density`; 0 where there is no fuel.
DENSITY: Mapping[int, str] = MappingProxyType({0: "none", 1: "sparse", 2: "normal", 3: "dense"})


@dataclass(frozen=True)
class Variable:
    """One variable of the pipeline.

    Parameters
    ----------
    name
        Name in datasets and stem of the file.
    dims
        Dimension names.
    dtype
        numpy dtype name, in memory and on disk.
    units
        UDUNITS text; "1" for shares and classes.
    text
        What it is, in one line (`long_name`, band description).
    minimum, maximum
        Closed range of valid values, None where open.
    nodata
        Value for "no data" in files.
    classes
        Meaning of each code, for class variables.
    along
        Dimension along which a simulation gives several such planes, each of which is written by itself.
    colours
        "#rrggbb" per class code, or a ramp (low to high) under keys 0, 1, 2, ... for continuous ones.
    bits
        Bits of a number in files that hold it packed, see `rasters.packing`; 0: as it is.
    """

    name: str
    dims: tuple[str, ...]
    dtype: str
    units: str
    text: str
    minimum: float | None = None
    maximum: float | None = None
    nodata: float | None = None
    classes: Mapping[int, str] = field(default_factory=dict)
    colours: Mapping[int, str] = field(default_factory=dict)
    along: str = ""
    bits: int = 0

    @property
    def bands(self) -> tuple[str, ...]:
        """Descriptions of its bands in a file."""
        if self.dims[0] != "direction":
            return (self.text,)
        return DIRECTIONS if self.name == "spread_probability" else tuple(f"{self.name} {d}" for d in DIRECTIONS)


def _ramp(*colours: str) -> Mapping[int, str]:
    return MappingProxyType(dict(enumerate(colours)))


# fmt: off
_VARIABLES = (
    Variable("elevation", ("y", "x"), "float32", "m", "terrain elevation", -500.0, 9000.0, -9999.0,
             colours=_ramp("#2d6a4f", "#95b46a", "#e9d8a6", "#b08968", "#f8f9fa")),
    Variable("vegetation", ("y", "x"), "uint8", "1", "vegetation type", 0, 3, 255, VEGETATION,
             MappingProxyType({0: "#d9d9d9", 1: "#e9d66b", 2: "#a3b18a", 3: "#2d6a4f"})),
    Variable("density", ("y", "x"), "uint8", "1", "vegetation density", 0, 3, 255, DENSITY,
             MappingProxyType({0: "#d9d9d9", 1: "#d8f3dc", 2: "#74c69d", 3: "#1b4332"})),
    Variable("vegetation_effect", ("y", "x"), "float32", "1",
             "effect of the vegetation type on spread, in place of the class", -1.0, None, -9999.0,
             colours=_ramp("#f7fcf5", "#74c476", "#00441b")),
    Variable("density_effect", ("y", "x"), "float32", "1",
             "effect of the vegetation density on spread, in place of the class", -1.0, None, -9999.0,
             colours=_ramp("#f7fcf5", "#74c476", "#00441b")),
    Variable("rate", ("y", "x"), "float32", "m h-1",
             "rate of spread on flat calm dry ground, in place of that of the class", 0.0, 6000.0, -9999.0,
             colours=_ramp("#fff7ec", "#fc8d59", "#7f0000")),
    Variable("dead_load", ("y", "x"), "float32", "kg m-2", "dead fuel, in place of that of the class", 0.0, 100.0,
             -9999.0, colours=_ramp("#fff7bc", "#fe9929", "#662506")),
    Variable("live_load", ("y", "x"), "float32", "kg m-2", "live fuel, in place of that of the class", 0.0, 100.0,
             -9999.0, colours=_ramp("#f7fcf5", "#74c476", "#00441b")),
    Variable("heat_content", ("y", "x"), "float32", "kJ kg-1",
             "heat content of the fuel, in place of that of the class", 0.0, 50_000.0, -9999.0,
             colours=_ramp("#fff7bc", "#fe9929", "#662506")),
    Variable("live_moisture", ("y", "x"), "float32", "1",
             "moisture of the live fuel, in place of that of the class", 0.0, 1.0, -9999.0,
             colours=_ramp("#fff7bc", "#41b6c4", "#081d58")),
    Variable("burnable", ("y", "x"), "bool", "1", "cell holds fuel"),
    Variable("spread_probability", ("direction", "y", "x"), "float32", "1",
             "probability that fire spreads from the cell to its neighbour in this direction", 0.0, 1.0,
             -9999.0, colours=_ramp("#ffffcc", "#fd8d3c", "#800026")),
    Variable("travel_time", ("direction", "y", "x"), "float32", "s",
             "time that fire takes from the cell to its neighbour in this direction", 0.0, 16777216.0,
             -9999.0, colours=_ramp("#7f0000", "#fc8d59", "#fef0d9")),
    Variable("heat", ("y", "x"), "float32", "kJ m-2", "heat released per area of the cell when it burns", 0.0, None,
             -9999.0, colours=_ramp("#fff7bc", "#fe9929", "#662506")),
    Variable("intensity", ("direction", "y", "x"), "float32", "kW m-1",
             "fire-line intensity of a fire that goes from the cell in this direction", 0.0, None,
             -9999.0, colours=_ramp("#fff7bc", "#fe9929", "#662506")),
    Variable("flame_length", ("direction", "y", "x"), "float32", "m",
             "flame length of a fire that goes from the cell in this direction", 0.0, None,
             -9999.0, colours=_ramp("#fff7bc", "#fe9929", "#662506")),
    Variable("priority", ("y", "x"), "float64", "1", "cutting priority, higher is cut earlier", None, None,
             -9999.0, colours=_ramp("#fcfdbf", "#fe9f6d", "#de4968", "#8c2981", "#000004")),
    Variable("breaks", ("y", "x"), "uint8", "1", "fire break", 0, 1, 255,
             MappingProxyType({0: "untouched", 1: "fire break"}),
             MappingProxyType({0: "#00000000", 1: "#1f4fd8"})),
    Variable("kept_share", ("y", "x"), "float64", "1",
             "share of its spread probability that the cell keeps once it is treated", 0.0, 1.0, -9999.0,
             colours=_ramp("#01665e", "#f6e8c3", "#8c510a")),
    Variable("suitability", ("y", "x"), "float32", "1", "how well a line can be held, 1 is best", 0.0, 1.0, -9999.0,
             colours=_ramp("#8c510a", "#f6e8c3", "#01665e")),
    Variable("burn_count", ("y", "x"), "uint32", "1", "runs in which the cell burns", 0, None, 4294967295,
             colours=_ramp("#ffffb2", "#fecc5c", "#fd8d3c", "#e31a1c", "#800026")),
    Variable("burn_frequency", ("y", "x"), "float32", "1", "share of runs in which the cell burns", 0.0, 1.0,
             -9999.0, colours=_ramp("#ffffb2", "#fecc5c", "#fd8d3c", "#e31a1c", "#800026")),
    Variable("grey_level", ("y", "x"), "uint16", "1",
             "burn frequency in 16 grey levels of equal width, 16 burns most often", 0, 256, 0,
             colours=_ramp("#000000", "#ffffff")),
    Variable("burnt_by", ("y", "x"), "float32", "1", "share of runs in which the cell has burnt by then", 0.0,
             1.0, -9999.0, colours=_ramp("#ffffb2", "#fecc5c", "#fd8d3c", "#e31a1c", "#800026"), along="time"),
    Variable("arrival_time", ("y", "x"), "float32", "s",
             "time from the start of the fire to its arrival, where it arrives", 0.0, None, -9999.0,
             colours=_ramp("#800026", "#e31a1c", "#fd8d3c", "#fecc5c", "#c7e9b4", "#41b6c4", "#225ea8"),
             along="quantile"),
    Variable("arrival", ("y", "x"), "uint32", "s", "time from the start of the fire to its arrival in one run",
             0, 4294967294, 4294967295, colours=_ramp("#800026", "#fd8d3c", "#c7e9b4", "#225ea8"), along="run"),
    Variable("burnt_in_class", ("y", "x"), "float32", "1",
             "share of runs in which the cell burns in a fire of this size class", 0.0, 1.0, -9999.0,
             colours=_ramp("#ffffb2", "#fecc5c", "#fd8d3c", "#e31a1c", "#800026"), along="size_from"),
    Variable("flame_exceedance", ("y", "x"), "float32", "1",
             "share of runs in which fire comes to the cell with longer flames", 0.0, 1.0, -9999.0,
             colours=_ramp("#fff5eb", "#fdae6b", "#f16913", "#8c2d04"), along="flame_length"),
    Variable("fire_paths", ("y", "x"), "float32", "1",
             "cells that fire goes on to by way of this cell, mean over the runs", 0.0, None, -9999.0,
             colours=_ramp("#fcfdbf", "#fe9f6d", "#de4968", "#8c2981", "#000004")),
    Variable("fire_size", ("run",), "int64", "1", "cells burnt in the run; ground that lines clear is not", 0),
    Variable("fire_size_by", ("run", "time"), "int64", "1", "cells burnt in the run by then", 0),
    Variable("duration", ("run",), "float64", "s", "how long the fire of the run may burn; inf if it ends by itself",
             0.0),
    Variable("containment", ("run",), "float64", "s",
             "when crews contain the fire of the run; inf if they do not", 0.0),
    Variable("weather", ("run",), "int64", "1", "number of the weather of the run, from 0", 0),
    Variable("value_lost", ("run",), "float64", "1", "value lost in the run, in the unit of the values at risk", 0.0),
)
# fmt: on

#: All variables by name.
VARIABLES: Mapping[str, Variable] = MappingProxyType({v.name: v for v in _VARIABLES})


@dataclass(frozen=True)
class Column:
    """One column of what is written as vectors.

    Parameters
    ----------
    text
        What it is, for people; with the unit it is the alias of the field in a GeoPackage.
    short
        Its name in a Shapefile, at most 10 letters.
    unit
        SI, "ha", or "" for numbers and shares, and for money and values, whose unit the user knows.
    digits
        Digits behind the point where people read it.
    zero
        What 0 means, if it is no amount.
    """

    text: str
    short: str
    unit: str = ""
    digits: int = 0
    zero: str = ""

    @property
    def alias(self) -> str:
        """The text with the unit, and with what 0 means."""
        more = [f"[{self.unit}]"] * bool(self.unit) + [f"(0: {self.zero})"] * bool(self.zero)
        return " ".join([self.text, *more])

    def told(self, value: object) -> str:
        """A value as people read it; a dash for nothing."""
        if isinstance(value, str):
            return value
        if value is None or value != value:
            return "\N{EN DASH}"
        if self.zero and value == 0:
            return self.zero
        # Numbers of things and years are no amounts: no comma in them.
        return f"{value:,.{self.digits}f} {self.unit}".strip() if self.unit or self.digits else f"{value:.0f}"


def _with_ends(name: str, text: str, short: str) -> dict[str, Column]:
    """An area, and the ends of its interval."""
    ends = {"low": "lower end of the 95 % interval", "high": "upper end"}
    both = {f"{name}_{end}": Column(f"{text}, {told}", f"{short}_{end}", "ha", 2) for end, told in ends.items()}
    return {name: Column(text, f"{short}_ha", "ha", 2), **both}


_NEVER, _BARE = "not within the years", "ground without fuel"
#: Factors of the siting, and the ground that each tells.
_GROUND = {
    "road": "roads",
    "river": "rivers",
    "ridge": "ridges",
    "valley": "valley bottoms",
    "edge": "the edge of the fuel",
    "slope": "gentle slopes",
    "access": "ground that is reached well",
}

# fmt: off
#: Columns of segments, treatments, breaks and gaps, compartments and fronts of fire, in the order of telling.
COLUMNS: Mapping[str, Column] = MappingProxyType({
    "order": Column("Place in the order of construction", "order"),
    "stage": Column("Stage of construction", "stage"),
    "year": Column("Year of construction", "year", zero=_NEVER),
    "year_begun": Column("Year in which building begins", "year_begun", zero=_NEVER),
    "return_years": Column("Return interval of the fuel", "return_yrs", "years", 1),
    "upkeep_year": Column("Cost of a year of upkeep, money or hectares", "upkeep_yr", digits=2),
    "upkeep_years": Column("Years of upkeep", "upkeep_yrs"),
    "number": Column("Place in the source", "number"),
    "rank": Column("Place by what it saves", "rank"),
    "keep": Column("Worth its upkeep", "keep"),
    "stands_until": Column("Last year in which it stands", "stands_til"),
    "compartment": Column("Compartment", "compartmnt"),
    "length_m": Column("Length", "length_m", "m"),
    "width_m": Column("Mean width", "width_m", "m", 1),
    "cells": Column("Cells", "cells"),
    "area_ha": Column("Area", "area_ha", "ha", 2),
    "mean_slope_deg": Column("Mean slope of the ground", "slope_mean", "degrees", 1),
    "max_slope_deg": Column("Steepest slope of the ground", "slope_max", "degrees", 1),
    "cost": Column("Cost", "cost", digits=2),
    "treatment": Column("Treatment", "treatment"),
    "treatment_residual": Column("Share of the spread that the treatment leaves", "treat_res", digits=3),
    "treatment_cost": Column("Cost of the treatment", "treat_cost", digits=2),
    "treatment_yearly": Column("Cost of the treatment a year", "treat_year", digits=2),
    "treatment_saving": Column("Expected loss that the treated segment saves", "treat_save", digits=2),
    "compartment_a": Column("Compartment on one side", "comp_a"),
    "compartment_b": Column("Compartment on the other side", "comp_b"),
    "gain": Column("Expected loss saved at its turn", "gain", digits=2),
    "gain_share": Column("Share of all that the breaks save", "gain_share", digits=5),
    "stage_gain_share": Column("Share of all that its stage saves", "gain_stage", digits=5),
    "intensity_kw_m": Column("Fire-line intensity to stop", "intensity", "kW/m"),
    "flame_length_m": Column("Flame length to stop", "flame_m", "m", 1),
    "breach": Column("Share of such fires that breach it", "breach", digits=3),
    "width_wilson_m": Column("Width that 5 % of them would breach", "wid_wilson", "m", 1),
    "width_flames_m": Column("Width of 1.5 flame lengths", "wid_flames", "m", 1),
    "mean_priority": Column("Mean priority", "mean_prior", digits=5),
    "ignition_share": Column("Share of ignitions", "ign_share", digits=5),
    "value": Column("Value", "value", digits=2),
    "expected_loss": Column("Expected loss", "exp_loss", digits=2),
    "burnt_value": Column("Value burnt in the simulated fires", "burnt_val", digits=2),
    **_with_ends("worth_ha", "Saved in the mean fire beside all others", "worth"),
    "worth_per_km": Column("Saved by a km of it, hectares", "worth_km", digits=2),
    **_with_ends("alone_ha", "Saved in the mean fire alone", "alone"),
    "random_ha": Column("Saved alone at random places", "random_ha", "ha", 2),
    "upkeep_ha": Column("To be treated anew every year", "upkeep_ha", "ha", 2),
    "from_break": Column("From break", "from_break", zero=_BARE),
    "to_break": Column("To break", "to_break", zero=_BARE),
    **_with_ends("saved_ha", "Saved in the mean fire if it is closed", "saved"),
    "saved_per_km": Column("Saved by closing a km, hectares", "saved_km", digits=2),
    "random_per_km": Column("Saved by a km at random places, hectares", "random_km", digits=2),
    "pod": Column("Compartment for operations", "pod"),
    "pod_a": Column("Compartment on one side", "pod_a"),
    "pod_b": Column("Compartment on the other side", "pod_b"),
    "fuel_ha": Column("Area with fuel", "fuel_ha", "ha", 2),
    "agricultural": Column("Share of the fuel that is agricultural", "agricult", digits=3),
    "shrubs": Column("Share of the fuel that is shrubs", "shrubs", digits=3),
    "pines": Column("Share of the fuel that is pines", "pines", digits=3),
    "burnt_ha": Column("Burnt in the mean fire", "burnt_ha", "ha", 2),
    "border_m": Column("Border with others", "border_m", "m"),
    "suitability": Column("Mean suitability of the border, 0 to 1", "suitabil", digits=2),
    **{f"on_{name}": Column(f"Share of the border that lies on {text}", f"on_{name}", digits=2)
       for name, text in _GROUND.items()},
    "hours": Column("Hours from the start of the fire", "hours", "h", 1),
})
# fmt: on


def annotate(data: xr.DataArray) -> xr.DataArray:
    """Return `data` with `long_name`, `units` and class meanings as CF attributes.

    Raises
    ------
    KeyError
        If `data.name` is not a variable of the schema.
    """
    variable = VARIABLES[str(data.name)]
    attrs: dict[str, object] = {"long_name": variable.text, "units": variable.units}
    if variable.classes:
        attrs["flag_values"] = np.array(list(variable.classes), dtype=variable.dtype)
        attrs["flag_meanings"] = " ".join(text.replace(" ", "_") for text in variable.classes.values())
    return data.assign_attrs(attrs)


class MapLayer(NamedTuple):
    """Lines or outlines of a result, as pictures and maps of it show them.

    Attributes
    ----------
    title
        What it is.
    frame
        One row a feature.
    column
        Column by which features are coloured, or None.
    legend
        What the column tells, with its unit.
    """

    title: str
    frame: gpd.GeoDataFrame
    column: str | None = None
    legend: str = ""


class Shown:
    """Prints as one line, and in a notebook as a small table: `facts` says what of it, `layers` what lies on a map."""

    def layers(self) -> Sequence[MapLayer]:
        """Lines and outlines, the lowest first; most things have none."""
        return ()

    def facts(self) -> Mapping[str, object]:
        """What matters, by name, as short text."""
        raise NotImplementedError

    def __repr__(self) -> str:
        return one_line(type(self).__name__, self.facts())

    def _repr_html_(self) -> str:
        return card(type(self).__name__, self.facts())


def percent(share: float) -> str:
    """A share for people: to a tenth of a per cent, and below one per cent to two digits, since large maps burn little.

    Examples
    --------
    >>> percent(0.961), percent(0.0), percent(0.000327)
    ('96.1 %', '0.0 %', '0.033 %')
    """
    value = 100.0 * share
    return f"{value:.2g} %" if 0.0 < value < 0.95 else f"{value:.1f} %"


def one_line(name: str, facts: Mapping[str, object]) -> str:
    """Facts for a terminal.

    Examples
    --------
    >>> one_line("Plan", {"by": "dissection", "cuts": "5 ha"})
    '<Plan: by dissection, cuts 5 ha>'
    """
    return f"<{name}: {', '.join(f'{key} {value}' for key, value in facts.items())}>"


def card(name: str, facts: Mapping[str, object], more: str = "") -> str:
    """Facts for a notebook, as HTML; `more` is HTML that comes after them.

    Examples
    --------
    >>> card("Plan", {"by": "<mine>"})
    '<div><strong>Plan</strong><table><tr><th>by</th><td>&lt;mine&gt;</td></tr></table></div>'
    """
    rows = "".join(f"<tr><th>{escape(key)}</th><td>{escape(str(value))}</td></tr>" for key, value in facts.items())
    return f"<div><strong>{escape(name)}</strong><table>{rows}</table>{more}</div>"


def validate(dataset: xr.Dataset, names: Iterable[str]) -> None:
    """Check that `dataset` holds the named variables with the dims, dtype and range of the schema.

    NaN counts as missing and passes. The values are looked at, so the cost is one pass over the data.

    Raises
    ------
    InputError
        Naming every problem found, not only the first.
    """
    problems = []
    for name in names:
        variable = VARIABLES[name]
        if name not in dataset:
            problems.append(f"{name} is missing (expected {variable.text}, dims {variable.dims})")
            continue
        data = dataset[name]
        if data.dims != variable.dims:
            problems.append(f"{name} has dims {data.dims}, expected {variable.dims}")
        if data.dtype != np.dtype(variable.dtype):
            problems.append(f"{name} has dtype {data.dtype}, expected {variable.dtype}")
            continue
        low, high = data.min(), data.max()
        if variable.minimum is not None and float(low) < variable.minimum:
            problems.append(
                f"{name} goes down to {float(low):g} {variable.units}, expected at least {variable.minimum:g}"
            )
        if variable.maximum is not None and float(high) > variable.maximum:
            problems.append(
                f"{name} goes up to {float(high):g} {variable.units}, expected at most {variable.maximum:g}"
            )
    if problems:
        raise InputError("the landscape is not usable: " + "; ".join(problems))
