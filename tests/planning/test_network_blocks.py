"""A network made block by block is that of the whole landscape, and so are fires in windows of its files."""

from __future__ import annotations

import hashlib
from pathlib import Path

import numpy as np
import pytest
import rasterio
from click.testing import CliRunner

import firebreak_gis as fb
from firebreak_gis import memory
from firebreak_gis.cli import firebreak
from firebreak_gis.landscape.folder import LandscapeFolder, read_landscape_folder, write_landscape
from firebreak_gis.planning.blocks import NetworkBlocks
from firebreak_gis.planning.weather import SpreadRequest
from firebreak_gis.rasters.blocks import ROWS, rows_of
from firebreak_gis.spread import spread_network
from firebreak_gis.spread.raster import NetworkFile

pytestmark = pytest.mark.usefixtures("no_pictures")


@pytest.fixture(scope="module")
def folder(tmp_path_factory, sample_paths):
    place = tmp_path_factory.mktemp("land") / "land"
    write_landscape(fb.read_landscape(**sample_paths, resolution=14.0), place)
    return place


@pytest.mark.parametrize("clock", [False, True])
def test_blocks_are_those_of_the_whole(folder, clock):
    spread = SpreadRequest(wind_speed=5.0, wind_from=315.0, clock=clock)
    landscape = read_landscape_folder(folder)
    assert landscape.sizes["y"] > 2 * ROWS - 20
    whole = spread_network(landscape, **spread.params(landscape))
    made = NetworkBlocks(LandscapeFolder(folder), spread, cells=1)
    found = list(made)
    assert [row for row, _ in found] == list(range(0, landscape.sizes["y"], ROWS))
    for name, plane in whole.to_dataset().data_vars.items():
        parts = np.concatenate([data[name].to_numpy() for _, data in found], axis=-2)
        np.testing.assert_array_equal(parts, plane.to_numpy())
    assert made.n_burnable == whole.n_burnable
    assert made.mean == pytest.approx(whole.probability[:, whole.burnable].mean(dtype=float))
    if clock:
        rates = whole.rate()[whole.probability > 0]
        assert made.rate == pytest.approx(float(np.median(rates)), abs=0.1)
    else:
        assert made.rate is None


def _hashes(place: Path) -> dict[str, str]:
    return {f.name: hashlib.sha256(f.read_bytes()).hexdigest() for f in sorted(place.iterdir()) if f.is_file()}


def test_commands_give_the_same_bytes(folder, tmp_path, monkeypatch):
    made = []
    for name, cells, window in (
        ("whole", memory.BLOCK_CELLS, []),
        ("w64", 1, ["--window", "64"]),
        ("w512", 1, ["--window", "512"]),
    ):
        monkeypatch.setattr(memory, "BLOCK_CELLS", cells)
        place = tmp_path / name
        place.mkdir()
        weather = tmp_path / "weather.csv"
        weather.write_text("wind_speed,wind_from,weight\n3,315,2\n8,200,1\n")
        wind = ["--wind-speed", "5", "--wind-from", "315"]
        fires = ["--runs", "20", "--duration", "3h", "--hold", "0.47"]
        for words in (
            ["network", str(folder), "-o", str(place / "net.tif"), "--clock", *wind],
            [
                "burn",
                str(place / "net.tif"),
                "-o",
                str(place / "a.tif"),
                "--sizes",
                str(place / "a.csv"),
                *fires,
                *window,
            ],
            ["burn", str(folder), "-o", str(place / "b.tif"), "--embers", "on", *wind, *fires, *window],
            ["burn", str(folder), "-o", str(place / "c.tif"), "--weather", str(weather), *fires, *window],
        ):
            done = CliRunner().invoke(firebreak, words)
            assert done.exit_code == 0, done.output
        made.append(_hashes(place))
    nets = [{"net.tif": each.pop("net.tif")} for each in made]
    assert made[0] == made[1] == made[2]
    assert nets[1] == nets[2]
    with rasterio.open(tmp_path / "whole/net.tif") as whole, rasterio.open(tmp_path / "w64/net.tif") as parts:
        np.testing.assert_array_equal(whole.read(), parts.read())
        assert (whole.tags(), whole.profile) == (parts.tags(), parts.profile)


