"""Points, lines and polygons of any file, reprojected; vector files that are whole and reproducible."""

import importlib.util
import time
import zipfile

import geopandas as gpd
import numpy as np
import pyogrio
import pytest
import shapely
from pyproj import Transformer

from firebreak_gis import vectors
from firebreak_gis.errors import CRSError, InputError, MissingComponentError, OutputError, VerificationError
from firebreak_gis.files.sources import filtered

UTM = "EPSG:32635"


def boxes(order=(2, 0, 1)):
    shapes = [shapely.box(5e5 + 100 * i, 4e6, 5e5 + 100 * i + 50, 4e6 + 40) for i in order]
    return gpd.GeoDataFrame({"priority": [1, 2, 3], "name": ["ä", "b", "ζώνη"]}, geometry=shapes, crs=UTM)


FORMATS = [".gpkg", ".geojson", ".json", ".fgb", ".zip"]


@pytest.mark.parametrize("suffix", FORMATS)
def test_what_is_written_reads_back_in_order(tmp_path, suffix):
    path = vectors.write_vector(tmp_path / f"breaks{suffix}", boxes())
    back = vectors.read_polygons(path, UTM)
    assert list(back["priority"]) == [1, 2, 3]
    assert list(back["name"]) == ["ä", "b", "ζώνη"]
    assert shapely.hausdorff_distance(back.geometry.array, boxes().geometry.array).max() < 1e-3
    assert [p.name for p in tmp_path.iterdir()] == [path.name]


@pytest.mark.parametrize("suffix", FORMATS)
def test_equal_data_give_equal_bytes(tmp_path, suffix):
    (tmp_path / "a").mkdir()
    one = vectors.write_vector(tmp_path / f"breaks{suffix}", boxes()).read_bytes()
    time.sleep(1.1)  # time stamps are kept by the second
    assert vectors.write_vector(tmp_path / "a" / f"breaks{suffix}", boxes()).read_bytes() == one


def test_geopackages_are_of_the_version_that_all_read(tmp_path):
    path = vectors.write_vector(tmp_path / "a.gpkg", boxes())
    assert int.from_bytes(path.read_bytes()[60:64], "big") == 10_200  # "user_version" of the format


def test_the_layer_is_named_after_the_file_or_as_asked(tmp_path):
    for layer, expected in ((None, "breaks"), ("zones", "zones")):
        path = vectors.write_vector(tmp_path / "breaks.gpkg", boxes(), layer=layer, overwrite=True)
        assert [row[0] for row in pyogrio.list_layers(path)] == [expected]


def test_geojson_is_in_longitude_and_latitude(tmp_path):
    path = vectors.write_vector(tmp_path / "a.geojson", boxes())
    west, south, east, north = pyogrio.read_info(path)["total_bounds"]
    assert 26.9 < west < east < 27.1
    assert 36.1 < south < north < 36.2


@pytest.mark.parametrize("suffix", FORMATS)
def test_no_features_are_written_too(tmp_path, suffix):
    path = vectors.write_vector(tmp_path / f"a{suffix}", boxes().iloc[:0])
    assert pyogrio.read_info(path, force_feature_count=True)["features"] == 0
    with pytest.raises(InputError, match="holds no"):
        vectors.read_polygons(path, UTM)


def test_parquet_says_what_is_missing_or_works(tmp_path):
    if importlib.util.find_spec("pyarrow") is None:
        with pytest.raises(MissingComponentError, match="pyarrow"):
            vectors.write_vector(tmp_path / "a.parquet", boxes())
        assert list(tmp_path.iterdir()) == []
    else:
        path = vectors.write_vector(tmp_path / "a.parquet", boxes())
        assert len(vectors.read_polygons(path, UTM)) == 3


def test_overwriting_and_unknown_extensions_are_refused(tmp_path):
    path = vectors.write_vector(tmp_path / "a.gpkg", boxes())
    before = path.read_bytes()
    with pytest.raises(OutputError, match="exists"):
        vectors.write_vector(path, boxes())
    with pytest.raises(OutputError, match="extension"):
        vectors.write_vector(tmp_path / "a.txt", boxes())
    with pytest.raises(CRSError):
        vectors.write_vector(tmp_path / "b.gpkg", boxes().set_crs(None, allow_override=True))
    (tmp_path / "a.gpkg-wal").touch()
    with pytest.raises(OutputError, match="open in another program"):
        vectors.write_vector(path, boxes(), overwrite=True)
    assert path.read_bytes() == before


