"""What a planner adds on the command line: each option shapes the plan as it says, and the account tells."""

import json

import geopandas as gpd
import numpy as np
import pytest
import rasterio
import shapely
from click.testing import CliRunner

from firebreak_gis.cli import firebreak
from tests.places import NORTH_WEST, UTM, relief, square, write

pytestmark = pytest.mark.usefixtures("no_pictures")

ROWS, COLS = 24, 31
LEFT, TOP = NORTH_WEST


def run(*words, code=0):
    outcome = CliRunner().invoke(firebreak, [str(w) for w in words])
    assert outcome.exit_code == code, outcome.output + repr(outcome.exception)
    return outcome.output


def read(path):
    with rasterio.open(path) as source:
        return source.read(1)


def drawn(path, *shapes, layer=None, **columns):
    placed = [
        shapely.transform(s, lambda p: np.column_stack((LEFT + 20 * p[:, 0], TOP - 20 * p[:, 1]))) for s in shapes
    ]
    gpd.GeoDataFrame(columns, geometry=placed, crs=UTM).to_file(path, layer=layer)
    return path


@pytest.fixture(scope="module")
def place(tmp_path_factory):
    """Shrubs all over, as network and priority, too."""
    folder = tmp_path_factory.mktemp("stakes")
    write(folder / "dem.tif", relief(ROWS, COLS))
    write(folder / "veg.tif", np.full((ROWS, COLS), 2, "uint8"))
    run("align", folder / "dem.tif", folder / "veg.tif", "normal", "-o", folder / "land", "-q")
    run("network", folder / "land", "-o", folder / "net.tif", "-q")
    run("rank", folder / "net.tif", "--method", "random", "-o", folder / "rank.tif", "-q")
    return folder


@pytest.fixture
def plan(place, tmp_path):
    layers = [place / "dem.tif", place / "veg.tif", "normal"]

    def planned(*words, code=0):
        out = tmp_path / "out"
        text = run("plan", *layers, "-o", out, "--method", "random", "--runs", 3, "--overwrite", *words, code=code)
        return text, (read(out / "breaks.tif") if code == 0 else None), out

    return planned


def test_protected_areas_are_kept_in_every_part_unless_centres_are_asked_for(plan, tmp_path):
    area = drawn(tmp_path / "p.gpkg", shapely.box(5.9, 5.9, 20.2, 15.1))
    every, cut, _ = plan("--protected", area, "--budget", 0.7)
    assert not cut[5:16, 5:21].any()
    assert "protected: 1 polygons or lines take 176 cells" in every
    _, cut, _ = plan("--protected", area, "--protected-rule", "centre", "--budget", 0.82)
    assert not cut[6:15, 6:20].any()
    assert cut[5, 5:21].any()
    _, cut, _ = plan("--allowed", area, "--budget", 0.15)
    assert cut.sum() == cut[6:15, 6:20].sum() > 0


def test_unknown_costs_are_refused_with_strict_or_said(plan, tmp_path):
    cost = np.full((ROWS, COLS), 1000, "float32")
    cost[:, :15] = -9999
    write(tmp_path / "c.tif", cost, nodata=-9999)
    words = ["--cost", tmp_path / "c.tif", "--budget", 4000, "--budget-unit", "cost"]
    text, cut, out = plan(*words)
    assert (cut.sum(), cut[:, :15].sum()) == (100, 0)
    assert "Warning: cost is not known on 360 cells with fuel (14.4 ha), where nothing is cut" in text
    account = json.loads((out / "run.json").read_text())
    assert any("cost is not known" in sentence for sentence in account["warnings"])
    assert "refused by --strict" in plan(*words, "--strict", code=3)[0]
    text, cut, _ = plan(*words, "--cost-default", 1000)
    assert cut[:, :15].any()
    assert "taken as 1000 a hectare, as asked" in text


def test_values_are_amounts_or_densities_and_the_account_tells_their_sum(plan, tmp_path):
    write(tmp_path / "people.tif", np.full((5, 7), 10, "float32"), transform=square(100.0))
    text, cut, out = plan("--values", tmp_path / "people.tif")
    # The landscape has 24 x 31 cells of 20 m, the map 25 x 35.
    assert "values: 297.6 in all on the landscape" in text
    told = json.loads((out / "run.json").read_text())["alignment"]
    assert any(sentence.startswith("values: 297.6 in all on the landscape") for sentence in told)
    parts = gpd.read_file(out / "compartments.gpkg", layer="compartments")
    assert parts["value"].sum() == pytest.approx(0.4 * (ROWS * COLS - cut.sum()))
    text, _, out = plan("--values", tmp_path / "people.tif", "--values-as", "density")
    assert "values: 297.6 in all" in text  # 10 a hectare are 0.4 a cell, too
    houses = drawn(tmp_path / "h.gpkg", shapely.box(5.1, 5.1, 5.2, 5.2), shapely.box(8, 8, 12, 12), n=[100, 50])
    text, cut, out = plan("--values", houses, "--values-field", "n", "--budget", 0.01)
    assert "values: 150 in all" in text
    parts = gpd.read_file(out / "compartments.gpkg", layer="compartments")
    lost = 100 * cut[5, 5] + 50 / 16 * cut[8:12, 8:12].sum()
    assert parts["value"].sum() == pytest.approx(150 - lost)


