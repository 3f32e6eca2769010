"""Spread models: against a plain loop, against the published numbers, and turned round."""

from __future__ import annotations

import math

import numpy as np
import pytest

from firebreak_gis.errors import CRSError, FirebreakError, GridError, InputError, ParameterError
from firebreak_gis.grid import Grid, parse_crs
from firebreak_gis.lattice import AZIMUTH, DIRECTIONS, OPPOSITE
from firebreak_gis.rasters import write_raster
from firebreak_gis.simulation.fires import simulate
from firebreak_gis.spread import spread_network
from firebreak_gis.spread.artificial import forest
from tests.twins import centrality as turning
from tests.twins import spread as twin


def assert_same_edges(network, expected):
    got = twin.as_dict(network)
    assert set(got) == {key for key, p in expected.items() if p > 0}
    for key, p in got.items():
        assert p == pytest.approx(expected[key], rel=2e-7), key


@pytest.mark.parametrize("boundary", ["open", "periodic"])
@pytest.mark.parametrize("seed", range(3))
def test_calm_is_the_loop(make_landscape, boundary, seed):
    landscape = make_landscape((7 + seed, 12), seed, boundary=boundary)
    assert_same_edges(spread_network(landscape), twin.alexandridis(landscape))


@pytest.mark.parametrize("boundary", ["open", "periodic"])
@pytest.mark.parametrize(("speed", "wind_from"), [(8, 315), (3.5, 17.0), (20, 360), (0, 123)])
def test_uniform_wind_is_the_loop(make_landscape, boundary, speed, wind_from):
    landscape = make_landscape(seed=5, boundary=boundary)
    network = spread_network(landscape, wind_speed=speed, wind_from_direction=wind_from)
    assert_same_edges(network, twin.alexandridis(landscape, speed, wind_from))


@pytest.mark.parametrize("boundary", ["open", "periodic"])
def test_wind_of_every_cell_is_the_loop(make_landscape, boundary):
    landscape = make_landscape(seed=6, boundary=boundary)
    random = np.random.default_rng(1)
    shape = landscape["burnable"].shape
    speed, wind_from = random.uniform(0, 15, shape), random.uniform(0, 360, shape)
    expected = twin.alexandridis(landscape, speed, wind_from)
    grid = Grid.of(landscape["burnable"])
    for wrap in (np.asarray, lambda values: grid.dataarray(values, "wind")):
        network = spread_network(landscape, wind_speed=wrap(speed), wind_from_direction=wrap(wind_from))
        assert_same_edges(network, expected)
    mixed = spread_network(landscape, wind_speed=speed, wind_from_direction=200)
    assert_same_edges(mixed, twin.alexandridis(landscape, speed, 200))


def test_changed_parameters_are_the_loop(make_landscape):
    landscape = make_landscape(seed=7)
    changed = {
        "p0": 0.3,
        "a": 0.02,
        "c1": 0.1,
        "c2": 0.05,
        "agricultural": 0.5,
        "shrubs": -0.2,
        "pines": -1.0,
        "sparse": 0.1,
        "normal": -0.5,
        "dense": 2.0,
    }
    network = spread_network(landscape, wind_speed="4", wind_from_direction=90, **changed)
    assert_same_edges(network, twin.alexandridis(landscape, 4, 90, **changed))


@pytest.mark.parametrize(
    ("vegetation", "density", "published"),
    [
        (1, 1, 0.2436),
        (1, 2, 0.406),
        (1, 3, 0.528),
        (2, 1, 0.348),
        (2, 2, 0.58),
        (2, 3, 0.754),
        (3, 1, 0.487),
        (3, 2, 0.812),
        (3, 3, 1.0),
    ],
)
def test_published_numbers_of_flat_calm_ground(make_landscape, vegetation, density, published):
    landscape = make_landscape((4, 5), holes=0, elevation=120, vegetation=vegetation, density=density)
    inner = spread_network(landscape).probability[:, 1:-1, 1:-1]
    assert np.ptp(inner) == 0
    assert inner.flat[0] == pytest.approx(published, abs=6e-4)
    assert inner.max() <= 1


def test_published_wind_factors(make_landscape):
    landscape = make_landscape((3, 5), holes=0, elevation=0, vegetation=2, density=2)
    published = {0: 1.433, 45: 1.054, 90: 0.503, 135: 0.240, 180: 0.176}
    for wind_from in (0.0, 90.0, 225.0):
        p = spread_network(landscape, wind_speed=8, wind_from_direction=wind_from).probability[:, 1, 2] / 0.58
        for d in range(8):
            angle = abs((AZIMUTH[d] - (wind_from + 180.0) + 180.0) % 360.0 - 180.0)
            assert p[d] == pytest.approx(published[round(angle)], abs=5.1e-4), (wind_from, DIRECTIONS[d])


