"""Each way of resampling against a loop over single cells."""

import math
from collections import Counter

import numpy as np
import pytest
from affine import Affine
from pyproj import Transformer
from rasterio.enums import Resampling
from rasterio.io import MemoryFile
from rasterio.vrt import WarpedVRT

from firebreak_gis.grid import Grid, parse_crs
from firebreak_gis.landscape import resampling
from firebreak_gis.landscape.resampling import Placed, average, bilinear, mode, nearest
from tests.places import NORTH_WEST, UTM, patches, relief, square

GRID = Grid((13, 9), square(47.3, (NORTH_WEST[0] + 33.3, NORTH_WEST[1] - 41.7)), parse_crs(UTM))
PLACES = {
    "same_crs": (square(20.0), UTM),
    "rotated": (Affine.translation(*NORTH_WEST) @ Affine.rotation(-9) @ Affine.scale(21, -17), UTM),
    "degrees": (Affine(0.00023, 0, 27.9612, 0, -0.00019, 36.1402), "EPSG:4326"),
}
SHAPE = (41, 37)


def placed(place, row=0, col=0, shape=SHAPE):
    transform, crs = PLACES[place]
    return Placed(transform, parse_crs(crs), row, col, shape)


def centres_in_cells(place):
    """{(row, col) of the grid: [(row, col) of the source]}, one centre at a time."""
    transform, crs = PLACES[place]
    turn = Transformer.from_crs(crs, UTM, always_xy=True)
    found = {}
    for row in range(SHAPE[0]):
        for col in range(SHAPE[1]):
            x, y = turn.transform(*(transform @ (col + 0.5, row + 0.5)))
            c, r = ~GRID.transform @ (x, y)
            found.setdefault((math.floor(r), math.floor(c)), []).append((row, col))
    return found


@pytest.mark.parametrize("place", PLACES)
def test_average_is_the_mean_of_the_centres_inside(place):
    values = relief(*SHAPE).copy()
    values[10:14, 10:14] = np.nan
    result = average(values, placed(place), GRID)
    inside = centres_in_cells(place)
    compared = 0
    for row in range(GRID.shape[0]):
        for col in range(GRID.shape[1]):
            if (row, col) in inside:
                heights = [float(values[cell]) for cell in inside[row, col] if not np.isnan(values[cell])]
                expected = sum(heights) / len(heights) if heights else math.nan
                assert result[row, col] == pytest.approx(expected, rel=1e-6, nan_ok=True)
                compared += 1
    assert compared > 70


@pytest.mark.parametrize("place", PLACES)
def test_mode_is_the_vote_of_the_centres_inside(place):
    codes = patches(*SHAPE, [0, 1, 2, 3, 9], size=1).astype(np.int32)
    codes[codes == 9] = -1
    result = mode(codes, placed(place), GRID, -1)
    ties = 0
    for (row, col), cells in centres_in_cells(place).items():
        if 0 <= row < GRID.shape[0] and 0 <= col < GRID.shape[1]:
            votes = Counter(int(codes[cell]) for cell in cells)
            most = max(votes.values())
            winners = sorted(code for code, count in votes.items() if count == most)
            ties += len(winners) > 1
            real = [code for code in winners if code != -1]
            assert result[row, col] == (real[0] if real else -1)
    assert ties > 5


@pytest.mark.parametrize("place", PLACES)
def test_bilinear_weighs_the_four_centres_around(place):
    values = relief(*SHAPE).copy()
    values[10:14, 10:14] = np.nan
    grid = Grid((40, 35), square(19.1, (NORTH_WEST[0] + 3.3, NORTH_WEST[1] - 1.7)), parse_crs(UTM))
    result = bilinear(values, placed(place), grid)
    transform, crs = PLACES[place]
    turn = Transformer.from_crs(UTM, crs, always_xy=True)
    holes = 0
    for row, y in enumerate(grid.y):
        for col, x in enumerate(grid.x):
            c, r = ~transform @ turn.transform(x, y)
            expected = _bilinear_at(values, r, c)
            holes += math.isnan(expected)
            assert result[row, col] == pytest.approx(expected, rel=1e-6, nan_ok=True)
    assert 4 <= holes < 1000


def _bilinear_at(values, row, col):
    rows, cols = values.shape
    if not (0 <= row < rows and 0 <= col < cols) or math.isnan(values[int(row), int(col)]):
        return math.nan
    total = weights = 0.0
    first_row, first_col = math.floor(row - 0.5), math.floor(col - 0.5)
    for r in (first_row, first_row + 1):
        for c in (first_col, first_col + 1):
            value = float(values[min(max(r, 0), rows - 1), min(max(c, 0), cols - 1)])
            if not math.isnan(value):
                weight = (1 - abs(row - 0.5 - r)) * (1 - abs(col - 0.5 - c))
                total += weight * value
                weights += weight
    return total / weights


@pytest.mark.parametrize("how", [nearest, bilinear, average, mode])
@pytest.mark.parametrize("place", PLACES)
def test_blocks_and_windows_do_not_matter(how, place, monkeypatch):
    """A window with a margin of two cells of the grid gives the same cells, to the last bit."""
    classes = how in (nearest, mode)
    values = patches(*SHAPE, [0, 1, 2, 3]).astype(np.int32) if classes else relief(*SHAPE)
    rest = (-1,) if classes else ()
    whole = how(values, placed(place), GRID, *rest)
    monkeypatch.setattr(resampling, "BLOCK", 40)
    np.testing.assert_array_equal(how(values, placed(place), GRID, *rest), whole)
    part = Grid((4, 3), GRID.transform @ Affine.translation(4, 5), GRID.crs)
    window = (7, 3)
    cut = values[window[0] : 34, window[1] : 33]
    result = how(np.ascontiguousarray(cut), placed(place, *window, cut.shape), part, *rest)
    np.testing.assert_array_equal(result, whole[5:9, 4:7])


