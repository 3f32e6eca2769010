"""Costs and values in the unit that their raster tells, and without flags among them."""

import numpy as np
import pytest

from firebreak_gis.errors import InputError
from firebreak_gis.grid import Grid, parse_crs
from firebreak_gis.landscape.amounts import cost_per_hectare, value_at_risk
from firebreak_gis.landscape.planes import ignition_source
from firebreak_gis.landscape.target_grid import Account
from tests.places import UTM, square, write

GRID = Grid((20, 30), square(), parse_crs(UTM))


def raster(folder, values, **more):
    return str(write(folder / "a.tif", np.asarray(values, "float32"), **more))


@pytest.mark.parametrize(
    ("unit", "factor"), [(None, 1.0), ("EUR/ha", 1.0), ("€/m2", 1e4), ("USD per acre", 2.4710538), ("PLN km-2", 0.01)]
)
@pytest.mark.parametrize("cell", [20.0, 7.0, 90.0])
def test_costs_are_taken_in_their_unit(tmp_path, unit, factor, cell):
    values = np.random.default_rng(0).uniform(1, 9, (60, 90))
    plain = cost_per_hectare(raster(tmp_path, values, transform=square(cell)), GRID)
    account = Account()
    found = cost_per_hectare(raster(tmp_path, values, transform=square(cell), units=unit), GRID, account=account)
    np.testing.assert_allclose(found, plain * factor, rtol=1e-5)
    assert any("so much for a hectare" in line for line in account.alignment) == (factor != 1.0)


@pytest.mark.parametrize("unit", ["EUR", "hours", "m/s"])
def test_a_cost_that_is_not_for_an_area_is_refused(tmp_path, unit):
    with pytest.raises(InputError, match=rf"is in '{unit}', expected so much for an area"):
        cost_per_hectare(raster(tmp_path, np.ones((20, 30)), units=unit), GRID)


def test_values_for_an_area_are_densities(tmp_path):
    path = raster(tmp_path, np.full((20, 30), 250.0), units="people/km2")
    with pytest.raises(InputError, match="--values-as density"):
        value_at_risk(path, GRID)
    assert value_at_risk(path, GRID, values_as="density").sum() == pytest.approx(250.0 * 0.4 * 0.6)
    counted = raster(tmp_path, np.full((20, 30), 2.0), units="people")
    assert value_at_risk(counted, GRID).sum() == pytest.approx(1200.0)


READERS = {
    "cost": cost_per_hectare,
    "values": value_at_risk,
    "densities": lambda path, grid: value_at_risk(path, grid, values_as="density"),
    "ignitions": ignition_source,
}


@pytest.mark.parametrize("reader", READERS)
@pytest.mark.parametrize("cell", [20.0, 7.0, 90.0])
def test_negative_flags_are_found_before_they_are_mixed(tmp_path, reader, cell):
    values = np.full((90, 90), 50.0)
    values[5, 5] = -1
    with pytest.raises(InputError, match=r"holds -1 in 1 cells, expected finite numbers of at least 0; .*-a_nodata"):
        READERS[reader](raster(tmp_path, values, transform=square(cell)), GRID)
    assert np.isfinite(READERS[reader](raster(tmp_path, values, transform=square(cell), nodata=-1), GRID)).any()