def test_a_file_with_too_few_features_never_takes_its_place(tmp_path, monkeypatch):
    genuine = vectors._encoded
    monkeypatch.setattr(vectors, "_encoded", lambda gdf, *rest: genuine(gdf.iloc[1:], *rest))
    with pytest.raises(VerificationError, match="3 features were written, 2 read back"):
        vectors.write_vector(tmp_path / "a.gpkg", boxes())
    assert list(tmp_path.iterdir()) == []


def test_a_file_with_moved_features_never_takes_its_place(tmp_path, monkeypatch):
    genuine = vectors._encoded
    monkeypatch.setattr(
        vectors, "_encoded", lambda gdf, *rest: genuine(gdf.set_geometry(gdf.translate(0.0, 1e-6)), *rest)
    )
    with pytest.raises(VerificationError, match="do not read back"):
        vectors.write_vector(tmp_path / "a.gpkg", boxes())
    assert list(tmp_path.iterdir()) == []


def points_file(folder):
    """Two layers: points in degrees, multipoints in UTM; one without a geometry."""
    path = folder / "ignitions.gpkg"
    one = gpd.GeoDataFrame({"n": [1, 2]}, geometry=[shapely.Point(27.85, 36.15), None], crs=4326)
    two = gpd.GeoDataFrame(
        {"n": [3]}, geometry=[shapely.MultiPoint([(576_500, 4_001_000), (576_600, 4_001_100)])], crs=UTM
    )
    one.to_file(path, layer="villages")
    two.to_file(path, layer="roads")
    return path


def test_all_points_of_a_layer_are_read_and_reprojected(tmp_path):
    points = vectors.read_points(f"{points_file(tmp_path)}|layername=villages", UTM)
    assert list(points["n"]) == [1]
    assert points.crs == UTM
    x, y = Transformer.from_crs(4326, UTM, always_xy=True).transform(27.85, 36.15)
    np.testing.assert_allclose(points.get_coordinates(), [(x, y)])
    assert points.attrs["notes"] == ["1 features without a geometry were left out"]
    several = vectors.read_points(f"{tmp_path / 'ignitions.gpkg'}|layername=roads", UTM)
    assert list(several["n"]) == [3, 3]
    assert list(several.index) == [0, 1]
    np.testing.assert_allclose(several.get_coordinates(), [(576_500, 4_001_000), (576_600, 4_001_100)])


def test_frames_and_series_are_taken_and_not_changed():
    frame = gpd.GeoDataFrame({"n": [1]}, geometry=[shapely.Point(27.85, 36.15, 99.0)], crs=4326)
    before = frame.copy()
    for source in (frame, frame.geometry):
        points = vectors.read_points(source, UTM)
        assert not points.has_z.any()
        assert points.crs == UTM
    assert frame.equals(before)
    assert frame.crs == 4326


def test_lines_are_taken_apart_and_polygons_kept_whole():
    lines = gpd.GeoSeries([shapely.MultiLineString([[(0, 0), (9, 9)], [(5, 5), (6, 9)]])], crs=UTM)
    assert len(vectors.read_features(lines, UTM)) == 2
    areas = gpd.GeoSeries([shapely.MultiPolygon([shapely.box(0, 0, 1, 1), shapely.box(5, 5, 6, 6)])], crs=UTM)
    assert len(vectors.read_polygons(areas, UTM)) == 1


def test_self_crossing_polygons_are_repaired_and_told():
    bow = shapely.Polygon([(0, 0), (10, 10), (10, 0), (0, 10)])
    polygons = vectors.read_polygons(gpd.GeoSeries([bow, shapely.box(20, 20, 30, 30)], crs=UTM), UTM)
    assert polygons.is_valid.all()
    assert polygons.area.tolist() == [50, 100]
    assert "1 polygons crossed themselves" in polygons.attrs["notes"][0]


def refusals(folder):
    text = folder / "text.geojson"
    text.write_text("hello")
    cut = folder / "cut.gpkg"
    cut.write_bytes(vectors.write_vector(folder / "whole.gpkg", boxes()).read_bytes()[:30_000])
    table = folder / "table.csv"
    table.write_text("a,b\n1,2\n")
    lost = gpd.GeoSeries([shapely.Point(0, 0)])
    return [
        (folder / "missing.gpkg", InputError, "does not exist"),
        (text, InputError, "cannot be read"),
        (cut, InputError, "cannot be read"),
        (table, InputError, "a table needs the columns x and y, or lon and lat"),
        (boxes(), InputError, "holds Polygon, expected points only"),
        (lost, CRSError, "no coordinate reference system"),
        (gpd.GeoSeries([], crs=UTM), InputError, "holds no points"),
        (gpd.GeoSeries([None], crs=UTM), InputError, "holds no points"),
        (gpd.GeoSeries([shapely.Point(5e5, 4e6)], crs=4326), CRSError, "cannot describe"),
    ]


