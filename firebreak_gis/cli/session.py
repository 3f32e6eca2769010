"""What every command shares while it runs: messages, progress, the result, a stop from outside."""

from __future__ import annotations

import _thread
import contextlib
import json
import sys
import threading
import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import click

from firebreak_gis.errors import Cancelled, OutputError
from firebreak_gis.files.locks import reason
from firebreak_gis.manifest import plain
from firebreak_gis.progress import COMPILING

if TYPE_CHECKING:
    from firebreak_gis.planning.timing import Estimate

_BAR_WIDTH = 24
_REPORT_EVERY = 0.1  # seconds
_REPORT_ANYWAY = 2.0  # though nothing but the time left is new
_COMPILING = "compiling, once on this machine"
#: Work that takes less is not announced [s].
_LONG = 15.0
#: A stop that no report of progress has met within this, as while libraries are loaded, comes as Ctrl-C would [s].
_PATIENCE = 0.5
#: Before so much is done, or has been worked for [s], nobody knows how long the rest takes.
_TOO_EARLY, _TOO_SHORT = 0.02, 1.0


@dataclass
class Session:
    """Talks to the person or program that called a command.

    Parameters
    ----------
    as_json
        The result goes to stdout as one JSON object.
    progress_mode
        `bar` (stderr, only on a terminal), `json` (lines on stdout; `cancel` or the end of stdin stops) or
        `none`.
    verbosity
        -1 quiet, 0 normal, 1 verbose.
    """

    as_json: bool = False
    progress_mode: str = "bar"
    verbosity: int = 0
    _started: float = 0.0
    _last: tuple[float, str, int] = (0.0, "", -1)
    #: Seconds worked and share done when the pace began to count, and the seconds foreseen then.
    _begun: tuple[float, float, float] = (0.0, 0.0, 0.0)
    _stopped: threading.Event = field(default_factory=threading.Event)
    _ended: threading.Event = field(default_factory=threading.Event)

    def __post_init__(self) -> None:
        """Listen for a stop where a program drives us, and for kernels that are compiled."""
        self._started = time.monotonic()
        COMPILING.begun = self._compiling
        if self.progress_mode == "json":
            threading.Thread(target=self._listen, daemon=True).start()

    @property
    def heard(self) -> bool:
        """Whether anybody reads what is said, and how long the work takes."""
        return self.verbosity >= 0 or self.progress_mode == "json"

    def say(self, text: str) -> None:
        """Tell the person something: on stderr, or a program as a line of JSON."""
        if self.verbosity < 0:
            return
        if self.progress_mode == "json":
            self._print_line({"said": text})
        else:
            self._tell(text)

    def detail(self, text: str) -> None:
        """Tell the person something that only -v asks for."""
        if self.verbosity > 0:
            self.say(text)

    def warn(self, text: str) -> None:
        """Tell the person of something that may be wrong; also when quiet."""
        if self.progress_mode == "json":
            self._print_line({"warning": text})
        else:
            self._tell(f"Warning: {text}")

    def foresee(self, estimate: Estimate) -> None:
        """Say how long the work will take, if that is long; the time left is counted from here."""
        done = max(self._last[2], 0) / 100
        self._begun = (self._worked(time.monotonic()), done, estimate.seconds)
        if estimate.seconds >= _LONG:
            self.say(estimate.told())

    def seconds_left(self, fraction: float, now: float) -> float | None:
        """How long the rest takes at the pace so far, the compiling not counted; None while nobody knows."""
        since, done, foreseen = self._begun
        worked = self._worked(now) - since
        if fraction - done > _TOO_EARLY and worked > _TOO_SHORT:
            return worked * (1.0 - fraction) / (fraction - done)
        return max(foreseen - worked, 0.0) if foreseen else None

    def _worked(self, now: float) -> float:
        return now - self._started - COMPILING.seconds

    def close(self) -> None:
        """The command is at its end: there is nothing left to stop."""
        self._ended.set()

    def progress(self, fraction: float, message: str) -> None:
        """Report the share done (0 to 1); raises `Cancelled` once a stop was asked for."""
        if self._stopped.is_set():
            self.close()
            raise Cancelled("stopped as asked; no half-written file was left behind")
        now, percent = time.monotonic(), int(100 * fraction)
        last_time, last_message, last_percent = self._last
        soon = _REPORT_ANYWAY if message == last_message else _REPORT_EVERY
        if percent == last_percent and now - last_time < soon:
            return
        self._last = (now, message, percent)
        if self.progress_mode == "json":
            left = self.seconds_left(fraction, now)
            told = {} if left is None else {"seconds_left": round(left)}
            self._print_line({"progress": round(fraction, 4), "message": message, **told})
        elif self.progress_mode == "bar" and self.verbosity >= 0 and sys.stderr.isatty():
            self._draw_bar(fraction, message, now)

    def finish(self, result: Mapping[str, Any], text: str) -> None:
        """End a command: the result as JSON on stdout, or `text` for people."""
        self.close()
        self._clear_bar()
        if self.as_json or self.progress_mode == "json":
            self._print_line({"result": plain(result)})
        elif self.verbosity >= 0:
            self._print(text)

    def _tell(self, text: str) -> None:
        """Write to stderr; where nobody can read it the work goes on all the same."""
        self._clear_bar()
        with contextlib.suppress(OSError):
            click.echo(text, err=True)

    def _draw_bar(self, fraction: float, message: str, now: float) -> None:
        left = self.seconds_left(fraction, now)
        time_left = "" if left is None else f" {int(left // 60)}:{int(left % 60):02d} left"
        self._write_bar(f"{_bar(fraction)}{time_left}  {message[:60]}")

    def _compiling(self) -> None:
        """Say why nothing moves."""
        _, message, percent = self._last
        if message == _COMPILING:
            return
        self._last = (0.0, _COMPILING, percent)
        if self.progress_mode == "json":
            self._print_line({"progress": max(percent, 0) / 100, "message": _COMPILING})
        elif self.progress_mode == "bar" and self.verbosity >= 0 and sys.stderr.isatty():
            self._write_bar(f"{_bar(max(percent, 0) / 100)}  {_COMPILING}")

    def _clear_bar(self) -> None:
        if self.progress_mode == "bar" and sys.stderr.isatty():
            self._write_bar("")

    def _write_bar(self, text: str) -> None:
        with contextlib.suppress(OSError):
            sys.stderr.write(f"\r\x1b[K{text}")
            sys.stderr.flush()

    def _print_line(self, document: Mapping[str, Any]) -> None:
        self._print(json.dumps(document, ensure_ascii=False))

    def _print(self, text: str) -> None:
        try:
            click.echo(text)
        except OSError as error:
            raise OutputError(f"cannot write to the standard output: {reason(error)}") from error

    def _listen(self) -> None:
        for line in sys.stdin:
            if line.strip() == "cancel":
                break
        # Also at the end of stdin: whoever started us has gone.
        self._stopped.set()
        if not self._ended.wait(_PATIENCE):
            _thread.interrupt_main()


def _bar(fraction: float) -> str:
    filled = int(_BAR_WIDTH * fraction)
    return f"[{'#' * filled}{'-' * (_BAR_WIDTH - filled)}] {100 * fraction:3.0f} %"
