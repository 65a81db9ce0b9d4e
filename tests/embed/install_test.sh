#!/bin/sh
# SPDX-License-Identifier: MIT
# Checks that an installation can be moved and then serves CMake projects, users of pkg-config and its own programs.
# usage: install_test.sh CMAKE BUILD_FOLDER SAMPLES_FOLDER C_COMPILER
. "$(dirname "$0")/installed.sh"

# Each component contains its own files and no others.
for component in runtime development tools; do
    "$cmake" --install "$build" --prefix "$folder/$component" --component $component >"$folder/log"
    (cd "$folder/$component" && find . -type f -o -type l) | sed 's|.*/||' | sort >"$folder/$component.list"
done
grep -qx 'libnicol.so.0.1' "$folder/runtime.list" || fail "no library in the component runtime"
grep -vx -e 'libnicol\.so\.[0-9.]*' -e LICENSE -e third_party.txt "$folder/runtime.list" && fail "more than the library in the component runtime"
printf '%s\n' libnicol.so nicol.h nicol.hpp nicol_classes.hpp nicol_files.h nicol_psh.h nicol.pc nicolConfig-release.cmake nicolConfig.cmake nicolConfigVersion.cmake |
    sort | sed "s/-release/$(grep -o -- '-[a-z]*\.cmake' "$folder/development.list" | sed 's/\.cmake//')/" |
    diff - "$folder/development.list" || fail "the files of the component development"
printf '%s\n' nicol-convert nicol-render | diff - "$folder/tools.list" || fail "the files of the component tools"

# Installs all components, then moves them to a folder whose name has a space.
"$cmake" --install "$build" --prefix "$folder/first" >"$folder/log"
mv "$folder/first" "$folder/at last"
prefix="$folder/at last"
libraries=$(dirname "$(find "$prefix" -name libnicol.so)")
if grep -rlF -e "$build" -e "$folder/first" "$prefix" --include='*.cmake' --include='*.pc'; then
    fail "these name folders of the build"
fi
"$prefix/bin/nicol-render" --version >/dev/null || fail "the installed nicol-render"
"$prefix/bin/nicol-convert" --version >/dev/null || fail "the installed nicol-convert"

"$build/bin/hello_stokes" >"$folder/expected"

# Builds a CMake project against the installation.
configure() { "$cmake" -S "$1" -B "$2" -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_COMPILER="$compiler" \
    -DCMAKE_PREFIX_PATH="$prefix" >"$folder/log" 2>&1; }
configure "$samples/embed_cmake" "$folder/embed" || { cat "$folder/log"; fail "find_package(nicol)"; }
"$cmake" --build "$folder/embed" >"$folder/log" || { cat "$folder/log"; fail "the CMake project"; }
"$folder/embed/hello_stokes" | diff "$folder/expected" - || fail "hello_stokes of the CMake project"

# Incompatible versions must not be found.
for version in 0.0 0.2 1.0; do
    mkdir "$folder/wants$version"
    sed "s/nicol 0\.1 /nicol $version /; s|\.\./|$samples/|" "$samples/embed_cmake/CMakeLists.txt" \
        >"$folder/wants$version/CMakeLists.txt"
    configure "$folder/wants$version" "$folder/wants$version/build" && fail "version $version was found"
done

# Builds with one line of pkg-config.
if ! command -v pkg-config >/dev/null; then
    echo "skipped: pkg-config is absent"
    exit 77
fi
PKG_CONFIG_PATH=$libraries/pkgconfig
export PKG_CONFIG_PATH
[ "$(pkg-config --modversion nicol)" = "$("$prefix/bin/nicol-render" --version | grep -o '[0-9]*\.[0-9]*\.[0-9]*' | head -n 1)" ] ||
    fail "the version in nicol.pc"
eval "$compiler" -std=c99 "$samples/embed_c/hello_stokes.c" "$(pkg-config --cflags --libs nicol)" -o "$folder/plain"
LD_LIBRARY_PATH=$libraries "$folder/plain" | diff "$folder/expected" - || fail "hello_stokes by pkg-config"
echo "installed, moved, found by CMake and pkg-config"
