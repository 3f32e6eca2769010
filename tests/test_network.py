"""The spread network: directions, boundaries, conversions, breaks, refusals."""

from __future__ import annotations

import dataclasses

import networkx as nx
import numpy as np
import pytest
import rasterio
import xarray as xr
from affine import Affine

from firebreak_gis.errors import CRSError, GridError, InputError, ParameterError
from firebreak_gis.grid import Grid
from firebreak_gis.lattice import (
    AZIMUTH,
    COL_STEP,
    DIRECTIONS,
    OPPOSITE,
    ORTHOGONAL,
    ROW_STEP,
    STEP_LENGTH,
)
from firebreak_gis.network import SpreadNetwork, neighbour
from firebreak_gis.rasters import write_raster
from firebreak_gis.spread import spread_network
from firebreak_gis.spread.artificial import forest
from firebreak_gis.spread.raster import read_network
from tests.twins import centrality as twin

UTM = {"crs": "EPSG:32635", "transform": Affine(20, 0, 586_440, 0, -20, 3_999_900)}


def random_network(seed=0, shape=(7, 11), boundary="open", **more):
    random = np.random.default_rng(seed)
    probability = random.random((8, *shape)).astype(np.float32)
    probability[random.random(probability.shape) < 0.2] = 0
    return SpreadNetwork(probability, burnable=random.random(shape) > 0.25, boundary=boundary, **more)


def edges(network):
    """Edges as {(from cell, to cell): p}, walked by name."""
    rows, cols = network.shape
    found = {}
    for d, name in enumerate(DIRECTIONS):
        down = ("S" in name) - ("N" in name)
        right = ("E" in name) - ("W" in name)
        for row in range(rows):
            for col in range(cols):
                if network.probability[d, row, col] > 0:
                    to = ((row + down) % rows, (col + right) % cols)
                    found[(row, col), to] = float(network.probability[d, row, col])
    return found


def test_lattice_is_a_compass():
    assert DIRECTIONS == ("N", "NE", "E", "SE", "S", "SW", "W", "NW")
    for d in range(8):
        angle = np.radians(AZIMUTH[d])
        length = STEP_LENGTH[d]
        assert ROW_STEP[d] == pytest.approx(-np.cos(angle) * length)
        assert COL_STEP[d] == pytest.approx(np.sin(angle) * length)
        back = OPPOSITE[d]
        assert (ROW_STEP[back], COL_STEP[back]) == (-ROW_STEP[d], -COL_STEP[d])
        assert (d in ORTHOGONAL) == (length == 1.0)


def test_probability_points_from_the_cell():
    for d, name in enumerate(DIRECTIONS):
        probability = np.zeros((8, 4, 6), np.float32)
        probability[d, 2, 3] = 0.5
        ((source, target),) = edges(SpreadNetwork(probability))
        assert source == (2, 3)
        assert target[0] - 2 == ("S" in name) - ("N" in name)
        assert target[1] - 3 == ("E" in name) - ("W" in name)
        csr = SpreadNetwork(probability).to_csr()
        assert csr[2 * 6 + 3, target[0] * 6 + target[1]] == 0.5


@pytest.mark.parametrize("boundary", ["open", "periodic"])
def test_neighbour_is_the_loop(boundary):
    plane = np.random.default_rng(0).random((4, 7))
    for d in range(8):
        got = neighbour(plane, d, boundary)
        for row in range(4):
            for col in range(7):
                r, c = row + ROW_STEP[d], col + COL_STEP[d]
                if boundary == "periodic":
                    r, c = r % 4, c % 7
                inside = 0 <= r < 4 and 0 <= c < 7
                assert got[row, col] == (plane[r, c] if inside else 0)


def test_open_boundary_is_closed_to_fire():
    full = SpreadNetwork(np.ones((8, 5, 8), np.float32))
    for (row, col), (to_row, to_col) in edges(full):
        assert abs(row - to_row) <= 1
        assert abs(col - to_col) <= 1
    assert len(edges(full)) == 8 * 40 - 6 * (5 + 8) + 4
    torus = SpreadNetwork(np.ones((8, 5, 8), np.float32), boundary="periodic")
    assert len(edges(torus)) == 8 * 40


@pytest.mark.parametrize("boundary", ["open", "periodic"])
def test_no_edge_touches_a_cell_without_fuel(boundary):
    network = random_network(1, boundary=boundary)
    assert not network.burnable.all()
    for source, target in edges(network):
        assert network.burnable[source]
        assert network.burnable[target]


