"""Fires that burn in windows of a map are those of the whole map, whatever the windows."""

from __future__ import annotations

import numpy as np
import pytest

from firebreak_gis.errors import ParameterError
from firebreak_gis.grid import Grid
from firebreak_gis.kernels.percolation import steps
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.simulation.containment import as_containment
from firebreak_gis.simulation.durations import as_duration
from firebreak_gis.simulation.embers import as_embers
from firebreak_gis.simulation.fires import burn
from firebreak_gis.simulation.ground import part_of
from firebreak_gis.simulation.ground_fires import MapInMemory
from firebreak_gis.simulation.holding import as_hold, stretches
from firebreak_gis.simulation.request import FireRequest
from firebreak_gis.simulation.window import Window, tiles
from firebreak_gis.simulation.windows import burn_windows


def landscape(shape=(150, 171), seed=3):
    """A network with holes, times, heat and a CRS in metres, and breaks on it."""
    from affine import Affine

    rng = np.random.default_rng(seed)
    network = SpreadNetwork(
        rng.uniform(0.2, 0.9, (8, *shape)),
        burnable=rng.random(shape) < 0.95,
        crs="EPSG:32635",
        transform=Affine(20.0, 0.0, 500_000.0, 0.0, -20.0, 4_000_000.0),
        travel_time=rng.integers(60, 900, (8, *shape)).astype(float),
        heat=rng.uniform(5_000, 40_000, shape),
    )
    breaks = np.zeros(shape, bool)
    breaks[:, ::40] = True
    breaks[::35] = True
    return network, breaks


@pytest.mark.parametrize("timed", [False, True])
def test_a_part_of_a_network_is_the_network_of_the_part(timed):
    whole, _ = landscape()
    if not timed:
        whole = SpreadNetwork(whole.probability, burnable=whole.burnable, transform=whole.grid.transform)
    window = Window(40, 30, (60, 64), whole.shape)
    rows, cols = window.slices
    grid = window.grid(whole.grid)
    times = {"travel_time": whole.travel_time[:, rows, cols], "heat": whole.heat[rows, cols]} if timed else {}
    made = SpreadNetwork(
        whole.probability[:, rows, cols],
        burnable=whole.burnable[rows, cols],
        crs=grid.crs,
        transform=grid.transform,
        **times,
    )
    part = part_of(whole, rows, cols, grid)
    for name in ("probability", "burnable", "travel_time", "heat"):
        np.testing.assert_array_equal(getattr(part, name), getattr(made, name))
    assert (part.grid, part.boundary) == (made.grid, made.boundary)
    assert not part.probability.flags.writeable


FIRES = {
    "short": {"duration": as_duration("1h")},
    "drawn": {"duration": as_duration("lognormal:1h,0.7"), "hold": as_hold("0.5:100")},
    "leaky": {"duration": as_duration("2h"), "residual": 0.2, "hold": as_hold("0.5:70")},
    "leaky here and there": {
        "duration": as_duration("2h"),
        "residual": np.random.default_rng(3).choice([0.0, 0.3, 1.0], (150, 171)),
    },
    "embers": {
        "duration": as_duration("1h"),
        "embers": as_embers("rate=500,longest=400,wind_speed=8,wind_from_direction=290"),
        "hold": as_hold("0.5:100"),
    },
    "contained": {"duration": as_duration("3h"), "containment": as_containment("lognormal:40min,0.8")},
    "attacked": {"duration": as_duration("3h"), "containment": as_containment("attack:1h;size=1")},
    "points": {
        "duration": as_duration("1h"),
        "ignitions": [(500_300.0, 3_999_000.0), (502_000.0, 3_998_700.0)],
        "ignition_mode": "all",
    },
}


@pytest.mark.parametrize("fires", ["drawn", "leaky", "embers", "attacked"])
def test_windows_lose_the_same_value(fires):
    network, breaks = landscape()
    value = np.random.default_rng(1).random(network.shape)
    request = FireRequest(n_runs=40, seed=5, **FIRES[fires])
    whole = burn(network, request, breaks=breaks, value=value, first_run=7)
    parts = burn_windows(MapInMemory(network, breaks), request, side=16, value=value, first_run=7, threads=2)
    assert whole["value_lost"].mean() > 10
    assert whole.identical(parts)


@pytest.mark.parametrize("fires", FIRES)
@pytest.mark.parametrize("side", [16, 64, 512])
def test_windows_change_nothing(fires, side):
    network, breaks = landscape()
    request = FireRequest(n_runs=40, seed=5, **FIRES[fires])
    whole = burn(network, request, breaks=breaks)
    parts = burn_windows(MapInMemory(network, breaks), request, side=side, threads=2)
    assert whole["fire_size"].max() > 100
    assert whole.identical(parts)


