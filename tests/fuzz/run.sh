#!/bin/sh
# SPDX-License-Identifier: MIT
# Builds the fuzzers with Clang and runs each for some seconds, two at a time. Fails if one finds something. Findings
# lie in build-fuzz/findings: fix the defect and keep the input in tests/fuzz/corpus/NAME.
# NICOL_FUZZ_SEED=N starts with the same random numbers each time, so that another machine can reproduce a finding.
# usage: sh tests/fuzz/run.sh [SECONDS [NAME...]]
set -eu
cd "$(dirname "$0")/../.."
seconds=${1:-30}
[ $# = 0 ] || shift

# Headers are not precompiled here, so that includes that are missing in tests show.
cmake -S . -B build-fuzz -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
    -DNICOL_FUZZ=ON -DNICOL_BUILD_TESTS=ON -DNICOL_INSTALL=OFF
cmake --build build-fuzz --target fuzzers

export LSAN_OPTIONS=suppressions=$PWD/tests/lsan.supp:print_suppressions=0
# tests/main.cpp explains this option.
export ASAN_OPTIONS=intercept_tls_get_addr=0
[ ! -d /dev/shm ] || export TMPDIR=/dev/shm
rm -f build-fuzz/*.found
# usage: fuzz NAME
fuzz() {
    # New inputs go into the first folder, and later runs start from it.
    grown=build-fuzz/corpus/$1
    kept=tests/fuzz/corpus/$1
    mkdir -p "$grown" build-fuzz/findings
    [ -d "$kept" ] || kept=""
    dictionary=tests/fuzz/$1.dict
    [ ! -f "$dictionary" ] && dictionary="" || dictionary=-dict=$dictionary
    log=build-fuzz/$1.log
    # -rss_limit_mb also refuses single allocations of that size. An image may take 8 GiB.
    megabytes=1024
    case $1 in exr | bitmap) megabytes=9216 ;; esac
    if "build-fuzz/bin/fuzz_$1" -max_total_time="$seconds" -timeout=10 -rss_limit_mb="$megabytes" -max_len=4096 \
        -seed="${NICOL_FUZZ_SEED:-0}" -print_final_stats=1 -artifact_prefix="build-fuzz/findings/$1-" $dictionary \
        "$grown" "build-fuzz/tests/fuzz/seeds/$1" $kept >"$log" 2>&1; then
        state=clean
    else
        state=FOUND
        touch "build-fuzz/$1.found"
        tail -n 60 "$log"
    fi
    runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
    cover=$(sed -n 's/.* cov: \([0-9]*\).*/\1/p' "$log" | tail -n 1)
    echo "fuzz $1: $state, ${runs:-?} executions, ${cover:-?} edges"
}

beside=0
for program in build-fuzz/bin/fuzz_*; do
    name=${program##*/fuzz_}
    case " ${*:-$name} " in *" $name "*) ;; *) continue ;; esac
    fuzz "$name" &
    beside=$(((beside + 1) % 2))
    [ "$beside" = 1 ] || wait
done
wait
found=$(cd build-fuzz && ls -- *.found 2>/dev/null || true)
[ -z "$found" ] || { echo "fuzz: findings in" $found >&2; exit 1; }
