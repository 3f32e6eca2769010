"""Texts and units of columns inside a GeoPackage, where QGIS and GDAL read them as aliases."""

from __future__ import annotations

import sqlite3
from collections.abc import Iterable, Mapping

from firebreak_gis.errors import OutputError
from firebreak_gis.schema import COLUMNS

#: Table and registration of the schema extension, OGC 12-128r15, annex F.9.
_TABLE = """CREATE TABLE gpkg_data_columns (
 table_name TEXT NOT NULL, column_name TEXT NOT NULL, name TEXT, title TEXT, description TEXT, mime_type TEXT,
 constraint_name TEXT, CONSTRAINT pk_gdc PRIMARY KEY (table_name, column_name),
 CONSTRAINT gdc_tn UNIQUE (table_name, name))
"""
_EXTENSIONS = """CREATE TABLE IF NOT EXISTS gpkg_extensions (
 table_name TEXT, column_name TEXT, extension_name TEXT NOT NULL, definition TEXT NOT NULL, scope TEXT NOT NULL,
 CONSTRAINT ge_tce UNIQUE (table_name, column_name, extension_name))
"""
_REGISTRATION = (
    "gpkg_data_columns",
    None,
    "gpkg_schema",
    "http://www.geopackage.org/spec121/#extension_schema",
    "read-write",
)


def with_aliases(content: bytes | memoryview, layers: Mapping[str, Iterable[str]]) -> bytes:
    """Return a GeoPackage that names its columns for people, with units, as `schema.COLUMNS` does.

    Parameters
    ----------
    content
        Of the file.
    layers
        Columns by layer; those that the schema does not know keep their names.

    Raises
    ------
    OutputError
        If it is no database.
    """
    rows = [
        (layer, name, COLUMNS[name].alias, COLUMNS[name].text, COLUMNS[name].unit or None)
        for layer, names in layers.items()
        for name in names
        if name in COLUMNS
    ]
    if not rows:
        return bytes(content)
    base = sqlite3.connect(":memory:")
    try:
        base.deserialize(bytes(content))
        with base:
            base.execute(_TABLE)
            base.execute(_EXTENSIONS)
            base.execute("INSERT INTO gpkg_extensions VALUES (?, ?, ?, ?, ?)", _REGISTRATION)
            base.executemany(
                "INSERT INTO gpkg_data_columns (table_name, column_name, name, title, description) "
                "VALUES (?, ?, ?, ?, ?)",
                rows,
            )
        return base.serialize()
    except sqlite3.Error as error:
        raise OutputError(f"the GeoPackage cannot be made: {error}; is the disk full?") from error
    finally:
        base.close()
