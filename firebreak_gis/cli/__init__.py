"""The command line: one file a command, each parses, calls one function and writes."""

from __future__ import annotations

import sys

from firebreak_gis.cli.group import firebreak

__all__ = ["firebreak", "main"]


def main() -> None:
    """Run the command line and exit."""
    sys.exit(firebreak.main(prog_name="firebreak", standalone_mode=True))
