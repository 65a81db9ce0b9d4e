#!/bin/sh
# SPDX-License-Identifier: MIT
# Installs packages that only developers need: Clang with its tools, sanitizers and libFuzzer, ccache, abidiff, glslang, and
# those of the programs in tests/peers and of samples/vulkan.
set -eu

packages="ccache clang clang-format clang-tidy libclang-rt-14-dev abigail-tools python3-venv libllvm19 glslang-tools help2man lintian python3-sphinx python3-myst-parser furo libvulkan-dev libopengl-dev mesa-vulkan-drivers"
missing=""
for package in $packages; do
    status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$status" = installed ] || missing="$missing $package"
done
[ -z "$missing" ] || DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing
