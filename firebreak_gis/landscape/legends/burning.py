"""Columns of a legend that say how the fuel burns, for fires with a clock.

Where a cell is blank, the class counts. Built-in legends have them where PROPAGATOR (Trucchia et al. 2020, doi
10.3390/fire3030026) gives a fuel other numbers than its class has here.

| column | what |
|---|---|
| `rate_m_h` | rate of spread on flat calm dry ground |
| `dead_kg_m2`, `live_kg_m2` | loads of dead and live fuel |
| `heat_kj_kg` | heat content |
| `live_moisture` | moisture of the live fuel, a share |
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from types import MappingProxyType

from firebreak_gis.schema import VARIABLES

#: Variable of the landscape that a column fills.
BURNING: Mapping[str, str] = MappingProxyType(
    {
        "rate_m_h": "rate",
        "dead_kg_m2": "dead_load",
        "live_kg_m2": "live_load",
        "heat_kj_kg": "heat_content",
        "live_moisture": "live_moisture",
    }
)


def burning_of(record: Mapping[str, str], number: int, problems: list[str]) -> dict[str, float | None]:
    """Numbers of a line by variable, None where the cell is blank; problems are added.

    Parameters
    ----------
    record
        Cells by column.
    number
        Of the line.
    problems
        Sentences.
    """
    found: dict[str, float | None] = {}
    for column, name in BURNING.items():
        text = record.get(column, "")
        variable = VARIABLES[name]
        low, high = variable.minimum or 0.0, variable.maximum or math.inf
        try:
            value = float(text) if text else None
        except ValueError:
            value = math.nan
        if value is not None and not low <= value <= high:
            problems.append(f"line {number}: {column} is {text!r}, expected a number from {low:g} to {high:g}")
        if value is not None and not record.get("vegetation"):
            problems.append(f"line {number}: {column} goes with a vegetation, and there is none")
        found[name] = value
    return found
