"""Formats and names of rasters: FlamMap landscapes, variables of netCDF, ASCII grids, virtual rasters, addresses."""

import numpy as np
import pytest
import rasterio
import rasterio.shutil
import xarray as xr

from firebreak_gis.errors import GridError, InputError, LegendError, ParameterError
from firebreak_gis.landscape import read_landscape
from firebreak_gis.rasters import file_of, read_header, read_raster
from firebreak_gis.rasters.naming import gdal_name, short_name
from tests.places import UTM, patches, relief, square, write

ROWS, COLS = 40, 33


def planes(fuel=165, bare=98):
    """The five bands of a landscape, int16: feet, degrees, degrees, fuel models, percent."""
    heights = (relief(ROWS, COLS) * 3).astype(np.int16)
    codes = np.where(patches(ROWS, COLS, [0, 1]) == 0, bare, fuel).astype(np.int16)
    cover = np.linspace(0, 100, ROWS * COLS).reshape(ROWS, COLS).astype(np.int16)
    bands = np.stack([heights, heights * 0, heights * 0 + 180, codes, cover])
    bands[:, :2, :3] = -9999
    return bands


def lcp(folder, bands, **more):
    source = write(folder / "source.tif", bands)
    options = {"ELEVATION_UNIT": "FEET", "LATITUDE": "36", **more}
    rasterio.shutil.copy(source, folder / "land.lcp", driver="LCP", **options)
    return folder / "land.lcp"


def test_a_flammap_landscape_is_all_three_layers(tmp_path):
    bands = planes()
    data = read_landscape(lcp(tmp_path, bands))
    hole = np.zeros((ROWS, COLS), bool)
    hole[:2, :3] = True
    np.testing.assert_allclose(data["elevation"], np.where(hole, np.nan, bands[0] * 0.3048), rtol=1e-6)
    np.testing.assert_array_equal(data["vegetation"], np.where((bands[3] == 165) & ~hole, 3, 0))
    expected = np.where(bands[4] < 40, 1, np.where(bands[4] < 70, 2, 3))
    np.testing.assert_array_equal(data["density"], np.where(data["vegetation"] > 0, expected, 0))
    assert data.attrs["legend"] == "scott_burgan_40"
    assert "canopy cover in band 5" in data.attrs["alignment"][0]
    alone = read_landscape(
        *[tmp_path / "land.lcp"] * 2, "normal", legend="scott_burgan_40", band={"dem": 1, "vegetation": 4}
    )
    np.testing.assert_array_equal(alone["vegetation"], data["vegetation"])


def test_the_legend_of_a_landscape_follows_its_codes_and_the_user_wins(tmp_path):
    path = lcp(tmp_path, planes(fuel=9))
    assert read_landscape(path).attrs["legend"] == "anderson_13"
    with pytest.raises(LegendError, match=r"scott_burgan_40 does not list: 9 "):
        read_landscape(path, legend="scott_burgan_40")


def test_a_landscape_as_geotiff_is_known_by_its_bands(tmp_path):
    path = named(tmp_path, planes(), ("US_ELEV2020", "US_SLPD2020", "US_ASP2020", "US_240FBFM40", "US_240CC"))
    assert read_landscape(path)["burnable"].sum() == read_landscape(lcp(tmp_path, planes()))["burnable"].sum()
    with pytest.raises(ParameterError, match="left out"):
        read_landscape(read_raster(path, band=1))


def named(folder, bands, names, name="land.tif"):
    path = write(folder / name, bands, nodata=-9999)
    with rasterio.open(path, "r+") as target:
        for band, text in enumerate(names, start=1):
            if text:
                target.set_band_description(band, text)
    return path


#: Names of the canopy cover in products of LANDFIRE over the years, and of what is none.
COVERS = [
    "US_240CC",
    "LF2024_CC_CONUS",
    "LF2022_CC_CONUS",
    "CC",
    "cc2020",
    "LC20_CC_200",
    "US_200CC_20",
    "Canopy Cover",
]
NO_COVERS = ["LF2024_FCCS_CONUS", "CCF", "LF2024_CH_CONUS", "US_240CBD", "ACCESS"]


@pytest.mark.parametrize("cover", COVERS + NO_COVERS)
def test_the_canopy_cover_is_known_by_its_name(tmp_path, cover):
    bands = planes()[[0, 3, 4]]
    data = read_landscape(named(tmp_path, bands, ("LF2020_Elev_CONUS", "LF2024_FBFM40_CONUS", cover)))
    told = " ".join(data.attrs["alignment"])
    assert ("canopy cover in band 3" in told) == (cover in COVERS)
    assert ("none of them is a canopy cover" in told) == (cover in NO_COVERS)
    assert f"3 {cover}" in told
    assert (set(np.unique(data["density"])) == {0, 1, 2, 3}) == (cover in COVERS)


