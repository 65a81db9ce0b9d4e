#!/bin/sh
# SPDX-License-Identifier: MIT
# Checks that the Rust crate builds without the network and passes its tests. usage: rust_test.sh CARGO CRATE
# LIBRARY_FOLDER BUILD_FOLDER
set -eu
rm -rf "$4/crate"
mkdir -p "$4"
# Cargo writes files next to its input.
cp -R "$2" "$4/crate"
cd "$4/crate"
NICOL_LIB_DIR=$3
LD_LIBRARY_PATH=$3
RUSTFLAGS="-D warnings"
export NICOL_LIB_DIR LD_LIBRARY_PATH RUSTFLAGS
"$1" test --offline --quiet --target-dir ../target
"$1" build --offline --quiet --target-dir ../target --example save_stokes
