#!/usr/bin/env bash
# Makes the pictures of README and docs anew, where the default plan or the page has changed:
#
#   tests/pictures.sh [PYTHON]     needs what the tests of browser and QGIS need, see .ci/run; then look at what it made
#
# comparison.png, named.png and timed_plans.png show real landscapes and have commands of their own, beside them in the docs.
set -euo pipefail
cd "$(dirname "$0")/.."
python=${1:-$PWD/.venv/bin/python}
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
sample=(sample_data/dem.tif sample_data/vegetation.tif sample_data/density.tif)
small() { convert "$1" -strip -dither None -colors 256 -define png:compression-level=9 "$2"; }

"$python" -m firebreak_gis plan "${sample[@]}" -o "$place/plan" -q
small "$place/plan/overview.png" sample_data/pictures/overview.png
"$python" tests/browser/picture.py "$place/plan/report.html" "$place/report.png"
small "$place/report.png" sample_data/pictures/report.png

"$python" -m firebreak_gis mapbook "$place/plan" -o "$place/book.pdf" --pages 36 -q
"$python" - "$place/book.pdf" "$place/mapbook.png" <<'END'
import sys

import pypdfium2

book = pypdfium2.PdfDocument(sys.argv[1])
book[len(book) - 1].render(scale=1.2).to_pil().save(sys.argv[2])
END
small "$place/mapbook.png" sample_data/pictures/mapbook.png
FIREBREAK_PYTHON=$python tests/qgis/screenshot.sh
