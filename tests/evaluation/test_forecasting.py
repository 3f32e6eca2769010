"""Observed fires simulated: cases in, forecasts, validations and calibrations out."""

import tomllib

import numpy as np
import pandas as pd
import pytest

from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.evaluation import fire_sizes
from firebreak_gis.evaluation.calibration import Calibration, calibrate_scars, calibrate_sizes
from firebreak_gis.evaluation.forecasting import Case, growth_of, open_case, run_case, validate
from firebreak_gis.grid import Grid
from firebreak_gis.simulation.weather import Spell, Step, Weather
from firebreak_gis.spread import spread_network, weather_networks
from tests.places import real, shared

ROSE = "rose:W=4"
SHAPE = (61, 75)


@pytest.fixture(scope="module")
def land(make_landscape):
    """Flat shrubs with a lake."""
    lake = np.ones(SHAPE, bool)
    lake[35:42, 45:55] = False
    return make_landscape(SHAPE, holes=0.0, relief=0.0, vegetation=2 * lake, density=2 * lake, burnable=lake)


def window(land, rows, cols):
    plane = np.zeros(SHAPE, bool)
    plane[rows[0] : rows[1] + 1, cols[0] : cols[1] + 1] = True
    return plane


@pytest.fixture(scope="module")
def true_fire(land):
    """What burns with half the usual rate in two hours in at least half of the runs, and where it starts."""
    start = window(land, (30, 30), (25, 25))
    guess = np.ones(SHAPE, bool)
    case = open_case(Case(land, guess, start, "2h", ROSE))
    return run_case(case, {"rate_scale": 0.5}, n_runs=60, seed=5).probability >= 0.5, start


def test_a_forecast_is_of_one_piece(land, true_fire):
    scar, start = true_fire
    case = open_case(Case(land, scar, start, "2h", ROSE))
    found = run_case(case, {}, n_runs=40, seed=1, threads=1)
    assert found.probability[30, 25] == 1.0
    assert found.arrival[30, 25] == pytest.approx(0.0, abs=0.2)
    assert (found.arrival[found.probability > 0] <= 2.0).all()
    assert np.isnan(found.arrival[found.probability == 0]).all()
    assert found.hours[-1] == 4.0
    assert np.array_equal(found.sizes[:, found.hours == 2.0].ravel(), found.burnt)
    assert (np.diff(found.sizes, axis=1) >= 0).all()
    assert np.nansum(found.probability) * 40 == pytest.approx(found.burnt.sum())
    again = run_case(case, {}, n_runs=40, seed=1, threads=2)
    assert np.array_equal(found.probability, again.probability, equal_nan=True)
    drawn = run_case(open_case(Case(land, scar, start, "lognormal:1h,0.5", ROSE)), {}, n_runs=40, seed=1)
    assert (drawn.sizes[:, -1] >= drawn.burnt).all()
    assert len(set(drawn.burnt.tolist())) > 30


def test_validate_knows_the_model_that_made_the_fire(land, true_fire):
    scar, start = true_fire
    true = validate(land, scar, start=start, duration="2h", weather=ROSE, n_runs=60, rate_scale=0.5)
    fast = validate(land, scar, start=start, duration="2h", weather=ROSE, n_runs=60)
    assert true.beats == {"none": True, "distance": True, "ellipse": True}
    assert true.scores["simulated"]["growth_iou"] > 0.85 > 0.6 > fast.scores["simulated"]["growth_iou"]
    assert true.scores["simulated"]["size_ratio"] == pytest.approx(1.0, abs=0.15)
    assert true.hours_to_size == pytest.approx(2.0, rel=0.1)
    assert fast.hours_to_size == pytest.approx(1.0, rel=0.15)
    assert any("wind of the ellipse 4.0 m/s from 270 degrees" in note for note in true.notes)


