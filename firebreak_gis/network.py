"""The spread network: every cell of a grid can light its eight neighbours with a probability."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from firebreak_gis.errors import GridError, InputError, MissingComponentError, ParameterError
from firebreak_gis.grid import UNREFERENCED, Grid, parse_crs
from firebreak_gis.lattice import COL_STEP, DIRECTIONS, LONGEST, NEVER, OPPOSITE, ROW_STEP, close_boundary
from firebreak_gis.schema import Shown, annotate

if TYPE_CHECKING:
    import networkx as nx
    import scipy.sparse
    import xarray as xr
    from affine import Affine

    Residual = float | np.ndarray | xr.DataArray

Boundary = Literal["open", "periodic"]


@dataclass(frozen=True, eq=False, init=False, repr=False)
class SpreadNetwork(Shown):
    """A directed network on a square grid; the one object that all rankings and simulations take.

    Parameters
    ----------
    probability
        (8, rows, cols), numbers in [0, 1] or a DataArray of these dims. `probability[d, row, col]` points
        FROM the cell TO its neighbour in direction d (N NE E SE S SW W NW). Copied to float32. Edges that
        leave an open grid, or that touch a cell without fuel, are set to 0.
    burnable
        (rows, cols) bool: which cells hold fuel. Default: those with any edge in or out.
    boundary
        `"open"`, or `"periodic"`: the grid is a torus (an artificial forest).
    crs, transform
        Where the grid lies; taken from `probability` if that is a DataArray.
    provenance
        What is to be known of the network, as plain data.
    travel_time
        (8, rows, cols) seconds that fire takes along each edge, for fires with a clock; None for a network without
        times. Whole numbers, or floats with NaN where there is no edge, which are rounded; at least 1 on every edge
        with p > 0. Kept as uint32: `lattice.NEVER` where p = 0; what is longer than `lattice.LONGEST` (194 days) is
        set to it.
    heat
        (rows, cols) heat that a cell releases per area of the map when it burns [kJ/m2]; needs `travel_time`. Then
        `intensity` and `flame_length` are known.

    Raises
    ------
    GridError
        If a shape does not fit.
    InputError
        If a probability is NaN or outside [0, 1], an edge has no time, or a heat is negative or missing on fuel.

    Examples
    --------
    >>> network = SpreadNetwork(np.full((8, 3, 4), 0.5))
    >>> network.n_burnable, network.treated(np.eye(3, 4)).probability[:, 1, 1].any()
    (12, np.False_)
    """

    probability: np.ndarray
    burnable: np.ndarray
    boundary: Boundary
    grid: Grid
    provenance: dict[str, Any] = field(default_factory=dict)
    travel_time: np.ndarray | None = None
    heat: np.ndarray | None = None

    def __init__(
        self,
        probability: np.ndarray | xr.DataArray,
        *,
        burnable: np.ndarray | xr.DataArray | None = None,
        boundary: Boundary = "open",
        crs: Any = None,
        transform: Affine | None = None,
        provenance: dict[str, Any] | None = None,
        travel_time: np.ndarray | xr.DataArray | None = None,
        heat: np.ndarray | xr.DataArray | None = None,
    ) -> None:
        grid = Grid.of_directions(probability) if hasattr(probability, "dims") else None
        values = np.array(probability, dtype=np.float32, order="C")
        if values.ndim != 3 or values.shape[0] != 8 or 0 in values.shape:
            raise GridError(f"probability has shape {values.shape}, expected (8, rows, cols)")
        if boundary not in ("open", "periodic"):
            raise ParameterError(f"boundary is {boundary!r}, expected 'open' or 'periodic'")
        if not (values.min() >= 0.0 and values.max() <= 1.0):  # also catches NaN
            raise InputError(
                f"probabilities lie in [{values.min()}, {values.max()}], expected numbers from 0 to 1 "
                "without NaN; use 0 where there is no fuel"
            )
        shape = (values.shape[1], values.shape[2])
        if boundary == "periodic" and min(shape) < 3:
            raise GridError(f"a periodic grid needs at least 3 rows and columns, got {shape}")
        if grid is None:
            grid = Grid(shape, transform or UNREFERENCED, None if crs is None else parse_crs(crs))
        if boundary == "open":
            close_boundary(values)
        fuel = _has_edge(values, boundary) if burnable is None else np.array(burnable, dtype=bool)
        if fuel.shape != shape:
            raise GridError(f"burnable has shape {fuel.shape}, expected {shape}")
        if burnable is not None:
            values *= fuel
            for d in range(8):
                values[d] *= neighbour(fuel, d, boundary)
        if heat is not None and travel_time is None:
            raise ParameterError("heat was given without travel_time, which fire-line intensities need as well")
        times = None if travel_time is None else _whole_seconds(travel_time, values, grid)
        released = None if heat is None else _heat_of(heat, fuel, grid)
        for array in (values, fuel, times, released):
            if array is not None:
                array.flags.writeable = False
        for name, value in (
            ("probability", values),
            ("burnable", fuel),
            ("boundary", boundary),
            ("grid", grid),
            ("provenance", dict(provenance or {})),
            ("travel_time", times),
            ("heat", released),
        ):
            object.__setattr__(self, name, value)

    def facts(self) -> dict[str, object]:
        """Fuel, grid, boundary and times, as `repr` and notebooks show them."""
        return {
            "fuel": f"{self.n_burnable:,} cells",
            "grid": self.grid.describe(),
            "boundary": self.boundary,
            "travel times": ("no", "yes")[self.timed],
        }

    @property
    def shape(self) -> tuple[int, int]:
        """(rows, cols)."""
        return self.grid.shape

    @property
    def timed(self) -> bool:
        """Whether the network has travel times, so that fires can have a clock."""
        return self.travel_time is not None

    def require_times(self, what: str) -> np.ndarray:
        """Return `travel_time`, (8, rows, cols) uint32.

        Raises
        ------
        InputError
            If there is none; `what` names the thing that needs it, as in "--duration".
        """
        if self.travel_time is None:
            raise InputError(
                f"{what} needs travel times, and the network has none: it says how likely fire spreads, not how fast; "
                "make it with firebreak network --clock (spread_network(..., clock=True)), or bring 8 bands of seconds"
            )
        return self.travel_time

    def require_heat(self, what: str) -> np.ndarray:
        """Return `heat`, (rows, cols) float32, or refuse `what` needs it as `require_times` does."""
        if self.heat is None:
            raise InputError(
                f"{what} needs the heat that each cell releases; the spread model must tell it, or heat=..."
            )
        return self.heat

    @cached_property
    def n_burnable(self) -> int:
        """Cells that hold fuel, N_v."""
        return int(np.count_nonzero(self.burnable))

    def treated(self, breaks: np.ndarray | xr.DataArray, *, residual: Residual = 0.0) -> SpreadNetwork:
        """Return the network with fire breaks in it.

        Parameters
        ----------
        breaks
            (rows, cols), true where the fuel is cut.
        residual
            Share of its probability that an edge INTO a treated cell keeps (a fuel break), one number or (rows, cols);
            0 is a perfect break, which also stops edges out of the cell (an ignition there burns nothing).

        Returns
        -------
        SpreadNetwork
            With the same `burnable`, so that shares still refer to the fuel before cutting.
        """
        kept = self.kept_share(residual).astype(np.float32)
        cut = self.mask(breaks, "breaks")
        values = self.probability.copy()
        for d in range(8):
            into = neighbour(cut, d, self.boundary)
            values[d][into] *= neighbour(kept, d, self.boundary)[into] if kept.ndim else kept
        values[:, cut & (kept == 0.0)] = 0.0
        return self.derived(probability=values)

    def kept_share(self, residual: Residual) -> np.ndarray:
        """Return what treated cells keep, () or (rows, cols) float64; refused if not from 0 to 1 on fuel."""
        if isinstance(residual, (int, float, np.floating)):
            return np.array(checked_residual(float(residual)))
        kept = np.where(self.burnable, self.plane(residual, "residual"), 0.0).astype(np.float64)
        if not ((kept >= 0.0) & (kept <= 1.0)).all():  # also where it is NaN
            raise ParameterError("residual has cells with fuel outside of 0 to 1, or without a number")
        return kept

    def derived(self, *, probability: np.ndarray | None = None, burnable: np.ndarray | None = None) -> SpreadNetwork:
        """Return the network with other probabilities or less fuel; boundary, grid, times and heat are carried along.

        Parameters
        ----------
        probability
            (8, rows, cols), above 0 only where this network has an edge. Default: as here.
        burnable
            (rows, cols) bool. Default: as here.
        """
        return SpreadNetwork(
            self.probability if probability is None else probability,
            burnable=self.burnable if burnable is None else burnable,
            boundary=self.boundary,
            crs=self.grid.crs,
            transform=self.grid.transform,
            provenance=self.provenance,
            travel_time=self.travel_time,
            heat=self.heat,
        )

    def rate(self) -> np.ndarray:
        """Rate of spread along the map of a fire that goes from the cell in each direction [m/h].

        Returns
        -------
        numpy.ndarray
            (8, rows, cols) float32, 0 where there is no edge.

        Raises
        ------
        InputError
            If the network has no times, or its grid is not one of square cells in metres.
        """
        from firebreak_gis.kernels.rate import rates

        times = self.require_times("a rate of spread")
        self.grid.require_metres("rates of spread")
        return rates(times, self.grid.cell_size)

    def intensity(self) -> np.ndarray:
        """Fire-line intensity of a fire that goes from the cell in each direction [kW/m].

        Byram: heat per area times rate of spread. Loads of fuel are told per area of the map, so the rate is taken
        along the map: cells have `cell_size` times 1 or sqrt(2) between them, whatever the slope.

        Returns
        -------
        numpy.ndarray
            (8, rows, cols) float32, 0 where there is no edge.

        Raises
        ------
        InputError
            If the network has no times or no heat.
        """
        out = self.rate()
        out *= self.require_heat("fire-line intensity") * np.float32(1 / 3600)
        return out

    def flame_length(self) -> np.ndarray:
        """Flame length of a fire that goes from the cell in each direction [m], (8, rows, cols) float32.

        Byram 1959: 0.0775 I^0.46 of the `intensity` I [kW/m]; 0 where there is no edge.
        """
        out: np.ndarray = self.intensity()
        np.power(out, np.float32(0.46), out=out)
        out *= np.float32(0.0775)
        return out

    def mask(self, data: np.ndarray | xr.DataArray, what: str) -> np.ndarray:
        """Return `data` as a (rows, cols) bool array after checking that it lies on this grid.

        Raises
        ------
        GridError
            If it has another shape or, georeferenced, another grid.
        """
        return np.asarray(self.plane(data, what) > 0)

    def plane(self, data: np.ndarray | xr.DataArray, what: str) -> np.ndarray:
        """Return `data` as a (rows, cols) array after checking that it lies on this grid."""
        if hasattr(data, "dims"):
            grid = Grid.of(data)
            if self.grid.crs is not None:
                self.grid.require(grid, what)
        values = np.asarray(data)
        if values.shape != self.shape:
            raise GridError(f"{what} has shape {values.shape}, expected {self.shape}")
        return values

    def to_csr(self) -> scipy.sparse.csr_array:
        """Adjacency matrix a_lk = p(l -> k), row-major cell numbers, float64, without edges of p = 0."""
        import scipy.sparse

        source, target, d = self._edges()
        n_cells = self.burnable.size
        weights = self.probability.reshape(8, n_cells)[d, source].astype(np.float64)
        kind = np.int32 if n_cells < 2**31 else np.int64  # scipy's graphs know no longer numbers
        return scipy.sparse.csr_array((weights, (source.astype(kind), target.astype(kind))), shape=(n_cells, n_cells))

    def to_networkx(self) -> nx.DiGraph:
        """Return a networkx graph of the burnable cells.

        Nodes are (row, col); edges have `probability` and `length` = 1/p.

        Raises
        ------
        MissingComponentError
            If networkx is not installed.
        """
        try:
            import networkx as nx
        except ImportError as error:
            raise MissingComponentError("networkx is not installed; pip install networkx") from error
        graph = nx.DiGraph()
        cols = self.shape[1]
        graph.add_nodes_from((int(r), int(c)) for r, c in np.argwhere(self.burnable))
        source, target, d = self._edges()
        weights = self.probability.reshape(8, -1)[d, source].astype(np.float64)
        for s, t, p in zip(source.tolist(), target.tolist(), weights.tolist(), strict=True):
            graph.add_edge(divmod(s, cols), divmod(t, cols), probability=p, length=1.0 / p)
        return graph

    def to_raster(self) -> xr.DataArray:
        """Return the probabilities as a DataArray (direction, y, x) with CRS, NaN where there is no fuel."""
        values = np.where(self.burnable, self.probability, np.float32(np.nan))
        data = annotate(self.grid.dataarray(values, "spread_probability"))
        return data.assign_attrs(boundary=self.boundary)

    def to_dataset(self) -> xr.Dataset:
        """Return all that the network holds, for `write_raster`: a file that `read_network` reads back.

        Returns
        -------
        xarray.Dataset
            `spread_probability` (direction, y, x) and, where known, `travel_time` (direction, y, x) [s, NaN where
            there is no edge] and `heat` (y, x) [kJ/m2].
        """
        planes = {"spread_probability": self.to_raster()}
        if self.travel_time is not None:
            times = self.travel_time.astype(np.float32)
            times[self.travel_time == NEVER] = np.nan
            planes["travel_time"] = annotate(self.grid.dataarray(times, "travel_time"))
        if self.heat is not None:
            heat = np.where(self.burnable, self.heat, np.float32(np.nan))
            planes["heat"] = annotate(self.grid.dataarray(heat, "heat"))
        return planes["spread_probability"].to_dataset().assign(planes).assign_attrs(boundary=self.boundary)

    def _edges(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Source cell, target cell and direction of every edge with p > 0."""
        rows, cols = self.shape
        d, row, col = np.nonzero(self.probability)
        to_row = (row + np.array(ROW_STEP)[d]) % rows
        to_col = (col + np.array(COL_STEP)[d]) % cols
        return row * cols + col, to_row * cols + to_col, d


