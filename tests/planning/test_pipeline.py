"""The whole way in Python: a plan of a small landscape, written, refused, stopped."""

from __future__ import annotations

from functools import partial

import geopandas as gpd
import numpy as np
import pandas as pd
import pytest
import rasterio
from shapely.geometry import Point

from firebreak_gis import evaluate, plan, rank, select_breaks, simulate, spread_network
from firebreak_gis.errors import Cancelled, InputError, OutputError, ParameterError
from firebreak_gis.files.outputs import names
from firebreak_gis.landscape import read_landscape_folder
from firebreak_gis.planning.budgets import default_budgets
from firebreak_gis.planning.judging import ASSUMED_DURATION, ASSUMED_HOLD
from firebreak_gis.planning.outputs import OUTPUTS, write_plan
from firebreak_gis.schema import DENSITY, VEGETATION


@pytest.fixture(scope="module")
def landscape(make_landscape):
    return make_landscape((22, 31), seed=2, relief=4.0)


@pytest.fixture(scope="module")
def result(landscape):
    return plan(
        landscape,
        budget=0.14,
        method="bonacich",
        method_params={"beta": 0.2},
        model_params={"wind_speed": 3},
        n_runs=40,
        seed=6,
    )


def test_a_plan_is_its_stages(landscape, result):
    network = spread_network(landscape, wind_speed=3)
    priority = rank(network, "bonacich", beta=0.2)
    breaks = select_breaks(priority, budget=0.14)
    np.testing.assert_array_equal(result.priority, priority)
    np.testing.assert_array_equal(result.breaks, breaks)
    timed = spread_network(landscape, wind_speed=3, clock=True)
    fires = {"n_runs": 40, "seed": 6, "duration": ASSUMED_DURATION}
    assert result.before.identical(simulate(timed, hold=ASSUMED_HOLD, **fires))
    assert result.after.identical(simulate(timed, breaks=breaks, hold=ASSUMED_HOLD, **fires))
    assert set(result.evaluation["ranking"].to_numpy()) == {"bonacich", "random", "flammability"}


def test_a_timeless_plan_is_that_of_the_paper(landscape, result):
    asked = {"budget": 0.14, "method": "bonacich", "method_params": {"beta": 0.2}, "n_runs": 40, "seed": 6}
    paper = plan(landscape, **asked, model_params={"wind_speed": 3}, timeless=True)
    network = spread_network(landscape, wind_speed=3)
    assert paper.breaks.identical(result.breaks)
    assert paper.before.identical(simulate(network, n_runs=40, seed=6))
    assert paper.after.identical(simulate(network, breaks=paper.breaks, n_runs=40, seed=6))
    rankings = {name: rank(network, name, seed=6) for name in ("random", "flammability")}
    rankings = {"bonacich": rank(network, "bonacich", beta=0.2), **rankings}
    assert paper.paper.identical(evaluate(network, rankings, budgets=default_budgets(0.14), n_runs=40, seed=6))
    assert paper.evaluation.identical(paper.paper)
    assert result.paper.identical(paper.paper)
    assert len(paper.headline) == 1
    told = paper.summary
    assert told["timeless"]["burnt_share_with_breaks"] == pytest.approx(told["burnt_share_with_breaks"])


def test_endless_fires_and_breaks_that_hold_are_the_paper(landscape):
    """Where the probability keeps wind and slope, a clock that never stops changes nothing."""
    asked = {"method": "flammability", "n_runs": 30, "seed": 2}
    params = {"wind_speed": 4.0, "probability_keeps": "both"}
    paper = plan(landscape, **asked, model_params=params, timeless=True)
    endless = plan(landscape, **asked, model_params=params, duration="inf", hold=1)
    for side in ("before", "after"):
        np.testing.assert_array_equal(getattr(endless, side)["fire_size"], getattr(paper, side)["fire_size"])
        np.testing.assert_array_equal(getattr(endless, side)["burn_count"], getattr(paper, side)["burn_count"])
    assert not endless.judged.reburnt


def test_the_headline_names_clock_weather_and_breaks(landscape):
    made = plan(landscape, method="flammability", model_params={"wind_speed": 3, "wind_from_direction": 270}, n_runs=20)
    first, second = made.headline
    for word in ("burn 8 h in the median", "wind 3 m/s from 270 degrees", "holds in 0.47 of fires"):
        assert word in first
        assert word in " ".join(made.judged.assumptions).lower()
    assert "assumed, not known" in " ".join(made.judged.assumptions)
    assert "Without a clock and with perfect breaks" in second
    share = 100 * float(made.paper["mean"].sel(ranking="flammability", budget=0.1))
    assert f"{share:.1f} % with them" in second
    rose = "rose:NW=5x0.4,N=8x0.2;duration=2h"
    told = plan(landscape, method="flammability", weather=rose, hold="0.8:100", embers=True, n_runs=20)
    assert "2 weathers, drawn by their weights, mean wind 6 m/s" in told.headline[0]
    assert "as long as the weather tells" in told.headline[0]
    assert "each 100 m of break holds in 0.8" in told.headline[0]
    assert "assumed, not known" not in " ".join(told.judged.assumptions)
    assert (told.before["duration"] == 7200).all()
    assert set(told.before["weather"].to_numpy()) == {0, 1}


