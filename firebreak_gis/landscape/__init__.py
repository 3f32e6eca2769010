"""Any rasters to one landscape on one square grid: read, written to a folder, read back."""

from firebreak_gis.landscape.folder import read_landscape_folder, write_landscape
from firebreak_gis.landscape.reading import memory_needed, read_landscape

__all__ = ["memory_needed", "read_landscape", "read_landscape_folder", "write_landscape"]
