"""The map book, opened by a reader of PDF: texts, places at their scale, sizes of paper, caps, bytes, refusals."""

from __future__ import annotations

import re
import time
from dataclasses import replace

import geopandas as gpd
import numpy as np
import pypdfium2
import pytest
import shapely
from click.testing import CliRunner
from pyproj import Transformer

from firebreak_gis import plan, write_raster
from firebreak_gis.cli import firebreak
from firebreak_gis.construction.writing import write_segments
from firebreak_gis.errors import Cancelled, InputError
from firebreak_gis.planning.outputs import write_plan
from firebreak_gis.report.mapbook import maps, pages, write_book
from firebreak_gis.report.mapbook.atlas import Atlas, percent, read_atlas
from firebreak_gis.report.mapbook.columns import wrapped
from firebreak_gis.vectors import write_vector

POINT = 1 / 72  # inch


@pytest.fixture(scope="module")
def made(make_landscape):
    return plan(make_landscape((40, 52), seed=4, relief=6.0), budget=0.15, n_runs=8)


@pytest.fixture(scope="module")
def folder(made, tmp_path_factory):
    place = tmp_path_factory.mktemp("mapbook") / "plan"
    write_plan(made, place)
    return place


@pytest.fixture(scope="module")
def atlas(folder):
    return read_atlas(folder, title="Δοκιμή 5 $ über 3 $", date="spring 2026")


@pytest.fixture(scope="module")
def book(atlas, tmp_path_factory):
    path = tmp_path_factory.mktemp("mapbook") / "book.pdf"
    assert write_book(path, atlas, most=6) == 6
    return path


def texts(path):
    with pypdfium2.PdfDocument(path) as document:
        return [page.get_textpage().get_text_range() for page in document]


def flat(text):
    """Its words; where a font moves letters apart, a reader may see a gap behind a bracket."""
    return " ".join(text.split()).replace("( ", "(")


def require_on_paper(path):
    """No letter lies within 10 points of the edge of its page, or off it."""
    with pypdfium2.PdfDocument(path) as document:
        for page in document:
            text = page.get_textpage()
            boxes = np.array([text.get_charbox(k) for k in range(text.count_chars())])
            assert (boxes[:, :2] > 10).all()
            assert (boxes[:, 2:] < np.array(page.get_size()) - 10).all()


def own_pages(path):
    return [flat(text) for text in texts(path) if flat(text).startswith("Segment ")]


def test_a_page_for_each_of_the_first_segments_says_what_the_plan_knows(made, atlas, book):
    lines, n = made.segments.lines, len(made.segments.lines)
    found = own_pages(book)
    assert n > 6
    assert len(found) == 6
    for k, text in enumerate(found):
        row = lines.iloc[k]
        assert f"Segment {k + 1} of {n}" in text
        assert f"stage {row.stage} of {lines.stage.max()}" in text
        assert f"Length {row.length_m:,.0f} m" in text
        assert f"Area {row.area_ha:,.2f} ha" in text
        assert re.search(r" Ends A .* Why .* Map ", text)
        assert f"Slope, mean {row.mean_slope_deg:.1f} degrees" in text
        assert f"Slope, steepest {row.max_slope_deg:.1f} degrees" in text
        assert "Cost" not in text  # nobody gave prices
        if row.compartment_b:
            areas = dict(zip(made.compartments["compartment"], made.compartments["area_ha"], strict=True))
            for side in (row.compartment_a, row.compartment_b):
                assert f"compartment {side} ({areas[side]:,.1f} ha)" in text
        else:
            assert "Separates nothing" in text
        assert f"adds {percent(lines.gain_share[lines.stage == row.stage].sum())} of all" in text
        members = lines["order"][lines.stage == row.stage]
        assert (f"all {len(members)} segments of stage {row.stage} ({members.min()}" in text) == (len(members) > 1)
        assert ("Built at its turn" in text) == (len(members) == 1)
        touching = made.segments.polygons.geometry.intersects(made.segments.polygons.geometry.iloc[k])
        assert len(atlas.neighbours[k]) == touching.sum() - 1


