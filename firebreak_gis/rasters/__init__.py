"""Reading and writing rasters: the only package that opens them."""

from firebreak_gis.rasters.blocks import write_blocks
from firebreak_gis.rasters.header import (
    Header,
    header_of_array,
    read_header,
    require_georeferenced,
    with_crs,
)
from firebreak_gis.rasters.naming import file_of
from firebreak_gis.rasters.opening import files_behind, open_raster
from firebreak_gis.rasters.reading import (
    Cells,
    VariableFile,
    read_cells,
    read_raster,
    read_variable,
    read_variables,
    require_role,
    variable_bands,
)
from firebreak_gis.rasters.writing import disk_dtype, write_raster

__all__ = [
    "Cells",
    "Header",
    "VariableFile",
    "disk_dtype",
    "file_of",
    "files_behind",
    "header_of_array",
    "open_raster",
    "read_cells",
    "read_header",
    "read_raster",
    "read_variable",
    "read_variables",
    "require_georeferenced",
    "require_role",
    "variable_bands",
    "with_crs",
    "write_blocks",
    "write_raster",
]
