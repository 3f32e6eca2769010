"""Existing breaks, one by one: what each is worth, where gaps are, and the same fires for all."""

from __future__ import annotations

import json

import geopandas as gpd
import numpy as np
import pytest
import shapely
from affine import Affine
from click.testing import CliRunner
from pyproj import CRS

from firebreak_gis.cli import firebreak
from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.evaluation.assessment import assess, told
from firebreak_gis.evaluation.gaps import find_gaps
from firebreak_gis.evaluation.measures import BOUNDS, resamples
from firebreak_gis.grid import Grid
from firebreak_gis.landscape.existing import existing_breaks
from firebreak_gis.landscape.target_grid import Account
from firebreak_gis.network import SpreadNetwork
from firebreak_gis.schema import COLUMNS
from firebreak_gis.simulation.fires import simulate
from tests.places import write

SHAPE, SIDE = (21, 32), 20.0
GRID = Grid(SHAPE, Affine(SIDE, 0.0, 500_000.0, 0.0, -SIDE, 4_000_000.0), CRS.from_epsg(32633))


def network(burnable=None):
    fuel = np.ones(SHAPE, bool) if burnable is None else burnable
    return SpreadNetwork(np.full((8, *SHAPE), 0.9, np.float32), burnable=fuel, transform=GRID.transform, crs=GRID.crs)


def line(*cells):
    """Through the middles of cells (row, col)."""
    return shapely.LineString([(500_000 + SIDE * (c + 0.5), 4_000_000 - SIDE * (r + 0.5)) for r, c in cells])


def lines(*shapes):
    return gpd.GeoDataFrame(geometry=list(shapes), crs=GRID.crs)


def standing(frame):
    return existing_breaks(frame, GRID, account=Account())


def burner(found, runs=40):
    def burnt(cut, progress):
        return simulate(found, breaks=cut if cut.any() else None, n_runs=runs, seed=1)["fire_size"].to_numpy()

    return burnt


#: A wall down the middle with a hole of three cells, and a stub that closes nothing.
WALL = lines(line((0, 15), (8, 15)), line((12, 15), (20, 15)), line((3, 24), (3, 27)))


def test_each_line_is_a_break_with_its_cells_and_ends():
    found = standing(WALL)
    assert [cells.size for cells in found.cells] == [9, 9, 4]
    assert found.cells[0].tolist() == [r * 32 + 15 for r in range(9)]
    assert found.lengths.tolist() == [160.0, 160.0, 60.0]
    mask = np.zeros(SHAPE, np.uint8)
    for cells in found.cells:
        mask.ravel()[cells] = 1
    pieces = standing(mask)
    assert sorted(cells.size for cells in pieces.cells) == [4, 9, 9]
    assert sorted(pieces.lengths.round().tolist()) == [80.0, 180.0, 180.0]


def test_worth_is_what_more_burns_without_the_break():
    """With fires that burn what is not cut, weighted by run, every number is a sum over cells."""
    weight = np.random.default_rng(0).random((12, *SHAPE))

    def burnt(cut, progress):
        return (weight * ~cut).sum(axis=(1, 2))

    crossing = lines(line((5, 3), (5, 9)), line((2, 6), (9, 6)))
    found = assess(network(), standing(crossing), burnt, longest_gap=0.0, placements=2, seed=3)
    area, picks = GRID.cell_area_ha, resamples(12, 3)
    own = [{(5, c) for c in range(3, 10)}, {(r, 6) for r in range(2, 10)}]
    by_number = found.breaks.set_index("number")
    for k in (0, 1):
        alone = area * sum(weight[:, r, c] for r, c in own[k])
        worth = area * sum(weight[:, r, c] for r, c in own[k] - own[1 - k])  # the crossing stays cut
        row = by_number.loc[k + 1]
        assert row["worth_ha"] == pytest.approx(worth.mean())
        assert row["alone_ha"] == pytest.approx(alone.mean())
        ends = np.percentile(worth[picks].mean(axis=1), BOUNDS)
        assert [row["worth_ha_low"], row["worth_ha_high"]] == pytest.approx(ends.tolist())
        assert row["random_ha"] == pytest.approx(alone.mean(), rel=0.3)  # as many cells elsewhere
    assert found.breaks["rank"].tolist() == [1, 2]
    assert found.breaks["worth_ha"].is_monotonic_decreasing
    again = assess(network(), standing(crossing), burnt, longest_gap=0.0, placements=2, seed=3)
    assert again.breaks.drop(columns="geometry").equals(found.breaks.drop(columns="geometry"))


