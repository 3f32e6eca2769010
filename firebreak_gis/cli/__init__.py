"""The command line: one file a command, each parses, calls one function and writes."""

from __future__ import annotations

import gc
import os

from firebreak_gis.cli.group import ENDED, firebreak, hush, stand_streams
from firebreak_gis.errors import Cancelled

__all__ = ["firebreak", "main"]


def main() -> None:
    """Run the command line and exit."""
    stand_streams()
    try:
        firebreak.main(prog_name="firebreak", standalone_mode=True)
    except SystemExit as stop:
        hush()
        if isinstance(stop.code, int) and stop.code >= min(Cancelled.exit_code, ENDED):
            # Threads may still be inside a kernel; nobody waits for what was cancelled.
            os._exit(stop.code)
        raise
    finally:
        # The interpreter looks through all objects of all libraries as it ends, a third of a second for nothing.
        gc.freeze()
