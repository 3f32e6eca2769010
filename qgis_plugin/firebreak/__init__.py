"""Firebreak: plan forest fire breaks in the QGIS toolbox; firebreak_gis does the work, in its own process."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .plugin import FirebreakPlugin


def classFactory(iface: Any) -> FirebreakPlugin:  # noqa: N802 - named by QGIS
    """Return the plugin."""
    from .plugin import FirebreakPlugin

    return FirebreakPlugin(iface)
