"""Values of a QGIS form turned into what the command line reads: paths, numbers and words."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingException,
    QgsProcessingFeedback,
    QgsRasterFileWriter,
    QgsRasterLayer,
    QgsRasterPipe,
)

from . import enums
from .manifest import Field
from .translation import translate

#: Vector formats that the engine reads as they are; all others are exported first.
_VECTOR_FORMATS = ["gpkg", "geojson", "fgb", "shp"]

_READERS = {"folder": "file"}


class FormValues:
    """Reads the values of one run of an algorithm.

    Parameters
    ----------
    algorithm
        The algorithm that runs.
    parameters, context, feedback
        As QGIS hands them to it.
    folder
        Where exported layers go.
    """

    def __init__(
        self,
        algorithm: QgsProcessingAlgorithm,
        parameters: dict[str, Any],
        context: QgsProcessingContext,
        feedback: QgsProcessingFeedback,
        folder: Path,
    ) -> None:
        self._algorithm = algorithm
        self._parameters = parameters
        self._context = context
        self._feedback = feedback
        self._folder = folder

    def read(self, fields: tuple[Field, ...]) -> dict[str, Any]:
        """Return the value of every field by its name, None where nothing was given."""
        return {field.name: getattr(self, f"_{_READERS.get(field.kind, field.kind)}")(field) for field in fields}

    def _given(self, field: Field) -> bool:
        return self._parameters.get(field.name) not in (None, "")

    def _raster(self, field: Field) -> str | None:
        layer = self._algorithm.parameterAsRasterLayer(self._parameters, field.name, self._context)
        if layer is None:
            if self._given(field):
                raise QgsProcessingException(self._algorithm.invalidRasterError(self._parameters, field.name))
            return None
        path = layer.source().partition("|")[0]
        in_memory = path.startswith("/vsimem/")  # of this process, which the engine cannot see
        if layer.providerType() == "gdal" and not in_memory and _crs_of_file(layer) == layer.crs():
            return path
        return self._exported(layer, field)

    def _exported(self, layer: QgsRasterLayer, field: Field) -> str:
        """Write a layer that is no file, or whose CRS was set in QGIS, as a GeoTIFF of the same values."""
        if not layer.crs().isValid() and layer.providerType() == "gdal":
            return layer.source()
        path = str(self._folder / f"{field.name.lower()}.tif")
        writer, pipe = QgsRasterFileWriter(path), QgsRasterPipe()
        writer.setOutputFormat("GTiff")
        pipe.set(layer.dataProvider().clone())
        failure = writer.writeRaster(
            pipe, layer.width(), layer.height(), layer.extent(), layer.crs(), self._context.transformContext()
        )
        if failure != enums.RASTER_WRITTEN:
            message = translate("Firebreak", "The layer {} cannot be read as cells of a raster.")
            raise QgsProcessingException(message.format(layer.name()))
        return path

    def _vector(self, field: Field) -> str | None:
        if not self._given(field):
            return None
        source = self._algorithm.parameterAsSource(self._parameters, field.name, self._context)
        if source is None:
            raise QgsProcessingException(self._algorithm.invalidSourceError(self._parameters, field.name))
        return self._algorithm.parameterAsCompatibleSourceLayerPath(
            self._parameters, field.name, self._context, _VECTOR_FORMATS, "gpkg", self._feedback
        )

    def _file(self, field: Field) -> str | None:
        return self._algorithm.parameterAsFile(self._parameters, field.name, self._context) or None

    def _crs(self, field: Field) -> str | None:
        crs = self._algorithm.parameterAsCrs(self._parameters, field.name, self._context)
        if not crs.isValid():
            return None
        return crs.authid() or crs.toWkt(enums.WKT2_2019)

    def _extent(self, field: Field) -> tuple[float, ...] | None:
        if not self._given(field):
            return None
        crs = self._algorithm.parameterAsCrs(self._parameters, "CRS", self._context)
        if not crs.isValid():
            raise QgsProcessingException(
                translate("Firebreak", "An extent needs the CRS of the grid; choose it beside the extent (CRS).")
            )
        box = self._algorithm.parameterAsExtent(self._parameters, field.name, self._context, crs)
        if box.isNull() or box.isEmpty():
            return None
        return box.xMinimum(), box.yMinimum(), box.xMaximum(), box.yMaximum()

    def _number(self, field: Field) -> float | None:
        if self._parameters.get(field.name, field.default) is None:
            return None
        return self._algorithm.parameterAsDouble(self._parameters, field.name, self._context)

    def _integer(self, field: Field) -> int | None:
        if self._parameters.get(field.name, field.default) is None:
            return None
        return self._algorithm.parameterAsInt(self._parameters, field.name, self._context)

    def _boolean(self, field: Field) -> bool:
        return self._algorithm.parameterAsBool(self._parameters, field.name, self._context)

    def _choice(self, field: Field) -> str | None:
        return self._algorithm.parameterAsEnumString(self._parameters, field.name, self._context) or None

    def _choices(self, field: Field) -> list[str]:
        return self._algorithm.parameterAsEnumStrings(self._parameters, field.name, self._context)

    def _field(self, field: Field) -> str | None:
        return next(iter(self._algorithm.parameterAsFields(self._parameters, field.name, self._context)), None)

    def _text(self, field: Field) -> str | None:
        return self._algorithm.parameterAsString(self._parameters, field.name, self._context).strip() or None


def _crs_of_file(layer: QgsRasterLayer) -> QgsCoordinateReferenceSystem:
    """Return the CRS that the file itself has, whatever was set in QGIS."""
    return QgsRasterLayer(layer.source(), "", "gdal").crs()
