"""Lists of the forms: words to read, while the engine gets its own.

The value of a parameter is the engine's word, in scripts, in models and in batches, whatever the language of QGIS.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from processing.gui.wrappers import WidgetWrapper
from qgis.gui import QgsGui
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtWidgets import QComboBox, QListWidget, QListWidgetItem, QWidget

from . import enums
from .translation import translate

_SHORTEST = 24  # letters of a list that must fit; the longest would widen the form, and are seen when it opens
_LINES = 7  # of a list with several choices


class ChoiceWidget(WidgetWrapper):
    """The list of an enum parameter; QGIS makes it where the parameter's metadata names it.

    Parameters
    ----------
    words
        What is shown for each option of the parameter, in their order.
    """

    def __new__(cls, param: Any, dialog: Any, row: int = 0, col: int = 0, words: Sequence[str] = ()) -> Any:  # noqa: ARG004
        """Leave it to QGIS in the modeler, where a value may come from elsewhere; only its list is made readable."""
        if type(dialog).__name__ != "ModelerParametersDialog":
            return super().__new__(cls)
        widget = QgsGui.processingGuiRegistry().createModelerParameterWidget(
            dialog.model, dialog.childId, param, dialog.context
        )
        widget.setDialog(dialog)
        shown = dict(zip(param.options(), words))  # noqa: B905 - QGIS may run Python 3.9
        for combo in widget.findChildren(QComboBox):
            for place in range(combo.count()):
                combo.setItemText(place, shown.get(combo.itemData(place), combo.itemText(place)))
        return widget

    def createWidget(self, words: Sequence[str] = ()) -> QWidget:  # noqa: N802 - this and the following are named by QGIS
        """Return the list."""
        definition = self.parameterDefinition()
        options = list(zip(definition.options(), words))  # noqa: B905
        if definition.allowMultiple():
            several = QListWidget()
            for option, word in options:
                item = QListWidgetItem(word)
                item.setData(Qt.ItemDataRole.UserRole, option)
                item.setToolTip(word)
                item.setCheckState(Qt.CheckState.Unchecked)
                several.addItem(item)
            several.setFixedHeight(_LINES * several.sizeHintForRow(0) + 2 * several.frameWidth())
            several.itemChanged.connect(lambda _: self.widgetValueHasChanged.emit(self))
            return several
        one = QComboBox()
        one.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        one.setMinimumContentsLength(_SHORTEST)
        if definition.flags() & enums.OPTIONAL:
            one.addItem(translate("Firebreak", "[not chosen]"), None)
        for option, word in options:
            one.addItem(word, option)
            one.setItemData(one.count() - 1, word, Qt.ItemDataRole.ToolTipRole)
        one.view().setMinimumWidth(one.view().sizeHintForColumn(0) + 2 * one.iconSize().width())
        one.currentIndexChanged.connect(lambda _: self.widgetValueHasChanged.emit(self))
        return one

    def setValue(self, value: Any) -> None:  # noqa: N802
        """Show a value: the engine's word, or several."""
        if isinstance(self.widget, QComboBox):
            self.widget.setCurrentIndex(max(0, self.widget.findData(value)))
            return
        chosen = value.split(",") if isinstance(value, str) else list(value or ())
        for item in self._items():
            wanted = item.data(Qt.ItemDataRole.UserRole) in chosen
            item.setCheckState(Qt.CheckState.Checked if wanted else Qt.CheckState.Unchecked)

    def value(self) -> Any:
        """Return the engine's word, or a list of them."""
        if isinstance(self.widget, QComboBox):
            return self.widget.currentData()
        checked = (item for item in self._items() if item.checkState() == Qt.CheckState.Checked)
        return [item.data(Qt.ItemDataRole.UserRole) for item in checked]

    def _items(self) -> list[QListWidgetItem]:
        return [self.widget.item(row) for row in range(self.widget.count())]
