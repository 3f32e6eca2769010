"""Options of who does the heavy work, the same for every command that has such; results never depend on them."""

from __future__ import annotations

import functools
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import click

from firebreak_gis.cli import kinds
from firebreak_gis.cli.session import Session
from firebreak_gis.errors import ParameterError

F = TypeVar("F", bound=Callable[..., Any])


def engine(command: F) -> F:
    """--workers, --scheduler, --resume; goes below `options.common`, as parts are kept beside the output."""

    @functools.wraps(command)
    def wrapper(
        *args: Any, session: Session, workers: int | None, scheduler: str | None, resume: bool, **kwargs: Any
    ) -> Any:
        if not (workers or scheduler or resume) or kwargs.get("dry_run"):
            return command(*args, session=session, **kwargs)
        from firebreak_gis.simulation.workers import cluster

        if resume and kwargs["output"] is None:
            raise ParameterError("--resume keeps finished parts beside the output; give --output too")
        keep = parts_beside(Path(kwargs["output"])) if resume else None
        with cluster(workers, scheduler=scheduler, keep=keep, say=session.warn) as made:
            if made.cluster is not None:
                session.detail(f"{made.threads} threads of workers; dashboard: {made.cluster.dashboard}")
            try:
                done = command(*args, session=session, **kwargs)
            except BaseException:
                if made.kept is not None and made.kept.count:
                    session.say(f"Finished parts are kept in {keep}; the same command goes on from there.")
                raise
            if made.kept is not None and made.kept.found:
                session.say(f"{made.kept.found} parts of an earlier run were taken, {made.kept.made} were made.")
            return done

    options = [
        click.option(
            "--workers",
            type=kinds.COUNT,
            metavar="N",
            help="Do the heavy work in so many processes of this machine, each with the data in its own memory (extra "
            "scale) [default: the threads of one process].",
        ),
        click.option(
            "--scheduler",
            metavar="ADDRESS",
            help="Do it on the cluster of this dask scheduler: tcp://HOST:PORT, or its scheduler file (.json).",
        ),
        click.option(
            "--resume",
            is_flag=True,
            help="Keep finished parts beside the output until the end; after a stop the same command goes on from "
            "them. Results are the same.",
        ),
    ]
    for option in reversed(options):
        wrapper = option(wrapper)
    return wrapper  # type: ignore[return-value]


def parts_beside(output: Path) -> Path:
    """Hidden folder for the parts of a run: in its output folder, or beside its output file."""
    from firebreak_gis.files.parts import FOLDER

    asked = click.get_current_context().command.params
    folder = any(p.name == "output" and not isinstance(p.type, kinds.NewFile) for p in asked)
    return output / FOLDER if folder else output.parent / f".{output.name}{FOLDER}"
