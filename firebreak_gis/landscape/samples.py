"""The sample landscape that comes with the package."""

from __future__ import annotations

from pathlib import Path

from firebreak_gis.errors import MissingComponentError


def sample_layers() -> dict[str, str]:
    """Return the paths of the sample rasters: elevation, vegetation and density, 268 x 404 cells of about 30 m.

    Returns
    -------
    dict
        `dem`, `vegetation`, `density`, as `read_landscape` takes them; from the installed package or the clone.

    Raises
    ------
    MissingComponentError
        If the package was installed without them.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> fb.read_landscape(**fb.sample_layers(), resolution=200.0).attrs["legend"]
    'paper'
    """
    package = Path(__file__).resolve().parents[1]
    for folder in (package / "sample_data", package.parent / "sample_data"):
        if (folder / "dem.tif").is_file():
            return {name: str(folder / f"{name}.tif") for name in ("dem", "vegetation", "density")}
    raise MissingComponentError("the sample data is not installed; give rasters of your own")
