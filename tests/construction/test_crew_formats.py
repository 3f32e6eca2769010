"""Files for crews, opened by readers that did not write them: names, values, coordinates, layers, colours, refusals."""

from __future__ import annotations

import io
import json
import re
import sqlite3
import time
import zipfile
from pathlib import Path
from xml.etree import ElementTree as ET

import ezdxf
import geopandas as gpd
import gpxpy
import numpy as np
import pytest
import shapefile
import shapely
from click.testing import CliRunner
from pyproj import CRS, Transformer

from firebreak_gis import plan
from firebreak_gis.cli import firebreak
from firebreak_gis.construction.writing import (
    KINDS,
    LABELS,
    read_written,
    write_breaks,
    write_compartments,
    write_segments,
)
from firebreak_gis.errors import InputError, OutputError
from firebreak_gis.files import formats
from firebreak_gis.files.formats import FORMATS, gpx, kml
from firebreak_gis.files.formats.dxf import TEXT_HEIGHT
from firebreak_gis.files.formats.shapefile import field_names
from firebreak_gis.schema import COLUMNS
from firebreak_gis.vectors import write_layers, write_vector

WORDS = "Räumung <κοπή> & тест"
KML, GPX = f"{{{kml.NAMESPACE}}}", f"{{{gpx.NAMESPACE}}}"
TO_METRES = Transformer.from_crs("EPSG:4326", "EPSG:32635", always_xy=True)


@pytest.fixture(scope="module")
def made(make_landscape):
    """Layers by name: a text with all that XML minds, and columns that are nothing somewhere."""
    found = plan(make_landscape((22, 31), seed=4, relief=4.0), budget=0.2, treatments="default", n_runs=4)
    frames = {name: frame.copy() for name, frame in zip(("lines", "polygons"), found.segments, strict=True)}
    assert "treatment_yearly" in frames["lines"]
    for frame in frames.values():
        frame["treatment"] = [WORDS, None, *frame["treatment"][2:]]
        frame["mean_slope_deg"] = [np.nan, *frame["mean_slope_deg"][1:]]
        frame["remarks_of_the_north"] = frame["remarks_of_the_south"] = np.arange(len(frame)) / 7
    frames["compartments"] = found.compartments
    frames["breaks"] = found.polygons
    assert len(frames["lines"]) > 10
    return frames


def written(made, folder, suffix, name):
    path = folder / f"{name}{suffix}"
    if name in ("lines", "polygons"):
        write_segments(path, made["lines"], made["polygons"], what=name)
    else:
        {"compartments": write_compartments, "breaks": write_breaks}[name](path, made[name])
    return path


def corners(shape):
    """(n, 2) all corners of a shape, rings from their westernmost lowest corner on and one way round."""
    return shapely.get_coordinates(shapely.normalize(shape))


def compare(frame, shapes, columns, *, metres=1e-6, missing=()):
    """Shapes (in metres) and values by column, as the reader found them."""
    assert len(shapes) == len(frame)
    for shape, expected in zip(shapes, frame.geometry, strict=True):
        expected = shapely.normalize(expected)
        parts = [shape] if expected.geom_type.startswith("Multi") == shape.geom_type.startswith("Multi") else []
        found = parts[0] if parts else next(iter(shape.geoms))
        assert shapely.hausdorff_distance(found, expected) < metres
        assert len(corners(found)) == len(corners(expected))
    for name in frame.columns.drop(["geometry", *missing]):
        for found, expected in zip(columns[name], frame[name], strict=True):
            if expected is None or expected != expected:
                assert found is None or found != found, name
            elif isinstance(expected, str):
                assert found == expected
            else:
                assert float(found) == pytest.approx(float(expected), rel=1e-12, abs=1e-15), name


def in_metres(shape):
    return shapely.transform(shape, lambda xy: np.column_stack(TO_METRES.transform(*xy.T)))


every_layer = pytest.mark.parametrize("name", KINDS)