def test_each_unusable_source_gets_its_own_sentence(tmp_path):
    for source, error, match in refusals(tmp_path):
        with pytest.raises(error, match=match):
            vectors.read_points(source, UTM)


def test_a_flatgeobuf_cut_between_features_is_refused(tmp_path):
    path = vectors.write_vector(tmp_path / "whole.fgb", boxes())
    data, found = path.read_bytes(), set()
    cut = tmp_path / "cut.fgb"
    for size in range(len(data) // 4, len(data)):
        cut.write_bytes(data[:size])
        with pytest.raises(InputError) as caught:
            vectors.read_polygons(cut, UTM)
        found.add("expected; copy" in str(caught.value))
    assert found == {True, False}
    assert len(vectors.read_polygons(path, UTM)) == len(boxes())


def test_names_cut_in_the_middle_of_a_letter_are_read(tmp_path):
    """Shapefiles hold ten bytes of a name; "surface_m²" has eleven."""
    frame = boxes()[["priority", "geometry"]].rename(columns={"priority": "surface_mX"})
    frame.to_file(tmp_path / "scar.shp", engine="pyogrio")
    table = tmp_path / "scar.dbf"
    table.write_bytes(table.read_bytes().replace(b"surface_mX", b"surface_m\xc2"))
    with pytest.raises(UnicodeDecodeError):
        gpd.read_file(tmp_path / "scar.shp", engine="pyogrio")
    back = vectors.read_polygons(tmp_path / "scar.shp", UTM)
    assert list(back[back.columns[0]]) == [1, 2, 3]
    assert back.area.tolist() == [2000.0] * 3


def roads():
    """Three points, two of them on primary roads."""
    places = [shapely.Point(576_500 + 10 * i, 4_001_000) for i in range(3)]
    return gpd.GeoDataFrame({"highway": ["primary", "path", "primary"], "lanes": [2, 1, 4]}, geometry=places, crs=UTM)


def test_a_file_with_several_layers_asks_which(tmp_path):
    path = points_file(tmp_path)
    with pytest.raises(
        InputError, match=r"several layers: villages, roads; say which, e\.g\. '.*\|layername=villages'"
    ):
        vectors.read_points(path, UTM)
    with pytest.raises(InputError, match="has no layer 'rivers'; it has villages, roads"):
        vectors.read_points(f"{path}|layername=rivers", UTM)
    assert list(vectors.read_points(f"{path}|layerid=1", UTM)["n"]) == [3, 3]
    roads().iloc[:0].to_file(tmp_path / "one.gpkg", layer="empty")
    roads().to_file(tmp_path / "one.gpkg", layer="roads")
    assert len(vectors.read_points(tmp_path / "one.gpkg", UTM)) == 3  # the other holds nothing


def test_a_condition_filters_features(tmp_path):
    roads().to_file(tmp_path / "osm.gpkg", layer="roads")
    boxes().to_file(tmp_path / "osm.gpkg", layer="areas")
    name = f"{tmp_path / 'osm.gpkg'}|layername=roads|subset=\"highway\" = 'primary'"
    assert list(vectors.read_points(name, UTM)["lanes"]) == [2, 4]
    assert list(vectors.read_points(filtered(name, "lanes > 2"), UTM)["lanes"]) == [4]
    with pytest.raises(InputError, match="holds no points that the filter lets through"):
        vectors.read_points(filtered(name, "lanes > 9"), UTM)
    for wrong in ("width > 2", "lanes >", "lanes = 'a"):
        with pytest.raises(InputError, match=r"the filter .* does not work"):
            vectors.read_points(filtered(name, wrong), UTM)


@pytest.mark.parametrize("suffix", [".shp", ".tab", ".geojsonl", ".gdb", ".zip"])
def test_files_that_people_have_are_vectors(tmp_path, suffix):
    drivers = {".tab": "MapInfo File", ".geojsonl": "GeoJSONSeq", ".gdb": "OpenFileGDB"}
    place = tmp_path / f"a{'.shp' if suffix == '.zip' else suffix}"
    data = roads().to_crs(4326) if suffix == ".geojsonl" else roads()
    data.astype({"lanes": "int32"}).to_file(place, driver=drivers.get(suffix))
    if suffix == ".zip":
        with zipfile.ZipFile(tmp_path / "a.zip", "w") as archive:
            for part in tmp_path.glob("a.*"):
                if part.suffix != ".zip":
                    archive.write(part, f"a folder/{part.name}")
        place = tmp_path / "a.zip"
    assert vectors.is_vector(str(place))
    found = vectors.read_points(place, UTM)
    assert list(found["lanes"]) == [2, 1, 4]
    np.testing.assert_allclose(found.get_coordinates(), roads().get_coordinates(), atol=1e-3)
    assert len(vectors.read_points(filtered(str(place), "highway = 'primary'"), UTM)) == 2


def test_archives_with_several_files_ask_which_and_others_say_what_they_hold(tmp_path):
    for name in ("a", "b"):
        vectors.write_vector(tmp_path / f"{name}.gpkg", roads())
    with zipfile.ZipFile(tmp_path / "two.zip", "w") as archive:
        archive.write(tmp_path / "a.gpkg", "x/a.gpkg")
        archive.write(tmp_path / "b.gpkg", "x/b.gpkg")
    with pytest.raises(InputError, match=r"holds x/a\.gpkg, x/b\.gpkg; say which, e\.g\. '.*\|layername=a'"):
        vectors.read_points(tmp_path / "two.zip", UTM)
    assert len(vectors.read_points(f"{tmp_path / 'two.zip'}|layername=b", UTM)) == 3
    with zipfile.ZipFile(tmp_path / "r.zip", "w") as archive:
        archive.writestr("people.tif", b"II*")
    with pytest.raises(InputError, match=r"holds no vector file, but people\.tif; unpack it first"):
        vectors.read_points(tmp_path / "r.zip", UTM)
    (tmp_path / "bad.zip").write_bytes(b"PK no archive")
    with pytest.raises(InputError, match="cannot be read as an archive"):
        vectors.read_points(tmp_path / "bad.zip", UTM)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("x,y,n\n576500.5,4001000,3\n", (576_500.5, 4_001_000)),
        ("n;Easting;Northing\n3;576500,5;4001000\n", (576_500.5, 4_001_000)),
        ("n\tX\tY\n3\t576500.5\t4001000\n", (576_500.5, 4_001_000)),
        ("\N{ZERO WIDTH NO-BREAK SPACE}Longitude,latitude,n\n27.85,36.15,3\n", None),
        ("lat;lon;n\n36,15;27,85;3\n", None),
    ],
)
def test_tables_with_coordinates_are_points(tmp_path, text, expected):
    (tmp_path / "p.csv").write_text(text, encoding="utf-8")
    found = vectors.read_points(tmp_path / "p.csv", UTM)
    place = expected or Transformer.from_crs(4326, UTM, always_xy=True).transform(27.85, 36.15)
    np.testing.assert_allclose(found.get_coordinates(), [place])
    assert list(found["n"]) == [3]
    assert "were taken as EPSG:" in found.attrs["notes"][0]


