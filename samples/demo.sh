#!/bin/sh
# SPDX-License-Identifier: MIT
# From a fresh clone to polarized images: packages, Release build, two scenes under two turns of the light.
set -eu
cd "$(dirname "$0")/.."

sh samples/setup.sh
cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release
cmake --build build --target nicol-render

# The bunny's highlights are sharper than the default order can hold. What each vertex sees of the light does not
# depend on the light's turn: the cache keeps it from image to image.
for scene in bunny_hdr bunny_sky; do
    for angle in 0 120; do
        folder=out/demo/${scene}_$angle
        mkdir -p "$folder"
        echo "rendering samples/assets/$scene.xml, light rotated by $angle degrees"
        build/bin/nicol-render samples/assets/$scene.xml -D light_angle=$angle --order-low 16 \
            --cache build/cache -o "$folder/stokes.exr" --images "$folder" --stats "$folder/stats.json"
    done
done

echo
echo "The images are in $(pwd)/out/demo:"
find out/demo -name '*.png' | sort