def test_ends_are_told_in_degrees_and_on_the_grid(made, book):
    to_degrees = Transformer.from_crs(made.network.grid.crs, 4326, always_xy=True)
    for shape, text in zip(made.segments.lines.geometry, own_pages(book), strict=False):
        told = re.findall(r"([\d.]+)° N ([\d.]+)° E ([\d ]+) E ([\d ]+) N", text.replace("\N{NO-BREAK SPACE}", " "))
        part = max(getattr(shape, "geoms", [shape]), key=lambda p: p.length)
        ends = {tuple(part.coords[0]), tuple(part.coords[-1])}
        assert len(told) == len(ends)
        for lat, lon, east, north in told:
            place = float(east.replace(" ", "")), float(north.replace(" ", ""))
            assert min(np.hypot(place[0] - x, place[1] - y) for x, y in ends) < 1
            np.testing.assert_allclose(to_degrees.transform(*place), (float(lon), float(lat)), atol=2e-5)


def test_the_overview_says_the_headline_with_its_assumptions_and_where_it_comes_from(made, atlas, book):
    first = flat(texts(book)[0])
    for sentence in (*made.headline, *made.judged.assumptions):
        assert flat(sentence) in first
    assert first.startswith("Δοκιμή 5 $ über 3 $")
    assert "Date: spring 2026" in first
    assert "EPSG:32635" in first
    assert f"6 of the {len(atlas.lines)} segments have a page; the list names all" in first
    assert "built first (stage 1)" in first


def test_the_list_names_all_with_their_page_and_sums(made, book):
    lines = made.segments.lines
    everything = texts(book)
    listed = [text for text in everything if flat(text).startswith("Segments in order")]
    rows = [flat(line).split(" ") for text in listed for line in text.splitlines() if re.match(r"\d+ \d+ ", line)]
    assert [int(row[0]) for row in rows] == lines["order"].tolist()
    assert [int(row[1]) for row in rows] == lines["stage"].tolist()
    assert [float(row[2].replace(",", "")) for row in rows] == lines["length_m"].round().tolist()
    first = 1 + len(listed) + 1
    assert [row[-1] for row in rows] == [str(first + k) if k < 6 else "–" for k in range(len(rows))]
    for k in range(6):
        assert f"page {first + k}" in flat(everything[first + k - 1])
    total = flat(listed[-1]).split("Sum")[1]
    assert f"{lines['length_m'].sum():,.0f} m" in total
    assert f"{lines['area_ha'].sum():,.2f} ha" in total
    assert "100 %" in total


def pixels(path, number, dots=200):
    """(rows, cols, 3) of a page, from 0."""
    with pypdfium2.PdfDocument(path) as document:
        return np.asarray(document[number].render(scale=dots * POINT).to_pil().convert("RGB")).astype(int)


def spot(image, paper, place, window, box, dots=200):
    """The pixels within half a millimetre of a place on the map."""
    across = box[0] + (place[0] - window.left) / (window.right - window.left) * box[2]
    up = box[1] + (place[1] - window.bottom) / (window.top - window.bottom) * box[3]
    row, col = round((paper.height - up) * dots), round(across * dots)
    return image[row - 3 : row + 4, col - 3 : col + 4].reshape(-1, 3)


@pytest.mark.parametrize("portrait", [False, True])
def test_segments_lie_on_paper_where_their_scale_says(atlas, tmp_path, portrait):
    path = tmp_path / "b.pdf"
    write_book(path, atlas, most=5, portrait=portrait)
    paper = pages.sheet("a4", portrait=portrait)
    with pypdfium2.PdfDocument(path) as document:
        assert document.get_page_size(0) == pytest.approx((paper.width / POINT, paper.height / POINT), abs=0.1)
        before = len(document) - 5
    for k in range(5):
        image = pixels(path, before + k)
        shape = atlas.polygons.geometry.iloc[k]
        window = maps.window_of(shape.bounds, paper.map[2:], margin=0.14, least=pages.FINEST)
        assert window.right - window.left == pytest.approx(paper.map[2] * 0.0254 * window.scale)
        line = max(shapely.get_parts(atlas.lines.geometry.iloc[k]), key=lambda p: p.length)
        for share in (0.1, 0.9):
            point = line.interpolate(share, normalized=True)
            near = spot(image, paper, (point.x, point.y), window, paper.map)
            assert (np.abs(near - (0xD7, 0x19, 0x1C)).max(axis=1) < 60).any(), (k, share)
        assert f"1 : {window.scale:,.0f}".replace(",", " ") in flat(texts(path)[before + k]).replace("\xa0", " ")


