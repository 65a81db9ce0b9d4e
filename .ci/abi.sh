#!/bin/sh
# SPDX-License-Identifier: MIT
# Checks the shared library against that of the last tag. Ends with 1 if programs built against the old one would break.
set -eu
cd "$(dirname "$0")/.."

if ! last=$(git describe --tags --abbrev=0 2>/dev/null); then
    echo "abidiff: there is no tag yet to compare with"
    exit 0
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
git archive --prefix=old/ "$last" | tar -x -C "$folder"
git archive --prefix=new/ HEAD | tar -x -C "$folder"
for tree in old new; do
    cmake -S "$folder/$tree" -B "$folder/$tree/build" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DNICOL_BUILD_SAMPLES=OFF
    cmake --build "$folder/$tree/build" --target nicol
done
# abidiff returns a sum: 1 and 2 for errors, 4 for changes, 8 for incompatible changes.
answer=0
abidiff --headers-dir1 "$folder/old/include" --headers-dir2 "$folder/new/include" \
    "$folder/old/build/lib/libnicol.so" "$folder/new/build/lib/libnicol.so" || answer=$?
[ $((answer & 11)) = 0 ]
