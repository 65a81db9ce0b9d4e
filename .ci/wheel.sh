#!/bin/sh
# SPDX-License-Identifier: MIT
# Builds the wheel and uses it as a user would.
set -eu
cd "$(dirname "$0")/.."

# The compilers and the options of the tests' build, whose results ccache then has.
CC=cc CXX=c++ SKBUILD_CMAKE_DEFINE=NICOL_WERROR=ON sh samples/python/wheel.sh
out=$PWD/build-wheel/wheels
python=$(sh .ci/peers.sh)

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$python" -m venv "$folder/fresh"
"$folder/fresh/bin/pip" install --quiet --no-index "$out"/*.whl
scene=$PWD/samples/assets/snail_sky.xml
cd "$folder"
unset NICOL_LIBRARY
fresh/bin/nicol-render "$scene" -o script.exr --size 64x64
fresh/bin/python -m nicol render "$scene" -o module.exr --size 64x64
cmp script.exr module.exr
fresh/bin/pip install --quiet numpy
fresh/bin/nicol-dataset --help | grep -q RECIPE
# Blender's extension, which brings the wheel with it.
"$python" "$OLDPWD/samples/blender/make_zip.py" "$out"/*.whl -o nicol_blender.zip
if "$python" -c "import bpy" 2>/dev/null; then
    BLENDER_USER_RESOURCES=$folder/blender "$python" -c "
import bpy
bpy.ops.extensions.package_install_files(filepath='$folder/nicol_blender.zip', repo='user_default', enable_on_install=True)
scene = bpy.context.scene
scene.render.engine, scene.render.filepath = 'NICOL', '$folder/blender.png'
scene.render.resolution_x, scene.render.resolution_y = 64, 64
bpy.ops.render.render(write_still=True)
import nicol
assert nicol.__file__.startswith('$folder/blender'), nicol.__file__
"
    test -s blender.png
fi
# Beside other wheels that bring OpenMP, Embree and image libraries of their own.
"$python" -m pip install --quiet --no-deps --target beside "$out"/*.whl
export PYTHONPATH=$folder/beside
"$python" -c "import nicol; assert nicol.__file__.startswith('$folder'), nicol.__file__"
"$python" "$OLDPWD/tests/peers/beside_test.py" "$OLDPWD/samples/assets"
