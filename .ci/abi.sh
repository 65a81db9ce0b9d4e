#!/bin/sh
# SPDX-License-Identifier: MIT
# The shared library against that of the last tag: 1 where programs built against that one would break.
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
# Its answer is a sum: 1 and 2 for errors, 4 for changes, 8 for those that break.
answer=0
abidiff --headers-dir1 "$folder/old/include" --headers-dir2 "$folder/new/include" \
    "$folder/old/build/lib/libnicol.so" "$folder/new/build/lib/libnicol.so" || answer=$?
[ $((answer & 11)) = 0 ]