def checked_residual(residual: float) -> float:
    """Return the share of its spread probability that a treated cell keeps, if it is one from 0 to 1."""
    if not 0.0 <= residual <= 1.0:
        raise ParameterError(f"residual is {residual}, expected a share from 0 to 1")
    return residual


def neighbour(plane: np.ndarray, direction: int, boundary: Boundary = "open") -> np.ndarray:
    """For each cell, the value of `plane` at its neighbour in `direction`; zero beyond an open edge.

    Parameters
    ----------
    plane
        (rows, cols).
    direction
        Index into `lattice.DIRECTIONS`.
    boundary
        `"open"` or `"periodic"`.

    Returns
    -------
    numpy.ndarray
        (rows, cols), same dtype.
    """
    dr, dc = ROW_STEP[direction], COL_STEP[direction]
    out = np.roll(plane, (-dr, -dc), axis=(0, 1))
    if boundary == "open":
        if dr:
            out[-1 if dr > 0 else 0, :] = 0
        if dc:
            out[:, -1 if dc > 0 else 0] = 0
    return out


def _has_edge(values: np.ndarray, boundary: Boundary) -> np.ndarray:
    fuel: np.ndarray = np.any(values > 0, axis=0)
    for d in range(8):
        fuel |= neighbour((values[OPPOSITE[d]] > 0), d, boundary)
    return fuel


