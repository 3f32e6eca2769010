"""The plugin's settings, and the look-up of the engine with them."""

from __future__ import annotations

from pathlib import Path

from qgis.core import QgsApplication, QgsSettings

from .engine.environment import proxy_address
from .engine.lookup import Engine, Places, find_engine

_ENGINE = "firebreak/engine"
_PACKAGE = "firebreak/package"


def engine_setting() -> str:
    """Return the path of the engine that the user chose, empty for none."""
    return str(QgsSettings().value(_ENGINE, "") or "")


def set_engine_setting(path: str) -> None:
    """Keep the path of the engine."""
    QgsSettings().setValue(_ENGINE, path)


def package_setting(default: str) -> str:
    """Return what pip shall install."""
    return str(QgsSettings().value(_PACKAGE, "") or default)


def set_package_setting(package: str) -> None:
    """Keep what pip shall install."""
    QgsSettings().setValue(_PACKAGE, package)


def proxy() -> str:
    """Return the address of the proxy that QGIS is set to use, empty for none."""
    kept = QgsSettings()

    def value(key: str) -> str:
        return str(kept.value(f"proxy/{key}", "") or "")

    return proxy_address(
        enabled=value("proxyEnabled"),
        kind=value("proxyType"),
        host=value("proxyHost"),
        port=value("proxyPort"),
        user=value("proxyUser"),
        password=value("proxyPassword"),
    )


def made_folder() -> Path:
    """Return the folder of the environment that the plugin makes, inside the user's QGIS profile."""
    return Path(QgsApplication.qgisSettingsDirPath()) / "firebreak_engine"


def current_engine() -> Engine:
    """Find the engine; raises `EngineMissingError`."""
    return find_engine(Places(setting=engine_setting(), made=made_folder()))
