"""What is kept of fires with a clock, beside how often each cell burns: asked for in advance, added up run by run."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.errors import ParameterError
from firebreak_gis.lattice import STEP_LENGTH
from firebreak_gis.schema import annotate

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.kernels.tally import Tally
    from firebreak_gis.network import SpreadNetwork

#: Bins of arrival times, from which quantiles are read, and the end of the first [s].
_BINS, _FIRST_BIN = 32, 300.0
#: Arrivals are told up to here where runs have no end [s].
_HORIZON = 7 * 86_400


@dataclass(frozen=True)
class Products:
    """What is kept of the runs.

    Parameters
    ----------
    by
        Times [s], rising: how often a cell has burnt by then, and how large each fire was then.
    quantiles
        Shares of the runs in which the cell burns: the arrival time before which fire came in that share of them.
    size_classes
        Fire sizes [ha], rising, that part the fires into classes: how often the cell burns in a fire of each.
    flame_lengths
        Flame lengths [m], rising: how often fire comes to the cell with longer flames.
    paths
        Whether to count the cells that fire reaches by way of each cell.
    arrivals
        Whether to keep the arrival time of every cell in every run: 4 B a cell and run.

    Notes
    -----
    Quantiles are read from 32 bins of times, each longer than the last by one factor (1.16 for runs of 8 hours), and
    from straight lines within a bin. They are told up to 7 days where runs have no end. Memory a cell and thread: 4 B
    for each time, bin, class and flame length, 12 B for paths.

    Examples
    --------
    >>> import numpy as np, firebreak_gis as fb
    >>> network = fb.SpreadNetwork(np.ones((8, 5, 9)), travel_time=np.full((8, 5, 9), 600))
    >>> asked = fb.Products(by=(1800, 3600))
    >>> burns = fb.simulate(network, ignitions=[(0.5, -2.5)], duration="1h", n_runs=2, products=asked)
    >>> burns["fire_size_by"].to_numpy().tolist()
    [[20, 35], [20, 35]]
    """

    by: tuple[float, ...] = ()
    quantiles: tuple[float, ...] = ()
    size_classes: tuple[float, ...] = ()
    flame_lengths: tuple[float, ...] = ()
    paths: bool = False
    arrivals: bool = False

    def __post_init__(self) -> None:
        for name in ("by", "size_classes", "flame_lengths"):
            values = getattr(self, name)
            if any(not v > 0 for v in values) or any(b <= a for a, b in pairwise(values)):
                raise ParameterError(f"{name} is {', '.join(map(str, values))}, expected rising numbers above 0")
        if any(not 0 < q < 1 for q in self.quantiles):
            raise ParameterError(
                f"quantiles are {', '.join(map(str, self.quantiles))}, expected shares between 0 and 1"
            )

    @property
    def needs_times(self) -> bool:
        """Whether it matters when fire comes."""
        return self.arrivals or bool(self.by or self.quantiles or self.flame_lengths)

    def edges(self, longest: int) -> np.ndarray:
        """Ends of the bins of arrival times [s], (n_bins,) uint64, rising; `longest` is the longest duration [s]."""
        edges = {round(t) for t in self.by}
        if self.quantiles:
            end = max(min(longest, _HORIZON), 1)
            first = min(_FIRST_BIN, end / 2)
            edges |= {round(first * (end / first) ** (k / (_BINS - 1))) for k in range(_BINS)}
        return np.array(sorted(edge for edge in edges if edge > 0), np.uint64)


def new_tally(
    network: SpreadNetwork,
    products: Products,
    n_runs: int,
    *,
    longest: int,
    value: np.ndarray | None,
    by_parts: bool = False,
    rim: np.ndarray | None = None,
) -> Tally:
    """Empty sums for what is asked.

    Parameters
    ----------
    network
        The network, with heat if flame lengths are asked.
    products
        What is asked.
    n_runs
        Number of runs.
    longest
        The longest duration of a run [s].
    value
        (n_cells,) float64 lost where the cell burns, or None.
    by_parts
        Whether parts of cells burn, as where lines clear ground; see `kernels.tally.Tally.unit`.
    rim
        (rows, cols) bool, cells from which fire could leave a window of the map; None where there is no more map.
    """
    from firebreak_gis.kernels.tally import Tally
    from firebreak_gis.kernels.walls import GROUND

    n_cells, unit = network.burnable.size, GROUND if by_parts else 1
    edges = products.edges(longest)
    cell_area = network.grid.cell_area_ha if products.size_classes else 1.0
    classes = np.array([np.floor((limit / cell_area + 1e-9) * unit) for limit in products.size_classes], np.int64)
    # Byram 1959: L = 0.0775 I^0.46.
    intensities = np.array([(limit / 0.0775) ** (1 / 0.46) for limit in products.flame_lengths])
    metres = network.grid.cell_size if intensities.size else 1.0
    return Tally(
        counts=np.zeros(n_cells, np.uint32),
        unit=unit,
        sizes=np.zeros(n_runs, np.int64),
        value=np.zeros(0) if value is None else value,
        lost=np.zeros(0 if value is None else n_runs),
        edges=edges,
        by_time=np.zeros((n_cells if edges.size else 0, edges.size), np.uint32),
        growth=np.zeros((n_runs if edges.size else 0, edges.size), np.int64),
        classes=classes,
        by_size=np.zeros((n_cells if classes.size else 0, classes.size + 1), np.uint32),
        hanging=np.zeros(n_cells if products.paths else 0, np.uint32),
        onwards=np.zeros(n_cells if products.paths else 0, np.uint64),
        heat=np.zeros(0, np.float32) if network.heat is None else network.heat.ravel(),
        lengths=np.array(STEP_LENGTH) * metres,
        intensities=intensities,
        above=np.zeros((n_cells if intensities.size else 0, intensities.size), np.uint32),
        arrivals=np.full((n_runs if products.arrivals else 0, n_cells), 0xFFFFFFFF, np.uint32),
        rim=np.zeros(0, bool) if rim is None else rim.ravel(),
        reached=np.zeros(n_runs, bool),
    )


#: Sums that each thread has for itself, so that they can be added up in any order.
_OWN = ("counts", "by_time", "by_size", "hanging", "onwards", "above")


def own_sums(tally: Tally) -> Tally:
    """The same tally with sums of cells of its own, for one thread."""
    return tally._replace(**{name: np.zeros_like(getattr(tally, name)) for name in _OWN})


def add_up(total: Tally, parts: list[Tally]) -> None:
    """Add the sums of the threads to `total`."""
    for part in parts:
        for name in _OWN:
            if name != "hanging":
                np.add(getattr(total, name), getattr(part, name), out=getattr(total, name))


#: Sums a run.
_BY_RUN = ("sizes", "lost", "growth", "reached")


def part_of(tally: Tally, runs: np.ndarray) -> dict[str, np.ndarray]:
    """What some runs have come to, to be sent and kept: sums of the cells that burn, `cells`, and of the runs."""
    cells = np.flatnonzero(tally.counts)
    sums = {name: getattr(tally, name) for name in _OWN if name != "hanging"}
    return {
        "cells": cells.astype(np.uint32 if tally.counts.size < 1 << 32 else np.uint64),
        **{name: plane[cells] for name, plane in sums.items() if plane.size},
        **{name: each[runs] for name in _BY_RUN if (each := getattr(tally, name)).size},
    }


def take_part(total: Tally, runs: np.ndarray, part: Mapping[str, np.ndarray]) -> None:
    """Add what `part_of` gave of the runs to `total`."""
    for name, values in part.items():
        if name in _BY_RUN:
            getattr(total, name)[runs] = values
        elif name != "cells":
            getattr(total, name)[part["cells"]] += values


def in_cells(tally: Tally) -> Tally:
    """The same with sizes in cells: whole numbers, or float64 where lines clear parts of cells."""
    if tally.unit == 1:
        return tally
    return tally._replace(sizes=tally.sizes / tally.unit, growth=tally.growth / tally.unit)


def product_maps(network: SpreadNetwork, products: Products, tally: Tally) -> dict[str, xr.DataArray]:
    """Maps and tables of what was asked, by name; the tally is used up."""
    import xarray as xr

    n_runs = tally.sizes.size
    burnable = network.burnable

    def planes(name: str, dim: str, labels: tuple[float, ...], values: np.ndarray, units: str) -> xr.DataArray:
        masked = np.where(burnable, values.reshape(len(labels), *network.shape), np.nan).astype(np.float32)
        data = xr.concat([network.grid.dataarray(plane, name) for plane in masked], dim=dim)
        return annotate(data.assign_coords({dim: (dim, np.array(labels, np.float64), {"units": units})}))

    out: dict[str, xr.DataArray] = {}
    # In place: it is the largest of all arrays, and not needed as it was.
    until = np.cumsum(tally.by_time, axis=1, out=tally.by_time) if tally.by_time.size else tally.by_time
    if products.by:
        at = np.searchsorted(tally.edges, np.array([round(t) for t in products.by], np.uint64))
        out["burnt_by"] = planes("burnt_by", "time", products.by, until[:, at].T / n_runs, "s")
        growth = xr.DataArray(tally.growth[:, at], dims=("run", "time"), name="fire_size_by")
        out["fire_size_by"] = annotate(growth)
    if products.quantiles:
        times = [_quantile(tally.edges, until, tally.counts, q) for q in products.quantiles]
        out["arrival_time"] = planes("arrival_time", "quantile", products.quantiles, np.array(times), "1")
    if products.size_classes:
        out["burnt_in_class"] = planes(
            "burnt_in_class", "size_from", (0.0, *products.size_classes), tally.by_size.T / n_runs, "ha"
        )
    if products.flame_lengths:
        share = tally.above.T / n_runs
        out["flame_exceedance"] = planes("flame_exceedance", "flame_length", products.flame_lengths, share, "m")
    if products.paths:
        onwards = np.where(burnable, tally.onwards.reshape(network.shape) / n_runs, np.nan).astype(np.float32)
        out["fire_paths"] = annotate(network.grid.dataarray(onwards, "fire_paths"))
    if products.arrivals:
        each = [network.grid.dataarray(row.reshape(network.shape), "arrival") for row in tally.arrivals]
        out["arrival"] = annotate(xr.concat(each, dim="run"))
    return out


def _quantile(edges: np.ndarray, until: np.ndarray, counts: np.ndarray, share: float) -> np.ndarray:
    """Time at which `share` of the runs that burn each cell have reached it [s], NaN where none or later than told."""
    wanted = share * counts
    reached = until >= wanted[:, np.newaxis]
    k = np.argmax(reached, axis=1)
    cell = np.arange(counts.size)
    ends = edges.astype(np.float64)
    begins = np.append(0.0, ends[:-1])
    before = np.where(k > 0, until[cell, np.maximum(k - 1, 0)], 0)
    inside = until[cell, k] - before
    part = np.divide(wanted - before, inside, out=np.zeros(counts.size), where=inside > 0)
    known = (counts > 0) & reached.any(axis=1)
    return np.where(known, begins[k] + part * (ends - begins)[k], np.nan)
