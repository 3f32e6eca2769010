"""firebreak doctor: whether everything is here that the work needs."""

from __future__ import annotations

import importlib.metadata
import os
import platform
import shutil
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass
from pathlib import Path

import click

import firebreak_gis
from firebreak_gis.cli import options
from firebreak_gis.cli.session import Session
from firebreak_gis.errors import FirebreakError, MissingComponentError
from firebreak_gis.memory import DEFAULT_SHARE, memory_limit
from firebreak_gis.threads import thread_count

#: Packages that the program cannot do without.
_NEEDED = (
    "numpy",
    "scipy",
    "numba",
    "xarray",
    "rioxarray",
    "rasterio",
    "pyproj",
    "affine",
    "shapely",
    "geopandas",
    "pyogrio",
    "click",
    "matplotlib",
    "pillow",
)
_IMPORTED = {"pillow": "PIL"}
#: Extras for those who run it, and a package that tells whether each is there.
_EXTRAS = {"scale": "distributed", "maps": "folium"}
#: Formats of rasters: written, and read where users have them.
_DRIVERS_NEEDED = ("GTiff", "COG", "VRT")
_DRIVERS_WANTED = ("AAIGrid", "LCP", "netCDF", "HFA")
_LITTLE_DISK = 1 << 30


@dataclass(frozen=True)
class Check:
    """One thing looked at.

    Parameters
    ----------
    name
        What.
    state
        `ok`, `warning` (a feature is missing or slow) or `broken`.
    text
        What was found, and what to do.
    """

    name: str
    state: str
    text: str


@click.command("doctor")
@options.common
def command(session: Session) -> None:
    """Look whether all is here: packages, GDAL and PROJ data, compiler cache, threads, memory, disk; run a small test.

    Exit code 6 if a component is missing or broken.
    """
    checks = []
    steps: tuple[Callable[[], Iterator[Check]], ...] = (
        _packages,
        _formats,
        _coordinates,
        _vectors,
        _cache,
        _machine,
        _small_run,
    )
    for i, step in enumerate(steps):
        session.progress(i / len(steps), step.__name__.strip("_").replace("_", " "))
        checks += _answers(step)
    lines = [f"{check.state:8} {check.name:16} {check.text}" for check in checks]
    broken = [check for check in checks if check.state == "broken"]
    if broken:
        session.say("\n".join(lines))
        told = "; ".join(f"{check.name}: {check.text}" for check in broken)
        raise MissingComponentError(f"{told}. Install the program anew, in an environment of its own")
    session.finish({"healthy": True, "checks": [asdict(check) for check in checks]}, "\n".join(lines))


def _answers(step: Callable[[], Iterator[Check]]) -> list[Check]:
    """Run a step to its end; a step that fails is itself a finding."""
    found: list[Check] = []
    try:
        found.extend(step())
    except (ImportError, OSError, RuntimeError, ValueError, AttributeError, FirebreakError) as error:
        found.append(Check(step.__name__.strip("_").replace("_", " "), "broken", f"{type(error).__name__}: {error}"))
    return found


def _packages() -> Iterator[Check]:
    yield Check("firebreak_gis", "ok", f"{firebreak_gis.__version__}, Python {platform.python_version()}")
    for name in _NEEDED:
        try:
            importlib.import_module(_IMPORTED.get(name, name))
            yield Check(name, "ok", importlib.metadata.version(name))
        except (ImportError, OSError, importlib.metadata.PackageNotFoundError) as error:
            yield Check(name, "broken", f"cannot be loaded ({error}); pip install {name}")
    for extra, name in _EXTRAS.items():
        try:
            yield Check(f"extra {extra}", "ok", f"{name} {importlib.metadata.version(name)}")
        except importlib.metadata.PackageNotFoundError:
            yield Check(f"extra {extra}", "ok", f'not installed; what wants it says so; pip install ".[{extra}]"')


