"""Treatments in a plan: costs and where nothing is allowed, before the design; a treatment for each segment, after."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.construction.segments import segments_of
from firebreak_gis.construction.treating import Offers, Treated, with_treatments
from firebreak_gis.errors import ParameterError

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.breaks import Budget
    from firebreak_gis.construction.treatments import Treatments
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.stakes import StakePlanes, Stakes


def offers_of(landscape: xr.Dataset, table: Treatments, network: SpreadNetwork) -> Offers:
    """What a table of treatments offers in each cell of a landscape with this network."""
    edges = network.probability[network.probability > 0]
    return Offers(landscape, table, float(edges.mean(dtype=np.float64)) if edges.size else 0.0)


def priced(planes: StakePlanes, offers: Offers, budget: Budget) -> StakePlanes:
    """What a planner adds, with what the table of treatments adds to it.

    Nothing may be cut where no treatment is allowed. If the budget is money, a cell costs what its usual treatment
    does.

    Raises
    ------
    ParameterError
        If a budget in money has two prices, that of the table and another.
    """
    allowed = offers.allowed
    if not allowed[offers.fuel].all():
        planes = replace(planes, unpriced=~allowed if planes.unpriced is None else planes.unpriced | ~allowed)
    if budget.unit != "cost":
        return planes
    if planes.cost is not None:
        raise ParameterError("the table of treatments tells what cutting costs; leave --cost out, or the treatments")
    return replace(planes, cost=np.where(allowed, offers.usual[1], 0.0))


def treat(
    offers: Offers, network: SpreadNetwork, stakes: Stakes, breaks: xr.DataArray, priority: xr.DataArray, budget: Budget
) -> Treated:
    """Take the breaks apart into segments, and give each a treatment; for a budget in money they cost no more."""
    found = segments_of(
        network,
        breaks,
        priority=priority,
        elevation=offers.landscape["elevation"],
        cost=stakes.cost,
        value=stakes.value,
        ignition=stakes.ignition,
    )
    return with_treatments(found, offers, money=budget.amount if budget.unit == "cost" else None)
