#!/bin/sh
# SPDX-License-Identifier: MIT
# Installs missing packages of Debian 12 or later that Nicol is built with and runs on.
set -eu

embree=libembree4-4
if [ "$(. /etc/os-release 2>/dev/null && echo "${ID:-} ${VERSION_ID:-}")" = "debian 12" ]; then
    embree=libembree3-3
fi

packages="cmake g++ ninja-build python3 python3-glad python3-numpy
  luajit pkg-config doxygen dpkg-dev file
  libosmesa6-dev libosmesa6 libegl-dev libegl-mesa0 libgl1-mesa-dri
  libglm-dev libopenmesh-dev libopenexr-dev $embree libtbb-dev libpugixml-dev libpng-dev libstb-dev libturbojpeg0-dev
  libtinygltf-dev nlohmann-json3-dev
  libboost-dev libssl-dev libdeflate-dev zlib1g-dev doctest-dev libsdl2-dev xvfb xauth curl"

if ! command -v dpkg-query >/dev/null 2>&1; then
    echo "setup: not a Debian system; what is needed there is called:" $packages >&2
    exit 0
fi

missing=""
for package in $packages; do
    status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$status" = installed ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

if [ "$(id -u)" -ne 0 ]; then
    echo "setup: missing packages; install them as root: apt-get install$missing" >&2
    exit 1
fi

echo "setup: installing$missing"
export DEBIAN_FRONTEND=noninteractive
apt-get update
apt-get install -y --no-install-recommends $missing
