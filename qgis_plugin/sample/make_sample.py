#!/usr/bin/env python3
"""Make the sample project and the sample model beside this script.

Run it with the Python of QGIS as ``python qgis_plugin/sample/make_sample.py``. The project holds the layers
of `sample_data` by relative paths; the model goes from layers to breaks and burns with and without them.
"""

from __future__ import annotations

import os
import re
import sys
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from qgis.core import (
    Qgis,
    QgsApplication,
    QgsColorRampShader,
    QgsCoordinateReferenceSystem,
    QgsFillSymbol,
    QgsLineSymbol,
    QgsMarkerSymbol,
    QgsPalettedRasterRenderer,
    QgsProcessingModelAlgorithm,
    QgsProcessingModelChildAlgorithm,
    QgsProcessingModelChildParameterSource,
    QgsProcessingModelOutput,
    QgsProcessingModelParameter,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterLayer,
    QgsProcessingParameterString,
    QgsProject,
    QgsRasterLayer,
    QgsRasterShader,
    QgsReferencedRectangle,
    QgsSingleBandPseudoColorRenderer,
    QgsSingleSymbolRenderer,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import QPointF
from qgis.PyQt.QtGui import QColor

HERE = Path(__file__).resolve().parent
DATA = HERE.parent.parent / "sample_data"

CLASSES = {
    "vegetation": {
        0: ("none", "#d9d9d9"),
        1: ("agricultural", "#e9d66b"),
        2: ("shrubs", "#a3b18a"),
        3: ("pines", "#2d6a4f"),
    },
    "density": {1: ("sparse", "#d8f3dc"), 2: ("normal", "#74c69d"), 3: ("dense", "#1b4332")},
}
HEIGHTS = {0: "#2d6a4f", 150: "#95b46a", 300: "#e9d8a6", 450: "#b08968", 600: "#f8f9fa"}
VECTORS = {
    "ignitions": QgsMarkerSymbol.createSimple({"name": "star", "color": "#e31a1c", "size": "4"}),
    "villages": QgsFillSymbol.createSimple({"color": "#6c757d", "outline_color": "#212529"}),
    "roads": QgsLineSymbol.createSimple({"line_color": "#495057", "line_width": "0.5"}),
    "boundary": QgsFillSymbol.createSimple({"style": "no", "outline_color": "#212529", "outline_width": "0.5"}),
}


def make_project(target: Path) -> None:
    """Write the project."""
    project = QgsProject()
    project.setFilePathStorage(Qgis.FilePathType.Relative)
    project.setTitle("Firebreak sample landscape")
    project.setCrs(QgsCoordinateReferenceSystem("EPSG:32635"))
    layers = [_classes(name) for name in CLASSES]
    layers.append(_heights())
    for name, symbol in VECTORS.items():
        layer = QgsVectorLayer(str(DATA / f"{name}.gpkg"), name, "ogr")
        layer.setRenderer(QgsSingleSymbolRenderer(symbol))
        layers.append(layer)
    tree = project.layerTreeRoot()
    for name in (*VECTORS, "vegetation", "density", "dem"):
        layer = next(layer for layer in layers if layer.name() == name)
        if not layer.isValid():
            sys.exit(f"{layer.source()} cannot be read")
        project.addMapLayer(layer, False)
        tree.addLayer(layer).setItemVisibilityChecked(name not in ("density", "dem"))
    extent = next(layer for layer in layers if layer.name() == "vegetation").extent()
    project.viewSettings().setDefaultViewExtent(QgsReferencedRectangle(extent, project.crs()))
    if not project.write(str(target)):
        sys.exit(project.error())
    text = target.read_text(encoding="utf-8")
    for attribute in ("saveUser", "saveUserFull", "saveDateTime"):
        text = re.sub(f' {attribute}="[^"]*"', "", text)
    target.write_text(text, encoding="utf-8")
    for stray in DATA.glob("*.aux.xml"):
        stray.unlink()


def _classes(name: str) -> QgsRasterLayer:
    layer = QgsRasterLayer(str(DATA / f"{name}.tif"), name)
    entries = [QgsPalettedRasterRenderer.Class(code, QColor(c), text) for code, (text, c) in CLASSES[name].items()]
    layer.setRenderer(QgsPalettedRasterRenderer(layer.dataProvider(), 1, entries))
    return layer


def _heights() -> QgsRasterLayer:
    layer = QgsRasterLayer(str(DATA / "dem.tif"), "dem")
    ramp = QgsColorRampShader(0, max(HEIGHTS))
    ramp.setColorRampItemList(
        [QgsColorRampShader.ColorRampItem(z, QColor(colour), f"{z} m") for z, colour in HEIGHTS.items()]
    )
    shader = QgsRasterShader()
    shader.setRasterShaderFunction(ramp)
    layer.setRenderer(QgsSingleBandPseudoColorRenderer(layer.dataProvider(), 1, shader))
    return layer


def make_model(target: Path) -> None:
    """Write the model: network, ranking, breaks, burns without and with them."""
    model = QgsProcessingModelAlgorithm("Breaks and burns", "Firebreak")
    inputs = (
        QgsProcessingParameterRasterLayer("dem", "Elevation"),
        QgsProcessingParameterRasterLayer("vegetation", "Vegetation"),
        QgsProcessingParameterRasterLayer("density", "Vegetation density"),
        QgsProcessingParameterString("budget", "Budget, such as 10%, 5ha or 20000eur", "10%"),
        QgsProcessingParameterNumber("runs", "Number of fires", QgsProcessingParameterNumber.Type.Integer, 100),
    )
    for row, definition in enumerate(inputs):
        component = QgsProcessingModelParameter(definition.name())
        component.setPosition(QPointF(120, 80 + 80 * row))
        model.addModelParameter(definition, component)
    given = QgsProcessingModelChildParameterSource.fromModelParameter
    made = QgsProcessingModelChildParameterSource.fromChildOutput
    _child(
        model,
        "network",
        0,
        {"INPUT_DEM": given("dem"), "INPUT_VEGETATION": given("vegetation"), "INPUT_DENSITY": given("density")},
    )
    _child(model, "rank", 1, {"INPUT_NETWORK": made("network", "OUTPUT_NETWORK"), "BUDGET": given("budget")})
    _child(
        model,
        "breaks",
        2,
        {"INPUT_PRIORITY": made("rank", "OUTPUT_PRIORITY"), "BUDGET": given("budget")},
        {"OUTPUT_BREAKS": "Fire breaks"},
    )
    fires = {"INPUT_NETWORK": made("network", "OUTPUT_NETWORK"), "N_RUNS": given("runs")}
    _child(model, "burn", 3, fires, {"OUTPUT_FREQUENCY": "Burn frequency without breaks"}, "without")
    _child(
        model,
        "burn",
        4,
        {**fires, "INPUT_BREAKS": made("breaks", "OUTPUT_BREAKS")},
        {"OUTPUT_FREQUENCY": "Burn frequency with the breaks"},
        "with",
    )
    if not model.toFile(str(target)):
        sys.exit(f"{target} cannot be written")


def _child(
    model: QgsProcessingModelAlgorithm,
    algorithm: str,
    row: int,
    sources: dict,
    results: dict | None = None,
    name: str | None = None,
) -> None:
    child = QgsProcessingModelChildAlgorithm(f"firebreak:{algorithm}")
    child.setChildId(name or algorithm)
    child.setDescription(child.algorithm().displayName() + (f" ({name} breaks)" if name else ""))
    child.setPosition(QPointF(420, 80 + 100 * row))
    for definition in child.algorithm().parameterDefinitions():
        optional = definition.flags() & QgsProcessingParameterDefinition.Flag.FlagOptional
        if not optional and definition.defaultValue() is not None:
            value = QgsProcessingModelChildParameterSource.fromStaticValue(definition.defaultValue())
            child.addParameterSources(definition.name(), [value])
    for parameter, source in sources.items():
        child.addParameterSources(parameter, [source])
    outputs = {}
    for parameter, text in (results or {}).items():
        output = QgsProcessingModelOutput(text, text)
        output.setChildId(child.childId())
        output.setChildOutputName(parameter)
        output.setPosition(QPointF(720, 80 + 100 * row))
        output.setMandatory(True)  # without a file of breaks the burn after it would know of none
        outputs[text] = output
    child.setModelOutputs(outputs)
    model.addChildAlgorithm(child)


def main() -> None:
    """Make both."""
    application = QgsApplication([], False)
    application.initQgis()
    sys.path.insert(0, str(HERE.parent))
    from firebreak.provider import FirebreakProvider

    provider = FirebreakProvider()
    QgsApplication.processingRegistry().addProvider(provider)
    make_project(HERE / "sample_landscape.qgs")
    make_model(HERE / "breaks_and_burns.model3")
    application.exitQgis()


if __name__ == "__main__":
    main()
