"""Which cells geometries cut and how much of each, against a slow twin that intersects every cell."""

from itertools import pairwise

import geopandas as gpd
import numpy as np
import pytest
import shapely
from affine import Affine
from hypothesis import example, given, settings
from hypothesis import strategies as st

from firebreak_gis.grid import Grid, parse_crs
from firebreak_gis.landscape.footprints import LEAST_PART, close_corners, corner_contacts, footprints
from tests.places import UTM, square

GRID = Grid((9, 13), square(), parse_crs(UTM))
LEFT, _, _, TOP = GRID.bounds


def on_map(shapes, cell=20.0):
    """Geometries in (column, row) coordinates, on the map."""
    return gpd.GeoDataFrame(
        geometry=[
            shapely.transform(s, lambda p: np.column_stack((LEFT + cell * p[:, 0], TOP - cell * p[:, 1])))
            for s in shapes
        ],
        crs=UTM,
    )


def twin(shape, rows=9, cols=13):
    found = {}
    for row in range(rows):
        for col in range(cols):
            piece = shape.intersection(shapely.box(col, row, col + 1, row + 1))
            part = piece.area if shapely.get_dimensions(shape) == 2 else piece.length
            if part > LEAST_PART:
                found[row * cols + col] = part
    return found


def random_shape(rng, kind):
    corners = rng.uniform(-3, 15, (5, 2)) if rng.random() < 0.5 else rng.integers(-6, 30, (5, 2)) / 2.0
    line = shapely.LineString(corners)
    if kind == "line":
        return line
    if kind == "thin":
        return line.buffer(rng.uniform(1e-3, 0.2), cap_style="flat")
    if kind == "hull":
        return line.convex_hull
    if kind == "box":
        x, y = rng.integers(-8, 24, 2) / 4.0
        return shapely.box(x, y, x + rng.integers(1, 40) / 4.0, y + rng.integers(1, 40) / 4.0)
    ring = shapely.Point(corners[0]).buffer(rng.uniform(0.1, 6))
    return ring.difference(shapely.affinity.scale(ring, 0.6, 0.6)).union(shapely.box(0, 0, 1.5, 1))


@settings(max_examples=40, deadline=None)
@example(4333, ["thin", "thin", "line"])
@example(345616, ["hull", "thin", "thin", "line"])
@given(
    st.integers(0, 10**6), st.lists(st.sampled_from(["thin", "hull", "box", "ring", "line"]), min_size=1, max_size=4)
)
def test_cells_and_parts_are_those_of_the_twin(seed, kinds):
    rng = np.random.default_rng(seed)
    shapes = [s for s in (random_shape(rng, kind) for kind in kinds) if not s.is_empty]
    shapes = [s for s in shapes if shapely.get_dimensions(s) > 0]
    prints = footprints(on_map(shapes), GRID)
    for i, shape in enumerate(shapes):
        mine = prints.feature == i
        found = dict(zip(prints.cell[mine].tolist(), prints.part[mine].tolist(), strict=True))
        expected = twin(shape)
        if shapely.get_dimensions(shape) == 1:  # a line along an edge of cells may count on either side
            # Piece by piece: a line may go over the same ground twice.
            pieces = [shapely.LineString(pair) for pair in pairwise(shapely.get_coordinates(shape))]
            assert sum(found.values()) <= sum(sum(twin(piece).values()) for piece in pieces) + 1e-6
            inside = sum(piece.intersection(shapely.box(0, 0, 13, 9)).length for piece in pieces)
            assert sum(found.values()) == pytest.approx(inside, abs=1e-6) or inside > sum(found.values())
            assert set(found) <= set(expected)
            continue
        for cell in set(found) | set(expected):
            assert found.get(cell, 0.0) == pytest.approx(expected.get(cell, 0.0), abs=2e-7)
        assert prints.whole[i] == pytest.approx(shape.area)


def test_points_count_once_each_and_only_inside():
    shapes = [shapely.MultiPoint([(0.5, 0.5), (0.6, 0.6), (3.5, 2.5), (20, 2)]), shapely.Point(-1, 0)]
    prints = footprints(on_map(shapes), GRID)
    assert prints.cell.tolist() == [0, 2 * 13 + 3]
    assert prints.part.tolist() == [2, 1]
    assert prints.whole.tolist() == [4, 1]


def test_what_only_touches_from_outside_is_not_cut():
    """The edges of a polygon on edges of cells: the ring of cells around is not in it."""
    prints = footprints(on_map([shapely.box(2, 3, 5, 6)]), GRID)
    expected = np.zeros(GRID.shape, bool)
    expected[3:6, 2:5] = True
    assert prints.cell.tolist() == np.flatnonzero(expected).tolist()
    assert (prints.part > 1 - 1e-9).all()


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 10**6), st.sampled_from([1e-6, 1e-3, 0.05, 0.4]), st.booleans())
def test_a_thin_polygon_or_line_parts_the_grid(seed, width, through_corners):
    """No step from a cell to one of its eight neighbours leads from one side to the other."""
    from scipy import ndimage

    rng = np.random.default_rng(seed)
    row = rng.integers(1, 9) if through_corners else rng.uniform(1, 8)
    slope = rng.choice([-1.0, 1.0]) if through_corners else rng.normal()
    shapes = [shapely.LineString([(col, row + slope * (col - 6)) for col in np.linspace(-30, 43, 74)])]
    if width > 1e-5:
        shapes = [shapely.LineString(shapes[0].coords[::73]).buffer(width / 2, cap_style="flat")]
    frame = on_map(shapes)
    mask = np.zeros(GRID.shape, bool)
    mask.ravel()[footprints(frame, GRID).cell] = True
    mask = close_corners(mask, frame, GRID)
    cols, rows = np.meshgrid(np.arange(13) + 0.5, np.arange(9) + 0.5)
    side = rows > row + slope * (cols - 6)
    labels, _ = ndimage.label(~mask, structure=np.ones((3, 3)))
    one, other = (set(labels[~mask & part].tolist()) for part in (side, ~side))
    assert not one & other


def test_corner_contacts_are_those_of_two_cells_that_meet_nowhere_else():
    mask = np.array([[1, 0, 0], [0, 1, 1], [1, 0, 0]], bool)
    falling, rising = corner_contacts(mask)
    assert falling.tolist() == [[True, False], [False, False]]
    assert rising.tolist() == [[False, False], [True, False]]


def test_many_small_and_one_large_polygon_are_quick():
    import time

    grid = Grid((1000, 1000), Affine(20, 0, LEFT, 0, -20, TOP), parse_crs(UTM))
    rng = np.random.default_rng(0)
    houses = [shapely.box(x, y, x + 0.5, y + 0.4) for x, y in rng.uniform(0, 1000, (20_000, 2))]
    frame = on_map([*houses, shapely.Point(500, 500).buffer(400, quad_segs=2000)])
    start = time.perf_counter()
    prints = footprints(frame, grid)
    assert time.perf_counter() - start < 10
    share = prints.part / prints.whole[prints.feature]
    inside = np.bincount(prints.feature, weights=share)
    assert inside.max() < 1 + 1e-9
    assert np.median(inside) == pytest.approx(1, abs=1e-9)
