"""`firebreak plan` on real landscapes, one command each; the files are opened anew by other means."""

import json

import geopandas as gpd
import numpy as np
import pytest
import rasterio
from click.testing import CliRunner

from firebreak_gis.cli import firebreak

pytestmark = pytest.mark.shared

RHODES, IRELAND, GIRONA = "rhodes_20m/rhodes_", "ireland_aniso/", "vilopriu_2013/"
CASES = {
    "rhodes, three layers": (
        [f"{RHODES}dem.tif", f"{RHODES}vegetation.tif", f"{RHODES}density.tif"],
        [],
        (32635, 20.0, (512, 512)),
    ),
    "rhodes, fuel map": (
        [f"{RHODES}dem.tif", f"{RHODES}fuel12.tif"],
        ["--legend", "eu12"],
        (32635, 20.0, (512, 512)),
    ),
    "ireland": ([f"{IRELAND}dem_clip.tif", f"{IRELAND}veg_clip.tif"], ["--legend", "prop6"], (32629, 20.0, None)),
    "girona": (
        [f"{GIRONA}elevation.tif", f"{GIRONA}fuels.tif", f"{GIRONA}ccf.tif"],
        ["--legend", "scott_burgan_40", "--density-legend", "canopy_cover", "--unknown", "nonburnable"],
        (25831, 20.0, (610, 508)),
    ),
}


@pytest.fixture(scope="module", params=CASES)
def case(request, tmp_path_factory):
    from tests.places import SHARED

    layers, options, grid = CASES[request.param]
    if not SHARED.is_dir():
        pytest.skip("the real landscapes are not here")
    paths = [str(SHARED / name) for name in layers]
    folder = tmp_path_factory.mktemp("plan") / "out"
    words = [
        "plan",
        *paths,
        "-o",
        str(folder),
        "--budget",
        "0.05",
        "--method",
        "flammability",
        "--runs",
        "30",
        *options,
    ]
    outcome = CliRunner().invoke(firebreak, words)
    assert outcome.exit_code == 0, outcome.output
    return paths, folder, grid


def read(path):
    with rasterio.open(path) as file:
        return file.read(1, masked=True)


def test_grid_and_counts(case):
    _, folder, (epsg, cell, shape) = case
    grids = set()
    for path in folder.glob("*.tif"):
        with rasterio.open(path) as file:
            grids.add((file.crs.to_epsg(), file.transform, file.shape))
    assert len(grids) == 1
    found_epsg, transform, found_shape = grids.pop()
    assert found_epsg == epsg
    assert transform.a == -transform.e == cell
    assert shape is None or found_shape == shape
    fuel = ~read(folder / "priority.tif").mask
    cut = read(folder / "breaks.tif").filled(0) == 1
    assert cut.sum() == int(0.05 * fuel.sum() + 0.5)
    assert gpd.read_file(folder / "breaks.gpkg")["cells"].sum() == cut.sum()
    before, after = read(folder / "burn_frequency.tif"), read(folder / "burn_frequency_with_breaks.tif")
    assert (after <= before).all()
    summary = json.loads((folder / "run.json").read_text())["summary"]
    assert summary["burnable_cells"] == fuel.sum()
    assert 0 < summary["burnt_share_with_breaks"] < summary["burnt_share_without_breaks"] <= 1
    assert summary["burnt_share_without_breaks"] * fuel.sum() == pytest.approx(
        before.compressed().astype(float).sum(), rel=1e-4
    )


def test_layers_are_those_that_went_in(case):
    """Cell centres looked up in the inputs one by one: elevation close, fuel where the fuel map has it."""
    paths, folder, _ = case
    with rasterio.open(folder / "elevation.tif") as file:
        heights, transform = file.read(1, masked=True), file.transform
        crs = file.crs
    rng = np.random.default_rng(0)
    rows = rng.integers(5, heights.shape[0] - 5, 300)
    cols = rng.integers(5, heights.shape[1] - 5, 300)
    points = [transform @ (c + 0.5, r + 0.5) for r, c in zip(rows.tolist(), cols.tolist(), strict=True)]
    vegetation = read(folder / "vegetation.tif").filled(0)[rows, cols]
    with rasterio.open(paths[0]) as dem, rasterio.open(paths[1]) as fuel:
        assert dem.crs.to_epsg() == crs.to_epsg()
        z = np.array([value[0] for value in dem.sample(points)], float)
        codes = np.array([value[0] for value in fuel.sample(points)])
    valid = ~heights.mask[rows, cols] if heights.mask.ndim else np.ones(300, bool)
    relief = np.abs(heights.data[rows, cols] - z)[valid & (np.abs(z) < 9000)]
    assert np.median(relief) < 1.0
    assert relief.max() < 30.0
    # One code has one class wherever it stands (a rare cell on an edge may be read from its neighbour).
    odd = 0
    for code in np.unique(codes):
        classes = np.bincount(vegetation[codes == code], minlength=4)
        odd += classes.sum() - classes.max()
    assert odd <= 3
