#!/bin/sh
# SPDX-License-Identifier: MIT
# Tests the Node.js module and its example with Koffi from npm. The test is skipped without a network.
# usage: node_test.sh NODE NPM PYTHON TESTS_FOLDER SAMPLES_FOLDER BUILD_FOLDER C_PROGRAM
set -eu
node=$1
npm=$2
python=$3
tests=$4
samples=$5
mkdir -p "$6"
cp "$samples"/node/*.js* "$tests/node_test.js" "$6"
cd "$6"
if [ ! -d node_modules/koffi ] &&
    ! "$npm" install --no-audit --no-fund --no-package-lock --fetch-retries=0 --fetch-timeout=20000 >npm.log 2>&1; then
    echo "skipped: npm cannot fetch koffi"
    exit 77
fi
LAYOUT=$("$python" -B "$samples/bindings/abi.py")
export LAYOUT
"$node" node_test.js
"$python" "$tests/save_stokes_test.py" "$7" "$samples/assets" "$node" "$6/save_stokes.js"
