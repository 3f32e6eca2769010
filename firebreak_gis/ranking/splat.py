"""Strategically placed area treatments (SPLAT): staggered patches that slow a fire, with no line through them.

Rows of rectangles lie across the heading, each row moved so that its patches overlap those of the next. With patches
of W cells along and L across the heading, rows S apart and an overlap of O, the share of the land treated is
W L / ((W + S) 2 (L - O)); S follows from the budget. Patches with most fuel value come first, then the cells nearest
to patches. Where ground is better to hold a patch moves to it, along the heading by up to a quarter of S. Treated
cells that still burn (residual above 0) are what the pattern was made for. Cost: a few passes.

The pattern slows fires and leaves them a way round every patch. Where fires burn until they end by themselves, slowing
them saves nothing. A pattern laid for a smaller budget than is cut therefore burns less: what is left goes to the
cells nearest to the patches, closes the gaps within each row, and the rows become walls. Such a plan is `stripes` by
another name; `plan` and `rank` lay the pattern for the budget that is cut.
Source: Finney 2001, doi 10.1093/forestscience/47.2.219.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from firebreak_gis.errors import ParameterError
from firebreak_gis.plugins import parameter

if TYPE_CHECKING:
    from firebreak_gis.network import SpreadNetwork
    from firebreak_gis.progress import Progress
    from firebreak_gis.stakes import Stakes

#: Bytes at the peak beside the network: a cell, a cell and thread; measured.
MEMORY = (160, 0)


@dataclass(frozen=True)
class Params:
    """Parameters of the staggered patches."""

    direction: float | None = parameter(
        None,
        text="heading of the fires, clockwise from north; default: into which fire spreads most",
        units="degree",
        minimum=0.0,
        maximum=360.0,
    )
    width: int = parameter(
        4, text="patch along the heading", units="cells", minimum=1, maximum=1000, told="least_width"
    )
    length: int = parameter(12, text="patch across the heading", units="cells", minimum=1, maximum=10_000)
    overlap: int = parameter(4, text="overlap of patches of neighbouring rows", units="cells", minimum=0)
    gap: float | None = parameter(
        None, text="between rows along the heading; default: what the budget affords", units="cells", minimum=0.0
    )
    cell_share: float = parameter(
        0.05,
        text="share of the cells with fuel that the patches may take",
        minimum=1e-6,
        maximum=1.0,
        told="cell_share",
    )


def rank(network: SpreadNetwork, params: Params, *, stakes: Stakes, seed: int, progress: Progress) -> np.ndarray:
    """Return the order of cutting, (rows, cols) float64, highest first."""
    from firebreak_gis.placement.orientation import in_standard_orientation

    if params.overlap >= params.length:
        raise ParameterError(
            f"splat overlap is {params.overlap} cells, expected less than the length of a patch, {params.length}"
        )
    progress(0.0, "laying patches")
    if params.direction is None:
        return in_standard_orientation(network, stakes, lambda n, s, _: _patches_first(n, params, s))
    return _patches_first(network, params, stakes)


def _patches_first(network: SpreadNetwork, params: Params, stakes: Stakes) -> np.ndarray:
    from firebreak_gis.placement.bending import is_even, pushed
    from firebreak_gis.placement.patterns import pattern_first, prevailing, staggered_patches

    heading = prevailing(network) if params.direction is None else params.direction
    gap = params.gap
    if gap is None:
        share = params.width * params.length / (2.0 * (params.length - params.overlap))
        gap = max(share / params.cell_share - params.width, 0.0)
    patch = staggered_patches(
        network.shape, heading, width=params.width, length=params.length, gap=gap, overlap=params.overlap
    )
    treated = np.where(network.burnable & ~stakes.protected, patch, -1).ravel()
    cells = np.argsort(treated, kind="stable")[np.count_nonzero(treated < 0) :]
    if cells.size == 0:
        return pattern_first(network, stakes, [])
    patches = np.split(cells, np.flatnonzero(np.diff(treated[cells])) + 1)
    if not is_even(stakes):
        patches = pushed(patches, network, stakes, heading, int(gap / 4.0))
    worth = np.array([stakes.value.ravel()[own].sum() for own in patches])
    return pattern_first(network, stakes, [patches[i] for i in np.argsort(-worth, kind="stable")])