def test_roads_and_water_are_drawn(atlas, folder, tmp_path):
    left, bottom, right, _ = atlas.grid.bounds
    middle = (left + right) / 2
    road = shapely.LineString([(left, bottom + 60), (right, bottom + 60)])
    lake = shapely.box(middle, bottom + 200, middle + 120, bottom + 320)
    for name, shape in (("roads", road), ("water", lake)):
        frame = gpd.GeoDataFrame(geometry=[shape], crs=atlas.grid.crs).to_crs(4326)
        write_vector(tmp_path / f"{name}.gpkg", frame)
    drawn = read_atlas(folder, roads=str(tmp_path / "roads.gpkg"), water=str(tmp_path / "water.gpkg"))
    paper = pages.sheet("a4", portrait=False)
    window = maps.window_of(drawn.grid.bounds, paper.map[2:], margin=0.01)
    colours = {}
    for key, book in (("with", drawn), ("without", atlas)):
        write_book(tmp_path / f"{key}.pdf", book, most=1)
        image = pixels(tmp_path / f"{key}.pdf", 0)
        colours[key] = [
            spot(image, paper, place, window, paper.map).tolist()
            for place in ((left + 25, bottom + 60), (middle + 60, bottom + 260))
        ]
    brown, blue = (0x6B, 0x4A, 0x2B), (0xBC, 0xD9, 0xEA)
    assert min(np.abs(np.array(colours["with"][0]) - brown).max(axis=1)) < 30
    assert min(np.abs(np.array(colours["without"][0]) - brown).max(axis=1)) > 30
    assert min(np.abs(np.array(colours["with"][1]) - blue).max(axis=1)) < 12
    assert "Roads: roads.gpkg" in flat(texts(tmp_path / "with.pdf")[0])


@pytest.mark.parametrize("paper", pages.PAPERS)
def test_scales_are_round_and_hold_what_they_show(paper):
    size = pages.sheet(paper, portrait=True).map[2:]
    random = np.random.default_rng(1)
    for _ in range(50):
        x, y = random.uniform(-1e6, 1e6, 2)
        across, up = 10 ** random.uniform(0, 5.5, 2)
        window = maps.window_of((x, y, x + across, y + up), size, margin=0.1, least=5000)
        assert window.scale in maps.SCALES
        assert window.left <= x - 0.1 * (window.right - window.left) + 1e-6
        assert window.top >= y + up + 0.1 * (window.top - window.bottom) - 1e-6
        smaller = [s for s in maps.SCALES if 5000 <= s < window.scale]
        room = 0.8 * 0.0254
        assert all(across > room * size[0] * s or up > room * size[1] * s for s in smaller)


def test_equal_plans_give_equal_bytes_without_a_date(atlas, folder, tmp_path):
    write_book(tmp_path / "a.pdf", atlas, most=2)
    time.sleep(1.1)
    write_book(tmp_path / "b.pdf", read_atlas(folder, title=atlas.title, date="spring 2026"), most=2)
    assert (tmp_path / "a.pdf").read_bytes() == (tmp_path / "b.pdf").read_bytes()
    with pypdfium2.PdfDocument(tmp_path / "a.pdf") as document:
        told = document.get_metadata_dict()
    assert (told["Title"], told["CreationDate"], told["ModDate"]) == (atlas.title, "", "")
    assert told["Creator"].startswith("firebreak_gis ")


