#!/bin/sh
# SPDX-License-Identifier: MIT
# Sets up, builds and runs every test. NICOL_CI_SANITIZE=1 or --sanitize also runs them under AddressSanitizer and
# UBSan, and --threads runs the multi-threaded ones under ThreadSanitizer. --all tests computed images on each OpenGL
# backend instead of one. --build leaves out running the release tests.
set -eu
cd "$(dirname "$0")/.."

sanitize=${NICOL_CI_SANITIZE:-0}
threads=0
build=0
for argument in "$@"; do
    case $argument in
    --sanitize) sanitize=1 ;;
    --threads) threads=1 ;;
    --all) export NICOL_TEST_BACKENDS=all ;;
    --build) build=1 ;;
    *)
        echo "usage: sh tests/run.sh [--sanitize] [--threads] [--all] [--build]" >&2
        exit 2
        ;;
    esac
done

sh samples/setup.sh

if [ "$sanitize" = 1 ]; then
    cmake -S . -B build-asan -G Ninja -DCMAKE_BUILD_TYPE=Debug -DNICOL_SANITIZE=ON -DNICOL_BUILD_TESTS=ON
    cmake --build build-asan
    ctest --test-dir build-asan --output-on-failure -j2
fi

if [ "$threads" = 1 ]; then
    cmake -S . -B build-tsan -G Ninja -DCMAKE_BUILD_TYPE=Debug -DNICOL_SANITIZE=thread -DNICOL_BUILD_TESTS=ON
    cmake --build build-tsan --target test_threads test_waits
    ctest --test-dir build-tsan --output-on-failure -R '^(threads|waits)\.'
fi

cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DNICOL_BUILD_TESTS=ON -DNICOL_PRECOMPILE=ON
cmake --build build
[ "$build" = 1 ] || ctest --test-dir build --output-on-failure -j2
