"""Every algorithm on real layers in a real QGIS; the outputs are those of the command line."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from conftest import QUICK, ROOT, cells, firebreak
from osgeo import gdal, ogr
from qgis import processing
from qgis.core import (
    QgsApplication,
    QgsCoordinateReferenceSystem,
    QgsFeature,
    QgsGeometry,
    QgsProcessingException,
    QgsProcessingFeatureSourceDefinition,
    QgsProcessingFeedback,
    QgsProcessingModelAlgorithm,
    QgsProcessingParameterDefinition,
    QgsProject,
    QgsRasterLayer,
    QgsVectorLayer,
)

#: Algorithms whose help shows a map or a curve.
PICTURED = {"align", "network", "rank", "breaks", "segments", "plan", "burn", "evaluate", "compare"}

pytestmark = pytest.mark.usefixtures("provider")


def features(path: object, layer: str | int = 0) -> list:
    # A data source has to outlive its layers.
    source = ogr.Open(str(path))
    return sorted(feature.ExportToJson() for feature in source.GetLayer(layer))


def run(name: str, **parameters):
    return processing.run(f"firebreak:{name}", parameters)


class Told(QgsProcessingFeedback):
    """Keeps what an algorithm says."""

    def __init__(self):
        super().__init__(False)
        self.texts, self.steps = [], []
        self.progressChanged.connect(self.steps.append)

    def pushInfo(self, info):  # noqa: N802
        self.texts.append(info)

    def pushWarning(self, warning):  # noqa: N802
        self.texts.append(f"Warning: {warning}")


def test_align(layers, reference, tmp_path):
    outputs = {f"OUTPUT_{n.upper()}": str(tmp_path / f"{n}.tif") for n in ("elevation", "vegetation", "density")}
    outputs["OUTPUT_RUN"] = str(tmp_path / "account.json")
    found = run("align", **layers, RESOLUTION=QUICK["RESOLUTION"], **outputs)
    for name in ("elevation", "vegetation", "density"):
        assert cells(found[f"OUTPUT_{name.upper()}"]) == cells(reference / "landscape" / f"{name}.tif")
        assert (tmp_path / f"{name}.qml").is_file()
    assert "alignment" in Path(found["OUTPUT_RUN"]).read_text(encoding="utf-8")


def test_network_of_raw_layers(layers, reference, tmp_path):
    found = run(
        "network",
        **layers,
        RESOLUTION=QUICK["RESOLUTION"],
        WIND_SPEED=8,
        WIND_FROM=315,
        OUTPUT_NETWORK=str(tmp_path / "n.tif"),
    )
    assert cells(found["OUTPUT_NETWORK"]) == cells(reference / "network.tif")
    assert found["BURNABLE_CELLS"] > 1000


def test_network_of_aligned_layers(reference, tmp_path):
    aligned = {
        f"INPUT_{name}": str(reference / "landscape" / f"{file}.tif")
        for name, file in (("DEM", "elevation"), ("VEGETATION", "vegetation"), ("DENSITY", "density"))
    }
    found = run("network", **aligned, WIND_SPEED=8, WIND_FROM=315, OUTPUT_NETWORK=str(tmp_path / "n.tif"))
    assert cells(found["OUTPUT_NETWORK"]) == cells(reference / "network.tif")


def test_rank(reference, tmp_path):
    found = run(
        "rank",
        INPUT_NETWORK=str(reference / "network.tif"),
        METHOD="bonacich",
        METHOD_PARAMS="beta=0.3",
        OUTPUT_PRIORITY=str(tmp_path / "p.tif"),
    )
    assert cells(found["OUTPUT_PRIORITY"]) == cells(reference / "priority.tif")


def test_breaks(reference, tmp_path):
    found = run(
        "breaks",
        INPUT_PRIORITY=str(reference / "priority.tif"),
        BUDGET=0.08,
        OUTPUT_BREAKS=str(tmp_path / "b.tif"),
        OUTPUT_BREAK_POLYGONS=str(tmp_path / "b.gpkg"),
    )
    assert cells(found["OUTPUT_BREAKS"]) == cells(reference / "breaks.tif")
    assert features(found["OUTPUT_BREAK_POLYGONS"]) == features(reference / "breaks.gpkg")
    assert found["CELLS_CUT"] == sum(map(sum, ([v == 1 for v in row] for row in cells(reference / "breaks.tif")[0])))


def test_burn(data, reference, tmp_path):
    found = run(
        "burn",
        INPUT_NETWORK=str(reference / "network.tif"),
        INPUT_BREAKS=str(reference / "breaks.tif"),
        INPUT_IGNITIONS=str(data / "ignitions.gpkg"),
        N_RUNS=QUICK["N_RUNS"],
        OUTPUT_FREQUENCY=str(tmp_path / "f.tif"),
        OUTPUT_FIRE_SIZES=str(tmp_path / "s.csv"),
    )
    assert cells(found["OUTPUT_FREQUENCY"]) == cells(reference / "burn_frequency.tif")
    assert Path(found["OUTPUT_FIRE_SIZES"]).read_bytes() == (reference / "sizes.csv").read_bytes()
    assert 0 < found["MEAN_BURNT_SHARE"] <= found["MAX_BURNT_SHARE"] <= 1


def test_assess(reference, tmp_path):
    """Each connected piece of the breaks is judged; one gap and no other places keep it short."""
    few = ("--runs", QUICK["N_RUNS"], "--placements", 0, "--most-gaps", 1)
    firebreak("assess", *few, "-o", tmp_path / "own", reference / "network.tif", reference / "breaks.tif")
    found = run(
        "assess",
        INPUT_NETWORK=str(reference / "network.tif"),
        INPUT_BREAKS=str(reference / "breaks.tif"),
        N_RUNS=QUICK["N_RUNS"],
        PLACEMENTS=0,
        MOST_GAPS=1,
        OUTPUT_ASSESSMENT=str(tmp_path / "a.gpkg"),
        OUTPUT_BREAK_WORTH=str(tmp_path / "b.csv"),
        OUTPUT_SUMMARY=str(tmp_path / "s.txt"),
    )
    assert features(found["OUTPUT_ASSESSMENT"]) == features(tmp_path / "own" / "assessment.gpkg") != []
    assert Path(found["OUTPUT_BREAK_WORTH"]).read_bytes() == (tmp_path / "own" / "break_worth.csv").read_bytes()
    assert Path(found["OUTPUT_SUMMARY"]).read_text(encoding="utf-8").strip()


def test_evaluate(reference, tmp_path):
    found = run(
        "evaluate",
        INPUT_NETWORK=str(reference / "network.tif"),
        METHODS=["degree", "random"],
        BUDGETS="0,0.1,0.2",
        N_RUNS=QUICK["N_RUNS"],
        OUTPUT_EVALUATION=str(tmp_path / "e.csv"),
        OUTPUT_FIGURE=str(tmp_path / "e.png"),
        OUTPUT_FIGURE_SVG=str(tmp_path / "e.svg"),
    )
    kept = reference / "evaluation" / "evaluation.csv"
    assert Path(found["OUTPUT_EVALUATION"]).read_bytes() == kept.read_bytes()
    assert Path(found["OUTPUT_FIGURE"]).read_bytes()[:4] == b"\x89PNG"
    assert "<svg" in Path(found["OUTPUT_FIGURE_SVG"]).read_text(encoding="utf-8")


def test_compare(reference, tmp_path):
    found = run(
        "compare",
        INPUT_NETWORK=str(reference / "network.tif"),
        METHODS=["degree", "random"],
        BUDGETS="0.05,0.1",
        RESIDUALS="0,0.1",
        N_RUNS=QUICK["N_RUNS"],
        OUTPUT_COMPARISON=str(tmp_path / "c.csv"),
        OUTPUT_FIGURE=str(tmp_path / "c.png"),
    )
    kept = reference / "comparison" / "comparison.csv"
    assert Path(found["OUTPUT_COMPARISON"]).read_bytes() == kept.read_bytes()
    assert Path(found["OUTPUT_FIGURE"]).read_bytes()[:4] == b"\x89PNG"


def test_segments(layers, reference, tmp_path):
    given = {
        name: str(reference / f"{file}.tif")
        for name, file in (("INPUT_NETWORK", "network"), ("INPUT_BREAKS", "breaks"), ("INPUT_PRIORITY", "priority"))
    }
    found = run(
        "segments",
        **given,
        INPUT_DEM=layers["INPUT_DEM"],
        OUTPUT_SEGMENTS=str(tmp_path / "s.gpkg"),
        OUTPUT_COMPARTMENTS=str(tmp_path / "c.gpkg"),
    )
    for layer in ("lines", "polygons"):
        assert features(found["OUTPUT_SEGMENTS"], layer) == features(reference / "segments.gpkg", layer)
    assert features(found["OUTPUT_COMPARTMENTS"]) == features(reference / "compartments.gpkg")
    assert found["SEGMENTS"] == len(features(reference / "segments.gpkg", "polygons")) > 0


def test_siting(layers, data, reference, tmp_path):
    roads = str(data / "roads.gpkg")
    firebreak(
        "siting", "--roads", roads, "--siting-param", "ridge=0.8", "-o", tmp_path / "c.tif", reference / "landscape"
    )
    found = run(
        "siting",
        **layers,
        RESOLUTION=QUICK["RESOLUTION"],
        INPUT_ROADS=roads,
        SITING_PARAMS="ridge=0.8",
        OUTPUT_SUITABILITY=str(tmp_path / "s.tif"),
    )
    assert cells(found["OUTPUT_SUITABILITY"]) == cells(tmp_path / "c.tif")
    assert 0 < found["MEAN_SUITABILITY"] < 1


def test_delineate(layers, data, reference, tmp_path):
    roads = str(data / "roads.gpkg")
    own = tmp_path / "own"
    firebreak("delineate", "--size", "300ha", "--roads", roads, "--runs", 10, "-o", own, reference / "landscape")
    found = run(
        "delineate",
        **layers,
        **QUICK,
        SIZE_HA="300ha",
        INPUT_ROADS=roads,
        OUTPUT_PODS=str(tmp_path / "p.gpkg"),
    )
    for layer in ("pods", "borders"):
        assert features(found["OUTPUT_PODS"], layer) == features(own / "pods.gpkg", layer) != []
    assert found["COMPARTMENTS"] == len(features(own / "pods.gpkg", "pods")) > 1
    assert 0 < found["BORDER_SUITABILITY"] <= 1
    assert found["KM"] > 0


def test_validate(layers, data, reference, tmp_path):
    scar, start = str(data / "villages.gpkg"), str(data / "ignitions.gpkg")
    runs = ("--runs", QUICK["N_RUNS"], "--start", start, "--duration", "2h", "--wind-speed", 5)
    firebreak("validate", *runs, "-o", tmp_path / "own", reference / "landscape", scar)
    found = run(
        "validate",
        **layers,
        **QUICK,
        INPUT_SCAR=scar,
        INPUT_START=start,
        DURATION="2h",
        WIND_SPEED=5,
        OUTPUT_SCORES=str(tmp_path / "s.csv"),
        OUTPUT_FREQUENCY=str(tmp_path / "f.tif"),
        OUTPUT_FOLDER=str(tmp_path / "all"),
    )
    assert cells(found["OUTPUT_FREQUENCY"]) == cells(tmp_path / "own" / "burn_frequency.tif")
    assert Path(found["OUTPUT_SCORES"]).read_bytes() == (tmp_path / "own" / "scores.csv").read_bytes()
    own = {path.name for path in (tmp_path / "own").iterdir() if not path.name.startswith(".")}
    assert {path.name for path in (tmp_path / "all").iterdir()} == own


def test_calibrate(layers, reference, tmp_path):
    sizes = tmp_path / "sizes.csv"
    days = [(3, 1), (8, 1), (15, 1), (40, 2), (90, 2), (200, 3), (30, 1), (60, 2), (12, 1), (150, 3)]
    lines = [f"{ha},2020-07-{1 + i:02d},2020-07-{i + n:02d}" for i, (ha, n) in enumerate(days)]
    sizes.write_text("\n".join(["ha,first,last", *lines]) + "\n", encoding="utf-8")
    columns = {"size_column": "ha", "first_day_column": "first", "last_day_column": "last"}
    words = [word for name, column in columns.items() for word in (f"--{name.replace('_', '-')}", column)]
    runs = ("--weather", "rose:NW=5x1", "--runs", QUICK["N_RUNS"], "--fit", "duration", "--least", 1)
    firebreak("calibrate", *runs, *words, "-o", tmp_path / "own.toml", reference / "landscape", sizes)
    found = run(
        "calibrate",
        **layers,
        **QUICK,
        FIRES_FILE=str(sizes),
        WEATHER="rose:NW=5x1",
        FIT="duration",
        LEAST=1,
        **{name.upper(): column for name, column in columns.items()},
        OUTPUT_CALIBRATION=str(tmp_path / "c.toml"),
    )

    def numbers(path):
        return re.findall(r"^(?!#).*=.*$", Path(path).read_text(encoding="utf-8"), re.MULTILINE)

    assert numbers(found["OUTPUT_CALIBRATION"]) == numbers(tmp_path / "own.toml") != []


def test_files_for_crews(layers, tmp_path):
    """The map book of a plan, and its segments in the formats of crews, by the ending of the destination."""
    folder = tmp_path / "plan"
    processing.run("firebreak:plan", {**layers, **QUICK, "METHOD": "compartments", "OUTPUT_FOLDER": str(folder)})
    book = run("mapbook", RUN_FOLDER=str(folder), PAGES=2, TITLE="Two pages", OUTPUT_MAPBOOK=str(tmp_path / "book.pdf"))
    assert Path(book["OUTPUT_MAPBOOK"]).read_bytes().startswith(b"%PDF")
    assert book["SEGMENTS_WITH_PAGE"] == 2 <= book["SEGMENTS"]
    segments = folder / "segments.gpkg"
    for ending in ("kml", "gpx", "dxf", "geojson"):
        found = run("export", MADE=str(segments), OUTPUT_CREWS=str(tmp_path / f"crew.{ending}"))
        own = tmp_path / f"crews.{ending}"  # a KML document has the name of its file
        firebreak("export", segments, "-o", own)
        assert Path(found["OUTPUT_CREWS"]).read_bytes() == own.read_bytes(), ending
        assert found["FEATURES"] == book["SEGMENTS"]
    with pytest.raises(QgsProcessingException, match=r"is written as \.kml, but crew\.shp"):
        run("export", MADE=str(segments), OUTPUT_CREWS=str(tmp_path / "crew.shp"))


def test_a_folder_of_all_files_and_its_report(layers, tmp_path):
    folder = tmp_path / "all files"
    told = Told()
    made = processing.run(
        "firebreak:plan",
        {
            **layers,
            **QUICK,
            "METHOD": "degree",
            "OUTPUT_FOLDER": str(folder),
            "OUTPUT_REPORT": str(tmp_path / "first.html"),
        },
        feedback=told,
    )
    assert {"breaks.tif", "segments.gpkg", "report.html", "run.json", "breaks.qml"} <= {
        p.name for p in folder.iterdir()
    }
    assert any("first.html" in text and "Results Viewer" in text for text in told.texts)
    found = run("report", RUN_FOLDER=str(folder), OUTPUT_REPORT=str(folder / "anew.html"))
    firebreak("report", "-o", folder / "own.html", folder)
    assert Path(found["OUTPUT_REPORT"]).read_bytes() == (folder / "own.html").read_bytes()
    assert Path(made["OUTPUT_REPORT"]).is_file()
    kinds = {
        o.name(): o.type()
        for o in QgsApplication.processingRegistry().algorithmById("firebreak:plan").outputDefinitions()
    }
    assert kinds["OUTPUT_REPORT"] == "outputHtml", "so the Results Viewer opens it"


@pytest.mark.parametrize("ending", ["geojson", "fgb", "shp"])
def test_vector_outputs_in_the_format_chosen(ending, reference, tmp_path):
    found = run(
        "breaks",
        INPUT_PRIORITY=str(reference / "priority.tif"),
        BUDGET=0.08,
        OUTPUT_BREAKS=str(tmp_path / "b.tif"),
        OUTPUT_BREAK_POLYGONS=str(tmp_path / "new" / f"b.{ending}"),
    )
    usual, layer = (
        QgsVectorLayer(str(path), "x", "ogr") for path in (reference / "breaks.gpkg", found["OUTPUT_BREAK_POLYGONS"])
    )
    assert layer.isValid()
    assert layer.crs() == usual.crs()
    areas = [sorted(round(f.geometry().area()) for f in one.getFeatures()) for one in (usual, layer)]
    assert areas[0] == areas[1] != []


def test_every_algorithm_has_a_test(provider):
    """Which are those that run it and compare with the command line."""
    text = Path(__file__).read_text(encoding="utf-8")
    called = set(re.findall(r'\brun\(\s*"(\w+)"', text)) | set(re.findall(r'"firebreak:(\w+)",\s*{', text))
    assert {a.name() for a in provider.algorithms()} <= called


def test_every_name_of_qgis_exists():
    """Dotted names of the plugin's code that start with a class of QGIS or Qt, looked up in this release."""
    import ast

    from qgis import core, gui
    from qgis.PyQt import QtCore, QtGui, QtWidgets

    places = {"qgis.core": core, "qgis.gui": gui}
    places |= {f"qgis.PyQt.{m.__name__.rpartition('.')[2]}": m for m in (QtCore, QtGui, QtWidgets)}
    seen = 0
    for path in (ROOT / "qgis_plugin" / "firebreak").rglob("*.py"):
        tree, known = ast.parse(path.read_text(encoding="utf-8")), {}
        for node in ast.walk(tree):
            if isinstance(node, ast.ImportFrom) and node.module in places:
                known |= {alias.name: getattr(places[node.module], alias.name) for alias in node.names}
        for node in ast.walk(tree):
            names, inner = [], node
            while isinstance(inner, ast.Attribute):
                names.insert(0, inner.attr)
                inner = inner.value
            if names and isinstance(inner, ast.Name) and inner.id in known:
                value = known[inner.id]
                for name in names:
                    assert hasattr(value, name), f"{path.name}: {inner.id}.{'.'.join(names)}"
                    value = getattr(value, name)
                    seen += 1
    assert seen > 20


