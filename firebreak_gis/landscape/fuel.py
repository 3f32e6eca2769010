"""From codes on the grid to vegetation and density classes, by the legends."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from firebreak_gis.errors import InputError, LegendError
from firebreak_gis.grid import Grid
from firebreak_gis.landscape.continuity import CONTINUITY, density_by_continuity
from firebreak_gis.landscape.legends import Legend
from firebreak_gis.landscape.legends.burning import BURNING
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.schema import DENSITY

#: What every landscape holds.
LAYERS = ("elevation", "vegetation", "density")
#: What a landscape holds only where a legend gives numbers in place of classes.
INSTEAD = ("vegetation_effect", "density_effect", *BURNING.values())
#: So many unknown codes are listed in a message.
LISTED = 8


@dataclass(frozen=True)
class Fuel:
    """Fuel on the grid, all arrays (rows, cols).

    Parameters
    ----------
    vegetation, density
        uint8 class codes of the schema; density is 0 where vegetation is.
    instead
        float32 numbers in place of what the class has, NaN where the class counts, by variable; those of `INSTEAD`
        that a legend gives.
    unknown
        By "vegetation" and "density", the cells of each code that the legend does not list.
    lacking
        Cells with vegetation but without density.
    """

    vegetation: np.ndarray
    density: np.ndarray
    instead: Mapping[str, np.ndarray] = field(default_factory=dict)
    unknown: Mapping[str, Mapping[float, int]] = field(default_factory=dict)
    lacking: int = 0


def fuel_of(
    codes: np.ndarray,
    cover: np.ndarray | str | None,
    legend: Legend,
    density_legend: Legend,
    *,
    inner: tuple[slice, slice] = (slice(None), slice(None)),
) -> Fuel:
    """Look the codes up.

    Parameters
    ----------
    codes
        Vegetation codes as floats, NaN for no data.
    cover
        Density codes (or a quantity) likewise; the name of one class; "continuity"; or None.
    legend, density_legend
        For `codes` and `cover`.
    inner
        Rows and columns of `codes` that are looked up; those around count for the continuity alone.
    """
    closed = None
    if isinstance(cover, str) and cover == CONTINUITY:
        closed = density_by_continuity(legend.column("vegetation", 0)[_look_up(codes, legend)[0]] > 0)[inner]
    index, unknown = _look_up(codes[inner], legend)
    unknowns = {"vegetation": unknown}
    vegetation = legend.column("vegetation", 0)[index].astype(np.uint8)
    density = legend.column("density", np.nan)[index]
    density_effect = _effect(legend, "density_effect", index)
    if cover is not None:
        replaced = (legend.column("density_from_raster", 1)[index] == 1) | np.isnan(density)
        given_effect = None
        if closed is not None:
            given = closed.astype(np.float64)
        elif isinstance(cover, str):
            given = np.full(vegetation.shape, float(_density_code(cover)))
        else:
            where, unknowns["density"] = _look_up(np.where(vegetation > 0, cover, np.nan), density_legend)
            given = density_legend.column("density", np.nan)[where]
            given_effect = _effect(density_legend, "density_effect", where)
        density = np.where(replaced, given, density)
        density_effect = _merge(density_effect, given_effect, replaced)
    lacking = int(np.count_nonzero(np.isnan(density) & (vegetation > 0)))
    classes = np.where(np.isnan(density) | (vegetation == 0), 0, density).astype(np.uint8)
    numbers = {name: _effect(legend, name, index) for name in INSTEAD} | {"density_effect": density_effect}
    burns = classes > 0
    instead = {name: np.where(burns, plane, np.float32(np.nan)) for name, plane in numbers.items() if plane is not None}
    return Fuel(vegetation, classes, instead, unknowns, lacking)


@dataclass
class Lacks:
    """Cells of a landscape, gathered part by part, in which something lacks; numbers as in `Fuel`."""

    unknown: dict[str, dict[float, int]] = field(default_factory=dict)
    lacking: int = 0
    blind: int = 0
    burnable: int = 0

    def add(self, fuel: Fuel, elevation: np.ndarray) -> np.ndarray:
        """Look at one more part; where it can burn."""
        grows = (fuel.vegetation > 0) & (fuel.density > 0)
        burnable = grows & np.isfinite(elevation)
        blind, seeing = (int(np.count_nonzero(each)) for each in (grows & ~burnable, burnable))
        self.join(Lacks({name: dict(codes) for name, codes in fuel.unknown.items()}, fuel.lacking, blind, seeing))
        return np.asarray(burnable)

    def join(self, other: Lacks) -> None:
        """Add what lacks in other parts."""
        for name, codes in other.unknown.items():
            known = self.unknown.setdefault(name, {})
            for code, number in codes.items():
                known[code] = known.get(code, 0) + number
        self.lacking += other.lacking
        self.blind += other.blind
        self.burnable += other.burnable

    def require(self, legends: Mapping[str, Legend], grid: Grid, account: Account, unknown: str) -> None:
        """Refuse, or warn of, what was found.

        Parameters
        ----------
        legends
            Of "vegetation" and "density".
        grid
            Of the whole.
        account
            Warnings are added to it.
        unknown
            "refuse" or "nonburnable".

        Raises
        ------
        LegendError
            For codes that a legend does not list, with their areas.
        InputError
            If nothing can burn.
        """
        for name, codes in self.unknown.items():
            if codes:
                _refuse_unknown(codes, legends[name], name, grid, account, unknown)
        cells = grid.shape[0] * grid.shape[1]
        if self.lacking:
            account.warn(
                f"{self.lacking} cells with vegetation have no density and are taken as not burnable "
                f"({self.lacking / cells:.2%} of the grid)"
            )
        if self.blind:
            account.warn(
                f"{self.blind} cells with fuel have no elevation and are taken as not burnable "
                f"({self.blind / cells:.2%} of the grid)"
            )
        if not self.burnable:
            raise InputError(
                "no cell can burn: nowhere do vegetation, density and elevation meet; check the legend and "
                "the no-data values"
            )


def given_instead(legend: Legend, density_legend: Legend | None) -> set[str]:
    """Variables that `fuel_of` makes where legends give numbers; `density_legend` is None without a raster for it."""
    found = {name for name in INSTEAD if not np.isnan(legend.column(name, np.nan)).all()}
    if density_legend is not None and not np.isnan(density_legend.column("density_effect", np.nan)).all():
        found.add("density_effect")
    return found


def burnable_cells(layers: Mapping[Any, Any]) -> np.ndarray:
    """Return where vegetation, density and elevation meet, (rows, cols) bool."""
    elevation, vegetation, density = (np.asarray(layers[name]) for name in LAYERS)
    return np.asarray((vegetation > 0) & (density > 0) & np.isfinite(elevation))


def _density_code(name: str) -> int:
    return next(code for code, label in DENSITY.items() if label == name)


def _effect(legend: Legend, name: str, index: np.ndarray) -> np.ndarray | None:
    column = legend.column(name, np.nan)
    return None if np.isnan(column).all() else np.asarray(column.astype(np.float32)[index])


def _merge(own: np.ndarray | None, given: np.ndarray | None, replaced: np.ndarray) -> np.ndarray | None:
    if own is None and given is None:
        return None
    blank = np.full(replaced.shape, np.nan, dtype=np.float32)
    return np.where(replaced, blank if given is None else given, blank if own is None else own)


def _look_up(values: np.ndarray, legend: Legend) -> tuple[np.ndarray, dict[float, int]]:
    """Index of the legend's entry for each cell, -1 where there is no data; cells of each code that it does not list.

    Of a legend with ranges the ends of the unknown stand for all of them, since its values may all differ.
    """
    index = legend.find(values)
    strange = values[(index < 0) & np.isfinite(values)]
    missing = legend.column("missing", 0)
    if missing.any():
        index = np.where(missing[index] == 1, -1, index)
    if not strange.size:
        return index, {}
    if legend.continuous and strange.min() < strange.max():
        return index, {float(strange.min()): 1, float(strange.max()): strange.size - 1}
    codes, counts = np.unique(strange, return_counts=True)
    return index, dict(zip(codes.tolist(), counts.tolist(), strict=True))


def _refuse_unknown(
    codes: Mapping[float, int], legend: Legend, name: str, grid: Grid, account: Account, unknown: str
) -> None:
    areas = _areas(codes, legend, grid)
    if unknown == "refuse":
        raise LegendError(
            f"the {name} raster holds codes that the legend {legend.name} does not list: {areas}. Give the "
            f"right legend "
            f"(--legend, --density-legend), add the codes to an own one, declare no data (--src-nodata "
            f"{name}=...), or take them "
            "as land without fuel (--unknown nonburnable)" + _hint(codes, legend, name)
        )
    account.warn(f"{name}: codes not in the legend {legend.name} were taken as land without fuel: {areas}")


def _areas(codes: Mapping[float, int], legend: Legend, grid: Grid) -> str:
    if legend.continuous:
        return f"{min(codes):g} to {max(codes):g} ({sum(codes.values()) * grid.cell_area_ha:.6g} ha)"
    most = sorted(codes, key=lambda code: (-codes[code], code))[:LISTED]
    told = ", ".join(f"{code:g} ({codes[code] * grid.cell_area_ha:.6g} ha)" for code in sorted(most))
    return told + (f" and {len(codes) - LISTED} more" if len(codes) > LISTED else "")


def _hint(codes: Mapping[float, int], legend: Legend, name: str) -> str:
    if name == "density" and not legend.continuous and max(codes) <= 100 and len(codes) > LISTED:
        return "; if it is a cover in percent, take the density legend canopy_cover or tree_cover_density"
    return ""
