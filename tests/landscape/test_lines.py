"""Lines with a width in metres: the links that they cross, and the fires that they stop."""

from __future__ import annotations

import math
from dataclasses import replace

import geopandas as gpd
import numpy as np
import pytest
import shapely
from affine import Affine

import firebreak_gis as fb
from firebreak_gis import SpreadNetwork, simulate
from firebreak_gis.errors import GridError, InputError, ParameterError
from firebreak_gis.grid import Grid, parse_crs
from firebreak_gis.kernels import draws
from firebreak_gis.kernels.walls import GROUND
from firebreak_gis.landscape.lines import beside, line_breaks, links_crossed
from firebreak_gis.lattice import COL_STEP, NEVER, OPPOSITE, ROW_STEP
from firebreak_gis.network import neighbour
from firebreak_gis.simulation.embers import Embers, what_flies, wind_of
from firebreak_gis.simulation.holding import Hold, breach, chances, fire_before, stretches
from firebreak_gis.simulation.products import Products
from tests.twins.arrival import Fire
from tests.twins.percolation import word

CRS = parse_crs("EPSG:32635")
PLACE = Affine(20, 0, 586_440, 0, -20, 3_999_900)
EACH = Products(arrivals=True)


def grid_of(shape):
    return Grid(shape, PLACE, CRS)


def drawn(lines, grid, width=8.0):
    """Lines in (column, row) coordinates as a frame in the CRS of the grid."""
    t = grid.transform
    on_map = [[(t.c + t.a * x, t.f + t.e * y) for x, y in line] for line in lines]
    frame = gpd.GeoDataFrame(geometry=[shapely.LineString(line) for line in on_map], crs=grid.crs)
    return frame.assign(width_m=width)


def wild(seed, shape, n=4, whole=False):
    """Random polylines, some vertices on centres and corners of cells if `whole`."""
    random = np.random.default_rng(seed)
    lines = [random.uniform(-1.0, [shape[1] + 1.0, shape[0] + 1.0], (random.integers(2, 6), 2)) for _ in range(n)]
    return [np.round(2 * line) / 2 if whole else line for line in lines]


def network_of(seed, shape=(17, 22)):
    random = np.random.default_rng(seed)
    return SpreadNetwork(
        random.uniform(0.2, 0.7, (8, *shape)),
        burnable=random.random(shape) > 0.08,
        travel_time=random.integers(40, 900, (8, *shape)),
        heat=random.uniform(5_000, 50_000, shape),
        crs=CRS,
        transform=PLACE,
    )


def breaks_of(seed, network, n=4, width=8.0):
    return line_breaks(drawn(wild(seed, network.shape, n), network.grid, width), network.grid, width="width_m")


@pytest.mark.parametrize("seed", range(6))
def test_links_crossed_are_those_that_shapely_crosses(seed):
    grid = grid_of((13, 17))
    lines = wild(seed, grid.shape)
    found, width, *_ = links_crossed(drawn(lines, grid), grid)
    whole = shapely.MultiLineString([np.rint(line * 4096) / 4096 for line in lines])
    for row in range(13):
        for col in range(17):
            for d in range(8):
                r, c = row + ROW_STEP[d], col + COL_STEP[d]
                link = shapely.LineString([(col + 0.5, row + 0.5), (c + 0.5, r + 0.5)])
                inside = 0 <= r < 13 and 0 <= c < 17
                assert bool(found[row, col] >> d & 1) == (inside and link.crosses(whole)), (row, col, d)
    forward = sum((found >> d & 1) for d in (2, 3, 4, 5)) > 0
    np.testing.assert_array_equal(width, np.where(forward, 8.0, 0.0))


@pytest.mark.parametrize("seed", range(20))
def test_links_are_crossed_from_both_ends_also_where_lines_touch_centres(seed):
    grid = grid_of((9, 11))
    found, *_ = links_crossed(drawn(wild(seed, grid.shape, whole=True), grid), grid)
    assert found.any()
    for d in range(8):
        np.testing.assert_array_equal(found >> d & 1, neighbour(found >> OPPOSITE[d] & 1, d))


