#!/bin/sh
# SPDX-License-Identifier: MIT
# Installs what only developers need: Clang with its tools, sanitizers and libFuzzer, abidiff, and what
# the programs that tests/peers compares with run on.
set -eu

packages="clang clang-format clang-tidy libclang-rt-14-dev abigail-tools python3-venv libllvm19"
missing=""
for package in $packages; do
    status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$status" = installed ] || missing="$missing $package"
done
[ -z "$missing" ] || DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing
