"""The report page as text: complete, escaped, without an address that leaves it; tests/browser opens it."""

from __future__ import annotations

import base64
import io
import json
import re
from html.parser import HTMLParser

import numpy as np
import pandas as pd
import pytest
from PIL import Image

from firebreak_gis.report.page import pictures, render
from firebreak_gis.report.page.comparison import comparison_page
from firebreak_gis.report.page.content import Curve, Outlines, Page, Picture, Row
from firebreak_gis.report.page.plan import plan_page

NASTY = "</script><script>alert(1)</script>\"'&<img src=x onerror=alert(1)>\u2028"


class Reader(HTMLParser):
    """Elements, attributes and texts of a page; fails on tags that are not closed in order."""

    VOID = frozenset({"meta", "link", "input", "br", "img", "line", "polyline"})

    def __init__(self) -> None:
        super().__init__()
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.open: list[str] = []
        self.texts: list[str] = []

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.texts.append(data)


def read(text: str) -> Reader:
    reader = Reader()
    reader.feed(text)
    reader.close()
    assert reader.open == []
    return reader


def nasty_page() -> Page:
    square = {"type": "Polygon", "coordinates": [[[0, 0], [10, 0], [10, 10], [0, 0]]]}
    feature = {"type": "Feature", "geometry": square, "properties": {"number": 0, "card": {NASTY: NASTY}}}
    return Page(
        title=NASTY,
        headline=(NASTY,),
        assumptions=(NASTY,),
        warnings=(NASTY,),
        figures=((NASTY, NASTY, NASTY),),
        size=(100.0, 80.0),
        origin=(0.0, 0.0, NASTY),
        pictures=(Picture("before", NASTY, pictures.png(np.zeros((2, 3, 4), np.uint8)), (("#fff", NASTY),), True),),
        outlines=(Outlines("segments", NASTY, [feature], shown=True),),
        curve=Curve(NASTY, NASTY, NASTY, [(NASTY, [0.0, 1.0], [0.5, 0.25])], 0.5),
        segments=(Row({NASTY: NASTY, "ha": 1.5}, {"ha": 1}, frozenset({"ha"}), 0),),
        comparison=(Row({NASTY: NASTY}),),
        files=((NASTY, NASTY),),
        provenance=((NASTY, NASTY),),
    )


def test_texts_are_escaped_wherever_they_stand():
    page = read(render(nasty_page()))
    assert [name for name, _ in page.tags if name == "script"] == ["script"] * 3
    assert not [name for name, _ in page.tags if name == "img"]
    assert not [key for _, attributes in page.tags for key in attributes if key.startswith("on")]
    assert sum(NASTY.replace("\u2028", "") in text.replace("\u2028", "") for text in page.texts) > 10
    data = next(t for t in page.texts if t.startswith('{"size"'))
    assert json.loads(data)["outlines"][0]["features"][0]["properties"]["card"] == {NASTY: NASTY}


def test_nothing_is_loaded_from_elsewhere():
    page = read(render(nasty_page()))
    policy = next(a["content"] for _, a in page.tags if a.get("http-equiv") == "Content-Security-Policy")
    assert policy.startswith("default-src 'none'")
    addresses = [a[key] for _, a in page.tags for key in ("href", "src", "action", "data") if a.get(key)]
    assert addresses
    assert all(address.startswith(("#", "./", "data:")) for address in addresses)
    styles = " ".join(text for text in page.texts if ".leaflet" in text)
    assert "url(" not in re.sub(r"url\(#[^)]*\)", "", styles)
    assert "@import" not in styles


def test_the_same_page_gives_the_same_text():
    assert render(nasty_page()) == render(nasty_page())


def decoded(address: str) -> np.ndarray:
    return np.asarray(Image.open(io.BytesIO(base64.b64decode(address.partition(",")[2]))).convert("RGBA"))


@pytest.mark.parametrize("colours", [3, 300])
def test_pictures_keep_every_colour(colours):
    random = np.random.default_rng(colours)
    palette = random.integers(0, 256, (colours, 4), dtype=np.uint8)
    image = palette[random.integers(0, colours, (40, 61))]
    np.testing.assert_array_equal(decoded(pictures.png(image)), image)