@pytest.mark.parametrize(
    "ring",
    [
        [(2.5, 2.5), (8.5, 2.5), (8.5, 6.5), (2.5, 6.5), (2.5, 2.5)],  # through centres
        [(5.5, 0.5), (9.5, 4.5), (5.5, 8.5), (1.5, 4.5), (5.5, 0.5)],  # along diagonal links
        [(2.0, 2.0), (8.0, 2.0), (8.0, 7.0), (2.0, 7.0), (2.0, 2.0)],  # through corners
        [(1.1, 2.5), (9.7, 1.5), (8.5, 7.9), (3.5, 6.5), (1.1, 2.5)],
    ],
)
def test_a_closed_line_lets_no_fire_out(ring):
    grid = grid_of((9, 11))
    network = SpreadNetwork(np.ones((8, 9, 11)), crs=CRS, transform=PLACE)
    breaks = line_breaks(drawn([ring], grid), grid, width=5.0)
    burns = simulate(network, breaks=breaks, ignitions=(grid.x[5], grid.y[4]), ignition_mode="each", n_runs=1)
    inside = int(burns["burn_count"].sum())
    assert 0 < inside < 99
    out = simulate(network, breaks=breaks, ignitions=(grid.x[0], grid.y[0]), n_runs=1)
    assert int(out["burn_count"].sum()) == 99 - inside


def test_a_line_through_centres_counts_as_just_west_or_north_of_them():
    grid = grid_of((3, 3))
    crossed, *_ = links_crossed(drawn([[(1.5, -1), (1.5, 4)]], grid), grid)
    assert [int(v) for v in crossed[1]] == [0b00001110, 0b11100000, 0]
    crossed, *_ = links_crossed(drawn([[(-1, 1.5), (4, 1.5)]], grid), grid)
    assert [int(v) for v in crossed[:, 1]] == [0b00111000, 0b10000011, 0]


def keyed_holds(breaks, key, hold, chance, network):
    """Pairs of cells between which a line holds in a run, in plain Python."""
    held = set()
    stretch = breaks.stretches(hold.length)
    for cell in range(breaks.crossed.size):
        row, col = divmod(cell, network.shape[1])
        for d in (2, 3, 4, 5):
            if breaks.crossed[row, col] >> d & 1:
                draw = word(key, int(stretch[row, col])) >> 32
                if chance[row, col] >= 1 or draw < round(float(chance[row, col]) * 2**32):
                    held.add((cell, (row + ROW_STEP[d]) * network.shape[1] + col + COL_STEP[d]))
    return frozenset(held)


