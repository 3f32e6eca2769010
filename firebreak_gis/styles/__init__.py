"""QGIS styles (.qml) of what is written, one module for rasters and one for vectors."""
