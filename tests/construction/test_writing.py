"""Segments and compartments as they go to the field: files of several layers, styles, the command."""

from __future__ import annotations

import sqlite3
from xml.etree import ElementTree as ET

import geopandas as gpd
import numpy as np
import pyogrio
import pytest
from click.testing import CliRunner

from firebreak_gis import rank, select_breaks, spread_network, write_raster
from firebreak_gis.cli import firebreak
from firebreak_gis.construction.compartments import compartments_of
from firebreak_gis.construction.segments import segments_of
from firebreak_gis.construction.writing import write_compartments, write_segments
from firebreak_gis.errors import CRSError, OutputError
from firebreak_gis.planning.pipeline import plan
from firebreak_gis.schema import COLUMNS
from firebreak_gis.styles.vectors import class_edges, graduated
from firebreak_gis.vectors import write_layers


@pytest.fixture(scope="module")
def network(make_landscape):
    return spread_network(make_landscape((22, 31), seed=4, relief=4.0))


@pytest.fixture(scope="module")
def priority(network):
    return rank(network, "dissection")


@pytest.fixture(scope="module")
def breaks(network, priority):
    return select_breaks(priority, budget=0.2, burnable=network.burnable)


def styles(path):
    """Style by layer, as another program finds it."""
    with sqlite3.connect(path) as file:
        rows = file.execute("select f_table_name, styleQML, useAsDefault, f_geometry_column from layer_styles")
        return {name: (ET.fromstring(text), default, column) for name, text, default, column in rows}


def test_layers_of_one_file(network, breaks, tmp_path):
    lines, polygons = segments_of(network, breaks)
    write_segments(tmp_path / "s.gpkg", lines, polygons)
    assert [row[0] for row in pyogrio.list_layers(tmp_path / "s.gpkg")] == ["lines", "polygons", "layer_styles"]
    for name, frame in (("lines", lines), ("polygons", polygons)):
        back = gpd.read_file(tmp_path / "s.gpkg", layer=name)
        assert back.geometry.geom_equals(frame.geometry).all()
        for column in frame.columns.drop("geometry"):
            np.testing.assert_array_equal(back[column], frame[column])
    first = (tmp_path / "s.gpkg").read_bytes()
    write_segments(tmp_path / "s.gpkg", lines, polygons, overwrite=True)
    assert (tmp_path / "s.gpkg").read_bytes() == first
    with pytest.raises(OutputError, match="exists"):
        write_segments(tmp_path / "s.gpkg", lines, polygons)
    with pytest.raises(OutputError, match=r"only \.gpkg"):
        write_layers(tmp_path / "s.fgb", {"lines": lines})
    with pytest.raises(CRSError, match="layer lines"):
        write_layers(tmp_path / "t.gpkg", {"lines": lines.set_crs(None, allow_override=True)})
    assert [p.name for p in tmp_path.iterdir()] == ["s.gpkg"]


def test_styles_lie_in_the_file(network, breaks, tmp_path):
    write_segments(tmp_path / "s.gpkg", *segments_of(network, breaks))
    found = styles(tmp_path / "s.gpkg")
    assert set(found) == {"lines", "polygons"}
    lines, polygons = segments_of(network, breaks)
    for name, frame in (("lines", lines), ("polygons", polygons)):
        root, default, column = found[name]
        assert default
        assert column == "geom"
        ranges = root.findall("renderer-v2/ranges/range")
        edges = [(float(r.get("lower")), float(r.get("upper"))) for r in ranges]
        for stage in frame["stage"]:
            assert any(low <= stage <= high for low, high in edges)
        names = {s.get("name") for s in root.findall("renderer-v2/symbols/symbol")}
        assert {r.get("symbol") for r in ranges} == names
        assert root.find("renderer-v2").get("attr") == "stage"
        aliases = {a.get("field"): (int(a.get("index")), a.get("name")) for a in root.findall("aliases/alias")}
        # GDAL puts its own number before the columns.
        assert aliases == {
            c: (k, COLUMNS[c].alias) for k, c in enumerate(frame.columns.drop("geometry"), 1) if c in COLUMNS
        }
    assert found["lines"][0].find("labeling/settings/text-style").get("fieldName") == "order"
    write_compartments(tmp_path / "c.gpkg", compartments_of(network, breaks)[1])
    assert styles(tmp_path / "c.gpkg")["compartments"][0].find("renderer-v2").get("attr") == "expected_loss"


