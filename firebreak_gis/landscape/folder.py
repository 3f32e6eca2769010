"""A landscape as a folder of rasters: what `firebreak align` writes and the later commands read."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from firebreak_gis.errors import InputError
from firebreak_gis.files.commit import unfinished
from firebreak_gis.files.outputs import Output, Writing, write_all
from firebreak_gis.grid import Grid
from firebreak_gis.landscape.fuel import INSTEAD, LAYERS, burnable_cells
from firebreak_gis.rasters import VariableFile, write_blocks
from firebreak_gis.rasters.blocks import rows_of
from firebreak_gis.schema import annotate, validate

if TYPE_CHECKING:
    import xarray as xr

    from firebreak_gis.rasters.reading import Window as Rectangle


def write_landscape(
    dataset: xr.Dataset,
    folder: str | os.PathLike[str],
    *,
    overwrite: bool = False,
    provenance: Mapping[str, Any] | None = None,
    forbid: Iterable[str | os.PathLike[str]] = (),
    creation_options: Mapping[str, Any] | None = None,
) -> list[Path]:
    """Write the layers of a landscape as elevation.tif, vegetation.tif, density.tif, and numbers that a legend gives.

    Parameters
    ----------
    dataset
        From `read_landscape`.
    folder
        Made if it is missing.
    overwrite, provenance, forbid, creation_options
        As in `rasters.write_raster`; nothing is written if one of the files must not be.

    Returns
    -------
    list of pathlib.Path
        The files, in order.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> files = fb.write_landscape(fb.read_landscape(**fb.sample_layers(), resolution=250.0), "land")
    >>> [file.name for file in files]
    ['elevation.tif', 'vegetation.tif', 'density.tif']
    """
    how = Writing(overwrite, forbid=list(forbid), creation_options=creation_options or {}, tags=provenance or {})
    return write_all(OUTPUTS, dataset, folder, how, variables=dataset)


def _layer(name: str, label: str, needs: str = "") -> Output[xr.Dataset]:
    def write(dataset: xr.Dataset, path: Path, how: Writing) -> None:
        told: dict[str, Any] = {}
        if name == LAYERS[0]:
            told = {key: list(dataset.attrs[key]) for key in ("alignment", "warnings") if key in dataset.attrs}
            told |= {"legend": dataset.attrs["legend"]} if "legend" in dataset.attrs else {}
        write_blocks(
            path,
            _blocks(dataset, name),
            Grid.of(dataset),
            overwrite=how.overwrite,
            forbid=how.forbid,
            creation_options=how.creation_options,
            provenance={**how.tags, **told},
        )

    return Output(f"{name}.tif", label, write, needs)


def _blocks(dataset: xr.Dataset, name: str) -> Iterator[tuple[int, xr.Dataset]]:
    """Rows of a layer, looked at; all of them together unless there are very many."""
    # What is wrong with any layer is told before the first is written.
    looked_at = [*LAYERS, *(other for other in INSTEAD if other in dataset)] if name == LAYERS[0] else [name]
    for row, part in rows_of(dataset):
        validate(part, looked_at)
        yield row, part[[name]]


_LABELS = {
    "elevation": "Elevation on the common grid",
    "vegetation": "Vegetation classes on the common grid",
    "density": "Density classes on the common grid",
    "vegetation_effect": "Effect of the vegetation, where the legend gives numbers in place of classes",
    "density_effect": "Effect of the density, where the legend gives numbers in place of classes",
    "rate": "Rate of spread on flat calm dry ground, where the legend gives it",
    "dead_load": "Load of dead fuel, where the legend gives it",
    "live_load": "Load of live fuel, where the legend gives it",
    "heat_content": "Heat content of the fuel, where the legend gives it",
    "live_moisture": "Moisture of the live fuel, where the legend gives it",
}

#: A landscape as files; what only some legends give is written where it is there.
OUTPUTS: tuple[Output[xr.Dataset], ...] = tuple(
    _layer(name, _LABELS[name], name if name in INSTEAD else "") for name in LAYERS + INSTEAD
)


def read_landscape_folder(folder: str | os.PathLike[str]) -> xr.Dataset:
    """Read what `write_landscape` wrote; equal to the dataset that was written.

    Raises
    ------
    InputError
        If a layer is missing or damaged; `GridError` if the layers lie on different grids.

    Examples
    --------
    >>> import firebreak_gis as fb
    >>> landscape = fb.read_landscape(**fb.sample_layers(), resolution=250.0)
    >>> files = fb.write_landscape(landscape, "land")
    >>> bool((fb.read_landscape_folder("land")["elevation"] == landscape["elevation"]).all())
    True
    """
    return LandscapeFolder(folder).read()


class LandscapeFolder:
    """A landscape in files, read as a whole or by windows.

    Parameters
    ----------
    folder
        What `write_landscape` wrote.

    Attributes
    ----------
    grid : Grid
        Of the whole landscape.

    Raises
    ------
    InputError, GridError
        As `read_landscape_folder`; without reading the cells.
    """

    def __init__(self, folder: str | os.PathLike[str]) -> None:
        place = Path(folder)
        self._files = {name: VariableFile(place / f"{name}.tif", name) for name in _layers_in(place)}
        self.grid = self._files["elevation"].grid
        self.grid.cell_size  # noqa: B018 - refuses cells that are not square
        for name, file in self._files.items():
            self.grid.require(file.grid, f"{name}.tif")

    def read(self, window: Rectangle | None = None) -> xr.Dataset:
        """Read the landscape, or a window (row, column, rows, columns) of it."""
        import xarray as xr

        grid = self.grid if window is None else self._files["elevation"].part(window)
        told = self._files["elevation"].provenance
        variables = {name: annotate(grid.dataarray(file.read(window), name)) for name, file in self._files.items()}
        dataset = xr.Dataset(variables)
        dataset["burnable"] = annotate(grid.dataarray(burnable_cells(dataset), "burnable"))
        dataset.attrs = {"legend": told["legend"]} if "legend" in told else {}
        dataset.attrs |= {key: json.loads(told.get(key, "[]")) for key in ("alignment", "warnings")}
        return dataset


def _layers_in(place: Path) -> list[str]:
    """Names of the layers in a folder."""
    if not place.is_dir():
        raise InputError(
            f"{place} is not a folder with {', '.join(f'{name}.tif' for name in LAYERS)}; make one with: "
            f"firebreak align"
        )
    if unfinished(place / f"{name}.tif" for name in LAYERS + INSTEAD):
        raise InputError(
            f"a run was killed while it replaced the landscape in {place}, the layers may be of two runs; make it "
            "again with: firebreak align --overwrite"
        )
    missing = [f"{name}.tif" for name in LAYERS if not (place / f"{name}.tif").exists()]
    if missing:
        raise InputError(f"the landscape folder {place} lacks {', '.join(missing)}; make it with: firebreak align")
    return list(LAYERS) + [name for name in INSTEAD if (place / f"{name}.tif").exists()]
