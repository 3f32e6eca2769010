"""Kinds of design: a new one is one module, which the pipeline, the estimate and the outputs take as it is."""

from __future__ import annotations

import sys

import numpy as np
import pytest

from firebreak_gis import plan
from firebreak_gis.planning import designs
from firebreak_gis.planning.request import DesignRequest

KIND = '''
"""Nothing in the northern half: of a design only what lies south is cut."""
from dataclasses import replace

from firebreak_gis.errors import ParameterError

ORDER = 30

def asked(request):
    return request.method == "degree"

def require(request):
    if request.design.width is not None:
        raise ParameterError("the southern half has no width")

def rankings(request):
    return 2

def make(setting, rest, progress):
    found = rest(setting, progress)
    rows = setting.network.shape[0]
    breaks = found.breaks.copy()
    breaks[: rows // 2] = 0
    return replace(found, breaks=breaks)
'''


@pytest.fixture
def southern(monkeypatch, tmp_path):
    """The module, as if it lay in the folder of the package."""
    (tmp_path / "southern.py").write_text(KIND)
    monkeypatch.setattr(designs, "__path__", [*designs.__path__, str(tmp_path)])
    designs._kinds.cache_clear()
    yield
    designs._kinds.cache_clear()
    sys.modules.pop("firebreak_gis.planning.designs.southern", None)


def names(**asked):
    return [kind.__name__.rpartition(".")[2] for kind in designs.asked_for(DesignRequest(**asked))]


def test_the_chain_is_what_a_request_asks_for():
    from firebreak_gis.construction.treatments import read_treatments

    assert names() == ["cells"]
    assert names(line_width=5.0) == ["lines", "cells"]
    table = read_treatments()
    assert names(goal="worst-tenth", treatments=table) == ["treated", "worst_tenth", "cells"]
    assert designs.rankings(DesignRequest()) == 1
    assert designs.rankings(DesignRequest(goal="worst-tenth", treatments=table)) == 5
    money = DesignRequest(goal="worst-tenth", treatments=table, budget="100 eur")
    assert designs.rankings(money) == 5 * (1 + len(table.names))


def test_a_new_kind_is_one_module(southern, make_landscape):
    land = make_landscape((30, 32), seed=4)
    given = {"method": "degree", "budget": 0.1, "n_runs": 10}
    made = plan(land, **given)
    assert names(method="degree") == ["southern", "cells"]
    assert names() == ["cells"]
    assert designs.rankings(DesignRequest(method="degree")) == 2
    cut = made.breaks.to_numpy() > 0
    assert cut[15:].any()
    assert not cut[:15].any()
    assert made.summary["cells_cut"] == np.count_nonzero(cut) < round(0.1 * made.network.n_burnable)
    assert made.segments.lines.geometry.bounds["maxy"].max() < made.network.grid.transform.f - 14 * 20
    with pytest.raises(ValueError, match="southern half has no width"):
        plan(land, width=40.0, **given)
