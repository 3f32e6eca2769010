"""Areas are classes: no cell of a mask is made up by interpolation, none that an area cuts is missed."""

import geopandas as gpd
import numpy as np
import pytest
import shapely
from affine import Affine

from firebreak_gis import SpreadNetwork, simulate
from firebreak_gis.errors import InputError
from firebreak_gis.grid import Grid, parse_crs
from firebreak_gis.landscape.masks import mask_plane
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.stakes import with_barriers
from tests.places import NORTH_WEST, UTM, square, write

GRID = Grid((40, 60), square(), parse_crs(UTM))
LEFT, TOP = NORTH_WEST


def drawn(*shapes):
    """Geometries in (column, row) coordinates of the grid."""
    placed = [
        shapely.transform(s, lambda p: np.column_stack((LEFT + 20 * p[:, 0], TOP - 20 * p[:, 1]))) for s in shapes
    ]
    return gpd.GeoDataFrame(geometry=placed, crs=UTM)


def by_overlap(mask, cell, offset, rule):
    """Slow twin: cells of a mask of any cell size against each cell of the grid."""
    found = np.zeros(GRID.shape, bool)
    for row, col in np.ndindex(GRID.shape):
        spans = []
        for at, size, shift in ((row, mask.shape[0], offset[1]), (col, mask.shape[1], offset[0])):
            edges = shift + cell * np.arange(size + 1)
            overlap = np.minimum(edges[1:], 20 * at + 20) - np.maximum(edges[:-1], 20 * at)
            inside = (edges[:-1] <= 20 * at + 10) & (20 * at + 10 < edges[1:])
            spans.append((overlap > 0.05, inside, overlap.clip(0).sum()))
        part = np.ix_(spans[0][0], spans[1][0])
        centre = mask[np.ix_(spans[0][1], spans[1][1])]
        centre = bool(centre.size and centre[0, 0])
        if rule == "touched":
            found[row, col] = mask[part].any()
        elif rule == "centre":
            found[row, col] = centre
        else:
            found[row, col] = centre and mask[part].all()
    return found


@pytest.mark.parametrize("rule", ["touched", "centre", "within"])
@pytest.mark.parametrize(("cell", "offset"), [(5, (0, 0)), (7, (3, -11)), (20, (8, 4)), (50, (0, 0)), (70, (-30, 20))])
def test_rasters_on_other_cells_are_never_interpolated(tmp_path, rule, cell, offset):
    shape = (1 + int(830 / cell), 1 + int(1250 / cell))
    mask = np.random.default_rng(cell).random(shape) < (0.02 if cell < 10 else 0.2)
    path = write(
        tmp_path / "m.tif", mask.astype("uint8"), transform=Affine(cell, 0, LEFT + offset[0], 0, -cell, TOP - offset[1])
    )
    found = mask_plane(path, GRID, what="area", rule=rule)
    np.testing.assert_array_equal(found, by_overlap(mask, cell, offset, rule))


def test_a_mask_is_the_same_from_finer_coarser_and_equal_cells(tmp_path):
    """Whole blocks of 100 m: exactly these, neither grown by half a cell nor shrunk."""
    blocks = np.random.default_rng(1).random((8, 12)) < 0.3
    expected = np.kron(blocks, np.ones((5, 5), bool))
    for cell in (4, 10, 20, 100):
        times = 100 // cell
        fine = np.kron(blocks, np.ones((times, times), "uint8")).astype("uint8")
        path = write(tmp_path / f"{cell}.tif", fine, transform=square(float(cell)), nodata=0 if cell == 10 else None)
        for rule in ("touched", "centre", "within"):
            np.testing.assert_array_equal(mask_plane(path, GRID, what="area", rule=rule), expected)


def test_no_data_lies_outside_and_what_is_no_mask_is_refused(tmp_path):
    values = np.full((40, 60), 255, "uint8")
    values[5:9, 7:20] = 1
    account = Account()
    mask = mask_plane(write(tmp_path / "n.tif", values, nodata=255), GRID, what="area", rule="touched", account=account)
    assert mask.sum() == 4 * 13
    assert any("tells nothing about 0.978" in text for text in account.alignment)
    values[5, 7] = 7
    mask_plane(write(tmp_path / "o.tif", values), GRID, what="area", rule="touched", account=account)
    assert any("all values above 0 count as inside, here also 7, 255" in text for text in account.alignment)
    with pytest.raises(InputError, match=r"holds fractions such as 0\.5, expected a mask"):
        mask_plane(write(tmp_path / "f.tif", np.full((40, 60), 0.5)), GRID, what="area", rule="touched")