def test_plan(data, layers, reference, tmp_path):
    told = Told()
    outputs = {
        "PRIORITY": "priority.tif",
        "BREAKS": "breaks.tif",
        "FREQUENCY": "burn_frequency.tif",
        "FREQUENCY_WITH_BREAKS": "burn_frequency_with_breaks.tif",
        "ELEVATION": "elevation.tif",
        "VEGETATION": "vegetation.tif",
        "DENSITY": "density.tif",
    }
    paths = {f"OUTPUT_{name}": str(tmp_path / "sub" / f"my {file}") for name, file in outputs.items()}
    files = {
        "OUTPUT_BREAK_POLYGONS": str(tmp_path / "p.gpkg"),
        "OUTPUT_FIRE_SIZES": str(tmp_path / "s.csv"),
        "OUTPUT_EVALUATION": str(tmp_path / "e.csv"),
        "OUTPUT_OVERVIEW": str(tmp_path / "o.png"),
    }
    found = processing.run(
        "firebreak:plan",
        {**layers, **QUICK, **paths, **files, "METHOD": "degree", "INPUT_IGNITIONS": str(data / "ignitions.gpkg")},
        feedback=told,
    )
    for name, file in outputs.items():
        assert cells(found[f"OUTPUT_{name}"]) == cells(reference / "plan" / file), name
    assert features(found["OUTPUT_BREAK_POLYGONS"]) == features(reference / "plan" / "breaks.gpkg")
    for name, file in (("FIRE_SIZES", "fire_sizes.csv"), ("EVALUATION", "evaluation.csv")):
        assert Path(found[f"OUTPUT_{name}"]).read_bytes() == (reference / "plan" / file).read_bytes()
    assert found["BURNT_SHARE_WITH_BREAKS"] <= found["BURNT_SHARE_WITHOUT_BREAKS"]
    assert told.steps == sorted(told.steps)
    assert len({round(step) for step in told.steps}) > 10
    assert any("resampled" in text for text in told.texts)