@pytest.mark.parametrize(
    ("name", "fuel", "legend"),
    [
        ("US_240FBFM13", 2, "anderson_13"),
        ("LF2024_FBFM13_CONUS", 9, "anderson_13"),
        ("LF2024_FBFM40_CONUS", 165, "scott_burgan_40"),
        ("Fuel model", 8, "anderson_13"),
        ("Fuel model", 183, "scott_burgan_40"),
    ],
)
def test_the_legend_follows_the_name_of_the_band_or_its_codes(tmp_path, name, fuel, legend):
    path = named(tmp_path, planes(fuel=fuel)[[0, 3, 4]], ("Elevation", name, "CC"))
    assert read_landscape(path).attrs["legend"] == legend


def test_of_two_fuel_models_one_is_chosen(tmp_path):
    bands = np.concatenate([planes(), planes(fuel=9)[3:4]])
    path = named(tmp_path, bands, ("Elev", "", "", "LF2024_FBFM40_CONUS", "CC", "LF2024_FBFM13_CONUS"))
    with pytest.raises(InputError, match="choose bands"):
        read_landscape(path)
    assert read_landscape(path, legend="anderson_13")["burnable"].any()
    assert read_landscape(path, legend="scott_burgan_40")["burnable"].any()
    chosen = read_landscape(path, band={"vegetation": 6})
    assert chosen.attrs["legend"] == "anderson_13"
    assert "fuel models in band 6" in chosen.attrs["alignment"][0]


@pytest.mark.parametrize("n_bands", [5, 8])
@pytest.mark.parametrize("names", ["", "Band {}"])
def test_a_landscape_without_names_is_taken_in_the_order_of_flammap(tmp_path, n_bands, names):
    bands = np.concatenate([planes(), np.full((3, ROWS, COLS), 7, np.int16)])[:n_bands]
    data = read_landscape(named(tmp_path, bands, [names.format(i) for i in range(1, n_bands + 1)]))
    written = read_landscape(lcp(tmp_path, planes()))
    for layer in ("vegetation", "density"):
        np.testing.assert_array_equal(data[layer], written[layer])
    assert "taken in the order of FlamMap" in data.attrs["alignment"][1]


@pytest.mark.parametrize(("band", "what"), [(2, "slope"), (3, "aspect"), (4, "fuel models"), (5, "canopy cover")])
def test_bands_without_names_must_be_possible(tmp_path, band, what):
    bands = planes()
    bands[band - 1] = 450
    with pytest.raises(InputError, match=f"band {band} would be {what}, but its values go from 450 to 450"):
        read_landscape(write(tmp_path / "land.tif", bands, nodata=-9999))
    with pytest.raises(InputError, match="no FlamMap landscape"):
        read_landscape(write(tmp_path / "four.tif", bands[:4], nodata=-9999))


def test_a_landscape_without_canopy_is_asked_about_and_takes_a_word(tmp_path):
    bands = planes()
    bands[4] = 0
    path = lcp(tmp_path, bands)
    with pytest.raises(LegendError, match="is 0 on all cells: is it an empty band"):
        read_landscape(path)
    data = read_landscape(path, "sparse")
    assert set(np.unique(data["density"])) == {0, 1}
    assert "canopy cover in band" not in data.attrs["alignment"][0]


def test_landscapes_that_contradict_themselves_are_refused(tmp_path):
    with pytest.raises(GridError, match=r"in feet, its \.prj says metre"):
        read_landscape(lcp(tmp_path, planes(), LINEAR_UNIT="FEET"))
    with pytest.raises(LegendError, match="categories"):
        read_landscape(lcp(tmp_path, planes(), CANOPY_COV_UNIT="CATEGORIES"))


def test_variables_of_netcdf_by_name(tmp_path):
    heights = read_raster(write(tmp_path / "dem.tif", relief(ROWS, COLS)))
    heights.attrs.clear()
    codes = patches(ROWS, COLS, [1, 2, 3]).astype(np.int16)
    data = xr.Dataset({"height": heights, "fuel": (("y", "x"), codes)})
    for name in data.data_vars:
        data[name].attrs["grid_mapping"] = "spatial_ref"
    path = tmp_path / "all of it.nc"
    data.to_netcdf(path, engine="scipy")
    landscape = read_landscape(f"{path}:height", f"{path}:fuel", "dense")
    np.testing.assert_array_equal(landscape["elevation"], relief(ROWS, COLS))
    np.testing.assert_array_equal(landscape["vegetation"], codes)
    same = read_landscape(f'NETCDF:"{path}":height', f'NETCDF:"{path}":fuel', "dense")
    assert same.equals(landscape)
    with pytest.raises(InputError, match=r"several rasters.*all of it\.nc:"):
        read_header(path)
    with pytest.raises(InputError, match="cannot be read"):
        read_header(f"{path}:nothing")
    with pytest.raises(InputError, match="does not exist"):
        read_header(f"{tmp_path}/none.nc:height")


