"""Landscapes that several test files share: small made-up ones, and the sample landscape."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from affine import Affine

from firebreak_gis.grid import Grid, parse_crs
from firebreak_gis.schema import annotate
from tests.compiled import pytest_sessionstart  # noqa: F401
from tests.no_skips import pytest_addoption, pytest_configure  # noqa: F401
from tests.trials import all_fires_where_marked, fewer_fires  # noqa: F401

ROOT = Path(__file__).resolve().parents[1]
SAMPLE = ROOT / "sample_data"
#: The smallest PNG.
PIXEL = bytes.fromhex(
    "89504e470d0a1a0a0000000d49484452000000010000000108000000003a7e9b55"
    "0000000a49444154789c6360000000020001737501180000000049454e44ae426082"
)

Make = Callable[..., xr.Dataset]


def _landscape(
    shape: tuple[int, int] = (9, 14),
    seed: int = 0,
    *,
    boundary: str = "open",
    cell: float = 20.0,
    holes: float = 0.2,
    relief: float = 15.0,
    crs: str | None = "EPSG:32635",
    **layers: object,
) -> xr.Dataset:
    """Rough terrain under random fuel with holes; `layers` replaces single ones (a number or an array)."""
    random = np.random.default_rng(seed)
    grid = Grid(shape, Affine(cell, 0, 586_440.0, 0, -cell, 3_999_900.0), crs and parse_crs(crs))
    vegetation = random.integers(1, 4, shape).astype(np.uint8)
    density = random.integers(1, 4, shape).astype(np.uint8)
    gaps = random.random(shape) < holes
    vegetation[gaps] = density[gaps] = 0
    values = {
        "elevation": (relief * random.standard_normal(shape)).astype(np.float32),
        "vegetation": vegetation,
        "density": density,
        "burnable": ~gaps,
    }
    kinds = dict.fromkeys(("vegetation_effect", "density_effect", "rate", "dead_load", "live_load"), "float32")
    kinds |= dict.fromkeys(("heat_content", "live_moisture"), "float32")
    for name, value in layers.items():
        kind = values[name].dtype if name in values else kinds[name]
        values[name] = np.broadcast_to(np.asarray(value, dtype=kind), shape).copy()
    data = {name: annotate(grid.dataarray(array, name)) for name, array in values.items()}
    return xr.Dataset(data, attrs={"boundary": boundary, "alignment": [], "warnings": []})


@pytest.fixture(scope="session")
def make_landscape() -> Make:
    """Function that makes a small landscape; not square, with holes in the fuel."""
    return _landscape


@pytest.fixture(scope="session")
def sample_paths() -> dict[str, str]:
    """Paths of the three layers of the sample landscape."""
    return {name: str(SAMPLE / f"{name}.tif") for name in ("dem", "vegetation", "density")}


@pytest.fixture(scope="session")
def sample(sample_paths: dict[str, str]) -> xr.Dataset:
    """The sample landscape in cells of 60 m; treat as read-only."""
    from firebreak_gis.landscape import read_landscape

    return read_landscape(**sample_paths, crs="EPSG:32635", resolution=60.0)


@pytest.fixture
def shared_data() -> Path:
    """Folder of the real landscapes; skips where it is absent."""
    folder = ROOT.parent / "shared" / "data"
    if not folder.is_dir():
        pytest.skip("the real landscapes are not here")
    return folder


@pytest.fixture
def no_pictures(monkeypatch: pytest.MonkeyPatch) -> None:
    """Figures are not drawn, but saved as one pixel: for tests that make many plans and look at no picture of them."""
    from firebreak_gis.files import write_bytes
    from firebreak_gis.report import figures

    def save(figure: object, path: Path, *, overwrite: bool = False, dpi: int = 150) -> Path:
        write_bytes(Path(path), PIXEL, overwrite=overwrite)
        return Path(path)

    monkeypatch.setattr(figures, "save", save)
