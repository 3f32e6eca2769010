"""Any rasters to one landscape on one square grid: read, written to a folder, read back."""

from firebreak_gis.landscape.folder import read_landscape_folder, write_landscape
from firebreak_gis.landscape.reading import read_landscape, read_surveyed
from firebreak_gis.landscape.surveying import Survey, memory_needed, survey

__all__ = [
    "Survey",
    "memory_needed",
    "read_landscape",
    "read_landscape_folder",
    "read_surveyed",
    "survey",
    "write_landscape",
]