def test_one_of_several_layers_and_conditions_on_its_features(plan, tmp_path):
    path = tmp_path / "osm.gpkg"
    lines = [shapely.LineString([(0, row), (COLS, row)]) for row in (5.5, 12.5)]
    drawn(path, *lines, layer="roads", highway=["primary", "path"])
    drawn(path, shapely.box(0, 20, 5, 24), layer="water", kind=["lake"])
    assert "several layers: roads, water; say which" in plan("--barriers", path, code=3)[0]

    def barred(*words):
        text = plan("--barriers", *words)[0]
        return next(line for line in text.splitlines() if line.startswith("barriers: "))

    assert " take 62 cells" in barred(f"{path}|layername=roads")
    one = " take 31 cells"
    assert one in barred(f"{path}|layername=roads|subset=highway = 'primary'")
    assert one in barred(f"{path}|layername=roads", "--where", "highway = 'primary'")
    assert one in barred(f"{path}|layername=roads", "--where", "barriers=highway = 'primary'")
    area = drawn(tmp_path / "p.gpkg", shapely.box(8, 18, 9, 19), highway=["path"])
    both = ["--barriers", f"{path}|layername=roads", "--protected", area]
    assert "expected OPTION=CONDITION" in plan(*both, "--where", "highway = 'primary'", code=2)[0]
    assert one in plan(*both, "--where", "barriers=highway = 'primary'", "--where", "protected=highway = 'path'")[0]
    assert "none is given" in plan("--where", "highway = 'primary'", code=2)[0]
    assert "does not work" in plan("--barriers", f"{path}|layername=roads", "--where", "width > 3", code=3)[0]


def test_a_plan_with_conditions_is_repeated_from_its_account(plan, place, tmp_path):
    path = drawn(
        tmp_path / "r.gpkg", *[shapely.LineString([(0, r), (COLS, r)]) for r in (5.5, 12.5)], highway=["a", "b"]
    )
    _, cut, out = plan("--barriers", path, "--where", "barriers=highway = 'a'")
    run("plan", "--config", out / "run.json", "-o", tmp_path / "again")
    assert (read(tmp_path / "again/breaks.tif") == cut).all()


def test_places_of_fires_outside_are_left_out_when_asked(plan, place, tmp_path):
    points = drawn(tmp_path / "i.gpkg", shapely.Point(5.5, 5.5), shapely.Point(500, 5))
    assert "--ignitions-outside drop" in plan("--ignitions", points, code=3)[0]
    told = "ignitions: 1 of 2 were left out, 1 outside the grid and 0 on cells without fuel"
    text, _, out = plan("--ignitions", points, "--ignitions-outside", "drop")
    assert told in text
    assert told in json.loads((out / "run.json").read_text())["feasibility"]
    words = [place / "net.tif", "--ignitions", points, "--ignitions-outside", "drop", "--runs", 4]
    assert told in run("burn", *words, "-o", tmp_path / "f.tif")
    assert told in run("evaluate", *words, "--methods", "random", "-o", tmp_path / "e")
    assert told in run("compare", *words, "--methods", "random", "--budgets", "0.1", "-o", tmp_path / "c")
    (tmp_path / "i.csv").write_text(f"x,y\n{LEFT + 110},{TOP - 110}\n")
    run("burn", place / "net.tif", "--ignitions", tmp_path / "i.csv", "--runs", 4, "-o", tmp_path / "g.tif")
    assert (read(tmp_path / "g.tif") == read(tmp_path / "f.tif")).all()


def test_own_breaks_are_drawn_or_lie_on_any_grid(place, tmp_path):
    """One wall, four ways: the fires are the same, and none passes it."""
    lanes = drawn(tmp_path / "wall.gpkg", shapely.box(12.2, 0, 12.4, ROWS))
    line = drawn(tmp_path / "line.gpkg", shapely.LineString([(12.3, 0), (12.3, ROWS)]))
    wall = np.zeros((ROWS, COLS), "uint8")
    wall[:, 12] = 1
    write(tmp_path / "wall.tif", wall)
    fine = np.zeros((ROWS * 4, COLS * 4), "uint8")
    fine[:, 50] = 1
    write(tmp_path / "fine.tif", fine, transform=square(5.0))
    start = drawn(tmp_path / "i.gpkg", shapely.Point(3.5, 3.5))
    burnt = []
    for breaks in (lanes, line, tmp_path / "wall.tif", tmp_path / "fine.tif"):
        words = ["--breaks", breaks, "--ignitions", start, "--runs", 20, "-o", tmp_path / "f.tif", "--overwrite"]
        run("burn", place / "net.tif", *words)
        burnt.append(read(tmp_path / "f.tif"))
    assert (burnt[0][:, 12:31] <= 0).all()
    assert (burnt[0][:, :12] > 0).any()
    assert all((other == burnt[0]).all() for other in burnt[1:])
    run("segments", place / "net.tif", lanes, "-o", tmp_path / "s.gpkg")
    assert len(gpd.read_file(tmp_path / "s.gpkg", layer="polygons")) == 1
    write(tmp_path / "far.tif", wall, transform=square(20.0, (LEFT + 9e4, TOP)))
    refused = run("burn", place / "net.tif", "--breaks", tmp_path / "far.tif", "-o", tmp_path / "h.tif", code=3)
    assert "breaks does not touch the landscape" in refused
    other = run("burn", place / "net.tif", "--breaks", place / "land/density.tif", "-o", tmp_path / "h.tif", code=3)
    assert "was written as vegetation density, expected breaks" in other


