#!/usr/bin/env bash
# The plugin in a real QGIS: suite and smoke test. The packages of apt-packages.txt must be there.
#
#   tests/qgis/run.sh [FOLDER]     FOLDER keeps the two environments between runs (default: a temporary one)
#
# FIREBREAK_PYTHON, if set, is taken as the engine in place of a new one.
set -euo pipefail

root=$(cd "$(dirname "$0")/../.." && pwd)
place=${1:-$(mktemp -d)}
[ $# -ge 1 ] || trap 'rm -rf "$place"' EXIT
mkdir -p "$place"

# Not `python3`: a test runs where PATH may name another Python than the one PyQGIS was built for.
system=/usr/bin/python3
[ -x "$place/qgis/bin/pytest" ] || {
  "$system" -m venv --system-site-packages "$place/qgis"
  "$place/qgis/bin/pip" install -q pytest pytest-qgis
}
if [ -z "${FIREBREAK_PYTHON:-}" ]; then
  FIREBREAK_PYTHON=$place/engine/bin/python
  [ -x "$FIREBREAK_PYTHON" ] || "$system" -m venv "$place/engine"
  "$place/engine/bin/pip" install -q "$root"
fi
export FIREBREAK_PYTHON

unset PYTHONPATH
# The Python inside qgis_process takes its libraries from beside the first python3 on the way: with an environment
# active that is the wrong one.
export PATH=/usr/bin:$PATH
export QT_QPA_PLATFORM=offscreen PYTHONDONTWRITEBYTECODE=1
XDG_RUNTIME_DIR=$(mktemp -d)
QGIS_CUSTOM_CONFIG_PATH=$(mktemp -d)
export XDG_RUNTIME_DIR QGIS_CUSTOM_CONFIG_PATH
chmod 700 "$XDG_RUNTIME_DIR"

echo "-- algorithms, desktop, isolation"
"$place/qgis/bin/python" -m pytest -c "$root/tests/qgis/pytest.ini" --rootdir "$root/tests/qgis" "$root/tests/qgis" -q -p no:cacheprovider

echo "-- qgis_process"
"$system" "$root/tests/qgis/smoke.py"
