"""The Processing provider: all algorithms of the manifest."""

from __future__ import annotations

from pathlib import Path

from qgis.core import QgsApplication, QgsProcessingProvider
from qgis.PyQt.QtGui import QIcon

from . import translation
from .algorithm import FirebreakAlgorithm
from .manifest import descriptions
from .results import VECTOR_FORMATS
from .translation import translate

ICON = Path(__file__).parent / "icons" / "firebreak.svg"


class FirebreakProvider(QgsProcessingProvider):
    """Offers the commands of firebreak_gis in the toolbox, in models and in batch, in the language of QGIS."""

    def __init__(self) -> None:
        super().__init__()
        translation.use(QgsApplication.locale())

    def id(self) -> str:
        """Return the identifier."""
        return "firebreak"

    def name(self) -> str:
        """Return the title."""
        return translate("Firebreak", "Firebreak")

    def longName(self) -> str:  # noqa: N802 - this and the following are named by QGIS
        """Return the title with a few words more."""
        return translate("Firebreak", "Firebreak (plan forest fire breaks)")

    def icon(self) -> QIcon:
        """Return the picture in the toolbox."""
        return QIcon(str(ICON))

    def svgIconPath(self) -> str:  # noqa: N802
        """Return the path of the picture."""
        return str(ICON)

    def loadAlgorithms(self) -> None:  # noqa: N802
        """Add one algorithm a command."""
        for description in descriptions():
            self.addAlgorithm(FirebreakAlgorithm(description))

    def supportedOutputRasterLayerExtensions(self) -> list[str]:  # noqa: N802
        """Return the one raster format that the engine writes."""
        return ["tif"]

    def supportedOutputVectorLayerExtensions(self) -> list[str]:  # noqa: N802
        """Return the vector formats that the forms offer."""
        return list(VECTOR_FORMATS)

    def defaultRasterFileExtension(self) -> str:  # noqa: N802
        """Return the extension of temporary rasters."""
        return "tif"

    def defaultVectorFileExtension(self, hasGeometry: bool = True) -> str:  # noqa: N802, ARG002
        """Return the extension of temporary vectors."""
        return "gpkg"

    def supportsNonFileBasedOutput(self) -> bool:  # noqa: N802
        """Outputs are files."""
        return False
