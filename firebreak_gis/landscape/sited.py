"""Where lines go: how much good ground counts, and ground that is too steep, or too near or too far from roads.

Plans, rankings and comparisons all come through `SitingRequest.on`, which makes the difficulty of every cell and adds
to the protected cells, so that they agree.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from firebreak_gis.errors import ParameterError
from firebreak_gis.landscape.siting import (
    beside,
    difficulty,
    distance,
    features,
    require_strength,
    siting_of,
    suitability,
)
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.stakes import StakePlanes

if TYPE_CHECKING:
    from firebreak_gis.landscape.siting import Siting

#: Strength where none is asked for; of those tried (docs/siting.md) the one that follows lines most for what it costs.
STRENGTH = 1.5
#: Terrain with less between its lowest and highest ground has no ridges to follow [m].
_RELIEF = 50.0

_WORDS = {
    "ridge": "ridges",
    "valley": "valley bottoms",
    "road": "roads",
    "river": "rivers",
    "edge": "edges of the fuel",
}


@dataclass(frozen=True)
class Sited:
    """What is planned with once the ground is known.

    Parameters
    ----------
    planes
        With the difficulty, and with all that must not be cut among the protected cells.
    strength
        How much the ground counts, 0: not at all.
    lines
        Cells within one cell of each line that a break can follow, by name, (rows, cols) bool.
    told
        What is assumed, in words.
    account
        Sentences on how much may not be cut, and why.
    """

    planes: StakePlanes
    strength: float
    lines: Mapping[str, np.ndarray]
    told: tuple[str, ...]
    account: tuple[str, ...]

    def shares(self, cells: np.ndarray) -> dict[str, float]:
        """Share of some cells, (rows, cols) bool, within one cell of each line, and of any."""
        count = max(int(np.count_nonzero(cells)), 1)
        found = {name: float(np.count_nonzero(mask & cells) / count) for name, mask in self.lines.items()}
        every = np.logical_or.reduce([*self.lines.values(), np.zeros(cells.shape, bool)])
        return {**found, "any": float(np.count_nonzero(every & cells) / count)}


@dataclass(frozen=True)
class SitingRequest:
    """How breaks are laid into the ground.

    Parameters
    ----------
    siting
        How much more a wall counts in the worst ground than in the best, see `siting.difficulty`; 0 makes all ground
        alike. None: 1.5 where the terrain is known and has relief and lines to follow, else 0.
    siting_params
        Fields of `siting.Siting`.
    max_slope
        Steeper ground is not cut [degrees].
    near_roads, beyond_roads
        Ground farther than that from all roads, or nearer to one, is not cut [m].
    """

    siting: float | None = None
    siting_params: Mapping[str, Any] = field(default_factory=dict)
    max_slope: float | None = None
    near_roads: float | None = None
    beyond_roads: float | None = None

    def require(self) -> None:
        """Refuse what cannot be on any map.

        Raises
        ------
        ParameterError
            Naming the option.
        """
        siting_of(self.siting_params)
        if self.siting is not None:
            require_strength(self.siting)
        if self.max_slope is not None and not 0.0 <= self.max_slope <= 90.0:
            raise ParameterError(f"--max-slope is {self.max_slope:g}, expected degrees from 0 to 90")
        for option, metres in (("near", self.near_roads), ("beyond", self.beyond_roads)):
            if metres is not None and not (np.isfinite(metres) and metres >= 0.0):
                raise ParameterError(f"--{option}-roads is {metres:g} m, expected a distance of at least 0")
        near, beyond = self.near_roads, self.beyond_roads
        if near is not None and beyond is not None and beyond >= near:
            raise ParameterError(
                f"nothing is both within {near:g} m of roads (--near-roads) and beyond {beyond:g} m (--beyond-roads); "
                "let the first be the larger"
            )

    def on(self, planes: StakePlanes, network: SpreadNetwork, elevation: np.ndarray | None) -> Sited:
        """Look at the ground.

        Parameters
        ----------
        planes
            What a planner adds; a difficulty given there stays.
        network
            Without the barriers.
        elevation
            (rows, cols) [m], NaN where unknown; None where no terrain is known.

        Raises
        ------
        ParameterError
            If what is asked needs a terrain or roads that are not given.
        """
        self.require()
        size = network.grid.cell_size
        chosen = siting_of(self.siting_params)
        strength = self._strength(elevation)
        given = {
            name: network.mask(plane, name)
            for name in ("barriers", "roads", "rivers", "aoi")
            if (plane := getattr(planes, name)) is not None
        }
        fuel = network.burnable & ~given.get("barriers", np.False_)
        known = {"burnable": fuel, "roads": given.get("roads"), "rivers": given.get("rivers"), "siting": chosen}
        lines = features(elevation, size, **known)  # type: ignore[arg-type]
        told: list[str] = []
        if strength > 0.0 and planes.difficulty is None and (lines or self.siting is not None):
            planes = replace(
                planes,
                difficulty=difficulty(suitability(elevation, size, lines=lines, **known)[0], strength=strength),  # type: ignore[arg-type]
            )
            told.append(_told(strength, lines, chosen, sloping=elevation is not None and chosen.slope > 0.0))
        account: list[str] = []
        kept = np.zeros(network.shape, bool)
        for excluded, why in self._excluded(elevation, given, size):
            count = int(np.count_nonzero(excluded & fuel))
            told.append(f"nothing is cut {why}")
            account.append(f"{count * network.grid.cell_area_ha:,.6g} ha of fuel lie {why}, where nothing is cut")
            kept |= excluded
        if kept.any():
            before = False if planes.protected is None else network.mask(planes.protected, "protected")
            planes = replace(planes, protected=kept | before)
        near = {name: beside(mask, size, 0.0) for name, mask in lines.items()}
        return Sited(planes, strength, near, tuple(told), tuple(account))

    def _strength(self, elevation: np.ndarray | None) -> float:
        if self.siting is not None:
            return self.siting
        heights = np.zeros(1) if elevation is None else elevation[np.isfinite(elevation)]
        return STRENGTH if heights.size and np.ptp(heights) >= _RELIEF else 0.0

    def _excluded(
        self, elevation: np.ndarray | None, given: Mapping[str, np.ndarray], size: float
    ) -> list[tuple[np.ndarray, str]]:
        """Cells that must not be cut, and why."""
        from firebreak_gis.kernels.terrain import horn_slope

        found = []
        if "aoi" in given:
            found.append((~given["aoi"], "outside the area of interest"))
        if self.max_slope is not None:
            if elevation is None:
                raise ParameterError("--max-slope needs to know the terrain; give the elevation (--dem)")
            slope = horn_slope(np.asarray(elevation, dtype=np.float64), size)
            # Unknown ground is not known to be gentle.
            found.append((~(slope <= self.max_slope), f"on slopes above {self.max_slope:g} degrees"))
        if self.near_roads is None and self.beyond_roads is None:
            return found
        roads = given.get("roads")
        if roads is None or not roads.any():
            raise ParameterError("--near-roads and --beyond-roads need to know where roads are; give them (--roads)")
        away = distance(roads, size)
        if self.near_roads is not None:
            found.append((away > self.near_roads, f"farther than {self.near_roads:g} m from roads"))
        if self.beyond_roads is not None:
            found.append((away <= self.beyond_roads, f"within {self.beyond_roads:g} m of roads"))
        return found


def _told(strength: float, lines: Mapping[str, np.ndarray], chosen: Siting, *, sloping: bool) -> str:
    names = [_WORDS[name] for name in sorted(lines, key=lambda name: -getattr(chosen, name))]
    names += ["gentle slopes"] if sloping else []
    listed = names[0] if len(names) == 1 else ", ".join(names[:-1]) + " and " + names[-1]
    return f"breaks keep to {listed} (siting {strength:g}; what each is worth is assumed)"
