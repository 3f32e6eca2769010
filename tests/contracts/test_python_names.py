"""Whatever the command line does, Python does under a name of `firebreak_gis`, and what that returns shows itself."""

from __future__ import annotations

import dataclasses
import re

import geopandas as gpd
import numpy as np
import pytest

import firebreak_gis as fb
from firebreak_gis.cli import firebreak
from firebreak_gis.schema import Shown


@pytest.fixture(scope="module")
def made(make_landscape):
    """One small thing of every kind that a function returns, by the name of its type."""
    landscape = make_landscape((24, 31), seed=3, holes=0.05)
    plan = fb.plan(landscape, budget="10%", n_runs=6, method="dissection")
    weather = fb.read_weather("rose:NW=5x0.4,N=8x0.2")
    existing = fb.existing_breaks(plan.breaks, plan.network.grid)

    def burnt(cut, progress):
        return fb.simulate(plan.network, breaks=cut, n_runs=6)["fire_size"].to_numpy()

    found = [
        plan,
        existing,
        fb.assess(plan.network, existing, burnt, placements=1),
        fb.delineate(plan.network, np.full(plan.network.shape, 0.5), size_ha=60 * plan.network.grid.cell_area_ha),
        plan.network,
        plan.segments,
        plan.stakes,
        plan.judged.fires.ignitions,
        weather,
        fb.weather_networks(landscape, weather),
        fb.ignition_places(plan.network),
        fb.landscape_experiment(landscape, n_runs=2),
    ]
    return {type(thing).__name__: thing for thing in found}


def test_every_command_is_a_function():
    commands = set(firebreak.list_commands(None))
    assert set(fb.COMMANDS) <= commands
    for command in commands:
        name = fb.COMMANDS.get(command, command)
        if name is None:  # looks after the installation
            assert command in {"describe", "doctor", "warmup"}
        else:
            assert name in fb.__all__, f"firebreak {command} has no name in Python"
            assert callable(getattr(fb, name))


def test_the_name_of_a_command_leads_to_its_function():
    with pytest.raises(AttributeError, match=r"firebreak burn is fb\.simulate"):
        _ = fb.burn
    with pytest.raises(AttributeError, match=r"no attribute 'nothing'$"):
        _ = fb.nothing


def test_what_is_returned_prints_as_one_line_and_as_a_table(made):
    for name, thing in made.items():
        text, page = repr(thing), thing._repr_html_()
        assert text.startswith(f"<{name}: "), text
        assert "\n" not in text
        assert len(text) < 300, text
        assert page.startswith(f"<div><strong>{name}</strong><table>"), name
        assert page.count("<tr") >= len(thing.facts())
        for key, value in thing.facts().items():
            assert f"{key} {value}" in text
            assert f"<th>{key}</th>" in page


def test_no_dataclass_with_arrays_prints_them(made):
    """Every kind of result is in the fixture, or prints shortly for another reason."""
    kinds = {kind.__name__ for kind in _all(Shown)}
    assert kinds - {"Validation", "Calibration"} <= set(made)
    for kind in _all(Shown):
        if dataclasses.is_dataclass(kind):
            assert kind.__repr__ is Shown.__repr__, kind


def _all(kind):
    return {kid for sub in kind.__subclasses__() for kid in (sub, *_all(sub))}


def test_the_facts_are_those_of_the_thing(made):
    plan, segments = made["Plan"], made["Segments"]
    assert f"{plan.summary['ha_cut']:,.4g} ha (" in plan.facts()["cut"]
    assert plan.facts()["mean fire"].startswith(f"{plan.summary['fire_ha_without_breaks']:,.4g} ha without")
    assert segments.facts()["segments"] == len(segments.lines)
    assert plan.headline[0].split(" ")[0] in plan._repr_html_()
    assert made["SpreadNetwork"].facts()["fuel"] == f"{int(made['SpreadNetwork'].burnable.sum()):,} cells"
    assert made["Weather"].facts()["weathers"] == 2
    found = made["Assessment"]
    assert f"{found.burnt_bare_ha:,.4g} ha without" in found.facts()["mean fire"]
    assert made["Existing"].facts()["breaks"] == len(found.breaks)
    pods, borders = made["Delineation"].pods, made["Delineation"].borders
    assert made["Delineation"].facts()["compartments"] == len(pods) > 1
    assert made["Delineation"].suitability == pytest.approx(
        np.average(borders["suitability"], weights=borders["length_m"])
    )