# --- layers as users have them --------------------------------------------------------------------------------


def points(data: Path) -> QgsVectorLayer:
    return QgsVectorLayer(str(data / "ignitions.gpkg"), "points", "ogr")


def burnt(reference: Path, tmp_path: Path, ignitions: object) -> list:
    found = run(
        "burn",
        INPUT_NETWORK=str(reference / "network.tif"),
        INPUT_IGNITIONS=ignitions,
        N_RUNS=4,
        OUTPUT_FREQUENCY=str(tmp_path / "f.tif"),
    )
    return cells(found["OUTPUT_FREQUENCY"])[0]


def test_memory_layers_and_selections(data, reference, tmp_path):
    """A memory layer of one point, and that point selected in its file, burn alike; all points do not."""
    layer = points(data)
    chosen = next(iter(layer.getFeatures()))
    memory = QgsVectorLayer("Point?crs=" + layer.crs().authid(), "memory", "memory")
    copy = QgsFeature()
    copy.setGeometry(QgsGeometry(chosen.geometry()))
    memory.dataProvider().addFeatures([copy])
    layer.selectByIds([chosen.id()])
    QgsProject.instance().addMapLayers([layer, memory])
    try:
        selected = burnt(
            reference, tmp_path, QgsProcessingFeatureSourceDefinition(layer.id(), selectedFeaturesOnly=True)
        )
        assert selected == burnt(reference, tmp_path, memory)
        assert selected != burnt(reference, tmp_path, layer)
    finally:
        QgsProject.instance().clear()


