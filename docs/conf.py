"""The site: pages by hand, the reference made from the code, notebooks executed. Warnings are errors, see build.sh."""

import os
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import reference  # noqa: E402

import firebreak_gis  # noqa: E402

reference.write(HERE / "generated")

project = "firebreak_gis"
author = "the firebreak_gis developers"
release = version = firebreak_gis.__version__
extensions = ["myst_nb", "sphinx.ext.autodoc", "numpydoc"]
exclude_patterns = ["_build", "README.md"]
html_theme = "furo"
html_title = f"firebreak_gis {release}"
html_show_copyright = False
html_static_path = ["_static"]
html_css_files = ["site.css"]
nitpicky = True
smartquotes = False  # options begin with two hyphens

myst_heading_anchors = 3
myst_enable_extensions = ["colon_fence"]

nb_execution_mode = "force"
nb_execution_raise_on_error = True
nb_execution_timeout = 120
os.environ.setdefault("FIREBREAK_SAMPLE", str(HERE.parent / "sample_data"))

# Types stand in the signature as the code has them; texts of docstrings say shapes and units.
autodoc_typehints = "none"
autodoc_member_order = "bysource"
numpydoc_show_class_members = False
numpydoc_xref_param_type = False
