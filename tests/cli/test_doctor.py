"""`firebreak doctor`: healthy here; what is missing is named, with exit code 6."""

import json
import re
import tomllib
from pathlib import Path

import pytest
from click.testing import CliRunner

from firebreak_gis.cli import firebreak
from firebreak_gis.cli.commands import doctor
from firebreak_gis.cli.commands.doctor import Check


def run(*words, code=0):
    outcome = CliRunner().invoke(firebreak, ["doctor", *words])
    assert outcome.exit_code == code, outcome.output
    return outcome


def test_all_is_well_here():
    found = json.loads(run("--json").stdout)["result"]
    assert found["healthy"]
    states = {check["name"]: check["state"] for check in found["checks"]}
    assert {"numpy", "rasterio", "GDAL", "PROJ", "vectors", "compiler cache", "threads", "memory", "disk"} <= set(
        states
    )
    assert states["small run"] == "ok"
    assert set(states.values()) <= {"ok", "warning"}
    assert "PROJ" in run().stdout


def test_a_missing_package_is_named(monkeypatch):
    monkeypatch.setattr(doctor, "_NEEDED", ("numpy", "no_such_package"))
    outcome = run("--json", code=6)
    (line,) = [json.loads(text) for text in outcome.stdout.splitlines()]
    assert line["error"]["exit_code"] == 6
    assert line["error"]["kind"] == "component"
    assert "pip install no_such_package" in line["error"]["message"]


def test_it_looks_for_what_the_package_asks_for():
    project = tomllib.loads(Path("pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert list(doctor._NEEDED) == [re.split("[><=[]", line)[0] for line in project["dependencies"]]
    for extra, name in doctor._EXTRAS.items():
        assert any(name in line for line in project["optional-dependencies"][extra])


def test_an_extra_that_is_not_there_is_no_fault(monkeypatch):
    monkeypatch.setattr(doctor, "_EXTRAS", {"more": "no_such_package"})
    (check,) = [c for c in json.loads(run("--json").stdout)["result"]["checks"] if c["name"] == "extra more"]
    assert check["state"] == "ok"
    assert 'pip install ".[more]"' in check["text"]


def test_foreign_data_of_proj_are_found_out(monkeypatch):
    """A wrong PROJ_DATA makes every transformation wrong or fail; here the known point is 7 m off."""
    import pyproj

    class Wrong:
        def transform(self, x, y):
            return 500_007.0, 0.0

    monkeypatch.setattr(pyproj.Transformer, "from_crs", lambda *_, **__: Wrong())
    (check,) = doctor._coordinates()
    assert check.state == "broken"
    assert "7 m off" in check.text


@pytest.mark.parametrize("error", [ImportError("libgdal"), RuntimeError("wrong"), OSError("x")])
def test_a_check_that_fails_is_a_finding(error):
    def _formats():
        yield Check("first", "ok", "")
        raise error

    found = doctor._answers(_formats)
    assert [c.state for c in found] == ["ok", "broken"]
    assert str(error) in found[1].text


def test_an_unwritable_cache_is_warned_of(monkeypatch, tmp_path):
    (tmp_path / "file").write_text("in the way")
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path / "file"))
    (check,) = doctor._cache()
    assert check.state == "warning"
    assert "NUMBA_CACHE_DIR" in check.text