def test_a_crs_set_in_qgis_counts(data, layers, tmp_path):
    """The file has no CRS, the user has set it on the layer; the engine sees the layer's."""
    naked = tmp_path / "naked.tif"
    gdal.Translate(str(naked), layers["INPUT_DEM"])
    file = gdal.Open(str(naked), gdal.GA_Update)
    file.SetProjection("")
    del file
    layer = QgsRasterLayer(str(naked), "dem")
    layer.setCrs(QgsCoordinateReferenceSystem("EPSG:4326"))
    # QGIS 3.22 never frees an exception from an algorithm, nor the frames below it: the project must own the layer.
    QgsProject.instance().addMapLayer(layer)
    same = {**layers, "RESOLUTION": QUICK["RESOLUTION"]}
    given = {**same, "INPUT_DEM": layer.id()}
    try:
        found = run("align", **given, OUTPUT_ELEVATION=str(tmp_path / "a.tif"))
        usual = run("align", **same, OUTPUT_ELEVATION=str(tmp_path / "b.tif"))
        assert cells(found["OUTPUT_ELEVATION"]) == cells(usual["OUTPUT_ELEVATION"])
        layer.setCrs(QgsCoordinateReferenceSystem())
        with pytest.raises(QgsProcessingException, match=r"coordinate reference system|CRS"):
            run("align", **given, OUTPUT_ELEVATION=str(tmp_path / "c.tif"))
    finally:
        QgsProject.instance().clear()


