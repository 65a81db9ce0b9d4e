#!/bin/sh
# SPDX-License-Identifier: MIT
# Steps from a fresh clone to polarized images: packages, Release build, four scenes, each with two rotations of the
# light.
set -eu
cd "$(dirname "$0")/.."

sh samples/setup.sh
cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release
cmake --build build --target nicol-render

# The visibility at vertices does not depend on the light, so the cache serves all images.
for scene in snail_hdr snail_sky snail_sun snail_textured; do
    for angle in 0 120; do
        folder=out/demo/${scene}_$angle
        mkdir -p "$folder"
        echo "rendering samples/assets/$scene.xml, light rotated by $angle degrees"
        build/bin/nicol-render samples/assets/$scene.xml -D light_angle=$angle --cache build/cache \
            -o "$folder/stokes.exr" --images "$folder" --stats "$folder/stats.json"
    done
done

echo
echo "The images are in $(pwd)/out/demo:"
find out/demo -name '*.png' | sort