def test_fuel_by_default_is_any_edge_in_or_out():
    probability = np.zeros((8, 3, 7), np.float32)
    probability[2, 1, 1] = 0.5  # (1, 1) lights (1, 2)
    probability[2, :, -1] = 0.9  # leaves the grid
    network = SpreadNetwork(probability)
    assert np.argwhere(network.burnable).tolist() == [[1, 1], [1, 2]]
    assert network.n_burnable == 2


@pytest.mark.parametrize("boundary", ["open", "periodic"])
@pytest.mark.parametrize("seed", range(3))
def test_matrix_and_graph_are_the_edges(seed, boundary):
    network = random_network(seed, (4 + seed, 9), boundary)
    expected = edges(network)
    np.testing.assert_array_equal(network.to_csr().toarray(), twin.adjacency(network))
    assert network.to_csr().nnz == len(expected)
    graph = network.to_networkx()
    assert isinstance(graph, nx.DiGraph)
    assert set(graph.nodes) == {tuple(cell) for cell in np.argwhere(network.burnable).tolist()}
    assert {(s, t): data["probability"] for s, t, data in graph.edges(data=True)} == expected
    for _, _, data in graph.edges(data=True):
        assert data["length"] == pytest.approx(1 / data["probability"], rel=1e-15)


@pytest.mark.parametrize("boundary", ["open", "periodic"])
@pytest.mark.parametrize("holes", [True, False])
def test_raster_and_back_is_exact(tmp_path, boundary, holes):
    """Isolated cells with fuel stay cells with fuel, with and without holes beside them."""
    random = np.random.default_rng(2)
    probability = random.random((8, 6, 9)).astype(np.float32)
    burnable = random.random((6, 9)) > 0.3 if holes else np.ones((6, 9), bool)
    burnable[2:5, 3:6] = True
    probability[:, 2:5, 3:6] = 0  # the middle of them neither lights nor is lit
    for d in range(8):
        probability[d][neighbour(np.pad([[True]], ((3, 2), (4, 4))), d)] = 0
    network = SpreadNetwork(probability, burnable=burnable, boundary=boundary, **UTM)
    assert not any((3, 4) in pair for pair in edges(network))
    back = read_network(write_raster(tmp_path / "network.tif", network.to_raster()))
    np.testing.assert_array_equal(back.probability, network.probability)
    np.testing.assert_array_equal(back.burnable, network.burnable)
    assert back.boundary == boundary
    assert back.grid.matches(network.grid)


def test_artificial_forest_comes_back_without_crs(tmp_path):
    network = spread_network(forest((5, 8), seed=2), model="artificial")
    back = read_network(write_raster(tmp_path / "forest.tif", network.to_raster()))
    np.testing.assert_array_equal(back.probability, network.probability)
    assert back.boundary == "periodic"
    assert back.grid.crs is None


def foreign(path, values, **profile):
    """An eight-band raster as another program would write it."""
    rows, cols = values.shape[1:]
    options = {"driver": "GTiff", "count": 8, "height": rows, "width": cols, "dtype": "float32"}
    with rasterio.open(path, "w", **options, **{"transform": UTM["transform"], **profile}) as target:
        target.write(values.astype(np.float32))
    return path


def test_foreign_rasters(tmp_path):
    values = random_network(3).probability.copy()
    values[:, 0, :] = 0  # the first row lights nothing
    values[[5, 6, 7, 0, 1, 2, 3, 4], 1, :] *= 1
    for d in (7, 0, 1):
        values[d, 1, :] = 0  # and is not lit
    plain = read_network(foreign(tmp_path / "plain.tif", values, crs=UTM["crs"]))
    assert not plain.burnable[0].any()
    assert plain.boundary == "open"
    values[:, 0, 0] = -1
    marked = read_network(foreign(tmp_path / "marked.tif", values, crs=UTM["crs"], nodata=-1))
    assert marked.burnable.sum() == marked.burnable.size - 1
    assert not marked.burnable[0, 0]
    with pytest.raises(InputError, match="-1"):
        read_network(foreign(tmp_path / "undeclared.tif", values, crs=UTM["crs"]))
    with pytest.raises(CRSError, match="coordinate reference system"):
        read_network(foreign(tmp_path / "nowhere.tif", np.abs(values)))


def test_raster_of_the_network_is_described(tmp_path):
    network = random_network(4, **UTM)
    data = network.to_raster()
    assert data.dims == ("direction", "y", "x")
    assert tuple(data["direction"].to_numpy()) == DIRECTIONS
    assert data.attrs["units"] == "1"
    with rasterio.open(write_raster(tmp_path / "network.tif", data)) as source:
        assert source.descriptions == DIRECTIONS
        assert source.crs.to_epsg() == 32635
        stored = source.read(masked=True)
    assert (stored.mask.all(axis=0) == ~network.burnable).all()
    assert (stored.filled(0) == network.probability).all()


