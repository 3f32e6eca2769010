"""QGIS parameters built from the fields and outputs of a form."""

from __future__ import annotations

from typing import Any

from qgis.core import (
    QgsProcessing,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterCrs,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterEnum,
    QgsProcessingParameterExtent,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterField,
    QgsProcessingParameterFile,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterDestination,
    QgsProcessingParameterRasterLayer,
    QgsProcessingParameterString,
    QgsProcessingParameterVectorDestination,
)

from .manifest import Field, Output
from .texts import file_filter, translated

_DECIMALS = 6


def input_parameter(field: Field) -> QgsProcessingParameterDefinition:
    """Return the QGIS parameter for a field."""
    label, optional = translated(field.label), _is_optional(field)
    make: dict[str, Any] = {
        "raster": lambda: QgsProcessingParameterRasterLayer(field.name, label, optional=optional),
        "vector": lambda: QgsProcessingParameterFeatureSource(
            field.name, label, [QgsProcessing.SourceType.TypeVectorAnyGeometry], optional=optional
        ),
        "field": lambda: QgsProcessingParameterField(
            field.name, label, parentLayerParameterName=field.parent, optional=optional
        ),
        "file": lambda: QgsProcessingParameterFile(field.name, label, optional=optional),
        "crs": lambda: QgsProcessingParameterCrs(field.name, label, optional=optional),
        "extent": lambda: QgsProcessingParameterExtent(field.name, label, optional=optional),
        "number": lambda: _number(field, label, QgsProcessingParameterNumber.Type.Double),
        "integer": lambda: _number(field, label, QgsProcessingParameterNumber.Type.Integer),
        "boolean": lambda: QgsProcessingParameterBoolean(field.name, label, bool(field.default), optional=optional),
        "choice": lambda: _choice(field, label, several=False),
        "choices": lambda: _choice(field, label, several=True),
        "text": lambda: QgsProcessingParameterString(field.name, label, field.default, optional=optional),
    }
    parameter = make[field.kind]()
    parameter.setHelp(translated(field.help))
    if field.advanced:
        parameter.setFlags(parameter.flags() | QgsProcessingParameterDefinition.Flag.FlagAdvanced)
    return parameter


def output_parameter(output: Output) -> QgsProcessingParameterDefinition:
    """Return the QGIS destination for an output."""
    label = translated(output.label)
    if output.kind == "raster":
        return QgsProcessingParameterRasterDestination(output.name, label, optional=True, createByDefault=output.shown)
    if output.kind == "vector":
        return QgsProcessingParameterVectorDestination(
            output.name,
            label,
            QgsProcessing.SourceType.TypeVectorAnyGeometry,
            optional=True,
            createByDefault=output.shown,
        )
    return QgsProcessingParameterFileDestination(
        output.name, label, file_filter(output.file), optional=True, createByDefault=output.shown
    )


def _is_optional(field: Field) -> bool:
    """Tell whether a model may leave the field out; advanced ones always, so that models outlive new options."""
    return field.advanced or not (field.required or field.default is not None)


def _number(field: Field, label: str, kind: Any) -> QgsProcessingParameterNumber:
    parameter = QgsProcessingParameterNumber(field.name, label, kind, field.default, optional=_is_optional(field))
    if field.low is not None:
        parameter.setMinimum(field.low)
    if field.high is not None:
        parameter.setMaximum(field.high)
    if kind == QgsProcessingParameterNumber.Type.Double:
        parameter.setMetadata({"widget_wrapper": {"decimals": _DECIMALS}})
    return parameter


def _choice(field: Field, label: str, *, several: bool) -> QgsProcessingParameterEnum:
    """Return an enum whose values are the words themselves, so that models outlive new choices."""
    default = field.default.split(",") if several and field.default else field.default
    return QgsProcessingParameterEnum(
        field.name,
        label,
        list(field.choices),
        allowMultiple=several,
        defaultValue=default,
        optional=_is_optional(field),
        usesStaticStrings=True,
    )
