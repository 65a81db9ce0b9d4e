#!/bin/sh
# SPDX-License-Identifier: MIT
# Checks the shaders that tests rendered with, by Khronos's own compiler, because drivers differ in what they accept. Mesa
# writes the sources into the folder MESA_SHADER_DUMP_PATH of the tests.
# usage: sh .ci/shaders.sh [FOLDER]; default: build/shaders
set -eu
cd "$(dirname "$0")/.."
folder=${1:-build/shaders}

count=0
for file in "$folder"/*.glsl; do
    # Ours begin with the name of their file in glsl/; others, some of them with mistakes, are those of tests.
    name=$(sed -n '1s|^//@ 0 ||p' "$file")
    [ -n "$name" ] && [ -f "glsl/$name" ] || continue
    case ${file##*/} in
    VS_*) stage=vert ;;
    FS_*) stage=frag ;;
    CS_*) stage=comp ;;
    esac
    if ! messages=$(glslangValidator -S "$stage" "$file"); then
        echo "$messages" >&2
        cat "$file" >&2
        exit 1
    fi
    count=$((count + 1))
done
echo "shaders: $count variants"
[ "$count" -gt 60 ]
