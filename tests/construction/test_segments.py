"""Compartments and segments: hand-drawn cases, slow twins, mirrored maps, the sample landscape."""

from __future__ import annotations

import itertools
import math

import geopandas as gpd
import numpy as np
import pytest
import shapely
from affine import Affine
from rasterio.features import rasterize

import firebreak_gis as fb
from firebreak_gis.breaks import select_breaks
from firebreak_gis.construction import centrelines
from firebreak_gis.construction.centrelines import find_borders
from firebreak_gis.construction.compartments import compartments_of, split
from firebreak_gis.construction.segments import segments_of
from firebreak_gis.construction.sequence import construction_order
from firebreak_gis.errors import GridError, InputError
from firebreak_gis.grid import Grid
from firebreak_gis.kernels.terrain import horn_slope
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.ranking import rank
from firebreak_gis.simulation.fires import simulate
from firebreak_gis.spread import spread_network
from firebreak_gis.vectors import write_vector
from tests.twins import centrality as turned
from tests.twins import segments as twin

CELL = 20.0
PLACE = Affine(CELL, 0, 586_440.0, 0, -CELL, 3_999_900.0)
COLUMNS = [
    "order",
    "stage",
    "length_m",
    "width_m",
    "cells",
    "area_ha",
    "mean_slope_deg",
    "max_slope_deg",
    "cost",
    "compartment_a",
    "compartment_b",
    "gain",
    "gain_share",
    "stage_gain_share",
    "geometry",
]


def drawn(*rows: str) -> tuple[SpreadNetwork, np.ndarray]:
    """Network and breaks of a picture: # cut, ~ no fuel, . fuel."""
    picture = np.array([list(row) for row in rows])
    probability = np.full((8, *picture.shape), 0.5, np.float32)
    return SpreadNetwork(probability, burnable=picture != "~", crs="EPSG:32635", transform=PLACE), picture == "#"


