"""Weather: tables and wind roses, which run has which, and the networks of a landscape in it."""

from __future__ import annotations

import math

import numpy as np
import pandas as pd
import pytest

import firebreak_gis as fb
from firebreak_gis.errors import InputError, ParameterError
from firebreak_gis.lattice import NEVER
from firebreak_gis.planning.weather import SpreadRequest, WeatherRequest
from firebreak_gis.simulation.weather import Spell, Step, Weather, WeatherNetworks
from firebreak_gis.simulation.weather_reading import read_weather
from firebreak_gis.spread import spread_network, weather_networks


@pytest.fixture
def table(tmp_path):
    """Function that writes a table and returns its path."""

    def write(*lines):
        path = tmp_path / "weather.csv"
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
        return path

    return write


@pytest.mark.parametrize(
    "header",
    [
        "weight,wind_speed_kmh,wind_from,moisture_pct,duration_h",
        "Weight,Wind speed [km/h],Wind direction (deg),Moisture [%],Duration [h]",
        "weight,windspeed (km h-1),wind_from_direction_degrees,moisture (percent),duration (hours)",
        "weight,WS,WD,moisture_percent,duration_hours",
        "weight;wind_speed_km_h;wd;moisture_%;duration_hr",
    ],
)
def test_names_tell_the_units(table, header):
    rows = ["2,36,270,8,6", "1,18,90,12.5,0.5"]
    weather = read_weather(table(header, *(row.replace(",", ";") if ";" in header else row for row in rows)))
    assert weather.spells == (
        Spell((Step(10.0, 270.0, 0.08),), weight=2.0, duration=21_600.0),
        Spell((Step(5.0, 90.0, 0.125),), weight=1.0, duration=1_800.0),
    )
    assert weather.steady
    assert weather.timed
    assert any("wind_speed in k" in said for said in weather.said)


def test_numbers_without_a_unit_are_those_of_the_program(table):
    weather = read_weather(table("wind_speed,wind_from,moisture", "7,200,0.1", "# a note", "", "3,20,0.05"))
    assert [spell.steps[0] for spell in weather.spells] == [Step(7, 200, 0.1), Step(3, 20, 0.05)]
    assert [spell.weight for spell in weather.spells] == [1, 1]
    assert not weather.timed


def test_options_name_columns_and_units(table):
    path = table("FF,DD,TMP,wind_from", "20,1.5707963,31,7")
    weather = read_weather(
        path,
        columns={"wind_speed": "FF", "wind_from": "DD"},
        units={"wind_speed": "kn", "wind_from": "rad"},
        ignore=["TMP", "wind_from"],
    )
    (step,) = weather.spells[0].steps
    assert step.wind_speed == pytest.approx(20 * 1852 / 3600)
    assert step.wind_from_direction == pytest.approx(90)
    with pytest.raises(ParameterError, match="no column GG"):
        read_weather(path, columns={"wind_speed": "GG"})
    with pytest.raises(ParameterError, match="names speed"):
        read_weather(path, columns={"speed": "FF"})


def test_a_decimal_comma_where_semicolons_part_the_cells(table):
    weather = read_weather(table("wind_speed;wind_from", "3,5;180"))
    assert weather.spells[0].steps[0] == Step(3.5, 180)


def test_a_frame_is_a_table(table):
    path = table("scenario,time_h,wind_speed,wind_from,weight", "a,0,3,10,2", "a,1,4,20,2", "b,0,5,30,1")
    assert read_weather(pd.read_csv(path)).spells == read_weather(path).spells
    assert read_weather(read_weather(path)) is not None


