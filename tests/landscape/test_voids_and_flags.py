"""Voids of a DEM and flags of a cover are found before neighbours are mixed, however the layer is laid."""

import numpy as np
import pytest
from affine import Affine

from firebreak_gis.errors import InputError, LegendError
from firebreak_gis.grid import Grid, parse_crs
from firebreak_gis.landscape import read_landscape
from firebreak_gis.landscape.alignment import align_quantity
from firebreak_gis.landscape.legends import read_legend
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.rasters import read_header
from tests.places import NORTH_WEST, UTM, relief, square, write

ROWS, COLS = 60, 70
#: Ways in which a layer comes onto the grid: copied, interpolated, averaged.
WAYS = {"copied": {}, "finer": {"resolution": 13.0}, "coarser": {"resolution": 47.0}}


def dem_with(value, *, base=200.0, where=(slice(20, 35), slice(25, 40)), collar=False, dtype=np.float32, factor=1.0):
    """Hills of 200 to 1100 m with a hole, or a frame, of one value (in stored units)."""
    heights = (base + relief(ROWS, COLS)) / factor
    if collar:
        inner = heights[6:-6, 6:-6].copy()
        heights = np.full_like(heights, value)
        heights[6:-6, 6:-6] = inner
    else:
        heights[where] = value
    return heights.astype(dtype)


def landscape(tmp_path, heights, *, src_nodata=None, strict=False, units=None, **options):
    dem = write(tmp_path / "d.tif", heights, units=units)
    vegetation = write(tmp_path / "v.tif", np.full(heights.shape, 2, np.uint8))
    return read_landscape(
        dem,
        vegetation,
        "normal",
        src_nodata=None if src_nodata is None else {"dem": src_nodata},
        strict=strict,
        **options,
    )


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("void", [-999.0, -9999.0, -32768.0, -3.4e38])
def test_deep_voids_leave_no_ring_of_false_heights(tmp_path, void, way):
    got = landscape(tmp_path, dem_with(void), **WAYS[way])["elevation"].to_numpy()
    assert np.nanmin(got) >= 200.0
    assert np.isnan(got).any()


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("collar", [False, True])
@pytest.mark.parametrize("void", [0.0, -1.0, -99.0, -400.0, 50.0])
def test_a_void_that_could_be_ground_is_asked_about(tmp_path, void, collar, way):
    heights = dem_with(void, collar=collar)
    with pytest.raises(
        InputError, match=rf"is {void:g} m in \d+ cells .*--src-nodata dem={void:g} if it means no data"
    ):
        landscape(tmp_path, heights, **WAYS[way])
    got = landscape(tmp_path, heights, src_nodata=void, **WAYS[way])["elevation"].to_numpy()
    assert np.nanmin(got) >= 200.0
    assert np.isnan(got).any()
    kept = landscape(tmp_path, heights, src_nodata=float("nan"), **WAYS[way])["elevation"].to_numpy()
    assert np.isfinite(kept).all()
    assert kept.min() == pytest.approx(void, abs=1e-3)


@pytest.mark.parametrize("dtype", [np.int16, np.float32])
def test_the_void_is_named_in_the_numbers_of_the_file(tmp_path, dtype):
    heights = dem_with(-5, dtype=dtype, factor=0.3048)
    with pytest.raises(InputError, match=r"is -1\.524 m .*--src-nodata dem=-5 if"):
        landscape(tmp_path, heights, units="ft")
    assert np.nanmin(landscape(tmp_path, heights, units="ft", src_nodata=-5)["elevation"]) > 199.0


def test_a_hole_in_a_plain_and_a_collar_about_low_hills_are_asked_about(tmp_path):
    plain = np.full((ROWS, COLS), 500, np.float32)
    plain[20:30, 20:30] = 0
    hills = relief(ROWS, COLS) / 3 + 20
    hills[:9] = 0
    for heights in (plain, hills):
        with pytest.raises(InputError, match=r"is 0 m in .* cells"):
            landscape(tmp_path, heights)


