#!/bin/sh
# SPDX-License-Identifier: MIT
# Checks the shaders, in the variants that some tests render with, by Khronos's own compiler, because drivers differ in
# what they accept. Mesa writes the sources down.
set -eu
cd "$(dirname "$0")/.."

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export MESA_SHADER_DUMP_PATH="$folder" MESA_SHADER_CACHE_DISABLE=1 NICOL_CACHE= NICOL_TEST_BACKENDS=egl
build/bin/test_devices --minimal --source-file='*compute_gl*'
build/bin/test_render --minimal --source-file='*alpha_gl*,*element_gl*'
build/bin/test_capi --minimal --source-file='*planes_gl*'
count=0
for file in "$folder"/*.glsl; do
    case ${file##*/} in
    VS_*) stage=vert ;;
    FS_*) stage=frag ;;
    CS_*) stage=comp ;;
    esac
    if ! glslangValidator -S "$stage" "$file" >"$folder/messages"; then
        cat "$folder/messages" "$file" >&2
        exit 1
    fi
    count=$((count + 1))
done
echo "shaders: $count variants"
[ "$count" -gt 60 ]