@every_layer
def test_geopackage_by_sqlite(made, tmp_path, name):
    path = written(made, tmp_path, ".gpkg", name)
    with sqlite3.connect(path) as base:
        base.row_factory = sqlite3.Row
        rows = base.execute(f'select * from "{name}"').fetchall()
        aliases = {
            r["column_name"]: r for r in base.execute("select * from gpkg_data_columns where table_name=?", [name])
        }
        extensions = base.execute("select extension_name from gpkg_extensions where table_name='gpkg_data_columns'")
        assert [r[0] for r in extensions] == ["gpkg_schema"]
        assert base.execute("pragma integrity_check").fetchone()[0] == "ok"
        assert base.execute("select srs_id from gpkg_contents where table_name=?", [name]).fetchone()[0] == 32635
    sizes = {0: 0, 1: 32}
    shapes = [shapely.from_wkb(r["geom"][8 + sizes[(r["geom"][3] >> 1) & 7] :]) for r in rows]
    compare(made[name], shapes, {c: [r[c] for r in rows] for c in made[name].columns.drop("geometry")})
    known = [c for c in made[name].columns if c in COLUMNS]
    assert set(aliases) == set(known)
    for column in known:
        assert aliases[column]["name"] == COLUMNS[column].alias
        assert aliases[column]["title"] == COLUMNS[column].text
        assert aliases[column]["description"] == (COLUMNS[column].unit or None)


def test_the_units_of_a_geopackage_stand_in_every_layer(made, tmp_path):
    write_segments(tmp_path / "s.gpkg", made["lines"], made["polygons"])
    with sqlite3.connect(tmp_path / "s.gpkg") as base:
        found = base.execute("select table_name, name from gpkg_data_columns where column_name='length_m'").fetchall()
    assert found == [("lines", "Length [m]"), ("polygons", "Length [m]")]


def by_pyshp(frame, reader):
    columns = {
        name: [record[short] for record in reader.records()] for name, short in field_names(frame.columns[:-1]).items()
    }
    return [shapely.geometry.shape(shape.__geo_interface__) for shape in reader.shapes()], columns


@every_layer
@pytest.mark.parametrize("suffix", [".shp", ".shp.zip"])
def test_shapefile_by_pyshp(made, tmp_path, name, suffix):
    frame = made[name].copy()
    frame = frame[[*frame.columns.drop("geometry"), "geometry"]]
    path = written(made, tmp_path, suffix, name)
    ends = ("cpg", "dbf", "prj", "shp", "shx")
    if suffix == ".shp":
        files = {end: (tmp_path / f"{name}.{end}").read_bytes() for end in ends}
        assert sorted(p.name for p in tmp_path.iterdir()) == [f"{name}.{end}" for end in ends]
    else:
        with zipfile.ZipFile(path) as archive:
            assert sorted(archive.namelist()) == [f"{name}.{end}" for end in ends]
            files = {end: archive.read(f"{name}.{end}") for end in ends}
    assert files["cpg"] == b"UTF-8"
    assert CRS(files["prj"].decode()).equals(CRS(32635), ignore_axis_order=True) or "UTM_Zone_35N" in str(files["prj"])
    parts = {end: io.BytesIO(files[end]) for end in ("shp", "shx", "dbf")}
    with shapefile.Reader(**parts, encoding="utf-8") as reader:
        names = [field.name for field in reader.fields if field.name != "DeletionFlag"]
        assert names == list(field_names(frame.columns.drop("geometry")).values())
        shapes, columns = by_pyshp(frame, reader)
        columns = {key: [None if v == "" else v for v in values] for key, values in columns.items()}
        compare(frame, shapes, columns)


@every_layer
def test_geojson_by_json(made, tmp_path, name):
    document = json.loads(written(made, tmp_path, ".geojson", name).read_text(encoding="utf-8"))
    assert document["type"] == "FeatureCollection"
    assert "crs" not in document  # RFC 7946, 4
    shapes = [shapely.geometry.shape(feature["geometry"]) for feature in document["features"]]
    for shape in shapes:
        for part in getattr(shape, "geoms", [shape]):
            if part.geom_type == "Polygon":  # RFC 7946, 3.1.6
                assert part.exterior.is_ccw
                assert not [hole for hole in part.interiors if hole.is_ccw]
    columns = {c: [f["properties"][c] for f in document["features"]] for c in made[name].columns.drop("geometry")}
    compare(made[name], [in_metres(shape) for shape in shapes], columns, metres=1e-3)


#: Order of elements in a placemark, of those that are written (OGC 07-147r2, AbstractFeatureType).
PLACEMARK = ["name", "description", "styleUrl", "ExtendedData", "LineString", "Polygon", "MultiGeometry"]


