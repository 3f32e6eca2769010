"""What is asked of a calibration: one typed value."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

#: Hours of a day in which a fire spreads: the median burn period of 164 Portuguese fires (Benali et al. 2023,
#: PT-FireSprd, doi 10.5194/essd-15-3791-2023).
HOURS_A_DAY = 7.5


@dataclass(frozen=True)
class CalibrationRequest:
    """What is fitted, and to which fires; see `calibration.calibrate_sizes` and `landscape.scars.fire_table`.

    Parameters
    ----------
    fit
        "rate", "duration", "p0"; None for the usual ones.
    size_column, first_day_column, last_day_column
        Columns of a table of fires; None: found by name.
    least
        Smallest fire that counts [ha].
    hours_a_day
        Hours for which a fire spreads on each of its days.
    longest
        No fire spreads longer [s]; None: found from the fires.
    model_params
        Parameters of the spread model that stay as they are.
    """

    fit: Sequence[str] | None = None
    size_column: str | None = None
    first_day_column: str | None = None
    last_day_column: str | None = None
    least: float = 100.0
    hours_a_day: float = HOURS_A_DAY
    longest: float | None = None
    model_params: Mapping[str, Any] = field(default_factory=dict)
