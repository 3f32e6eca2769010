"""The network of a landscape in dask arrays, block by block, and none before it is asked for."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis import plugins
from firebreak_gis.errors import MissingComponentError, ParameterError
from firebreak_gis.grid import Grid

if TYPE_CHECKING:
    import xarray as xr

#: First and last row and column.
_Part = tuple[slice, slice]


def lazy_network(landscape: xr.Dataset, *, model: str = "alexandridis", **params: Any) -> xr.Dataset:
    """The spread network of a landscape as rasters that are not computed yet.

    Parameters
    ----------
    landscape
        As `spread_network` takes it, in dask arrays; the blocks are those of `burnable`.
    model
        Name of a spread model of which an edge depends on cells nearby alone (it says so in `HALO`).
    **params
        As in `spread_network`; a plane such as a wind of each cell may be a dask array too.

    Returns
    -------
    xarray.Dataset
        `spread_probability` (direction, y, x), with a clock also `travel_time` (direction, y, x) [s] and `heat` (y, x),
        in the blocks of the landscape: once computed equal to ``spread_network(...).to_dataset()``.

    Raises
    ------
    ParameterError
        If the model must see the whole landscape, or that is a torus.
    MissingComponentError
        If dask is not installed (extra `scale`).

    Notes
    -----
    `rank`, `select_breaks`, `simulate` and all that follows take dask arrays as well, and compute them: a ranking
    depends on all cells.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> landscape = fb.read_landscape(**fb.sample_layers(), resolution=200.0)
    >>> lazy = fb.lazy_network(landscape.chunk({"y": 20, "x": 20}), wind_speed=5.0)
    >>> lazy["spread_probability"].chunks is not None
    True
    >>> lazy.compute().identical(fb.spread_network(landscape, wind_speed=5.0).to_dataset())
    True
    """
    try:
        import dask.array
        from dask.delayed import delayed

        arrays: Any = dask.array  # it tells no types
    except ImportError:
        raise MissingComponentError(
            "dask is not installed, which networks that are lazy need; install firebreak_gis[scale]"
        ) from None
    halo = plugins.halo_of(model)
    if halo is None:
        raise ParameterError(f"the spread model {model} must see the whole landscape; take spread_network")
    if landscape.attrs.get("boundary", "open") != "open":
        raise ParameterError("a landscape that is a torus has no blocks; take spread_network")
    grid = Grid.of(landscape["burnable"])
    layers = {str(name): layer.data for name, layer in landscape.data_vars.items() if layer.ndim == 2}
    planes = {
        name: value.data if hasattr(value, "dims") else value for name, value in params.items() if np.ndim(value) == 2
    }
    numbers = {name: value for name, value in params.items() if name not in planes}
    make = partial(_made, grid, dict(landscape.attrs), model, numbers)

    def cut(part: _Part) -> tuple[_Part, dict[str, Any], dict[str, Any]]:
        one, other = ({name: plane[part] for name, plane in some.items()} for some in (layers, planes))
        return part, one, other

    # A corner tells which variables there are.
    part, *some = cut((slice(0, 3), slice(0, 3)))
    known = make(part, *({name: np.asarray(plane) for name, plane in each.items()} for each in some))
    chunks = landscape["burnable"].chunks or tuple((n,) for n in grid.shape)
    rows, cols = (_spans(sizes, halo) for sizes in chunks)
    blocks = [[delayed(_kept)(delayed(make)(*cut((row[0], col[0]))), (row[1], col[1])) for col in cols] for row in rows]
    variables = {}
    for name, like in known.data_vars.items():
        each = [
            [
                arrays.from_delayed(block[name], (*like.shape[:-2], height, width), like.dtype)
                for block, width in zip(line, chunks[1], strict=True)
            ]
            for line, height in zip(blocks, chunks[0], strict=True)
        ]
        variables[name] = grid.dataarray(arrays.block(each), str(name), **like.attrs)
    return variables[next(iter(variables))].to_dataset().assign(variables).assign_attrs(known.attrs)


def _made(
    grid: Grid,
    attrs: Mapping[str, Any],
    model: str,
    numbers: Mapping[str, Any],
    part: _Part,
    layers: Mapping[str, np.ndarray],
    planes: Mapping[str, np.ndarray],
) -> xr.Dataset:
    """The network of a part of a landscape."""
    import xarray as xr
    from affine import Affine

    from firebreak_gis.spread import spread_network

    shape = next(iter(layers.values())).shape
    own = Grid(shape, grid.transform @ Affine.translation(part[1].start, part[0].start), grid.crs)
    variables = {name: own.dataarray(np.asarray(layer), name) for name, layer in layers.items()}
    given: dict[str, Any] = {**numbers, **planes}
    return spread_network(xr.Dataset(variables, attrs=attrs), model=model, **given).to_dataset()


def _kept(network: xr.Dataset, inner: _Part) -> dict[str, np.ndarray]:
    """The values of a block, without the cells around it."""
    return {str(name): plane.to_numpy()[..., *inner] for name, plane in network.data_vars.items()}


def _spans(sizes: Sequence[int], halo: int) -> list[tuple[slice, slice]]:
    """Of each block what is read, with the cells around it; and which of that is the block.

    Examples
    --------
    >>> _spans((4, 3), 1)
    [(slice(0, 5, None), slice(0, 4, None)), (slice(3, 7, None), slice(1, 4, None))]
    """
    ends = np.cumsum([0, *sizes]).tolist()
    read = [(max(first - halo, 0), min(last + halo, ends[-1])) for first, last in pairwise(ends)]
    return [
        (slice(low, high), slice(first - low, last - low))
        for (low, high), (first, last) in zip(read, pairwise(ends), strict=True)
    ]