def test_extent_crs_and_density_word(layers, tmp_path):
    given = {k: v for k, v in layers.items() if k != "INPUT_DENSITY"}
    box = "586000,590000,4003000,4007000 [EPSG:32635]"
    found = run(
        "align",
        **given,
        DENSITY="dense",
        BOUNDS=box,
        CRS="EPSG:32635",
        RESOLUTION=100,
        OUTPUT_ELEVATION=str(tmp_path / "e.tif"),
        OUTPUT_DENSITY=str(tmp_path / "d.tif"),
    )
    values, transform, _, _ = cells(found["OUTPUT_ELEVATION"])
    assert (len(values), len(values[0]), transform[0], transform[3]) == (40, 40, 586000, 4007000)
    assert {v for row in cells(found["OUTPUT_DENSITY"])[0] for v in row} <= {0, 3, 255}
    with pytest.raises(QgsProcessingException, match="needs the CRS"):
        run("align", **given, DENSITY="dense", BOUNDS=box, OUTPUT_ELEVATION=str(tmp_path / "x.tif"))


def test_what_a_planner_adds(data, reference, tmp_path):
    """Polygons with a field, and areas, are those of the command line."""
    villages, roads = str(data / "villages.gpkg"), str(data / "roads.gpkg")
    firebreak(
        "rank",
        "--method",
        "degree",
        "--protected",
        villages,
        "--barriers",
        roads,
        "--values",
        villages,
        "--values-field",
        "people",
        "-o",
        tmp_path / "cli.tif",
        reference / "network.tif",
    )
    given = {"INPUT_NETWORK": str(reference / "network.tif"), "METHOD": "degree", "INPUT_BARRIERS": roads}
    found = run(
        "rank",
        **given,
        INPUT_PROTECTED=villages,
        INPUT_VALUES=villages,
        VALUES_FIELD="people",
        OUTPUT_PRIORITY=str(tmp_path / "p.tif"),
    )
    assert cells(found["OUTPUT_PRIORITY"]) == cells(tmp_path / "cli.tif")
    plain = run("rank", **given, OUTPUT_PRIORITY=str(tmp_path / "q.tif"))
    assert cells(plain["OUTPUT_PRIORITY"]) != cells(found["OUTPUT_PRIORITY"])


