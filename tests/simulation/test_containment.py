"""Crews that contain fires: at a time, by an attack that may fail, or never."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
import xarray as xr
from click.testing import CliRunner

from firebreak_gis import cluster, simulate
from firebreak_gis.cli import firebreak
from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.kernels.draws import PURPOSES
from firebreak_gis.lattice import NEVER
from firebreak_gis.rasters import write_raster
from firebreak_gis.simulation.budgets import burn_budgets
from firebreak_gis.simulation.containment import Containment, as_containment
from firebreak_gis.simulation.durations import as_duration
from firebreak_gis.simulation.holding import strongest
from firebreak_gis.simulation.products import Products
from firebreak_gis.simulation.request import FireRequest
from tests.simulation.test_timed import WINDY, ensemble, network_of

ATTACK = "attack:1h;size=3;intensity=8000;intense=0.6"


@pytest.mark.parametrize(
    "fires", [{}, {"duration": "2h"}, {"embers": WINDY, "duration": "uniform:1h,3h", "hold": "0.5"}]
)
@pytest.mark.parametrize("never", ["inf", "attack:inf;size=0"])
def test_never_changes_nothing(fires, never):
    network = network_of(3)
    breaks = np.zeros(network.shape)
    breaks[:, 9] = 1
    given = {"breaks": breaks, "n_runs": 30, "seed": 4, **fires}
    xr.testing.assert_identical(simulate(network, containment=never, **given), simulate(network, **given))


def test_infinite_containment_writes_the_same_bytes(tmp_path):
    network = network_of(5)
    write_raster(tmp_path / "network.tif", network.to_dataset())
    for name, more in (("without", []), ("never", ["--containment", "inf"]), ("soon", ["--containment", "30min"])):
        words = ["burn", str(tmp_path / "network.tif"), "--duration", "3h", "--runs", "40", *more]
        words += ["-o", str(tmp_path / f"{name}.tif"), "--sizes", str(tmp_path / f"{name}.csv")]
        outcome = CliRunner().invoke(firebreak, words)
        assert outcome.exit_code == 0, outcome.output
        assert ("fires are contained after 30 min (assumed)" in outcome.output) == (name == "soon")
    for ending in ("tif", "csv"):
        never, without, soon = ((tmp_path / f"{name}.{ending}").read_bytes() for name in ("never", "without", "soon"))
        assert never == without != soon
    assert (tmp_path / "soon.csv").read_text().splitlines()[1].endswith(",0.5")


def test_contained_fires_are_those_of_that_duration():
    network = network_of(1)
    contained = simulate(network, containment="40min,90min", n_runs=60, seed=2)
    ended = simulate(network, duration="40min,90min", n_runs=60, seed=2)
    np.testing.assert_array_equal(contained["burn_count"], ended["burn_count"])
    np.testing.assert_array_equal(contained["fire_size"], ended["fire_size"])
    assert contained["containment"].to_numpy()[:2].tolist() == [2400.0, 5400.0]
    both = simulate(network, containment="90min", duration="40min", n_runs=60, seed=2)
    np.testing.assert_array_equal(
        both["fire_size"], simulate(network, duration="40min", n_runs=60, seed=2)["fire_size"]
    )


def test_draws_are_keyed_and_those_of_no_other_purpose(tmp_path):
    law = "lognormal:1h,0.8"
    times = as_containment(law).of_runs(seed=7, n_runs=400)
    assert np.unique(times).size > 380
    assert abs(np.corrcoef(times, as_duration(law).of_runs(seed=7, n_runs=400))[0, 1]) < 0.2
    assert 3000 < np.median(times) < 4300
    np.testing.assert_array_equal(as_containment(law).of_runs(seed=7, n_runs=100, first_run=300), times[300:])
    assert PURPOSES.index("containment") > PURPOSES.index("places")
    network = network_of(2)
    whole = simulate(network, containment=law, n_runs=50, seed=3)
    with cluster(keep=tmp_path / "parts"):
        xr.testing.assert_identical(whole, simulate(network, containment=law, n_runs=50, seed=3))
    xr.testing.assert_identical(whole, simulate(network, containment=law, n_runs=50, seed=3, threads=1))


@pytest.mark.parametrize("changing", [None, False, True])
def test_attack_against_its_twin(changing):
    """Each run told from the arrival times of the fire that nobody fights."""
    network, weather = (network_of(6), None) if changing is None else (network_of(6), ensemble(6, changing=changing))
    crews = as_containment(ATTACK)
    given = {"weather": weather, "n_runs": 80, "seed": 5}
    free = simulate(network, products=Products(arrivals=True), **given)
    fought = simulate(network, containment=ATTACK, **given)
    cell = network.grid.cell_area_ha
    outcomes = set()
    for run in range(80):
        arrival = free["arrival"].to_numpy()[run].astype(float)
        arrival[arrival == NEVER] = np.inf
        if weather is None:
            intensity = strongest(network, "")
        else:
            made = weather[int(free["weather"][run])]
            intensity = np.mean([strongest(made.network, "", times) for times in made.times], axis=0)
        early = np.isfinite(arrival) & (arrival <= 3600)
        size, intense = early.sum() * cell, (early & (intensity > 8000)).sum() * cell
        held = size <= crews.size and intense <= crews.intense
        outcomes.add((bool(size <= crews.size), bool(intense <= crews.intense)))
        assert np.isfinite(fought["containment"][run]) == held
        assert fought["fire_size"][run] == (early.sum() if held else np.isfinite(arrival).sum())
    assert len(outcomes) >= 3  # the size alone, the intensity alone, and neither decide


def test_cutting_more_never_frees_a_contained_fire():
    network = network_of(8, shape=(24, 31), high=0.8)
    contained = []
    for share in (0.0, 0.1, 0.25):
        breaks = (np.random.default_rng(1).random(network.shape) < share).astype(float)
        contained.append(
            np.isfinite(simulate(network, breaks=breaks, containment=ATTACK, n_runs=150)["containment"].to_numpy())
        )
    assert 0 < contained[0].sum() < contained[2].sum()
    for fewer, more in pairwise(contained):
        assert (more | ~fewer).all()


def test_every_budget_has_its_crews():
    network = network_of(4)
    priority = network.grid.dataarray(np.random.default_rng(2).random(network.shape), "priority")
    request = FireRequest(n_runs=40, containment=as_containment(ATTACK))
    burnt = burn_budgets(network, priority, request, budgets=[0.0, 0.2])
    np.testing.assert_array_equal(burnt[:, 0], simulate(network, containment=ATTACK, n_runs=40)["fire_size"])


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ("soon", "soon"),
        ("attack", "attack"),
        ("attack:1h;size", "size"),
        ("attack:1h;speed=3", "size, intensity, intense"),
        ("attack:1h;size=-2", "at least 0"),
        ("weather", "no matter of the weather"),
    ],
)
def test_what_is_no_containment_is_refused(given, told):
    with pytest.raises(ParameterError, match=told):
        as_containment(given)


def test_what_it_needs():
    base = network_of(1)
    from firebreak_gis import SpreadNetwork

    timeless = SpreadNetwork(base.probability, burnable=base.burnable)
    with pytest.raises(InputError, match="containment"):
        simulate(timeless, containment="1h", n_runs=3)
    cold = SpreadNetwork(base.probability, burnable=base.burnable, travel_time=base.travel_time)
    assert simulate(cold, containment="1h", n_runs=3)["containment"][0] == 3600
    with pytest.raises(InputError, match="attack"):
        simulate(cold, containment="attack:1h", n_runs=3)
    assert Containment().endless
    assert math.isinf(Containment().time.values[0])