@pytest.mark.parametrize(
    ("lines", "said"),
    [
        (["wind_speed,wind_from,RH", "3,4,50"], "'RH' is not known"),
        (["wind_speed_hpa,wind_from", "3,4"], "'wind_speed_hpa' is not known"),
        (["wind_speed [hPa],wind_from", "3,4"], "no unit of a wind speed"),
        (["wind_from,weight", "3,4"], "no column for wind_speed"),
        (["wind_speed,wind_from,duration", "3,4,8"], "does not tell its unit"),
        (["wind_speed,WS,wind_from", "3,4,5"], "both hold wind_speed"),
        (["wind_speed,wind_from", "3,x"], "line 2: wind_from is 'x'"),
        (["wind_speed,wind_from", "3,"], "line 2: wind_from is ''"),
        (["wind_speed,wind_from", "3,4,5"], "line 2: 3 cells, expected 2"),
        (["wind_speed,wind_from", "99,4", "3,400"], "0 to 60; weather 2: the wind comes from 400"),
        (["wind_speed,wind_from,moisture", "3,4,8"], "moisture_pct"),
        (["wind_speed,wind_from,weight", "3,4,-1"], "weight -1"),
        (["wind_speed,wind_from,weight", "3,4,0"], "no weather has a weight"),
        (["wind_speed,wind_from,duration_h", "3,4,0"], "duration of 0 s"),
        (["wind_speed,wind_from"], "is empty"),
        (["Instance,wind_speed,wind_from", "a,3,4", "a,5,6"], "follow each other.*--weather-step 1h"),
        (["datetime,WS,WD", "23/03/25 14:00,3,4", "23/03/25 14:00,5,6"], "carry one time"),
        (["datetime,WS,WD", "02/03/25 14:00,3,4", "03/04/25 14:00,5,6"], "more than one way.*2025-03-23 14:00"),
        (["time,WS,WD", "noon,3,4", "later,5,6"], "cannot be read"),
        (["time_h,WS,WD", "1,3,4", "0,5,6"], "do not rise"),
        (["scenario,time_h,WS,WD,weight", "a,0,3,4,1", "a,1,5,6,2"], "different numbers for weight"),
    ],
)
def test_what_cannot_be_is_said(table, lines, said):
    with pytest.raises(InputError, match=said):
        read_weather(table(*lines))


def test_a_file_that_is_not_there(tmp_path):
    with pytest.raises(InputError, match=r"does not exist.*rose:"):
        read_weather(tmp_path / "none.csv")


def test_hours_follow_each_other(table):
    hours = ["2025-08-01 13:00,10,200", "2025-08-01 14:00,20,210", "2025-08-01 16:30,5,270"]
    weather = read_weather(table("datetime,wind_speed,wind_from", *hours))
    (spell,) = weather.spells
    assert spell.starts == (0, 3600, 12_600)
    assert [step.wind_speed for step in spell.steps] == [10, 20, 5]
    assert spell.span == 12_600 + 9_000
    assert not weather.steady
    same = ["01/08/25 13:00,10,200", "01/08/25 14:00,20,210", "01/08/25 16:30,5,270"]  # in any order of day and month
    assert read_weather(table("datetime,wind_speed,wind_from", *same)).spells == weather.spells
    stepped = read_weather(table("wind_speed,wind_from", "10,200", "20,210"), step="30min")
    assert stepped.spells[0].starts == (0, 1800)
    assert stepped.spells[0].span == 3600
    with pytest.raises(ParameterError, match="step"):
        read_weather(table("wind_speed,wind_from", "10,200"), step="soon")


def test_scenarios_are_an_ensemble_of_sequences(table):
    lines = ["b,0,1,10,3,8", "a,0,2,20,1,4", "b,1,3,30,3,8", "a,2,4,40,1,4", "a,5,5,50,1,4"]
    weather = read_weather(table("scenario,time_h,wind_speed,wind_from,weight,duration_h", *lines))
    assert [spell.name for spell in weather.spells] == ["b", "a"]
    assert [spell.starts for spell in weather.spells] == [(0, 3600), (0, 7200, 18_000)]
    assert [spell.weight for spell in weather.spells] == [3, 1]
    assert [step.wind_speed for step in weather.spells[1].steps] == [2, 4, 5]
    assert weather.spells[1].duration == 14_400


def test_the_scars_of_belgium(shared_data):
    path = shared_data / "maasmechelen_2025/weather.csv"
    weather = read_weather(path, step="1h")
    assert len(weather.spells[0].steps) == 8
    assert weather.spells[0].steps[0].wind_speed == pytest.approx(18.24 / 3.6)
    with pytest.raises(InputError, match="carry one time"):
        read_weather(path)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("rose:NW=5x0.4,N=8x0.2", [(5, 315, 0.4), (8, 0, 0.2)]),
        ("rose: nw = 5 x 0.4 , 22.5=8", [(5, 315, 0.4), (8, 22.5, 1)]),
        ("rose:WSW=36km/hx40%", [(10, 247.5, 0.4)]),
        ("rose:S=10kn*2,S=0x1", [(10 * 1852 / 3600, 180, 2), (0, 180, 1)]),
    ],
)
def test_wind_roses(text, expected):
    found = [(s.steps[0].wind_speed, s.steps[0].wind_from_direction, s.weight) for s in read_weather(text).spells]
    assert found == [pytest.approx(petal) for petal in expected]


def test_a_rose_tells_moisture_and_duration():
    spells = read_weather("rose:E=5,W=6;moisture=6%;duration=90min").spells
    assert {(s.steps[0].moisture, s.duration) for s in spells} == {(0.06, 5400.0)}


