"""Networks in dask arrays: block by block, none before it is asked for, and equal to those made at once."""

import sys

import dask
import numpy as np
import pytest

import firebreak_gis as fb
from firebreak_gis.errors import InputError, MissingComponentError, ParameterError


@pytest.fixture(scope="module")
def landscape():
    return fb.read_landscape(**fb.sample_layers(), resolution=150.0)


@pytest.mark.parametrize("chunks", [{"y": 17, "x": 23}, {"y": 1}, {"x": 1000}, None])
@pytest.mark.parametrize("given", [{}, {"clock": True, "neighbourhood": "von_neumann"}])
def test_equal_to_the_network_made_at_once(landscape, chunks, given):
    wind = np.random.default_rng(1).uniform(0.0, 9.0, landscape["burnable"].shape)
    given = {"wind_speed": wind, "wind_from_direction": 300.0, **given}
    lazy = fb.lazy_network(landscape if chunks is None else landscape.chunk(chunks), **given)
    assert lazy["spread_probability"].chunks is not None
    whole = fb.spread_network(landscape, **given).to_dataset()
    assert set(lazy.data_vars) == set(whole.data_vars)
    assert lazy.compute().identical(whole)


def test_nothing_is_computed_but_what_is_asked_for(landscape):
    """A layer that cannot be read spoils the blocks that need it, and no other."""
    import dask.array as da

    def spoilt(block, block_info=None):
        if block_info[0]["chunk-location"] == (1, 1):
            raise OSError("cannot be read")
        return block

    chunked = landscape.chunk({"y": 20, "x": 20})
    elevation = chunked["elevation"].copy(data=da.map_blocks(spoilt, chunked["elevation"].data, dtype="float32"))
    lazy = fb.lazy_network(chunked.assign(elevation=elevation))["spread_probability"]
    whole = fb.spread_network(landscape).to_raster()
    np.testing.assert_array_equal(lazy[..., 60:].to_numpy(), whole[..., 60:].to_numpy())
    with pytest.raises(OSError, match="cannot be read"):
        lazy[:, 20:40, 20:40].compute()


def test_steps_that_must_see_all_compute(landscape):
    """Landscapes in dask arrays go into everything, with equal results."""
    chunked = landscape.chunk({"y": 20, "x": 20})
    assert dask.is_dask_collection(chunked)
    network = fb.spread_network(chunked, clock=True, wind_speed=5.0)
    other = fb.spread_network(landscape, clock=True, wind_speed=5.0)
    np.testing.assert_array_equal(network.probability, other.probability)
    np.testing.assert_array_equal(network.travel_time, other.travel_time)
    weather = "rose:NW=5x0.4,N=36km/hx0.2;duration=1h"
    burns, wanted = (
        fb.simulate(networks[0].network, weather=networks, duration="weather", n_runs=10)
        for networks in (fb.weather_networks(each, weather) for each in (chunked, landscape))
    )
    assert burns.identical(wanted)
    made, alone = (fb.plan(each, method="degree", budget="5%", n_runs=10) for each in (chunked, landscape))
    assert made.breaks.equals(alone.breaks)
    assert made.summary == alone.summary


def test_refused_with_what_to_do(landscape, monkeypatch):
    with pytest.raises(ParameterError, match="must see the whole landscape"):
        fb.lazy_network(fb.forest((12, 20), seed=1), model="artificial")
    with pytest.raises(ParameterError, match="torus"):
        fb.lazy_network(landscape.assign_attrs(boundary="periodic"))
    with pytest.raises((InputError, KeyError)):
        fb.lazy_network(landscape.drop_vars("elevation"))
    monkeypatch.setitem(sys.modules, "dask.delayed", None)
    with pytest.raises(MissingComponentError, match=r"firebreak_gis\[scale\]"):
        fb.lazy_network(landscape)