def test_classes_have_the_colours_of_the_schema_and_no_data_none():
    picture = pictures.of_classes("breaks", np.array([[0, 1], [1, 255]]), key="b", label="b")
    image = decoded(picture.image)
    assert image[0, 1].tolist() == [0x1F, 0x4F, 0xD8, 255]
    assert image[0, 0, 3] == image[1, 1, 3] == 0
    assert picture.legend == (("#1f4fd8", "fire break"),)


def test_large_maps_are_thinned_out():
    values = np.arange(3200 * 4, dtype=float).reshape(3200, 4)
    image = decoded(pictures.of_numbers("burn_frequency", values, key="k", label="l").image)
    assert image.shape[0] == -(-3200 // 3)


def test_numbers_that_are_missing_are_transparent():
    values = np.array([[0.0, np.nan, 1.0]])
    picture = pictures.of_numbers("burn_frequency", values, key="k", label="l", low=0, high=1)
    assert decoded(picture.image)[0, :, 3].tolist() == [255, 0, 255]
    assert [text for _, text in picture.legend] == ["0", "0.2", "0.4", "0.6", "0.8", "1"]


def small_parts():
    import geopandas as gpd
    import shapely
    from affine import Affine

    from firebreak_gis.grid import Grid, parse_crs

    grid = Grid((6, 9), Affine(20, 0, 500_000, 0, -20, 4_000_000), parse_crs("EPSG:32635"))
    breaks = np.zeros(grid.shape, np.uint8)
    breaks[:, 4] = 1
    rows = {"order": [2, 1], "stage": [2, 1], "length_m": [np.nan, 60.0], "area_ha": [0.04, 0.12], "cost": [1.0, 3.0]}
    shapes = [shapely.box(500_080, 3_999_880, 500_100, 3_999_900), shapely.box(500_080, 3_999_900, 500_100, 3_999_960)]
    return {
        "breaks.tif": grid.dataarray(breaks, "breaks"),
        "burn_frequency.tif": grid.dataarray(np.full(grid.shape, 0.4, np.float32), "burn_frequency"),
        "segments.gpkg": gpd.GeoDataFrame(rows, geometry=shapes, crs="EPSG:32635"),
        "evaluation.csv": pd.DataFrame({"method": ["a", "a"], "d_f": [0.0, 0.5], "mean": [0.9, 0.1]}),
    }


def test_a_plan_becomes_a_page():
    account = {"parameters": {"method": "degree", "budget": 5, "budget_unit": "ha"}, "assumptions": ["It is calm."]}
    page = plan_page(small_parts(), account)
    assert page.title == "Fire breaks by degree, 5 ha"
    assert page.size == (180.0, 120.0)
    assert page.origin[:2] == (500_000.0, 3_999_880.0)
    first = page.segments[0]
    assert first.cells["Segment"] == 1
    assert first.feature == 1  # its number on the map, whatever the order of building
    feature = page.outlines[-1].features[first.feature]
    assert feature["properties"]["card"]["Length"] == "60 m"
    assert feature["geometry"]["coordinates"][0][0][0] in (80.0, 100.0)  # metres from the lower left corner
    text = read(render(page)).texts
    assert "It is calm." in text
    assert "0.16" in text  # the total of the areas
    assert page.segments[1].shown("Length [m]") == "\N{EN DASH}"


def test_a_page_shows_the_first_of_very_many_segments(monkeypatch):
    from firebreak_gis.report.page import plan

    monkeypatch.setattr(plan, "MOST", 1)
    page = plan_page(small_parts(), {"parameters": {}, "warnings": ["It is dry."]})
    assert [row.cells["Segment"] for row in page.segments] == [1]
    assert len(page.outlines[-1].features) == 1
    assert page.warnings == ("It is dry.", "this page shows the first 1 of 2 segments; segments.gpkg holds all")
    monkeypatch.setattr(plan, "MOST", 2)
    assert len(plan_page(small_parts(), {"parameters": {}}).segments) == 2


def test_a_page_of_a_comparison_sorts_numbers_as_numbers():
    table = pd.DataFrame({"method": ["b", "a"], "d_f": [0.1, 0.1], "residual": [0.0, 0.0], "R": [0.5, np.nan]})
    page = comparison_page(table, {})
    found = read(render(page)).tags
    keys = [a["data-key"] for name, a in found if name == "td"]
    assert keys == ["b", "0.1", "0.0", "0.5", "a", "0.1", "0.0", ""]


def test_methods_of_a_comparison_as_it_comes_have_colours_of_their_own():
    names = ["lines", "dissection", "compartments", "stripes", "bonacich", "flammability", "random"]
    text = render(Page(title="t", curve=Curve("c", "n", "x", [(name, [0.0, 0.5], [0.5, 0.1]) for name in names])))
    drawn = re.findall(r'class="line line-(\d)"', text)
    assert len(set(drawn)) == len(names)
    for scheme in text.split("@media (prefers-color-scheme: dark)")[:2]:
        told = {number: re.search(rf"--c{number}: (#\w+);", scheme).group(1) for number in drawn}
        assert len(set(told.values())) == len(names)
    for number in drawn:
        assert f".line-{number} {{ stroke: var(--c{number})" in text
        assert f".name-{number} {{ fill: var(--c{number})" in text


@pytest.mark.parametrize(
    ("top", "expected"), [(0.087, 0.1), (0.95, 1.0), (0.031, 0.04), (0.2, 0.2), (1.0, 1.0), (0.0, 1.0)]
)
def test_the_curve_fills_its_height(top, expected):
    page = Page(title="t", curve=Curve("c", "n", "x", [("a", [0.0, 0.5], [top, 0.0])]))
    ticks = [text for text in read(render(page)).texts if text.endswith(" %")][4]
    assert float(ticks.removesuffix(" %")) == pytest.approx(100 * expected)


def _segments_frame(**more):
    import geopandas as gpd
    from shapely.geometry import box

    table = {
        "order": [1, 2, 3, 4],
        "stage": [1, 2, 2, 3],
        "length_m": [100.0, 200.0, 300.0, 400.0],
        "area_ha": [1.0, 2.0, 3.0, 4.0],
        "cost": [10.0, 20.0, 30.0, 40.0],
        "gain_share": [0.4, 0.3, 0.2, 0.1],
        **more,
    }
    shapes = [box(100 * k, 0, 100 * k + 50, 50) for k in range(4)]
    return gpd.GeoDataFrame(table, geometry=shapes, crs="EPSG:32635")


def _group_lines(html):
    found = re.findall(r'<tr class="group"><th scope="rowgroup" colspan="(\d+)">([^<]*)</th>(.*?)</tr>', html)
    return [(words, int(wide), re.findall(r"<td[^>]*>([^<]*)</td>", cells)) for wide, words, cells in found]


def test_segments_are_grouped_by_stage_with_sums():
    from firebreak_gis.report.page import _table
    from firebreak_gis.report.page.plan import _segments

    html = _table("segments", _segments(_segments_frame()))
    lines = _group_lines(html)
    assert [words for words, _, _ in lines] == ["Stage 1", "Stage 2", "Stage 3"]
    assert lines[1][2] == ["500", "5.00", "50", "50.00"]  # length, area, cost, share of what is saved
    assert "Group by stage " in html
    assert html.count("<tbody>") == 3
    foot = html.split("<tfoot>")[1]
    assert re.findall(r"<td[^>]*>([^<]*)</td>", foot) == ["1,000", "10.00", "100", "100.00"]
    columns = len(re.findall(r"<th scope=.col.", html))
    assert all(wide + len(cells) == columns for _, wide, cells in lines)


def test_years_come_before_stages():
    """A stage that is built over two years stands in both; what no year is told for comes last."""
    from firebreak_gis.report.page import _table
    from firebreak_gis.report.page.plan import _segments

    html = _table("segments", _segments(_segments_frame(year=[2.0, 1.0, 2.0, np.nan])))
    assert [words for words, _, _ in _group_lines(html)] == [
        "Year 1, Stage 2",
        "Year 2, Stage 1",
        "Year 2, Stage 2",
        "Stage 3",
    ]
    assert "Group by year and stage " in html
    assert re.findall(r'class="go" data-feature="(\d)"', html) == ["1", "0", "2", "3"]


def test_comparisons_have_no_groups():
    from firebreak_gis.report.page import _table
    from firebreak_gis.report.page.content import Row

    html = _table("comparison", [Row({"method": "a", "R": 0.1}), Row({"method": "b", "R": 0.2})])
    assert "group" not in html
    assert "<tfoot>" not in html
