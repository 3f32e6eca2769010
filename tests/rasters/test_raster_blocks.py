"""Rasters written block by block are, to the byte, those written at once."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

from firebreak_gis.errors import InputError, OutputError
from firebreak_gis.grid import Grid
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.rasters import VariableFile, write_blocks, write_raster
from firebreak_gis.rasters.blocks import ROWS


@pytest.fixture(scope="module")
def network():
    from affine import Affine

    rng = np.random.default_rng(0)
    shape = (700, 300)
    return SpreadNetwork(
        rng.uniform(0.1, 0.9, (8, *shape)),
        burnable=rng.random(shape) < 0.8,
        crs="EPSG:32635",
        transform=Affine(25.0, 0.0, 5e5, 0.0, -25.0, 4e6),
        travel_time=rng.integers(50, 900, (8, *shape)).astype(float),
        heat=rng.uniform(1e4, 4e4, shape),
    )


def in_blocks(data, step):
    for row in range(0, data.sizes["y"], step):
        yield row, data.isel(y=slice(row, row + step))


@pytest.mark.parametrize("step", [ROWS, 2 * ROWS, 4 * ROWS])
def test_the_bytes_are_those_of_the_whole(network, step, tmp_path):
    data = network.to_dataset()
    told = {"provenance": {"seed": 3, "note": "é"}, "creation_options": {"compress": "LZW"} if step > ROWS else None}
    whole = write_raster(tmp_path / "whole.tif", data, **told)
    parts = write_blocks(tmp_path / "parts.tif", in_blocks(data, step), network.grid, **told)
    assert parts.read_bytes() == whole.read_bytes()
    assert parts.with_suffix(".qml").read_bytes() == whole.with_suffix(".qml").read_bytes()
    assert sorted(p.name for p in tmp_path.iterdir()) == ["parts.qml", "parts.tif", "whole.qml", "whole.tif"]


def test_classes_keep_their_colours(tmp_path, network):
    from firebreak_gis.schema import annotate

    mask = annotate(network.grid.dataarray(network.burnable.astype(np.uint8), "breaks"))
    whole = write_raster(tmp_path / "whole.tif", mask)
    parts = write_blocks(tmp_path / "parts.tif", in_blocks(xr.Dataset({"breaks": mask}), ROWS), network.grid)
    assert parts.read_bytes() == whole.read_bytes()


def test_blocks_that_do_not_fit_are_refused_and_nothing_is_left(network, tmp_path):
    data = network.to_dataset()
    for rows in ([(0, slice(0, 256)), (300, slice(300, 700))], [(0, slice(0, 512))]):
        with pytest.raises(InputError, match="row"):
            write_blocks(tmp_path / "a.tif", ((row, data.isel(y=part)) for row, part in rows), network.grid)
    with pytest.raises(OutputError, match=r"\.tif"):
        write_blocks(tmp_path / "a.png", [], network.grid)
    assert list(tmp_path.iterdir()) == []


def test_windows_of_a_file_are_those_of_its_whole(network, tmp_path):
    import rasterio

    path = write_raster(tmp_path / "n.tif", network.to_raster())
    turned = tmp_path / "turned.tif"
    with rasterio.open(path) as source, rasterio.Env(GDAL_PAM_ENABLED="NO"):
        grid = Grid(network.shape, source.transform, network.grid.crs)
        profile = {
            **source.profile,
            "driver": "GTiff",
            "transform": source.transform * source.transform.translation(0, 700) * source.transform.scale(1, -1),
        }
        with rasterio.open(turned, "w", **profile) as target:
            target.write(source.read()[:, ::-1])
            for band, text in enumerate(source.descriptions, start=1):
                target.set_band_description(band, text)
    window = (30, 17, 200, 64)
    for file in (VariableFile(path, "spread_probability"), VariableFile(turned, "spread_probability")):
        whole, part = file.read(), file.read(window)
        np.testing.assert_array_equal(part, whole[:, 30:230, 17:81])
        np.testing.assert_array_equal(np.nan_to_num(whole), network.probability)
        np.testing.assert_allclose(file.part(window).x, grid.x[17:81])
        np.testing.assert_allclose(file.part(window).y, grid.y[30:230])
