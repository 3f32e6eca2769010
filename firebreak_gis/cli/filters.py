"""What of the inputs is taken: --where for features of vector files, --foreign for rankings from elsewhere."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any, TypeVar

import click

from firebreak_gis.cli import kinds
from firebreak_gis.errors import ParameterError
from firebreak_gis.files.sources import filtered

F = TypeVar("F", bound=Callable[..., Any])


foreign = click.option(
    "--foreign",
    is_flag=True,
    help="Take a raster that was not written as a priority all the same: its greatest numbers are cut first.",
)


def where(command: F) -> F:
    """--where, which becomes part of the names of the vector files."""

    @functools.wraps(command)
    def wrapper(*args: Any, where: tuple[str, ...], **kwargs: Any) -> Any:
        return command(*args, **_filtered(kwargs, where))

    return click.option(
        "--where",
        multiple=True,
        metavar="[OPTION=]SQL",
        help="Take only features that fit a condition, e.g. \"barriers=highway = 'primary'\"; the option's name may be "
        "left out if one alone names a vector file. One of several layers is 'FILE|layername=roads'.",
    )(wrapper)  # type: ignore[return-value]


def _filtered(given: dict[str, Any], conditions: tuple[str, ...]) -> dict[str, Any]:
    """Put conditions into the names of the vector files that they are for."""
    from firebreak_gis.vectors import is_vector

    ctx = click.get_current_context()
    names = {
        flag.lstrip("-"): str(param.name)
        for param in ctx.command.params
        if isinstance(param.type, kinds.Kind) and "vector" in param.type.name
        for flag in (*param.opts, param.metavar or "")
    }
    named = {option: given[name] for option, name in names.items() if option and is_vector(given.get(name))}
    one = len({names[option] for option in named}) == 1
    for text in conditions:
        option, equals, condition = text.partition("=")
        option = option.strip().lstrip("-").replace("_", "-")
        if not (equals and option in named):
            option, condition = (next(iter(named)), text) if one else ("", text)
        if not option or not condition.strip():
            raise ParameterError(
                f"--where got {text!r}, expected OPTION=CONDITION with an option that names a vector file"
                + (f" ({', '.join(named)})" if named else "; none is given")
            )
        given[names[option]] = filtered(given[names[option]], condition.strip())
    return given
