"""Rules for the QGIS plugin that need no QGIS: imports, enums, metadata, zip, manifest, security."""

from __future__ import annotations

import ast
import importlib.util
import json
import re
import subprocess
import sys
import zipfile
from configparser import ConfigParser
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

ROOT = Path(__file__).resolve().parents[2]
PLUGIN = ROOT / "qgis_plugin" / "firebreak"
SOURCES = sorted(PLUGIN.rglob("*.py"))
LARGEST_ZIP = 25 * 2**20
PICTURES = {".svg", ".png"}

sys.path[:0] = [str(PLUGIN.parent), str(Path(__file__).parent)]

import collect_names  # noqa: E402
from firebreak import forms, manifest  # noqa: E402

source = pytest.mark.parametrize("path", SOURCES, ids=lambda p: p.relative_to(PLUGIN).as_posix())


def nodes(path: Path) -> list[ast.AST]:
    return list(ast.walk(ast.parse(path.read_text(encoding="utf-8"))))


# --- sources ------------------------------------------------------------------------------------------------


@source
def test_imports_are_pyqgis_and_the_standard_library(path):
    for node in nodes(path):
        names = []
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            names = [node.module]
        for name in names:
            top = name.partition(".")[0]
            # `processing` is the part of QGIS that draws the forms.
            assert top in ("qgis", "processing") or top in sys.stdlib_module_names, name
            assert not re.match(r"PyQt\d|PySide", name)


def test_the_engine_part_needs_no_qgis():
    free = [
        *PLUGIN.glob("engine/*.py"),
        *(
            PLUGIN / f"{n}.py"
            for n in ("forms", "labels", "names", "words", "manifest", "arguments", "results", "translation")
        ),
    ]
    for path in free:
        assert "qgis" not in {
            name.partition(".")[0]
            for node in nodes(path)
            for name in (
                [alias.name for alias in node.names]
                if isinstance(node, ast.Import)
                else [node.module or ""]
                if isinstance(node, ast.ImportFrom) and node.level == 0
                else []
            )
        }


