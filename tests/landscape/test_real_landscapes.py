"""`firebreak plan` on real landscapes, one command each; the files are opened anew by other means."""

import json

import geopandas as gpd
import numpy as np
import pytest
import rasterio
from click.testing import CliRunner
from rasterio.warp import transform as transform_points

from firebreak_gis.cli import firebreak

pytestmark = pytest.mark.shared


def made_up_fuel(folder, dem):
    """Classes by height on the cells of a DEM."""
    with rasterio.open(dem) as source:
        heights, profile = source.read(1), source.profile
    codes = np.digitize(heights, np.quantile(heights, [0.1, 0.4, 0.7])).astype("uint8")
    profile = {k: profile[k] for k in ("driver", "height", "width", "count", "crs", "transform")}
    with rasterio.open(folder / "fuel.tif", "w", dtype="uint8", **profile) as target:
        target.write(codes, 1)
    return str(folder / "fuel.tif")


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
    "liguria": (
        ["spotorno_20m/src_spotorno_dem.tif", "spotorno_20m/src_spotorno_fuel.tif"],
        ["--legend", "eu12"],
        (32632, 20.0, (512, 512)),
    ),
    "california": (
        [f"us_ca_30m/{name}_UTM_resampled30m.tif" for name in ("Elevation", "FBFM", "CC")],
        ["--legend", "scott_burgan_40", "--density-legend", "canopy_cover"],
        (32610, 30.0, (564, 522)),
    ),
    "chile": (
        ["portezuelo_100m/elevation.tif", "portezuelo_100m/fuels.tif"],
        ["--legend", "kitral", "--unknown", "nonburnable"],
        (32718, 100.02265625, (80, 80)),
    ),
    "alberta, grids of text": (
        ["sub20/elevation.asc", "sub20/fuels.asc"],
        ["--legend", "fbp", "--ignitions", "sub20/IgnitionProbability.asc"],
        (3400, 100.0, (20, 20)),
    ),
    "alberta, bands of one file": (
        ["sub20/Input_Geotiff.tif"] * 2,
        ["--legend", "fbp", "--bidx", "dem=3", "--bidx", "vegetation=1", "--src-crs", "EPSG:3400"],
        (3400, 100.0, (20, 20)),
    ),
    "texas, a DEM in degrees": (
        ["geographic_dem/dem.tif", made_up_fuel],
        [],
        (32614, 85.0, None),
    ),
}
#: What is refused at first, and the words of the sentence, which name what was done above.
REFUSED = {
    "chile": (
        ["portezuelo_100m/elevation.tif", "portezuelo_100m/fuels.tif", "--legend", "kitral"],
        ["34 (11.005 ha)", "--unknown nonburnable"],
    ),
    "alberta": (
        [
            "sub20/Input_Geotiff.tif",
            "sub20/Input_Geotiff.tif",
            "--legend",
            "fbp",
            "--bidx",
            "dem=3",
            "--bidx",
            "vegetation=1",
        ],
        ["claims degrees", "--src-crs"],
    ),
    "alberta, which band": (["sub20/elevation.asc", "sub20/Input_Geotiff.tif", "normal"], ["has 5 bands", "--bidx"]),
    "girona": (
        [f"{GIRONA}elevation.tif", f"{GIRONA}fuels.tif", "--legend", "scott_burgan_40"],
        ["0 (", "--unknown nonburnable"],
    ),
    "two islands": (["geographic_dem/dem.tif", f"{RHODES}fuel12.tif", "--legend", "eu12"], ["do not overlap"]),
    "a DEM as fuel": (["geographic_dem/dem.tif"] * 2, ["no density"]),
}


@pytest.fixture(scope="module", params=CASES)
def case(request, tmp_path_factory):
    from tests.places import SHARED

    layers, options, grid = CASES[request.param]
    if not SHARED.is_dir():
        pytest.skip("the real landscapes are not here")
    place = tmp_path_factory.mktemp("plan")
    paths: list[str] = []
    for layer in layers:
        paths.append(layer(place, paths[0]) if callable(layer) else str(SHARED / layer))
    if callable(layers[-1]):
        paths.append("continuity")
    folder = place / "out"
    options = [str(SHARED / word) if word.endswith(".asc") else word for word in options]
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
        "20",
        *options,
    ]
    outcome = CliRunner().invoke(firebreak, words)
    assert outcome.exit_code == 0, outcome.output
    return paths, folder, grid


def read(path):
    with rasterio.open(path) as file:
        return file.read(1, masked=True)


@pytest.mark.parametrize("name", REFUSED)
def test_refused_with_the_way_out(name, tmp_path):
    from tests.places import SHARED

    if not SHARED.is_dir():
        pytest.skip("the real landscapes are not here")
    words, parts = REFUSED[name]
    words = [str(SHARED / word) if "/" in word else word for word in words]
    outcome = CliRunner().invoke(firebreak, ["align", *words, "-o", str(tmp_path / "out")])
    assert outcome.exit_code == 3, outcome.output
    for part in parts:
        assert part in outcome.output
    assert not (tmp_path / "out").exists()


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
        if "Input" not in paths[0]:  # that one says degrees of metres
            points = list(zip(*transform_points(crs, dem.crs, *zip(*points, strict=True)), strict=True))
        z = np.array([value[-1] if dem.count == 1 else value[2] for value in dem.sample(points)], float)
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
