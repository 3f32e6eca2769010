"""The settings page: which engine is used, whether it answers, and a button that makes one."""

from __future__ import annotations

from pathlib import Path

from qgis.core import QgsApplication
from qgis.gui import QgsFileWidget, QgsOptionsPageWidget, QgsOptionsWidgetFactory
from qgis.PyQt.QtGui import QIcon
from qgis.PyQt.QtWidgets import (
    QFormLayout,
    QGroupBox,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPlainTextEdit,
    QProgressBar,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from . import settings
from .engine.errors import EngineMissingError
from .engine.lookup import forget
from .engine.making import PACKAGE
from .make_task import MakeEngineTask
from .provider import ICON
from .translation import translate

#: Object name by which `iface.showOptionsDialog` finds the page.
PAGE = "firebreakOptions"
_MOST_LINES = 2000


class OptionsFactory(QgsOptionsWidgetFactory):
    """Makes the page when the options dialog opens."""

    def __init__(self) -> None:
        super().__init__()
        self.setTitle("Firebreak")

    def icon(self) -> QIcon:
        """Return the picture in the list of pages."""
        return QIcon(str(ICON))

    def createWidget(self, parent: QWidget | None) -> QgsOptionsPageWidget:  # noqa: N802 - named by QGIS
        """Return the page."""
        return OptionsPage(parent)


class OptionsPage(QgsOptionsPageWidget):
    """The page."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName(PAGE)
        self._task: MakeEngineTask | None = None
        layout = QVBoxLayout(self)
        layout.addWidget(self._engine_group())
        layout.addWidget(self._making_group())
        layout.addStretch()
        self._show_engine()

    def apply(self) -> None:
        """Keep what was entered."""
        settings.set_engine_setting(self._engine.filePath().strip())
        settings.set_package_setting(self._package.text().strip())
        forget()

    def _engine_group(self) -> QGroupBox:
        group = QGroupBox(translate("Firebreak", "Engine"))
        form = QFormLayout(group)
        self._engine = QgsFileWidget()
        self._engine.setFilePath(settings.engine_setting())
        self._engine.setDialogTitle(translate("Firebreak", "Python with firebreak_gis, or the firebreak program"))
        self._engine.lineEdit().setPlaceholderText(translate("Firebreak", "empty: found by itself"))
        form.addRow(translate("Firebreak", "Python or program"), self._engine)
        check = QPushButton(translate("Firebreak", "Check"))
        check.clicked.connect(self._check)
        self._status = QLabel()
        self._status.setWordWrap(True)
        form.addRow(check, self._status)
        return group

    def _making_group(self) -> QGroupBox:
        group = QGroupBox(translate("Firebreak", "Make an engine"))
        form = QFormLayout(group)
        text = QLabel(
            translate(
                "Firebreak",
                "Makes a Python environment in your QGIS profile, about 900 MB, and installs firebreak_gis into it: "
                "from the package index (through the proxy of QGIS), or from the path of a clone or a wheel. The "
                "Python of QGIS is left alone, and an engine made before stays until the new one answers. "
                "Nothing is installed until you press the button.",
            )
        )
        text.setWordWrap(True)
        form.addRow(text)
        self._base = QgsFileWidget()
        self._base.lineEdit().setPlaceholderText(translate("Firebreak", "empty: the newest of 3.11 to 3.13 found"))
        form.addRow(translate("Firebreak", "Python to make it from"), self._base)
        self._package = QLineEdit(settings.package_setting(""))
        self._package.setPlaceholderText(PACKAGE)
        self._package.setToolTip(translate("Firebreak", "A name in the index, or the path of a clone or a wheel."))
        form.addRow(translate("Firebreak", "Package"), self._package)
        self._make = QPushButton(translate("Firebreak", "Make engine"))
        self._make.clicked.connect(self._start)
        self._stop = QPushButton(translate("Firebreak", "Cancel"))
        self._stop.setEnabled(False)
        self._stop.clicked.connect(self._cancel)
        buttons = QHBoxLayout()
        self._bar = QProgressBar()
        self._bar.setRange(0, 100)
        for widget in (self._make, self._stop, self._bar):
            buttons.addWidget(widget)
        form.addRow(buttons)
        self._log = QPlainTextEdit()
        self._log.setReadOnly(True)
        self._log.setMaximumBlockCount(_MOST_LINES)
        form.addRow(self._log)
        return group

    def _check(self) -> None:
        self.apply()
        self._show_engine()

    def _show_engine(self) -> None:
        try:
            engine = settings.current_engine()
        except EngineMissingError as error:
            self._status.setText(str(error))
            return
        text = translate("Firebreak", "firebreak_gis {} answers: {} ({})")
        self._status.setText(text.format(engine.version, engine.command[0], engine.origin))

    def _start(self) -> None:
        settings.set_package_setting(self._package.text().strip())
        base = self._base.filePath().strip()
        self._log.clear()
        self._task = MakeEngineTask(
            settings.made_folder(), Path(base) if base else None, settings.package_setting(PACKAGE), settings.proxy()
        )
        self._task.said.connect(self._log.appendPlainText)
        self._task.progressChanged.connect(lambda percent: self._bar.setValue(int(percent)))
        self._task.ended.connect(self._ended)
        self._switch(running=True)
        QgsApplication.taskManager().addTask(self._task)

    def _cancel(self) -> None:
        if self._task is not None:
            self._task.cancel()

    def _ended(self, text: str) -> None:
        self._task = None
        self._log.appendPlainText(text)
        self._switch(running=False)
        self._show_engine()

    def _switch(self, *, running: bool) -> None:
        self._make.setEnabled(not running)
        self._stop.setEnabled(running)
        self._bar.setValue(0 if running else self._bar.value())
