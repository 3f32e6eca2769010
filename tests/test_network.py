"""The spread network: directions, boundaries, conversions, breaks, refusals."""

from __future__ import annotations

import dataclasses
import pickle

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
    LONGEST,
    NEVER,
    OPPOSITE,
    ROW_STEP,
    STEP_LENGTH,
)
from firebreak_gis.network import SpreadNetwork, neighbour
from firebreak_gis.placement.orientation import in_standard_orientation
from firebreak_gis.rasters import write_raster
from firebreak_gis.spread import spread_network
from firebreak_gis.spread.artificial import forest
from firebreak_gis.spread.raster import read_network
from firebreak_gis.stakes import Stakes, with_barriers
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
@pytest.mark.parametrize("residual", [0.0, 0.25, 1.0, "plane"])
def test_treated_is_the_loop(boundary, residual):
    network = random_network(5, boundary=boundary)
    if residual == "plane":
        residual = np.random.default_rng(2).choice([0.0, 0.25, 1.0], network.shape)
    kept = np.broadcast_to(residual, network.shape)
    cut = np.random.default_rng(1).random(network.shape) < 0.2
    treated = network.treated(cut, residual=residual)
    expected = {}
    for (source, target), p in edges(network).items():
        if cut[target]:
            p = float(np.float32(p) * np.float32(kept[target]))
        if cut[source] and kept[source] == 0:
            p = 0.0
        if p > 0:
            expected[source, target] = p
    assert edges(treated) == expected
    np.testing.assert_array_equal(treated.burnable, network.burnable)
    assert treated.boundary == boundary
    if (kept == 1).all():
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
        with pytest.raises(ParameterError, match="residual has cells"):
            network.treated(cut, residual=np.where(network.burnable, wrong, 0.0))
    with pytest.raises(GridError, match="residual"):
        network.treated(cut, residual=np.zeros((3, 3)))


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


def timed_network(seed=0, shape=(7, 11), boundary="open", heat=True, **more):
    """A random network with times of 1 s to 10 days."""
    bare = random_network(seed, shape, boundary)
    random = np.random.default_rng(seed + 100)
    times = np.exp(random.uniform(0, np.log(864_000), (8, *shape))).round()
    more |= {"heat": random.uniform(0, 90_000, shape)} if heat else {}
    return SpreadNetwork(bare.probability, burnable=bare.burnable, boundary=boundary, travel_time=times, **more)


def assert_same_times(one, other):
    for name in ("probability", "burnable", "travel_time", "heat"):
        np.testing.assert_array_equal(getattr(one, name), getattr(other, name), err_msg=name)
    assert (one.boundary, one.timed) == (other.boundary, other.timed)


@pytest.mark.parametrize("boundary", ["open", "periodic"])
def test_there_is_a_time_where_there_is_an_edge(boundary):
    network = timed_network(boundary=boundary)
    assert network.timed
    assert network.travel_time.dtype == np.uint32
    np.testing.assert_array_equal(network.travel_time != NEVER, network.probability > 0)
    assert not network.travel_time.flags.writeable
    assert not random_network().timed


@pytest.mark.parametrize("boundary", ["open", "periodic"])
@pytest.mark.parametrize("heat", [False, True])
def test_what_derives_from_a_network_keeps_its_times(boundary, heat):
    network = timed_network(boundary=boundary, heat=heat)
    mask = np.random.default_rng(4).random(network.shape) < 0.3
    leaky, cut, barred = network.treated(mask, residual=0.2), network.treated(mask), with_barriers(network, mask)
    assert_same_times(pickle.loads(pickle.dumps(network)), network)
    np.testing.assert_array_equal(leaky.travel_time, network.travel_time)
    for less in (cut, barred):
        kept = less.probability > 0
        assert 0 < kept.sum() < (network.probability > 0).sum()
        np.testing.assert_array_equal(less.travel_time, np.where(kept, network.travel_time, NEVER))
    for made in (leaky, cut, barred):
        assert (made.heat is None) == (not heat)
    if heat:
        np.testing.assert_array_equal(cut.heat, network.heat)
        np.testing.assert_array_equal(barred.heat, np.where(mask, 0, network.heat))


def test_times_turn_with_the_map():
    network = timed_network()
    seen = []
    for symmetry in twin.SYMMETRIES.values():
        turned = twin.turn_network(network, symmetry)
        in_standard_orientation(turned, Stakes(turned), lambda n, *_: seen.append(n) or np.zeros(n.shape))
    assert len(seen) == 8
    for other in seen[1:]:
        assert_same_times(seen[0], other)
        np.testing.assert_array_equal(seen[0].intensity(), other.intensity())
    seen.clear()
    network = timed_network(**UTM)
    in_standard_orientation(network, Stakes(network), lambda n, *_: seen.append(n) or np.zeros(n.shape))
    assert seen[0].grid.cell_size == 20