def test_breaks_are_designed_without_a_clock_where_it_is_asked(landscape):
    """Whatever judges them; of several weathers the design knows the mean."""
    still = partial(plan, method_params={"by_fires": False})
    clocks = [{"timeless": True}, {"duration": "1h", "hold": "flame"}, {"embers": True}, {"hold": 0.2}]
    breaks = [still(landscape, n_runs=5, **clock).breaks for clock in clocks]
    for other in breaks[1:]:
        assert other.identical(breaks[0])
    one = still(landscape, n_runs=5, model_params={"wind_speed": 5.0, "wind_from_direction": 315.0})
    same = still(landscape, n_runs=5, weather="rose:NW=5x0.4,NW=5x0.6")
    np.testing.assert_allclose(same.network.probability, one.network.probability, rtol=1e-6)
    np.testing.assert_array_equal(same.after["fire_size"], one.after["fire_size"])
    north = spread_network(landscape, wind_speed=8.0).probability.astype(float)
    west = spread_network(landscape, wind_speed=4.0, wind_from_direction=270.0).probability.astype(float)
    mixed = plan(landscape, n_runs=5, weather="rose:N=8x1,W=4x3", method="flammability").network.probability
    np.testing.assert_allclose(mixed, 0.25 * north + 0.75 * west, rtol=1e-6)


def test_more_budget_saves_more(landscape):
    """Every budget meets the same fires: cutting more of one ranking never burns more."""
    made = plan(landscape, method="dissection", budget=0.1, duration="2h", n_runs=80)
    budgets = made.evaluation["budget"].to_numpy()
    np.testing.assert_allclose(budgets, [0.0, 0.05, 0.1, 0.15, 0.2])
    mean = made.evaluation["mean"].sel(ranking="dissection").to_numpy()
    assert (np.diff(mean) <= 0).all()
    assert mean[-1] < mean[0]
    cells = made.evaluation["burnt_cells"].sel(ranking="dissection")
    np.testing.assert_array_equal(cells.sel(budget=0.1), made.after["fire_size"])
    np.testing.assert_array_equal(cells.sel(budget=0.0), made.before["fire_size"])


def test_barriers_hold_as_asked(landscape):
    """A barrier that always fails is fuel for the fires; one that always holds is none, as in the design."""
    barriers = np.zeros(landscape["burnable"].shape)
    barriers[:, 15] = 1
    asked = {"method": "flammability", "barriers": barriers, "duration": "3h", "n_runs": 60, "hold": 1}
    holds, half, never = (plan(landscape, **asked, barriers_hold=share) for share in (1.0, 0.5, 0.0))
    free = plan(landscape, **{**asked, "barriers": None}, ignitions=holds.judged.fires.ignitions)
    means = [float(made.before["fire_size"].mean()) for made in (holds, half, never)]
    assert means[0] < means[1] < means[2]
    np.testing.assert_array_equal(never.before["fire_size"], free.before["fire_size"])
    assert np.isnan(holds.before["burn_frequency"].to_numpy()[:, 15]).all()
    for other in (half, never):
        assert other.breaks.identical(holds.breaks)
    rose = plan(landscape, **{**asked, "weather": "rose:N=0"})
    np.testing.assert_array_equal(rose.before["fire_size"], holds.before["fire_size"])


def test_a_model_without_times_is_judged_without_a_clock(landscape):
    emptiness = (
        landscape["burnable"].astype(np.float32).copy(data=np.full(landscape["burnable"].shape, 0.1, np.float32))
    )
    land = landscape.assign(emptiness=emptiness)
    made = plan(land, model="artificial", method="flammability", n_runs=20)
    paper = plan(land, model="artificial", method="flammability", n_runs=20, timeless=True)
    assert made.before.identical(paper.before)
    assert made.after.identical(paper.after)
    assert any("tells no times" in warning for warning in made.feasibility.warnings)
    assert not any("tells no times" in warning for warning in paper.feasibility.warnings)
    for asked in ({"duration": "8h"}, {"embers": True}, {"hold": "flame"}):
        with pytest.raises(InputError, match="travel times"):
            plan(land, model="artificial", **asked)


