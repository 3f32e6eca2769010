#!/usr/bin/env bash
# Takes the picture of the README: the real window under Xvfb, the plan made by the plugin.
#
#   FIREBREAK_PYTHON=/path/to/python tests/qgis/screenshot.sh [PICTURE]
set -euo pipefail

root=$(cd "$(dirname "$0")/../.." && pwd)
picture=${1:-$root/qgis_plugin/screenshot.png}
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT

mkdir -p "$place/firebreak_gis/qgis_plugin" "$place/config" "$place/run"
cp -r "$root/sample_data" "$place/firebreak_gis/"
cp -r "$root/qgis_plugin/sample" "$place/firebreak_gis/qgis_plugin/"
chmod 700 "$place/run"
export XDG_RUNTIME_DIR=$place/run QGIS_CUSTOM_CONFIG_PATH=$place/config QGIS_PLUGINPATH=$root/qgis_plugin
export SHOT_PROJECT=$place/firebreak_gis/qgis_plugin/sample/sample_landscape.qgs SHOT_PICTURE=$place/shot.png
export PYTHONDONTWRITEBYTECODE=1
unset PYTHONPATH
export PATH=/usr/bin:$PATH  # see run.sh

QT_QPA_PLATFORM=offscreen qgis_process.bin plugins enable firebreak >/dev/null 2>&1
env -u QT_QPA_PLATFORM timeout 120 xvfb-run -a -s "-screen 0 1600x1000x24" \
  qgis.bin --nologo --noversioncheck --code "$root/tests/qgis/shot.py" >"$place/log" 2>&1 || { cat "$place/log"; exit 1; }
convert "$place/shot.png" -strip -dither None -colors 256 -define png:compression-level=9 "$picture"
