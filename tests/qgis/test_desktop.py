"""What only the desktop does: styles and order of loaded layers, the settings page, the plugin's life."""

from __future__ import annotations

import gc
import re
import shutil
import time
import weakref
from pathlib import Path

import pytest
from conftest import QUICK
from qgis.core import (
    QgsApplication,
    QgsPalettedRasterRenderer,
    QgsProcessingAlgRunnerTask,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingOutputLayerDefinition,
    QgsProject,
    QgsRasterLayer,
    QgsSettings,
    QgsSingleBandPseudoColorRenderer,
)
from qgis.PyQt.QtCore import QCoreApplication
from qgis.PyQt.QtWidgets import QPushButton

pytestmark = pytest.mark.usefixtures("provider")


def wait_until(done, seconds: float) -> None:
    end = time.monotonic() + seconds
    while not done():
        assert time.monotonic() < end, "it took too long"
        QCoreApplication.processEvents()
        time.sleep(0.01)


def test_outputs_are_styled_and_in_order(layers, tmp_path):
    """Run as the dialog does: on a background thread, layers loaded into the project afterwards."""
    from processing.gui.Postprocessing import handleAlgorithmResults

    project = QgsProject.instance()
    project.clear()
    outputs = {
        name: QgsProcessingOutputLayerDefinition(str(tmp_path / f"{file}"), project)
        for name, file in (
            ("OUTPUT_BREAKS", "a breaks.tif"),
            ("OUTPUT_FREQUENCY", "z frequency.tif"),
            ("OUTPUT_PRIORITY", "m.tif"),
            ("OUTPUT_BREAK_POLYGONS", "b.gpkg"),
            ("OUTPUT_SEGMENTS", "s.gpkg"),
        )
    }
    algorithm = QgsApplication.processingRegistry().createAlgorithmById("firebreak:plan")
    context, feedback = QgsProcessingContext(), QgsProcessingFeedback(False)
    context.setProject(project)
    parameters = {**layers, **QUICK, **outputs, "METHOD": "degree"}
    task = QgsProcessingAlgRunnerTask(algorithm, parameters, context, feedback)
    ended = []
    task.executed.connect(lambda ok, results: ended.append((ok, results)))
    QgsApplication.taskManager().addTask(task)
    ticks, begun = 0, time.monotonic()
    while not ended and time.monotonic() - begun < 60:
        QCoreApplication.processEvents()
        time.sleep(0.01)
        ticks += 1
    assert ended[0][0]
    assert ticks > 50, "the window stood still"
    assert handleAlgorithmResults(algorithm, context, feedback, parameters=parameters)
    wait_until(lambda: len(project.layerTreeRoot().findLayers()) == 5, 5)
    for _ in range(20):
        QCoreApplication.processEvents()
    (group,) = project.layerTreeRoot().children()
    assert re.fullmatch(r"Plan fire breaks \(Degree, \d\d:\d\d\)", group.name())
    sources = [Path(node.layer().source().partition("|")[0]).name for node in group.children()]
    assert sources == ["s.gpkg", "b.gpkg", "a breaks.tif", "z frequency.tif", "m.tif"]
    found = {Path(layer.source().partition("|")[0]).name: layer for layer in project.mapLayers().values()}
    assert isinstance(found["a breaks.tif"].renderer(), QgsPalettedRasterRenderer)
    assert isinstance(found["z frequency.tif"].renderer(), QgsSingleBandPseudoColorRenderer)
    assert found["s.gpkg"].renderer().classAttribute() == "stage"
    assert found["s.gpkg"].labelsEnabled()
    metadata = found["m.tif"].metadata()
    assert metadata.title() == "Cutting priority"
    assert "firebreak_gis" in metadata.history()[0]
    assert "Ranking: degree" in metadata.history()
    assert f"Number of fires: {QUICK['N_RUNS']}" in metadata.history()
    assert found["b.gpkg"].renderer().symbol().color().blue() > 200
    project.clear()


def test_a_refused_run_lets_its_layers_go(layers, tmp_path):
    """A failed run in the background, as the dialog does it, holds no layer: its file can be moved or mended."""
    layer = QgsRasterLayer(layers["INPUT_DEM"], "dem")
    kept = weakref.ref(layer)
    algorithm = QgsApplication.processingRegistry().createAlgorithmById("firebreak:plan")
    context, feedback = QgsProcessingContext(), QgsProcessingFeedback(False)
    parameters = {**layers, "INPUT_DEM": layer, "BUDGET": 1.5, "OUTPUT_BREAKS": str(tmp_path / "b.tif")}
    task, ended = QgsProcessingAlgRunnerTask(algorithm, parameters, context, feedback), []
    task.executed.connect(lambda ok, results: ended.append(ok))
    QgsApplication.taskManager().addTask(task)
    wait_until(lambda: ended, 60)
    assert ended == [False]
    assert "budget is 1.5" in feedback.textLog()
    del task, parameters, layer
    for _ in range(20):  # the task manager lets the task go
        QCoreApplication.processEvents()
    gc.collect()
    assert kept() is None


@pytest.fixture
def quiet_settings():
    keys = ("firebreak/engine", "firebreak/package")
    yield
    for key in keys:
        QgsSettings().remove(key)


def test_settings_page(quiet_settings, monkeypatch, tmp_path):
    from firebreak import settings
    from firebreak.options import OptionsFactory

    page = OptionsFactory().createWidget(None)
    assert "answers" in page._status.text()
    monkeypatch.delenv("FIREBREAK_PYTHON")
    page._engine.setFilePath(str(tmp_path / "nothing"))
    next(b for b in page.findChildren(QPushButton) if b.text() == "Check").click()
    assert "no such file" in page._status.text()
    assert settings.engine_setting() == str(tmp_path / "nothing")


def test_make_engine_on_a_click(quiet_settings, monkeypatch, tmp_path, engine_wheel):
    """The button makes an environment in the background; the page shows lines, a bar and the outcome."""
    from firebreak import settings
    from firebreak.options import OptionsPage

    monkeypatch.delenv("FIREBREAK_PYTHON")
    monkeypatch.setattr(settings, "made_folder", lambda: tmp_path / "profile" / "firebreak_engine")
    page = OptionsPage()
    assert "9.8.7" not in page._status.text()
    page._package.setText(str(engine_wheel))
    page._make.click()
    assert not page._make.isEnabled()
    wait_until(lambda: page._make.isEnabled(), 60)
    assert "9.8.7" in page._status.text()
    assert "is ready" in page._log.toPlainText()
    assert page._bar.value() == 100
    shutil.rmtree(tmp_path / "profile")
