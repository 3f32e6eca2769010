"""Bounds that lie beside the layers: said in words that help."""

import numpy as np
import pytest
from pyproj import Transformer

from firebreak_gis.errors import GridError, ParameterError
from firebreak_gis.grid import Grid
from firebreak_gis.landscape import read_landscape
from tests.places import NORTH_WEST, UTM, relief, write


def landscape(tmp_path, bounds):
    dem = write(tmp_path / "d.tif", relief(40, 50))
    return read_landscape(dem, write(tmp_path / "v.tif", np.full((40, 50), 2, np.uint8)), "normal", bounds=bounds)


def test_bounds_in_degrees_are_said_to_be_and_turned_into_metres(tmp_path):
    x, y = NORTH_WEST
    to_degrees = Transformer.from_crs(UTM, "EPSG:4326", always_xy=True).transform
    corners = to_degrees([x + 200, x + 600], [y - 600, y - 200])
    bounds = corners[0][0], corners[1][0], corners[0][1], corners[1][1]
    with pytest.raises(ParameterError, match=r"look like degrees, expected coordinates in EPSG:32635") as caught:
        landscape(tmp_path, bounds)
    offered = tuple(float(word) for word in str(caught.value).split("there they are ")[1].split(" (")[0].split())
    got = Grid.of(landscape(tmp_path, offered)["elevation"]).bounds
    np.testing.assert_allclose(got, (x + 200, y - 600, x + 600, y - 200), atol=40)


def test_bounds_beside_the_layers_are_refused_with_both_extents(tmp_path):
    x, y = NORTH_WEST
    with pytest.raises(GridError, match="lie beside the extent that all layers cover"):
        landscape(tmp_path, (x + 9000, y - 600, x + 9400, y - 200))
