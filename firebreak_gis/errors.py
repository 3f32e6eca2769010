"""Every error that the package raises on purpose, and the exit code of each.

One root, `FirebreakError`; each class also stands under the builtin that a Python programmer would
expect. Callers decide on the class, never on the text. A message says what is wrong, what was got,
what was expected and what to do.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar


class FirebreakError(Exception):
    """Root of all errors raised on purpose.

    Attributes
    ----------
    exit_code
        What the command line exits with.
    kind
        Short stable name, used in machine-readable error reports.
    """

    exit_code: ClassVar[int] = 1
    kind: ClassVar[str] = "error"


class ParameterError(FirebreakError, ValueError):
    """A parameter has an impossible value (exit 2)."""

    exit_code = 2
    kind = "parameter"


class InputError(FirebreakError, ValueError):
    """An input file or array cannot be used as it is (exit 3)."""

    exit_code = 3
    kind = "input"


class CRSError(InputError):
    """A coordinate reference system is missing, impossible or unsuitable (exit 3)."""

    kind = "crs"


class GridError(InputError):
    """Shapes or grids do not fit together (exit 3)."""

    kind = "grid"


class LegendError(InputError):
    """A class code or a legend file cannot be understood (exit 3)."""

    kind = "legend"


class OutputError(FirebreakError, OSError):
    """An output cannot be written, or writing it would destroy something (exit 4)."""

    exit_code = 4
    kind = "output"


class ResourceError(FirebreakError, MemoryError):
    """The work does not fit into memory or on the disk (exit 5)."""

    exit_code = 5
    kind = "resource"


class MissingComponentError(FirebreakError, ImportError):
    """An optional component is not installed (exit 6)."""

    exit_code = 6
    kind = "component"


class VerificationError(FirebreakError, RuntimeError):
    """A result or a written file failed its own check (exit 7)."""

    exit_code = 7
    kind = "verification"


class Cancelled(FirebreakError, RuntimeError):  # noqa: N818 - not an error of anybody's
    """The user asked to stop; nothing half done was left behind (exit 130)."""

    exit_code = 130
    kind = "cancelled"


def raise_together(problems: Sequence[FirebreakError]) -> None:
    """Raise several errors as one that names them all: an `InputError` if one of them is, else a `ParameterError`."""
    if len(problems) == 1:
        raise problems[0]
    if problems:
        kind = InputError if any(isinstance(p, InputError) for p in problems) else ParameterError
        listed = "; ".join(f"({k}) {problem}" for k, problem in enumerate(problems, start=1))
        raise kind(f"{len(problems)} things stand in the way: {listed}")
