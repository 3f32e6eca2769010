#!/usr/bin/env python3
"""Build the plugin's zip for the QGIS plugin manager: the same bytes from the same files.

Run it as ``python qgis_plugin/build_zip.py [--output DIR]``.
"""

from __future__ import annotations

import argparse
import zipfile
from configparser import ConfigParser
from pathlib import Path

HERE = Path(__file__).resolve().parent
PLUGIN = HERE / "firebreak"
FIXED_DATE = (2000, 1, 1, 0, 0, 0)
SKIPPED_FOLDERS = {"__pycache__"}
SKIPPED_SUFFIXES = {".pyc", ".pyo", ".xml"}


def files() -> list[Path]:
    """Return the files that belong into the zip, sorted."""
    found = (path for path in PLUGIN.rglob("*") if path.is_file())
    return sorted(
        path
        for path in found
        if not SKIPPED_FOLDERS & set(path.parts)
        and path.suffix not in SKIPPED_SUFFIXES
        and not path.name.startswith(".")
    )


def version() -> str:
    """Return the version of the plugin."""
    metadata = ConfigParser(interpolation=None)
    metadata.read(PLUGIN / "metadata.txt", encoding="utf-8")
    return metadata["general"]["version"]


def build(folder: Path) -> Path:
    """Write the zip into a folder and return its path."""
    folder.mkdir(parents=True, exist_ok=True)
    target = folder / f"{PLUGIN.name}.{version()}.zip"
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for path in files():
            entry = zipfile.ZipInfo(path.relative_to(HERE).as_posix(), FIXED_DATE)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, path.read_bytes())
    return target


def main() -> None:
    """Run from the command line."""
    parser = argparse.ArgumentParser(description="Build the plugin's zip.")
    parser.add_argument("--output", type=Path, default=HERE / "dist", help="folder to write into")
    print(build(parser.parse_args().output))  # noqa: T201


if __name__ == "__main__":
    main()
