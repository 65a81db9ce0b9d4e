#!/bin/sh
# SPDX-License-Identifier: MIT
# Checks that pip installs the package from its folder without the network, and that the installed package works.
# usage: python_package.sh PACKAGE PYTHON...
set -eu
package=$1
shift
python=""
for candidate in "$@"; do
    ! "$candidate" -c 'import setuptools, wheel, pip' 2>/dev/null || python=$candidate
done
if [ -z "$python" ]; then
    echo "skipped: none of $* has pip, setuptools and wheel"
    exit 77
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
# The build writes files next to its input.
cp -R "$package" "$folder/package"
"$python" -m pip install --quiet --no-index --no-deps --no-build-isolation --no-warn-script-location \
    --disable-pip-version-check --root-user-action=ignore --target "$folder/installed" "$folder/package"
cd "$folder"
PYTHONPATH=$folder/installed "$python" -c '
import importlib.metadata, nicol
assert nicol.__file__.startswith("'"$folder"'"), nicol.__file__
assert importlib.metadata.version("nicol") == nicol.version_string()
'
