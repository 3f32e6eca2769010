"""Dissection: walls between compartments by nested minimum cuts, those that save most for their cost first.

What network science calls dismantling by nested dissection: small separators first cut the whole, then its parts.

Each compartment is split by the minimum vertex cut between opposite ends, in several directions, that saves
the largest expected loss for its cost; the pieces are split in turn. Where fire passes between all neighbours that hold
fuel, such a cut is the cheapest chain of cells that share a side. Compartments of more than 4,096 cells, 65,536 for
chains, are searched coarsely first. Maps of more than 4 million cells of fuel are parted into regions first, see
`placement.regions`. Costs are the capacities, protected
cells are never in a wall, cells without fuel are free, and ignitions and values at risk set what a wall saves. Walls
stop spread over corners too. A wall is worth little before it is closed, so budgets between two walls gain little.

Breaks that leak need width: walls are sought by the cost of their full width and each is built in full width
before the next. With a `residual` above 0 the width is chosen by simulated fires, and walls keep to fuel that is hard
to light. Cells in no wall come last,
those of large compartments first.

Where the plan knows what fires will come, with a clock, weather, embers and breaks that fail, walls of several layouts
are laid for its budget and tried out on such fires, drawn for the design alone: even walls of each width; where breaks
leak, thin walls that are widened where most is lost by way of them; where stretches fail, those parts first by which
most passes. The layout that loses least counts.

Cost: about 0.4 microseconds of processor time a cell and level of the tree: 7 s in all for 935,000 cells. Memory
about 125 B a cell beside the network.
Source: vertex cuts by flow between the ends of the map, Schild, Sommer 2015, doi 10.1007/978-3-319-20086-6_22;
warm starts, Hamann, Strasser 2018, doi 10.1145/3173045; order of construction, Horn 1972, doi 10.1137/0123021.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.plugins import parameter, require_width

if TYPE_CHECKING:
    from collections.abc import Callable

    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.placement.dissection import Cut
    from firebreak_gis.placement.orientation import Turn
    from firebreak_gis.placement.trial import Trial
    from firebreak_gis.progress import Progress
    from firebreak_gis.ranking import Ranked
    from firebreak_gis.stakes import Stakes

    #: Walls, and (rows, cols) the size of the smallest compartment around each cell that they split.
    Walls = tuple[list[Cut], np.ndarray]

#: Bytes at the peak beside the network: a cell, a cell and thread; measured.
MEMORY = (125, 5)
#: The same on maps that are dissected by regions; measured on 10 million cells with two threads.
LARGE_MEMORY = (100, 0)

#: Walls of equal cost are many, and the order of the cells decides between them: turned maps give plans that are
#: equally good, not the same cell by cell.
UNIQUE = False


@dataclass(frozen=True)
class Params:
    """Parameters of the dissection."""

    directions: int = parameter(8, text="directions in which walls are sought", minimum=1, maximum=64)
    smallest: int = parameter(16, text="compartments of fewer cells are not split", units="cells", minimum=2)
    width: int = parameter(
        0,
        text="width of the walls; 0: the best for the residual and budget by simulated fires, the least if perfect",
        units="cells",
        minimum=0,
        maximum=100,
    )
    least_width: int = parameter(
        1,
        text="width of the walls at least",
        units="cells",
        minimum=1,
        maximum=100,
        told="least_width",
    )
    residual: float = parameter(
        0.0,
        text="spread probability that a treated cell keeps, for which the width is chosen",
        minimum=0.0,
        maximum=1.0,
        told="residual",
    )
    cost_share: float = parameter(
        0.05,
        text="share of the cost of all fuel for which the width is chosen",
        minimum=0.0,
        maximum=1.0,
        told="cost_share",
    )
    by_fires: bool = parameter(
        True,
        text="where fires have a clock, whether walls are tried out on them; no: as if they burnt whole compartments",
    )


def effective(params: Params) -> Params:
    """Without a choice of the width the share of the cost makes no difference."""
    return params if _chooses(params) else replace(params, cost_share=Params().cost_share)


def _chooses(params: Params) -> bool:
    return params.width == 0 and params.residual > 0.0


def uses_trial(params: Params) -> bool:
    """Whether fires with a clock, where a plan knows them, make a difference."""
    return params.by_fires and params.width == 0


def rank(
    network: SpreadNetwork,
    params: Params,
    *,
    stakes: Stakes,
    seed: int,
    progress: Progress,
    trial: Trial | None = None,
) -> Ranked:
    """Return the order of cutting, (rows, cols) float64, highest first, and what the walls are in words."""
    return rankings(network, stakes=stakes, seed=seed)(params, progress, trial)


def rankings(
    network: SpreadNetwork, *, stakes: Stakes, seed: int
) -> Callable[[Params, Progress, Trial | None], Ranked]:
    """Return `rank` for any parameters: walls of one width are sought once, whatever the budget and the residual."""
    from firebreak_gis.placement.widening import best_width
    from firebreak_gis.ranking import Ranked

    walls: dict[Params, np.ndarray] = {}
    sought: dict[Params, Walls] = {}

    def cuts_for(params: Params, width: int, progress: Progress) -> Walls:
        key = Params(params.directions, params.smallest, width, residual=float(params.residual > 0.0))
        if key not in sought:
            sought[key] = _as_it_lies(network, stakes, params, width, progress)
        progress(1.0, f"walls of {width} cells")
        return sought[key]

    def walled(network: SpreadNetwork, params: Params, stakes: Stakes, width: int, progress: Progress) -> np.ndarray:
        key = Params(params.directions, params.smallest, width, residual=float(params.residual > 0.0))
        if key not in walls:
            walls[key] = _walls_first(network, params, stakes, width, progress)
        progress(1.0, f"walls of {width} cells")
        return walls[key]

    def one(params: Params, progress: Progress, trial: Trial | None = None) -> Ranked:
        require_width(__name__, params.width, params.least_width)
        if trial is not None and uses_trial(params) and network.burnable.any():
            return _tried_out(network, params, stakes, trial, cuts_for, progress)
        width = params.width or params.least_width

        def standard(network: SpreadNetwork, stakes: Stakes, turn: object) -> np.ndarray:
            nonlocal width
            if not _chooses(params) or not network.burnable.any():
                return walled(network, params, stakes, width, progress)
            width, priority = best_width(
                network,
                stakes,
                lambda width, step: walled(network, params, stakes, width, step),
                narrowest=params.least_width,
                cost_share=params.cost_share,
                residual=params.residual,
                seed=seed,
                progress=progress,
            )
            return priority

        priority = _turned(network, stakes, standard)
        return Ranked(priority, f"walls of {width} cell{'s' if width > 1 else ''}")

    return one


def _walls_first(network: SpreadNetwork, params: Params, stakes: Stakes, width: int, progress: Progress) -> np.ndarray:
    from firebreak_gis.placement.dissection import lines_first
    from firebreak_gis.placement.widening import walls

    def found() -> tuple[list[np.ndarray], np.ndarray]:
        """What else is known of each wall is not kept beyond this."""
        cuts, sizes = _cuts(network, stakes, params, width, progress)
        return walls(_in_sequence(cuts, network, stakes, width), network, stakes, width)[0], sizes

    cells, sizes = found()
    return lines_first(cells, stakes, sizes)


def _tried_out(
    network: SpreadNetwork,
    params: Params,
    stakes: Stakes,
    trial: Trial,
    cuts_of: Callable[[Params, int, Progress], Walls],
    progress: Progress,
) -> Ranked:
    from firebreak_gis.breaks import Budget
    from firebreak_gis.placement.dissection import lines_first
    from firebreak_gis.placement.reinforcing import best_layout
    from firebreak_gis.progress import part
    from firebreak_gis.ranking import Ranked

    # Walls of every width lie on the lines of one or two widths.
    least, leaky = params.least_width, params.residual > 0.0
    sought = sorted({max(least, 2), max(least, 3)}) if leaky else [least]
    made = [
        cuts_of(params, width, part(progress, 0.5 * k / len(sought), 0.5 * (k + 1) / len(sought)))
        for k, width in enumerate(sought)
    ]

    def cuts_for(width: int) -> Walls:
        return made[-1] if width >= sought[-1] else made[0]

    chosen = best_layout(
        network,
        stakes,
        trial,
        lambda width, chance: _in_sequence(cuts_for(width)[0], network, stakes, width, chance),
        money=Budget.of_cost_share(params.cost_share, stakes).amount,
        narrowest=params.least_width,
        progress=part(progress, 0.5, 1.0),
    )
    return Ranked(lines_first(chosen.cells, stakes, cuts_for(1)[1]), chosen.told)


def _as_it_lies(network: SpreadNetwork, stakes: Stakes, params: Params, width: int, progress: Progress) -> Walls:
    """Walls found on the map in its standard orientation, in the numbers of the cells as it lies."""
    from firebreak_gis.placement.orientation import turned_corner

    cuts: list[Cut] = []

    def standard(turned: SpreadNetwork, placed: Stakes, turn: Turn) -> np.ndarray:
        number = turn(np.arange(network.burnable.size).reshape(network.shape)).ravel()
        # Priced as they will be widened, on the map as it lies.
        found, sizes = _cuts(turned, placed, params, width, progress, corner=turned_corner(turn))
        cuts.extend(cut._replace(cells=number[cut.cells]) for cut in found)
        return sizes

    sizes = _turned(network, stakes, standard)
    return cuts, sizes


def _turned(
    network: SpreadNetwork, stakes: Stakes, method: Callable[[SpreadNetwork, Stakes, Turn], np.ndarray]
) -> np.ndarray:
    """Answer for the map in its standard orientation; as it lies where it is dissected by regions: it is not copied."""
    from firebreak_gis.placement.dissection import by_regions
    from firebreak_gis.placement.orientation import in_standard_orientation

    if by_regions(network):
        return method(network, stakes, np.asarray)
    return in_standard_orientation(network, stakes, method)


def _cuts(
    network: SpreadNetwork, stakes: Stakes, params: Params, width: int, progress: Progress, **turned: Any
) -> Walls:
    from firebreak_gis.placement.dissection import dissect

    sizes = np.zeros(network.burnable.size, np.int32)
    cuts = dissect(
        network,
        stakes,
        width=width,
        leaky=params.residual > 0.0,
        directions=params.directions,
        smallest=max(params.smallest, width * width),
        sizes=sizes,
        progress=progress,
        **turned,
    )
    return cuts, sizes.reshape(network.shape)


def _in_sequence(
    cuts: list[Cut],
    network: SpreadNetwork,
    stakes: Stakes,
    width: int,
    chance: Callable[[list[np.ndarray]], np.ndarray] | None = None,
) -> list[np.ndarray]:
    """Lines of the walls in the order of building that suits a width; `chance` tells how often each holds."""
    from firebreak_gis.placement.dissection import sequence
    from firebreak_gis.placement.widening import wall_costs

    lines = [cut.cells for cut in cuts]
    costs = wall_costs(lines, network, stakes, width)
    saved = np.array([cut.saved for cut in cuts]) * (1.0 if chance is None else chance(lines))
    order = sequence(saved.tolist(), costs, [cut.parent for cut in cuts])
    return [lines[i] for i in order]
