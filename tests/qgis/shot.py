"""Runs inside the QGIS desktop: plan breaks on the sample project, arrange the window, take its picture.

Started by `screenshot.sh`, which sets SHOT_PROJECT and SHOT_PICTURE.
"""

import os
import subprocess
import traceback
from pathlib import Path

import processing
from qgis.core import QgsApplication, QgsProject
from qgis.PyQt.QtCore import QCoreApplication, Qt, QTimer
from qgis.PyQt.QtWidgets import QComboBox, QDockWidget, QLineEdit, QScrollArea, QTabWidget
from qgis.utils import iface, loadPlugin, startPlugin

PROJECT = os.environ["SHOT_PROJECT"]
PICTURE = os.environ["SHOT_PICTURE"]
BUDGET, FIRES = "2%", 100
KEPT_DOCKS = ("Layers", "ProcessingToolbox")


def settle(milliseconds, then):
    """Let QGIS work, then go on; end QGIS on an error, so that the script never hangs."""

    def guarded():
        try:
            then()
        except BaseException:
            traceback.print_exc()
            os._exit(1)

    QTimer.singleShot(milliseconds, guarded)


def begin():
    """Open the project and plan."""
    window = iface.mainWindow()
    window.setGeometry(0, 0, 1600, 1000)
    if "firebreak" not in {p.id() for p in QgsApplication.processingRegistry().providers()}:
        loadPlugin("firebreak")
        startPlugin("firebreak")
    QgsProject.instance().read(PROJECT)
    folder = Path(PROJECT).parents[2] / "sample_data"
    layers = {f"INPUT_{n.upper()}": str(folder / f"{n}.tif") for n in ("dem", "vegetation", "density")}
    processing.runAndLoadResults(
        "firebreak:plan",
        {
            **layers,
            "BUDGET": BUDGET,
            "N_RUNS": FIRES,
            "OUTPUT_BREAKS": "TEMPORARY_OUTPUT",
            "OUTPUT_SEGMENTS": "TEMPORARY_OUTPUT",
            "OUTPUT_FREQUENCY_WITH_BREAKS": "TEMPORARY_OUTPUT",
        },
    )
    settle(1000, arrange)


def arrange():
    """Show layers, toolbox, map and form side by side."""
    window = iface.mainWindow()
    for dock in window.findChildren(QDockWidget):
        dock.setVisible(dock.objectName() in KEPT_DOCKS)
    toolbox = next(d for d in window.findChildren(QDockWidget) if d.objectName() == "ProcessingToolbox")
    window.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, toolbox)
    toolbox.findChild(QLineEdit).setText("firebreak")
    for node in QgsProject.instance().layerTreeRoot().findLayers():
        if node.name() in ("dem", "density", "vegetation"):
            node.setExpanded(False)
    layers = next(d for d in window.findChildren(QDockWidget) if d.objectName() == "Layers")
    window.resizeDocks([layers, toolbox], [380, 250], Qt.Orientation.Horizontal)
    iface.mapCanvas().zoomToFeatureExtent(QgsProject.instance().mapLayersByName("vegetation")[0].extent())
    iface.mapCanvas().refresh()
    settle(1500, show_form)


def show_form():
    """Open the form of the algorithm beside the map."""
    project = QgsProject.instance()
    layers = {f"INPUT_{n.upper()}": project.mapLayersByName(n)[0].id() for n in ("dem", "vegetation", "density")}
    dialog = processing.createAlgorithmDialog("firebreak:plan", {**layers, "BUDGET": BUDGET, "N_RUNS": FIRES})
    dialog.show()
    dialog.setGeometry(700, 330, 890, 640)
    for tabs in dialog.findChildren(QTabWidget):
        tabs.setCurrentIndex(0)
    settle(1500, lambda: scroll(dialog))


def scroll(dialog):
    """Show the part of the form with budget and ranking."""
    ranking = next(c for c in dialog.findChildren(QComboBox) if c.findData("dissection") >= 0)
    for area in dialog.findChildren(QScrollArea):
        area.ensureWidgetVisible(ranking, 0, 120)
    settle(1000, take)


def take():
    """Take the picture and end."""
    QCoreApplication.processEvents()
    subprocess.run(["import", "-window", "root", PICTURE], check=True)
    os._exit(0)


settle(3000, begin)