def test_tables_that_are_unclear_are_refused(tmp_path):
    path = tmp_path / "p.csv"
    for text, told in (
        ("x,y\n27.85,36.15\n", "look like degrees"),
        ("x,y\n1,here\n", "no numbers in line 2"),
        ("x,y\n500000,4000000\n,\n", "no numbers in line 3"),
        ("lon,lat\n27.85,95\n", "cannot describe"),
    ):
        path.write_text(text)
        with pytest.raises(InputError, match=told):
            vectors.read_points(path, UTM)
    path.write_text("x,y\n500000,4000000\n")
    with pytest.raises(InputError, match="cannot be filtered"):
        vectors.read_points(f"{path}|subset=x > 1", UTM)


@pytest.mark.parametrize("encoding", ["ISO-8859-1", "cp1252", "UTF-8"])
@pytest.mark.parametrize("told", ["as written", "UTF-8", "nothing"])
def test_tables_of_shapefiles_in_any_encoding_are_read(tmp_path, encoding, told):
    """The code page stands in the .cpg, or in byte 29 of the .dbf, or nowhere, or wrongly."""
    frame = gpd.GeoDataFrame({"Größe": [7.0], "name": ["Straße"]}, geometry=[shapely.box(0, 0, 9, 9)], crs="EPSG:32635")
    path = tmp_path / "a.shp"
    frame.to_file(path, encoding=encoding)
    if told != "as written":
        path.with_suffix(".cpg").unlink(missing_ok=True)
        table = bytearray(path.with_suffix(".dbf").read_bytes())
        table[29] = 0
        path.with_suffix(".dbf").write_bytes(bytes(table))
    if told == "UTF-8":
        path.with_suffix(".cpg").write_text("UTF-8")
    found = vectors.read_polygons(path, "EPSG:32635")
    assert len(found) == 1
    if not (encoding == "UTF-8" and told == "nothing"):  # then nobody can know
        assert found["Größe"].tolist() == [7.0]
        assert found["name"].tolist() == ["Straße"]
