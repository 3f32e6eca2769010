"""Legends: the built-in ones say what they should, own ones are checked to the line."""

import csv
import math

import numpy as np
import pytest

from firebreak_gis.errors import LegendError
from firebreak_gis.landscape import legends
from firebreak_gis.landscape.legends import parse, read_legend
from tests.places import real, shared
from tests.twins import rothermel

BUILT_IN = [
    "anderson_13",
    "canopy_cover",
    "corine",
    "corine_grid",
    "density",
    "eu12",
    "fbp",
    "fernandes",
    "kitral",
    "paper",
    "prop6",
    "scott_burgan_40",
    "tree_cover_density",
    "worldcover",
]
LETTERS = {"N": 0, "A": 1, "S": 2, "P": 3}


def classes(name):
    """{code: (vegetation, density)} of a legend."""
    return {int(e.low): (e.vegetation, e.density) for e in read_legend(name).entries}


def test_the_built_in_legends_are_listed_with_their_sources():
    assert legends.names() == BUILT_IN
    for name in legends.names():
        legend = read_legend(name)
        assert sum(line.startswith("Source: ") for line in legend.about) == 1
        burns = any(e.dead_load is not None or e.rate is not None for e in legend.entries)
        assert legend.version == ("2" if burns and name != "fernandes" else "1")
        assert legend.has_density or name == "paper"
        assert all(entry.label for entry in legend.entries)


def test_the_papers_classes():
    assert classes("paper") == {0: (0, None), 1: (1, None), 2: (2, None), 3: (3, None)}
    assert classes("density") == {i: (None, i) for i in range(4)}


def test_eu12_and_prop6():
    types = "NAAASSSSSSPPP"
    found = classes("eu12")
    assert [found[code][0] for code in range(13)] == [LETTERS[letter] for letter in types]
    assert [found[code][1] for code in range(1, 13)] == [1, 2, 3] * 4
    assert found[0] == (0, None)
    assert classes("prop6") == {
        1: (2, 2),
        2: (2, 3),
        3: (0, None),
        4: (1, 1),
        5: (3, 2),
        6: (1, 2),
        7: (2, 1),
    }


def test_scott_and_burgan():
    found = classes("scott_burgan_40")
    assert len(found) == 45
    assert all(found[code] == (0, None) for code in (91, 92, 93, 98, 99))
    expected = ["A1", "A2", "A2", "A3", "A3", "A3", "A3", "A3", "A3"]
    assert [found[code] for code in range(101, 110)] == [(LETTERS[t], int(d)) for t, d in expected]
    some = {121: "S1", 123: "S2", 124: "S3", 143: "S1", 144: "S2", 149: "S3", 161: "P1", 163: "P3"}
    some |= {
        165: "P2",
        181: "P1",
        182: "S1",
        185: "P1",
        186: "S2",
        187: "P2",
        189: "S2",
        201: "P2",
        204: "P3",
    }
    assert {code: found[code] for code in some} == {c: (LETTERS[t[0]], int(t[1])) for c, t in some.items()}
    own = {int(e.low) for e in read_legend("scott_burgan_40").entries if not e.density_from_raster}
    assert set(found) - own == {c for c in found if 161 <= c <= 189}


def test_the_grid_codes_of_corine_are_its_codes_in_order():
    found, grid = classes("corine"), classes("corine_grid")
    assert [grid[i] for i in range(1, 45)] == [found[code] for code in sorted(found)]
    assert grid[24] == found[312]  # coniferous forest


def test_anderson_follows_scott_and_burgan():
    found = classes("anderson_13")
    expected = ["A2", "A2", "A3", "S3", "S1", "S2", "S2", "P1", "P2", "P3", "P2", "P3", "P3"]
    assert [found[code] for code in range(1, 14)] == [(LETTERS[t], int(d)) for t, d in expected]
    assert {code for code, (kind, _) in found.items() if kind == 0} == {91, 92, 93, 98, 99}
    assert {int(e.low) for e in read_legend("anderson_13").entries if e.density_from_raster} == {8, 9, 10}