def test_years_treatments_and_prices_are_shown_where_there_are_any(made, atlas, tmp_path):
    long = "Räumung + kontrolliertes Brennen + Beweidung"
    treated = made.segments.lines.assign(treatment=long, treatment_yearly=123.45)
    lines = treated.assign(year=2027 + treated["order"] // 10, cost=treated["cells"] * 321.5)
    other = Atlas("t", lines, atlas.grid, polygons=atlas.polygons, elevation=atlas.elevation)
    write_book(tmp_path / "t.pdf", other, most=3)
    require_on_paper(tmp_path / "t.pdf")
    for k, text in enumerate(own_pages(tmp_path / "t.pdf")):
        row = lines.iloc[k]
        assert f"Year {row.year}" in text
        assert f"Treatment {row.treatment}" in text
        assert f"Cost {row.cost:,.2f}" in text
        assert f"Cost a year {row.treatment_yearly:,.2f}" in text
    listed = flat(texts(tmp_path / "t.pdf")[1])
    assert "Segment Stage Year Length" in listed
    # Long names are written smaller, and not over the next column.
    with pypdfium2.PdfDocument(tmp_path / "t.pdf") as document:
        page = document[1].get_textpage()
        place = page.search(long).get_next()
        left = page.get_charbox(place[0])[0]
        steep = page.search("Steepest").get_next()
        assert left > page.get_charbox(steep[0] + steep[1] - 1)[2]
    assert "Treatment Cost Saves Page" in listed


def test_segments_that_no_year_builds_have_none(made, tmp_path):
    polygons, lines = made.segments.polygons, made.segments.lines
    year = np.where(lines["order"] > 3, 0, 2)
    write_segments(tmp_path / "s.gpkg", lines.assign(year=year), polygons.assign(year=year))
    write_book(tmp_path / "y.pdf", read_atlas(tmp_path / "s.gpkg"), most=4)
    own = own_pages(tmp_path / "y.pdf")
    assert [re.search("Year (not within the years|[0-9]+)", text)[1] for text in own] == ["2"] * 3 + [
        "not within the years"
    ]
    listed = flat(texts(tmp_path / "y.pdf")[1])
    assert re.search(r"\b3 \d+ 2 ", listed)
    assert re.search(r"\b4 \d+ – ", listed)


@pytest.mark.parametrize("words", [10, 400, 4000])
@pytest.mark.parametrize(("paper", "portrait"), [("a4", False), ("a4", True), ("letter", False)])
def test_however_much_is_to_be_said_all_of_it_lies_on_paper(atlas, tmp_path, paper, portrait, words):
    said = {what: [f"{what}{k}" for k in range(words)] for what in ("head", "assumed", "warned")}
    said = {what: [" ".join(each[k : k + 40]) for k in range(0, words, 40)] for what, each in said.items()}
    texts_of = {"headline": said["head"], "assumptions": said["assumed"], "warnings": said["warned"]}
    other = replace(atlas, **{name: tuple(each) for name, each in texts_of.items()})
    write_book(tmp_path / "m.pdf", other, most=2, paper=paper, portrait=portrait)
    require_on_paper(tmp_path / "m.pdf")
    found = [flat(each) for each in texts(tmp_path / "m.pdf")]
    missing = {word for each in said.values() for some in each for word in some.split()} - set(" ".join(found).split())
    assert missing == set()
    assert said["head"][0] in found[0]
    assert "built first (stage 1)" in found[0]
    about = [k for k, each in enumerate(found) if "What the plan saves, and what that assumes" in each]
    assert about == list(range(1, 1 + len(about)))
    assert bool(about) == (words > 10)
    listed = next(k for k, each in enumerate(found) if each.startswith("Segments in order"))
    assert f"page {listed + 1}" in found[listed]
    own = [k for k, each in enumerate(found) if each.startswith("Segment ")]
    assert all(f"page {k + 1}" in found[k] for k in own)


def test_paragraphs_are_broken_between_words_alone_as_long_as_these_have_room():
    text = "from 587\N{NO-BREAK SPACE}212 E to 4\N{NO-BREAK SPACE}006\N{NO-BREAK SPACE}216 N  " + "x" * 40
    assert wrapped(text, 1e4, 7.5) == [text]
    lines = wrapped(text, 60.0, 7.5)
    assert "".join(lines).replace(" ", "") == text.replace(" ", "")
    assert any("4\N{NO-BREAK SPACE}006\N{NO-BREAK SPACE}216" in line for line in lines)
    assert sum(set(line) == {"x"} for line in lines) > 1
    assert wrapped("", 60.0, 7.5) == [""]


def test_short_segments_may_go_without_a_page(atlas, tmp_path):
    lengths = atlas.lines["length_m"]
    limit = float(lengths.median())
    own = write_book(tmp_path / "s.pdf", atlas, shortest=limit, most=4)
    shown = [int(text.split()[1]) for text in own_pages(tmp_path / "s.pdf")]
    assert own == len(shown) == 4
    assert shown == (np.flatnonzero(lengths >= limit)[:4] + 1).tolist()


def test_a_stop_leaves_nothing(atlas, tmp_path):
    seen = []

    def progress(share, message):
        seen.append((share, message))
        if len(seen) == 3:
            raise Cancelled("stopped")

    with pytest.raises(Cancelled):
        write_book(tmp_path / "b.pdf", atlas, most=5, progress=progress)
    assert list(tmp_path.iterdir()) == []
    assert [share for share, _ in seen] == sorted(share for share, _ in seen)
    assert re.fullmatch(r"page 3 of \d+", seen[-1][1])


def call(*words):
    return CliRunner().invoke(firebreak, [str(word) for word in words])


def test_the_command(made, folder, tmp_path):
    outcome = call("mapbook", folder, "-o", tmp_path / "b.pdf", "--pages", 2, "--paper", "letter", "--portrait")
    assert outcome.exit_code == 0, outcome.output
    assert f"2 of {len(made.segments.lines)} segments" in outcome.stdout
    assert "--pages" in outcome.stdout
    with pypdfium2.PdfDocument(tmp_path / "b.pdf") as document:
        assert document.get_page_size(0) == (612, 792)
    assert call("mapbook", folder, "-o", tmp_path / "b.pdf").exit_code == 4
    write_raster(tmp_path / "dem.tif", made.landscape["elevation"])
    source = folder / "segments.gpkg"
    words = ("--pages", 1, "-q", "--overwrite")
    assert call("mapbook", source, "-o", tmp_path / "c.pdf", "--dem", tmp_path / "dem.tif", *words).exit_code == 0
    assert "Elevation: dem.tif" in flat(texts(tmp_path / "c.pdf")[0])
    assert "Contour lines" in own_pages(tmp_path / "c.pdf")[0]
    assert call("mapbook", source, "-o", tmp_path / "d.pdf", *words).exit_code == 0
    assert "Contour lines" not in own_pages(tmp_path / "d.pdf")[0]
    refused = call("mapbook", folder, "-o", tmp_path / "e.pdf", "--dem", tmp_path / "dem.tif")
    assert (refused.exit_code, "leave --dem out" in refused.output) == (2, True)


def test_what_is_no_plan_is_refused(made, folder, tmp_path):
    with pytest.raises(InputError, match=r"run\.json"):
        read_atlas(tmp_path)
    (tmp_path / "run.json").write_text((folder / "run.json").read_text())
    with pytest.raises(InputError, match=r"lacks elevation\.tif, vegetation\.tif, segments\.gpkg"):
        read_atlas(tmp_path)
    (tmp_path / "run.json").write_text('{"software": "firebreak_gis", "command": "compare"}')
    with pytest.raises(InputError, match="holds a run of 'compare'"):
        read_atlas(tmp_path)
    write_segments(tmp_path / "none.gpkg", *(frame.iloc[:0] for frame in made.segments))
    with pytest.raises(InputError, match="holds no segment"):
        read_atlas(tmp_path / "none.gpkg")
    with pytest.raises(InputError, match="expected the layer lines"):
        read_atlas(folder / "compartments.gpkg")


def test_ground_without_a_coordinate_system_and_without_relief(make_landscape, tmp_path):
    made = plan(make_landscape((20, 26), seed=1, crs=None, elevation=0.0), budget=0.2, n_runs=4, timeless=True)
    ground = {name: made.landscape[name].to_numpy() for name in ("elevation", "vegetation")}
    bare = Atlas("bare", made.segments.lines, made.network.grid, compartments=made.compartments, **ground)
    write_book(tmp_path / "b.pdf", bare, most=1)
    assert "Without a coordinate system" in flat(texts(tmp_path / "b.pdf")[0])
    assert "° N" not in own_pages(tmp_path / "b.pdf")[0]
