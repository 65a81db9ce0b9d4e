#!/bin/sh
# SPDX-License-Identifier: MIT
# Steps from a fresh clone to the paper's images and its table of costs. Takes the arguments of nicol-paper, the data
# folder first. The default folder is polarsh in NICOL_TEST_DATA.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)

sh "$root/samples/setup.sh"
cmake -S "$root" -B "$root/build" -G Ninja -DCMAKE_BUILD_TYPE=Release
cmake --build "$root/build" --target nicol-paper nicol-render

# Keeps traced and tabulated results for the next run.
NICOL_CACHE="${NICOL_CACHE:-$root/build/cache}"
export NICOL_CACHE
"$root/build/bin/nicol-paper" "$@"

# Renders a sphere of the gold without shadows or high orders, at three truncations.
case "${1:-}" in
"" | -*) data="${NICOL_TEST_DATA:-.}/polarsh" ;;
*) data=$1 ;;
esac
for order in 4 9 19; do
    folder=out/paper/gold_$order
    mkdir -p "$folder"
    "$root/build/bin/nicol-render" "$root/samples/paper/gold_sphere.xml" -D "data=$(cd "$data" && pwd)" \
        --order-low $order --high-orders none --no-shadows -o "$folder/stokes.exr" --images "$folder"
done