def test_wind_from_north_blows_to_the_south(make_landscape):
    landscape = make_landscape((3, 5), holes=0, elevation=0, vegetation=2, density=2)
    p = spread_network(landscape, wind_speed=8, wind_from_direction=0).probability[:, 1, 2]
    assert DIRECTIONS[int(p.argmax())] == "S"
    assert DIRECTIONS[int(p.argmin())] == "N"


def test_twenty_degrees_of_slope(make_landscape):
    """To the east it rises by 20 degrees; on diagonals the way is longer and the slope gentler."""
    cell = 20.0
    rise = cell * math.tan(math.radians(20.0))
    elevation = np.broadcast_to(rise * np.arange(5), (3, 5))
    landscape = make_landscape((3, 5), holes=0, cell=cell, elevation=elevation, vegetation=2, density=2)
    p = spread_network(landscape, p0=0.1).probability[:, 1, 2] / 0.1
    steep = math.exp(0.078 * 20)
    diagonal = math.exp(0.078 * math.degrees(math.atan(rise / (cell * math.sqrt(2)))))
    expected = {"N": 1, "NE": diagonal, "E": steep, "SE": diagonal, "S": 1}
    expected |= {"SW": 1 / diagonal, "W": 1 / steep, "NW": 1 / diagonal}
    for d, name in enumerate(DIRECTIONS):
        assert p[d] == pytest.approx(expected[name], rel=1e-5), name


def test_uphill_is_faster_than_downhill_everywhere(make_landscape):
    landscape = make_landscape(seed=3, vegetation=2, density=2, holes=0.0, relief=1.0)
    network = spread_network(landscape, p0=0.1)
    z = landscape["elevation"].to_numpy()
    rows, cols = z.shape
    seen = 0
    for (row, col, name), p in twin.as_dict(network).items():
        d = DIRECTIONS.index(name)
        _, down, right, _ = twin.NEIGHBOURS[d]
        back = float(network.probability[OPPOSITE[d], row + down, col + right])
        assert (p > back) == (z[row + down, col + right] > z[row, col])
        assert p * back == pytest.approx(0.01, rel=1e-5)
        seen += 1
    assert seen == 8 * rows * cols - 2 * 3 * (rows + cols) + 4


@pytest.mark.parametrize("name", turning.SYMMETRIES)
@pytest.mark.parametrize("boundary", ["open", "periodic"])
def test_turned_landscape_and_wind_turn_the_network(make_landscape, name, boundary):
    symmetry = turning.SYMMETRIES[name]
    landscape = make_landscape((6, 11), seed=8, boundary=boundary)
    layers = {key: turning.turn(landscape[key].to_numpy(), symmetry) for key in landscape.data_vars}
    turned = make_landscape(layers["burnable"].shape, boundary=boundary, **layers)
    for d in (0, 3):
        wind_from = AZIMUTH[turning.turn_direction(d, symmetry)]
        got = spread_network(turned, wind_speed=6, wind_from_direction=wind_from)
        expected = turning.turn_network(
            spread_network(landscape, wind_speed=6, wind_from_direction=AZIMUTH[d]), symmetry
        )
        np.testing.assert_allclose(got.probability, expected.probability, rtol=2e-7)
        assert (got.burnable == expected.burnable).all()


