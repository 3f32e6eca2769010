"""Hypothesis over grids, CRS, transforms, types and "no data": what aligning must never change."""

import numpy as np
import pytest
from affine import Affine
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from firebreak_gis.grid import Grid
from firebreak_gis.landscape import read_landscape, read_landscape_folder, write_landscape
from tests.places import patches, relief, write

LAYERS = ("elevation", "vegetation", "density")
#: CRS: a place in it (x, y) and the length of 20 m in it.
PLACES = {
    "EPSG:32635": (586_440.0, 3_999_900.0, 20.0),  # UTM north
    "EPSG:32719": (301_250.5, 6_290_017.3, 20.0),  # UTM south
    "EPSG:25829": (520_000.0, 4_700_000.0, 20.0),  # UTM on ETRS89
    "EPSG:3035": (5_600_000.0, 1_480_000.0, 20.0),  # LAEA of Europe
    "EPSG:2227": (6_010_000.0, 2_110_000.0, 65.6),  # California 3, US survey feet
    "EPSG:4326": (27.96, 36.13, 0.0002),
    "EPSG:4258": (-8.4, 42.1, 0.0002),
}
TYPES = ("uint8", "int16", "uint16", "int32", "float32", "float64")
CODES = [0, 1, 2, 3]
#: Out of reach of hills and codes, and in every type.
DECLARED = 200


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("fuzz")


def settled(examples):
    return settings(max_examples=examples, deadline=None, derandomize=True, database=None)


@st.composite
def shapes(draw, low=26, high=48):
    rows = draw(st.integers(low, high))
    return rows, draw(st.integers(low, high).filter(lambda cols: cols != rows))


@st.composite
def transforms(draw, place, shape, kinds=("north-up", "south-up", "rotated", "oblong", "shifted")):
    """A transform whose raster has its middle near the place, whatever its kind."""
    x, y, cell = PLACES[place]
    kind = draw(st.sampled_from(kinds))
    cell *= draw(st.sampled_from([0.43, 1.0, 1.0, 1.7]))
    width, height = cell, cell * (draw(st.floats(1.01, 1.6)) if kind == "oblong" else 1.0)
    shift = [draw(st.floats(-0.49, 0.49)) * cell if kind == "shifted" else 0.0 for _ in range(2)]
    angle = draw(st.floats(-80, 80)) if kind == "rotated" else 0.0
    return (
        Affine.translation(x + shift[0], y + shift[1])
        @ Affine.rotation(angle)
        @ Affine.scale(width, height if kind == "south-up" else -height)
        @ Affine.translation(-shape[1] / 2, -shape[0] / 2)
    )


def stored(draw, values, holes):
    """Values in a drawn type with a drawn kind of "no data" in the holes; what `write` takes with it."""
    kind = draw(st.sampled_from(["declared", "sentinel", "nan", "none"]))
    dtype = draw(st.sampled_from(TYPES))
    if kind == "sentinel" and dtype in ("uint8", "uint16"):
        dtype = "int16"
    if kind == "nan" and dtype not in ("float32", "float64"):
        dtype = "float64"
    values = values.astype(dtype)
    if kind != "none":
        values[holes] = {"declared": DECLARED, "sentinel": -9999, "nan": np.nan}[kind]
    return values, {"declared": {"nodata": DECLARED}, "sentinel": {}, "nan": {"nodata": np.nan}, "none": {}}[kind]


@st.composite
def landscapes(draw, heights=None):
    """DEM, vegetation and density of one place, each with its own grid, type and "no data".

    Returns {layer: (values, words for `write`)} and what must be told of them.
    """
    place = draw(st.sampled_from(list(PLACES)))
    found, src_nodata = {}, {}
    for name in LAYERS:
        shape = draw(shapes())
        seed = draw(st.integers(0, 20))
        holes = np.random.default_rng(seed).random(shape) < 0.07
        if name == "elevation":
            values = relief(*shape, seed) % 150 if heights is None else np.full(shape, heights)
        else:
            values = patches(*shape, CODES[name == "density" :], seed=seed, size=draw(st.integers(1, 4)))
        values, more = stored(draw, values, holes)
        if name != "elevation" and values.dtype.kind != "u" and (values == -9999).any():
            src_nodata[name] = -9999
        found[name] = values, {**more, "crs": place, "transform": draw(transforms(place, shape))}
    return found, src_nodata


