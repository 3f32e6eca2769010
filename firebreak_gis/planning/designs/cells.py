"""Breaks of whole cells: the first of a ranking that the budget pays."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.breaks import select_breaks
from firebreak_gis.construction.pieces import break_polygons
from firebreak_gis.construction.segments import Segments, segments_of
from firebreak_gis.planning.budgets import reachable
from firebreak_gis.planning.design import design
from firebreak_gis.planning.designs import Design, Rest

if TYPE_CHECKING:
    import geopandas as gpd
    import xarray as xr

    from firebreak_gis.planning.setting import Setting
    from firebreak_gis.progress import Progress

#: The last of the chain, which is always asked.
ORDER = 100


def make(setting: Setting, _: Rest, progress: Progress) -> Cells:
    """Rank the cells, and cut the first."""
    request, network, about = setting.request.design, setting.network, setting.about
    trial = setting.trial
    priority = design(network, request.method, stakes=setting.stakes, **about, trial=trial, progress=progress)
    breaks = select_breaks(priority, budget=request.amount, burnable=network.burnable, cost=setting.stakes.cost)
    return Cells(setting, priority, breaks)


class Cells(Design):
    """Cells that are cut."""

    @property
    def laid(self) -> xr.DataArray:
        """The cells."""
        return self.breaks

    @property
    def ranked(self) -> xr.DataArray:
        """The priority: whatever is paid is cut first."""
        return self.priority

    def budgets(self, usual: Callable[[float], np.ndarray]) -> np.ndarray:
        """Those that protected cells leave enough cells for."""
        return reachable(usual(self.share), self.priority, self.setting.network)

    @property
    def share(self) -> float:
        """As asked, or what its cells are."""
        amount = self.setting.request.design.amount
        if amount.unit == "share":
            return amount.amount
        return float(self.breaks.attrs["cells_cut"] / max(self.setting.network.n_burnable, 1))

    def part(self, stands: np.ndarray) -> np.ndarray | None:
        """Cells of those segments."""
        return np.isin(self._numbers, np.flatnonzero(stands) + 1) if stands.any() else None

    @cached_property
    def _numbers(self) -> np.ndarray:
        """Number of the segment of each cell, from 1 in order, (rows, cols)."""
        from rasterio.features import rasterize

        polygons, network = self.segments.polygons, self.setting.network
        if not len(polygons):
            return np.zeros(network.shape, np.int32)
        shapes = zip(polygons.geometry, range(1, len(polygons) + 1), strict=True)
        return np.asarray(rasterize(shapes, network.shape, transform=network.grid.transform, dtype="int32"))

    @cached_property
    def segments(self) -> Segments:
        """See `segments.segments_of`."""
        stakes = self.setting.stakes
        return segments_of(
            self.setting.network,
            self.breaks,
            priority=self.priority,
            elevation=self.setting.landscape["elevation"],
            cost=stakes.cost,
            value=stakes.value,
            ignition=stakes.ignition,
        )

    @property
    def polygons(self) -> gpd.GeoDataFrame:
        """Connected cells, see `break_polygons`."""
        return break_polygons(self.breaks, self.priority)

    @property
    def figures(self) -> dict[str, Any]:
        """Cells, hectares and what cutting them costs."""
        cut = self.breaks.to_numpy() > 0
        count = int(np.count_nonzero(cut))
        return {
            "cells_cut": count,
            "ha_cut": round(count * self.setting.network.grid.cell_area_ha, 4),
            "cost": float(self.setting.stakes.cost[cut].sum()),
        }

    @property
    def told(self) -> str:
        """Cells of all, and hectares."""
        figures = self.figures
        return (
            f"{figures['cells_cut']} of {self.setting.network.n_burnable} cells with fuel cut "
            f"({figures['ha_cut']:,.1f} ha)"
        )
