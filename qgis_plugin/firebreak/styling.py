"""Styles and drawing order of the layers that an algorithm adds to the map."""

from __future__ import annotations

import contextlib
from dataclasses import dataclass
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

from .manifest import Output
from .names import DRAWING_ORDER
from .texts import translated

_STYLES = Path(__file__).with_name("styles")
_RANK, _RUN = "firebreak/drawing_rank", "firebreak/run"

#: QGIS keeps no reference to post-processors, so the last ones made are kept here.
_alive: list[QgsProcessingLayerPostProcessorInterface] = []
_KEPT = 64


@dataclass(frozen=True)
class Run:
    """What all layers of one run have in common: a mark, the title of their group, and metadata."""

    mark: str
    title: str
    about: str
    history: tuple[str, ...]


class Styler(QgsProcessingLayerPostProcessorInterface):
    """Gives a new layer its style and its place among the others of its run.

    Parameters
    ----------
    output
        The output that it is.
    run
        The run that made it.
    """

    def __init__(self, output: Output, run: Run) -> None:
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
        own = _STYLES / f"{self._output.name.lower()}.qml"
        style = next((path for path in (own, beside) if path.is_file()), None)
        if isinstance(layer, QgsVectorLayer) and style != own:
            layer.loadDefaultStyle()  # the one inside the GeoPackage
        elif style is not None:
            layer.loadNamedStyle(str(style))
        layer.triggerRepaint()
        layer.setCustomProperty(_RUN, self._run.mark)
        layer.setCustomProperty(_RANK, _rank_of(self._output.name))
        self._describe(layer)
        # The layer enters the tree of layers after this call.
        QTimer.singleShot(0, partial(arrange, self._run.mark, self._run.title))

    def _describe(self, layer: QgsMapLayer) -> None:
        """Say in the layer's metadata what it is and what made it."""
        metadata = layer.metadata()
        metadata.setTitle(translated(self._output.label))
        metadata.setAbstract(self._run.about)
        metadata.setHistory(list(self._run.history))
        layer.setMetadata(metadata)


def style_later(output: Output, path: str, run: Run, context: QgsProcessingContext) -> None:
    """Have a layer styled when QGIS loads it, if it will."""
    if context.willLoadLayerOnCompletion(path):
        details = context.layerToLoadOnCompletionDetails(path)
        details.setPostProcessor(Styler(output, run))
        with contextlib.suppress(AttributeError):  # later releases sort by themselves
            details.layerSortKey = -_rank_of(output.name)
        context.addLayerToLoadOnCompletion(path, details)


def arrange(run: str, title: str, project: QgsProject | None = None) -> None:
    """Put the layers of a run into one group, in drawing order: breaks over burn frequency over the rest."""
    root = (project or QgsProject.instance()).layerTreeRoot()
    nodes = [node for node in root.findLayers() if _belongs(node, run)]
    if len(nodes) < 2:
        return
    group = next((g for g in root.findGroups(True) if g.customProperty(_RUN) == run), None)
    if group is None:
        parent = nodes[0].parent()
        group = parent.insertGroup(parent.children().index(nodes[0]), title)
        group.setCustomProperty(_RUN, run)
    ordered = sorted(nodes, key=lambda node: int(node.layer().customProperty(_RANK)))
    if ordered != group.children():
        group.insertChildNodes(0, [node.clone() for node in ordered])
        for node in nodes:
            node.parent().removeChildNode(node)
        for opened in (False, True):  # the tree of layers may have opened the group while it was empty
            group.setExpanded(opened)


def _rank_of(output: str) -> int:
    return DRAWING_ORDER.index(output) if output in DRAWING_ORDER else len(DRAWING_ORDER)


def _belongs(node: QgsLayerTreeNode, run: str) -> bool:
    layer = node.layer() if isinstance(node, QgsLayerTreeLayer) else None
    return layer is not None and layer.customProperty(_RUN) == run