def test_cost_by_classes(layers, tmp_path):
    words = "agricultural=500,shrubs=900,pines=1500"
    runs = [
        run(
            "plan",
            **layers,
            **QUICK,
            METHOD="degree",
            BUDGET=20000,
            BUDGET_UNIT="cost",
            COST=cost,
            OUTPUT_BREAKS=str(tmp_path / f"{i}.tif"),
        )["CELLS_CUT"]
        for i, cost in enumerate((words, words.replace("500", "250")))
    ]
    assert 0 < runs[0] < runs[1]


def test_a_raster_in_the_memory_of_qgis(layers, reference, tmp_path):
    """The engine cannot see it, so it gets a copy."""
    memory = "/vsimem/dem.tif"
    gdal.Translate(memory, layers["INPUT_DEM"])
    layer = QgsProject.instance().addMapLayer(QgsRasterLayer(memory, "dem"))
    try:
        found = run(
            "align",
            **{**layers, "INPUT_DEM": layer.id()},
            RESOLUTION=QUICK["RESOLUTION"],
            OUTPUT_ELEVATION=str(tmp_path / "e.tif"),
        )
    finally:
        QgsProject.instance().clear()
        gdal.Unlink(memory)
    assert cells(found["OUTPUT_ELEVATION"]) == cells(reference / "landscape" / "elevation.tif")