def old_break(network):
    """A break of whole cells across the map, two wide on one half."""
    cells = np.zeros(network.shape, bool)
    cells[network.shape[0] // 2] = True
    cells[network.shape[0] // 2 + 1, : network.shape[1] // 2] = True
    return cells


def cells_that_hold(cells, key, hold, network):
    """Cut cells that hold in a run, in plain Python."""
    chance, stretch = chances(network, cells, hold).ravel(), 2 * stretches(network.shape, 20.0, hold.length).ravel()
    often = {c: float(chance[c]) for c in np.flatnonzero(cells.ravel()).tolist()}
    return frozenset(c for c, p in often.items() if p >= 1 or word(key, int(stretch[c])) >> 32 < round(p * 2**32))


def spared_by_hand(breaks, key, hold, kept, network):
    """Share of each cell that does not burn with it in a run, in plain Python."""
    chance = np.full(breaks.cleared.cell.size, hold.share)
    if hold.share is None:
        mean, trees = (plane.ravel()[breaks.cleared.cell] for plane in fire_before(network, hold))
        chance = 1.0 - breach(mean, breaks.cleared.width, trees=trees)
    cleared, share = breaks.cleared, [0.0] * network.burnable.size
    stretch = cleared.stretches(hold.length)
    for k, cell in enumerate(cleared.cell.tolist()):
        often = chance[k]
        if often >= 1 or word(key, int(stretch[k])) >> 32 < round(float(often) * 2**32):
            share[cell] += int(cleared.part[k])
    return np.floor(np.minimum(share, GROUND) * (1.0 - kept)) / GROUND


@pytest.mark.parametrize("hold", [Hold(1.0), Hold(0.5, length=60.0), Hold(share=None, length=100.0)])
@pytest.mark.parametrize("residual", [0.0, 0.4])
@pytest.mark.parametrize("flying", [False, True])
@pytest.mark.parametrize("with_cells", [False, True])
def test_fires_with_lines_are_those_of_the_twin(hold, residual, flying, with_cells):
    network = network_of(3)
    lines = breaks_of(4, network, width=np.array([2.0, 9.0, 15.0, 40.0]))
    breaks = beside(lines, old_break(network)) if with_cells else lines
    fuel = network.burnable.ravel()
    cells = [c for c in np.unique(breaks.cleared.cell).tolist() if fuel[c]][30:50:5]
    embers = Embers(rate=20_000.0, wind_speed=5.0, wind_from_direction=10.0) if flying else None
    burns = simulate(
        network,
        breaks=breaks,
        hold=hold,
        residual=residual,
        embers=embers,
        ignitions=[(network.grid.x[cell % 22], network.grid.y[cell // 22]) for cell in cells],
        ignition_mode="all",
        n_runs=40,
        seed=3,
        duration=3000,
        products=EACH,
    )
    keys = {name: draws.run_keys(3, name, 40) for name in ("edges", "hold", "embers", "ground")}
    thrown = None
    if embers is not None:
        wind = [wind_of(embers, network)]
        thrown = what_flies(embers, network, keys["embers"], times=[network.travel_time], winds=wind)
    chance = np.full(network.shape, 1.0 if hold.share is None else hold.share)
    if hold.share is None:
        intensity, trees = fire_before(network, hold)
        chance = 1.0 - breach(intensity, breaks.width, trees=trees)
    stopped, nothing = 0, 0
    for run in range(40):
        key = int(keys["hold"][run])
        held = keyed_holds(breaks, key, hold, chance, network)
        stands = cells_that_hold(breaks.cells, key, hold, network) if with_cells else frozenset()
        ground = spared_by_hand(breaks, key, hold, residual, network)
        given = {"key": int(keys["edges"][run]), "times": [network.travel_time], "limit": 3000, "residual": residual}
        given |= {"embers": thrown, "ember_key": int(keys["embers"][run]), "ground_key": int(keys["ground"][run])}
        lit = dict.fromkeys(cells, 0)
        expected = Fire(network, parted=held, stands=stands, ground=ground, **given).burn(lit)
        found = burns["arrival"][run].to_numpy().ravel()
        assert {c: int(found[c]) for c in np.flatnonzero(found != NEVER).tolist()} == expected
        stopped += len(Fire(network, **given).burn(lit)) > len(expected)
        nothing += not set(cells) <= set(expected)
    assert stopped > 5
    assert nothing > 5 or residual > 0 or hold.share is None


@pytest.mark.parametrize("hold", [Hold(1.0), Hold(0.5, length=60.0), Hold(None, 100.0), Hold(None, 100.0, "flames")])
@pytest.mark.parametrize("residual", [0.0, 0.3])
def test_more_lines_never_burn_any_cell_earlier(hold, residual):
    network = network_of(8)
    lines = drawn(wild(9, network.shape, 8), network.grid, np.linspace(3.0, 40.0, 8))
    earlier, slower = None, 0
    for n in (1, 3, 8):
        found = simulate(
            network,
            breaks=line_breaks(lines[:n], network.grid, width="width_m"),
            residual=residual,
            hold=hold,
            embers=Embers(rate=20_000.0, wind_speed=5.0, wind_from_direction=10.0),
            duration="lognormal:40min,0.5",
            n_runs=60,
            seed=6,
            products=EACH,
        )["arrival"].to_numpy()
        if earlier is not None:
            assert (found >= earlier).all()
            slower += int((found > earlier).sum())
        earlier = found
    assert slower > 200


def test_runs_with_lines_do_not_depend_on_threads_or_on_how_they_are_split():
    network = network_of(5)
    given = {"breaks": breaks_of(6, network), "hold": 0.5, "duration": 2000, "seed": 2, "products": EACH}
    whole = simulate(network, n_runs=30, threads=1, **given)
    np.testing.assert_array_equal(simulate(network, n_runs=30, threads=2, **given)["arrival"], whole["arrival"])
    late = simulate(network, n_runs=10, first_run=20, **given)
    np.testing.assert_array_equal(late["arrival"], whole["arrival"][20:])


@pytest.mark.parametrize("residual", [0.0, 0.3])
@pytest.mark.parametrize("with_cells", [False, True])
def test_without_a_clock_lines_are_those_of_the_slow_path(residual, with_cells):
    network = network_of(7)
    breaks = beside(breaks_of(6, network), old_break(network) if with_cells else None)
    given = {"breaks": breaks, "residual": residual, "n_runs": 100, "seed": 2}
    fast = simulate(network, **given)
    slow = simulate(network, **given, hold=Hold(1.0), products=EACH)
    np.testing.assert_array_equal(slow["fire_size"], fast["fire_size"])
    np.testing.assert_array_equal(slow["burn_count"], fast["burn_count"])
    assert (fast["fire_size"] % 1 > 0).any()
    assert fast["fire_size"].sum() < simulate(network, n_runs=100, seed=2)["fire_size"].sum()


def test_stretches_are_lengths_along_the_line_whatever_comes_later():
    """Against a slow walk along each line, by the place on it nearest to where a link is crossed."""
    grid = grid_of((23, 31))
    frame = drawn(wild(11, grid.shape, 5), grid)
    frame.loc[2, "geometry"] = shapely.MultiLineString([frame.geometry[2], frame.geometry[3]])  # the gap counts
    breaks = line_breaks(frame, grid, width="width_m")
    owner = {}
    for row, col in zip(*np.nonzero(breaks.width > 0), strict=True):
        links = shapely.MultiLineString(
            [
                [grid_place(grid, col, row), grid_place(grid, col + COL_STEP[d], row + ROW_STEP[d])]
                for d in (2, 3, 4, 5)
                if breaks.crossed[row, col] >> d & 1
            ]
        )
        first = next(k for k, line in enumerate(frame.geometry) if line.distance(links) < 1e-6)
        assert owner.setdefault(int(breaks.line[row, col]), first) == first
        walk, nearest = walked(frame.geometry[first]), shapely.Point(grid_place(grid, col, row))
        near = [far for far, place in walk if place.distance(nearest) < 1.01 * math.sqrt(2) * 20.0]
        assert min(near) - 2.0 <= breaks.along[row, col] <= max(near) + 2.0
    assert sorted(owner.values()) == [0, 1, 2, 4]  # the third holds the fourth
    numbers = breaks.stretches(50.0)
    assert np.unique(numbers[breaks.width > 0]).size == sum(
        np.unique(np.floor(breaks.along[breaks.line == mark] / walked(frame.geometry[k])[-1][0] * n)).size
        for mark, k in owner.items()
        if (n := max(round(walked(frame.geometry[k])[-1][0] / 50.0), 1))
    )
    assert (numbers % 2 == 0).all()  # barriers are drawn by odd numbers
    fewer = line_breaks(frame.iloc[:2], grid, width="width_m")
    kept = fewer.width > 0
    np.testing.assert_array_equal(fewer.stretches(50.0)[kept], numbers[kept])


def test_a_line_has_as_many_stretches_as_come_nearest_to_their_length():
    grid = grid_of((9, 60))
    for cells, count in ((10, 1), (14, 1), (16, 2), (24, 2), (26, 3), (50, 5)):
        line = line_breaks(drawn([[(3.0, 4.0), (3.0 + cells, 4.0)]], grid), grid, width=5.0)
        numbers, along = line.stretches(200.0)[line.width > 0], line.along[line.width > 0]
        assert np.unique(numbers).size == count, cells
        for k, number in enumerate(dict.fromkeys(numbers[np.argsort(along)].tolist())):
            assert np.ptp(along[numbers == number]) <= 20.0 * cells / count, k


def grid_place(grid, col, row):
    t = grid.transform
    return t.c + t.a * (col + 0.5), t.f + t.e * (row + 0.5)


def walked(line):
    """Places along a line or multiline, and how far each is from its beginning."""
    places, far = [], 0.0
    end = None
    for part in shapely.get_parts(line):
        far += 0.0 if end is None else math.dist(end, part.coords[0])
        places += [(far + s, part.interpolate(s)) for s in np.arange(0.0, part.length, 1.0)]
        far, end = far + part.length, part.coords[-1]
    return places


def test_stretches_of_a_line_hold_by_themselves_in_every_direction():
    """All of a line of 400 m holds as often as one draw says, whatever its direction; one of 800 m as two do."""
    shape = (60, 60)
    network = SpreadNetwork(np.ones((8, *shape)), travel_time=np.full((8, *shape), 60), crs=CRS, transform=PLACE)
    for turn in (0.0, 0.4, math.pi / 4):
        for sides, draws_of in ((4, 1), (4, 2)):
            radius = 8.0
            corners = [
                (
                    30.2 + radius * math.cos(turn + k * math.tau / sides),
                    30.1 + radius * math.sin(turn + k * math.tau / sides),
                )
                for k in range(sides + 1)
            ]
            length = sides * 20.0 * radius * math.sqrt(2)
            ring = line_breaks(drawn([corners], network.grid), network.grid, width=5.0)
            fires = {"ignitions": (network.grid.x[30], network.grid.y[30]), "n_runs": 400, "seed": 5}
            hold = Hold(0.6, length=length / draws_of * 1.0001)
            sizes = simulate(network, breaks=ring, hold=hold, **fires)["fire_size"].to_numpy()
            held = (sizes < 3000).mean()
            assert abs(held - 0.6**draws_of) < 0.075, (turn, draws_of)


def test_a_barrier_that_fails_is_drawn_apart_from_lines():
    network = SpreadNetwork(np.ones((8, 5, 40)), travel_time=np.full((8, 5, 40), 60), crs=CRS, transform=PLACE)
    line = line_breaks(drawn([[(20.0, -1), (20.0, 6)]], network.grid), network.grid, width=5.0)
    cells = np.zeros(network.shape, bool)
    cells[:, 20] = True
    given = {"hold": "0.5:10000", "ignitions": (network.grid.x[3], network.grid.y[2]), "n_runs": 60, "seed": 1}
    by_line = simulate(network, breaks=line, **given)["fire_size"].to_numpy()
    assert 10 < (by_line == 99.375).sum() < 50
    assert set(by_line.tolist()) == {99.375, 200}  # where the line holds, its ground is no fuel
    failing = simulate(network, breaks=line, barriers=cells | np.roll(cells, -1, 1), barriers_hold=1e-9, **given)
    np.testing.assert_array_equal(failing["fire_size"], by_line)


def test_wide_lines_hold_by_the_flames_that_narrow_ones_do_not():
    network = SpreadNetwork(
        np.ones((8, 5, 40)),
        travel_time=np.full((8, 5, 40), 60),
        heat=np.full((5, 40), 10_000.0),
        crs=CRS,
        transform=PLACE,
    )
    flame = 0.0775 * (10_000 * math.hypot(20, 20) / 60) ** 0.46
    given = {"hold": "flame:flames", "ignitions": (network.grid.x[3], network.grid.y[2]), "n_runs": 1}
    for share, size in ((1.49, 200), (1.51, 100)):
        breaks = line_breaks(drawn([[(20.2, -1), (19.8, 6)]], network.grid), network.grid, width=share * flame)
        assert int(simulate(network, breaks=breaks, **given)["burn_count"].sum()) == size


def test_width_comes_from_a_number_or_a_column_and_makes_the_area(tmp_path):
    network = network_of(1)
    lines = drawn([[(2, 2), (5, 6)], [(1, 9), (12, 9)]], network.grid, np.array([6.0, 30.0]))
    lines.to_file(tmp_path / "lines.gpkg")
    own = line_breaks(tmp_path / "lines.gpkg", network.grid, width="width_m")
    assert own.area_ha == pytest.approx((100 * 6 + 220 * 30) / 10_000)
    assert set(np.unique(own.width).tolist()) == {0.0, 6.0, 30.0}
    same = line_breaks(tmp_path / "lines.gpkg", network.grid, width=12.0)
    np.testing.assert_array_equal(own.crossed, same.crossed)
    assert same.area_ha == pytest.approx(320 * 12 / 10_000)
    with pytest.raises(InputError, match=r"no column 'depth'.*width_m"):
        line_breaks(lines, network.grid, width="depth")
    with pytest.raises(ParameterError, match="width of 1 of 2 lines"):
        line_breaks(lines.assign(width_m=[3.0, 0.0]), network.grid, width="width_m")
    with pytest.raises(ParameterError, match="-2"):
        line_breaks(lines, network.grid, width=-2.0)
    with pytest.raises(InputError, match="no numbers"):
        line_breaks(lines.assign(width_m=["wide", "thin"]), network.grid, width="width_m")
    with pytest.raises(InputError, match="lines only"):
        line_breaks(lines.assign(geometry=lines.buffer(5)), network.grid, width=3.0)
    with pytest.raises(InputError, match="crosses no link"):
        line_breaks(lines.translate(50_000), network.grid, width=3.0)
    elsewhere = Grid(network.shape, Affine(40, 0, 0, 0, -40, 0), CRS)
    other = replace(own, grid=elsewhere)
    for hold in (None, 0.5):
        with pytest.raises(GridError, match="lines"):
            simulate(network, breaks=other, hold=hold, n_runs=1)
    assert fb.line_breaks is line_breaks
