"""The spread network: every cell of a grid can light its eight neighbours with a probability."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from firebreak_gis.errors import GridError, InputError, ParameterError
from firebreak_gis.grid import UNREFERENCED, Grid, parse_crs
from firebreak_gis.lattice import COL_STEP, DIRECTIONS, OPPOSITE, ROW_STEP

if TYPE_CHECKING:
    import networkx as nx
    import scipy.sparse
    import xarray as xr
    from affine import Affine

Boundary = Literal["open", "periodic"]


@dataclass(frozen=True, eq=False, init=False)
class SpreadNetwork:
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

    Raises
    ------
    GridError
        If a shape does not fit.
    InputError
        If a probability is NaN or outside [0, 1].
    """

    probability: np.ndarray
    burnable: np.ndarray
    boundary: Boundary
    grid: Grid
    provenance: dict[str, Any] = field(default_factory=dict)

    def __init__(
        self,
        probability: np.ndarray | xr.DataArray,
        *,
        burnable: np.ndarray | xr.DataArray | None = None,
        boundary: Boundary = "open",
        crs: Any = None,
        transform: Affine | None = None,
        provenance: dict[str, Any] | None = None,
    ) -> None:
        grid = _grid_of(probability) if hasattr(probability, "dims") else None
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
            _close_boundary(values)
        fuel = _has_edge(values, boundary) if burnable is None else np.array(burnable, dtype=bool)
        if fuel.shape != shape:
            raise GridError(f"burnable has shape {fuel.shape}, expected {shape}")
        if burnable is not None:
            values *= fuel
            for d in range(8):
                values[d] *= neighbour(fuel, d, boundary)
        values.flags.writeable = False
        fuel.flags.writeable = False
        for name, value in (
            ("probability", values),
            ("burnable", fuel),
            ("boundary", boundary),
            ("grid", grid),
            ("provenance", dict(provenance or {})),
        ):
            object.__setattr__(self, name, value)

    @property
    def shape(self) -> tuple[int, int]:
        """(rows, cols)."""
        return self.grid.shape

    @cached_property
    def n_burnable(self) -> int:
        """Cells that hold fuel, N_v."""
        return int(np.count_nonzero(self.burnable))

    def treated(self, breaks: np.ndarray | xr.DataArray, *, residual: float = 0.0) -> SpreadNetwork:
        """Return the network with fire breaks in it.

        Parameters
        ----------
        breaks
            (rows, cols), true where the fuel is cut.
        residual
            Share of its probability that an edge INTO a treated cell keeps; 0 is a perfect break, which also
            stops edges out of the cell (an ignition there burns nothing).

        Returns
        -------
        SpreadNetwork
            With the same `burnable`, so that shares still refer to the fuel before cutting.
        """
        checked_residual(residual)
        cut = self.mask(breaks, "breaks")
        values = self.probability.copy()
        for d in range(8):
            values[d][neighbour(cut, d, self.boundary)] *= np.float32(residual)
        if residual == 0.0:
            values[:, cut] = 0.0
        return SpreadNetwork(
            values,
            burnable=self.burnable,
            boundary=self.boundary,
            crs=self.grid.crs,
            transform=self.grid.transform,
            provenance=self.provenance,
        )

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
        return scipy.sparse.csr_array((weights, (source, target)), shape=(n_cells, n_cells))

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
            from firebreak_gis.errors import MissingComponentError

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
        from firebreak_gis.schema import annotate

        values = np.where(self.burnable, self.probability, np.float32(np.nan))
        data = annotate(self.grid.dataarray(values, "spread_probability"))
        return data.assign_attrs(boundary=self.boundary)

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


def _grid_of(probability: Any) -> Grid:
    """Grid of a (direction, y, x) array whose directions, if named, stand in the order of the lattice."""
    if probability.ndim == 3 and probability.dims[0] in probability.coords:
        order = tuple(str(name) for name in probability[probability.dims[0]].to_numpy())
        if set(order) == set(DIRECTIONS) and order != DIRECTIONS:
            raise GridError(
                f"probability has its directions in the order {' '.join(order)}, expected "
                f"{' '.join(DIRECTIONS)}; reorder them with probability.sel(direction=[...])"
            )
    return Grid.of(probability)


def _close_boundary(values: np.ndarray) -> None:
    """Set the edges that leave an open grid to 0."""
    for d in range(8):
        if ROW_STEP[d]:
            values[d, -1 if ROW_STEP[d] > 0 else 0, :] = 0.0
        if COL_STEP[d]:
            values[d, :, -1 if COL_STEP[d] > 0 else 0] = 0.0


def _has_edge(values: np.ndarray, boundary: Boundary) -> np.ndarray:
    fuel: np.ndarray = np.any(values > 0, axis=0)
    for d in range(8):
        fuel |= neighbour((values[OPPOSITE[d]] > 0), d, boundary)
    return fuel