def random_case(seed: int, boundary: str = "open", shape: tuple[int, int] = (11, 14)):
    """Sparse one-way edges, holes, a random mask (some of it off fuel) and masses without ties."""
    rng = np.random.default_rng(seed)
    probability = rng.random((8, *shape)).astype(np.float32)
    probability[rng.random(probability.shape) < (0.0, 0.3, 0.6)[seed % 3]] = 0
    network = SpreadNetwork(
        probability, burnable=rng.random(shape) > 0.12, boundary=boundary, crs="EPSG:32635", transform=PLACE
    )
    cut = rng.random(shape) < (0.15, 0.3, 0.45, 0.6)[seed % 4]
    cut[shape[0] // 2] = True
    cut[:, shape[1] // 3] = True
    planes = {name: rng.random(shape) for name in ("value", "ignition", "cost")}
    return network, cut, planes


def owners(polygons: gpd.GeoDataFrame, network: SpreadNetwork) -> np.ndarray:
    """Order of the segment that covers each cell; counts must not overlap."""
    count = np.zeros(network.shape, int)
    owner = np.zeros(network.shape, int)
    for place, geometry in zip(polygons["order"], polygons.geometry, strict=True):
        inside = rasterize([geometry], network.shape, transform=network.grid.transform)
        count += inside
        owner[inside > 0] = place
    assert count.max(initial=0) <= 1
    return owner


def check(network: SpreadNetwork, cut: np.ndarray, **planes: np.ndarray) -> tuple[gpd.GeoDataFrame, gpd.GeoDataFrame]:
    """Segments, with everything that must hold for any of them."""
    lines, polygons = segments_of(network, cut, **planes)
    weighed = {k: v for k, v in planes.items() if k in ("value", "ignition")}
    _, table = compartments_of(network, cut, **weighed)
    _, before = compartments_of(network, np.zeros(network.shape), **weighed)
    assert list(lines.columns) == list(polygons.columns) == COLUMNS
    assert lines.crs == polygons.crs == network.grid.crs
    for frame in (lines, polygons, table):
        assert frame.geometry.is_valid.all()
        assert not frame.geometry.is_empty.any()
    assert polygons["order"].tolist() == list(range(1, len(polygons) + 1))
    assert (np.diff(np.append(1, polygons["stage"])) >= 0).all()
    assert set(polygons["stage"]) == set(range(1, polygons["stage"].max() + 1)) if len(polygons) else True
    owner = owners(polygons, network)
    np.testing.assert_array_equal(owner > 0, cut)
    np.testing.assert_array_equal(np.bincount(owner.ravel(), minlength=len(polygons) + 1)[1:], polygons["cells"])
    np.testing.assert_allclose(polygons.geometry.area, polygons["area_ha"] * 1e4)
    np.testing.assert_allclose(polygons["cells"] * network.grid.cell_area_ha, polygons["area_ha"])
    assert (polygons["gain"] >= 0).all()
    np.testing.assert_allclose(polygons["gain"].sum() + table["expected_loss"].sum(), before["expected_loss"].sum())
    if polygons["gain"].sum() > 0:
        assert polygons["gain_share"].sum() == pytest.approx(1)
    of_stage = polygons.groupby("stage")["gain_share"].transform("sum")
    np.testing.assert_allclose(polygons["stage_gain_share"], of_stage, atol=1e-12)
    # Both layers hold the same segments with the same numbers; lines lie inside, and no width is below a cell's.
    assert lines.drop(columns="geometry").equals(polygons.drop(columns="geometry"))
    apart = (lines["compartment_a"] == 0) & (lines["compartment_b"] == 0)
    assert (apart | (lines["compartment_a"] < lines["compartment_b"])).all()
    np.testing.assert_allclose(lines.geometry.length, lines["length_m"])
    assert (lines["length_m"] > 0).all()
    assert set(lines.geom_type) <= {"LineString", "MultiLineString"}
    assert polygons.buffer(1e-6 * network.grid.cell_size).covers(lines.geometry).all()
    assert (lines["width_m"] >= network.grid.cell_size * (1 - 1e-9)).all()
    return lines, polygons


def test_straight_wall():
    network, cut = drawn(*["...#....."] * 4)
    lines, polygons = check(network, cut)
    row = lines.iloc[0]
    assert len(lines) == len(polygons) == 1
    assert (row["compartment_a"], row["compartment_b"], row["cells"]) == (1, 2, 4)
    assert row["length_m"] == 4 * CELL
    assert row["width_m"] == pytest.approx(CELL)
    assert row["cost"] == 4
    assert math.isnan(row["mean_slope_deg"])
    assert row["gain"] == pytest.approx(36 - (20 * 20 + 12 * 12) / 36)
    assert row["gain_share"] == 1
    middle = PLACE @ (3.5, 0), PLACE @ (3.5, 4)
    assert row.geometry.equals(shapely.LineString(middle))


@pytest.mark.parametrize("width", [1, 2, 3, 4, 5])
def test_thick_walls_keep_their_middle_line(width):
    network, cut = drawn(*["...." + "#" * width + "....."] * 6)
    lines, polygons = check(network, cut)
    assert len(polygons) == 1
    assert lines.iloc[0]["width_m"] == pytest.approx(width * CELL)
    assert lines.geometry.iloc[0].equals(shapely.LineString([PLACE @ (4 + width / 2, 0), PLACE @ (4 + width / 2, 6)]))


def test_lines_drawn_together_or_one_by_one_are_the_same(monkeypatch):
    cut = np.zeros((40, 50), bool)
    cut[::6] = cut[3:5, ::2] = cut[:, ::7] = True
    network = SpreadNetwork(np.full((8, 40, 50), 0.5), transform=PLACE)
    parts = split(network, cut)
    borders = centrelines.find_borders(parts.labels, cut)
    whole = centrelines.draw_lines(borders, PLACE)
    for together in (1, 7, 60):
        monkeypatch.setattr(centrelines, "_TOGETHER", together)
        drawn = centrelines.draw_lines(borders, PLACE)
        assert len(drawn) == len(borders.pair) > 20
        assert all(one.equals_exact(other, 0.0) for one, other in zip(drawn, whole, strict=True))


@pytest.mark.parametrize("width", [1, 2, 3])
def test_t_junction_has_three_segments(width):
    above = ["....." + "#" * width + "......"] * 4
    network, cut = drawn(*above, *["#" * (11 + width)] * width, *["." * (11 + width)] * 5)
    lines, polygons = check(network, cut)
    assert len(lines) == len(polygons) == 3
    pairs = zip(lines["compartment_a"], lines["compartment_b"], strict=True)
    assert set(pairs) == {(1, 2), (1, 3), (2, 3)}
    ends = [shapely.get_coordinates(line)[[0, -1]] for line in lines.geometry]
    gaps = [shapely.distance(*pair) for pair in itertools.combinations(lines.geometry, 2)]
    assert max(gaps) <= 2 * width * CELL  # the junction belongs to one of them, at whose edge the others end
    assert len({tuple(point) for pair in ends for point in pair}) >= 5
    # The cells of the junction go to what is built first, and nothing stands open once a stage is finished.
    assert polygons["gain"].tolist() == pytest.approx(
        twin.gains(network, owners(polygons, network), 3, *[network.burnable.astype(float)] * 2)
    )


def test_ring():
    network, cut = drawn("........", ".######.", ".#....#.", ".#....#.", ".######.", "........")
    lines, polygons = check(network, cut)
    assert len(polygons) == 1
    assert lines.geometry.iloc[0].is_ring
    assert 16 * CELL > lines["length_m"].iloc[0] > (16 - 4 * 0.6) * CELL  # corners are rounded
    assert lines["gain"].iloc[0] == pytest.approx(48 - (24**2 + 8**2) / 48)
    assert len(polygons.geometry.iloc[0].interiors) == 1


def test_staircase_becomes_a_diagonal():
    n = 30
    cut = np.eye(n, dtype=bool) | np.eye(n, k=1, dtype=bool)
    network = SpreadNetwork(np.full((8, n, n), 0.5), crs="EPSG:32635", transform=PLACE)
    lines, polygons = check(network, cut)
    assert len(polygons) == 1
    assert lines["length_m"].iloc[0] == pytest.approx(math.sqrt(2) * n * CELL, rel=0.07)
    assert lines["width_m"].iloc[0] == pytest.approx(CELL)
    assert len(lines.geometry.iloc[0].coords) < 10


def test_a_diagonal_that_fire_passes_separates_nothing():
    network, cut = drawn("#....", ".#...", "..#..", "...#.", "....#")
    lines, polygons = check(network, cut)
    assert lines["width_m"].tolist() == [CELL]  # cells that meet at corners
    assert polygons[["compartment_a", "compartment_b"]].to_numpy().tolist() == [[0, 0]]


def test_spur_and_patch_separate_nothing():
    network, cut = drawn(
        "...#.......",
        "...#.......",
        "...#####...",
        "...#.......",
        "...#.....##",
        "...#.....##",
        "...#.......",
    )
    lines, polygons = check(network, cut)
    assert len(lines) == 3
    assert polygons["cells"].tolist() == [8, 4, 3]  # the foot of the spur counts as wall
    assert polygons["compartment_a"].tolist() == [1, 0, 0]
    assert polygons["compartment_b"].tolist() == [2, 0, 0]
    assert sorted(polygons["length_m"].tolist()[1:]) == [2 * CELL, 3 * CELL] or polygons["length_m"].min() > CELL
    assert polygons["width_m"].tolist() == pytest.approx([CELL, 2 * CELL, CELL])
    assert polygons["gain"].is_monotonic_decreasing


def test_a_road_splits_a_wall_but_both_parts_are_one_stage():
    network, cut = drawn("...#...", "...#...", "~~~~~~~", "...#...", "...#...", "...#...")
    _, polygons = check(network, cut)
    assert len(polygons) == 2
    assert polygons["stage"].nunique() == 2  # two pairs of compartments: the road is a wall
    network, cut = drawn("...#...", "...#...", "...~...", "...#...", "...#...", "...#...")
    _, polygons = check(network, cut)
    assert polygons["cells"].tolist() == [2, 3]
    assert polygons["stage"].tolist() == [1, 1]
    assert polygons["gain"].iloc[0] < 0.2 * polygons["gain"].iloc[1]  # a wall works when it is closed


def test_no_breaks_and_everything_cut():
    network, cut = drawn("....", "....", "....")
    lines, polygons = check(network, cut)
    assert len(lines) == len(polygons) == 0
    lines, polygons = check(network, ~cut)
    assert lines["width_m"].tolist() == [3 * CELL]
    assert polygons["cells"].tolist() == [12]
    labels, table = compartments_of(network, ~cut)
    assert len(table) == 0
    assert not labels.any()


def test_no_fuel():
    cut = np.array([[0, 0, 1], [0, 0, 0]], bool)
    network = SpreadNetwork(np.zeros((8, 2, 3)))
    _, polygons = check(network, cut)
    assert polygons["gain"].tolist() == [0]
    assert polygons["gain_share"].tolist() == [0]
    assert polygons["cost"].tolist() == [0]


@pytest.mark.parametrize("shape", [(1, 9), (9, 1), (1, 1)])
def test_thin_grids(shape):
    cut = np.zeros(shape, bool)
    cut.flat[cut.size // 2] = True
    network = SpreadNetwork(np.full((8, *shape), 0.5), burnable=np.ones(shape, bool))
    lines, polygons = check(network, cut, elevation=np.zeros(shape))
    assert len(polygons) == 1
    assert polygons["mean_slope_deg"].tolist() == [0]
    assert len(lines) == 1


def test_slope_cost_value_and_ignition():
    network, cut = drawn(*["..#..."] * 5)
    column = np.broadcast_to(np.arange(6.0), (5, 6))
    elevation = column * CELL
    ignition = np.where(column < 2, 3.0, 1.0)
    lines, _ = check(network, cut, elevation=elevation, cost=column, value=column, ignition=ignition)
    total = ignition.sum()
    kept = 5 * 6 / total * 5 * 1 + 5 * 3 / total * 5 * 12
    assert lines["mean_slope_deg"].iloc[0] == lines["max_slope_deg"].iloc[0] == pytest.approx(45)
    rough = elevation + np.arange(5)[:, np.newaxis] ** 3
    slopes = horn_slope(rough, CELL)[cut]
    found = check(network, cut, elevation=rough)[0]
    assert found["max_slope_deg"].tolist() == [slopes.max()]
    assert found["mean_slope_deg"].tolist() == [pytest.approx(slopes.mean())]
    assert slopes.max() > slopes.mean() + 1
    assert lines["cost"].iloc[0] == 5 * 2
    assert lines["gain"].iloc[0] == pytest.approx(5 * 15 - kept)
    elevation = np.where(column == 2, elevation, np.nan)
    unknown = segments_of(network, cut, elevation=elevation)[0]
    assert unknown[["mean_slope_deg", "max_slope_deg"]].isna().all(axis=None)


def test_cheap_walls_of_large_compartments_come_first():
    network, cut = drawn(*[".......#.#..."] * 4)
    _, polygons = check(network, cut)
    assert polygons.geometry.centroid.x.is_monotonic_increasing
    assert polygons["gain"].is_monotonic_decreasing
    cost = np.ones(network.shape)
    cost[:, 7] = 100
    _, dear = check(network, cut, cost=cost)
    assert dear["cost"].tolist() == [4, 400]


def test_priority_decides_between_equals():
    network, cut = drawn(*["...#...", "...#..."], "~~~~~~~", *["...#...", "...#..."])
    for sign in (1, -1):
        priority = np.broadcast_to(sign * np.arange(5.0)[:, np.newaxis], network.shape).copy()
        priority[~network.burnable] = -np.inf
        _, polygons = check(network, cut, priority=priority)
        south = polygons.geometry.centroid.y < (PLACE @ (0, 2.5))[1]
        assert south.tolist() == [sign > 0, sign < 0]


def test_compartments_of_burns():
    network, cut = drawn(*["...#....~"] * 3)
    burns = simulate(network, breaks=cut, n_runs=40, seed=3)
    value = np.where(network.burnable, 2.0, np.nan)
    labels, table = compartments_of(network, cut, value=value, burns=burns)
    assert labels.dtype == np.int32
    assert Grid.of(labels).matches(network.grid)
    assert table["cells"].tolist() == [12, 9]
    frequency = burns["burn_frequency"].to_numpy()
    for k in (1, 2):
        assert table["burnt_value"][k - 1] == pytest.approx(2 * frequency[labels.to_numpy() == k].sum())
    assert table["ignition_share"].tolist() == pytest.approx([12 / 24, 9 / 24])
    assert table["expected_loss"].tolist() == pytest.approx([12 / 24 * 24, 9 / 24 * 18])


def test_wrong_input():
    network, cut = drawn("..#..", "..#..")
    with pytest.raises(GridError, match="breaks has shape"):
        segments_of(network, cut[:1])
    for name in ("cost", "value", "ignition"):
        for bad in (-1.0, math.nan, math.inf):
            with pytest.raises(InputError, match=name):
                segments_of(network, cut, **{name: np.full(network.shape, bad)})
    with pytest.raises(InputError, match="burn_frequency"):
        compartments_of(network, cut, burns=simulate(network, n_runs=1)[["burn_count"]])


@pytest.mark.parametrize("boundary", ["open", "periodic"])
@pytest.mark.parametrize("seed", range(12))
def test_random_masks(seed, boundary):
    network, cut, planes = random_case(seed, boundary)
    _, polygons = check(network, cut, **planes)
    labels, _ = compartments_of(network, cut)
    parts = {frozenset(part) for part in twin.compartments(network, cut)}
    found = {frozenset(map(tuple, np.argwhere(labels.to_numpy() == k).tolist())) for k in range(1, len(parts) + 1)}
    assert found == parts
    expected = twin.gains(network, owners(polygons, network), len(polygons), planes["ignition"], planes["value"])
    np.testing.assert_allclose(polygons["gain"], expected, atol=1e-9)


@pytest.mark.parametrize("seed", range(8))
def test_borders_are_those_of_the_twin(seed):
    network, cut, _ = random_case(seed)
    labels = compartments_of(network, cut)[0].to_numpy()
    borders = find_borders(labels, cut)
    units = {
        (tuple(borders.pair[edge].tolist()), *(tuple(end) for end in ends))
        for edge, ends in zip(borders.edge.tolist(), borders.ends.tolist(), strict=True)
    }
    assert len(units) == borders.edge.size
    assert units == twin.border_units(labels, cut)


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize(("n_parts", "n"), [(12, 30), (2, 3), (40, 55)])
def test_order_is_that_of_the_twin(seed, n_parts, n):
    rng = np.random.default_rng(seed)
    pair = np.sort([rng.choice(n_parts, 2, replace=False) + 1 for _ in range(n)], axis=1)
    cost, own, mass = rng.random(n), rng.random((2, n)) / 50, rng.random((2, n_parts))
    stages = construction_order(
        pair,
        cost=cost,
        ignition=own[0],
        value=own[1],
        compartment_ignition=mass[0],
        compartment_value=mass[1],
        score=np.zeros(n),
    )
    masses = {k + 1: (mass[0, k], mass[1, k]) for k in range(n_parts)}
    expected = twin.order([tuple(p) for p in pair.tolist()], cost.tolist(), own.T.tolist(), masses)
    assert [set(stage) for stage in stages] == expected


@pytest.mark.parametrize("symmetry", list(turned.SYMMETRIES.values())[1:], ids=list(turned.SYMMETRIES)[1:])
def test_turned_maps_give_turned_segments(symmetry):
    rows = ["....#......", "....#......", "###########", "......#....", "......#....", "......#...#", "......#...."]
    network, cut = drawn(*rows)
    rng = np.random.default_rng(5)
    planes = {name: rng.random(network.shape) + 0.5 for name in ("value", "ignition", "cost")}
    _, there = segments_of(network, cut, **planes)
    other = turned.turn_network(network, symmetry)
    _, back = segments_of(
        other, turned.turn(cut, symmetry), **{k: turned.turn(plane, symmetry) for k, plane in planes.items()}
    )
    for name in ("cells", "length_m", "compartment_a", "compartment_b", "gain", "cost", "stage"):
        scale = CELL if name == "length_m" else 1  # the turned network has no CRS
        np.testing.assert_allclose(there[name], back[name] * scale)
    np.testing.assert_array_equal(turned.turn(owners(there, network), symmetry), owners(back, other))


def test_inputs_stay_as_they_are():
    network, cut, planes = random_case(2)
    before = [cut.copy(), *(plane.copy() for plane in planes.values())]
    segments_of(network, cut, elevation=planes["cost"], priority=planes["value"], **planes)
    for old, new in zip(before, [cut, *planes.values()], strict=True):
        np.testing.assert_array_equal(old, new)


def test_on_a_torus_walls_close_over_the_seam():
    cut = np.zeros((6, 9), bool)
    cut[:, [0, 4]] = True
    network = SpreadNetwork(np.full((8, 6, 9), 0.5), boundary="periodic")
    lines, polygons = check(network, cut)
    assert len(lines) == len(polygons) == 2
    assert polygons["stage"].tolist() == [1, 1]
    assert lines["length_m"].tolist() == [6, 6]


def test_sample_landscape(sample, tmp_path):
    network = spread_network(sample)
    priority = rank(network, "dissection")
    breaks = select_breaks(priority, budget=0.05, burnable=network.burnable)
    cut = breaks.to_numpy() > 0
    lines, polygons = segments_of(network, breaks, priority=priority, elevation=sample["elevation"])
    _, table = compartments_of(network, breaks)
    _, before = compartments_of(network, np.zeros(network.shape))
    assert polygons["cells"].sum() == cut.sum()
    assert polygons.geometry.is_valid.all()
    assert polygons.geometry.union_all().area == pytest.approx(cut.sum() * network.grid.cell_area_ha * 1e4)
    assert polygons["gain"].sum() + table["expected_loss"].sum() == pytest.approx(before["expected_loss"].sum())
    assert 10 < len(table) < 200
    assert lines["cells"].sum() > 0.9 * cut.sum()  # nearly everything separates something
    assert lines["width_m"].median() == pytest.approx(network.grid.cell_size, rel=0.15)
    slopes = horn_slope(sample["elevation"].to_numpy().astype(float), network.grid.cell_size)
    for row in polygons.itertuples():
        inside = rasterize([row.geometry], cut.shape, transform=network.grid.transform) > 0
        assert row.cells == inside.sum()
        assert (row.max_slope_deg, row.mean_slope_deg) == pytest.approx((slopes[inside].max(), slopes[inside].mean()))
    for name, frame in (("lines", lines), ("segments", polygons), ("compartments", table)):
        path = write_vector(tmp_path / f"{name}.gpkg", frame)
        again = gpd.read_file(path)
        assert again.crs == frame.crs == network.grid.crs
        assert again.drop(columns="geometry").columns.tolist() == frame.drop(columns="geometry").columns.tolist()
        assert len(again) == len(frame)


def test_segments_tell_what_they_must_stop_where_the_network_has_times_and_heat():
    shape = (40, 60)
    heat = np.full(shape, 8_000.0)
    heat[:, 40:] = 50_000.0
    network = SpreadNetwork(
        np.full((8, *shape), 0.5),
        crs="EPSG:32635",
        transform=PLACE,
        travel_time=np.full((8, *shape), 80),
        heat=heat,
    )
    cut = np.zeros(shape, bool)
    cut[:, 10] = cut[:, 50:53] = True
    lines, polygons = segments_of(network, cut)
    told = ["intensity_kw_m", "flame_length_m", "breach", "width_wilson_m", "width_flames_m"]
    assert list(polygons.columns) == [*COLUMNS[:-1], *told, "geometry"]
    assert list(lines.columns) == list(polygons.columns)
    for _, row in polygons.iterrows():
        grass = row["cells"] == 40
        intensity = (8_000.0 if grass else 50_000.0) * 20.0 * math.sqrt(2) / 80.0
        width, b = (20.0, 0.99) if grass else (60.0, 0.38)
        assert row["intensity_kw_m"] == pytest.approx(intensity, rel=1e-5)
        assert row["flame_length_m"] == pytest.approx(0.0775 * intensity**0.46, rel=1e-5)
        z = math.exp(1.36 + 0.00036 * intensity - b * width)
        assert row["breach"] == pytest.approx(z / (1 + z), rel=1e-4)
        needed = row["width_wilson_m"]
        assert math.exp(1.36 + 0.00036 * intensity - b * needed) == pytest.approx(0.05 / 0.95, rel=1e-4)
        assert row["width_flames_m"] == pytest.approx(1.5 * row["flame_length_m"])


def test_segments_are_found_by_name_and_still_unpack():
    network = fb.spread_network(fb.forest((12, 20), seed=1), model="artificial")
    breaks = fb.select_breaks(fb.rank(network, budget=0.2), budget=0.2)
    built = segments_of(network, breaks)
    lines, polygons = built
    assert lines is built.lines
    assert polygons is built.polygons
    assert set(lines.geom_type) <= {"LineString", "MultiLineString"}
    assert set(polygons.geom_type) <= {"Polygon", "MultiPolygon"}
