#!/bin/sh
# SPDX-License-Identifier: MIT
# The path of a Python that has what tests/peers compares Nicol with, in build-peers, which is made where it is missing.
set -eu
cd "$(dirname "$0")/.."

[ -x build-peers/bin/python ] || python3 -m venv build-peers
build-peers/bin/pip install --quiet mitsuba numpy polanalyser 'opencv-python-headless<5' matplotlib >&2
echo "$PWD/build-peers/bin/python"