def test_worldcover_has_the_eleven_classes_of_the_product():
    found = classes("worldcover")
    assert sorted(found) == [10, 20, 30, 40, 50, 60, 70, 80, 90, 95, 100]
    assert {code for code, (kind, _) in found.items() if kind == 0} == {50, 60, 70, 80}
    assert any("all trees are taken as pines" in line for line in read_legend("worldcover").about)


def test_canadian_fuel_types():
    found = classes("fbp")
    assert {code for code, (kind, _) in found.items() if kind == 0} == set(range(100, 107))
    assert all(found[code][0] == LETTERS["P"] for code in (*range(1, 8), 21, 22, 23))
    assert found[2] == (LETTERS["P"], 3)
    assert found[12] == (LETTERS["S"], 1)
    assert found[31] == (LETTERS["A"], 2)
    # The more conifers, the better it burns.
    for base in (400, 500, 600):
        assert [found[base + share] for share in (5, 45, 50, 70, 75, 95)] == [(2, 2)] * 2 + [(3, 1)] * 2 + [(3, 2)] * 2
        assert found[base // 10] == found[base + 50]
    for base in (700, 800, 900):
        assert [found[base + share] for share in (5, 45, 50, 95)] == [(3, 2)] * 2 + [(3, 3)] * 2


def test_corine():
    found = classes("corine")
    assert len(found) == 44
    by_type = {letter: {c for c, (v, _) in found.items() if v == LETTERS[letter]} for letter in "ASP"}
    assert by_type["A"] == {211, 212, 221, 222, 223, 231, 241, 242, 243, 244}
    assert by_type["S"] == {321, 322, 323, 324, 311, 333, 334}
    assert by_type["P"] == {312, 313}
    assert {c for c, (_, d) in found.items() if d == 1} == {333, 334}
    assert found[213] == (0, None)


@real
@pytest.mark.parametrize(
    ("name", "path"),
    [
        ("kitral", "portezuelo_100m/kitral_lookup_table.csv"),
        ("scott_burgan_40", "vilopriu_2013/spain_lookup_table.csv"),
    ],
)
def test_every_code_of_the_makers_table_is_there(name, path):
    found = classes(name)
    with shared(path).open(encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    assert len(rows) > 30
    for row in rows:
        code = int(row["grid_value"])
        if code == 0:  # "not available"
            continue
        assert code in found
        assert (found[code][0] == 0) == (row["fuel_type"].strip() in ("Non-fuel", "NB1", "NB2", "NB3", "NB8", "NB9"))
        if name == "kitral":
            words = row["descriptive_name"].split()
            if words[-1] in ("Densos", "Denso"):
                assert found[code][1] == 3
            if words[-1] == "Ralos" and "Medios" not in words:
                assert found[code][1] == 1


@pytest.mark.parametrize(
    ("cover", "canopy", "tree"),
    [(0, 1, 1), (29.9, 1, 1), (30, 1, 2), (39.99, 1, 2), (40, 2, 2), (69.9, 2, 2), (70, 3, 3), (100, 3, 3)],
)
def test_cover_thresholds(cover, canopy, tree):
    for name, expected in (("canopy_cover", canopy), ("tree_cover_density", tree)):
        legend = read_legend(name)
        assert legend.continuous
        assert legend.entries[int(legend.find(np.array([cover]))[0])].density == expected


def test_values_outside_are_found_nowhere():
    assert list(read_legend("canopy_cover").find(np.array([-0.1, 100.1, 255, np.nan]))) == [-1] * 4
    assert list(read_legend("paper").find(np.array([-1, 4, 1.5, np.nan, 2]))) == [-1, -1, -1, -1, 2]


def test_finding_is_looking_through_the_lines():
    legend = read_legend("corine")
    values = np.random.default_rng(0).integers(100, 530, 2000)
    slow = [next((i for i, e in enumerate(legend.entries) if e.low == v), -1) for v in values]
    assert list(legend.find(values)) == slow


@pytest.mark.parametrize("name", ["corine", "canopy_cover", "paper"])
def test_many_values_are_found_as_few_are(name):
    legend = read_legend(name)
    rng = np.random.default_rng(1)
    values = rng.integers(-5, 530, 80_000).astype(np.float64)
    odd = [np.nan, np.inf, -np.inf, -1.0, -0.5, 1.5, 29.9, 65_535.0, 65_536.0, 65_647.0, 1e30, -65_425.0]
    values[rng.integers(0, values.size, 5_000)] = rng.choice(odd, 5_000)
    in_parts = np.concatenate([legend.find(part) for part in np.split(values, 8)])
    assert np.array_equal(legend.find(values), in_parts)


def test_an_own_legend_by_path(tmp_path):
    path = tmp_path / "Ελλάδα.csv"
    text = '# Own map\n# version 3\n\ncode, vegetation, density, label\n7, Pines, dense, "old, tall"\n3,none,,\n'
    path.write_text(text, encoding="utf-8-sig")
    legend = read_legend(path)
    assert legend.name == "Ελλάδα"
    assert legend.about == ("Own map", "version 3")
    assert legend.codes == (3, 7)
    assert legend.entries[1].label == "old, tall"
    assert read_legend(str(path)) == legend
    assert read_legend(legend) is legend


def test_effects_are_numbers_with_a_point():
    legend = parse("code,vegetation,density\n1,0.25,-0.4\n2,-0.35,dense\n", "own", "own.csv")
    assert [(e.vegetation, e.vegetation_effect) for e in legend.entries] == [(3, 0.25), (1, -0.35)]
    assert [(e.density, e.density_effect) for e in legend.entries] == [(1, -0.4), (3, None)]


HEADER = "code,vegetation,density,label\n"


@pytest.mark.parametrize(
    ("text", "match"),
    [
        ("", "is empty"),
        ("# only a comment\n", "is empty"),
        (HEADER, "no codes"),
        ("kode,vegetation\n1,pines\n", "line 1: got the columns kode, vegetation"),
        ("code|vegetation|density\n1|pines|dense\n", "separated by commas"),
        (HEADER + "1,pines,dense,a\nextends,korine\n", "line 3: no legend 'korine' to extend"),
        ("extends\n" + HEADER + "1,pines,dense,a\n", "line 1: expected one line extends,NAME"),
        ("extends,tree_cover_density\ncode,density\n20..50,dense\n", "line 3: the code overlaps that of line 1"),
        ("code,label\n1,pines\n", "expected code, vegetation, density, label"),
        (HEADER + "1,pine,dense,a\n", "line 2: the vegetation is 'pine', expected one of none, agricultural"),
        (HEADER + "1,pines,thick,a\n", "line 2: the density is 'thick'"),
        (HEADER + "1,3,2,a\n", "class numbers are not"),
        (HEADER + "1,-1.0,2.0,a\n", "more than -1.0"),
        (HEADER + "1,nan.,dense,a\n", "line 2"),
        (HEADER + "x,pines,dense,a\n", "line 2: the code is 'x'"),
        (HEADER + "1.5,pines,dense,a\n", "line 2: the code is '1.5'"),
        (HEADER + "# why\n1,pines,dense,a\n\n1,none,,b\n", "line 5: the code overlaps that of line 3"),
        (HEADER + "5..2,pines,dense,a\n", "line 2: the range 5..2 is empty"),
        (HEADER + "0..30,pines,dense,a\n20..50,pines,sparse,b\n", "line 3: the code overlaps that of line 2"),
        (HEADER + "1,pines,dense,a,b,c\n", "line 2: 6 cells"),
        ("code,vegetation,density,density_from_raster\n1,pines,dense,perhaps\n", "expected yes or no"),
    ],
)
def test_faulty_legends_are_refused_with_the_line(text, match):
    with pytest.raises(LegendError, match=match):
        parse(text, "own", "own.csv")


def test_all_problems_are_told_at_once():
    with pytest.raises(LegendError) as caught:
        parse(HEADER + "1,pine,dense,a\n2,pines,thick,b\nx,none,,c\n", "own", "own.csv")
    assert all(part in str(caught.value) for part in ("own.csv", "line 2", "line 3", "line 4"))


def test_unreadable_legends_are_refused(tmp_path):
    with pytest.raises(LegendError, match=r"neither a built-in one .*corine"):
        read_legend("korine")
    path = tmp_path / "latin.csv"
    path.write_bytes("code,vegetation\n1,pines\n# für\n".encode("latin-1"))
    with pytest.raises(LegendError, match="UTF-8"):
        read_legend(path)


def own(tmp_path, content, name="own.csv"):
    path = tmp_path / name
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    return read_legend(path)


PLAIN = "code,vegetation,density,label\n10,pines,dense,a\n20,0.55,,b\n30,none,,\n"


@pytest.mark.parametrize(
    "content",
    [
        PLAIN.replace(",", ";"),
        PLAIN.replace(",", ";").replace("0.55", "0,55"),
        PLAIN.replace(",", "\t"),
        PLAIN.replace("10,", "10.0,").replace("20,", "20.000,"),
        PLAIN.encode("utf-16"),
        PLAIN.replace(",", "\t").encode("utf-16"),
        b"\xfe\xff" + PLAIN.encode("utf-16-be"),
        PLAIN.encode("utf-16-le"),
        PLAIN.encode("utf-16-be"),
        PLAIN.encode("utf-8-sig"),
        "sep=;\n" + PLAIN.replace(",", ";"),
        PLAIN.replace("\n", ",,\n") + ",,,,,\n",  # as spreadsheets fill lines up
        PLAIN.replace("\n", "\r\n"),
        "# why, and; how\n" + PLAIN.replace(",", ";"),
    ],
)
def test_legends_read_the_same_however_programs_write_them(tmp_path, content):
    assert own(tmp_path, content).entries == own(tmp_path, PLAIN, "plain.csv").entries


def test_a_legend_extends_another(tmp_path):
    base = read_legend("scott_burgan_40")
    legend = own(
        tmp_path, "extends,scott_burgan_40\ncode,vegetation,density,label\n165,none,,cut\n300,pines,dense,own\n"
    )
    found = {entry.low: entry for entry in legend.entries}
    assert set(found) == {*base.codes, 300.0}
    assert (found[165].vegetation, found[300].vegetation, found[300].density) == (0, 3, 3)
    assert [e for e in legend.entries if e.low not in (165, 300)] == [e for e in base.entries if e.low != 165]
    assert any(line.startswith("Source:") for line in legend.about)


def test_legends_extend_files_beside_them_and_in_chains(tmp_path):
    own(tmp_path, "extends;corine_grid\ncode;vegetation;density\n23;pines;dense\n", "first.csv")
    second = own(tmp_path, "extends,first.csv\ncode,vegetation,density\n24,none,\n", "second.csv")
    found = {entry.low: entry.vegetation for entry in second.entries}
    assert (found[23], found[24], found[25], len(found)) == (3, 0, 3, 45)
    assert own(tmp_path, "extends,corine_grid\n", "same.csv").entries == read_legend("corine_grid").entries


def test_circles_of_legends_are_refused(tmp_path):
    for one, other in (("a", "b"), ("b", "a")):
        (tmp_path / f"{one}.csv").write_text(f"extends,{other}.csv\ncode,vegetation\n1,none\n")
    with pytest.raises(LegendError, match="circle"):
        read_legend(tmp_path / "a.csv")


def test_an_own_range_takes_the_place_of_ranges_within_it(tmp_path):
    legend = own(tmp_path, "extends,tree_cover_density\ncode,density\n0..70,sparse\n")
    assert [(entry.low, entry.high) for entry in legend.entries] == [(0, 70), (70, 100), (254, 254), (255, 255)]


def test_flags_are_no_data_and_stand_apart_from_ranges():
    cover = read_legend("tree_cover_density")
    values = np.array([0.0, 99.5, 100.0, 100.5, 254.0, 255.0, -1.0, np.nan])
    assert cover.flagged(values).tolist() == [False, False, False, True, True, True, True, False]
    assert [cover.entries[i].missing for i in cover.find(np.array([254.0, 255.0]))] == [True, True]
    assert cover.has_density
    grid = read_legend("corine_grid")
    assert grid.entries[grid.find(np.array([48.0]))[0]].missing
    assert grid.has_vegetation
    assert grid.has_density


def test_columns_of_how_the_fuel_burns():
    text = "code,vegetation,density,rate_m_h,dead_kg_m2,live_kg_m2,heat_kj_kg,live_moisture\n"
    one, two = parse(text + "1,shrubs,dense,90,0.5,2,19000,0.6\n2,pines,normal\n", "own", "own.csv").entries
    assert (one.rate, one.dead_load, one.live_load, one.heat_content, one.live_moisture) == (90, 0.5, 2, 19_000, 0.6)
    assert {two.rate, two.dead_load, two.live_load, two.heat_content, two.live_moisture} == {None}


@pytest.mark.parametrize(
    ("column", "text"),
    [("rate_m_h", "fast"), ("rate_m_h", "-1"), ("dead_kg_m2", "200"), ("live_moisture", "60"), ("heat_kj_kg", "nan")],
)
def test_what_no_fuel_can_have_is_refused(column, text):
    with pytest.raises(LegendError, match=f"line 2: {column} is '{text}', expected a number from 0"):
        parse(f"code,vegetation,density,{column}\n1,shrubs,dense,{text}\n", "own", "own.csv")
    with pytest.raises(LegendError, match=f"{column} goes with a vegetation"):
        parse(f"code,density,{column}\n1,dense,0.5\n", "own", "own.csv")


@pytest.mark.parametrize(("name", "broadleaves"), [("eu12", 5), ("prop6", 1), ("corine", 311), ("corine_grid", 23)])
def test_broadleaves_have_the_loads_of_their_source(name, broadleaves):
    entry = next(e for e in read_legend(name).entries if e.low == broadleaves)
    assert (entry.dead_load, entry.live_load, entry.heat_content, entry.live_moisture) == (1.5, 3, 20_000, 0.6)
    assert entry.rate is None  # 140 m/h, as shrubs have


RATES = {1: 120.0, 2: 140.0, 3: 200.0}


@pytest.mark.parametrize("name", ["anderson_13", "scott_burgan_40", "fernandes"])
def test_rates_of_fuel_models_are_those_of_their_class_and_of_rothermel(name):
    """The rate of the class times the square root of the model's own no-wind rate over the class's mean one."""
    own = {code: rothermel.rate(**model) for code, model in rothermel.models().items()}
    entries = [e for e in read_legend(name).entries if e.vegetation]
    for kind in RATES:
        codes = [int(e.low) for e in entries if e.vegetation == kind]
        middle = math.exp(sum(math.log(own[code]) for code in codes) / len(codes))
        for entry in entries:
            if entry.vegetation == kind:
                assert entry.rate == round(RATES[kind] * math.sqrt(own[int(entry.low)] / middle)), entry.label


def test_the_twin_of_rothermel_burns_slower_the_wetter_and_not_at_extinction():
    for code, model in rothermel.models().items():
        rates = [rothermel.rate(**model, moisture=(m, m, m, 0.6 + m, 0.9 + m)) for m in (0.02, 0.06, 0.1, 0.14)]
        assert rates == sorted(rates, reverse=True), code
        assert rates[0] > rates[-1]
        assert rothermel.rate(**model, moisture=(0.6, 0.6, 0.6, 3.0, 3.0)) < 1e-9