def kml_shape(element):
    tag = element.tag.removeprefix(KML)
    if tag == "MultiGeometry":
        parts = [kml_shape(part) for part in element]
        return (shapely.MultiPolygon if parts[0].geom_type == "Polygon" else shapely.MultiLineString)(parts)

    def ring(e):
        return [tuple(map(float, each.split(","))) for each in e.find(f".//{KML}coordinates").text.split()]

    if tag == "LineString":
        return shapely.LineString(ring(element))
    holes = [ring(hole) for hole in element.findall(f"{KML}innerBoundaryIs")]
    return shapely.Polygon(ring(element.find(f"{KML}outerBoundaryIs")), holes)


@every_layer
def test_kml_by_an_xml_parser(made, tmp_path, name):
    frame = made[name]
    root = ET.parse(written(made, tmp_path, ".kml", name)).getroot()
    (document,) = root
    assert (root.tag, document.tag) == (f"{KML}kml", f"{KML}Document")
    assert document.find(f"{KML}name").text == name
    marks = list(document.iter(f"{KML}Placemark"))
    styles = {style.get("id"): style.find(f"{KML}LineStyle/{KML}color").text for style in document.iter(f"{KML}Style")}
    shapes, values, used = [], [], set()
    for mark in marks:
        tags = [child.tag.removeprefix(KML) for child in mark]
        assert tags == sorted(tags, key=PLACEMARK.index)
        assert len(tags) == 5
        used.add(mark.find(f"{KML}styleUrl").text)
        shapes.append(kml_shape(mark[4]))
        values.append({data.get("name"): data.find(f"{KML}value").text for data in mark.iter(f"{KML}Data")})
    assert used == {f"#{key}" for key in styles}
    number = LABELS[name].number
    order = np.argsort([float(row[number]) for row in values])  # folders gather what one stage builds
    shapes, values = [shapes[i] for i in order], [values[i] for i in order]
    columns = {c: [row.get(c) for row in values] for c in frame.columns.drop("geometry")}
    compare(frame, [in_metres(shape) for shape in shapes], columns, metres=1e-3)
    first = marks[order[0]]
    assert first.find(f"{KML}name").text == f"{LABELS[name].word} {frame[number].iloc[0]}"
    told = first.find(f"{KML}description").text.split("<br/>")
    assert f"Area: {frame['area_ha'].iloc[0]:,.2f} ha" in told
    assert all(": " in line for line in told)
    if name == "lines":
        assert "Treatment: Räumung &lt;κοπή&gt; &amp; тест" in told
        folders = document.findall(f"{KML}Folder")
        assert [f.find(f"{KML}name").text for f in folders] == [f"Stage {s}" for s in frame["stage"].unique()]
        counts = [len(f.findall(f"{KML}Placemark")) for f in folders]
        assert counts == frame.groupby("stage").size().tolist()
        assert styles["colour0"] == "ff1f0067"  # #67001f, the other way round
        assert len(styles) == 5


def test_gpx_by_gpxpy(made, tmp_path):
    frame = made["lines"]
    path = written(made, tmp_path, ".gpx", "lines")
    text = path.read_text(encoding="utf-8")
    found = gpxpy.parse(text)
    assert (found.version, found.creator, found.name, found.time) == ("1.1", "firebreak_gis", "lines", None)
    assert (
        [t.name for t in found.tracks] == [f"Segment {n}" for n in frame["order"]] == [w.name for w in found.waypoints]
    )
    shapes = [
        shapely.MultiLineString([[(p.longitude, p.latitude) for p in part.points] for part in track.segments])
        for track in found.tracks
    ]
    compare(frame, [in_metres(s) for s in shapes], {}, metres=1e-3, missing=frame.columns.drop("geometry"))
    for row, track, point in zip(frame.itertuples(), found.tracks, found.waypoints, strict=True):
        assert track.comment == point.comment == f"Segment {row.order}, stage {row.stage}"
        assert f"Length {row.length_m:,.0f} m" in track.description.split("; ")
        assert f"Steepest slope of the ground {row.max_slope_deg:.1f} degrees" in point.description.split("; ")
        assert row.geometry.distance(in_metres(shapely.Point(point.longitude, point.latitude))) < 1e-3
    assert WORDS in found.tracks[0].description
    root = ET.fromstring(text)
    kinds = [child.tag.removeprefix(GPX) for child in root]
    assert kinds == ["metadata"] + ["wpt"] * len(frame) + ["trk"] * len(frame)  # the order of the schema
    assert {tuple(c.tag.removeprefix(GPX) for c in e) for e in root.iter(f"{GPX}wpt")} == {
        ("name", "cmt", "desc", "sym", "type")
    }
    for track in root.iter(f"{GPX}trk"):
        tags = [c.tag.removeprefix(GPX) for c in track]
        assert tags[:4] == ["name", "cmt", "desc", "type"]
        assert set(tags[4:]) == {"trkseg"}