def test_a_network_with_times_will_do_for_one_weather(land, true_fire):
    scar, start = true_fire
    network = spread_network(land, clock=True, wind_speed=4.0, wind_from_direction=270.0)
    one = validate(network, scar, start=start, duration="1h", n_runs=30, wind=(4.0, 270.0))
    other = validate(land, scar, start=start, duration="1h", weather=ROSE, n_runs=30)
    assert one.scores == other.scores
    same = validate(land, scar, start=start, duration="1h", n_runs=30, wind_speed=4.0, wind_from_direction=270.0)
    assert same.scores == other.scores
    with pytest.raises(ParameterError, match="rate_scale cannot be set where a network is given"):
        validate(network, scar, start=start, duration="1h", rate_scale=0.5)
    with pytest.raises(ParameterError, match="a network is of one weather already"):
        validate(network, scar, start=start, duration="1h", weather=ROSE)
    with pytest.raises(InputError, match="travel times"):
        validate(spread_network(land), scar, start=start, duration="1h")
    with pytest.raises(InputError, match="does not exist"):
        validate("no/such/folder", scar, start=start, duration="1h")


def test_embers_cross_what_a_fire_without_them_does_not(land, true_fire):
    scar, start = true_fire
    wall = np.ones(SHAPE, bool)
    wall[:, 32:34] = False
    cut = land.copy()
    for name in ("vegetation", "density", "burnable"):
        cut[name] = land[name].where(wall, 0).astype(land[name].dtype)
    given = {"start": start, "duration": "4h", "weather": ROSE, "n_runs": 30}
    without = validate(cut, scar, **given)
    flying = validate(cut, scar, embers="rate=60", **given)
    assert np.nansum(without.forecast.probability[:, 34:]) == 0.0
    assert np.nansum(flying.forecast.probability[:, 34:]) > 0.0
    assert "not simulated: fire fighting, embers" in without.notes
    assert "not simulated: fire fighting" in flying.notes
    assert any("ember" in note and "60" in note for note in flying.notes)


def test_the_wind_of_the_ellipse_is_the_mean_over_time(land, true_fire):
    spells = (
        Spell((Step(4.0, 350.0), Step(4.0, 10.0)), starts=(0, 3600), span=7200, weight=3.0),
        Spell((Step(8.0, 0.0),), weight=1.0),
    )
    case = open_case(Case(land, *true_fire, "1h", Weather(spells)))
    speed, direction = case.wind({})
    assert speed == pytest.approx(5.0)
    assert min(direction, 360 - direction) == pytest.approx(0.0, abs=1e-6)


def test_calibration_finds_the_rate_that_made_the_fires(land, true_fire):
    scar, start = true_fire
    cases = [Case(land, scar, start, "2h", ROSE, name=f"fire {i}") for i in range(2)]
    found = calibrate_scars(cases, n_runs=40)
    assert (found.n_parameters, found.n_fires) == (1, 2)
    assert found.table["rate"].tolist() == pytest.approx([0.5, 0.5], rel=0.1)
    assert found.table["size_ratio_left_out"].tolist() == pytest.approx([1.0, 1.0], abs=0.2)
    config = tomllib.loads(found.config())
    assert config["for"] == "every command"
    assert config["parameters"]["model-param"]["rate_scale"] == pytest.approx(0.5, rel=0.1)
    alone = calibrate_scars(cases[:1], n_runs=20)
    assert "rate_left_out" not in alone.table
    assert any("no fire could be left out" in note for note in alone.notes)


def test_three_scars_tell_how_durations_differ(land, true_fire):
    """The same scar said to have spread for 1, 2 and 4 hours: rates apart by factors of two are durations apart."""
    scar, start = true_fire
    found = calibrate_scars(
        [Case(land, scar, start, f"{hours}h", ROSE, name=str(hours)) for hours in (1, 2, 4)], n_runs=30
    )
    assert found.n_parameters == 3
    assert found.table["rate"].tolist() == pytest.approx([1.0, 0.5, 0.25], rel=0.1)
    kind, _, words = found.parameters["duration"].partition(":")
    median, sigma = words.split(",")
    assert kind == "lognormal"
    assert float(median[:-1]) == pytest.approx(2 * 3600, rel=0.02)
    assert float(sigma) < 0.1  # the fires were all alike, whatever was said of them
    assert found.table["rate_left_out"].notna().all()