@pytest.mark.parametrize("boundary", ["open", "periodic"])
@pytest.mark.parametrize("heat", [False, True])
def test_a_network_with_times_reads_back_equal(tmp_path, boundary, heat):
    network = timed_network(boundary=boundary, heat=heat, provenance={"left_out": "wind"}, **UTM)
    path = write_raster(tmp_path / "network.tif", network.to_dataset(), provenance=network.provenance)
    with rasterio.open(path) as source:
        assert source.count == 16 + heat
        assert source.descriptions[:8] == DIRECTIONS
        assert source.descriptions[8:16] == tuple(f"travel_time {d}" for d in DIRECTIONS)
        assert source.units[8:16] == ("s",) * 8
    back = read_network(path)
    assert_same_times(back, network)
    assert back.provenance["left_out"] == "wind"
    assert back.grid == network.grid


def test_a_file_without_times_is_that_of_before(tmp_path):
    network = random_network(**UTM)
    one = write_raster(tmp_path / "one.tif", network.to_dataset())
    other = write_raster(tmp_path / "other.tif", network.to_raster())
    assert one.read_bytes() == other.read_bytes()
    assert not read_network(one).timed


@pytest.mark.parametrize("described", [False, True])
@pytest.mark.parametrize("bands", [16, 17])
def test_bands_of_others_are_told_by_name_or_order(tmp_path, described, bands):
    network = timed_network(heat=bands == 17, **UTM)
    planes = [*network.probability, *np.where(network.travel_time == NEVER, np.nan, network.travel_time)]
    planes += [network.heat] if bands == 17 else []
    names = [*DIRECTIONS, *(f"travel_time {d}" for d in DIRECTIONS), "heat"][:bands]
    if described:  # the order is then free
        planes, names = planes[8:] + planes[:8], names[8:] + names[:8]
    path = tmp_path / "others.tif"
    profile = {"driver": "GTiff", "dtype": "float32", "height": 7, "width": 11, "nodata": np.nan, **UTM}
    with rasterio.open(path, "w", count=bands, **profile) as target:
        target.write(np.array([np.where(network.burnable, plane, np.nan) for plane in planes], np.float32))
        if described:
            target.descriptions = names
    assert_same_times(read_network(path), network)
    with rasterio.open(tmp_path / "nine.tif", "w", count=9, **profile) as target:
        target.write(np.zeros((9, 7, 11), np.float32))
    with pytest.raises(InputError, match="9 bands"):
        read_network(tmp_path / "nine.tif")


def test_the_longest_time_is_exact_in_files(tmp_path):
    times = np.full((8, 3, 4), LONGEST - 1, np.uint32)
    times[:4] = LONGEST + 5
    network = SpreadNetwork(np.full((8, 3, 4), 0.5), travel_time=times, **UTM)
    inner = network.travel_time[:, 1, 1]
    assert inner[:4].tolist() == [LONGEST] * 4
    assert inner[4:].tolist() == [LONGEST - 1] * 4
    assert_same_times(read_network(write_raster(tmp_path / "long.tif", network.to_dataset())), network)


def test_times_that_cannot_be_are_refused():
    probability = np.full((8, 4, 5), 0.5)
    good = np.full((8, 4, 5), 30.0)
    hole, zero = good.copy(), good.copy()
    hole[2, 1, 1], zero[2, 1, 1] = np.nan, 0.4
    for times, match in ((hole, "no time on 1 edges to E"), (zero, "at least 1 s"), (good[:, 1:], "shape")):
        with pytest.raises(InputError, match=match):
            SpreadNetwork(probability, travel_time=times)
    with pytest.raises(ParameterError, match="without travel_time"):
        SpreadNetwork(probability, heat=np.ones((4, 5)))
    with pytest.raises(InputError, match="heat is negative"):
        SpreadNetwork(probability, travel_time=good, heat=np.full((4, 5), -1.0))
    bare = SpreadNetwork(probability)
    with pytest.raises(InputError, match=r"--duration needs travel times.*--clock"):
        bare.require_times("--duration")
    with pytest.raises(InputError, match="heat"):
        SpreadNetwork(probability, travel_time=good).intensity()


def test_intensity_is_heat_times_rate_of_spread():
    """Conifers of 1 and 4 kg/m2 that burn at 0.1 m/s: by hand."""
    seconds = np.array([200.0 if d % 2 == 0 else 200.0 * 2**0.5 for d in range(8)])
    times = np.broadcast_to(seconds[:, None, None], (8, 3, 3))
    network = SpreadNetwork(np.full((8, 3, 3), 0.5), travel_time=times, heat=np.full((3, 3), 40_000.0), **UTM)
    assert network.intensity()[:, 1, 1] == pytest.approx(4_000, rel=2e-3)
    assert network.flame_length()[:, 1, 1] == pytest.approx(0.0775 * 4_000**0.46, rel=1e-3)
    assert network.intensity()[0, 0, 1] == 0


def test_repr_is_one_short_line_that_tells_networks_apart():
    grid = np.full((8, 30, 40), 0.5)
    plain = SpreadNetwork(grid)
    text = repr(plain)
    assert len(text) < 200
    assert "\n" not in text
    assert f"{plain.n_burnable:,} cells" in text
    assert "30 x 40" in text
    assert "periodic" in repr(SpreadNetwork(grid, boundary="periodic"))
    assert "travel times no" in text
    assert "travel times yes" in repr(SpreadNetwork(grid, travel_time=np.full(grid.shape, 60.0)))
    assert "EPSG:32635" in repr(SpreadNetwork(grid, crs="EPSG:32635"))
