"""Options of fires with a clock, embers and breaks that fail; `simulation.request.FireRequest` has their fields."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any, TypeVar

import click

from firebreak_gis.cli import kinds
from firebreak_gis.cli.stakes_options import roads

F = TypeVar("F", bound=Callable[..., Any])


def judging(command: F) -> F:
    """The fires that plans are judged by: `clock` and `holding`, assumed where nothing is said, and --timeless."""
    timeless = click.option(
        "--timeless",
        is_flag=True,
        help="Fires end by themselves and breaks hold in every fire unless --hold says otherwise, as in the paper.",
    )
    assumed = "lognormal:8h,0.7, an assumption"
    return clock(holding(timeless(command), default="0.47, an assumption"), default=assumed)


def clock(command: F, *, default: str = "until they end by themselves") -> F:
    """--duration, --ignition-times, --embers, --containment."""
    return _apply(
        [
            click.option(
                "--duration",
                type=kinds.DURATION,
                metavar="TIME",
                help="How long fires burn: 8h, a list that the runs take in turn (4h,8h), lognormal:8h,0.7 (median and "
                f"sigma), uniform:2h,12h, or weather [default: {default}].",
            ),
            click.option(
                "--ignition-times",
                metavar="COLUMN",
                help="Column of the ignitions that tells when each is lit, in hours after the start of the run.",
            ),
            click.option(
                "--embers",
                type=kinds.EMBERS,
                metavar="on|NAME=VALUE,...",
                help="Embers that fly ahead of the fire: on, or numbers such as rate=12,longest=1000 in place of the "
                "assumed ones.",
            ),
            click.option(
                "--containment",
                type=kinds.CONTAINMENT,
                metavar="TIME|attack:TIME",
                help="When crews contain each fire: a time or a distribution as for --duration, or a direct attack at "
                "such a time, which fails if the fire is too large or too fierce by then: "
                "attack:1h;size=4;intensity=4000;intense=1 (ha, kW/m, ha above it) [default: never].",
            ),
        ],
        command,
    )


def holding(command: F, *, default: str = "always") -> F:
    """--hold, --barriers-hold, and the crews that breaks wait for: --stations, --roads, --crew-travel."""
    return _apply(
        [
            click.option(
                "--hold",
                type=kinds.HOLD,
                metavar="SHARE|flame",
                help="How often a stretch of break holds in a run: a share (0.47 in the field), flame (by width and "
                "the intensity of the fire, Wilson 1988) or flame:flames (1.5 flame lengths); stretches have 400 m, "
                f"or as in 0.47:800 [default: {default}].",
            ),
            click.option(
                "--barriers-hold",
                type=kinds.SHARE_OF_RUNS,
                default=1.0,
                show_default=True,
                help="Share of runs in which a stretch of the barriers holds; drawn apart from the breaks.",
            ),
            click.option(
                "--stations",
                type=kinds.VECTOR_OR_RASTER,
                metavar="PATH",
                help="Points or areas that crews set out from: a stretch of break holds only against fire that comes "
                "after them [default: crews are everywhere].",
            ),
            roads,
            click.option(
                "--crew-travel",
                type=kinds.TRAVEL,
                metavar="NAME=VALUE,...",
                help="How they travel: speed on roads and off them in km/h, and minutes from the start of the fire "
                "until they leave [default: road=40,off=3,delay=10, assumptions].",
            ),
        ],
        command,
    )


def window(command: F) -> F:
    """--window."""
    return click.option(
        "--window",
        type=kinds.COUNT,
        metavar="CELLS",
        help="Read the map by windows of this side (a power of two, such as 512) around each fire, larger where a fire "
        "needs it, so that maps larger than the memory can burn; the fires are the same.",
    )(command)


def products(command: F) -> F:
    """--products and what goes into it; other runs are kept out of the folder while the command writes."""

    @functools.wraps(command)
    def wrapper(*args: Any, **kwargs: Any) -> Any:
        from firebreak_gis.files import claiming

        if kwargs["products"] is None:
            return command(*args, **kwargs)
        with claiming(kwargs["products"], folder=True):
            return command(*args, **kwargs)

    return _apply(  # type: ignore[return-value]
        [
            click.option(
                "--products",
                type=click.Path(file_okay=False),
                metavar="DIR",
                help="Also write, into this folder: how often each cell has burnt by --by, median and 10 % arrival "
                "time, isochrones, how often it burns in fires of each of --size-classes and with flames above "
                "--flame-lengths, the main paths of the fire, and the table of fires.",
            ),
            click.option(
                "--by", type=kinds.TIMES, default="2h,4h,8h,24h", show_default=True, help="Times for --products."
            ),
            click.option(
                "--size-classes",
                type=kinds.NUMBERS,
                default="10,100,1000",
                show_default=True,
                help="Limits of the classes of fire sizes for --products, in hectares.",
            ),
            click.option(
                "--flame-lengths",
                type=kinds.NUMBERS,
                default="1.2,2.5,3.5",
                show_default=True,
                help="Flame lengths for --products, in metres; left out if the network knows no heat.",
            ),
        ],
        wrapper,
    )


def _apply(options: list[Callable[[Any], Any]], command: F) -> F:
    for option in reversed(options):
        command = option(command)
    return command
