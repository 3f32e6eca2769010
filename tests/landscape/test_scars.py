"""Observed fires on the grid of a landscape."""

import doctest

import geopandas as gpd
import numpy as np
import pandas as pd
import pytest
import shapely
from affine import Affine

from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.grid import Grid, parse_crs
from firebreak_gis.landscape import scars
from tests.places import real, shared

UTM = "EPSG:32635"
LEFT, TOP, CELL = 500_000.0, 4_000_200.0, 20.0
GRID = Grid((10, 14), Affine(CELL, 0, LEFT, 0, -CELL, TOP), parse_crs(UTM))
FUEL = np.ones(GRID.shape, bool)


def box(rows, cols, *, shift=0.0):
    """A rectangle over rows and columns, both ends included, `shift` metres to the east."""
    return shapely.box(
        LEFT + CELL * cols[0] + shift,
        TOP - CELL * (rows[1] + 1),
        LEFT + CELL * (cols[1] + 1) + shift,
        TOP - CELL * rows[0],
    )


def centre(row, col):
    return shapely.Point(LEFT + CELL * (col + 0.5), TOP - CELL * (row + 0.5))


def frame(*shapes):
    return gpd.GeoDataFrame(geometry=list(shapes), crs=UTM)


def window(rows, cols):
    plane = np.zeros(GRID.shape, bool)
    plane[rows[0] : rows[1] + 1, cols[0] : cols[1] + 1] = True
    return plane


@pytest.mark.parametrize(("shift", "moved"), [(0.0, 0), (9.0, 0), (11.0, 1), (-9.0, 0), (-11.0, -1)])
def test_cells_burn_whose_centre_is_inside(shift, moved):
    found = scars.read_scar(frame(box((2, 5), (3, 8), shift=shift)), frame(centre(4, 5)), GRID, fuel=FUEL)
    assert np.array_equal(found.burnt, window((2, 5), (3 + moved, 8 + moved)))
    assert np.array_equal(found.start, window((4, 4), (5, 5)))
    assert found.notes == ()


def test_files_in_other_coordinates_and_rasters_give_the_same(tmp_path):
    shapes = frame(box((2, 5), (3, 8))).to_crs("EPSG:4326")
    shapes.to_file(tmp_path / "scar.shp")
    frame(centre(4, 5)).to_crs("EPSG:3857").to_file(tmp_path / "start.gpkg")
    found = scars.read_scar(tmp_path / "scar.shp", tmp_path / "start.gpkg", GRID, fuel=FUEL)
    again = scars.read_scar(window((2, 5), (3, 8)), window((4, 4), (5, 5)), GRID, fuel=FUEL)
    assert np.array_equal(found.burnt, again.burnt)
    assert np.array_equal(found.start, again.start)


def test_starts_are_points_or_polygons_that_burn_already():
    scar = frame(box((1, 8), (1, 12)))
    polygon = scars.read_scar(scar, frame(box((3, 4), (3, 5)), centre(7, 7)), GRID, fuel=FUEL)
    assert np.array_equal(polygon.start, window((3, 4), (3, 5)) | window((7, 7), (7, 7)))
    tiny = scars.read_scar(
        scar, frame(centre(3, 3).buffer(1.0, quad_segs=1).difference(centre(3, 3).buffer(0.5))), GRID, fuel=FUEL
    )
    assert np.array_equal(tiny.start, window((3, 3), (3, 3)))
    assert tiny.notes == ("the start is smaller than a cell",)


def test_a_start_without_fuel_is_moved_into_the_scar_and_told():
    fuel = FUEL.copy()
    fuel[4, 4:7] = False
    found = scars.read_scar(frame(box((2, 5), (3, 8))), frame(centre(4, 5)), GRID, fuel=fuel)
    assert found.start.sum() == 1
    assert (found.start & fuel & found.burnt).any()
    assert found.notes == (
        "3 of the 24 cells of the scar hold no fuel on the map; no simulated fire burns them",
        "the start lies on a cell without fuel and was moved by 20 m",
    )
    with pytest.raises(InputError, match="without fuel only"):
        scars.read_scar(frame(box((2, 5), (3, 8))), frame(box((4, 4), (4, 6))), GRID, fuel=fuel)


