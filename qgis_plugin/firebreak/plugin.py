"""The plugin as QGIS loads it: the provider, and in the desktop the settings page."""

from __future__ import annotations

from typing import Any

from qgis.core import QgsApplication
from qgis.PyQt.QtGui import QIcon
from qgis.PyQt.QtWidgets import QAction

from .provider import ICON, FirebreakProvider
from .translation import translate


class FirebreakPlugin:
    """Registers the provider and the settings page.

    Parameters
    ----------
    iface
        The desktop, None under `qgis_process`.
    """

    def __init__(self, iface: Any) -> None:
        self._iface = iface
        self._provider: FirebreakProvider | None = None
        self._factory: Any = None
        self._action: QAction | None = None

    def initProcessing(self) -> None:  # noqa: N802 - this and `initGui` are named by QGIS
        """Register the provider; all that `qgis_process` needs."""
        self._provider = FirebreakProvider()
        QgsApplication.processingRegistry().addProvider(self._provider)

    def initGui(self) -> None:  # noqa: N802
        """Register the provider, the settings page and the entry in the menu."""
        from .options import OptionsFactory

        self.initProcessing()
        self._factory = OptionsFactory()
        self._iface.registerOptionsWidgetFactory(self._factory)
        text = translate("Firebreak", "Firebreak settings…")
        self._action = QAction(QIcon(str(ICON)), text, self._iface.mainWindow())
        self._action.triggered.connect(self._show_settings)
        self._iface.addPluginToMenu("Firebreak", self._action)

    def unload(self) -> None:
        """Take everything back."""
        if self._action is not None:
            self._iface.removePluginMenu("Firebreak", self._action)
            self._action = None
        if self._factory is not None:
            self._iface.unregisterOptionsWidgetFactory(self._factory)
            self._factory = None
        if self._provider is not None:
            QgsApplication.processingRegistry().removeProvider(self._provider)
            self._provider = None

    def _show_settings(self) -> None:
        from .options import PAGE

        self._iface.showOptionsDialog(self._iface.mainWindow(), PAGE)
