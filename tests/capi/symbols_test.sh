#!/bin/sh
# SPDX-License-Identifier: MIT
# libnicol exports the functions that the C headers declare and capi/symbols.txt lists, and nothing else; it is never
# unloaded.
# usage: symbols_test.sh LIBNICOL INCLUDE_FOLDER SYMBOLS_TXT
set -eu
LC_ALL=C
export LC_ALL
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# The version node NICOL_0 is a symbol of kind A.
nm -D --defined-only "$1" | awk '$2 != "A" { sub(/@.*/, "", $3); print $3 }' | sort >"$folder/exported"
# A declaration starts with NICOL_API and names the function before the first parenthesis.
sed -n 's/^NICOL_API [^(]*\(nicol_[a-z0-9_]*\)(.*/\1/p' "$2"/*.h | sort >"$folder/declared"
sort "$3" >"$folder/listed"

[ -s "$folder/declared" ]
diff -u "$folder/listed" "$folder/exported"
diff -u "$folder/listed" "$folder/declared"
# Threads of the library outlive a dlclose().
readelf -d "$1" | grep -q NODELETE
# Every line that starts a declaration was understood.
[ "$(cat "$2"/*.h | grep -c '^NICOL_API ')" = "$(wc -l <"$folder/declared")" ]