# --- refusals and stops ---------------------------------------------------------------------------------------


def test_refusals_are_told_in_the_engines_words(layers, tmp_path):
    with pytest.raises(QgsProcessingException, match=r"(?is)budget.*1\.5|1\.5.*budget"):
        run("plan", **layers, **QUICK, BUDGET=1.5, OUTPUT_BREAKS=str(tmp_path / "b.tif"))
    assert list(tmp_path.iterdir()) == []


def test_an_input_is_never_overwritten(reference):
    with pytest.raises(QgsProcessingException, match="overwrite an input"):
        run("breaks", INPUT_PRIORITY=str(reference / "priority.tif"), OUTPUT_BREAKS=str(reference / "priority.tif"))


def test_cancel(layers, tmp_path):
    import time

    told, asked = Told(), []
    told.progressChanged.connect(lambda percent: (asked.append(time.monotonic()), told.cancel()) if percent > 15 else 0)
    found = processing.run(
        "firebreak:plan",
        {**layers, "METHOD": "betweenness", "N_RUNS": 5000, "OUTPUT_BREAKS": str(tmp_path / "b.tif")},
        feedback=told,
    )
    assert time.monotonic() - asked[0] < 1.5  # a second, and the end of the Processing framework
    assert "OUTPUT_BREAKS" not in found or not Path(found["OUTPUT_BREAKS"]).exists()
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("script", "words"),
    [
        (None, "no such file"),
        ('echo \'{"software": "firebreak_gis", "version": "0.0.9"}\'', "0.0.9 is too old"),
        ("echo it hurts >&2; exit 7", "broken .*it hurts"),
    ],
    ids=["missing", "too old", "broken"],
)
def test_a_bad_engine(script, words, layers, monkeypatch, tmp_path):
    engine = tmp_path / "firebreak"
    if script is not None:
        engine.write_text(f"#!/bin/sh\n{script}\n")
        engine.chmod(0o755)
    monkeypatch.setenv("FIREBREAK_PYTHON", str(engine))
    algorithm = QgsApplication.processingRegistry().createAlgorithmById("firebreak:plan")
    able, told = algorithm.canExecute()
    assert not able
    assert re.search(words, told)
    assert "Make engine" in told
    with pytest.raises(QgsProcessingException, match=words):
        run("plan", **layers, OUTPUT_BREAKS=str(tmp_path / "b.tif"))