def _laid_on(data: np.ndarray | xr.DataArray, shape: tuple[int, ...], grid: Grid, what: str) -> np.ndarray:
    if hasattr(data, "dims") and grid.crs is not None:
        grid.require(Grid.of_directions(data), what)
    values = np.asarray(data)
    if values.shape != shape:
        raise GridError(f"{what} has shape {values.shape}, expected {shape}")
    return values


def _whole_seconds(travel_time: np.ndarray | xr.DataArray, probability: np.ndarray, grid: Grid) -> np.ndarray:
    """Travel times as the network keeps them, (8, rows, cols) uint32."""
    given = _laid_on(travel_time, probability.shape, grid, "travel_time")
    out = np.empty(given.shape, np.uint32)
    for d in range(8):
        times, edge = given[d], probability[d] > 0
        known = np.isfinite(times) if times.dtype.kind == "f" else times != NEVER
        lacking = int(np.count_nonzero(edge & ~known))
        if lacking:
            raise InputError(
                f"travel_time has no time on {lacking} edges to {DIRECTIONS[d]} that fire can take (p > 0); give the "
                "seconds there, or a probability of 0"
            )
        rounded = np.rint(times) if times.dtype.kind == "f" else times
        if (edge & (rounded < 1)).any():
            raise InputError(
                f"travel_time goes down to {times[edge].min():g} s on edges to {DIRECTIONS[d]}, expected at least 1 s"
            )
        out[d] = NEVER
        np.copyto(out[d], np.minimum(rounded, LONGEST), where=edge, casting="unsafe")
    return out


def _heat_of(heat: np.ndarray | xr.DataArray, burnable: np.ndarray, grid: Grid) -> np.ndarray:
    values = _laid_on(heat, burnable.shape, grid, "heat").astype(np.float32)
    inside = values[burnable]
    if inside.size and not (inside.min() >= 0.0 and np.isfinite(inside).all()):  # also catches NaN
        raise InputError("heat is negative, infinite or missing on cells that hold fuel, expected kJ/m2 of at least 0")
    values[~burnable] = 0.0
    return values
