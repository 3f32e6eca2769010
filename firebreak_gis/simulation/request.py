"""What is asked of the simulated fires: one typed value, the same for every command that burns.

To add an option of the fires, such as how long they burn: add a field here, an option of that name to
`cli.options.fires`, and read it in `simulation.fires.burn` (and `burn_budgets`). The commands hand the whole request
on, so none of them needs to know.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Literal

#: `each`: the runs take the given points in turn. `all`: every run starts at all of them at once.
IgnitionMode = Literal["each", "all"]


@dataclass(frozen=True)
class FireRequest:
    """Fires to simulate.

    Parameters
    ----------
    ignitions
        Where they start, see `ignitions.resolve_ignitions`; None is one random cell with fuel a run.
    ignition_mode
        What points mean: the runs take them in turn, or every run starts at all of them.
    n_runs
        Number of runs.
    seed
        Seed of all draws.
    residual
        Share of its spread probability that a treated cell keeps; 0 is a perfect break.
    """

    ignitions: Any = None
    ignition_mode: IgnitionMode = "each"
    n_runs: int = 100
    seed: int = 0
    residual: float = 0.0

    @property
    def sources(self) -> tuple[str, ...]:
        """Names of files that it refers to."""
        return (os.fspath(self.ignitions),) if isinstance(self.ignitions, (str, os.PathLike)) else ()
