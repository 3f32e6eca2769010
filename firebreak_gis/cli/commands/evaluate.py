"""firebreak evaluate: a spread network and rankings in, R(d_f) with significance out."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from firebreak_gis.cli import kinds, options, parsing
from firebreak_gis.cli.layers import checked_fires, recorded
from firebreak_gis.cli.session import Session

#: What the command writes into its folder.
OUTPUTS = {
    "evaluation.csv": "Burnt share and significance of every ranking at every budget",
    "evaluation.png": "Curves of the burnt share",
    "evaluation.svg": "Curves of the burnt share, to scale",
    "run.json": "Account of the run",
}


@click.command("evaluate")
@click.argument("network", type=kinds.RASTER)
@options.output_folder
@click.option(
    "--methods",
    "method_list",
    type=kinds.RANKINGS,
    default="bonacich,random",
    show_default=True,
    metavar="LIST",
    help="Rankings, separated by commas, parameters by colons: bonacich:beta=0.2,betweenness,random.",
)
@click.option(
    "--baseline",
    type=kinds.RANKING,
    metavar="NAME",
    default="random",
    show_default=True,
    help="Ranking that the others are tested against.",
)
@click.option(
    "--budgets",
    metavar="LIST",
    help="Shares to cut, separated by commas [default: 0 to 0.4 in steps of 0.01].",
)
@click.option(
    "--test",
    type=click.Choice(["wilcoxon", "ranksum", "t"]),
    default="wilcoxon",
    show_default=True,
    help="Paired Wilcoxon signed-rank, Wilcoxon rank-sum for independent runs, or paired t.",
)
@click.option("--alpha", type=float, default=0.01, show_default=True, help="Significance threshold.")
@options.fires
@options.seed
@options.fitting("evaluate")
@options.common
def command(session: Session, network: str, output: str, method_list: str, **given: Any) -> None:
    """Judge rankings on NETWORK: mean, 90 % percentile and maximum of the burnt share at every budget.

    All rankings meet the same fires. Writes evaluation.csv, evaluation.png, evaluation.svg and run.json.
    """
    from firebreak_gis.evaluation.curves import better_range, evaluate, table
    from firebreak_gis.files import make_folder, require_writable, together, write_text
    from firebreak_gis.manifest import write_manifest
    from firebreak_gis.planning.pipeline import default_budgets
    from firebreak_gis.progress import part
    from firebreak_gis.ranking import rank
    from firebreak_gis.rasters import files_behind
    from firebreak_gis.report.curve import curve_figure
    from firebreak_gis.report.figures import save
    from firebreak_gis.spread.raster import read_network

    seed = parsing.checked_seed(given["seed"])
    methods = parsing.methods_list(method_list)
    if given["baseline"] not in {label for label, _, _ in methods}:
        methods.append((given["baseline"], given["baseline"], {}))
    inputs = [p for p in (network, given["ignitions"]) if p and Path(p).is_file()]
    target = make_folder(output)
    files = [target / name for name in ("evaluation.csv", "evaluation.png", "evaluation.svg")]
    for name in (*files, target / "run.json"):
        require_writable(
            name, overwrite=given["overwrite"], forbid=files_behind(filter(None, (network, given["ignitions"])))
        )
    budgets = parsing.number_list(given["budgets"], "--budgets") if given["budgets"] else default_budgets()
    spread = read_network(network)
    fires = checked_fires(given, spread)
    priorities = {}
    for i, (label, method, params) in enumerate(methods):
        step = part(session.progress, 0.5 * i / len(methods), 0.5 * (i + 1) / len(methods), f"{label}: ")
        priorities[label] = rank(spread, method, seed=seed, progress=step, **params)
    result = evaluate(
        spread,
        priorities,
        budgets=budgets,
        baseline=given["baseline"],
        test=given["test"],
        alpha=given["alpha"],
        **fires,
        progress=part(session.progress, 0.5, 0.95),
    )
    with together(target):
        write_text(files[0], table(result).to_csv(index=False, lineterminator="\n"), overwrite=given["overwrite"])
        figure = curve_figure(result)
        for name in files[1:]:
            save(figure, name, overwrite=given["overwrite"])
        better = {label: better_range(result, label) for label in priorities if label != given["baseline"]}
        files.append(
            write_manifest(
                target / "run.json",
                command="evaluate",
                inputs=inputs,
                outputs=files,
                parameters=recorded({"network": network, "method_list": method_list, **given}),
                account={"n_burnable": spread.n_burnable, "significant_d_f": better},
                overwrite=given["overwrite"],
            )
        )
    told = [
        f"{label} burns less than {given['baseline']} (alpha {given['alpha']:g}) "
        + ("nowhere" if span is None else f"at d_f from {span[0]:g} to {span[1]:g}")
        for label, span in better.items()
    ]
    told.append(f"{len(priorities)} rankings at {len(budgets)} budgets; written to {output}")
    session.finish({"files": files, "significant_d_f": better}, "\n".join(told))
