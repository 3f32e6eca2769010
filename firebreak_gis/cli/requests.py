"""From the options of a command to typed requests, and to what `run.json` keeps of them."""

from __future__ import annotations

import dataclasses
import functools
from collections.abc import Callable
from typing import Any, TypeVar

import click

F = TypeVar("F", bound=Callable[..., Any])

#: Options that do not shape the result.
_TRANSIENT = frozenset(
    (
        *("output", "overwrite", "max_memory", "creation_options", "dry_run", "workers", "scheduler", "resume"),
        *("as_json", "progress_mode", "verbose", "quiet"),
    )
)
_TYPED = "firebreak_gis.typed"


def built(**parts: type[Any]) -> Callable[[F], F]:
    """Hand a command typed requests in place of single options; goes right above the function.

    `@built(fires=FireRequest)` calls the command with `fires=FireRequest(...)`, every field of which takes the option
    of its name. Fields without an option keep their default, several requests may take the same option, and options
    that are no field are handed on as they are.
    """

    def decorate(command: F) -> F:
        @functools.wraps(command)
        def wrapper(*args: Any, **kwargs: Any) -> Any:
            names = {part: [f.name for f in dataclasses.fields(kind)] for part, kind in parts.items()}
            requests = {
                part: kind(**{name: kwargs[name] for name in names[part] if name in kwargs})
                for part, kind in parts.items()
            }
            taken = {name for fields in names.values() for name in fields}
            return command(*args, **{k: v for k, v in kwargs.items() if k not in taken}, **requests)

        return wrapper  # type: ignore[return-value]

    return decorate


def note(ctx: click.Context | None, param: click.Parameter | None, value: Any) -> None:
    """Remember what was typed for an option whose value is converted."""
    if ctx is not None and param is not None:
        ctx.meta.setdefault(_TYPED, {})[param.name] = value


def recorded() -> dict[str, Any]:
    """Parameters of the running command worth keeping in `run.json`.

    Those that shape the result, set ones only, as they were typed (numbers as numbers): so the account is a valid
    `--config`.
    """
    ctx = click.get_current_context()
    values = {**ctx.params, **ctx.meta.get(_TYPED, {})}
    return {
        name: value
        for name, value in sorted(values.items())
        if name in ctx.params and name not in _TRANSIENT and value is not None and value not in ((), {})
    }