@every_layer
def test_dxf_by_ezdxf(made, tmp_path, name):
    frame = made[name]
    path = written(made, tmp_path, ".dxf", name)
    document = ezdxf.readfile(path)
    audit = document.audit()
    assert (audit.errors, audit.fixes) == ([], [])
    assert f"metres in {CRS(32635).name}" in path.read_text("ascii") or "EPSG:32635" in path.read_text("ascii")
    space = document.modelspace()
    drawn = {
        tuple(sorted((round(v.dxf.location.x, 3), round(v.dxf.location.y, 3)) for v in line.vertices)): line
        for line in space.query("POLYLINE")
    }
    texts = {text.dxf.text: text for text in space.query("TEXT")}
    number, group = LABELS[name].number, LABELS[name].group
    assert sorted(texts, key=int) == [str(n) for n in frame[number]]
    seen = 0
    for row in frame.itertuples():
        for part in getattr(row.geometry, "geoms", [row.geometry]):
            for ring in [part] if part.geom_type == "LineString" else [part.exterior, *part.interiors]:
                points = list(ring.coords)[:-1] if part.geom_type == "Polygon" else list(ring.coords)
                line = drawn[tuple(sorted((round(x, 3), round(y, 3)) for x, y in points))]
                assert line.is_closed == (part.geom_type == "Polygon")
                expected = f"SEGMENT_STAGE_{row.stage}" if group else LABELS[name].word.upper()
                assert line.dxf.layer == expected
                seen += 1
        text = texts[str(getattr(row, number))]
        x, y, _ = text.dxf.insert
        assert row.geometry.distance(shapely.Point(x, y)) < 1e-3
        assert text.dxf.height == TEXT_HEIGHT
    assert seen == len(space.query("POLYLINE"))
    layers = {layer.dxf.name: layer.color for layer in document.layers}
    if group:
        colours = [layers[f"SEGMENT_STAGE_{s}"] for s in frame["stage"].unique()]
        assert colours == sorted(colours, key=[1, 30, 2, 4, 5].index)
        assert len(set(colours)) == 5


def test_every_column_that_is_written_has_a_text_a_unit_and_a_short_name(made):
    ours = {c for frame in made.values() for c in frame.columns} - {"geometry"}
    assert ours - set(COLUMNS) == {"remarks_of_the_north", "remarks_of_the_south"}, (
        "say in schema.COLUMNS what they are"
    )
    shorts = [column.short for column in COLUMNS.values()]
    assert len({short.lower() for short in shorts}) == len(shorts)
    for name, column in COLUMNS.items():
        assert column.text[0].isupper()
        assert column.short.isascii()
        assert 1 <= len(column.short) <= 10
        units = {"_kw_m": "kW/m", "_ha": "ha", "_deg": "degrees", "_m": "m", "hours": "h", "return_years": "years"}
        for ending, unit in units.items():
            if name.removesuffix("_low").removesuffix("_high").endswith(ending):
                assert column.unit == unit
                break
        else:
            assert column.unit == "", name
    assert field_names(made["lines"].columns[-3:]) != {}


def test_the_page_for_crews_lists_the_columns():
    page = (Path(__file__).parents[2] / "docs/howto/crews.md").read_text(encoding="utf-8")
    listed = re.findall(r"^\| `(\w+)` \| `(\w+)` \| (.*) \|$", page, re.MULTILINE)
    assert listed == [(name, column.short, column.alias) for name, column in COLUMNS.items()]


def test_short_names_are_unique_whatever_the_columns_are():
    names = [f"quantity_number_{k}" for k in range(120)] + ["Quantity_N", "größe über alles", "cost"]
    short = field_names(names)
    assert list(short) == names
    assert len({s.lower() for s in short.values()}) == len(names)
    assert all(len(s.encode()) <= 10 for s in short.values())
    assert short["cost"] == "cost"