def test_a_shift_of_half_a_cell_takes_the_same_side_everywhere():
    """Every centre lies on a corner of four cells; rounding must not decide cell by cell."""
    codes = np.arange(SHAPE[0] * SHAPE[1], dtype=np.int32).reshape(SHAPE)
    corner = (NORTH_WEST[0] + 10.0, NORTH_WEST[1] - 10.0)
    grid = Grid((SHAPE[0] - 1, SHAPE[1] - 1), square(20.0, corner), parse_crs(UTM))
    np.testing.assert_array_equal(nearest(codes, placed("same_crs"), grid, -1), codes[1:, 1:])


def shifted(cells, cell=0.7, corner=(586_440 + 1 / 3, 3_999_900 - 1 / 7)):
    """A source and a grid of such cells, whose corner lies so many cells of it to the east and south."""
    source = Placed(square(cell, corner), parse_crs(UTM), 0, 0, SHAPE)
    start = (corner[0] + cells * cell, corner[1] - cells * cell)
    return source, Grid((SHAPE[0] - 1, SHAPE[1] - 1), square(cell, start), parse_crs(UTM))


@pytest.mark.parametrize("off", [0.0, -1e-7, 1e-7])
def test_centres_on_edges_take_the_same_side_whatever_the_rounding(off):
    """Positions on an edge come out as whole numbers or a little less; they belong to the east or south."""
    source, grid = shifted(0.5 + off)
    if off == 0.0:
        (_, columns, _), *_ = resampling._source_cells(source, grid)
        assert (columns < np.round(columns)).any(), "no noise, so that nothing is tested"
    codes = np.arange(SHAPE[0] * SHAPE[1], dtype=np.int32).reshape(SHAPE)
    np.testing.assert_array_equal(nearest(codes, source, grid, -1), codes[1:, 1:])
    # The other way round: centres of the source on edges of the grid.
    np.testing.assert_array_equal(mode(codes, source, grid, -1), codes[:-1, :-1])
    heights = codes.astype(np.float32)
    np.testing.assert_array_equal(average(heights, source, grid), heights[:-1, :-1])


def test_centres_off_an_edge_take_their_own_side():
    """What lies a hundred-thousandth of a cell beside an edge is not on it."""
    codes = np.arange(SHAPE[0] * SHAPE[1], dtype=np.int32).reshape(SHAPE)
    source, grid = shifted(0.5 - 1e-5)
    np.testing.assert_array_equal(nearest(codes, source, grid, -1), codes[:-1, :-1])
    source, grid = shifted(0.5 + 1e-5)
    np.testing.assert_array_equal(mode(codes, source, grid, -1), codes[1:, 1:])


def test_outside_is_missing():
    far = Grid((4, 5), square(20.0, (NORTH_WEST[0] - 60, NORTH_WEST[1] + 40)), parse_crs(UTM))
    codes = np.full(SHAPE, 7, dtype=np.int32)
    expected = np.full((4, 5), -1)
    expected[2:, 3:] = 7
    np.testing.assert_array_equal(nearest(codes, placed("same_crs"), far, -1), expected)
    np.testing.assert_array_equal(mode(codes, placed("same_crs"), far, -1), expected)
    heights = codes.astype(np.float32)
    wanted = np.where(expected == 7, np.float32(7), np.float32(np.nan))
    np.testing.assert_array_equal(bilinear(heights, placed("same_crs"), far), wanted)
    np.testing.assert_array_equal(average(heights, placed("same_crs"), far), wanted)


@pytest.mark.parametrize("how", [nearest, bilinear])
@pytest.mark.parametrize("place", PLACES)
def test_gdal_forced_to_be_exact_agrees(how, place):
    """The warper of GDAL without its interpolation of coordinates, see the module's text."""
    grid = Grid((70, 61), square(9.7, (NORTH_WEST[0] + 63.3, NORTH_WEST[1] - 51.7)), parse_crs(UTM))
    classes = how is nearest
    values = patches(*SHAPE, [0, 1, 2, 3, 9], size=1).astype(np.int32) if classes else relief(*SHAPE)
    transform, crs = PLACES[place]
    profile = {"driver": "GTiff", "count": 1, "height": SHAPE[0], "width": SHAPE[1], "dtype": values.dtype.name}
    with MemoryFile() as memory:
        with memory.open(**profile, crs=crs, transform=transform) as target:
            target.write(values, 1)
        with (
            memory.open() as source,
            WarpedVRT(
                source,
                crs=UTM,
                transform=grid.transform,
                width=grid.shape[1],
                height=grid.shape[0],
                resampling=Resampling.nearest if classes else Resampling.bilinear,
                nodata=-1,
                tolerance=1e-12,
                XSCALE="1",
                YSCALE="1",
            ) as warped,
        ):
            expected = warped.read(1)
    if classes:
        np.testing.assert_array_equal(nearest(values, placed(place), grid, -1), expected)
    else:
        result = bilinear(values, placed(place), grid)
        np.testing.assert_allclose(np.where(np.isnan(result), -1, result), expected, rtol=1e-6)
    assert (expected != -1).mean() > 0.9
