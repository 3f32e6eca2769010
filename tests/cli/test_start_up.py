"""Importing costs nothing until something is used."""

import subprocess
import sys

import pytest

HEAVY = ("numba", "xarray", "rasterio", "geopandas", "rioxarray", "matplotlib", "scipy", "pandas", "shapely", "dask")
_REPORT = f"import sys; print(','.join(n for n in {HEAVY!r} if n in sys.modules))"


def loaded(code):
    """Heavy packages that a fresh interpreter holds after `code`."""
    done = subprocess.run([sys.executable, "-c", f"{code}; {_REPORT}"], capture_output=True, text=True, check=True)
    return done.stdout.strip().splitlines()[-1:] or [""]


@pytest.mark.parametrize(
    "code",
    [
        "import firebreak_gis",
        "import firebreak_gis.cli",
        "from firebreak_gis import plugins; plugins.names('ranking')",
        "import firebreak_gis.kernels",
    ],
)
def test_nothing_heavy_is_imported(code):
    assert loaded(code) == [""]


def test_help_imports_nothing_heavy():
    code = (
        "from click.testing import CliRunner; from firebreak_gis.cli import firebreak; "
        "outcome = CliRunner().invoke(firebreak, ['plan', '--help']); assert outcome.exit_code == 0"
    )
    assert loaded(code) == [""]


def test_every_public_name_is_there():
    import firebreak_gis

    for name in firebreak_gis.__all__:
        assert getattr(firebreak_gis, name) is not None
    assert set(firebreak_gis.__all__) <= set(dir(firebreak_gis))
    with pytest.raises(AttributeError, match="nothing_like_that"):
        _ = firebreak_gis.nothing_like_that


def test_help_answers_soon():
    """Processor time of the whole program, twice the 0.3 s that are asked for, since other machines are slower."""
    code = (
        "import sys, time; sys.argv = ['firebreak', '--help']\n"
        "from firebreak_gis.cli import main\n"
        "try: main()\n"
        "finally: print(time.process_time(), file=sys.stderr)"
    )
    taken = []
    for _ in range(3):
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
        assert "Usage: " in done.stdout
        taken.append(float(done.stderr))
    assert min(taken) < 0.6
