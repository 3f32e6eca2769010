"""What a plan can reach, told before anything is computed; all conflicts at once, in words."""

from __future__ import annotations

import json
import math

import geopandas as gpd
import numpy as np
import pytest
from affine import Affine
from click.testing import CliRunner
from shapely.geometry import box

from firebreak_gis.breaks import Budget
from firebreak_gis.cli import firebreak
from firebreak_gis.errors import CRSError, InputError, ParameterError, raise_together
from firebreak_gis.grid import Grid
from firebreak_gis.landscape import write_landscape
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.planning.feasibility import feasibility, width_in_cells
from firebreak_gis.planning.pipeline import plan
from firebreak_gis.simulation.ignitions import resolve_ignitions
from firebreak_gis.stakes import Stakes
from firebreak_gis.vectors import write_vector

SHAPE = (6, 9)


@pytest.fixture(scope="module")
def network():
    burnable = np.ones(SHAPE, bool)
    burnable[:, 4] = False
    return SpreadNetwork(
        np.full((8, *SHAPE), 0.4), burnable=burnable, crs="EPSG:32635", transform=Affine(20, 0, 0, 0, -20, 0)
    )


def west(columns):
    """Protected: the first columns."""
    mask = np.zeros(SHAPE)
    mask[:, :columns] = 1
    return mask


def found(network, budget=0.1, unit="share", protected=None, cost=None, **more):
    return feasibility(network, Stakes(network, protected=protected, cost=cost), budget=Budget(budget, unit), **more)


def problem(network, *words, **asked):
    (error,) = found(network, **asked).problems
    assert isinstance(error, ParameterError)
    for word in words:
        assert word in str(error)


def test_account_says_what_can_be_reached(network):
    text = " / ".join(found(network, budget=0.25, protected=west(3)).account)
    assert "48 cells (1.92 ha) hold fuel" in text
    assert "18 cells (0.72 ha) of them may not be cut" in text
    assert "at most 30 cells (1.2 ha), 62.5 % of the fuel" in text
    assert "the budget is 12 cells (0.48 ha), 25 % of the fuel" in text
    cost = np.where(west(3) > 0, 100.0, np.broadcast_to(np.arange(9.0), SHAPE))
    text = " / ".join(found(network, budget=30.0, unit="cost", protected=west(3), cost=cost).account)
    total = 6 * (3 + 5 + 6 + 7 + 8)
    assert f"costs {total} (75 to 200 a hectare)" in text
    most = 6 + 2  # six at 3 and two at 5; least: three at 8; mean cost 5.8
    assert f"buys {3 * 0.04:g} to {most * 0.04:g} ha" in text
    assert f"about {30 / 5.8 * 0.04:.4g} ha" in text


@pytest.mark.parametrize("budget", [-0.1, 1.5, math.nan, math.inf])
@pytest.mark.parametrize("unit", ["share", "ha", "cost"])
def test_impossible_budgets(network, budget, unit):
    if (unit, budget) in (("ha", 1.5), ("cost", 1.5)):
        assert not found(network, budget=budget, unit=unit, cost=np.ones(SHAPE)).problems
    else:
        problem(network, "budget is", f"{budget}", budget=budget, unit=unit, cost=np.ones(SHAPE))


def test_conflicts(network):
    problem(network, "exclude everything", protected=west(9))
    problem(network, "only 30 cells (1.2 ha) can be cut", "lower the budget to 0.625", budget=0.7, protected=west(3))
    problem(network, "lower the budget to 1.2 ha", budget=1.25, unit="ha", protected=west(3))
    problem(network, "needs to know what cutting costs", budget=10, unit="cost")
    problem(network, "more than cutting everything", "lower it to 96", budget=97, unit="cost", cost=np.full(SHAPE, 2.0))
    problem(network, "only 120 m across", width=121.0)
    problem(network, "width is 0", width=0)
    problem(network, "width is nan", width=math.nan)
    problem(network, "residual is 1.5", residual=1.5)
    for fine in (
        {"budget": 0.625, "protected": west(3)},
        {"budget": 1.2, "unit": "ha", "protected": west(3)},
        {"budget": 96, "unit": "cost", "cost": np.full(SHAPE, 2.0)},
        {"width": 120.0, "residual": 0.1},
        {"budget": 0.0, "unit": "cost", "cost": np.zeros(SHAPE)},
    ):
        assert not found(network, **fine).problems
        assert not found(network, **fine).warnings


def test_what_is_hardly_meant(network):
    assert "does not buy a single cell" in found(network, budget=0.03, unit="ha").warnings[0]
    assert "give --residual" in found(network, width=40.0).warnings[0]
    assert not found(network, width=20.0).warnings


