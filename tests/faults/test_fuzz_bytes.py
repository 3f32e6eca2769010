"""Cut off and flipped bytes: an answer or a refusal in words, in a process of its own with bounded memory."""

import json
import subprocess
import sys
from pathlib import Path

import geopandas as gpd
import pytest
import rasterio.shutil
import shapely

from firebreak_gis.errors import InputError
from firebreak_gis.vectors import read_features, write_vector
from tests.places import NORTH_WEST, UTM, three

ROOT = Path(__file__).parents[2]
#: Files that are broken so many times, by kind, and how many of them must be refused at least.
TURNS = {
    "tif": (450, 150),
    "asc": (250, 50),
    "prj": (150, 20),
    "gpkg": (250, 50),
    "geojson": (250, 50),
    "fgb": (250, 50),
}


def good_files(folder, kind):
    """Small whole files of a kind: three layers of a landscape, or polygons and points."""
    if kind in ("tif", "asc", "prj"):
        for path in three(folder):
            if kind != "tif":
                rasterio.shutil.copy(path, path.with_suffix(".asc"), driver="AAIGrid")
        return
    west, north = NORTH_WEST
    corners = [(west + 70 * step, north - 90 * step) for step in range(1, 9)]
    areas = [shapely.box(x, y - 60, x + 50, y).difference(shapely.Point(x + 25, y - 25).buffer(9)) for x, y in corners]
    for name, geometry in (("areas", areas), ("places", [shapely.Point(corner) for corner in corners])):
        frame = gpd.GeoDataFrame({"name": [f"place {i}" for i in range(8)]}, geometry=geometry, crs=UTM)
        write_vector(folder / f"{name}.{kind}", frame)


@pytest.mark.parametrize("kind", TURNS)
def test_broken_bytes_are_refused_in_words(kind, tmp_path):
    turns, refused = TURNS[kind]
    good_files(tmp_path, kind)
    done = subprocess.run(
        [sys.executable, "-m", "tests.faults.broken_bytes", kind, tmp_path, str(turns)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        timeout=200,
    )
    assert done.returncode == 0, done.stderr[-2000:]
    found = json.loads(done.stdout)
    assert found["wrong"] == []
    assert set(found["codes"]) <= {"0", "3", "5"}
    assert found["codes"]["3"] > refused


@pytest.mark.filterwarnings("ignore:Non closed ring:RuntimeWarning")
def test_a_ring_that_does_not_close_is_refused_in_words(tmp_path):
    ring = [[27.8, 36.1], [27.9, 36.1], [27.9, 36.2], [27.7, 36.0]]
    feature = {"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": [ring]}}
    path = tmp_path / "open.geojson"
    path.write_text(json.dumps({"type": "FeatureCollection", "features": [feature]}))
    with pytest.raises(InputError, match=r"open\.geojson cannot be read"):
        read_features(path, "EPSG:32635")