# --- forms ----------------------------------------------------------------------------------------------------


def test_provider_and_forms(provider):
    assert provider.id() == "firebreak"
    assert not provider.icon().isNull()
    names = {a.name(): a for a in provider.algorithms()}
    titles = {a.group() for a in names.values()}
    assert titles == {"1 Prepare", "2 Rank and cut", "3 Burn", "4 Judge"}
    for algorithm in names.values():
        assert not algorithm.icon().isNull()
        assert algorithm.groupId() in ("prepare", "cut", "burn", "judge")
        page = algorithm.shortHelpString()
        assert ("<img" in page) == (algorithm.name() in PICTURED), algorithm.name()
        assert algorithm.helpUrl() == "", "the address is a placeholder"
        assert algorithm.tags()
        for definition in algorithm.parameterDefinitions():
            assert definition.description()
            default = definition.defaultValue()
            assert default is None or definition.checkValueIsAcceptable(default), definition.name()
        assert all(
            d.defaultFileExtension()
            in ("tif", "gpkg", "csv", "png", "svg", "json", "html", "toml", "txt", "pdf", "kml")
            for d in algorithm.destinationParameterDefinitions()
            if d.type() != "folderDestination"
        )
    advanced = QgsProcessingParameterDefinition.Flag.FlagAdvanced
    folded = {d.name() for d in names["plan"].parameterDefinitions() if d.flags() & advanced}
    assert {"CRS", "RESOLUTION", "METHOD_PARAMS", "SEED", "INPUT_COST", "INPUT_WIND_SPEED_RASTER"} <= folded
    assert not {"INPUT_DEM", "INPUT_VEGETATION", "INPUT_DENSITY", "BUDGET", "METHOD", "N_RUNS"} & folded
    method = names["plan"].parameterDefinition("METHOD")
    assert method.usesStaticStrings()
    assert "bonacich" in method.options()


def test_sample_model_and_project(layers, tmp_path):
    sample = ROOT / "qgis_plugin" / "sample"
    project = QgsProject()
    assert project.read(str(sample / "sample_landscape.qgs"))
    assert len(project.mapLayers()) >= 6
    assert all(layer.isValid() for layer in project.mapLayers().values())
    model = QgsProcessingModelAlgorithm()
    assert model.fromFile(str(sample / "breaks_and_burns.model3"))
    assert [model.validateChildAlgorithm(child) for child in model.childAlgorithms()]
    for child in model.childAlgorithms().values():
        assert model.validateChildAlgorithm(child.childId())[0], child.childId()