@pytest.mark.parametrize(
    ("name", "file", "gdal"),
    [
        ("a.nc:dem", "a.nc", 'NETCDF:"a.nc":dem'),
        (r"C:\my data\a.NC:dem", r"C:\my data\a.NC", 'NETCDF:"C:\\my data\\a.NC":dem'),
        ("/d/a.h5://grp/dem", "/d/a.h5", 'HDF5:"/d/a.h5"://grp/dem'),
        ('NETCDF:"/d/a.nc":dem', "/d/a.nc", 'NETCDF:"/d/a.nc":dem'),
        ("GTIFF_DIR:2:/d/a.tif", "/d/a.tif", "GTIFF_DIR:2:/d/a.tif"),
        ("C:\\a.tif", "C:\\a.tif", "C:\\a.tif"),
        ("plain.tif", "plain.tif", "plain.tif"),
    ],
)
def test_names_of_variables(name, file, gdal):
    assert (file_of(name), gdal_name(name)) == (file, gdal)
    if name.startswith("a.nc"):
        assert short_name(gdal) == name


def test_a_file_with_a_colon_in_its_name_is_a_file(tmp_path):
    path = write(tmp_path / "a.nc:b", relief(ROWS, COLS))
    np.testing.assert_array_equal(read_raster(path), relief(ROWS, COLS))


def test_ascii_grids_take_their_crs_from_the_prj_beside_them(tmp_path):
    source = write(tmp_path / "d.tif", relief(ROWS, COLS), nodata=-9999)
    rasterio.shutil.copy(source, tmp_path / "d.asc", driver="AAIGrid", DECIMAL_PRECISION=4)
    assert (tmp_path / "d.prj").is_file()
    np.testing.assert_allclose(read_raster(tmp_path / "d.asc"), relief(ROWS, COLS), atol=1e-3)
    assert read_header(tmp_path / "d.asc").crs.to_epsg() == 32635


def test_virtual_rasters_are_read_by_name_only_and_fetch_nothing(tmp_path):
    source = write(tmp_path / "d.tif", relief(ROWS, COLS))
    rasterio.shutil.copy(source, tmp_path / "d.vrt", driver="VRT")
    np.testing.assert_array_equal(read_raster(tmp_path / "d.vrt"), relief(ROWS, COLS))
    text = (tmp_path / "d.vrt").read_text()
    (tmp_path / "v.tif").write_text(text)
    with pytest.raises(InputError, match=r"name it \.vrt"):
        read_header(tmp_path / "v.tif")
    far = text.replace(">d.tif<", ">/vsicurl/https://example.org/d.tif<")
    assert far != text
    (tmp_path / "far.vrt").write_text(far)
    with pytest.raises(InputError, match="network or archive"):
        read_header(tmp_path / "far.vrt")


@pytest.mark.parametrize(
    "name",
    [
        "https://example.org/a.tif",
        "/vsizip/a.zip/a.tif",
        "s3://bucket/a.tif",
        "WMTS:x.xml",
        "PG:dbname=x",
        'NETCDF:"/vsicurl/https://example.org/a.nc":dem',
        "NETCDF:https://example.org/a.nc:dem",
    ],
)
def test_addresses_need_the_users_word(name):
    with pytest.raises(InputError, match="--remote"):
        read_header(name)


def test_an_archive_is_read_when_allowed(tmp_path):
    import zipfile

    path = write(tmp_path / "d.tif", relief(ROWS, COLS))
    with zipfile.ZipFile(tmp_path / "d.zip", "w") as archive:
        archive.write(path, "d.tif")
    inside = f"/vsizip/{tmp_path}/d.zip/d.tif"
    vegetation = write(tmp_path / "v.tif", patches(ROWS, COLS, [1, 2, 3]))
    data = read_landscape(inside, vegetation, "normal", remote=True)
    np.testing.assert_array_equal(data["elevation"], relief(ROWS, COLS))
    with pytest.raises(InputError, match="--remote"):
        read_landscape(inside, vegetation, "normal")


def test_several_nodata_values_of_a_layer(tmp_path):
    values = relief(ROWS, COLS).copy()
    values[0, 0], values[1, 1], values[2, 2] = -9999, 32767, np.nan
    dem = write(tmp_path / "d.tif", values, transform=square(), crs=UTM)
    vegetation = write(tmp_path / "v.tif", patches(ROWS, COLS, [1, 2, 3]))
    data = read_landscape(dem, vegetation, "normal", src_nodata={"dem": [-9999, 32767]})
    assert np.argwhere(~np.isfinite(data["elevation"].to_numpy())).tolist() == [[0, 0], [1, 1], [2, 2]]