SUFFIXES = [suffix for suffix in FORMATS if suffix != ".parquet"]


def test_equal_segments_give_equal_bytes(made, tmp_path):
    found = []
    for folder in (tmp_path / "a", tmp_path / "b"):
        folder.mkdir()
        for suffix in SUFFIXES:
            written(made, folder, suffix, "lines")
        found.append({p.name: p.read_bytes() for p in folder.iterdir()})
        time.sleep(1.1)  # time stamps are kept by the second, and some by two
    assert len(found[0]) == len(SUFFIXES) + 4
    assert found[0] == found[1]
    year = time.localtime().tm_year
    assert found[0]["lines.dbf"][1:4] == bytes([100, 1, 1]) != bytes([year - 1900, 1, 1])


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("name", ["lines", "compartments"])
def test_nothing_to_write_is_a_file_that_opens(made, tmp_path, suffix, name):
    if suffix == ".gpx" and name == "compartments":
        return
    empty = {key: frame.iloc[:0] for key, frame in made.items()}
    path = written(empty, tmp_path, suffix, name)
    if suffix in (".kml", ".gpx"):
        assert len(list(ET.parse(path).getroot().iter())) <= 4
    elif suffix == ".dxf":
        assert len(ezdxf.readfile(path).modelspace()) == 0
    elif suffix == ".shp":
        with shapefile.Reader(str(path)) as reader:
            assert len(reader) == 0
            assert reader.shapeTypeName == ("POLYLINE" if name == "lines" else "POLYGON")
    else:
        assert len(gpd.read_file(path, layer=name if suffix == ".gpkg" else None)) == 0


def test_what_a_format_cannot_hold_is_refused(made, tmp_path):
    lines, areas = made["lines"], made["breaks"]
    with pytest.raises(OutputError, match=r"cannot hold .*Polygon, which GPX does not know; lines can"):
        write_breaks(tmp_path / "b.gpx", areas)
    mixed = gpd.GeoDataFrame(geometry=[lines.geometry.iloc[0], areas.geometry.iloc[0]], crs=lines.crs)
    with pytest.raises(OutputError, match=r"one kind of geometry.*\.gpkg"):
        write_vector(tmp_path / "m.shp", mixed)
    with pytest.raises(OutputError, match="drawing in metres, got degrees"):
        write_vector(tmp_path / "d.dxf", lines.to_crs(4326))
    with pytest.raises(OutputError, match="at most 254 bytes, column treatment has one of 400"):
        write_vector(tmp_path / "t.shp", lines.assign(treatment="é" * 200))
    with pytest.raises(OutputError, match=r"only \.gpkg can hold"):
        write_layers(tmp_path / "l.kml", {"lines": lines, "polygons": areas})
    with pytest.raises(OutputError, match=r"did you mean \.geojson\?"):
        write_vector(tmp_path / "a.geojsn", lines)
    assert list(tmp_path.iterdir()) == []


def test_money_of_any_size_keeps_its_digits_in_a_shapefile(made, tmp_path):
    amounts = [1234567890123.25, 1e-9, 0.0, *([7.5] * (len(made["breaks"]) - 3))]
    frame = made["breaks"].assign(cost=amounts[: len(made["breaks"])])
    write_vector(tmp_path / "c.shp", frame)
    with shapefile.Reader(str(tmp_path / "c.shp")) as reader:
        assert [r["cost"] for r in reader.records()] == pytest.approx(frame["cost"].tolist(), rel=1e-12)


def test_a_shapefile_is_replaced_whole(made, tmp_path, monkeypatch):
    """A disk that fails at any of the moves leaves the five files of before; what indexes them goes with them."""
    path = written(made, tmp_path, ".shp", "breaks")
    (tmp_path / "breaks.qix").write_bytes(b"index of the old one")
    before = {p.name: p.read_bytes() for p in tmp_path.iterdir()}
    with pytest.raises(OutputError, match="exists"):
        write_breaks(path, made["breaks"])
    path.unlink()
    with pytest.raises(OutputError, match="exists"):  # the others are somebody's too
        write_breaks(path, made["breaks"])
    path.write_bytes(before["breaks.shp"])
    replace = type(path).replace
    for failing in range(5):
        moves = []

        def move(self, target, failing=failing, moves=moves):
            if str(target).endswith((".shp", ".dbf", ".shx", ".prj", ".cpg")):
                moves.append(target)
                if len(moves) == failing + 1:
                    raise OSError(5, "Input/output error")
            return replace(self, target)

        monkeypatch.setattr(type(path), "replace", move)
        with pytest.raises(OutputError, match="Input/output error"):
            write_vector(path, made["breaks"].iloc[:1], overwrite=True)
        monkeypatch.setattr(type(path), "replace", replace)
        assert {p.name: p.read_bytes() for p in tmp_path.iterdir()} == before
    write_vector(path, made["breaks"].iloc[:1], overwrite=True)
    assert sorted(p.suffix for p in tmp_path.iterdir()) == [".cpg", ".dbf", ".prj", ".shp", ".shx"]
    with shapefile.Reader(str(path)) as reader:
        assert len(reader) == 1


