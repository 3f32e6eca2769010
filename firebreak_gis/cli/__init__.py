"""The command line: one file a command, each parses, calls one function and writes."""

from __future__ import annotations

import gc
import os
import sys

from firebreak_gis.cli.group import firebreak
from firebreak_gis.errors import Cancelled

__all__ = ["firebreak", "main"]


def main() -> None:
    """Run the command line and exit."""
    try:
        firebreak.main(prog_name="firebreak", standalone_mode=True)
    except SystemExit as stop:
        if stop.code == Cancelled.exit_code:
            # Threads may still be inside a kernel; nobody waits for what was cancelled.
            sys.stdout.flush()
            sys.stderr.flush()
            os._exit(Cancelled.exit_code)
        raise
    finally:
        # The interpreter looks through all objects of all libraries as it ends, a third of a second for nothing.
        gc.freeze()
