"""Print the version that `firebreak_gis/__init__.py` tells; nothing is imported."""

import re
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[1] / "firebreak_gis" / "__init__.py"

found = re.search(r'^__version__ = "([^"]+)"$', SOURCE.read_text(encoding="utf-8"), re.MULTILINE)
if found is None:
    raise SystemExit(f"{SOURCE} tells no version")
print(found[1])
