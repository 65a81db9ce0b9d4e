#!/bin/sh
# SPDX-License-Identifier: MIT
# Prints the path of a Python with the peers of tests/peers, in build-peers, and makes it if it is missing.
set -eu
cd "$(dirname "$0")/.."

[ -x build-peers/bin/python ] || python3 -m venv build-peers
build-peers/bin/pip install --quiet mitsuba numpy polanalyser 'opencv-python-headless<5' matplotlib openapi-python-client ray >&2
# Blender as a module, 350 MB, exists for one version of Python alone.
build-peers/bin/pip install --quiet 'bpy==4.2.*' >&2 || echo "peers: PyPI has no bpy 4.2 for this Python" >&2
echo "$PWD/build-peers/bin/python"
