#!/bin/sh
# SPDX-License-Identifier: MIT
# Arguments, folder and failures of the tests of an installation, which read this file.
set -eu
cmake=$1
build=$2
samples=$3
compiler=$4
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
unset LD_LIBRARY_PATH CPATH LIBRARY_PATH PKG_CONFIG_PATH CMAKE_PREFIX_PATH

fail() {
    echo "failed: $*" >&2
    exit 1
}
