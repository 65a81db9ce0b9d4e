#!/bin/sh
# SPDX-License-Identifier: MIT
# Checks that the component `static` can be moved and then serves CMake projects and users of pkg-config by itself.
# usage: static_test.sh CMAKE BUILD_FOLDER SAMPLES_FOLDER C_COMPILER NAMES, the names of the functions, sorted
. "$(dirname "$0")/installed.sh"
names=$5

"$cmake" --build "$build" --target nicol_archive >"$folder/log" || { cat "$folder/log"; fail "libnicol.a"; }
"$cmake" --install "$build" --prefix "$folder/first" --component static >"$folder/log"
mv "$folder/first" "$folder/at last"
prefix="$folder/at last"
archive=$(find "$prefix" -name libnicol.a)
printf '%s\n' LICENSE libnicol.a nicol.h nicol.hpp nicol.pc nicolConfig.cmake nicolConfigVersion.cmake nicol_classes.hpp nicol_files.h \
    nicol_psh.h third_party.txt >"$folder/wanted"
(cd "$prefix" && find . -type f) | sed 's|.*/||' | LC_ALL=C sort | diff "$folder/wanted" - || fail "the files of the component static"
if grep -rlF -e "$build" -e "$folder/first" "$prefix" --include='*.cmake' --include='*.pc'; then
    fail "these name folders of the build"
fi
nm -g --defined-only "$archive" | awk 'NF == 3 { print $3 }' | LC_ALL=C sort >"$folder/symbols"
diff "$names" "$folder/symbols" || fail "the global symbols of libnicol.a"

"$build/bin/hello_stokes" >"$folder/expected"
"$cmake" -S "$samples/embed_cmake" -B "$folder/embed" -DCMAKE_C_COMPILER="$compiler" -DCMAKE_PREFIX_PATH="$prefix" \
    >"$folder/log" 2>&1 || { cat "$folder/log"; fail "find_package(nicol)"; }
"$cmake" --build "$folder/embed" >"$folder/log" || { cat "$folder/log"; fail "the CMake project"; }
"$folder/embed/hello_stokes" | diff "$folder/expected" - || fail "hello_stokes of the CMake project"

if ! command -v pkg-config >/dev/null; then
    echo "skipped: pkg-config is absent"
    exit 77
fi
PKG_CONFIG_PATH=$(dirname "$archive")/pkgconfig
export PKG_CONFIG_PATH
eval "$compiler" -std=c99 "$samples/embed_c/hello_stokes.c" "$(pkg-config --cflags --libs nicol)" -o "$folder/plain"
"$folder/plain" | diff "$folder/expected" - || fail "hello_stokes by pkg-config"
echo "the static library is found by CMake and pkg-config"
