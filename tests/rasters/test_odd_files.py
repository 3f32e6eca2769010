"""Odd rasters of other projects' tests as each layer: the right answer, or the right refusal; never a crash or a hang.

The other layers are made to fit: on the grid of the odd file where it says where it lies, else those of the sample.
"""

import faulthandler
from dataclasses import dataclass, field

import numpy as np
import pytest
import rasterio
from affine import Affine
from pyproj import Transformer

from firebreak_gis.errors import CRSError, FirebreakError, GridError, InputError, LegendError
from firebreak_gis.grid import Grid
from firebreak_gis.landscape import read_landscape
from tests.places import ROOT, UTM, real, square, write

SAMPLE = {name: str(ROOT / f"sample_data/{name}.tif") for name in ("dem", "vegetation", "density")}
# The tests themselves open files that lie nowhere.
pytestmark = pytest.mark.filterwarnings("ignore::rasterio.errors.NotGeoreferencedWarning")
LOWEST_LAND = -500.0
LAYERS = ("dem", "vegetation", "density")


@dataclass(frozen=True)
class Refused:
    """An error of exactly this class whose message holds these words."""

    kind: type[FirebreakError]
    words: str
    named: bool = True  # the message gives the file's name


@dataclass(frozen=True)
class Right:
    """A landscape whose cells are those of the file; `copied` cell by cell, else resampled."""

    copied: bool = True
    options: dict = field(default_factory=dict)
    lowest: float | None = None  # elevations below are taken as sea bed, with a warning


PICTURE = Refused(InputError, "colour picture")
NOWHERE = Refused(GridError, "does not say where its cells lie (no transform)")
NO_CRS = Refused(CRSError, "has no coordinate reference system")
FRACTIONS = Refused(InputError, "holds fractions such as")
UNLISTED = Refused(LegendError, "does not list", named=False)
COLOURS = Refused(InputError, "has a colour table")
SEVERAL = Refused(InputError, "holds several rasters, choose one by its full name")
ELSEWHERE = Refused(InputError, "which is no file")
BANDS = Refused(InputError, "bands; choose one by its number")
ASKED = Refused(InputError, "looks like a void or a collar")
TOO_FEW = Refused(GridError, "only 2 x 2 cells", named=False)
TOO_WIDE = Refused(CRSError, "spans 350 degrees of longitude", named=False)


def of(dem, codes):
    return {"dem": dem, "vegetation": codes, "density": codes}


#: What becomes of each file: as any layer, or layer by layer.
ODD = {
    "fuzz__graydepth-invert-overflow-5a0aad5024cc4ff3.tiff": Refused(InputError, "cannot be read as a raster"),
    "imagetiff__12bit.cropped.rgb.tiff": PICTURE,
    "imagetiff__12bit.cropped.tiff": NOWHERE,
    "imagetiff__BigTIFF.tif": PICTURE,
    "imagetiff__BigTIFFLong.tif": PICTURE,
    "imagetiff__BigTIFFMotorola.tif": PICTURE,
    "imagetiff__cmyk-3c-32b-float.tiff": PICTURE,
    "imagetiff__gradient-1c-64b-float.tiff": NOWHERE,
    "imagetiff__gradient-3c-32b-float.tiff": PICTURE,
    "imagetiff__gradient-3c-64b.tiff": PICTURE,
    "imagetiff__int16.tif": NOWHERE,
    "imagetiff__int8.tif": NOWHERE,
    "imagetiff__palette-1c-4b.tiff": of(COLOURS, NOWHERE),
    "imagetiff__palette-1c-8b.tiff": of(COLOURS, NOWHERE),
    "imagetiff__predictor-3-rgb-f32.tif": PICTURE,
    "imagetiff__quad-tile.jpg.tiff": PICTURE,
    "imagetiff_geo__geo-5b.tif": BANDS,
    "lfs_pointer__dem.tif": Refused(InputError, "git lfs pull"),
    "libtiffpic__flower-minisblack-02.tif": NOWHERE,
    "libtiffpic__flower-minisblack-08.tif": NOWHERE,
    "libtiffpic__flower-minisblack-24.tif": NOWHERE,
    "libtiffpic__ycbcr-cat.tif": PICTURE,
    "odcgeo__au-3577-rotated.tif": of(Right(copied=False), FRACTIONS),
    "odcgeo__au-3577.tif": of(Right(), UNLISTED),
    "odcgeo__au-gcp.tif": Refused(GridError, "it only has ground control points: gdalwarp"),
    "rasterio__RGB.byte.gcp.vrt": ELSEWHERE,
    "rasterio__RGB.byte.rpc.vrt": ELSEWHERE,
    "rasterio__RGB.byte.tif.aux.xml": Refused(InputError, "is an XML or HTML text"),
    "rasterio__RGB2.byte.tif.msk": NOWHERE,
    "rasterio__RGBA.uint16.tif": PICTURE,
    "rasterio__alpha.tif": PICTURE,
    "rasterio__compdcs.vrt": ELSEWHERE,
    "rasterio__float32.tif": NO_CRS,
    "rasterio__float_nan.tif": NO_CRS,
    "rasterio__float_raster_with_extra_nodata.tif": of(Right(), FRACTIONS),
    "rasterio__float_raster_with_nodata.tif": of(Right(), FRACTIONS),
    "rasterio__rgb-byte-tenth.tif": PICTURE,
    "rasterio__rotated.tif": NO_CRS,
    "rasterio__test_esri_wkt.tif": TOO_FEW,
    "rasterio__white-gemini-iv.vrt": ELSEWHERE,
    "riotiler__201404_13SED190110_201404_0x1500m_CL_1_extmask.tif.msk": NOWHERE,
    "riotiler__clp.tif": of(ASKED, UNLISTED),
    "riotiler__cog_gradient.tif": TOO_WIDE,
    "riotiler__cog_rgb.tif": PICTURE,
    "riotiler__cog_uint8_rgb_mask.tif": PICTURE,
    "riotiler__cog_uint8_rgb_nodata.tif": PICTURE,
    "skimage__multipage.tif": SEVERAL,
    "skimage__multipage_rgb.tif": SEVERAL,
}