def test_what_is_doubtful_is_told_and_what_is_wrong_refused():
    apart = scars.read_scar(frame(box((2, 5), (3, 8))), frame(centre(9, 13)), GRID, fuel=FUEL)
    assert apart.notes == ("the start lies outside the scar",)
    assert apart.burnt[9, 13]
    with pytest.raises(InputError, match="50 % of the scar lie off the landscape"):
        scars.read_scar(frame(box((2, 5), (10, 17))), frame(centre(4, 12)), GRID, fuel=FUEL)
    with pytest.raises(InputError, match="start lies outside the landscape"):
        scars.read_scar(frame(box((2, 5), (3, 8))), frame(centre(4, 99)), GRID, fuel=FUEL)
    with pytest.raises(InputError, match="does not touch"):
        scars.read_scar(frame(box((20, 25), (3, 8))), frame(centre(4, 5)), GRID, fuel=FUEL)


TABLE = pd.DataFrame(
    {
        "AREA_HA": [12.5, 0.0, np.nan, 300.0, 7.0],
        "begun": ["2016-09-03", "2016-09-03", "2016-09-03", "2016-09-30", None],
        "over": ["2016-09-03", "2016-09-03", "2016-09-03", "2016-10-02", "2016-10-02"],
    }
)


def test_table_of_sizes_and_days(tmp_path):
    found = scars.fire_table(TABLE, first_day="begun", last_day="over")
    assert found["ha"].tolist() == [12.5, 300.0, 7.0]
    assert found["days"].tolist()[:2] == [1.0, 3.0]
    assert np.isnan(found["days"][2])
    assert scars.fire_table(TABLE)["days"].isna().all()
    TABLE.to_csv(tmp_path / "fires.csv", index=False)
    assert scars.fire_table(tmp_path / "fires.csv", first_day="begun", last_day="over").equals(found)
    shapes = gpd.GeoDataFrame(TABLE, geometry=[box((2, 5), (3, 8))] * 5, crs=UTM)
    shapes.to_file(tmp_path / "fires.gpkg")
    assert scars.fire_table(tmp_path / "fires.gpkg", first_day="begun", last_day="over").equals(found)
    areas = scars.fire_table(shapes[["begun", "geometry"]])
    assert areas["ha"].tolist() == pytest.approx([24 * 0.04] * 5, rel=2e-3)


def test_bad_tables_are_refused(tmp_path):
    with pytest.raises(InputError, match="no column with the size"):
        scars.fire_table(TABLE[["begun"]])
    with pytest.raises(ParameterError, match="no column 'size'"):
        scars.fire_table(TABLE, size="size")
    backwards = pd.DataFrame({"ha": [1.0], "start": ["2020-02-02"], "end": ["2020-02-01"]})
    with pytest.raises(InputError, match="fire 1 ends before it begins"):
        scars.fire_table(backwards)
    with pytest.raises(InputError, match="no fire with a size"):
        scars.fire_table(TABLE[1:3])
    (tmp_path / "empty.csv").write_text("")
    with pytest.raises(InputError, match="cannot be read as a table"):
        scars.fire_table(tmp_path / "empty.csv")


def test_examples_run():
    assert doctest.testmod(scars).failed == 0


@real
def test_the_fires_of_monchique():
    found = scars.fire_table(shared("monchique_100m", "perimeters.shp"))
    assert len(found) == 170
    assert (found["ha"] >= 100).sum() == 42
    assert found["days"].max() == 7


@real
@pytest.mark.parametrize(("name", "cells", "bare"), [("clinge_2025", 253, 14), ("maasmechelen_2025", 1790, 5)])
def test_the_scars_of_two_fires(name, cells, bare):
    from firebreak_gis.landscape import read_landscape

    land = read_landscape(shared(name, "elevation.tif"), shared(name, "fuels.tif"), legend="scott_burgan_40")
    found = scars.read_scar(
        shared(name, "observed_scar.shp"),
        shared(name, "ignition.gpkg"),
        Grid.of(land["burnable"]),
        fuel=land["burnable"].to_numpy(),
    )
    assert found.burnt.sum() == cells
    assert found.start.sum() == 1
    assert f"{bare} of the {cells} cells" in found.notes[0]
