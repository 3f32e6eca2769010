#!/usr/bin/env bash
# Build the image and run the sample in it. Needs Docker; where there is none it says so and stops.
set -euo pipefail
cd "$(dirname "$0")/../.."
command -v docker >/dev/null || { echo "docker is not installed; the image was not built" >&2; exit 6; }
docker build -t firebreak_gis -f packaging/docker/Dockerfile .
docker run --rm firebreak_gis doctor
