"""A vector layer that the engine wrote, in the format that its destination says."""

from __future__ import annotations

from pathlib import Path

from qgis.core import QgsProcessingContext, QgsProcessingFeedback, QgsVectorFileWriter, QgsVectorLayer

from .results import DestinationError, deliver
from .translation import translate


def deliver_vector(
    file: Path, destination: Path, context: QgsProcessingContext, feedback: QgsProcessingFeedback
) -> None:
    """Copy a GeoPackage, or write its first layer, with its style, in another format.

    Raises
    ------
    DestinationError
        If the destination cannot be written.
    """
    ending = destination.suffix[1:].lower()
    if ending == file.suffix[1:]:
        deliver(file, destination)
        return
    layer = QgsVectorLayer(str(file), file.stem, "ogr")
    names = [line.split("!!::!!")[1] for line in layer.dataProvider().subLayers()]
    if len(names) > 1:
        message = translate("Firebreak", "{} holds {}; only a GeoPackage can hold {} as well.")
        feedback.pushWarning(message.format(destination.name, names[0], ", ".join(names[1:])))
    layer.loadDefaultStyle()
    options = QgsVectorFileWriter.SaveVectorOptions()
    options.driverName = QgsVectorFileWriter.driverForExtension(ending)
    options.layerName = destination.stem
    destination.parent.mkdir(parents=True, exist_ok=True)
    failure, reason = QgsVectorFileWriter.writeAsVectorFormatV3(
        layer, str(destination), context.transformContext(), options
    )[:2]
    if failure != QgsVectorFileWriter.WriterError.NoError:
        raise DestinationError(f"{destination} cannot be written ({reason}).")
    layer.saveNamedStyle(str(destination.with_suffix(".qml")))
