#!/usr/bin/env python3
"""Draw the pictures of the plugin's help pages from the sample data.

Run it with the Python of QGIS, FIREBREAK_PYTHON set, as ``python tests/qgis/pictures.py``.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from qgis.core import (
    QgsApplication,
    QgsMapRendererParallelJob,
    QgsMapSettings,
    QgsRasterLayer,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import QSize, Qt
from qgis.PyQt.QtGui import QColor, QImage

ROOT = Path(__file__).resolve().parents[2]
TARGET = ROOT / "qgis_plugin" / "firebreak" / "pictures"
WIDTH = 280


def main() -> None:
    """Run every command once and draw what it made."""
    application = QgsApplication([], False)
    application.initQgis()
    TARGET.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        data = shutil.copytree(ROOT / "sample_data", folder / "data")
        layers = [data / f"{layer}.tif" for layer in ("dem", "vegetation", "density")]
        network, fires = folder / "network.tif", ("--runs", "100")
        firebreak("plan", "--budget", "0.02", "-o", folder / "plan", *layers)
        firebreak("align", "-o", folder / "landscape", *layers)
        firebreak("network", "-o", network, folder / "landscape")
        firebreak("rank", "--method", "bonacich", "-o", folder / "priority.tif", network)
        firebreak("evaluate", *fires, "--methods", "bonacich,flammability,random", "-o", folder / "e", network)
        firebreak("compare", *fires, "--methods", "dissection,bonacich,random", "-o", folder / "c", network)
        plan = folder / "plan"
        draw("align", plan / "vegetation.tif")
        draw("network", network)
        draw("rank", folder / "priority.tif")
        draw("breaks", plan / "breaks.tif", plan / "vegetation.tif")
        draw("segments", plan / "segments.gpkg", plan / "breaks.tif", plan / "vegetation.tif")
        draw("plan", plan / "breaks.tif", plan / "burn_frequency_with_breaks.tif")
        draw("burn", plan / "burn_frequency.tif")
        for command, picture in (("evaluate", folder / "e/evaluation.png"), ("compare", folder / "c/comparison.png")):
            image = QImage(str(picture))
            wide = image.width() > 2 * image.height()  # several panels side by side: the first tells enough
            save(image.copy(0, 0, image.width() // 3, image.height()) if wide else image, command)
    application.exitQgis()


def firebreak(*words: object) -> None:
    """Run the command line."""
    command = [os.environ["FIREBREAK_PYTHON"], "-I", "-m", "firebreak_gis", *map(str, words), "-q"]
    subprocess.run(command, check=True)


def draw(name: str, *files: Path) -> None:
    """Draw layers, the first on top, in their own styles."""
    layers = []
    for file in files:
        kind = QgsVectorLayer if file.suffix == ".gpkg" else QgsRasterLayer
        layer = kind(str(file), file.stem)
        if file.with_suffix(".qml").exists():  # a GeoPackage has its style inside
            layer.loadNamedStyle(str(file.with_suffix(".qml")))
        if not layer.isValid():
            sys.exit(f"{file} cannot be read")
        layers.append(layer)
    settings = QgsMapSettings()
    settings.setLayers(layers)
    settings.setDestinationCrs(layers[0].crs())
    extent = layers[0].extent()
    settings.setExtent(extent)
    settings.setOutputSize(QSize(WIDTH, round(WIDTH * extent.height() / extent.width())))
    settings.setBackgroundColor(QColor("#ffffff"))
    job = QgsMapRendererParallelJob(settings)
    job.start()
    job.waitForFinished()
    save(job.renderedImage(), name)


def save(image: QImage, name: str) -> None:
    """Write a small picture."""
    if image.width() > WIDTH:
        image = image.scaledToWidth(WIDTH, Qt.TransformationMode.SmoothTransformation)
    image.convertToFormat(QImage.Format.Format_RGB32).save(str(TARGET / f"{name}.png"))


if __name__ == "__main__":
    main()
