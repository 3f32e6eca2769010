"""Styles and drawing order of the layers that an algorithm adds to the map."""

from __future__ import annotations

import contextlib
from functools import partial
from pathlib import Path

from qgis.core import (
    QgsLayerTreeLayer,
    QgsLayerTreeNode,
    QgsMapLayer,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingLayerPostProcessorInterface,
    QgsProject,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import QTimer

from .forms import DRAWING_ORDER

_STYLES = Path(__file__).with_name("styles")
_RANK, _RUN = "firebreak/drawing_rank", "firebreak/run"

#: QGIS keeps no reference to post-processors, so the last ones made are kept here.
_alive: list[QgsProcessingLayerPostProcessorInterface] = []
_KEPT = 64


class Styler(QgsProcessingLayerPostProcessorInterface):
    """Gives a new layer its style and its place among the others of its run.

    Parameters
    ----------
    output
        Name of the output parameter.
    run
        What all layers of one run have in common.
    """

    def __init__(self, output: str, run: str) -> None:
        super().__init__()
        self._output = output
        self._run = run
        _alive.append(self)
        del _alive[:-_KEPT]

    def postProcessLayer(  # noqa: N802 - named by QGIS
        self,
        layer: QgsMapLayer,
        context: QgsProcessingContext,  # noqa: ARG002
        feedback: QgsProcessingFeedback,  # noqa: ARG002
    ) -> None:
        """Load the plugin's own style, the one inside the layer's file, or the one beside it."""
        beside = Path(layer.source().partition("|")[0]).with_suffix(".qml")
        own = _STYLES / f"{self._output.lower()}.qml"
        style = next((path for path in (own, beside) if path.is_file()), None)
        if isinstance(layer, QgsVectorLayer) and style != own:
            layer.loadDefaultStyle()  # the one inside the GeoPackage
        elif style is not None:
            layer.loadNamedStyle(str(style))
        layer.triggerRepaint()
        layer.setCustomProperty(_RUN, self._run)
        layer.setCustomProperty(_RANK, _rank_of(self._output))
        # The layer enters the tree of layers after this call.
        QTimer.singleShot(0, partial(arrange, self._run))


def style_later(output: str, path: str, run: str, context: QgsProcessingContext) -> None:
    """Have a layer styled when QGIS loads it, if it will."""
    if context.willLoadLayerOnCompletion(path):
        details = context.layerToLoadOnCompletionDetails(path)
        details.setPostProcessor(Styler(output, run))
        with contextlib.suppress(AttributeError):  # later releases sort by themselves
            details.layerSortKey = -_rank_of(output)
        context.addLayerToLoadOnCompletion(path, details)


def arrange(run: str, project: QgsProject | None = None) -> None:
    """Put the layers of a run that stand side by side in drawing order: breaks over burn frequency over the rest."""
    root = (project or QgsProject.instance()).layerTreeRoot()
    parents = []
    for node in root.findLayers():
        if _belongs(node, run) and node.parent() not in parents:
            parents.append(node.parent())
    for parent in parents:
        for start, row in _rows(parent.children(), run):
            ordered = sorted(row, key=lambda node: int(node.layer().customProperty(_RANK)))
            if ordered != row:
                parent.insertChildNodes(start, [node.clone() for node in ordered])
                parent.removeChildren(start + len(row), len(row))


def _rank_of(output: str) -> int:
    return DRAWING_ORDER.index(output) if output in DRAWING_ORDER else len(DRAWING_ORDER)


def _belongs(node: QgsLayerTreeNode, run: str) -> bool:
    layer = node.layer() if isinstance(node, QgsLayerTreeLayer) else None
    return layer is not None and layer.customProperty(_RUN) == run


def _rows(nodes: list[QgsLayerTreeNode], run: str) -> list[tuple[int, list[QgsLayerTreeLayer]]]:
    """Return (place, nodes) of every unbroken row of layers of a run."""
    rows: list[tuple[int, list[QgsLayerTreeLayer]]] = []
    for place, node in enumerate(nodes):
        if not _belongs(node, run):
            continue
        if rows and rows[-1][0] + len(rows[-1][1]) == place:
            rows[-1][1].append(node)
        else:
            rows.append((place, [node]))
    return rows