def test_tables_carry_their_coordinate_system_as_epsg(made):
    plan = made["Plan"]
    for table in (plan.segments.lines, plan.segments.polygons, plan.compartments, plan.polygons):
        assert isinstance(table, gpd.GeoDataFrame)
        assert table.crs.to_string() == "EPSG:32635"
    for raster in (plan.breaks, plan.priority, plan.before["burn_frequency"], plan.landscape["elevation"]):
        assert re.search(r'ID\["EPSG",32635\]\]$', raster["spatial_ref"].attrs["crs_wkt"])


def test_everything_draws(made):
    plan = made["Plan"]
    table = fb.compare(plan.network, ["random", "degree"], budgets=["5%", "10%"], n_runs=3)
    for thing, title in (
        (plan, "Terrain (axes in km)"),
        (plan.segments, f"Segments, {len(plan.segments.lines)} in"),
        (plan.compartments, f"{len(plan.compartments)} outlines"),
        (plan.network, "Mean probability"),
        (plan.breaks, ""),
        (plan.before, "Share of the fires"),
        (plan.evaluation, ""),
        (made["Existing"], f"{len(made['Existing'])} existing breaks"),
        (made["Assessment"], f"{len(made['Assessment'].breaks)} breaks"),
        (made["Delineation"], f"{len(made['Delineation'].pods)} compartments"),
        (table, "breaks without a leak"),
    ):
        assert fb.plot(thing).axes[0].get_title(loc="left").startswith(title)
    with pytest.raises(fb.FirebreakError, match="expected a plan, segments"):
        fb.plot(np.zeros(3))


def test_segments_are_drawn_where_they_are(made):
    """The picture reaches as far as the outlines, in kilometres."""
    segments = made["Segments"]
    axes = fb.plot(segments).axes[0]
    left, bottom, right, top = segments.polygons.total_bounds
    found = axes.dataLim
    assert (found.x0, found.y0) == pytest.approx((0.0, 0.0), abs=1e-9)
    assert (found.x1, found.y1) == pytest.approx(((right - left) / 1000, (top - bottom) / 1000))


def test_maps_to_explore(made, monkeypatch):
    plan = made["Plan"]
    page = plan.explore().get_root().render()
    for layer in ("Burn frequency without breaks", "Burn frequency with the breaks", "Compartments", "Segments"):
        assert layer in page
    for thing in (plan.network, plan.breaks, plan.segments, plan.compartments, plan.before):
        assert "L.map(" in fb.explore(thing).get_root().render()
    for kind, columns in (
        ("Existing", ()),
        ("Assessment", ("worth beside all others [ha]",)),
        ("Delineation", ("suitability of the border",)),
    ):
        page = fb.explore(made[kind]).get_root().render()
        assert all(column in page for column in columns), kind
    with pytest.raises(fb.FirebreakError, match="no coordinate system"):
        fb.explore(fb.spread_network(fb.forest((6, 7)), model="artificial"))
    monkeypatch.setitem(__import__("sys").modules, "folium", None)
    with pytest.raises(fb.FirebreakError, match=r"pip install .firebreak_gis\[maps\]"):
        fb.explore(plan)


def test_a_raster_lies_where_it_is_on_the_web_map():
    """A corner cell of a raster, warped as the map shows it, lies where pyproj puts it."""
    import pyproj

    from firebreak_gis.grid import Grid
    from firebreak_gis.report.exploring import _on_the_web

    landscape = fb.read_landscape(**fb.sample_layers(), resolution=300.0)
    grid = Grid.of(landscape["burnable"])
    values = np.zeros(grid.shape)
    values[3, 5] = 1.0
    warped, ((south, west), (north, east)) = _on_the_web(values, grid)
    row, col = (float(place.mean()) for place in np.nonzero(warped == 1.0))
    web = pyproj.Transformer.from_crs("EPSG:4326", "EPSG:3857", always_xy=True)
    (x0, y0), (x1, y1) = web.transform(west, south), web.transform(east, north)
    x = x0 + (col + 0.5) / warped.shape[1] * (x1 - x0)
    y = y1 - (row + 0.5) / warped.shape[0] * (y1 - y0)
    back = pyproj.Transformer.from_crs("EPSG:3857", grid.crs, always_xy=True)
    east_m, north_m = back.transform(x, y)
    assert (east_m, north_m) == pytest.approx((grid.x[5], grid.y[3]), abs=200.0)
