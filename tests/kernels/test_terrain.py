"""Slopes: those that GIS programs show, and what is known of planes and mirrors."""

import math
import shutil
import subprocess
from unittest import mock

import numpy as np
import pytest
import rasterio
from hypothesis import given
from hypothesis import strategies as st

from firebreak_gis.kernels import terrain
from firebreak_gis.kernels.terrain import horn_slope
from tests.places import relief, write


def slow_slope(height, cell):
    """Cell by cell, as Horn (1981) writes it; beside what is not known the step to the other side counts twice."""
    rows, cols = height.shape

    def at(r, c):
        return height[r, c] if 0 <= r < rows and 0 <= c < cols else math.nan

    def rise(r, c, dr, dc):
        behind, here, ahead = at(r - dr, c - dc), at(r, c), at(r + dr, c + dc)
        if not math.isnan(ahead) and not math.isnan(behind):
            return ahead - behind
        return 2 * (ahead - here) if not math.isnan(ahead) else 2 * (here - behind)

    def mean(r, c, dr, dc):
        found = [(2 - abs(k), rise(r + k * dc, c + k * dr, dr, dc)) for k in (-1, 0, 1)]
        known = [(weight, value) for weight, value in found if not math.isnan(value)]
        if (rows if dr else cols) == 1:
            return 0.0
        return sum(w * v for w, v in known) / sum(w for w, _ in known) if known else math.nan

    out = np.full(height.shape, np.nan)
    for r in range(rows):
        for c in range(cols):
            if not math.isnan(height[r, c]):
                east, south = mean(r, c, 0, 1), mean(r, c, 1, 0)
                out[r, c] = math.degrees(math.atan(math.hypot(east, south) / (2 * cell)))
    return out


@given(st.integers(1, 9), st.integers(1, 11), st.integers(0, 99), st.floats(0, 0.4), st.sampled_from([1, 30, 250_000]))
def test_slopes_are_those_of_the_slow_twin_in_bands_of_any_size(rows, cols, seed, holes, together):
    rng = np.random.default_rng(seed)
    height = rng.normal(0, 30, (rows, cols))
    height[rng.random(height.shape) < holes] = np.nan
    with mock.patch.object(terrain, "_TOGETHER", together):
        found = horn_slope(height, 20.0)
    np.testing.assert_allclose(found, slow_slope(height, 20.0), atol=1e-9)


@given(st.floats(-2, 2), st.floats(-2, 2))
def test_a_plane_has_its_slope_everywhere_edges_included(a, b):
    y, x = np.mgrid[0:7, 0:9] * 20.0
    expected = np.degrees(np.arctan(np.hypot(a, b)))
    np.testing.assert_allclose(horn_slope(a * x + b * y, 20.0), expected, atol=1e-6)


def test_turning_the_terrain_turns_the_slopes():
    height = relief(13, 17).astype(float)
    np.testing.assert_allclose(horn_slope(np.rot90(height), 20.0), np.rot90(horn_slope(height, 20.0)), atol=1e-9)


def test_slopes_are_those_of_gdal(tmp_path):
    if shutil.which("gdaldem") is None:
        pytest.skip("gdaldem is not here")
    dem = write(tmp_path / "d.tif", relief(40, 50))
    subprocess.run(["gdaldem", "slope", str(dem), str(tmp_path / "s.tif"), "-q"], check=True)
    with rasterio.open(tmp_path / "s.tif") as source:
        expected = source.read(1)[1:-1, 1:-1]
    np.testing.assert_allclose(horn_slope(relief(40, 50).astype(float), 20.0)[1:-1, 1:-1], expected, atol=1e-3)