def _formats() -> Iterator[Check]:
    import rasterio

    with rasterio.Env() as environment:
        drivers = environment.drivers()
    lacking = [name for name in _DRIVERS_NEEDED if name not in drivers]
    if lacking:
        yield Check("GDAL", "broken", f"GDAL {rasterio.__gdal_version__} lacks {', '.join(lacking)}")
    else:
        yield Check("GDAL", "ok", f"{rasterio.__gdal_version__} with {len(drivers)} formats")
    without = [name for name in _DRIVERS_WANTED if name not in drivers]
    if without:
        yield Check("formats", "warning", f"{', '.join(without)} cannot be read; convert such files first")


def _coordinates() -> Iterator[Check]:
    """The central meridian of a UTM zone has x = 500000; both libraries must know the zone."""
    import pyproj
    from rasterio.warp import transform as gdal_transform

    x, y = pyproj.Transformer.from_crs(4326, 32635, always_xy=True).transform(27.0, 0.0)
    gdal_x, gdal_y = gdal_transform("EPSG:4326", "EPSG:32635", [27.0], [0.0])
    off = max(abs(x - 500_000), abs(y), abs(gdal_x[0] - 500_000), abs(gdal_y[0]))
    state = "ok" if off < 1e-3 else "broken"
    where = "" if state == "ok" else f"; a known point is {off:.3g} m off: is PROJ_DATA or GDAL_DATA set for others?"
    yield Check("PROJ", state, f"{pyproj.proj_version_str}, data in {pyproj.datadir.get_data_dir()}{where}")


def _vectors() -> Iterator[Check]:
    import pyogrio

    drivers = pyogrio.list_drivers()
    written = "w" in drivers.get("GPKG", "")
    yield Check("vectors", "ok" if written else "broken", f"{len(drivers)} formats" if written else "no GeoPackage")


def _cache() -> Iterator[Check]:
    """Where the compiled kernels are kept; without that every run compiles for a minute."""
    own = Path(firebreak_gis.__file__).parent / "kernels" / "__pycache__"
    folder = Path(os.environ.get("NUMBA_CACHE_DIR") or own)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            pass
        yield Check("compiler cache", "ok", str(folder))
    except OSError as error:
        text = f"{folder} cannot be written ({error.strerror}); set NUMBA_CACHE_DIR to a folder of yours"
        yield Check("compiler cache", "warning", text)


def _machine() -> Iterator[Check]:
    yield Check("threads", "ok", f"{thread_count(None)} (FIREBREAK_THREADS chooses)")
    limit = memory_limit()
    yield Check(
        "memory", "ok", f"{limit / 1e9:.3g} GB, of which {DEFAULT_SHARE:.0%} are used unless --max-memory is given"
    )
    free = shutil.disk_usage(Path.cwd()).free
    state = "ok" if free > _LITTLE_DISK else "warning"
    yield Check("disk", state, f"{free / 1e9:.3g} GB free in {Path.cwd()}")


def _small_run() -> Iterator[Check]:
    """Rank, cut, burn and write a small forest; what must hold for any forest is checked."""
    import numpy as np

    from firebreak_gis.breaks import select_breaks
    from firebreak_gis.ranking import rank
    from firebreak_gis.rasters import read_variable, write_raster
    from firebreak_gis.simulation.fires import simulate
    from firebreak_gis.spread import spread_network
    from firebreak_gis.spread.artificial import forest

    network = spread_network(forest((12, 15)), model="artificial")
    breaks = select_breaks(rank(network, "degree"), budget=0.1, burnable=network.burnable)
    before, after = (simulate(network, breaks=mask, n_runs=20) for mask in (None, breaks))
    with tempfile.TemporaryDirectory() as folder:
        path = write_raster(Path(folder) / "breaks.tif", breaks)
        same = np.array_equal(read_variable(path, "breaks", unreferenced=True), breaks)
    fewer = bool((after["fire_size"] <= before["fire_size"]).all())
    good = same and fewer and int(breaks.sum()) == round(0.1 * network.n_burnable)
    text = "a small forest was ranked, cut, burnt, written and read" if good else "a small forest gave a wrong result"
    yield Check("small run", "ok" if good else "broken", text)
