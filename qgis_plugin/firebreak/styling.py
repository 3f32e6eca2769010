"""Styles and drawing order of the layers that an algorithm adds to the map."""

from __future__ import annotations

import contextlib
from pathlib import Path

from qgis.core import (
    QgsLayerTreeLayer,
    QgsMapLayer,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingLayerPostProcessorInterface,
    QgsProject,
)
from qgis.PyQt.QtCore import QTimer

from .forms import DRAWING_ORDER

_STYLES = Path(__file__).with_name("styles")
_RANK = "firebreak/drawing_rank"

#: QGIS keeps no reference to post-processors, so the last ones made are kept here.
_alive: list[QgsProcessingLayerPostProcessorInterface] = []
_KEPT = 64


class Styler(QgsProcessingLayerPostProcessorInterface):
    """Gives a new layer its style and its place among its siblings.

    Parameters
    ----------
    output
        Name of the output parameter.
    """

    def __init__(self, output: str) -> None:
        super().__init__()
        self._output = output
        _alive.append(self)
        del _alive[:-_KEPT]

    def postProcessLayer(  # noqa: N802 - named by QGIS
        self,
        layer: QgsMapLayer,
        context: QgsProcessingContext,  # noqa: ARG002
        feedback: QgsProcessingFeedback,  # noqa: ARG002
    ) -> None:
        """Load the style that lies beside the layer, or the plugin's own."""
        beside = Path(layer.source().partition("|")[0]).with_suffix(".qml")
        own = _STYLES / f"{self._output.lower()}.qml"
        style = next((path for path in (own, beside) if path.is_file()), None)
        if style is not None:
            layer.loadNamedStyle(str(style))
            layer.triggerRepaint()
        layer.setCustomProperty(_RANK, DRAWING_ORDER.index(self._output) if self._output in DRAWING_ORDER else 99)
        # The layers of one run arrive one by one; when all are there they are put in order.
        QTimer.singleShot(0, arrange)


def style_later(output: str, path: str, context: QgsProcessingContext) -> None:
    """Have a layer styled when QGIS loads it, if it will."""
    if context.willLoadLayerOnCompletion(path):
        details = context.layerToLoadOnCompletionDetails(path)
        details.setPostProcessor(Styler(output))
        with contextlib.suppress(AttributeError):  # later releases sort by themselves
            details.layerSortKey = -DRAWING_ORDER.index(output) if output in DRAWING_ORDER else -99
        context.addLayerToLoadOnCompletion(path, details)


def arrange(project: QgsProject | None = None) -> None:
    """Put new layers that stand side by side in drawing order: breaks over burn frequency over the rest."""
    root = (project or QgsProject.instance()).layerTreeRoot()
    parents = []
    for node in root.findLayers():
        if _rank(node) is not None and node.parent() not in parents:
            parents.append(node.parent())
    for parent in parents:
        for start, run in _runs(parent.children()):
            ordered = sorted(run, key=_rank)
            if ordered != run:
                for place, node in enumerate(ordered):
                    parent.insertChildNode(start + place, node.clone())
                for node in run:
                    parent.removeChildNode(node)
            for node in run:
                layer = node.layer() if node in parent.children() else None
                if layer is not None:
                    layer.removeCustomProperty(_RANK)


def _rank(node: QgsLayerTreeLayer) -> int | None:
    layer = node.layer() if isinstance(node, QgsLayerTreeLayer) else None
    value = layer.customProperty(_RANK) if layer is not None else None
    return None if value is None else int(value)


def _runs(nodes: list) -> list[tuple[int, list]]:
    """Return (place, nodes) of every unbroken row of new layers."""
    rows: list[tuple[int, list]] = []
    for place, node in enumerate(nodes):
        if _rank(node) is None:
            continue
        if rows and rows[-1][0] + len(rows[-1][1]) == place:
            rows[-1][1].append(node)
        else:
            rows.append((place, [node]))
    return rows
