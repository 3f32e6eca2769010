#!/usr/bin/env bash
# Build the site into docs/_build; every warning is an error. Links within the site are checked by the build itself; those
# to the web are listed in docs/_build/external-links.txt and NOT fetched, since a build must not need a network.
set -euo pipefail
cd "$(dirname "$0")"
python=${1:-python}
"$python" -m sphinx -W -n --keep-going -q -b html . _build/html
grep -rhoE 'https?://[^]) >"`|]+' --include='*.md' . | sort -u >_build/external-links.txt
printf 'built docs/_build/html/index.html; %s external links listed, not fetched\n' "$(wc -l <_build/external-links.txt)"
