"""QGIS' own Python never imports what would break it, and the plugin leaves nothing behind."""

from __future__ import annotations

import os
import subprocess
import sys

from conftest import QUICK, ROOT

#: Libraries whose wheels crash QGIS.
HARMFUL = ("rasterio", "numba", "geopandas", "shapely", "pyproj", "pyogrio", "xarray", "firebreak_gis")

SESSION = """
import sys
from types import SimpleNamespace
from qgis.core import QgsApplication, QgsProcessingContext, QgsProcessingFeedback
from qgis.PyQt.QtWidgets import QMainWindow

application = QgsApplication([], True)
application.initQgis()
import firebreak

said, window = [], QMainWindow()
names = ("registerOptionsWidgetFactory", "unregisterOptionsWidgetFactory", "addPluginToMenu", "removePluginMenu")
iface = SimpleNamespace(mainWindow=lambda: window, showOptionsDialog=lambda parent, page: said.append(page),
                        **{name: (lambda *_, name=name: said.append(name)) for name in names})
plugin = firebreak.classFactory(iface)
registry = QgsApplication.processingRegistry()
assert registry.providerById("firebreak") is None
plugin.initGui()
plugin._action.trigger()
algorithm = registry.createAlgorithmById("firebreak:plan")
assert algorithm.canExecute()[0]
context, feedback = QgsProcessingContext(), QgsProcessingFeedback()
results, ok = algorithm.run(PARAMETERS, context, feedback)
assert ok, feedback.textLog()
plugin.unload()
assert registry.providerById("firebreak") is None
assert said == ["registerOptionsWidgetFactory", "addPluginToMenu", "firebreakOptions", "removePluginMenu",
                "unregisterOptionsWidgetFactory"], said
print("harmful:", [name for name in HARMFUL if name in sys.modules])
sys.stdout.flush()
application.exitQgis()
"""


def test_no_harmful_import_in_a_session(layers, tmp_path):
    """A trap lies on the path for every harmful library; a whole session runs past them."""
    traps, mark = tmp_path / "traps", tmp_path / "sprung"
    traps.mkdir()
    for name in HARMFUL:
        (traps / f"{name}.py").write_text(f"open({str(mark)!r}, 'a').write({name!r})")
    parameters = {**layers, **QUICK, "METHOD": "degree", "OUTPUT_BREAKS": str(tmp_path / "breaks.tif")}
    code = SESSION.replace("PARAMETERS", repr(parameters)).replace("HARMFUL", repr(HARMFUL))
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join((str(traps), str(ROOT / "qgis_plugin")))}
    command = [sys.executable, "-c", code]
    run = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    assert "harmful: []" in run.stdout
    assert not mark.exists()
    assert (tmp_path / "breaks.tif").is_file()