@pytest.mark.parametrize("values", [[], [np.nan], [3], [3, 3, 3], [1, 2], [1, 1, 1, 9], list(range(100))])
def test_classes_cover_all_values(values):
    edges = class_edges(np.array(values, float))
    assert len(edges) >= 2
    assert (np.diff(edges) > 0).all()
    known = [v for v in values if v == v]
    assert all(edges[0] <= v <= edges[-1] for v in known)
    style = graduated(np.array(values, float), column="a&b", symbol="fill", colours=["#000000", "#ffffff"])
    root = ET.fromstring(style)
    assert root.find("renderer-v2").get("attr") == "a&b"
    assert root.get("labelsEnabled") == "0"
    assert len(root.findall("renderer-v2/symbols/symbol")) == len(edges) - 1


def test_nothing_to_build(network, tmp_path):
    nothing = np.zeros(network.shape)
    write_segments(tmp_path / "s.gpkg", *segments_of(network, nothing))
    assert len(gpd.read_file(tmp_path / "s.gpkg", layer="lines")) == 0
    _, table = compartments_of(network, nothing)
    write_compartments(tmp_path / "c.gpkg", table)
    assert len(gpd.read_file(tmp_path / "c.gpkg", layer="compartments")) == len(table)
    kinds = dict(pyogrio.list_layers(tmp_path / "s.gpkg").tolist())
    assert (kinds["lines"], kinds["polygons"]) == ("LineString", "MultiPolygon"), "QGIS would see tables"


def test_the_command_writes_what_a_plan_writes(make_landscape, tmp_path):
    """Given the same network, breaks, terrain, costs and values."""
    landscape = make_landscape((22, 31), seed=4, relief=4.0)
    shape = landscape["burnable"].shape
    value = np.random.default_rng(1).random(shape)
    made = plan(landscape, budget=0.2, value=value, line_width="cells", n_runs=5)
    grid = made.network.grid
    write_raster(tmp_path / "network.tif", made.network.to_raster())
    for name, data in (("breaks", made.breaks), ("priority", made.priority), ("dem", landscape["elevation"])):
        write_raster(tmp_path / f"{name}.tif", data)
    write_raster(tmp_path / "value.tif", grid.dataarray(value, "elevation"))
    words = [
        "segments",
        "network.tif",
        "breaks.tif",
        "--priority",
        "priority.tif",
        "--dem",
        "dem.tif",
        "--values",
        "value.tif",
        "-o",
        "s.gpkg",
        "--compartments",
        "c.gpkg",
        "--json",
    ]
    words = [str(tmp_path / word) if "." in word else word for word in words]
    outcome = CliRunner().invoke(firebreak, words)
    assert outcome.exit_code == 0, outcome.output
    for name, frame in zip(("lines", "polygons"), made.segments, strict=True):
        back = gpd.read_file(tmp_path / "s.gpkg", layer=name)
        assert back.geometry.geom_equals(frame.geometry).all()
        for column in frame.columns.drop("geometry"):
            np.testing.assert_allclose(back[column], frame[column], rtol=1e-5, err_msg=column)
    back = gpd.read_file(tmp_path / "c.gpkg", layer="compartments")
    assert "burnt_value" in made.compartments.columns
    np.testing.assert_allclose(back["expected_loss"], made.compartments["expected_loss"], rtol=1e-5)
    assert CliRunner().invoke(firebreak, words).exit_code == 4
    words[words.index(str(tmp_path / "s.gpkg"))] = str(tmp_path / "value.tif")
    assert CliRunner().invoke(firebreak, [*words, "--overwrite"]).exit_code == 4