@pytest.mark.parametrize("rule", ["touched", "centre", "within"])
def test_a_mask_of_another_place_is_refused_as_polygons_are(tmp_path, rule):
    for name, far in (("a", square(20.0, (LEFT + 9e4, TOP))), ("b", square(50.0, (LEFT, TOP + 5e4)))):
        path = write(tmp_path / f"{name}.tif", np.ones((10, 10), "uint8"), transform=far)
        with pytest.raises(InputError, match="barriers does not touch the landscape"):
            mask_plane(path, GRID, what="barriers", rule=rule)
    with pytest.raises(InputError, match="barriers does not touch the landscape"):
        mask_plane(drawn(shapely.box(900, 900, 910, 910)), GRID, what="barriers", rule=rule)
    empty = write(tmp_path / "e.tif", np.full((40, 60), 9, "uint8"), nodata=9)
    with pytest.raises(InputError, match="does not touch"):
        mask_plane(empty, GRID, what="barriers", rule=rule)


def test_a_protected_polygon_is_protected_in_every_part():
    area = drawn(shapely.box(10.9, 5.2, 14.1, 8.7))
    expected = np.zeros(GRID.shape, bool)
    expected[5:9, 10:15] = True
    np.testing.assert_array_equal(mask_plane(area, GRID, what="protected", rule="touched"), expected)
    centre = np.zeros(GRID.shape, bool)
    centre[5:9, 11:14] = True
    np.testing.assert_array_equal(mask_plane(area, GRID, what="protected", rule="centre"), centre)
    within = np.zeros(GRID.shape, bool)
    within[6:8, 11:14] = True
    np.testing.assert_array_equal(mask_plane(area, GRID, what="allowed", rule="within"), within)


def test_areas_that_meet_allow_the_cells_on_their_border():
    parts = drawn(shapely.box(3, 3, 6.5, 8), shapely.box(6.5, 3, 10, 8))
    expected = np.zeros(GRID.shape, bool)
    expected[3:8, 3:10] = True
    np.testing.assert_array_equal(mask_plane(parts, GRID, what="allowed", rule="within"), expected)


def test_small_polygons_do_not_vanish_silently():
    tiny = drawn(shapely.box(4.1, 4.1, 4.2, 4.2), shapely.box(9, 9, 12, 12))
    assert mask_plane(tiny, GRID, what="protected", rule="touched")[4, 4]
    for rule in ("centre", "within"):
        account = Account()
        mask = mask_plane(tiny, GRID, what="protected", rule=rule, account=account)
        assert mask.sum() == 9
        assert any("1 of 2 polygons are too small or thin" in text for text in account.warnings)


@pytest.mark.parametrize("width", [0.01, 0.3, 1.0, 2.5])
@pytest.mark.parametrize("angle", [0.0, 0.3, np.pi / 4, 1.2, np.pi / 2])
@pytest.mark.parametrize("side", [1, -1])
def test_no_fire_passes_a_barrier_drawn_as_a_polygon_of_any_width(width, angle, side):
    """Certain spread from one side; 45 degrees runs through corners of cells."""
    middle, along = np.array([30.0, 20.0]), np.array([np.cos(angle), np.sin(angle)])
    line = shapely.LineString([middle - 80 * along, middle + 80 * along])
    network = SpreadNetwork(np.ones((8, 40, 60), np.float32), crs=UTM, transform=square())
    for shape in (line, line.buffer(width / 2, cap_style="flat")):
        mask = mask_plane(drawn(shape), GRID, what="barriers", rule="touched", solid=True)
        barred = with_barriers(network, mask)
        rows, cols = np.mgrid[0:40, 0:60] + 0.5
        across = (cols - middle[0]) * -along[1] + (rows - middle[1]) * along[0]
        start = np.unravel_index(np.argmax(np.where(mask, -np.inf, side * across)), GRID.shape)
        fire = simulate(barred, ignitions=[(GRID.x[start[1]], GRID.y[start[0]])], n_runs=1)
        burnt = fire["burn_count"].to_numpy() > 0
        assert burnt.sum() > 300
        assert (side * across[burnt] > 0).all()


def test_a_raster_of_lines_that_leak_at_corners_is_warned_of(tmp_path):
    account = Account()
    path = write(tmp_path / "d.tif", np.eye(40, 60, dtype="uint8"))
    mask_plane(path, GRID, what="barriers", rule="touched", solid=True, account=account)
    assert any("meet only at a corner in 39 places" in text for text in account.warnings)
