"""What tables and accounts hold, as a page shows it."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any


def provenance(account: Mapping[str, Any]) -> tuple[tuple[str, str], ...]:
    """What a page tells of where it comes from: names and texts."""
    rows = [("Program", f"{account.get('software', 'firebreak_gis')} {account.get('version', '')}".strip())]
    if account.get("grid"):
        rows.append(("Grid", str(account["grid"])))
    rows += [
        (f"Input {entry['path']}", f"SHA-256 {entry.get('sha256', 'not known')}") for entry in account.get("inputs", ())
    ]
    rows += [("Alignment", sentence) for sentence in account.get("alignment", ())]
    rows += [("What can be reached", sentence) for sentence in account.get("feasibility", ())]
    asked = account.get("parameters", {})
    rows.append(("Parameters", ", ".join(f"{name} = {value}" for name, value in sorted(asked.items()))))
    return tuple((name, value) for name, value in rows if value)


def plain(value: Any) -> Any:
    """A value as JSON holds it; None for NaN."""
    value = value.item() if hasattr(value, "item") else value
    return None if isinstance(value, float) and not math.isfinite(value) else value
