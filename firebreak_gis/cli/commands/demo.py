"""firebreak demo: the main job on the sample landscape, and its report in the browser."""

from __future__ import annotations

from pathlib import Path

import click

from firebreak_gis.landscape.samples import sample_layers


@click.command("demo", context_settings={"ignore_unknown_options": True})
@click.option(
    "-o",
    "--output",
    type=click.Path(file_okay=False),
    default="firebreak_demo",
    show_default=True,
    help="Folder to write into; made if it does not exist.",
)
@click.option("--open/--no-open", "show", default=True, show_default=True, help="Open the report in a browser.")
@click.argument("more", nargs=-1, type=click.UNPROCESSED, metavar="[OPTIONS OF PLAN]...")
@click.pass_context
def command(ctx: click.Context, output: str, show: bool, more: tuple[str, ...]) -> None:
    """Plan fire breaks on the sample landscape that comes with the program, and open the report.

    It is firebreak plan with the three sample rasters; all its options may be added, for example --budget 0.05.
    """
    group = ctx.parent.command if ctx.parent else None
    assert isinstance(group, click.Group)
    plan = group.get_command(ctx, "plan")
    assert plan is not None
    layers = sample_layers()
    words = [layers["dem"], layers["vegetation"], layers["density"], "-o", output, *more]
    with plan.make_context("plan", words, parent=ctx.parent) as inner:
        plan.invoke(inner)
    page = Path(output, "report.html").resolve()
    if show and page.is_file() and not click.launch(page.as_uri()):
        return
    click.echo(f"Open {page} in a browser.", err=True)
