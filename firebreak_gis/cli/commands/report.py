"""firebreak report: the folder of a plan or a comparison in, one page out."""

from __future__ import annotations

from pathlib import Path

import click

from firebreak_gis.cli import kinds, options, outputs
from firebreak_gis.cli.requests import built
from firebreak_gis.cli.session import Session
from firebreak_gis.files.request import OutputRequest


@click.command("report")
@click.argument("run", metavar="DIR", type=click.Path(exists=True, file_okay=False))
@outputs.output_file("Page", kinds.NEW_PAGE)
@options.common
@built(output=OutputRequest)
@click.pass_context
def command(ctx: click.Context, session: Session, run: str, output: OutputRequest) -> None:
    """Show DIR, which plan or compare wrote, on one page: map, segments, curve, assumptions, files.

    The page opens in any browser without a network. Plans and comparisons have one already, report.html; make it anew
    if files were changed, or for a folder that an earlier version wrote. Its links lead to files beside the page, so
    write it into DIR.
    """
    from firebreak_gis.files import require_writable, write_text
    from firebreak_gis.files.outputs import labels
    from firebreak_gis.manifest import read_account
    from firebreak_gis.report.page.folder import report_page

    account = read_account(Path(run) / "run.json")
    inputs = [Path(run) / entry["path"] for entry in account.get("outputs", ()) if entry["path"] != "report.html"]
    require_writable(output.output, overwrite=output.overwrite, forbid=[*inputs, Path(run) / "run.json"])
    session.progress(0.1, "reading")
    group = ctx.parent.command if ctx.parent else None
    made_by = group.get_command(ctx, str(account["command"])) if isinstance(group, click.Group) else None
    text = report_page(run, labels(outputs.outputs_of(made_by)) if made_by else {})
    session.progress(0.9, "writing")
    write_text(output.output, text, overwrite=output.overwrite)
    session.finish(
        {"files": [output.output], "bytes": len(text.encode())},
        f"written to {output.output}; open it in a browser",
    )