def shores(seed=0):
    """Terrain that goes down to a sea of exactly 0, in several shapes."""
    heights = relief(ROWS, COLS, seed)
    yield "gentle", np.maximum(heights - 300, 0)
    steep = np.maximum(heights * 4 - 1500, 0)
    yield "steep", steep
    yield "whole metres", np.round(steep)
    yield "lake in a plain", np.where(heights < 300, 0, np.float32(1.5) + heights * 0.001)
    yield "pit", np.where(heights == heights.min(), heights.min() - 9, heights)
    yield "flat", np.zeros_like(heights)
    yield "noise", np.random.default_rng(seed).normal(0, 15, heights.shape)
    yield "steps", np.repeat(np.arange(COLS // 10) * 100.0, 10)[np.newaxis].repeat(ROWS, axis=0)


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("index", range(8))
def test_shores_lakes_and_pits_are_not_asked_about(tmp_path, seed, index):
    _, heights = list(shores(seed))[index]
    got = landscape(tmp_path, heights.astype(np.float32))
    assert np.isfinite(got["elevation"]).all()


# --- flags of a quantity


COVER = read_legend("tree_cover_density")
ALTERNATIVES = {"finer": 13.0, "coarser": 47.0, "as it is": 20.0}


def cover_grid(cell):
    n = int(COLS * 20 / cell) - 2
    return Grid((int(ROWS * 20 / cell) - 2, n), Affine(cell, 0, NORTH_WEST[0], 0, -cell, NORTH_WEST[1]), parse_crs(UTM))


def slow_quantity(values, cell, flags):
    """Twin for cells that hold several of the layer's: the commonest kind, else the mean of those without a flag."""
    grid = cover_grid(cell)
    expected = np.full(grid.shape, np.nan)
    rows = ((np.arange(ROWS) + 0.5) * 20 / cell).astype(int)
    cols = ((np.arange(COLS) + 0.5) * 20 / cell).astype(int)
    for r in range(grid.shape[0]):
        for c in range(grid.shape[1]):
            inside = values[np.ix_(rows == r, cols == c)].ravel()
            kinds = [0 if v not in flags else v for v in inside]
            counts = {kind: kinds.count(kind) for kind in kinds}
            best = min(counts, key=lambda kind: (-counts[kind], kind))
            expected[r, c] = best if best else inside[~np.isin(inside, flags)].mean()
    return expected


def covers(seed=5):
    rng = np.random.default_rng(seed)
    values = rng.integers(0, 101, (ROWS, COLS))
    values[10:25, 20:45] = 255
    values[rng.random(values.shape) < 0.1] = 254
    return values.astype(np.uint8)


@pytest.mark.parametrize("way", ALTERNATIVES)
def test_flags_are_never_mixed_with_the_quantity(tmp_path, way):
    header = read_header(write(tmp_path / "c.tif", covers()))
    got = align_quantity(header, cover_grid(ALTERNATIVES[way]), "density", Account(), COVER.flagged)
    assert set(np.unique(got[got > 100])) == {254, 255}
    assert not ((got > 100) & (got < 254)).any()


def test_averages_leave_flags_out_as_the_slow_twin_does(tmp_path):
    header = read_header(write(tmp_path / "c.tif", covers()))
    got = align_quantity(header, cover_grid(47.0), "density", Account(), COVER.flagged)
    np.testing.assert_allclose(got, slow_quantity(covers(), 47.0, [254, 255]), rtol=1e-6)


def aligned(tmp_path, cover, resolution=None):
    dem = write(tmp_path / "d.tif", relief(ROWS, COLS))
    vegetation = write(tmp_path / "v.tif", np.full((ROWS, COLS), 23, np.uint8))
    density = write(tmp_path / "c.tif", cover)
    legends = {"legend": "corine_grid", "density_legend": "tree_cover_density"}
    return read_landscape(dem, vegetation, density, resolution=resolution, **legends)


@pytest.mark.parametrize("resolution", ALTERNATIVES.values())
def test_no_data_of_a_cover_makes_no_dense_rim(tmp_path, resolution):
    cover = np.full((ROWS, COLS), 10, np.uint8)
    cover[20:40, 20:40] = 255
    got = aligned(tmp_path, cover, resolution=resolution)["density"].to_numpy()
    assert set(np.unique(got)) == {0, 1}


def test_flags_that_the_legend_does_not_list_are_refused_with_their_values(tmp_path):
    cover = np.full((ROWS, COLS), 80, np.uint8)
    cover[20:40, 20:40] = 200
    for resolution in ALTERNATIVES.values():
        with pytest.raises(LegendError, match=r"does not list: 200 to 200"):
            aligned(tmp_path, cover, resolution=resolution)


def test_a_fraction_with_flags_is_still_seen(tmp_path):
    cover = np.random.default_rng(0).random((ROWS, COLS)).astype(np.float32)
    cover[:9] = 255
    with pytest.raises(LegendError, match="looks like a fraction"):
        aligned(tmp_path, cover)


@pytest.mark.parametrize("flag", [0, 255])
def test_a_cover_of_nothing_is_asked_about(tmp_path, flag):
    cover = np.zeros((ROWS, COLS), np.uint8)
    cover[:5] = flag
    with pytest.raises(LegendError, match=r"band 1, density\) is 0 on all cells"):
        aligned(tmp_path, cover)
    cover[30, 30] = 1
    assert aligned(tmp_path, cover)["burnable"].any()


# --- class codes


def test_codes_computed_in_floating_point_are_whole(tmp_path):
    codes = np.full((ROWS, COLS), 2 + 1e-7)
    got = read_landscape(
        write(tmp_path / "d.tif", relief(ROWS, COLS)), write(tmp_path / "v.tif", codes), "normal", resolution=13.0
    )
    assert set(np.unique(got["vegetation"])) == {2}
    odd = write(tmp_path / "o.tif", np.full((ROWS, COLS), 2.0001))
    with pytest.raises(InputError, match=r"fractions such as 2\.0001 "):
        read_landscape(tmp_path / "d.tif", odd, "normal")


def test_corines_no_data_code_is_land_without_fuel(tmp_path):
    codes = np.full((ROWS, COLS), 23, np.int8)
    codes[:, :30] = 48
    got = read_landscape(
        write(tmp_path / "d.tif", relief(ROWS, COLS)),
        write(tmp_path / "v.tif", codes, nodata=-128, transform=square()),
        legend="corine_grid",
    )
    assert not got["burnable"][:, :30].any()
    assert got["burnable"][:, 30:].all()
