"""Fixtures for tests in a real QGIS: the provider, layers to work on, the command line to compare with."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from osgeo import gdal
from stand_ins import make_wheel

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "qgis_plugin"))

gdal.UseExceptions()

#: Coarse cells and few fires, so that a run takes a second.
QUICK = {"RESOLUTION": 90, "N_RUNS": 10}


@pytest.fixture(scope="session")
def provider(qgis_app, qgis_processing):
    """The provider, registered."""
    from firebreak.provider import FirebreakProvider
    from qgis.core import QgsApplication

    registered = FirebreakProvider()
    QgsApplication.processingRegistry().addProvider(registered)
    yield registered
    QgsApplication.processingRegistry().removeProvider(registered)


@pytest.fixture(scope="session")
def data(tmp_path_factory):
    """A copy of the sample layers in a folder with a space and other letters."""
    folder = tmp_path_factory.mktemp("Δάσος data")
    for path in (ROOT / "sample_data").glob("*.*"):
        if path.suffix in (".tif", ".gpkg"):
            shutil.copy(path, folder)
    return folder


@pytest.fixture(scope="session")
def layers(data):
    """The three rasters as parameters."""
    return {f"INPUT_{name.upper()}": str(data / f"{name}.tif") for name in ("dem", "vegetation", "density")}


@pytest.fixture
def engine_wheel(tmp_path):
    """A wheel that stands in for the engine's."""
    return make_wheel(tmp_path)


def firebreak(*words: object) -> None:
    """Run the command line."""
    subprocess.run(
        [os.environ["FIREBREAK_PYTHON"], "-I", "-X", "utf8", "-m", "firebreak_gis", *map(str, words), "-q"], check=True
    )


@pytest.fixture(scope="session")
def reference(data, tmp_path_factory):
    """What the command line makes of the same layers, step by step and in one go."""
    folder = tmp_path_factory.mktemp("reference")
    dem, vegetation, density = (data / f"{name}.tif" for name in ("dem", "vegetation", "density"))
    runs = ("--runs", QUICK["N_RUNS"])
    firebreak("align", "--res", QUICK["RESOLUTION"], "-o", folder / "landscape", dem, vegetation, density)
    firebreak("network", "--wind-speed", 8, "--wind-from", 315, "-o", folder / "network.tif", folder / "landscape")
    firebreak("rank", "--method", "bonacich", "-p", "beta=0.3", "-o", folder / "priority.tif", folder / "network.tif")
    firebreak(
        "breaks",
        "--budget",
        0.08,
        "--polygons",
        folder / "breaks.gpkg",
        "-o",
        folder / "breaks.tif",
        folder / "priority.tif",
    )
    firebreak(
        "segments",
        "--priority",
        folder / "priority.tif",
        "--dem",
        dem,
        "--compartments",
        folder / "compartments.gpkg",
        "-o",
        folder / "segments.gpkg",
        folder / "network.tif",
        folder / "breaks.tif",
    )
    firebreak(
        "compare",
        *runs,
        "--methods",
        "degree,random",
        "--budgets",
        "0.05,0.1",
        "--residuals",
        "0,0.1",
        "-o",
        folder / "comparison",
        folder / "network.tif",
    )
    firebreak(
        "burn",
        *runs,
        "--breaks",
        folder / "breaks.tif",
        "--ignitions",
        data / "ignitions.gpkg",
        "--sizes",
        folder / "sizes.csv",
        "-o",
        folder / "burn_frequency.tif",
        folder / "network.tif",
    )
    firebreak(
        "evaluate",
        *runs,
        "--methods",
        "degree,random",
        "--budgets",
        "0,0.1,0.2",
        "-o",
        folder / "evaluation",
        folder / "network.tif",
    )
    firebreak(
        "plan",
        "--res",
        QUICK["RESOLUTION"],
        *runs,
        "--method",
        "degree",
        "--ignitions",
        data / "ignitions.gpkg",
        "-o",
        folder / "plan",
        dem,
        vegetation,
        density,
    )
    return folder


def cells(path: object):
    """Values, georeference and no-data values of all bands of a raster."""
    file = gdal.Open(str(path))
    nodata = [file.GetRasterBand(i + 1).GetNoDataValue() for i in range(file.RasterCount)]
    return file.ReadAsArray().tolist(), file.GetGeoTransform(), file.GetProjection(), nodata
