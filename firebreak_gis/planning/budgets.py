"""Budgets at which rankings are judged."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.breaks import Budget, can_be_cut

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.network import SpreadNetwork


def reachable(budgets: np.ndarray, priority: xr.DataArray, network: SpreadNetwork) -> np.ndarray:
    """Those of the budgets that protected cells leave enough cells for."""
    candidates = int(np.count_nonzero(can_be_cut(priority)))
    return budgets[[Budget(float(b)).cells(n_burnable=network.n_burnable) <= candidates for b in budgets]]


def few_budgets(*marked: float) -> np.ndarray:
    """Budgets for fires that must be burnt again for each: none, and around the marked ones, which are among them."""
    around = [min(factor * budget, 1.0) for budget in marked for factor in (0.0, 0.5, 1.0, 1.5, 2.0)]
    return np.unique(np.array([0.0, *around]))


def default_budgets(*marked: float, n_levels: int = 41) -> np.ndarray:
    """Evenly spaced budgets from 0 to beyond the marked ones, the marked ones among them."""
    top = min(1.0, max(0.4, 1.5 * max(marked, default=0.0)))
    return np.unique(np.concatenate([np.round(np.linspace(0.0, top, n_levels), 6), np.array(marked)]))
