"""Networks in few bits: errors stay below what the file states, and fires hardly change."""

from __future__ import annotations

import numpy as np
import pytest
import rasterio
from click.testing import CliRunner

import firebreak_gis as fb
from firebreak_gis.cli import firebreak
from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.lattice import LONGEST
from firebreak_gis.rasters import read_raster
from firebreak_gis.rasters.packing import largest_error, pack, packed, unpack
from firebreak_gis.schema import VARIABLES
from firebreak_gis.spread.raster import NetworkFile


@pytest.fixture(scope="module")
def land(tmp_path_factory, sample_paths):
    place = tmp_path_factory.mktemp("land") / "land"
    layers = [str(sample_paths[name]) for name in ("dem", "vegetation", "density")]
    assert CliRunner().invoke(firebreak, ["align", *layers, "-o", str(place), "--res", "60"]).exit_code == 0
    return place


def made(land, out, *words):
    wind = ("--wind-speed", "5", "--wind-from", "315", "--clock")
    done = CliRunner().invoke(firebreak, ["network", str(land), "-o", str(out), *wind, *words])
    assert done.exit_code == 0, done.output
    return done.output


@pytest.mark.parametrize("bits", [8, 16])
@pytest.mark.parametrize("name", ["spread_probability", "travel_time", "heat"])
def test_errors_are_those_stated_and_not_much_less(name, bits):
    variable = packed(VARIABLES[name], bits)
    random = np.random.default_rng(bits)
    shape = (3, 50, 400)
    values = random.random(shape) if name == "spread_probability" else LONGEST ** random.random(shape)
    values = values.astype(np.float32)
    values[0, 0, :3] = 0.0, 1.0, 1.0 if name == "spread_probability" else LONGEST
    missing = random.random(shape) < 0.1
    missing[0, 0, :3] = False
    codes = pack(np.where(missing, np.nan, values), missing, variable)
    assert codes.dtype == f"uint{bits}"
    found = unpack(codes, variable)
    np.testing.assert_array_equal(np.isnan(found), missing)
    error = np.abs(found.astype(float) - values)
    if name != "spread_probability":
        error /= np.maximum(values, 1.0)
    worst = float(error[~missing].max())
    assert 0.95 * largest_error(name, bits) < worst <= largest_error(name, bits)
    np.testing.assert_array_equal(found[0, 0, :3], values[0, 0, :3])
    # What was packed once stays as it is.
    np.testing.assert_array_equal(pack(found, missing, variable), codes)


def test_what_cannot_be_packed_is_refused(tmp_path):
    with pytest.raises(ParameterError, match="bits is 4"):
        packed(VARIABLES["heat"], 4)
    with pytest.raises(ParameterError, match="priority cannot be packed"):
        packed(VARIABLES["priority"], 8)
    with pytest.raises(InputError, match="more than the 16777216"):
        pack(np.full((2, 2), 1e9), np.zeros((2, 2), bool), packed(VARIABLES["heat"], 16))


@pytest.mark.parametrize("bits", ["8", "16"])
def test_a_network_in_few_bits_is_read_as_any_other(land, tmp_path, bits, monkeypatch):
    exact, few = tmp_path / "exact.tif", tmp_path / "few.tif"
    made(land, exact)
    told = made(land, few, "--bits", bits)
    error, relative = largest_error("spread_probability", int(bits)), largest_error("travel_time", int(bits))
    assert f"error of probability at most {error:.2g}, relative error of time at most {relative:.2g}" in told
    assert few.stat().st_size < (0.8 if bits == "16" else 0.5) * exact.stat().st_size
    with rasterio.open(few) as file:
        assert set(file.dtypes) == {f"uint{bits}"}
        assert float(file.tags()["FIREBREAK_ERROR_OF_PROBABILITY"]) == error
        assert float(file.tags()["FIREBREAK_RELATIVE_ERROR_OF_TIME"]) == relative
        assert file.tags(9)["largest_error"] == f"{relative:.2g}"
        shown = file.read(3, masked=True) * file.scales[2]
        assert set(file.block_shapes) == {(256, 256)}
    one, other = NetworkFile(exact).read(), NetworkFile(few).read()
    np.testing.assert_allclose(shown.filled(0.0), other.probability[2], atol=1e-6)
    np.testing.assert_array_equal(other.burnable, one.burnable)
    assert 0.0 < np.abs(other.probability - one.probability).max() <= error
    edges = (one.probability > 0) & (other.probability > 0)
    apart = np.abs(other.travel_time[edges].astype(float) - one.travel_time[edges])
    assert (apart <= relative * one.travel_time[edges] + 0.5).all()
    if bits == "16":  # there whole seconds up to an hour are exact
        assert not apart[one.travel_time[edges] < 3600].any()
    assert apart.max() > 0
    np.testing.assert_allclose(other.heat, one.heat, rtol=largest_error("heat", int(bits)))
    # Blocks and windows hold what the whole holds.
    if bits == "16":
        blocks = tmp_path / "blocks.tif"
        monkeypatch.setattr("firebreak_gis.memory.BLOCK_CELLS", 1)
        made(land, blocks, "--bits", bits)
        assert rasterio.open(blocks).read().tobytes() == rasterio.open(few).read().tobytes()
    disk = NetworkFile(few).on_disk(tmp_path, cells=2000)
    np.testing.assert_array_equal(disk.probability, other.probability)
    part = NetworkFile(few).read((10, 20, 30, 40))
    np.testing.assert_array_equal(part.probability[:, 1:-1, 1:-1], other.probability[:, 11:39, 21:59])
    with pytest.raises(InputError, match="packed into"):
        read_raster(few, band=3)


def test_burnt_area_changes_by_less_than_its_sampling_error(land, tmp_path):
    sizes = {}
    for bits in ("exact", "16"):
        made(land, tmp_path / f"{bits}.tif", "--bits", bits)
        burns = fb.simulate(fb.read_network(tmp_path / f"{bits}.tif"), n_runs=400, duration="6h", seed=3)
        sizes[bits] = burns["fire_size"].to_numpy().astype(float)
    error = sizes["exact"].std(ddof=1) / np.sqrt(sizes["exact"].size)
    assert error > 0.0
    assert abs(sizes["16"].mean() - sizes["exact"].mean()) < error
