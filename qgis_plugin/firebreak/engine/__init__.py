"""Finding, making and driving the engine: the command line of firebreak_gis in its own environment.

Nothing here imports QGIS, so all of it is tested in any Python.
"""
