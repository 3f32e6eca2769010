"""Figures: drawn from any result, saved whole, the same bytes each time."""

from __future__ import annotations

import io

import matplotlib as mpl
import numpy as np
import pandas as pd
import pytest
from matplotlib.image import imread

from firebreak_gis import plan
from firebreak_gis.errors import OutputError
from firebreak_gis.evaluation.curves import summarise
from firebreak_gis.evaluation.paper.landscape import grey_levels
from firebreak_gis.grid import Grid
from firebreak_gis.report import figures, paper
from firebreak_gis.report.comparison import comparison_figure
from firebreak_gis.report.curve import curve_figure
from firebreak_gis.report.overview import overview_figure
from firebreak_gis.schema import VARIABLES


@pytest.fixture(scope="module")
def landscape(make_landscape):
    return make_landscape((16, 27), seed=5, relief=4.0)


@pytest.fixture(scope="module")
def result(landscape):
    return plan(landscape, budget=0.14, method="flammability", n_runs=20, seed=1)


def shares(n_methods, n_budgets, n_runs=12):
    random = np.random.default_rng(0)
    budgets = np.linspace(0, 0.4, n_budgets)
    names = ["random", *(f"method {k}" for k in range(n_methods - 1))]
    burnt = {n: random.random((n_runs, n_budgets)) * (1 - budgets) * (1 - 0.3 * (n != "random")) for n in names}
    return summarise(burnt, fuel=1, budgets=budgets)


def picture(figure):
    stream = io.BytesIO()
    figure.savefig(stream, format="png", dpi=60)
    stream.seek(0)
    return imread(stream)


@pytest.mark.parametrize(("n_methods", "n_budgets"), [(1, 5), (2, 1), (3, 9), (12, 41)])
def test_curves_of_any_number_of_rankings(n_methods, n_budgets):
    result = shares(n_methods, n_budgets)
    figure = curve_figure(result, title="A title")
    (axes,) = figure.axes
    lines = {line.get_label(): line for line in axes.get_lines()}
    assert set(result["ranking"].to_numpy()) <= set(lines)
    for name in result["ranking"].to_numpy():
        np.testing.assert_array_equal(lines[name].get_ydata(), result["mean"].sel(ranking=name))
    colours = [lines[name].get_color() for name in result["ranking"].to_numpy()][:8]
    assert len(set(colours)) == len(colours)
    low, high = axes.get_ylim()
    assert low == 0
    assert high >= float(result["mean"].max())
    assert picture(figure).std() > 0.01


def overview(landscape, result):
    return overview_figure(
        landscape, result.breaks, result.before, result.after, result.evaluation, title="A plan", budget=0.14
    )


def test_overview_shows_terrain_fuel_and_both_burn_maps(landscape, result):
    figure = overview(landscape, result)
    titles = [axes.get_title(loc="left") for axes in figure.axes[:6]]
    for word in ("Terrain", "type", "density", "without", "with the breaks", "Burnt share"):
        assert any(word in title for title in titles), word
    before, after = (
        figure.axes[3].images[-1],
        next(image for image in figure.axes[4].images if image.get_cmap().name == "burn_frequency"),
    )
    assert before.get_clim() == after.get_clim()
    shown = np.ma.masked_invalid(before.get_array()).filled(0)
    np.testing.assert_array_equal(shown, np.nan_to_num(result.before["burn_frequency"].to_numpy()))
    colour = mpl.colors.to_rgb(figures.BREAK_COLOUR)
    layer = figure.axes[4].images[-1].get_array()
    drawn = (layer[..., 3] > 0) & (np.abs(layer[..., :3] - colour).max(axis=-1) < 0.01)
    assert (drawn == (result.breaks.to_numpy() > 0)).all()


def test_overview_of_a_landscape_without_breaks_fires_or_relief(make_landscape):
    flat = make_landscape((5, 40), holes=0.0, elevation=0.0)
    nothing = plan(flat, budget=0.0, method="random", model_params={"p0": 0.0}, n_runs=3)
    assert picture(overview(flat, nothing)).std() > 0.01


@pytest.mark.parametrize("suffix", ["png", "svg", "pdf"])
def test_equal_figures_are_equal_files(tmp_path, suffix):
    for name in ("one", "two"):
        figures.save(curve_figure(shares(3, 9)), tmp_path / f"{name}.{suffix}")
    one, two = ((tmp_path / f"{name}.{suffix}").read_bytes() for name in ("one", "two"))
    assert one == two
    assert b"Date" not in one
    assert len(one) > 3000