def test_calibration_takes_the_p0_of_the_best_shapes(land, true_fire, monkeypatch):
    from firebreak_gis.evaluation import calibration

    monkeypatch.setattr(calibration, "P0_TRIED", (0.3, 0.58))
    scar, start = true_fire
    cases = [Case(land, scar, start, "2h", ROSE, name=str(i)) for i in range(3)]
    both = calibrate_scars(cases, fit=("rate", "p0"), n_runs=30)
    shapes = {p0: calibrate_scars(cases[:1], n_runs=30, p0=p0).table["shape_growth_iou"][0] for p0 in (0.3, 0.58)}
    best = max(shapes, key=shapes.get)
    assert both.parameters["model-param"]["p0"] == best
    assert both.n_parameters == 2
    assert both.table["shape_growth_iou"].tolist() == pytest.approx([shapes[best]] * 3)
    assert both.table["rate_left_out"].notna().all()


def test_more_parameters_than_fires_are_refused(land, true_fire):
    case = Case(land, *true_fire, "2h", ROSE)
    with pytest.raises(ParameterError, match=r"1 fires cannot tell 2 parameters \(rate, p0\)"):
        calibrate_scars([case], fit=("rate", "p0"))
    with pytest.raises(ParameterError, match=r"2 fires cannot tell 3 parameters \(rate, duration\)"):
        calibrate_scars([case] * 2, fit=("duration",))
    with pytest.raises(ParameterError, match="fit is colour, rate, expected some of rate, duration, p0"):
        calibrate_scars([case], fit=("colour",))
    table = pd.DataFrame({"ha": [5.0, 7.0, 2.0], "days": [1.0, 1.0, 1.0]})
    with pytest.raises(ParameterError, match="3 fires cannot tell 4 parameters"):
        calibrate_sizes(land, table, weather=ROSE, fit=("rate", "duration", "p0"), least=1.0)
    with pytest.raises(ParameterError, match="2 fires cannot tell 3 parameters"):
        calibrate_sizes(land, table, weather=ROSE, least=4.0)


@pytest.fixture(scope="module")
def wide(make_landscape):
    """Room for fires of some hundred hectares, in cells of 100 m."""
    return make_landscape((90, 110), holes=0.05, relief=0.0, vegetation=2, density=2, cell=100.0, seed=4)


def test_sizes_and_days_tell_durations_and_rates(wide):
    """Fires made with double rates that last two hours in the median are told from their sizes and hours alone."""
    winds = "rose:W=3,S=3"
    growth = growth_of(wide, winds, longest=40 * 3600.0, n_runs=100, seed=9, rate_scale=2.0)
    random = np.random.default_rng(1)
    seconds = 2 * 3600 * np.exp(0.8 * random.standard_normal(100))
    sizes = growth.at(seconds)
    fires = pd.DataFrame({"ha": sizes, "days": seconds / 3600})  # an hour of spread on each of them
    found = calibrate_sizes(
        wide, fires, weather=winds, least=3.0, large=100.0, hours_a_day=1.0, longest=80 * 3600.0, n_runs=100
    )
    assert found.account["rate_scale"] == pytest.approx(2.0, rel=0.25)
    assert found.account["duration_median_s"] == pytest.approx(2 * 3600, rel=0.3)
    assert found.account["duration_sigma"] == pytest.approx(0.8, rel=0.3)
    assert 0.8 <= found.account["left_out_within_90"] <= 1.0
    for name, (low, high) in found.account["observed_90"].items():
        assert low <= found.account["simulated"][name] <= high, name
    config = tomllib.loads(found.config())["parameters"]
    assert config["duration"].startswith("lognormal:")
    assert config["weather"] == winds
    table = found.table
    assert len(table) == (sizes >= 3).sum()


def test_sizes_take_the_p0_that_fits_best(wide, monkeypatch):
    from firebreak_gis.evaluation import calibration

    monkeypatch.setattr(calibration, "P0_TRIED", (0.35, 0.58))
    sizes = growth_of(wide, ROSE, longest=6 * 3600.0, n_runs=60, seed=3).at(np.full(60, 4 * 3600.0))
    fires = pd.DataFrame({"ha": sizes, "days": np.nan})
    given = {"weather": ROSE, "least": 2.0, "longest": 24 * 3600.0, "n_runs": 60, "fit": ("duration",)}
    found = calibrate_sizes(wide, fires, **{**given, "fit": ("duration", "p0")})
    single = {p0: calibrate_sizes(wide, fires, p0=p0, **given).account["anderson_darling"] for p0 in (0.35, 0.58)}
    assert found.parameters["model-param"]["p0"] == min(single, key=single.get)
    assert found.account["anderson_darling"] == min(single.values())
    assert found.account["rate_scale"] == 1.0
    assert "rate_scale" not in found.parameters["model-param"]