@pytest.mark.parametrize("boundary", ["open", "periodic"])
@pytest.mark.parametrize("residual", [0.0, 0.25, 1.0])
def test_treated_is_the_loop(boundary, residual):
    network = random_network(5, boundary=boundary)
    cut = np.random.default_rng(1).random(network.shape) < 0.2
    treated = network.treated(cut, residual=residual)
    expected = {}
    for (source, target), p in edges(network).items():
        if cut[target]:
            p = float(np.float32(p) * np.float32(residual))
        if cut[source] and residual == 0:
            p = 0.0
        if p > 0:
            expected[source, target] = p
    assert edges(treated) == expected
    np.testing.assert_array_equal(treated.burnable, network.burnable)
    assert treated.boundary == boundary
    if residual == 1:
        np.testing.assert_array_equal(treated.probability, network.probability)


def test_treated_takes_any_mask_on_the_grid():
    network = random_network(6, **UTM)
    cut = np.zeros(network.shape, np.uint8)
    cut[3, 2:5] = 1
    expected = network.treated(cut).probability
    for mask in (cut > 0, cut.astype(float), network.grid.dataarray(cut, "breaks")):
        np.testing.assert_array_equal(network.treated(mask).probability, expected)
    np.testing.assert_array_equal(network.treated(cut * 0).probability, network.probability)
    for wrong in (-0.1, 1.1, np.nan):
        with pytest.raises(ParameterError, match="residual"):
            network.treated(cut, residual=wrong)


def test_nothing_can_be_changed_from_outside():
    given = np.full((8, 3, 4), 0.5, np.float32)
    burnable = np.ones((3, 4), bool)
    network = SpreadNetwork(given, burnable=burnable)
    given[:] = 0.9
    burnable[:] = False
    assert network.probability.max() == 0.5
    assert network.burnable.all()
    with pytest.raises(ValueError, match="read-only"):
        network.probability[0, 1, 1] = 0
    with pytest.raises(ValueError, match="read-only"):
        network.burnable[1, 1] = False
    with pytest.raises(dataclasses.FrozenInstanceError):
        network.boundary = "periodic"


@pytest.mark.parametrize(
    ("arguments", "error"),
    [
        ({"probability": np.zeros((7, 3, 4))}, GridError),
        ({"probability": np.zeros((3, 4))}, GridError),
        ({"probability": np.zeros((8, 0, 4))}, GridError),
        ({"probability": np.full((8, 3, 4), 1.1)}, InputError),
        ({"probability": np.full((8, 3, 4), -0.1)}, InputError),
        ({"probability": np.full((8, 3, 4), np.nan)}, InputError),
        ({"burnable": np.ones((4, 3), bool)}, GridError),
        ({"boundary": "closed"}, ParameterError),
        ({"probability": np.zeros((8, 2, 4)), "boundary": "periodic"}, GridError),
        ({"crs": "EPSG:0"}, CRSError),
    ],
)
def test_refusals(arguments, error):
    with pytest.raises(error):
        SpreadNetwork(**{"probability": np.full((8, 3, 4), 0.5), **arguments})


def test_arrays_with_names_are_held_to_them():
    network = random_network(7, **UTM)
    data = network.to_raster().fillna(0.0)
    again = SpreadNetwork(data, burnable=network.burnable)
    np.testing.assert_array_equal(again.probability, network.probability)
    assert again.grid.matches(network.grid)
    with pytest.raises(GridError, match="order"):
        SpreadNetwork(data.isel(direction=slice(None, None, -1)))
    with pytest.raises(GridError, match="dimensions"):
        SpreadNetwork(data.transpose("direction", "x", "y"))
    with pytest.raises(GridError, match="dimensions"):
        SpreadNetwork(data.transpose("y", "x", "direction"))


def test_planes_must_lie_on_the_grid():
    network = random_network(8, **UTM)
    rows, cols = network.shape
    plane = np.zeros((rows, cols))
    moved = Grid((rows, cols), network.grid.transform @ Affine.translation(0, 2), network.grid.crs)
    for wrong in (plane.T, plane[:-1], moved.dataarray(plane, "breaks")):
        with pytest.raises(GridError):
            network.treated(wrong)
    zone = Grid((rows, cols), network.grid.transform, "EPSG:32634" and random_network(8, crs="EPSG:32634").grid.crs)
    with pytest.raises(GridError, match="another grid"):
        network.treated(zone.dataarray(plane, "breaks"))
    bare = random_network(8)
    with pytest.raises(GridError, match="dimensions"):
        bare.treated(xr.DataArray(plane, dims=("row", "col")))