@pytest.mark.parametrize("text", ["", "NX=5", "N", "N=", "N=5hPa", "N=5x", "N=5x1x2", "N=5;rain=3", "N=5;moisture=wet"])
def test_roses_that_cannot_be_read(text):
    with pytest.raises(ParameterError):
        read_weather(f"rose:{text}")


ENSEMBLE = Weather(
    (
        Spell((Step(2.0, 0.0),), weight=1.0, duration=3600.0),
        Spell((Step(9.0, 90.0),), weight=0.0, duration=60.0),
        Spell((Step(5.0, 225.0),), weight=3.0, duration=7200.0),
    )
)


def test_runs_draw_by_weight():
    drawn = ENSEMBLE.of_runs(seed=3, n_runs=8000)
    counts = np.bincount(drawn, minlength=3)
    assert counts[1] == 0
    assert abs(counts[2] - 6000) < 4 * math.sqrt(8000 * 0.75 * 0.25)
    np.testing.assert_array_equal(ENSEMBLE.durations(seed=3, n_runs=50), np.array([3600, 60, 7200])[drawn[:50]])


def test_a_run_has_its_weather_however_runs_are_split():
    whole = ENSEMBLE.of_runs(seed=3, n_runs=300)
    np.testing.assert_array_equal(ENSEMBLE.of_runs(seed=3, n_runs=100, first_run=200), whole[200:])
    assert ENSEMBLE.of_run(3, 17) == ENSEMBLE.spells[whole[17]]
    assert (ENSEMBLE.of_runs(seed=4, n_runs=300) != whole).any()
    seen = {}
    for spell, runs in ENSEMBLE.groups(seed=3, n_runs=100, first_run=200):
        assert (np.diff(runs) > 0).all()
        seen |= dict.fromkeys(runs.tolist(), spell)
    assert [seen[run] for run in range(200, 300)] == whole[200:].tolist()


def test_weights_are_relative():
    heavy = Weather(tuple(Spell(s.steps, weight=s.weight * 128) for s in ENSEMBLE.spells))
    np.testing.assert_array_equal(heavy.of_runs(seed=0, n_runs=500), ENSEMBLE.of_runs(seed=0, n_runs=500))
    assert ENSEMBLE.shares.sum() == pytest.approx(1)
    assert ENSEMBLE.describe()["mean_wind_speed"] == pytest.approx(0.25 * 2 + 0.75 * 5)


def test_a_duration_that_is_not_told_is_refused():
    with pytest.raises(ParameterError, match="duration_h"):
        Weather((Spell((Step(2.0, 0.0),)),)).durations(seed=0, n_runs=3)


def test_every_weather_has_its_network(make_landscape):
    landscape = make_landscape(seed=2)
    networks = weather_networks(landscape, "rose:NW=5x0.4,N=8x0.2;moisture=6%", rate_scale=2.0)
    assert len(networks) == 2
    for index, (speed, wind_from) in enumerate([(5, 315), (8, 0)]):
        expected = spread_network(
            landscape, clock=True, wind_speed=speed, wind_from_direction=wind_from, moisture=0.06, rate_scale=2.0
        )
        found = networks[index]
        np.testing.assert_array_equal(found.network.travel_time, expected.travel_time)
        np.testing.assert_array_equal(found.network.probability, expected.probability)
        assert found.starts.tolist() == [0]
        assert len(found.times) == 1
        assert found.times[0] is found.network.travel_time
    assert networks[0].network.probability is networks[1].network.probability  # wind is in the times alone
    timeless = weather_networks(landscape, "rose:NW=5x0.4", clock=False)
    assert timeless[0].times == ()
    np.testing.assert_array_equal(
        timeless[0].network.probability,
        spread_network(landscape, wind_speed=5, wind_from_direction=315).probability,
    )


def test_networks_are_made_when_asked_for_and_kept(make_landscape, monkeypatch):
    import firebreak_gis.spread as spread

    built = []
    real = spread.spread_network
    monkeypatch.setattr(spread, "spread_network", lambda *a, **k: built.append(k["wind_speed"]) or real(*a, **k))
    networks = weather_networks(make_landscape(), "rose:N=1,N=2,N=1,N=3", keep=2)
    assert built == []
    assert networks[0] is networks[2]
    assert built == [1]
    networks[1]
    networks[0]
    assert built == [1, 2]
    networks[3]  # the one used longest ago is dropped
    networks[0]
    networks[1]
    assert built == [1, 2, 3, 2]


