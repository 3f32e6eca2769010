"""What is asked of the layers and their grid: one typed value, for `align`, `plan` and Python alike.

To add an option of the layers: add a field here, an option of that name to `cli.options.landscape`, and read it in
`surveying.survey` or `reading.read_surveyed`.
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

#: What codes that the legend does not list are: an error, or land without fuel.
Unknown = Literal["refuse", "nonburnable"]


@dataclass(frozen=True)
class LandscapeRequest:
    """Layers and the grid that they are laid on; every field as in `reading.read_landscape` (`bidx` is `band`)."""

    dem: Any
    vegetation: Any = None
    density: Any = None
    legend: Any = "paper"
    density_legend: Any = "density"
    crs: Any = None
    resolution: float | None = None
    bounds: tuple[float, float, float, float] | None = None
    like: Any = None
    src_crs: Mapping[str, Any] = field(default_factory=dict)
    src_nodata: Mapping[str, float | Sequence[float]] = field(default_factory=dict)
    bidx: Mapping[str, int] = field(default_factory=dict)
    unknown: Unknown = "refuse"
    strict: bool = False
    remote: bool = False
    max_memory: int | None = None

    @property
    def sources(self) -> tuple[str, ...]:
        """Names that may be those of files."""
        named = (self.dem, self.vegetation, self.density, self.legend, self.density_legend, self.like)
        return tuple(os.fspath(name) for name in named if isinstance(name, (str, os.PathLike)))