def test_growth_scales_with_the_rate(wide):
    """What the fit rests on: rates twice as high are times twice as long."""
    slow = growth_of(wide, ROSE, longest=8 * 3600.0, n_runs=40, seed=2, rate_scale=1.0)
    fast = growth_of(wide, ROSE, longest=4 * 3600.0, n_runs=40, seed=2, rate_scale=2.0)
    one, other = slow.at(np.full(40, 7 * 3600.0)), fast.at(np.full(40, 3.5 * 3600.0))
    assert other == pytest.approx(one, rel=0.1)
    assert other.mean() == pytest.approx(one.mean(), rel=0.02)


def test_growth_is_that_of_the_ensemble(wide):
    networks = weather_networks(wide, "rose:W=3,N=6")
    assert len(networks) == 2
    growth = growth_of(wide, "rose:W=3,N=6", longest=3 * 3600.0, n_runs=30, seed=2)
    assert growth.hectares.shape == (30, growth.times.size)
    assert growth.hectares.min() >= Grid.of(wide["burnable"]).cell_area_ha
    assert fire_sizes.statistics(growth.hectares[:, -1], least=1.0, large=10.0)["median_ha"] > 1.0


def test_a_configuration_is_toml(tmp_path):
    made = Calibration(
        {"clock": True, "duration": "lognormal:3600s,0.5", "weather": 'C:\\a "b".csv', "model-param": {"p0": 0.5}},
        1,
        2,
        pd.DataFrame(),
        notes=("a note",),
    )
    assert tomllib.loads(made.config())["parameters"] == made.parameters


def belgian(name, hours):
    from firebreak_gis.landscape import read_landscape

    land = read_landscape(
        shared(name, "elevation.tif"),
        shared(name, "fuels.tif"),
        legend="scott_burgan_40",
        resolution=40.0,
    )
    return Case(
        land,
        shared(name, "observed_scar.shp"),
        shared(name, "ignition.gpkg"),
        f"{hours}h",
        shared(name, "weather.csv"),
        "1h",
        name,
    )


@real
def test_two_belgian_fires_beside_fires_that_know_nothing():
    """Coarse cells, few runs: the rate of one fire foretells the size of the other within a factor of three."""
    cases = [belgian("clinge_2025", 4), belgian("maasmechelen_2025", 8)]
    found = calibrate_scars(cases, n_runs=20)
    assert found.table["size_ratio_left_out"].between(1 / 3, 3).all()
    assert (found.table["growth_iou"] > 0.2).all()


@real
def test_durations_of_one_half_of_monchiques_fires_foretell_the_other():
    """Coarse cells and few runs: median and 90 % of the odd years' fires from those of the even years."""
    import geopandas as gpd

    from firebreak_gis.landscape import read_landscape
    from firebreak_gis.landscape.scars import fire_table

    land = read_landscape(shared("monchique_100m", "landscape_2003.lcp"), legend="fernandes", resolution=300.0)
    fires = gpd.read_file(shared("monchique_100m", "perimeters.shp"))
    even, odd = (fire_table(fires[fires["Year"] % 2 == rest]) for rest in (0, 1))
    found = calibrate_sizes(land, even, weather="rose:N=4,NW=4,S=4,E=4", n_runs=60, moisture=0.06)
    observed = fire_sizes.bootstrap(odd["ha"].to_numpy(), least=100.0, large=1000.0)
    for name in ("median_ha", "p90_ha"):
        low, high = observed[name]
        assert low / 1.5 <= found.account["simulated"][name] <= 1.5 * high, name
    assert (found.n_fires, found.n_parameters) == (14, 3)
    assert 0.5 < found.account["rate_scale"] < 3.0