def test_changing_weather_is_a_stack_of_times(make_landscape):
    landscape = make_landscape(seed=2)
    steps = (Step(2.0, 300.0, 0.05), Step(9.0, 30.0, 0.4), Step(7.0, 100.0, 0.05))
    spell = Spell(steps, (0, 3600, 10_800), span=14_400.0)
    network, starts, times = weather_networks(landscape, Weather((spell,)))[0]
    alone = [
        spread_network(landscape, clock=True, wind_speed=s.wind_speed, wind_from_direction=d, moisture=m)
        for s, d, m in ((s, s.wind_from_direction, s.moisture) for s in steps)
    ]
    assert starts.tolist() == [0, 3600, 10_800]
    assert starts.dtype == np.uint64
    for got, expected in zip(times, alone, strict=True):
        np.testing.assert_array_equal(got, expected.travel_time)
    assert (times[1] == NEVER).all()  # nothing burns at 40 %
    np.testing.assert_array_equal(network.travel_time, np.minimum(times[0], times[2]))  # the least
    np.testing.assert_allclose(network.probability, alone[0].probability / 2, rtol=1e-6)  # for half of the time
    assert network.provenance == {"left_out": "wind and slope"}  # and no wind, since there are several
    with pytest.raises(ParameterError, match="needs fires with a clock"):
        weather_networks(landscape, Weather((spell,)), clock=False)


def test_steps_that_are_alike_are_steady_weather(make_landscape):
    landscape = make_landscape(seed=2)
    step = Step(6.0, 300.0, 0.05)
    changing = weather_networks(landscape, Weather((Spell((step,) * 3, (0, 60, 600)),)))[0]
    steady = weather_networks(landscape, Weather((Spell((step,)),)))[0]
    np.testing.assert_array_equal(changing.network.probability, steady.network.probability)
    np.testing.assert_array_equal(changing.network.travel_time, steady.network.travel_time)
    np.testing.assert_array_equal(changing.network.heat, steady.network.heat)


def test_what_a_model_cannot_follow_is_refused(make_landscape):
    landscape = make_landscape()
    with pytest.raises(ParameterError, match="knows no clock, wind_from_direction, wind_speed"):
        weather_networks(landscape, "rose:N=5", model="raster", path="x.tif")
    with pytest.raises(ParameterError, match="wind_speed is told by the weather and given besides"):
        weather_networks(landscape, "rose:N=5", wind_speed=3)
    with pytest.raises(ParameterError, match="moisture is told"):
        weather_networks(landscape, "rose:N=5;moisture=5%", moisture=0.1)
    kept = fb.weather_networks(landscape, fb.read_weather("rose:N=5"), moisture=0.1)[0].network
    np.testing.assert_array_equal(
        kept.travel_time, spread_network(landscape, clock=True, wind_speed=5, moisture=0.1).travel_time
    )


def test_what_is_asked_is_what_is_read(make_landscape, table):
    landscape = make_landscape(seed=2)
    path = table("FF,wind_from,rain", "36,270,1", "18,90,0")
    asked = WeatherRequest(
        str(path), weather_columns={"wind_speed": "FF"}, weather_units={"wind_speed": "km/h"}, weather_ignore="rain"
    )
    weather = asked.read()
    assert asked.sources == (str(path),)
    request = SpreadRequest(wind_speed=0.0, wind_from=0.0, moisture=0.07, clock=True, model_params={"p0": 0.5})
    made = request.networks(landscape, weather)
    expected = spread_network(landscape, clock=True, wind_speed=10, wind_from_direction=270, moisture=0.07, p0=0.5)
    np.testing.assert_array_equal(made[0].network.travel_time, expected.travel_time)
    np.testing.assert_array_equal(made[0].network.probability, expected.probability)
    with pytest.raises(ParameterError, match="leave --wind-speed out"):
        SpreadRequest(wind_speed=3.0).networks(landscape, weather)
    with pytest.raises(ParameterError, match="leave --moisture out"):
        SpreadRequest(moisture=0.1).networks(landscape, read_weather("rose:N=5;moisture=5%"))
    assert WeatherRequest().read() is None
    with pytest.raises(ParameterError, match="--weather FILE"):
        WeatherRequest(weather_step="1h").read()


def test_a_step_that_comes_again_is_built_once(make_landscape):
    landscape = make_landscape(seed=2)
    built = []

    def build(step):
        built.append(step)
        return spread_network(landscape, clock=True, wind_speed=step.wind_speed)

    one, other = Step(2.0, 0.0), Step(7.0, 0.0)
    spells = (Spell((one, other, one), (0, 60, 120)), Spell((one, one, other), (0, 60, 120)))
    networks = WeatherNetworks(Weather(spells), build)
    first, second = networks[0].times, networks[1].times
    assert first[0] is first[2]
    assert built == [one, other] * 2
    for k, step in enumerate(spells[1].steps):
        expected = spread_network(landscape, clock=True, wind_speed=step.wind_speed).travel_time
        np.testing.assert_array_equal(second[k], expected)
