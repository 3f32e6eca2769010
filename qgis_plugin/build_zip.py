#!/usr/bin/env python3
"""Build the plugin's zip for the QGIS plugin manager: the same bytes from the same files.

For yourself and your colleagues: ``python qgis_plugin/build_zip.py [--output DIR]``. For the plugin repository, which
wants to know where the project lives and who answers:
``python qgis_plugin/build_zip.py --release --repository https://... --email somebody@...``.
"""

from __future__ import annotations

import argparse
import re
import subprocess  # nosec B404 # pip is a program of its own
import sys
import zipfile
from collections.abc import Mapping
from configparser import ConfigParser
from pathlib import Path

HERE = Path(__file__).resolve().parent
PLUGIN = HERE / "firebreak"
FIXED_DATE = (2000, 1, 1, 0, 0, 0)
SKIPPED_FOLDERS = {"__pycache__"}
SKIPPED_SUFFIXES = {".pyc", ".pyo", ".xml"}
ADDRESSES = ("repository", "homepage", "documentation", "tracker", "email")
#: Stands in metadata.txt in the place of addresses that only the publisher knows.
PLACEHOLDER = "example.org"


class ReleaseError(ValueError):
    """The zip would be refused by the plugin repository."""


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


def metadata(addresses: Mapping[str, str]) -> str:
    """Return the text of metadata.txt with the addresses put in."""
    text = (PLUGIN / "metadata.txt").read_text(encoding="utf-8")
    for key, value in addresses.items():
        text = re.sub(rf"(?m)^{key}=.*$", lambda _, line=f"{key}={value}": line, text)
    return text


def values(text: str) -> dict[str, str]:
    """Return the entries of a metadata.txt."""
    parser = ConfigParser(interpolation=None)
    parser.read_string(text)
    return dict(parser["general"])


def require_addresses(text: str) -> None:
    """Refuse a metadata.txt whose addresses are missing or placeholders.

    Raises
    ------
    ReleaseError
        Naming them.
    """
    found = values(text)
    missing = [key for key in ADDRESSES if not _is_address(key, found.get(key, ""))]
    if missing:
        options = " ".join(f"--{key} ..." for key in missing)
        raise ReleaseError(f"a release needs real addresses; give {options} (https://, an e-mail address)")


def _is_address(key: str, value: str) -> bool:
    pattern = r"[^@\s]+@[^@\s]+\.\w+" if key == "email" else r"https://[^/\s]+\.[^/\s]+(/\S*)?"
    return PLACEHOLDER not in value and re.fullmatch(pattern, value) is not None


def build(folder: Path, addresses: Mapping[str, str] | None = None, *, release: bool = False) -> Path:
    """Write the zip into a folder and return its path.

    Parameters
    ----------
    folder
        Made if it is not there.
    addresses
        Entries of metadata.txt to set: repository, homepage, documentation, tracker, email.
    release
        Whether the zip is for the plugin repository.

    Raises
    ------
    ReleaseError
        If it is, and an address is missing.
    """
    text = metadata(addresses or {})
    if release:
        require_addresses(text)
    folder.mkdir(parents=True, exist_ok=True)
    target = folder / f"{PLUGIN.name}.{values(text)['version']}.zip"
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for path in files():
            entry = zipfile.ZipInfo(path.relative_to(HERE).as_posix(), FIXED_DATE)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, text.encode() if path.name == "metadata.txt" else path.read_bytes())
    return target


def build_wheel(folder: Path) -> None:
    """Put a wheel of the engine into a folder: what *Make engine* takes as its package.

    Raises
    ------
    ReleaseError
        If pip cannot build it.
    """
    command = [
        sys.executable,
        "-m",
        "pip",
        "wheel",
        "--quiet",
        "--no-deps",
        "--wheel-dir",
        str(folder),
        str(HERE.parent),
    ]
    if subprocess.run(command, check=False).returncode != 0:
        raise ReleaseError("pip could not build the wheel; its words are above")


def main() -> None:
    """Run from the command line."""
    parser = argparse.ArgumentParser(description="Build the plugin's zip.")
    parser.add_argument("--output", type=Path, default=HERE / "dist", help="folder to write into")
    parser.add_argument("--release", action="store_true", help="for the plugin repository: refuse missing addresses")
    parser.add_argument("--repository", help="where the source is, https://...")
    parser.add_argument("--homepage", help="by default the repository")
    parser.add_argument("--documentation", help="where the pages of docs/ are, by default the homepage with /docs")
    parser.add_argument("--tracker", help="by default the repository with /issues")
    parser.add_argument("--email", help="of who answers")
    parser.add_argument("--wheel", action="store_true", help="put a wheel of the engine beside the zip")
    given = vars(parser.parse_args())
    if given["repository"]:
        given["homepage"] = given["homepage"] or given["repository"]
        given["documentation"] = given["documentation"] or given["homepage"].rstrip("/") + "/docs"
        given["tracker"] = given["tracker"] or given["repository"].rstrip("/") + "/issues"
    try:
        addresses = {key: given[key] for key in ADDRESSES if given[key]}
        print(build(given["output"], addresses, release=given["release"]))  # noqa: T201
        if given["wheel"]:
            build_wheel(given["output"])
    except ReleaseError as error:
        sys.exit(f"Error: {error}")


if __name__ == "__main__":
    main()
