"""The report page of a comparison, from what its folder holds."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from firebreak_gis.report.page.content import Curve, Page, Row
from firebreak_gis.report.page.values import plain, provenance

if TYPE_CHECKING:
    import pandas as pd


def comparison_page(table: pd.DataFrame, account: Mapping[str, Any]) -> Page:
    """Return the page of a comparison.

    Parameters
    ----------
    table
        As `comparison.csv` holds it.
    account
        As `run.json` holds it.
    """
    perfect = table[table["residual"] == table["residual"].min()] if "residual" in table else table
    area = table.attrs.get("fuel_ha")
    lines = []
    for method, rows in perfect.groupby("method", sort=False):
        rows = rows.sort_values("d_f")
        lines.append((str(method), rows["d_f"].tolist(), rows["R"].tolist()))
    curve = None
    if lines and len(lines[0][1]) > 1:
        leak = float(perfect["residual"].iloc[0]) if "residual" in perfect else 0.0
        kind = f"treated cells keep {100 * leak:.3g} % of their spread" if leak else "treated cells let no fire pass"
        note = f"Mean burnt share of the fuel in the simulated fires; {kind}"
        curve = Curve("What each plan saves", note, "share of the fuel cut", lines)
    columns = {name: _compared(name) for name in table.columns}
    rows = tuple(
        Row({columns[name]: plain(value) for name, value in row.items()}, _decimals(table.rename(columns=columns)))
        for row in table.to_dict("records")
    )
    return Page(
        title="Plans compared" if area is None else f"Plans compared on {area:,.0f} ha",
        headline=tuple(account.get("headline", ())),
        assumptions=tuple(account.get("assumptions", ())),
        warnings=tuple(account.get("warnings", ())),
        curve=curve,
        comparison=rows,
        files=tuple((name, label) for name, label in account.get("files", ()) if name != "report.html"),
        provenance=provenance(account),
    )


#: Columns of `comparison.csv` as the page names them; the ends of intervals follow.
_COMPARED = {
    "method": "Method",
    "d_f": "Budget, share of the fuel",
    "residual": "Residual",
    "cells_cut": "Cells cut, or passed by lines",
    "ha_cut": "Cut [ha]",
    "R": "Burnt share",
    "burnt_ha": "Burnt [ha]",
    "p90_ha": "Burnt in one of ten [ha]",
    "cvar_ha": "Burnt in the worst tenth [ha]",
    "value_lost": "Value lost",
    "leverage": "Saved per ha cut [ha]",
}


def _compared(name: str) -> str:
    """Name of a column of a comparison; one that is not known keeps its own.

    Examples
    --------
    >>> _compared("burnt_ha_low"), _compared("my_own")
    ('Burnt [ha], low', 'my own')
    """
    for end in ("_low", "_high"):
        if name.removesuffix(end) in _COMPARED and name.endswith(end):
            return f"{_COMPARED[name.removesuffix(end)]}, {end[1:]}"
    return _COMPARED.get(name, name.replace("_", " "))


def _decimals(table: pd.DataFrame) -> dict[str, int]:
    """Decimals of the columns with fractions, by name."""
    return {
        str(name): 4 if table[name].abs().max() < 10 else 1 for name in table.columns if table[name].dtype.kind == "f"
    }