def test_saving_is_whole_or_not_at_all(tmp_path, monkeypatch):
    figure = curve_figure(shares(2, 5))
    figures.save(figure, tmp_path / "a.png")
    old = (tmp_path / "a.png").read_bytes()
    with pytest.raises(OutputError, match="exists"):
        figures.save(figure, tmp_path / "a.png")
    with pytest.raises(OutputError, match=r"\.bmp"):
        figures.save(figure, tmp_path / "a.bmp")
    monkeypatch.setattr(type(figure), "draw", lambda *_, **__: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        figures.save(figure, tmp_path / "a.png", overwrite=True)
    assert (tmp_path / "a.png").read_bytes() == old
    assert [p.name for p in tmp_path.iterdir()] == ["a.png"]


def test_a_picture_is_what_matplotlib_saves(tmp_path):
    """Drawn once, in place of twice."""
    figures.save(curve_figure(shares(3, 9)), tmp_path / "a.png", dpi=90)
    with figures._own_settings():
        curve_figure(shares(3, 9)).savefig(tmp_path / "b.png", dpi=90, metadata={"Software": None})
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()


def test_maps_are_in_kilometres_and_north_up(landscape):
    figure = figures.new_figure(4, 3)
    axes = figure.subplots()
    grid = Grid.of(landscape["burnable"])
    figures.map_axes(axes, grid, "A map")
    assert axes.get_xlim() == (0.0, 27 * 0.02)
    assert axes.get_ylim() == (0.0, 16 * 0.02)
    values = np.zeros(grid.shape)
    values[0, -1] = 1  # the north-eastern corner
    figures.show(axes, values, grid, cmap="gray")
    pixels = picture(figure)[..., :3].mean(axis=-1)
    inner = axes.get_window_extent()
    scale = pixels.shape[0] / figure.bbox.height
    row = int(pixels.shape[0] - (inner.y1 * scale - 2))
    assert pixels[row, int(inner.x1 * scale) - 2] > 0.9
    assert pixels[int(pixels.shape[0] - inner.y0 * scale) - 3, int(inner.x0 * scale) + 3] < 0.1


@pytest.mark.parametrize("name", [n for n, v in VARIABLES.items() if v.colours and not v.classes])
def test_ramps_end_in_the_colours_of_the_schema(name):
    ramp = figures.ramp(name)
    colours = [c for _, c in sorted(VARIABLES[name].colours.items())]
    assert mpl.colors.to_hex(ramp(0.0)) == colours[0][:7]
    assert mpl.colors.to_hex(ramp(1.0)) == colours[-1][:7]
    assert ramp(np.ma.masked_invalid([np.nan]))[0, 3] == 0


def test_hillshade_has_its_light_in_the_north_west():
    column = np.abs(np.arange(21.0) - 10)
    ridge = np.tile(30.0 - 3 * column, (9, 1))  # a ridge from north to south
    shade = figures.hillshade(ridge, 10.0)
    assert shade[4, 5] > shade[4, 15]
    gap = ridge.copy()
    gap[2, 3] = np.nan
    assert np.isfinite(figures.hillshade(gap, 10.0)).all()
    assert np.isfinite(figures.hillshade(np.full((4, 5), np.nan), 10.0)).all()


def test_figures_of_the_paper(landscape, result):
    grey = grey_levels(result.before["burn_frequency"].to_numpy(), 20)
    figure = paper.figure_4(landscape, result.before, grey, wind="wind 8 m/s from 315 degrees")
    assert "315" in figure.axes[0].get_title(loc="left")
    stored = np.ma.masked_invalid(figure.axes[1].images[0].get_array()).filled(0)
    np.testing.assert_array_equal(stored, grey)
    six = paper.figure_6(landscape, {("a", 0.14): result.breaks, ("b", 0.19): result.breaks})
    assert [axes.get_title(loc="left") for axes in six.axes] == [
        "Breaks by a, $d_f$ = 0.14",
        "Breaks by b, $d_f$ = 0.19",
    ]
    for drawn in (paper.figure_3(landscape), figure, six):
        assert picture(drawn).std() > 0.01


def test_comparison_has_a_panel_for_every_leak():
    rows = [
        {
            "method": method,
            "d_f": d_f,
            "residual": residual,
            "ha_cut": 40.0 * d_f,
            "R": 0.5 - d_f + residual,
            "burnt_ha": 40 * (0.5 - d_f + residual),
            "burnt_ha_low": 8.0,
            "burnt_ha_high": 20.0,
            "leverage": (0.9 - 0.5 + d_f - residual) / d_f,
        }
        for method in ("dissection", "compartments:width=2", "random")
        for d_f in (0.1, 0.2)
        for residual in (0.0, 0.1)
    ]
    figure = comparison_figure(pd.DataFrame(rows), n_burnable=1000, cell_area_ha=0.04)
    assert [axes.get_title(loc="left") for axes in figure.axes] == [
        "breaks without a leak",
        "breaks that leak: treated cells keep 10 %",
    ]
    for axes, residual in zip(figure.axes, (0.0, 0.1), strict=True):
        *curves, untreated = axes.get_lines()
        assert [line.get_label() for line in curves] == ["dissection", "compartments:width=2", "random"]
        assert [line.get_linestyle() for line in curves] == ["-", "--", ":"]
        np.testing.assert_allclose(curves[0].get_ydata(), [0.4 + residual, 0.3 + residual])
        np.testing.assert_allclose(untreated.get_ydata(), 0.9)
    assert picture(figure).std() > 0.01