def centre_of_fire(landscape, **wind):
    """Mean (row, col) of burnt cells relative to an ignition in the middle."""
    network = spread_network(landscape, p0=0.2, **wind)
    rows, cols = network.shape
    start = np.zeros(network.shape)
    start[rows // 2, cols // 2] = 1
    count = simulate(network, ignitions=start, n_runs=300, seed=4)["burn_count"].to_numpy()
    return (
        (count * (np.arange(rows) - rows // 2)[:, None]).sum() / count.sum(),
        (count * (np.arange(cols) - cols // 2)).sum() / count.sum(),
    )


def test_fire_runs_with_the_wind_and_up_the_slope(make_landscape):
    shape = (41, 35)
    flat = {"holes": 0.0, "vegetation": 2, "density": 2}
    south, east = centre_of_fire(make_landscape(shape, **flat, elevation=0), wind_speed=8, wind_from_direction=0)
    assert south > 2
    assert abs(east) < south / 3
    south, east = centre_of_fire(make_landscape(shape, **flat, elevation=0), wind_speed=8, wind_from_direction=270)
    assert east > 2
    assert abs(south) < east / 3
    ramp = np.broadcast_to(3.0 * np.arange(shape[0])[::-1, None], shape)  # rises to the north
    south, east = centre_of_fire(make_landscape(shape, **flat, elevation=ramp))
    assert south < -1
    assert abs(east) < -south / 3


def test_more_than_one_is_clipped(make_landscape):
    landscape = make_landscape(seed=2, vegetation=3, density=3, relief=30.0)
    p = spread_network(landscape, wind_speed=10).probability
    assert p.max() == 1.0
    assert (p[p > 0] < 1).any()


def test_effects_in_place_of_classes(make_landscape):
    """Numbers override the class where they are given; NaN leaves the class."""
    plain = make_landscape(seed=4)
    shape = plain["burnable"].shape
    effect = np.full(shape, np.nan)
    effect[:, ::2] = 0.25
    given = make_landscape(seed=4, vegetation_effect=effect, density_effect=np.where(np.isnan(effect), effect, -0.3))
    expected = twin.alexandridis(plain)
    scaled = twin.alexandridis(
        make_landscape(
            seed=4, vegetation=np.where(plain["vegetation"] > 0, 1, 0), density=np.where(plain["density"] > 0, 1, 0)
        ),
        agricultural=0.25,
        sparse=-0.3,
    )
    steps = {name: (down, right) for name, down, right, _ in twin.NEIGHBOURS}
    mixed = {key: (scaled if (key[1] + steps[key[2]][1]) % 2 == 0 else expected)[key] for key in expected}
    assert_same_edges(spread_network(given), mixed)


def test_inputs_stay_as_they_were(make_landscape):
    landscape = make_landscape(seed=1)
    before = landscape.copy(deep=True)
    spread_network(landscape, wind_speed=5)
    assert landscape.identical(before)


@pytest.mark.parametrize("threads", ["1", "2", "5"])
def test_threads_change_nothing(make_landscape, monkeypatch, threads):
    landscape = make_landscape((3, 17), seed=1)
    expected = spread_network(landscape, wind_speed=3).probability
    monkeypatch.setenv("FIREBREAK_THREADS", threads)
    assert (spread_network(landscape, wind_speed=3).probability == expected).all()


def test_missing_elevation_is_refused_only_under_fuel(make_landscape):
    landscape = make_landscape(seed=1)
    landscape["elevation"] = landscape["elevation"].where(landscape["burnable"])
    assert spread_network(landscape).n_burnable == int(landscape["burnable"].sum())
    row, col = np.argwhere(landscape["burnable"].to_numpy())[3]
    landscape["elevation"][row, col] = np.nan
    with pytest.raises(InputError, match="elevation is missing"):
        spread_network(landscape)


def test_every_fault_of_a_landscape_is_named(make_landscape):
    landscape = make_landscape()
    landscape["vegetation"] = landscape["vegetation"].astype("int64")
    landscape["density"][0, 0] = 9
    landscape = landscape.drop_vars("elevation")
    with pytest.raises(InputError) as caught:
        spread_network(landscape)
    for word in ("elevation is missing", "vegetation has dtype int64", "density goes up to 9"):
        assert word in str(caught.value)
    with pytest.raises(InputError, match="burnable"):
        spread_network(landscape.drop_vars("burnable"))


@pytest.mark.parametrize(
    "wrong",
    [
        {"wind_speed": -1},
        {"wind_speed": 61},
        {"wind_speed": "fast"},
        {"wind_speed": math.nan},
        {"wind_speed": np.float32(61)},
        {"wind_from_direction": 400},
        {"wind_from_direction": np.int64(-1)},
        {"p0": 1.5},
        {"p0": None},
        {"agricultural": -1.1},
        {"wind": 3},
    ],
)
def test_impossible_parameters_are_refused(make_landscape, wrong):
    with pytest.raises(ParameterError, match=next(iter(wrong))):
        spread_network(make_landscape(), **wrong)


def test_wind_rasters_must_fit(make_landscape):
    landscape = make_landscape()
    grid = Grid.of(landscape["burnable"])
    shape = grid.shape
    for wrong in (np.nan, 61.0, -0.1):
        speed = np.full(shape, 4.0)
        speed[tuple(np.argwhere(landscape["burnable"].to_numpy())[20])] = wrong
        with pytest.raises(ParameterError, match="wind_speed"):
            spread_network(landscape, wind_speed=speed)
    with pytest.raises(ParameterError, match="wind_from_direction"):
        spread_network(landscape, wind_from_direction=np.full(shape, 400.0))
    with pytest.raises(GridError, match="wind_speed"):
        spread_network(landscape, wind_speed=np.ones((3, 4)))
    moved = Grid(shape, grid.transform @ type(grid.transform).translation(1, 0), grid.crs)
    with pytest.raises(GridError, match="another grid"):
        spread_network(landscape, wind_speed=moved.dataarray(np.ones(shape), "wind"))
    with pytest.raises(GridError, match="dimensions"):
        spread_network(landscape, wind_speed=grid.dataarray(np.ones(shape), "wind").transpose("x", "y"))


def test_slopes_need_square_cells_in_metres(make_landscape):
    for crs in ("EPSG:4326", "EPSG:2263"):  # degrees, US survey feet
        with pytest.raises(CRSError, match="metres"):
            spread_network(make_landscape(crs=crs))
    landscape = make_landscape()
    stretched = landscape.drop_vars("spatial_ref").assign_coords(x=landscape["x"] * 2)
    with pytest.raises(GridError, match="square"):
        spread_network(stretched)
    with pytest.raises(GridError, match="dimensions"):
        spread_network(landscape.transpose("x", "y"))


def test_unknown_model_names_the_known(make_landscape):
    with pytest.raises(ParameterError, match="alexandridis, artificial, raster"):
        spread_network(make_landscape(), model="rothermel")


def test_artificial_forest_is_the_loop():
    landscape = forest((7, 11), seed=3)
    network = spread_network(landscape, model="artificial")
    assert network.boundary == "periodic"
    assert network.n_burnable == 77
    assert_same_edges(network, twin.artificial(landscape))


def test_artificial_forest_is_seeded_and_uniform():
    assert forest((7, 11), seed=3).identical(forest((7, 11), seed=3))
    assert not forest((7, 11), seed=3).equals(forest((7, 11), seed=4))
    emptiness = np.concatenate([forest((40, 50), seed=s)["emptiness"].to_numpy().ravel() for s in range(5)])
    assert ((emptiness >= 0) & (emptiness < 1)).all()
    bins = np.histogram(emptiness, 20, (0, 1))[0]
    assert ((bins - 500.0) ** 2 / 500.0).sum() < 43.8  # chi-square, 19 degrees of freedom, 0.1 %


def test_open_artificial_forest_closes_its_border():
    landscape = forest((5, 8), seed=1)
    landscape.attrs["boundary"] = "open"
    p = spread_network(landscape, model="artificial").probability
    assert (p[0, 0] == 0).all()
    assert (p[2, :, -1] == 0).all()
    np.testing.assert_allclose(p[2, :, :-1], 1 - landscape["emptiness"].to_numpy()[:, 1:], rtol=1e-6)


def test_emptiness_must_be_a_share():
    landscape = forest((5, 8))
    for value in (np.nan, 1.2, -0.1):
        wrong = landscape.copy(deep=True)
        wrong["emptiness"][1, 2] = value
        with pytest.raises(InputError, match="emptiness"):
            spread_network(wrong, model="artificial")
    with pytest.raises(InputError, match="emptiness"):
        spread_network(landscape.drop_vars("emptiness"), model="artificial")
    with pytest.raises(GridError, match="dimensions"):
        spread_network(landscape.assign(emptiness=landscape["emptiness"].T), model="artificial")


def test_own_raster_of_probabilities(make_landscape, tmp_path):
    landscape = make_landscape(seed=2)
    expected = spread_network(landscape, wind_speed=3)
    path = write_raster(tmp_path / "p.tif", expected.to_raster())
    network = spread_network(landscape, model="raster", path=str(path))
    assert (network.probability == expected.probability).all()
    with pytest.raises(ParameterError, match="path"):
        spread_network(landscape, model="raster")
    with pytest.raises(GridError, match="another grid"):
        spread_network(make_landscape((9, 13)), model="raster", path=str(path))
    with pytest.raises(FirebreakError):
        spread_network(landscape, model="raster", path=str(tmp_path / "none.tif"))


def test_foreign_crs_is_the_same_grid(make_landscape):
    """A CRS given as WKT is the one given as a code."""
    landscape = make_landscape()
    grid = Grid.of(landscape["burnable"])
    again = Grid(grid.shape, grid.transform, parse_crs(parse_crs("EPSG:32635").to_wkt()))
    assert spread_network(landscape, wind_speed=again.dataarray(np.ones(grid.shape), "wind")).n_burnable
