#!/bin/sh
# SPDX-License-Identifier: MIT
# Checks that the C headers compile without a warning in every dialect of C and C++ that users may choose, and that a
# program that initialises every struct runs.
# usage: header_test.sh INCLUDE_FOLDER USE_C USE_PROGRAM COMPILER...
set -eu
include=$1
source=$2
program=$3
shift 3

compiled=0
failed=0
compile() {
    compiled=$((compiled + 1))
    "$@" -Wall -Wextra -pedantic -Werror -fsyntax-only -I"$include" "$source" && return
    echo "failed: $*" >&2
    failed=1
}

for compiler in "$@"; do
    for standard in c99 c11 c17 c2x; do
        compile "$compiler" -x c -std=$standard -Wstrict-prototypes
    done
    # <stdint.h> uses long long, which C++98 does not have.
    compile "$compiler" -x c++ -std=c++98 -Wno-long-long
    for standard in c++11 c++14 c++17 c++20 c++23; do
        case $("$compiler" --version) in
        *clang*) [ $standard != c++23 ] || standard=c++2b ;;
        esac
        compile "$compiler" -x c++ -std=$standard
    done
done
# Use of a deprecated function is an error here, and none where a program leaves the warnings out.
old='#include <nicol.h>
NICOL_DEPRECATED("use nicol_version()") int old(void);
int main(void) { return old(); }'
for compiler in "$@"; do
    echo "$old" | "$compiler" -x c -std=c99 -Werror -fsyntax-only -I"$include" - 2>"$program.log" && failed=1
    grep -q "use nicol_version()" "$program.log" || failed=1
    echo "$old" | "$compiler" -x c -std=c99 -Werror -fsyntax-only -I"$include" "-DNICOL_DEPRECATED(text)=" - || failed=1
done
"$program"
echo "$compiled compilations"
[ "$compiled" -gt 0 ] && exit $failed
