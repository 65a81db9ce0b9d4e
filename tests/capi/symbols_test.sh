#!/bin/sh
# SPDX-License-Identifier: MIT
# Checks that libnicol exports exactly the functions that the C headers declare, that it imports nothing that another
# version of a library in the host's process could replace, and that it is never unloaded.
# usage: symbols_test.sh LIBNICOL NAMES, a file with the names of the functions, sorted
set -eu
LC_ALL=C
export LC_ALL
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# The version node NICOL_0.1 is a symbol of kind A.
nm -D --defined-only "$1" | awk '$2 != "A" { sub(/@.*/, "", $3); print $3 }' | sort >"$folder/exported"

declared=$2
[ -s "$declared" ]
diff -u "$declared" "$folder/exported"
# The library must stay loaded because its threads outlive a dlclose().
readelf -d "$1" | grep -q NODELETE
# Every imported name has a version or belongs to one of these libraries, whose names keep their meaning:
# - namespaces with a version: OpenEXR's C++ library (Imf_3_1), Imath (Imath_3_1), oneTBB (tbb::detail::d1 and r1);
# - zlib, whose functions are unchanged since version 1;
# - OpenEXRCore (exr_), which OpenEXR itself calls by these names, so no user of it is safe from a second copy in the
# process;
# - hooks of the C run time and of sanitizers;
# - OpenMesh, because a process rarely contains a second version of it.
nm -D --undefined-only "$1" | awk '{ print $NF }' | grep -v @ | c++filt |
    sed -E 's/^(vtable|typeinfo|typeinfo name|VTT|guard variable|(non-)?virtual thunk) (for|to) //' >"$folder/imported"
if grep -vE -e '(Imf|Imath)_[0-9]+_[0-9]+::' -e 'tbb::detail::[dr]1::' -e '^(inflate(Init_|Init2_|End)?|crc32)$' -e '^exr_[a-z_]+$' \
    -e '^(__gmon_start__|_ITM_(de)?registerTMCloneTable|__cxa_finalize|__[a-z]+san_|__sanitizer_)' -e 'OpenMesh|^omerr' "$folder/imported"; then
    echo "failed: a host that has another version of these lends it to libnicol" >&2
    exit 1
fi
