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


def _cheapest(code):
    """Least processor time in s of three whole programs that run `code`."""
    code = f"import sys, time\ntry: {code}\nfinally: print(time.process_time(), file=sys.stderr)"
    done = [subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True) for _ in range(3)]
    return min(float(one.stderr) for one in done), done[0].stdout


def test_help_answers_soon():
    """In the processor time of a few imports of numpy, which it needs: some 3.5 when the bound was set."""
    bound, _ = _cheapest("import numpy")
    took, said = _cheapest("sys.argv = ['firebreak', '--help']; from firebreak_gis.cli import main; main()")
    assert "Usage: " in said
    assert took < 5 * bound
