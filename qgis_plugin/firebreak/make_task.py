"""Making an engine in the background of the desktop."""

from __future__ import annotations

from pathlib import Path

from qgis.core import Qgis, QgsMessageLog, QgsTask
from qgis.PyQt.QtCore import pyqtSignal

from .engine.errors import EngineCancelledError, EngineError
from .engine.making import make_engine
from .translation import translate


class MakeEngineTask(QgsTask):
    """Makes an environment with the engine.

    Parameters
    ----------
    folder
        Of the environment.
    base
        Interpreter to make it from, None to look for one.
    package
        What pip shall install.
    proxy
        Through which pip reaches the index, empty for none.
    """

    said = pyqtSignal(str)
    ended = pyqtSignal(str)

    def __init__(self, folder: Path, base: Path | None, package: str, proxy: str) -> None:
        super().__init__(translate("Firebreak", "Making the engine of Firebreak"))
        self._arguments = (folder, base, package, proxy)
        self._text = ""

    def run(self) -> bool:
        """Do the work, on a thread of QGIS."""
        folder, base, package, proxy = self._arguments
        try:
            version = make_engine(
                folder, base=base, package=package, proxy=proxy, report=self._report, cancelled=self.isCanceled
            )
        except (EngineError, EngineCancelledError, OSError) as error:
            self._text = str(error)
            return False
        self._text = translate("Firebreak", "firebreak_gis {} is ready.").format(version)
        return True

    def finished(self, result: bool) -> None:
        """Tell the outcome, on the main thread."""
        level = Qgis.MessageLevel.Success if result else Qgis.MessageLevel.Warning
        QgsMessageLog.logMessage(self._text, "Firebreak", level)
        self.ended.emit(self._text)

    def _report(self, share: float, text: str) -> None:
        self.setProgress(100.0 * share)
        self.said.emit(text)