def test_timeless_fires_have_no_clock(landscape):
    for asked in ({"duration": "8h"}, {"embers": True}):
        with pytest.raises(ParameterError, match="--timeless"):
            plan(landscape, timeless=True, **asked)
    failing = plan(landscape, method="flammability", timeless=True, hold=0.3, n_runs=60)
    perfect = plan(landscape, method="flammability", timeless=True, n_runs=60)
    assert failing.after["fire_size"].sum() > perfect.after["fire_size"].sum()
    assert failing.before["burn_count"].equals(perfect.before["burn_count"])
    assert len(failing.headline) == 2


def test_figures_of_a_plan(result):
    n_burnable = result.network.n_burnable
    summary, sizes = result.summary, result.fire_sizes
    assert summary["burnable_cells"] == n_burnable
    assert summary["cells_cut"] == int(0.14 * n_burnable + 0.5) == result.polygons["cells"].sum()
    assert summary["ha_cut"] == pytest.approx(summary["cells_cut"] * 0.04)
    assert summary["burnt_share_without_breaks"] == pytest.approx(sizes["cells_without_breaks"].mean() / n_burnable)
    assert summary["burnt_share_with_breaks_max"] == pytest.approx(sizes["cells_with_breaks"].max() / n_burnable)
    chosen = result.evaluation.sel(ranking="bonacich", budget=0.14)
    assert summary["burnt_share_with_breaks"] == pytest.approx(float(chosen["mean"]))
    assert summary["burnt_share_with_breaks_p90"] == pytest.approx(float(chosen["p90"]))
    assert summary["p_value_against_random"] == float(chosen["p_value"])
    assert (sizes["cells_with_breaks"] <= sizes["cells_without_breaks"]).all()


def test_threads_change_nothing(landscape, result):
    again = plan(
        landscape,
        budget=0.14,
        method="bonacich",
        method_params={"beta": 0.2},
        model_params={"wind_speed": 3},
        n_runs=40,
        seed=6,
        threads=1,
    )
    assert again.evaluation.identical(result.evaluation)
    assert again.after.identical(result.after)


def test_written_plan_is_read_back(landscape, result, tmp_path):
    files = write_plan(result, tmp_path / "new" / "folder")
    assert {f.name for f in files} == set(names(OUTPUTS, ()))
    assert files[-1].name == "run.json"
    folder = tmp_path / "new" / "folder"
    back = read_landscape_folder(folder)
    for name in ("elevation", "vegetation", "density", "burnable"):
        np.testing.assert_array_equal(back[name], landscape[name])
    for name, data in {
        "breaks": result.breaks,
        "burn_frequency": result.before["burn_frequency"],
        "burn_frequency_with_breaks": result.after["burn_frequency"],
    }.items():
        with rasterio.open(folder / f"{name}.tif") as source:
            stored = source.read(1, masked=True).astype(float).filled(np.nan)
            assert source.crs.to_epsg() == 32635
        np.testing.assert_array_equal(stored, data.to_numpy().astype(float))
    pd.testing.assert_frame_equal(pd.read_csv(folder / "fire_sizes.csv"), result.fire_sizes, check_dtype=False)
    frame = gpd.read_file(folder / "breaks.gpkg")
    assert frame.geometry.geom_equals(result.polygons.geometry).all()


def test_nothing_is_written_if_one_file_is_in_the_way(result, tmp_path):
    (tmp_path / "overview.png").write_text("mine")
    with pytest.raises(OutputError, match=r"overview\.png exists"):
        write_plan(result, tmp_path)
    assert [p.name for p in tmp_path.iterdir()] == ["overview.png"]
    write_plan(result, tmp_path, overwrite=True)
    assert (tmp_path / "overview.png").stat().st_size > 10_000


def test_inputs_are_never_overwritten(result, tmp_path):
    source = tmp_path / "elevation.tif"
    source.write_bytes(b"the only copy")
    with pytest.raises(OutputError, match="input"):
        write_plan(result, tmp_path, inputs=[source], overwrite=True)
    assert source.read_bytes() == b"the only copy"


def test_wind_rasters_may_be_written_down(landscape, tmp_path):
    """Rasters among the parameters are named by their content in the account."""
    shape = landscape["burnable"].shape
    wind = {"wind_speed": np.full(shape, 5.0), "wind_from_direction": 10.0}
    windy = plan(landscape, method="flammability", model_params=wind, n_runs=3)
    same = plan(landscape, method="flammability", model_params={**wind, "wind_speed": 5.0}, n_runs=3)
    np.testing.assert_array_equal(windy.network.probability, same.network.probability)
    write_plan(windy, tmp_path)
    assert "array 22 x 31" in (tmp_path / "run.json").read_text()