def test_the_hole_in_the_wall_is_the_gap_that_matters_most():
    landscape, existing = network(), standing(WALL)
    found = assess(landscape, existing, burner(landscape), longest_gap=200.0, placements=2)
    first = found.gaps.iloc[0]
    assert {first["from_break"], first["to_break"]} == {1, 2}
    assert (first["cells"], first["length_m"]) == (3, 80.0)
    assert first["saved_ha_low"] > 0
    assert first["saved_per_km"] > 5 * first["random_per_km"]
    # With the hole closed each half of the wall is worth what the wall is; with it open neither does much.
    closed = lines(*WALL.geometry, line((9, 15), (11, 15)))
    shut = assess(landscape, standing(closed), burner(landscape), longest_gap=0.0, placements=0)
    assert shut.breaks["worth_ha"].max() > 3 * found.breaks["worth_ha"].max()
    assert np.isnan(shut.breaks["random_ha"]).all()
    assert shut.burnt_ha < found.burnt_ha <= found.burnt_bare_ha
    assert "from break 1 to break 2 over 80 m" in told(found)[2]


def test_a_break_is_kept_if_it_saves_more_than_must_be_treated_anew():
    """One of two breaks saves nothing, and the fires of a year decide for the other."""
    weight = np.zeros((12, *SHAPE))
    weight[:, 5] = 1.0

    def burnt(cut, progress):
        return (weight * ~cut).sum(axis=(1, 2))

    two = standing(lines(line((5, 3), (5, 9)), line((15, 3), (15, 9))))
    rates = np.full(SHAPE, 0.25)
    for fires, kept in ((1.0, ["yes", "no"]), (0.2, ["no", "no"])):
        found = assess(network(), two, burnt, longest_gap=0.0, placements=0, upkeep=rates, fires_per_year=fires)
        by_number = found.breaks.set_index("number")
        assert by_number.loc[[1, 2], "keep"].tolist() == kept
        assert by_number.loc[[1, 2], "upkeep_ha"].tolist() == pytest.approx([7 * GRID.cell_area_ha / 4] * 2)
    assert "2 cost more than they save" in told(found)[2]


def test_gaps_start_at_loose_ends_alone():
    burnable = np.ones(SHAPE, bool)
    burnable[:, 28:] = False
    gaps, left_out = find_gaps(standing(WALL), burnable, GRID, longest=200.0, most=10)
    pairs = list(zip(gaps.frame["from_break"], gaps.frame["to_break"], gaps.frame["length_m"], strict=True))
    assert (2, -1, 20.0) not in pairs  # the stub ends beside the ground without fuel
    assert (0, 1, 80.0) in pairs or (1, 0, 80.0) in pairs
    assert left_out == 0
    assert all(length <= 200.0 for *_, length in pairs)
    # Where a break ends beside another nothing is open, whatever lies near.
    burnable[:, 14] = False
    meeting = standing(lines(line((5, 2), (5, 12)), line((6, 11), (14, 11))))
    open_ends, _ = find_gaps(meeting, burnable, GRID, longest=200.0, most=10)
    starts = {shapely.get_coordinates(shape)[0].tolist()[1] for shape in open_ends.frame.geometry}
    assert 4_000_000 - SIDE * 6.5 not in starts
    assert 4_000_000 - SIDE * 14.5 in starts
    burnable[:, 14] = True
    fewer, more = find_gaps(standing(WALL), burnable, GRID, longest=200.0, most=1)
    assert len(fewer.cells) == 1
    assert more == len(pairs) - 1


def test_what_cannot_be_judged_is_refused():
    bare = np.ones(SHAPE, bool)
    bare[:, 15] = False
    with pytest.raises(InputError, match="no break lies on a cell with fuel"):
        assess(network(bare), standing(lines(line((0, 15), (8, 15)))), burner(network(bare)))
    with pytest.raises(ParameterError, match="at least 0"):
        assess(network(), standing(WALL), burner(network()), placements=-1)


def test_the_command_writes_breaks_and_gaps_that_a_stranger_reads(tmp_path):
    write(tmp_path / "net.tif", np.full((8, *SHAPE), 0.9, "float32"), transform=GRID.transform, crs="EPSG:32633")
    WALL.to_file(tmp_path / "wall.gpkg")
    words = ["assess", tmp_path / "net.tif", tmp_path / "wall.gpkg", "-o", tmp_path / "out", "--runs", 20, "--json"]
    done = CliRunner().invoke(firebreak, [str(w) for w in words])
    assert done.exit_code == 0, done.output
    breaks = gpd.read_file(tmp_path / "out" / "assessment.gpkg", layer="breaks")
    gaps = gpd.read_file(tmp_path / "out" / "assessment.gpkg", layer="gaps")
    assert set(breaks.columns) - {"geometry"} <= set(COLUMNS)
    assert set(gaps.columns) - {"geometry"} <= set(COLUMNS)
    assert breaks["rank"].tolist() == [1, 2, 3]
    assert set(breaks.geom_type) == {"LineString"}
    assert gaps.iloc[0]["length_m"] == 80.0
    said = json.loads(done.stdout.splitlines()[-1])["result"]["headline"]
    assert (tmp_path / "out" / "summary.txt").read_text().startswith(said[0])