#: Following the advice of a refusal: file, layer, outcome with the options that follow it.
ADVISED = [
    *[("imagetiff_geo__geo-5b.tif", "dem", Right(options={"band": {"dem": n}})) for n in (1, 3, 5)],
    ("imagetiff_geo__geo-5b.tif", "vegetation", Right(options={"band": {"vegetation": 3}})),
    ("imagetiff_geo__geo-5b.tif", "density", Right(options={"band": {"density": 4}})),
    ("rasterio__rotated.tif", "dem", Right(copied=False, options={"src_crs": {"dem": UTM}})),
    ("rasterio__float32.tif", "dem", Refused(GridError, "only 2 x 3 cells", named=False)),
    ("rasterio__float_nan.tif", "dem", Refused(GridError, "only 2 x 3 cells", named=False)),
    ("odcgeo__au-3577.tif", "vegetation", Right(options={"legend": "own"})),
    ("odcgeo__au-3577.tif", "density", Right(options={"density_legend": "own"})),
]

#: Files that lie nowhere, put somewhere by a VRT as the advice says (`gdal_translate -a_srs -a_ullr`).
PLACED = {
    **{name: Right() for name, outcome in ODD.items() if outcome is NOWHERE},
    "imagetiff__gradient-1c-64b-float.tiff": Refused(GridError, "only 1 x 256 cells", named=False),
    "imagetiff__int16.tif": Right(lowest=LOWEST_LAND),
    # Masks of 0 and 255: as terrain they have cliffs all round.
    "rasterio__RGB2.byte.tif.msk": ASKED,
    "riotiler__201404_13SED190110_201404_0x1500m_CL_1_extmask.tif.msk": ASKED,
    "libtiffpic__flower-minisblack-24.tif": Refused(InputError, "has elevations from 526344 to 1.67772e+07 m"),
}


def profile(path):
    """Shape, CRS and transform of a file that lies somewhere, else None."""
    try:
        with rasterio.open(path) as file:
            placed = file.transform != Affine.identity()
            return (file.shape, file.crs, file.transform) if placed else None
    except rasterio.errors.RasterioError:
        return None


def companions(path, folder):
    """Elevation, vegetation and density that fit a file."""
    found = profile(path)
    if found is None:
        return dict(SAMPLE)
    shape, own, transform = found
    values = {"dem": np.full(shape, 100, "float32"), "vegetation": np.full(shape, 2, "uint8")}
    return {
        "density": "normal",
        **{n: str(write(folder / f"{n}.tif", v, crs=own or UTM, transform=transform)) for n, v in values.items()},
    }


def own_legend(path, layer, folder):
    """Legend of the codes that a file holds: shrubs, dense."""
    with rasterio.open(path) as file:
        codes = np.unique(file.read(1, masked=True).compressed())
    head, classes = ("code,density", "dense") if layer == "density" else ("code,vegetation,density", "shrubs,dense")
    target = folder / "own.csv"
    target.write_text("\n".join([head, *(f"{code},{classes}" for code in codes)]) + "\n")
    return str(target)


def check(path, layer, outcome, folder, layers, **options):
    faulthandler.dump_traceback_later(60, exit=True)
    try:
        if isinstance(outcome, Refused):
            with pytest.raises(FirebreakError) as caught:
                read_landscape(**{**layers, layer: str(path)}, max_memory=2 << 30, **options)
            assert type(caught.value) is outcome.kind
            assert caught.value.exit_code == 3
            assert outcome.words in str(caught.value)
            assert not outcome.named or str(path) in str(caught.value)
        else:
            found = read_landscape(**{**layers, layer: str(path)}, max_memory=2 << 30, **options)
            compare(path, layer, outcome, found, options)
    finally:
        faulthandler.cancel_dump_traceback_later()


