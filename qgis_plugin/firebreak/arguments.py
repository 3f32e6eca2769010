"""From the values of a form to the arguments of the command line. Nothing here imports QGIS."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from .manifest import Field


class ArgumentsError(ValueError):
    """The values of a form do not go together; the text is meant for the user."""


def command_arguments(
    command: str,
    names: set[str],
    fields: Sequence[Field],
    values: Mapping[str, Any],
    extra: Mapping[str, str],
) -> list[str]:
    """Return the arguments of one command.

    Parameters
    ----------
    command
        Name of the command.
    names
        Its parameters; fields of others are passed over.
    fields
        Fields of the form, arguments in their order.
    values
        By field name; None or "" where nothing was given.
    extra
        More options (flag to value), and an argument that comes before all others (key "").

    Raises
    ------
    ArgumentsError
        If one option got two different values.
    """
    _refuse_doubles(fields, values)
    _refuse_gaps(fields, values)
    options: list[str] = []
    positional: list[str] = []
    for field in fields:
        value = values.get(field.name)
        if field.option not in names or value is None or value in ("", ()):
            continue
        if not field.flag:
            positional.append(_word(value))
        elif field.kind == "boolean":
            options += [field.flag] if value else []
        elif _as_words(value) == _as_words(field.default):
            continue  # left to the engine, which may know better, as with the wind of a network that has its own
        elif field.multiple:
            for word in str(value).split(";"):
                options += [field.flag, word.strip()] if word.strip() else []
        elif field.kind == "extent":
            options += [field.flag, *(_word(v) for v in value)]
        elif field.kind == "choices":
            options += [field.flag, ",".join(value)]
        else:
            options += [field.flag, _word(value)]
    for flag, value in extra.items():
        if flag:
            options += [flag, value]
        else:
            positional.insert(0, value)
    return [command, *options, "--", *positional]


def _refuse_gaps(fields: Sequence[Field], values: Mapping[str, Any]) -> None:
    """Arguments stand in order, so that none can be left out before another."""
    missing = None
    for field in (f for f in fields if not f.flag):
        given = any(values.get(f.name) not in (None, "") for f in fields if f.option == field.option)
        if not given:
            missing = missing or field
        elif missing is not None:
            raise ArgumentsError(f"{field.name} needs {missing.name} as well.")


def _word(value: Any) -> str:
    return repr(value) if isinstance(value, float) else str(value)


def _alternatives(field: Field, fields: Sequence[Field], values: Mapping[str, Any]) -> list[Field]:
    """Other fields of the same option that were filled in."""
    return [f for f in fields if f.option == field.option and f is not field and values.get(f.name) not in (None, "")]


def _as_words(value: Any) -> str:
    """Return a value as the manifest writes defaults: several choices joined by commas."""
    return ",".join(map(str, value)) if isinstance(value, (list, tuple)) else str(value)


def _refuse_doubles(fields: Sequence[Field], values: Mapping[str, Any]) -> None:
    for field in fields:
        if values.get(field.name) in (None, "") or field.default is not None:
            continue
        for other in _alternatives(field, fields, values):
            if other.default is None:
                raise ArgumentsError(f"Give either {field.name} or {other.name}, not both.")
