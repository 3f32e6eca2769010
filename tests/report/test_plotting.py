"""A first look: every result that people hold has a picture that shows its numbers."""

import numpy as np
import pytest

import firebreak_gis as fb


@pytest.fixture(scope="module")
def network():
    return fb.spread_network(fb.forest((12, 20), seed=1), model="artificial")


def shown(figure):
    return figure.axes[0].get_images()[0].get_array()


def test_maps_show_their_numbers(network):
    burns = fb.simulate(network, n_runs=20, seed=1)
    np.testing.assert_allclose(shown(fb.plot(burns)).filled(np.nan), burns["burn_frequency"].to_numpy())
    mean = np.where(network.burnable, network.probability.mean(axis=0), np.nan)
    np.testing.assert_allclose(shown(fb.plot(network)).filled(np.nan), mean)
    priority = fb.rank(network, "degree")
    drawn = shown(fb.plot(priority))
    assert drawn.mask.sum() == (~np.isfinite(priority.to_numpy())).sum()


def test_breaks_are_drawn(network):
    breaks = fb.select_breaks(fb.rank(network, "degree"), budget=0.1)
    plain, with_breaks = fb.plot(network), fb.plot(network, breaks=breaks)
    assert len(with_breaks.axes[0].get_children()) > len(plain.axes[0].get_children())


def test_curves(network):
    ranked = {name: fb.rank(network, name) for name in ("degree", "random")}
    curves = fb.evaluate(network, ranked, budgets=[0.0, 0.1, 0.2], n_runs=10)
    assert len(fb.plot(curves).axes[0].get_lines()) >= 2


def test_other_things_are_refused():
    with pytest.raises(fb.FirebreakError, match="expected a plan, segments"):
        fb.plot(3)
