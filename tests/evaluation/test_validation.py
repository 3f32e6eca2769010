"""A simulated fire held against a scar."""

import json

import numpy as np
import pytest
from affine import Affine

from firebreak_gis.errors import GridError
from firebreak_gis.evaluation import nulls, skill
from firebreak_gis.evaluation.validation import Forecast, judge
from firebreak_gis.grid import Grid, parse_crs
from firebreak_gis.landscape.scars import Scar
from firebreak_gis.manifest import plain
from firebreak_gis.report.figures import save
from firebreak_gis.report.validation import validation_figure

SHAPE = (40, 52)
GRID = Grid(SHAPE, Affine(20, 0, 586_440.0, 0, -20, 3_999_900.0), parse_crs("EPSG:32635"))


@pytest.fixture(scope="module")
def fire():
    """A fire driven to the east, twelve runs of it at several speeds, on land with a lake."""
    fuel = np.ones(SHAPE, bool)
    fuel[25:30, 30:38] = False
    start = np.zeros(SHAPE, bool)
    start[20, 12] = True
    row, col = np.mgrid[0 : SHAPE[0], 0 : SHAPE[1]]
    time = (np.hypot(row - 20, col - 12) - 0.7 * (col - 12)) / 3.0  # hours at speed 1
    time[~fuel] = np.inf
    speeds = np.linspace(0.6, 1.4, 12)
    hours = np.linspace(0.25, 3.0, 12)
    reached = np.array([time / speed <= 3.0 for speed in speeds])
    sizes = np.array([[(time / speed <= hour).sum() for hour in hours] for speed in speeds])
    forecast = Forecast(
        reached.mean(axis=0).astype(np.float32),
        np.where(reached.any(axis=0), time, np.nan),
        hours,
        sizes,
        reached.sum(axis=(1, 2)),
    )
    scar = Scar((time <= 3.0) | start, start, ("a note on the scar",))
    return forecast, scar, fuel


@pytest.fixture(scope="module")
def result(fire):
    forecast, scar, fuel = fire
    return judge(forecast, scar, GRID, fuel=fuel, wind=(4.0, 270.0), notes=("durations are assumed",))


def test_the_scores_are_those_of_each_fire(fire, result):
    forecast, scar, fuel = fire
    counted = fuel | scar.burnt
    assert list(result.scores) == ["simulated", "shape", "none", "distance", "ellipse"]
    for name, cells in result.fires.items():
        expected = skill.overlap(cells, scar.burnt, start=scar.start)
        for key in ("sorensen", "iou", "growth_iou"):
            assert result.scores[name][key] == expected[key]
        if name != "simulated":
            assert result.scores[name]["size_ratio"] == expected["size_ratio"]
            assert result.scores[name]["brier"] == skill.brier(cells * 1.0, scar.burnt, within=counted)
    assert np.array_equal(result.fires["simulated"], forecast.probability >= 0.5)
    assert result.fires["shape"].sum() == scar.burnt.sum()
    assert result.scores["simulated"]["size_ratio"] == pytest.approx(forecast.burnt.mean() / scar.burnt.sum(), rel=1e-6)
    assert result.scores["simulated"]["brier"] == skill.brier(forecast.probability, scar.burnt, within=counted)
    for name in nulls.NULLS:
        own, other = result.scores["simulated"]["brier"], result.scores[name]["brier"]
        assert result.scores[name]["skill"] == 1 - own / other


def test_a_model_that_knows_the_truth_beats_those_that_know_nothing(result):
    assert result.beats == {"none": True, "distance": True, "ellipse": True}
    assert result.scores["none"]["growth_iou"] == 0.0
    assert 0.2 < result.scores["distance"]["growth_iou"] < result.scores["ellipse"]["growth_iou"] < 0.9
    assert result.scores["shape"]["growth_iou"] > 0.9  # the likeliest cells with equal probability are a choice
    assert all(result.scores[name]["skill"] > 0 for name in nulls.NULLS)
    assert result.hours_to_size == pytest.approx(3.0, abs=0.3)


def test_a_null_model_as_a_forecast_beats_no_better_than_itself(fire):
    forecast, scar, fuel = fire
    distance = nulls.equal_distance(fuel, scar.start, int(scar.burnt.sum()))
    result = judge(forecast._replace(probability=distance * 1.0), scar, GRID, fuel=fuel, wind=(4.0, 270.0))
    assert result.beats["distance"] is False
    assert result.scores["distance"]["skill"] == 0.0


def test_what_is_told(fire, result):
    summary = json.loads(json.dumps(plain(result.summary()), allow_nan=False))
    assert summary["observed_ha"] == pytest.approx(fire[1].burnt.sum() * 0.04)
    assert summary["simulated_ha_p10"] < summary["simulated_ha_p50"] < summary["simulated_ha_p90"]
    assert summary["notes"] == ["a note on the scar", "durations are assumed"]
    assert len(summary["reliability"]) == skill.BINS
    assert sum(row["cells"] for row in summary["reliability"]) == (fire[2] | fire[1].burnt).sum()
    assert result.table()["model"].tolist() == list(result.scores)
    never = judge(fire[0]._replace(sizes=np.ones((12, 12), int)), fire[1], GRID, fuel=fire[2], wind=(4.0, 270.0))
    assert never.summary()["hours_to_observed_size"] is None


def test_planes_of_other_shapes_are_refused(fire):
    forecast, scar, fuel = fire
    with pytest.raises(GridError, match=r"the fuel has shape \(52, 40\)"):
        judge(forecast, scar, GRID, fuel=fuel.T, wind=(4.0, 270.0))


def test_the_figure_shows_scar_nulls_contours_and_scores(fire, result, tmp_path):
    figure = validation_figure(result, title="a fire", fuel=fire[2])
    labels = [text.get_text() for legend in figure.legends for text in legend.get_texts()]
    assert labels == [
        "observed scar",
        "null: equal distance in fuel, as large as the scar",
        "null: wind ellipse, as large as the scar",
        "median arrival",
        "start",
    ]
    words = " ".join(text.get_text() for axes in figure.axes for text in axes.texts)
    assert "durations are assumed" in words
    tables = [table for axes in figure.axes for table in axes.tables]
    cells = [cell.get_text().get_text() for table in tables for cell in table.get_celld().values()]
    assert f"{result.scores['ellipse']['growth_iou']:.2f}" in cells
    one = save(figure, tmp_path / "a.png").read_bytes()
    assert one == save(validation_figure(result, title="a fire", fuel=fire[2]), tmp_path / "b.png").read_bytes()


def test_outlines_go_along_the_cells(fire, result):
    figure = validation_figure(result, title="", fuel=fire[2])
    segments = figure.axes[0].collections[-1].get_segments()  # the scar is drawn last
    rows, cols = np.nonzero(fire[1].burnt)
    ends = np.array(segments).reshape(-1, 2) / 0.02
    assert ends[:, 0].min() == pytest.approx(cols.min())
    assert ends[:, 0].max() == pytest.approx(cols.max() + 1)
    assert (SHAPE[0] - ends[:, 1]).min() == pytest.approx(rows.min())
    assert (SHAPE[0] - ends[:, 1]).max() == pytest.approx(rows.max() + 1)
    padded = np.pad(fire[1].burnt, 1).astype(int)
    assert len(segments) == abs(np.diff(padded, axis=0)).sum() + abs(np.diff(padded, axis=1)).sum()