def call(*words):
    return CliRunner().invoke(firebreak, [str(word) for word in words])


def test_export_writes_what_a_plan_wrote(made, tmp_path):
    source = tmp_path / "segments.gpkg"
    write_segments(source, made["lines"], made["polygons"])
    write_compartments(tmp_path / "compartments.gpkg", made["compartments"])
    write_breaks(tmp_path / "breaks.gpkg", made["breaks"])
    for suffix in SUFFIXES:
        for name, what in (("lines", []), ("polygons", ["--what", "polygons"])):
            if (suffix, name) == (".gpx", "polygons"):
                continue
            target = tmp_path / f"{name}{suffix}"
            outcome = call("export", source, "-o", target, *what, "--json")
            assert outcome.exit_code == 0, outcome.output
            assert json.loads(outcome.stdout)["result"]["features"] == len(made[name])
            same = tmp_path / "again" / target.name
            same.parent.mkdir(exist_ok=True)
            write_segments(same, made["lines"], made["polygons"], what=name if what else None)
            if suffix in (".shp", ".dxf"):  # a line reads back as one of several parts, which others tell apart
                assert target.read_bytes() == same.read_bytes()
    assert set(read_written(tmp_path / "lines.gpkg")) == {"lines", "polygons"}
    assert set(read_written(tmp_path / "polygons.gpkg")) == {"polygons"}
    for name in ("compartments", "breaks"):
        assert call("export", tmp_path / f"{name}.gpkg", "-o", tmp_path / f"{name}.kml").exit_code == 0
        marks = list(ET.parse(tmp_path / f"{name}.kml").getroot().iter(f"{KML}Placemark"))
        assert len(marks) == len(made[name])


def test_export_says_what_it_cannot_do(made, tmp_path):
    source = tmp_path / "segments.gpkg"
    write_segments(source, made["lines"], made["polygons"])
    other = tmp_path / "roads.gpkg"
    write_vector(other, made["lines"])

    def refused(code, text, *words):
        outcome = call("export", *words)
        assert outcome.exit_code == code, outcome.output
        assert text in outcome.output

    refused(4, "--what lines", source, "-o", tmp_path / "s.gpx", "--what", "polygons")
    refused(4, "did you mean .dxf?", source, "-o", tmp_path / "s.dwg")
    refused(3, "none of the layers lines, polygons", other, "-o", tmp_path / "s.kml")
    refused(3, "does not exist", tmp_path / "no.gpkg", "-o", tmp_path / "s.kml")
    refused(4, "is the input", source, "-o", source, "--overwrite")
    write_breaks(tmp_path / "breaks.gpkg", made["breaks"])
    refused(3, "there are no lines, but breaks", tmp_path / "breaks.gpkg", "-o", tmp_path / "b.kml", "--what", "lines")
    (tmp_path / "broken.gpkg").write_bytes(source.read_bytes()[:5000])
    refused(3, "broken.gpkg", tmp_path / "broken.gpkg", "-o", tmp_path / "s.kml")
    with pytest.raises(InputError):
        read_written(tmp_path / "broken.gpkg")
    assert not list(tmp_path.glob("s.*"))


@pytest.mark.parametrize(
    ("suffix", "known", "expected"),
    [(".kmz", FORMATS, ".kml"), (".KLM", FORMATS, ".kml"), (".tiff", (".tif", ".csv"), ".tif"), (".x", FORMATS, "")],
)
def test_hints(suffix, known, expected):
    assert formats.hint(suffix, known) == (expected and f"; did you mean {expected}?")
