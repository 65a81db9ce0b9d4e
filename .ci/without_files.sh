#!/bin/sh
# SPDX-License-Identifier: MIT
# Builds libnicol without files, for hosts that bring their data as arrays: it renders the same, and refuses files by name.
set -eu
cd "$(dirname "$0")/.."

cmake -S . -B build-without-files -G Ninja -DCMAKE_BUILD_TYPE=Release -DNICOL_BUILD_TESTS=OFF -DNICOL_BUILD_SAMPLES=OFF \
    -DNICOL_EXR=OFF -DNICOL_BITMAPS=OFF -DNICOL_MESH_FILES=OFF -DNICOL_SCENE_FILES=OFF
cmake --build build-without-files
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# usage: needed BUILD_FOLDER; prints the MB of the library, and with what it loads beside the C library
needed() {
    strip -o "$folder/stripped.so" "$1/lib/libnicol.so"
    ldd "$1/lib/libnicol.so" | awk '$3 ~ /^\// && $3 !~ /lib(c|m|dl|gcc_s|stdc\+\+)\.so/ { print $3 }' | xargs du -cbL "$folder/stripped.so" |
        awk 'NR == 1 { alone = $1 } END { printf "%.1f MB, %.1f MB with its libraries\n", alone / 1e6, $1 / 1e6 }'
}
for build in build build-without-files; do
    cc -std=c11 -Iinclude samples/embed_c/hello_stokes.c -o "$folder/$build" "$build/lib/libnicol.so" -Wl,-rpath,"$PWD/$build/lib"
    echo "$build: $(needed "$build")"
done
cmake --build build-without-files --target nicol_archive
cc -std=c11 -Iinclude samples/embed_c/hello_stokes.c -o "$folder/archive" build-without-files/capi/static/libnicol.a \
    -lz -ltbb -lstdc++ -lm -ldl -pthread
"$folder/build" >"$folder/all"
for program in build-without-files archive; do
    "$folder/$program" | diff "$folder/all" -
done

NICOL_LIBRARY=$PWD/build-without-files/lib/libnicol.so PYTHONPATH=samples/python python3 - <<'END'
import nicol

context = nicol.Context.create()
light = nicol.Environment.create_constant(context, (1, 1, 1))
picture = nicol.Framebuffer.create(context, 8, 8, 3)
with nicol.Scene.create(context) as scene:
    scene.set_environment(light, None, 1)
    nicol.render(scene, nicol.Camera(), nicol.RenderOptions(), picture)
calls = {
    "NICOL_SCENE_FILES": lambda: nicol.Scene.load(context, "a.xml", []),
    "NICOL_MESH_FILES": lambda: nicol.Mesh.load(context, "a.obj"),
    "NICOL_BITMAPS": lambda: nicol.Texture.load(context, "a.png"),
    "NICOL_EXR": lambda: picture.write_exr("a.exr"),
}
for option, call in calls.items():
    try:
        call()
        raise SystemExit(f"{option}: no error")
    except nicol.Error as error:
        assert option in str(error) and "a." in str(error), error
END
echo "without files: the same picture, and errors that name the option"
