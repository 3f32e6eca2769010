#!/usr/bin/env bash
# Makes the pictures of README and docs anew, where the default plan or the page has changed:
#
#   tests/pictures.sh [PYTHON [RHODES]]     needs what the tests of browser and QGIS need, see .ci/run; then look at what it made
#
# RHODES is the folder with rhodes_dem.tif, rhodes_vegetation.tif and rhodes_density.tif, for the map of its lines.
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

page() {  # of a map book: BOOK NUMBER SCALE PICTURE
    "$python" - "$1" "$2" "$3" "$place/page.png" <<'END'
import sys

import pypdfium2

file, number, scale, picture = sys.argv[1:]
book = pypdfium2.PdfDocument(file)
book[int(number) % len(book)].render(scale=float(scale)).to_pil().save(picture)
END
    small "$place/page.png" "$4"
}
"$python" -m firebreak_gis mapbook "$place/plan" -o "$place/book.pdf" --pages 36 -q
page "$place/book.pdf" -1 1.2 sample_data/pictures/mapbook.png

lines() {  # of a plan, as the first page of its map book shows them: PICTURE FOLDER LAYERS AND OPTIONS
    "$python" -m firebreak_gis plan "${@:3}" --budget 5% --runs 300 --wind-speed 5 --wind-from 315 -o "$place/$2" -q
    "$python" -m firebreak_gis mapbook "$place/$2" -o "$place/$2.pdf" -q
    page "$place/$2.pdf" 0 1.45 "$1"
}
lines sample_data/pictures/lines_sample.png sample "${sample[@]}" --roads sample_data/roads.gpkg
if [ -n "${2:-}" ]; then
    lines sample_data/pictures/lines_rhodes.png rhodes "$2"/rhodes_{dem,vegetation,density}.tif --res 40
fi
FIREBREAK_PYTHON=$python tests/qgis/screenshot.sh
