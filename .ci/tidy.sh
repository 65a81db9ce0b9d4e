#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs clang-tidy over the library. The sources of a folder are read as one file, because most of the time is spent on
# common headers.
set -eu
cd "$(dirname "$0")/.."

cmake -S . -B build-tidy -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
    -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=0 -DNICOL_BUILD_SAMPLES=OFF -DNICOL_BUILD_TESTS=OFF
cmake --build build-tidy --target nicol_glad src/gl/embedded_shaders.cpp
run-clang-tidy -p build-tidy -quiet -j2 -checks=-bugprone-suspicious-include 'Unity/unity_.*\.cxx$'