def test_segments_with_unknown_costs_are_refused(place, tmp_path):
    wall = drawn(tmp_path / "wall.gpkg", shapely.box(12.2, 0, 12.4, ROWS))
    cost = drawn(tmp_path / "c.gpkg", shapely.box(0, 0, COLS, 12), c=[500.0])
    words = ["segments", place / "net.tif", wall, "-o", tmp_path / "s.gpkg", "--cost", cost, "--cost-field", "c"]
    assert "the cost of 12 of the cells cut is not known" in run(*words, code=3)
    run(*words, "--cost-default", 100)
    found = gpd.read_file(tmp_path / "s.gpkg", layer="polygons")
    assert found["cost"].sum() == pytest.approx(0.04 * 12 * 600)


def test_only_a_ranking_is_taken_as_a_priority_unless_confirmed(place, tmp_path):
    out = ["-o", tmp_path / "b.tif", "--overwrite"]
    run("breaks", place / "rank.tif", *out)
    for name, told in (
        (place / "land/elevation.tif", "was written as terrain elevation"),
        (place / "dem.tif", "does not say that it is a cutting priority"),
    ):
        text = run("breaks", name, *out, code=3)
        assert told in text
        assert "--foreign" in text
        assert "as asked" in run("breaks", name, *out, "--foreign")
        assert "--foreign" in run(
            "segments", place / "net.tif", tmp_path / "b.tif", "--priority", name, "-o", tmp_path / "s.gpkg", code=3
        )
    highest = read(place / "dem.tif")[read(tmp_path / "b.tif") == 1]
    assert highest.min() >= np.sort(read(place / "dem.tif").ravel())[-highest.size]
    write(tmp_path / "flat.tif", np.ones((ROWS, COLS), "float32"))
    assert "ranks all cells alike" in run("breaks", tmp_path / "flat.tif", *out, "--foreign")


def test_breaks_are_paid_for_by_polygons_or_rasters_of_cost(place, tmp_path):
    cost = drawn(tmp_path / "c.gpkg", shapely.box(0, 0, COLS, 12), c=[500.0])
    out = ["-o", tmp_path / "b.tif", "--overwrite", "--budget", 1000, "--budget-unit", "cost"]
    text = run("breaks", place / "rank.tif", *out, "--cost", cost, "--cost-field", "c")
    assert "cost is not known on 372 cells with fuel" in text
    cut = read(tmp_path / "b.tif")
    assert (cut.sum(), cut[12:].sum()) == (50, 0)
    run("breaks", place / "rank.tif", *out, "--cost", cost, "--cost-field", "c", "--cost-default", 500)
    cut = read(tmp_path / "b.tif")
    assert cut.sum() == 50
    assert cut[12:].any()


def test_an_area_of_interest_limits_cuts_and_not_fires(plan, tmp_path):
    aoi = drawn(tmp_path / "aoi.gpkg", shapely.box(5, 5, 15, 15))
    text, breaks, out = plan("--aoi", aoi, "--budget", "0.05")
    rows, cols = np.nonzero(breaks)
    assert rows.size == round(0.05 * ROWS * COLS)
    assert rows.min() >= 5
    assert cols.min() >= 5
    assert max(rows.max(), cols.max()) < 15
    account = json.loads((out / "run.json").read_text())
    assert account["summary"]["burnable_cells"] == ROWS * COLS
    assert "Nothing is cut outside the area of interest." in account["assumptions"]
    text, _, _ = plan("--aoi", aoi, "--budget", "0.5", code=2)
    assert "lower the budget" in text


def test_distances_from_roads_take_units(plan, tmp_path):
    road = drawn(tmp_path / "road.gpkg", shapely.LineString([(10.5, 0), (10.5, ROWS)]))
    _, breaks, _ = plan("--roads", road, "--near-roads", "0.08km", "--beyond-roads", "45m", "--budget", "0.1")
    assert set(np.nonzero(breaks)[1]) <= {7, 6, 13, 14}
    assert breaks.sum() == round(0.1 * ROWS * COLS)
    for words, message in (
        (["--near-roads", "80m"], "--roads"),
        (["--roads", road, "--near-roads", "far"], "such as 50m"),
        (["--roads", road, "--near-roads", "10m", "--beyond-roads", "20m"], "the larger"),
        (["--max-slope", "100"], "--max-slope"),
        (["--siting", "-1"], "strength"),
    ):
        text, _, _ = plan(*words, code=2)
        assert message in text
