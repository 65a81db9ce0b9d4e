#!/bin/sh
# SPDX-License-Identifier: MIT
# Renders 200 frames of demo.json (20 objects under 20 lights, 10 views of each) into out/dataset, and a sheet of all of them,
# out/dataset/sheet.png. Needs samples/demo.sh's build. usage: sh samples/dataset/demo.sh [OUTPUT]
set -eu
cd "$(dirname "$0")/../.."
output=${1:-out/dataset}
[ -n "${NICOL_LIBRARY:-}" ] || NICOL_LIBRARY=$PWD/build/lib/libnicol.so.0.1
PYTHONPATH=$PWD/samples/python
export NICOL_LIBRARY PYTHONPATH
python=${PYTHON:-/usr/bin/python3}

"$python" -m nicol.dataset samples/dataset/demo.json --frames 0:200 --output "$output"
"$python" samples/dataset/sheet.py "$output" "$output/sheet.png"