def test_nothing_to_cut_and_everything_to_cut(landscape, tmp_path):
    none = plan(landscape, budget=0.0, method="random", n_runs=5)
    assert none.breaks.sum() == 0
    assert none.after["burn_count"].equals(none.before["burn_count"])
    assert len(none.polygons) == 0
    assert "p_value_against_random" not in none.summary
    write_plan(none, tmp_path / "none")
    assert len(gpd.read_file(tmp_path / "none/breaks.gpkg")) == 0
    everything = plan(landscape, budget=1.0, method="random", n_runs=5, hold=1)
    assert everything.breaks.sum() == everything.network.n_burnable
    assert everything.after["fire_size"].sum() == 0


def test_fires_of_given_points(landscape):
    row, col = np.argwhere(landscape["burnable"].to_numpy())[200]
    point = Point(float(landscape["x"][col]), float(landscape["y"][row]))
    frame = gpd.GeoDataFrame(geometry=[point], crs="EPSG:32635").to_crs("EPSG:4326")
    burnt = plan(landscape, method="flammability", ignitions=frame, n_runs=12).before
    assert burnt["burn_frequency"][row, col] == 1


@pytest.mark.parametrize(
    ("wrong", "error"),
    [
        ({"budget": 1.2}, ParameterError),
        ({"n_runs": 0}, ParameterError),
        ({"seed": -3}, ParameterError),
        ({"residual": -0.5}, ParameterError),
        ({"ignitions": [(0.0, 0.0)]}, InputError),
        ({"ignitions": "nowhere.gpkg"}, InputError),
        ({"method": "guess"}, ParameterError),
        ({"model_params": {"p0": 7}}, ParameterError),
    ],
)
def test_what_cannot_be_is_refused_before_the_long_work(landscape, wrong, error, monkeypatch):
    """A wrong ignition must not be found after an hour of ranking."""
    monkeypatch.setattr("firebreak_gis.ranking.bonacich.rank", lambda *_, **__: pytest.fail("ranked first"))
    with pytest.raises(error):
        plan(landscape, **{"method": "bonacich", **wrong})


def test_a_plan_can_be_stopped_at_any_step(landscape, result, tmp_path):
    heard = []
    plan(landscape, method="bonacich", n_runs=5, progress=lambda fraction, message: heard.append((fraction, message)))
    shares = [f for f, _ in heard]
    assert shares == sorted(shares)
    assert shares[-1] == pytest.approx(1.0)
    messages = " ".join(m for _, m in heard)
    for word in ("rank by bonacich", "without breaks", "with breaks", "evaluate"):
        assert word in messages
    for limit in (0.1, 0.4, 0.55, 0.9):

        def stop(fraction, message, limit=limit):
            if fraction >= limit:
                raise Cancelled("enough")

        with pytest.raises(Cancelled):
            plan(landscape, method="bonacich", n_runs=5, progress=stop)

    # A stop that is obeyed leaves nothing, even one that comes when all but the moving is done.
    for limit in (0.5, 1.0):

        def stop_writing(fraction, message, limit=limit):
            if fraction >= limit:
                raise Cancelled("enough")

        with pytest.raises(Cancelled):
            write_plan(result, tmp_path, progress=stop_writing)
        assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("marked", [0.0, 0.14, 0.1 + 0.2, 0.7, 1.0])
def test_budgets_hold_the_marked_one(marked):
    budgets = default_budgets(marked)
    assert (np.diff(budgets) > 0).all()
    assert marked in budgets
    assert budgets[0] == 0
    assert budgets[-1] <= 1
    assert budgets[-1] >= min(1.0, 1.2 * marked)


def test_class_shares_of_the_cut_cells_stand_beside_those_of_random_cutting(make_landscape):
    landscape = make_landscape((20, 31), seed=4)
    made = plan(landscape, budget=0.2, method="flammability", n_runs=5)
    shares = made.summary["cut_classes"]
    cut, fuel = made.breaks.to_numpy() > 0, made.network.burnable
    for layer, classes in (("vegetation", VEGETATION), ("density", DENSITY)):
        assert list(shares[layer]) == [name for code, name in classes.items() if code]
        for code, name in classes.items():
            if code:
                codes = landscape[layer].to_numpy()
                assert shares[layer][name]["cut"] == pytest.approx((codes[cut] == code).mean())
                assert shares[layer][name]["random"] == pytest.approx((codes[fuel] == code).mean())
    assert shares["density"]["dense"]["cut"] > shares["density"]["dense"]["random"]


def test_repr_is_one_short_line_and_segments_have_names(result):
    text = repr(result)
    assert len(text) < 250
    assert "\n" not in text
    assert result.request.design.method in text
    assert len(result.segments.lines) == len(result.segments.polygons) > 0