@source
def test_enums_are_scoped(path):
    """`Class.Enum.Value`, never `Class.Value`, which Qt 6 lacks."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    inner = {id(n.value) for n in ast.walk(tree) if isinstance(n, ast.Attribute)}
    called = {id(n.func) for n in ast.walk(tree) if isinstance(n, ast.Call)}
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and id(node) not in inner | called:
            is_class = re.match(r"(Q[A-Z]|Qt$|Qgis$|Qgs)", node.value.id)
            assert not (is_class and node.attr[0].isupper()), f"{node.value.id}.{node.attr} in line {node.lineno}"


@source
def test_enums_that_qgis_4_names_anew_stand_in_one_place(path):
    old = (
        r"QgsProcessing\.(SourceType|Type)|\.Flag\.Flag|ParameterNumber\.Type|RasterFileWriter\.WriterError|WktVariant"
    )
    assert path.name == "enums.py" or not re.search(old, path.read_text(encoding="utf-8"))


#: What only later releases have, and the plugin does without.
LATER = {"QGIS 3.22": {"layerSortKey"}, "QGIS 4": set()}


@pytest.mark.parametrize("release", LATER)
def test_every_name_used_is_there_in_the_oldest_qgis_and_in_qgis_4(release):
    """Classes, enums, and methods that are called or overridden; `collect_names.py` says how the lists are made."""
    known = json.loads((Path(__file__).with_name("qgis_names.json")).read_text(encoding="utf-8"))[release]
    dotted, methods = collect_names.used()
    new, old = collect_names.of_enums()
    dotted |= new if release == "QGIS 4" else old
    assert len(dotted) > 60
    assert len(methods) > 100
    assert dotted - set(known["dotted"]) == set()
    assert methods - set(known["methods"]) == LATER[release]


@source
def test_python_39_can_read_it(path):
    """The oldest QGIS that the plugin supports runs Python 3.9."""
    tree = ast.parse(path.read_text(encoding="utf-8"), feature_version=(3, 9))
    late = any(isinstance(n, ast.ImportFrom) and n.module == "__future__" for n in tree.body)
    assert late or len(tree.body) == 1, "annotations would be evaluated"
    for node in ast.walk(tree):
        if isinstance(node, ast.Call):
            assert not [k for k in node.keywords if k.arg in ("strict", "slots", "kw_only")]


@source
def test_no_assert_no_bare_except_no_shell(path):
    for node in nodes(path):
        assert not isinstance(node, ast.Assert)
        assert not (isinstance(node, ast.ExceptHandler) and node.type is None)
        for keyword in node.keywords if isinstance(node, ast.Call) else ():
            assert not (keyword.arg == "shell" and getattr(keyword.value, "value", True))


@source
def test_texts_can_be_found_by_the_translators(path):
    """Calls of translate() carry the context `Firebreak` and a literal, but for texts of the manifest."""
    for node in nodes(path):
        if isinstance(node, ast.Call) and getattr(node.func, "attr", getattr(node.func, "id", "")) == "translate":
            assert node.args[0].value == "Firebreak"
            assert isinstance(node.args[1], ast.Constant) or path.name == "texts.py"


@source
def test_modules_stay_small(path):
    assert len(path.read_text(encoding="utf-8").splitlines()) <= 300


def test_bandit_finds_nothing():
    run = subprocess.run(
        [sys.executable, "-m", "bandit", "-q", "-r", str(PLUGIN), "-f", "json"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert json.loads(run.stdout)["results"] == []


# --- manifest -----------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def described():
    run = subprocess.run(
        [sys.executable, "-m", "firebreak_gis", "describe", "--json"],
        capture_output=True,
        text=True,
        encoding="utf-8",
        cwd=ROOT,
        check=True,
    )
    return json.loads(run.stdout)["result"]


def test_manifest_is_in_step_with_the_program(described):
    """Mend it with ``firebreak describe > qgis_plugin/firebreak/manifest.json``."""
    kept = json.loads((PLUGIN / "manifest.json").read_text(encoding="utf-8"))
    assert kept == described


def test_every_form_has_its_command(described):
    names = [d.form.name for d in manifest.descriptions()]
    assert names == [form.name for form in forms.FORMS if form.name in described["commands"]]
    assert {"align", "network", "rank", "breaks", "plan", "burn", "evaluate"} <= set(names)
    assert {form.group for form in forms.FORMS} == set(forms.GROUPS)


@pytest.mark.parametrize("description", manifest.descriptions(), ids=lambda d: d.form.name)
def test_forms_are_sound(description):
    names = [f.name for f in description.fields] + [o.name for o in description.outputs]
    assert len(names) == len(set(names))
    assert description.outputs
    known = {o.name for o in description.outputs}
    assert set(description.form.shown) - {"OUTPUT_REPORT"} <= known
    options = {f.option for f in description.fields}
    for field in description.fields:
        assert field.parent == "" or field.parent in names
        assert field.label
        assert field.kind in ("raster", "vector") or not field.name.startswith("INPUT_")
        assert field.help
        assert "--" not in field.help, "a flag of the command line"
        assert "firebreak " not in field.help, "a command"
        if field.choices and field.default:
            assert set(str(field.default).split(",")) <= set(field.choices)
    assert not (set(description.form.main) - options) & {
        "budget",
        "method",
        "n_runs",
        "seed",
        "dem",
        "vegetation",
    }
    for place in ("icons",):
        assert (PLUGIN / place / f"{description.form.name}.svg").is_file()


def test_the_same_word_means_the_same_everywhere():
    kinds: dict[str, set[str]] = {}
    for description in manifest.descriptions():
        for field in description.fields:
            kinds.setdefault(field.name, set()).add(f"{field.kind} {field.option}")
    assert {name: found for name, found in kinds.items() if len(found) > 1} == {}


def test_groups():
    found = {}
    for description in manifest.descriptions():
        found.setdefault(forms.GROUPS[description.form.group], []).append(description.form.title)
    assert found == {
        "1 Prepare": [
            "Align landscape",
            "Spread network",
            "Where a line can be held",
            "Compartments bounded by control lines",
        ],
        "2 Rank and cut": [
            "Plan fire breaks",
            "Rank cells",
            "Select fire breaks",
            "Segments to build",
            "Map book for crews",
            "Files for crews",
        ],
        "3 Burn": ["Burn frequency"],
        "4 Judge": [
            "Judge existing breaks",
            "Evaluate",
            "Compare",
            "Validate against a scar",
            "Calibrate on observed fires",
            "Report of a run",
        ],
    }


def test_the_table_of_forms_names_only_options_that_some_command_has(described):
    known = {option["name"] for c in described["commands"].values() for option in c.get("parameters", ())}
    for form in forms.FORMS:
        assert set(form.main) <= known, form.name
        assert len(form.main) == len(set(form.main))


@pytest.mark.parametrize("description", manifest.descriptions(), ids=lambda d: d.form.name)
def test_forms_are_short(description):
    """What stands on the form; the rest is folded away, or comes with the folder of all files."""
    seen = [f.name for f in description.fields if not f.advanced]
    seen += [o.name for o in description.outputs if o.shown or o.kind == "folder"]
    assert len(seen) <= 20, seen
    options = [f.option for f in description.fields]
    assert ("method" in options) == ("method_params" in options), "one field takes the parameters of all rankings"


#: Words of help texts that tell that a number has a unit or none.
UNITS = re.compile(
    r"\[.+\]|metres|hectare|share|probabilit|degrees|north|shares?|number|money|threshold|percent|cells", re.IGNORECASE
)


def test_form_of_burn_asks_for_a_clock_and_not_for_another_wind():
    burn = next(d for d in manifest.descriptions() if d.form.name == "burn")
    plain = {field.option for field in burn.fields if not field.advanced}
    assert {"network", "mask", "duration", "hold", "embers"} <= plain
    assert not {field.option for field in burn.fields} & {"model", "wind_speed", "weather", "moisture", "model_params"}


@pytest.mark.parametrize("description", manifest.descriptions(), ids=lambda d: d.form.name)
def test_numbers_have_units(description):
    for field in description.fields:
        if field.kind == "number":
            assert UNITS.search(f"{field.label} {field.help}"), field.name


def test_new_options_and_outputs_need_no_edits(monkeypatch, described):
    """An option and a file that no table knows come out as an advanced field and a destination on demand."""
    later = json.loads(json.dumps(described))
    command = later["commands"]["plan"]
    command["parameters"] += [
        {"name": "spotting_rate", "type": "float", "default": 0.5, "flags": ["--spotting-rate"], "help": "Rate [1/h]."},
        {"name": "mapped", "type": "new-vector", "flags": ["--mapped"], "help": "Map."},
    ]
    command["outputs"]["lanes.gpkg"] = "Lanes"
    monkeypatch.setattr(manifest, "_document", lambda: later)
    manifest.descriptions.cache_clear()
    try:
        plan = next(d for d in manifest.descriptions() if d.form.name == "plan")
    finally:
        manifest.descriptions.cache_clear()
    field = next(f for f in plan.fields if f.option == "spotting_rate")
    assert (field.name, field.kind, field.advanced, field.default) == ("SPOTTING_RATE", "number", True, 0.5)
    outputs = {o.name: o for o in plan.outputs}
    assert (outputs["OUTPUT_LANES"].kind, outputs["OUTPUT_LANES"].shown) == ("vector", False)
    assert (outputs["OUTPUT_MAPPED"].kind, outputs["OUTPUT_MAPPED"].flag) == ("vector", "--mapped")


def test_promised_names():
    plan = next(d for d in manifest.descriptions() if d.form.name == "plan")
    names = {f.name for f in plan.fields} | {o.name for o in plan.outputs}
    assert {
        "INPUT_DEM",
        "INPUT_VEGETATION",
        "INPUT_DENSITY",
        "BUDGET",
        "METHOD",
        "N_RUNS",
        "SEED",
        "OUTPUT_PRIORITY",
        "OUTPUT_BREAKS",
        "OUTPUT_FREQUENCY",
    } <= names


# --- metadata and zip ---------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def metadata():
    parser = ConfigParser(interpolation=None)
    parser.read(PLUGIN / "metadata.txt", encoding="utf-8")
    return parser["general"]


def test_metadata(metadata):
    for key in (
        "name",
        "description",
        "version",
        "qgisMinimumVersion",
        "author",
        "email",
        "about",
        "tracker",
        "repository",
        "homepage",
        "license",
        "tags",
        "icon",
        "category",
    ):
        assert metadata[key].strip(), key
    assert re.fullmatch(r"\d+\.\d+\.\d+", metadata["version"])
    assert metadata["qgisMinimumVersion"] == "3.22"
    assert metadata["qgisMaximumVersion"] == "4.99"
    assert metadata["hasProcessingProvider"] == "yes"
    assert "supportsQt6" not in metadata
    for key in ("tracker", "repository", "homepage", "documentation", "email"):
        assert "example.org" in metadata[key], "an address that only the publisher knows"
    for word in ("Make engine", "pip install firebreak_gis"):
        assert word in metadata["about"]
    assert (PLUGIN / metadata["icon"]).is_file()


def test_the_folder_is_the_slug_of_the_name(metadata):
    assert re.sub(r"[^a-z0-9]+", "_", metadata["name"].lower()) == PLUGIN.name
    assert PLUGIN.name != "firebreak_gis"


def test_the_licence_is_inside_and_the_projects_own():
    assert (PLUGIN / "LICENSE").read_text(encoding="utf-8") == (ROOT / "LICENSE").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def builder():
    spec = importlib.util.spec_from_file_location("build_zip", PLUGIN.parent / "build_zip.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_zip(builder, tmp_path, metadata):
    path = builder.build(tmp_path / "a")
    assert path.name == f"firebreak.{metadata['version']}.zip"
    assert path.stat().st_size <= LARGEST_ZIP
    with zipfile.ZipFile(path) as archive:
        names = archive.namelist()
    assert {name.partition("/")[0] for name in names} == {"firebreak"}
    assert {
        "firebreak/metadata.txt",
        "firebreak/LICENSE",
        "firebreak/__init__.py",
        "firebreak/manifest.json",
    } <= set(names)
    for name in names:
        assert "__pycache__" not in name
        assert not re.search(r"(^|/)[._](?!_init__)", name), "hidden file"
        assert Path(name).suffix in {".py", ".json", ".txt", ".qml", ".ts", ".qm", "", *PICTURES}, "a binary?"
    assert path.read_bytes() == builder.build(tmp_path / "b").read_bytes()


def test_a_release_has_real_addresses(builder, tmp_path):
    """The plugin repository refuses others; the publisher gives them to the builder."""
    with pytest.raises(builder.ReleaseError, match=r"--repository .* --email"):
        builder.build(tmp_path, release=True)
    with pytest.raises(builder.ReleaseError, match=r"give --tracker \.\.\. \("):
        builder.build(
            tmp_path,
            {
                **dict.fromkeys(("repository", "homepage", "documentation"), "https://forest.net/x"),
                "tracker": "http://forest.net",
                "email": "a@forest.net",
            },
            release=True,
        )
    assert list(tmp_path.iterdir()) == []
    given = ["--repository", "https://forest.net/fire/", "--email", "a@forest.net", "--output", str(tmp_path)]
    run = subprocess.run(
        [sys.executable, builder.__file__, "--release", *given], capture_output=True, text=True, check=True
    )
    with zipfile.ZipFile(run.stdout.strip()) as archive:
        parser = ConfigParser(interpolation=None)
        parser.read_string(archive.read("firebreak/metadata.txt").decode())
        found = parser["general"]
    assert found["tracker"] == "https://forest.net/fire/issues"
    assert found["documentation"] == "https://forest.net/fire/docs"
    assert found["homepage"] == found["repository"] == "https://forest.net/fire/"
    assert found["email"] == "a@forest.net"
    assert "example.org" not in str(dict(found))


@pytest.mark.parametrize("path", sorted(PLUGIN.rglob("*.svg")), ids=lambda p: p.name)
def test_icons_are_xml(path):
    root = ET.parse(path).getroot()
    assert root.get("viewBox") == "0 0 24 24"


def test_sample_project_is_relative():
    text = (PLUGIN.parent / "sample" / "sample_landscape.qgs").read_text(encoding="utf-8")
    places = set(re.findall(r"<datasource>([^<|]+)", text))
    assert {Path(place).name for place in places} >= {
        "dem.tif",
        "vegetation.tif",
        "density.tif",
        "ignitions.gpkg",
    }
    for place in places:
        assert place.startswith("../../sample_data/")
        assert (PLUGIN.parent / "sample" / place).is_file()
    assert not re.search(r"\bnan\b", text, re.IGNORECASE)
    assert not re.search(r"(saveUser|/(home|root)/|[A-Z]:\\)", text)