def test_what_has_no_windows_is_refused(folder, tmp_path):
    out = str(tmp_path / "x.tif")
    for words, text in (
        (["--window", "100"], "power of two"),
        (["--window", "64", "--products", str(tmp_path / "p")], "--products"),
        (["--window", "64", "--hold", "flame"], "as a whole"),
        (["--window", "64", "--model", "artificial"], "whole map"),
    ):
        done = CliRunner().invoke(firebreak, ["burn", str(folder), "-o", out, "--duration", "1h", *words])
        assert done.exit_code == 2 or done.exit_code == 3, done.output
        assert text in done.output
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("method", ["degree", "bonacich", "flammability", "dissection"])
def test_a_network_that_stays_on_the_disk_is_ranked_alike(folder, tmp_path, monkeypatch, method):
    net = str(tmp_path / "net.tif")
    made = CliRunner().invoke(firebreak, ["network", str(folder), "-o", net, "--wind-speed", "4", "--wind-from", "90"])
    assert made.exit_code == 0, made.output
    whole = NetworkFile(net).read()
    parts = NetworkFile(net).on_disk(tmp_path, cells=5000)
    assert isinstance(parts.probability.base, np.memmap) or isinstance(parts.probability, np.memmap)
    np.testing.assert_array_equal(parts.probability, whole.probability)
    np.testing.assert_array_equal(parts.burnable, whole.burnable)
    assert parts.grid == whole.grid
    out = [str(tmp_path / name) for name in ("whole.tif", "disk.tif")]
    for path, cells in zip(out, (10**9, 3000), strict=True):
        monkeypatch.setattr("firebreak_gis.cli.commands.rank.BLOCK_CELLS", cells)
        monkeypatch.setitem(rows_of.__kwdefaults__, "cells", cells)
        done = CliRunner().invoke(firebreak, ["rank", net, "-o", path, "--method", method])
        assert done.exit_code == 0, done.output
    with rasterio.open(out[0]) as one, rasterio.open(out[1]) as other:
        np.testing.assert_array_equal(one.read(), other.read())
        assert (one.tags(), one.tags(1), one.profile) == (other.tags(), other.tags(1), other.profile)
    assert sorted(each.name for each in tmp_path.iterdir() if each.suffix == ".tif") == [
        "disk.tif",
        "net.tif",
        "whole.tif",
    ]


def test_rows_of_a_network_end_at_its_borders_alike(tmp_path):
    """Edges that leave the map or enter bare ground are taken out of blocks as out of the whole."""
    random = np.random.default_rng(2)
    probability = random.random((8, 37, 29)).astype(np.float32)
    bare = random.random((37, 29)) < 0.2
    network = fb.SpreadNetwork(probability, burnable=~bare)
    path = fb.write_raster(tmp_path / "net.tif", network.to_raster())
    for cells in (29, 100, 10_000):
        found = NetworkFile(path).on_disk(tmp_path, cells=cells)
        np.testing.assert_array_equal(found.probability, network.probability)
        np.testing.assert_array_equal(found.burnable, network.burnable)
        assert not found.probability.flags.writeable


def test_ranking_on_the_disk_asks_for_less_memory():
    cells = 100_000_000
    whole = memory.bytes_for("rank", cells, method="dissection", threads=1)
    disk = memory.bytes_for("rank", cells, method="dissection", threads=1, blocks=True)
    assert whole - disk == 32 * cells
    few = memory.BLOCK_CELLS
    assert memory.bytes_for("rank", few, method="degree", blocks=True) == memory.bytes_for("rank", few, method="degree")


def test_all_bands_of_a_window_are_read_in_one_go(folder, tmp_path, monkeypatch):
    """Bands lie cell by cell in the file: each look at it decodes the tiles of all of them."""
    from firebreak_gis.rasters import reading

    net = str(tmp_path / "net.tif")
    wind = ["--wind-speed", "4", "--wind-from", "90"]
    assert CliRunner().invoke(firebreak, ["network", str(folder), "-o", net, "--clock", *wind]).exit_code == 0
    file, whole = NetworkFile(net), NetworkFile(net).read()
    looks = []
    opened = reading.open_raster
    monkeypatch.setattr(reading, "open_raster", lambda *args, **more: looks.append(args) or opened(*args, **more))
    part = file.read((40, 30, 50, 60))
    assert len(looks) == 1
    inner = (slice(None), slice(41, 89), slice(31, 89))  # edges end at the rims of a window
    near = (slice(None), slice(1, 49), slice(1, 59))
    for name in ("probability", "travel_time"):
        np.testing.assert_array_equal(getattr(part, name)[near], getattr(whole, name)[inner])
    np.testing.assert_array_equal(part.heat, whole.heat[40:90, 30:90])