def test_ignitions(network):
    def draw(where, n_runs=10):
        return lambda: resolve_ignitions(network, where, n_runs=n_runs, seed=0)

    assert (
        "50 % of the simulated fires start"
        in found(network, protected=west(3), ignitions=draw([(10.0, -10.0), (170.0, -10.0)])).account[-1]
    )
    (error,) = found(network, ignitions=draw([(90.0, -10.0)])).problems
    assert isinstance(error, InputError)
    assert "without fuel" in str(error)


def test_all_problems_at_once(network):
    several = found(
        network,
        budget=2.0,
        width=1e5,
        residual=-1.0,
        protected=west(9),
        ignitions=lambda: resolve_ignitions(network, None, n_runs=0, seed=0),
    )
    with pytest.raises(ParameterError, match=r"4 things .*1\).*exclude.*2\).*budget.*3\).*residual.*4\).*n_runs"):
        several.require()
    with pytest.raises(InputError, match="2 things"):
        raise_together([ParameterError("one"), CRSError("two")])
    with pytest.raises(CRSError, match=r"^two$"):
        raise_together([CRSError("two")])
    raise_together([])


@pytest.mark.parametrize(
    ("width", "size", "cells"),
    [(None, 20, 1), (1, 20, 1), (20, 20, 1), (20.1, 20, 2), (60, 20, 3), (0.3, 0.1, 3), (0.1 + 0.2, 0.1, 3)],
)
def test_width_in_cells(width, size, cells):
    assert width_in_cells(width, size) == cells


def test_a_plan_is_refused_before_it_is_ranked(make_landscape, monkeypatch):
    landscape = make_landscape()
    heard = []
    done = plan(landscape, budget=0.1, method="random", n_runs=2, checked=heard.append)
    assert heard == [done.feasibility]
    monkeypatch.setattr("firebreak_gis.ranking.random.rank", lambda *_, **__: pytest.fail("ranked first"))
    everything = np.ones(landscape["burnable"].shape)
    with pytest.raises(ParameterError, match=r"exclude everything.*only 180 m across"):
        plan(landscape, budget=0.1, method="random", width=200.0, protected=everything)


@pytest.fixture
def files(make_landscape, tmp_path):
    landscape = make_landscape((16, 21), relief=3.0)
    write_landscape(landscape, tmp_path / "land")
    grid = Grid.of(landscape["burnable"])
    left, top = grid.transform.c, grid.transform.f
    for name, edges in {"half": (0, -320, 200, 0), "far": (9e4, -320, 9.1e4, 0), "all": (-50, -400, 500, 50)}.items():
        place = box(left + edges[0], top + edges[1], left + edges[2], top + edges[3])
        write_vector(tmp_path / f"{name}.gpkg", gpd.GeoDataFrame({"people": [7]}, geometry=[place], crs=grid.crs))
    return tmp_path


def command(files, *words, code=0):
    layers = [str(files / f"land/{name}.tif") for name in ("elevation", "vegetation", "density")]
    named = [str(files / word) if word.endswith(".gpkg") else word for word in words]
    outcome = CliRunner().invoke(
        firebreak, ["plan", *layers, "-o", str(files / "out"), "--method", "random", "--runs", "3", *named]
    )
    assert outcome.exit_code == code, outcome.output
    return outcome.output


def test_the_command_says_all_that_is_wrong_with_its_files(files):
    text = command(
        files,
        "--protected",
        "far.gpkg",
        "--barriers",
        "far.gpkg",
        "--values",
        "half.gpkg",
        "--values-field",
        "houses",
        code=3,
    )
    for words in ("3 things", "protected does not touch", "barriers does not touch", "no field 'houses'", "people"):
        assert words in text
    assert "exclude everything" in command(files, "--protected", "all.gpkg", code=2)
    both = command(files, "--protected", "half.gpkg", "--allowed", "half.gpkg", code=2)
    assert "exclude everything" in both
    assert not list(files.glob("out/*.tif"))


def test_the_command_gives_its_account(files):
    text = command(files, "--allowed", "half.gpkg", "--width", "30", "--budget", "0.2")
    account = json.loads((files / "out/run.json").read_text())
    assert len(account["feasibility"]) >= 3
    for sentence in (*account["feasibility"], *account["warnings"]):
        assert sentence in text
    assert "breaks are at least 2 cells (40 m) wide" in account["feasibility"]
    assert "give --residual" in account["warnings"][-1]
    assert "--strict asks" in command(files, "--width", "30", "--strict", "--overwrite", code=2)