def source(path, layer, options):
    """Values of a file with NaN for none, CRS, transform, read by plain rasterio."""
    with rasterio.open(path) as file:
        values = file.read(options.get("band", {}).get(layer, 1), masked=True)
        crs = file.crs or rasterio.crs.CRS.from_user_input(options["src_crs"][layer])
        return values.astype(float).filled(np.nan), crs, file.transform


def compare(path, layer, outcome, found, options):
    values, crs, transform = source(path, layer, options)
    grid = Grid.of(found["burnable"])
    if not outcome.copied:
        assert layer == "dem"
        between(found["elevation"].values, grid, values, crs, transform)
        return
    assert grid.shape == values.shape
    assert grid.transform.almost_equals(transform)
    assert grid.crs.equals(crs, ignore_axis_order=True) or grid.crs.to_proj4() == crs.to_proj4()
    if outcome.lowest is not None:
        below = values < outcome.lowest
        assert any(f"{below.sum()} cells" in text for text in found.attrs["warnings"]), found.attrs["warnings"]
        values = np.where(below, np.nan, values)
    if layer == "dem":
        np.testing.assert_array_equal(found["elevation"].values, values.astype(np.float32))
        np.testing.assert_array_equal(found["burnable"].values, np.isfinite(values))
        return
    wanted = {"vegetation": 2, "density": 3}[layer] if {"legend", "density_legend"} & set(options) else values
    np.testing.assert_array_equal(found[layer].values, np.where(np.isfinite(values), wanted, 0))


def between(elevation, grid, values, crs, transform):
    """Every elevation lies among those of the file round the same place, and few cells were lost."""
    rows, cols = np.indices(grid.shape)
    x, y = grid.transform * (cols + 0.5, rows + 0.5)
    col, row = ~transform * Transformer.from_crs(grid.crs, crs, always_xy=True).transform(x, y)
    row, col = np.floor(row).astype(int), np.floor(col).astype(int)
    wide = np.pad(values, 2, constant_values=np.nan)
    lowest, highest = np.full(grid.shape, np.inf), np.full(grid.shape, -np.inf)
    for down in (-1, 0, 1):
        for right in (-1, 0, 1):
            at = np.clip(row + down + 2, 0, wide.shape[0] - 1), np.clip(col + right + 2, 0, wide.shape[1] - 1)
            lowest, highest = np.fmin(lowest, wide[at]), np.fmax(highest, wide[at])
    known = np.isfinite(elevation)
    assert (elevation[known] >= lowest[known] - 1e-3).all()
    assert (elevation[known] <= highest[known] + 1e-3).all()
    here = wide[np.clip(row + 2, 0, wide.shape[0] - 1), np.clip(col + 2, 0, wide.shape[1] - 1)]
    assert known.sum() > 0.9 * np.isfinite(here).sum() > 0


@real
def test_every_file_has_its_row(shared_data):
    assert {p.name for p in (shared_data / "odd_tiffs").iterdir()} == set(ODD)


@real
@pytest.mark.parametrize("layer", LAYERS)
@pytest.mark.parametrize("name", ODD)
def test_an_odd_file_by_itself(name, layer, tmp_path, shared_data):
    path = shared_data / "odd_tiffs" / name
    outcome = ODD[name][layer] if isinstance(ODD[name], dict) else ODD[name]
    check(path, layer, outcome, tmp_path, companions(path, tmp_path))


@real
@pytest.mark.parametrize(
    ("name", "layer", "outcome"), ADVISED, ids=lambda value: value if isinstance(value, str) else ""
)
def test_the_advice_of_a_refusal_helps(name, layer, outcome, tmp_path, shared_data):
    path = shared_data / "odd_tiffs" / name
    options = {"src_crs": {"dem": UTM}} if isinstance(outcome, Refused) else dict(outcome.options)
    for key in ("legend", "density_legend"):
        if options.get(key) == "own":
            options[key] = own_legend(path, layer, tmp_path)
    check(path, layer, outcome, tmp_path, companions(path, tmp_path), **options)


@real
@pytest.mark.parametrize("name", PLACED)
def test_a_file_put_in_its_place(name, tmp_path, shared_data):
    path = shared_data / "odd_tiffs" / name
    with rasterio.open(path) as file:
        rows, cols, kind = *file.shape, {"int8": "Int8", "uint8": "Byte"}.get(file.dtypes[0], file.dtypes[0].title())
    placed = tmp_path / "placed.vrt"
    kind = kind.replace("Uint", "UInt")
    step = ", ".join(map(str, square().to_gdal()))
    placed.write_text(
        f'<VRTDataset rasterXSize="{cols}" rasterYSize="{rows}"><SRS>{UTM}</SRS><GeoTransform>{step}</GeoTransform>'
        f'<VRTRasterBand dataType="{kind}" band="1"><SimpleSource><SourceFilename>{path}</SourceFilename>'
        f"<SourceBand>1</SourceBand></SimpleSource></VRTRasterBand></VRTDataset>"
    )
    check(placed, "dem", PLACED[name], tmp_path, companions(placed, tmp_path))