def test_barriers_that_may_fail():
    network, breaks = landscape()
    request = FireRequest(n_runs=30, duration=as_duration("2h"), barriers_hold=0.5, hold=as_hold("0.5:100"))
    barriers = np.roll(breaks, 9, axis=1)
    whole = burn(network, request, breaks=breaks, barriers=barriers)
    assert whole.identical(burn_windows(MapInMemory(network, breaks, barriers), request, side=16))


def test_lines_are_cut_by_windows_as_cells_are():
    import geopandas as gpd
    from shapely.geometry import LineString

    from firebreak_gis.landscape.lines import line_breaks

    network, _ = landscape()
    lines = gpd.GeoDataFrame(
        geometry=[LineString([(500_100, 3_999_900 - k), (503_300, 3_997_300 + k)]) for k in range(0, 2_600, 300)],
        crs="EPSG:32635",
    )
    breaks = line_breaks(lines, network.grid, width=12.0)
    request = FireRequest(n_runs=30, duration=as_duration("2h"), hold=as_hold("0.5:100"))
    whole = burn(network, request, breaks=breaks)
    assert whole["fire_size"].sum() < burn(network, request)["fire_size"].sum()
    assert whole.identical(burn_windows(MapInMemory(network, breaks), request, side=32))


def test_what_has_no_windows_is_refused():
    network, breaks = landscape((40, 50))
    with pytest.raises(ParameterError, match="power of two"):
        burn_windows(MapInMemory(network), FireRequest(n_runs=1), side=100)
    with pytest.raises(ParameterError, match="as a whole"):
        burn_windows(MapInMemory(network, breaks), FireRequest(n_runs=1, hold=as_hold("flame")), side=16)
    torus = SpreadNetwork(np.full((8, 20, 20), 0.5), boundary="periodic", travel_time=np.full((8, 20, 20), 60.0))
    with pytest.raises(ParameterError, match="torus"):
        burn_windows(MapInMemory(torus), FireRequest(n_runs=1), side=16)


def test_a_window_knows_its_place():
    whole = (70, 100)
    window = Window.around(60, 5, 66, 9, whole, 16)
    assert window.shape == (16, 16)
    assert window.top + 16 <= 70
    rows, cols = window.slices
    numbers = np.arange(7_000).reshape(whole)
    inside = numbers[window.slices]
    np.testing.assert_array_equal(window.local(inside.ravel()), np.arange(256))
    assert window.corner == inside[0, 0]
    found = steps((16, 16), periodic=False, corner=window.corner, map_cols=100)
    cell = np.arange(256, dtype=np.uint64)
    np.testing.assert_array_equal(found.first + cell + (cell >> found.shift) * found.skip, inside.ravel())
    np.testing.assert_array_equal(
        stretches(window.shape, 20.0, 100.0, window), stretches(whole, 20.0, 100.0)[window.slices]
    )
    grid = Grid(whole, landscape((5, 5))[0].grid.transform, None)
    np.testing.assert_allclose(window.grid(grid).x, grid.x[cols])
    np.testing.assert_allclose(window.grid(grid).y, grid.y[rows])
    with pytest.raises(ValueError, match="power of two"):
        steps((16, 20), periodic=False, corner=0, map_cols=100)


def test_the_rim_is_where_the_map_goes_on():
    window = Window(0, 84, (16, 16), (70, 100))
    rim = window.rim(2)
    assert rim[-2:].all()
    assert rim[:, :2].all()
    assert not rim[:14, 2:].any()
    assert not Window(0, 0, (70, 100), (70, 100)).rim(3).any()


def test_tiles_hold_every_run_that_burns_once():
    rng = np.random.default_rng(1)
    starts = np.concatenate([[0], np.cumsum(rng.integers(0, 3, 200))])
    cells = rng.integers(-1, 7_000, starts[-1])
    found = list(tiles(cells, starts, (70, 100), 16))
    burning = [i for i in range(200) if (cells[starts[i] : starts[i + 1]] >= 0).any()]
    assert sorted(np.concatenate(found).tolist()) == burning
    for runs in found:
        places = np.concatenate([cells[starts[i] : starts[i + 1]] for i in runs])
        places = places[places >= 0]
        if runs.size > 1:
            assert np.ptp(places // 100 // 16) == np.ptp(places % 100 // 16) == 0


def test_random_cells_are_those_of_equal_weights():
    from firebreak_gis.simulation.ignitions import resolve_ignitions

    network, _ = landscape()
    drawn = resolve_ignitions(network, n_runs=500, seed=4).cells
    weighed = resolve_ignitions(network, network.burnable.astype(float), n_runs=500, seed=4).cells
    np.testing.assert_array_equal(drawn, weighed)
