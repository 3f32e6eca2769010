"""QGIS parameters built from the fields and outputs of a form."""

from __future__ import annotations

from typing import Any

from qgis.core import (
    QgsProcessingParameterBoolean,
    QgsProcessingParameterCrs,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterEnum,
    QgsProcessingParameterExtent,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterField,
    QgsProcessingParameterFile,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterFolderDestination,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterDestination,
    QgsProcessingParameterRasterLayer,
    QgsProcessingParameterString,
    QgsProcessingParameterVectorDestination,
)

from . import enums
from .manifest import Field, Output
from .texts import field_label, file_filter, translated

_DECIMALS = 6


def input_parameter(field: Field) -> QgsProcessingParameterDefinition:
    """Return the QGIS parameter for a field."""
    label, optional = field_label(field), _is_optional(field)
    make: dict[str, Any] = {
        "raster": lambda: QgsProcessingParameterRasterLayer(field.name, label, optional=optional),
        "vector": lambda: QgsProcessingParameterFeatureSource(
            field.name, label, [enums.ANY_GEOMETRY], optional=optional
        ),
        "field": lambda: QgsProcessingParameterField(
            field.name, label, parentLayerParameterName=field.parent, optional=optional
        ),
        "file": lambda: QgsProcessingParameterFile(field.name, label, optional=optional),
        "folder": lambda: QgsProcessingParameterFile(field.name, label, enums.FOLDER, optional=optional),
        "crs": lambda: QgsProcessingParameterCrs(field.name, label, optional=optional),
        "extent": lambda: QgsProcessingParameterExtent(field.name, label, optional=optional),
        "number": lambda: _number(field, label, enums.DOUBLE),
        "integer": lambda: _number(field, label, enums.INTEGER),
        "boolean": lambda: QgsProcessingParameterBoolean(field.name, label, bool(field.default), optional=optional),
        "choice": lambda: _choice(field, label, several=False),
        "choices": lambda: _choice(field, label, several=True),
        "text": lambda: QgsProcessingParameterString(field.name, label, field.default, optional=optional),
    }
    parameter = make[field.kind]()
    parameter.setHelp(translated(field.help))
    if field.advanced:
        parameter.setFlags(parameter.flags() | enums.ADVANCED)
    return parameter


def output_parameter(output: Output) -> QgsProcessingParameterDefinition:
    """Return the QGIS destination for an output; those that the form does not show can be named in scripts and models.

    All files of a run come with its folder, so that the form stays short.
    """
    parameter = _destination(output)
    if not output.shown and output.kind != "folder":
        parameter.setFlags(parameter.flags() | enums.HIDDEN)
    return parameter


def _destination(output: Output) -> QgsProcessingParameterDefinition:
    label = translated(output.label)
    usual: dict[str, bool] = {"optional": True, "createByDefault": output.shown}
    if output.kind == "raster":
        return QgsProcessingParameterRasterDestination(output.name, label, **usual)
    if output.kind == "vector":
        return QgsProcessingParameterVectorDestination(output.name, label, enums.ANY_GEOMETRY, **usual)
    if output.kind == "folder":
        return QgsProcessingParameterFolderDestination(output.name, label, **usual)
    return QgsProcessingParameterFileDestination(output.name, label, file_filter(output.file), **usual)


def _is_optional(field: Field) -> bool:
    """Tell whether a model may leave the field out; advanced ones always, so that models outlive new options."""
    return field.advanced or not (field.required or field.default not in (None, ""))


def _number(field: Field, label: str, kind: Any) -> QgsProcessingParameterNumber:
    parameter = QgsProcessingParameterNumber(field.name, label, kind, field.default, optional=_is_optional(field))
    if field.low is not None:
        parameter.setMinimum(field.low)
    if field.high is not None:
        parameter.setMaximum(field.high)
    if kind == enums.DOUBLE:
        parameter.setMetadata({"widget_wrapper": {"decimals": _DECIMALS}})
    return parameter


def _choice(field: Field, label: str, *, several: bool) -> QgsProcessingParameterEnum:
    """Return an enum whose values are the engine's words, so that models outlive new choices; the form shows others."""
    default = field.default.split(",") if several and field.default else field.default
    parameter = QgsProcessingParameterEnum(
        field.name,
        label,
        list(field.choices),
        allowMultiple=several,
        defaultValue=default,
        optional=_is_optional(field),
        usesStaticStrings=True,
    )
    words = [translated(word) for word in field.words]
    parameter.setMetadata({"widget_wrapper": {"class": f"{__package__}.choosing.ChoiceWidget", "words": words}})
    return parameter
