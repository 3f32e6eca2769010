#!/usr/bin/env bash
# The report page in a real browser. Needs the packages of apt-packages.txt, and selenium in the Python given:
#
#   tests/browser/run.sh PYTHON
set -euo pipefail
cd "$(dirname "$0")/../.."
"${1:-.venv/bin/python}" -m pytest tests/browser -q -n 0 -p no:cacheprovider
