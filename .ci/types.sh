#!/bin/sh
# SPDX-License-Identifier: MIT
# Checks the type hints of the Python package, and what they say to users of it.
set -eu
cd "$(dirname "$0")/.."

python=$(sh .ci/peers.sh)
"$python" -m pip install --quiet mypy
cd samples/python
"$python" -m mypy
"$python" -m mypy ../../tests/embed/python_types.py