def lay(folder, landscape, layout=None, **more):
    """Write the layers as `layout` says (options of GeoTIFF) and read them."""
    found, src_nodata = landscape
    options = layout or {}
    paths = [write(folder / f"{name}.tif", values, **words, **options) for name, (values, words) in found.items()]
    return read_landscape(*paths, src_nodata=src_nodata, **more)


def valid(landscape, name):
    values, words = landscape[0][name]
    out = (values == -9999) | (values == words.get("nodata")) | np.isnan(values.astype(float))
    return values[~out].astype(float)


@settled(60)
@given(landscape=landscapes(), resolution=st.sampled_from([None, None, 13.0, 45.0]))
def test_aligning_the_aligned_is_the_identity(folder, landscape, resolution):
    """Read from arrays, and from the files that `align` writes."""
    once = lay(folder, landscape, resolution=resolution)
    again = read_landscape(*[once[name] for name in LAYERS])
    write_landscape(once, folder / "out", overwrite=True)
    assert read_landscape_folder(folder / "out").identical(once)
    from_files = read_landscape(*[folder / "out" / f"{name}.tif" for name in LAYERS])
    for result in (again, from_files):
        assert result.equals(once)
        assert Grid.of(result).matches(Grid.of(once))
        for name in LAYERS:
            assert f"{name}: copied cell by cell, its cells are those of the grid" in result.attrs["alignment"]


@settled(120)
@given(landscape=landscapes(), resolution=st.sampled_from([None, 9.0, 31.0, 45.0]))
def test_codes_and_heights_out_lie_within_those_in(folder, landscape, resolution):
    data = lay(folder, landscape, resolution=resolution)
    for name in LAYERS[1:]:
        assert set(np.unique(data[name])) <= {0, *valid(landscape, name)}
    heights = valid(landscape, "elevation").astype(np.float32)
    assert heights.min() <= float(data["elevation"].min()) <= float(data["elevation"].max()) <= heights.max()


@settled(50)
@given(data=st.data(), height=st.sampled_from([0, 1, 7, 99, 137]), resolution=st.sampled_from([None, 9.0, 31.0, 45.0]))
def test_a_level_dem_stays_level(folder, data, height, resolution):
    landscape = data.draw(landscapes(heights=height))
    elevation = lay(folder, landscape, resolution=resolution)["elevation"].to_numpy()
    assert set(np.unique(elevation[np.isfinite(elevation)])) == {np.float32(height)}


@settled(25)
@given(landscape=landscapes(), size=st.sampled_from([16, 32]), compress=st.sampled_from(["deflate", "lzw", "zstd"]))
def test_a_tiled_file_is_read_like_a_striped_one(folder, landscape, size, compress):
    tiled = {"tiled": True, "blockxsize": size, "blockysize": size, "compress": compress}
    one, other = lay(folder, landscape), lay(folder, landscape, tiled)
    assert one.identical(other)


@settled(80)
@given(landscape=landscapes(), resolution=st.sampled_from([None, 9.0, 31.0]), data=st.data())
def test_any_part_is_the_part_of_the_whole(folder, landscape, resolution, data):
    """Only the window of each layer is read for the part, and it gives the same cells."""
    whole = lay(folder, landscape, resolution=resolution)
    grid = Grid.of(whole)
    (row, rows), (col, cols) = (
        (first, data.draw(st.integers(3, size - first)))
        for size in grid.shape
        for first in [data.draw(st.integers(0, size - 3))]
    )
    cut = whole.isel(y=slice(row, row + rows), x=slice(col, col + cols))
    part = Grid((rows, cols), grid.transform @ Affine.translation(col, row), grid.crs)
    assume(bool(cut["burnable"].any()))
    result = lay(folder, landscape, like=part)
    for name in LAYERS:
        np.testing.assert_array_equal(result[name], cut[name])
