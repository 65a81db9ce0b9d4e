#!/bin/sh
# SPDX-License-Identifier: MIT
# pip installs the package from its folder, without the network, and what it installed works.
# usage: python_package.sh PYTHON PACKAGE
set -eu
python=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
if ! "$python" -c 'import setuptools, wheel, pip' 2>/dev/null; then
    echo "skipped: pip, setuptools or wheel is absent"
    exit 77
fi
# The build writes beside its input.
cp -R "$2" "$folder/package"
"$python" -m pip install --quiet --no-index --no-deps --no-build-isolation --no-warn-script-location \
    --disable-pip-version-check --root-user-action=ignore --target "$folder/installed" "$folder/package"
cd "$folder"
PYTHONPATH=$folder/installed "$python" -c '
import importlib.metadata, nicol
assert nicol.__file__.startswith("'"$folder"'"), nicol.__file__
assert importlib.metadata.version("nicol") == nicol.version_string()
'
