"""What can go wrong between the plugin and the engine."""

from __future__ import annotations


class EngineError(Exception):
    """Root of the errors of this package; the text is meant for the user."""


class EngineMissingError(EngineError):
    """No engine was found, or the one found is too old or broken."""


class EngineFailedError(EngineError):
    """The engine refused the work or died.

    Parameters
    ----------
    message
        What to tell the user.
    kind
        Name of the kind of error that the engine gave, `died` if it gave none.
    exit_code
        Exit code of the process; negative for a signal.
    """

    def __init__(self, message: str, *, kind: str = "died", exit_code: int = 1) -> None:
        super().__init__(message)
        self.kind = kind
        self.exit_code = exit_code


class EngineCancelledError(EngineError):
    """The user asked to stop."""
