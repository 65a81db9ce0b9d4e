#!/bin/sh
# SPDX-License-Identifier: MIT
# Installs the Debian packages in a system that has nothing else, links a C program to them, renders and removes them.
# Needs root, debootstrap and a Debian archive.
# usage: clean_root_test.sh CPACK BUILD_FOLDER SAMPLES_FOLDER
set -eu
cpack=$1
build=$2
samples=$3

skip() {
    echo "skipped: $*"
    exit 77
}
fail() {
    echo "failed: $*" >&2
    exit 1
}
[ "$(id -u)" -eq 0 ] || skip "only root can make another system's folder"
command -v debootstrap >/dev/null || skip "debootstrap is absent"

folder=$(mktemp -d)
root=$folder/root
trap 'rm -rf "$folder"' EXIT
archive=${NICOL_DEBIAN_ARCHIVE:-http://deb.debian.org/debian}
debootstrap --variant=minbase bookworm "$root" "$archive" >"$folder/log" 2>&1 ||
    { tail -5 "$folder/log"; skip "debootstrap made no system from $archive"; }
cp /etc/apt/apt.conf.d/* "$root/etc/apt/apt.conf.d/" # the access to the archive, if configured

(cd "$build" && "$cpack" -G DEB -B "$folder/packages") >"$folder/log" 2>&1 || { cat "$folder/log"; fail "cpack"; }
mkdir "$root/try"
cp "$folder"/packages/*.deb "$root/try/"
cp -r "$samples/assets" "$samples/embed_c" "$samples/embed_cmake" "$root/try/"

inside() { chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root DEBIAN_FRONTEND=noninteractive sh -euc "$1"; }
inside 'apt-get update && apt-get install -y --no-install-recommends /try/*.deb gcc g++ libc6-dev pkg-config cmake make' \
    >"$folder/log" 2>&1 || { tail -20 "$folder/log"; fail "installing"; }

# Without a driver the programs must report what is missing.
if inside 'nicol-render /try/assets/snail_sky.xml -o /try/a.exr' >"$folder/log" 2>&1; then fail "rendered without OpenGL"; fi
grep -qi 'osmesa' "$folder/log" || { cat "$folder/log"; fail "the message does not name what to install"; }
inside 'apt-get install -y --no-install-recommends libosmesa6' >"$folder/log" 2>&1 || { tail "$folder/log"; fail "libosmesa6"; }

inside 'cd /try && gcc -std=c99 -Wall -Werror embed_c/hello_stokes.c $(pkg-config --cflags --libs nicol) -o hello && ./hello'
inside 'cd /try && cmake -S embed_cmake -B viewer >/dev/null && cmake --build viewer' >"$folder/log" 2>&1 ||
    { tail -20 "$folder/log"; fail "the CMake package"; }
inside 'nicol-render /try/assets/snail_sky.xml -o /try/a.exr && test -s /try/a.exr && nicol-convert --info /try/assets/forest.exr'
inside 'cd /try && python3 -c "import nicol; nicol.render(\"assets/snail_sky.xml\", size=(64, 48)).save(\"p.exr\")" && test -s p.exr'
# EGL is enough, too.
inside 'apt-get purge -y libosmesa6 && apt-get install -y --no-install-recommends libegl1 libegl-mesa0 libgl1-mesa-dri' \
    >"$folder/log" 2>&1 || { tail "$folder/log"; fail "libegl1"; }
inside 'nicol-render /try/assets/snail_sky.xml -o /try/e.exr --size 64x48 --stats - | grep "\"backend\": \"egl\""'
inside 'apt-get install -y --reinstall /try/*.deb && nicol-render --version' >"$folder/log" 2>&1 || { tail "$folder/log"; fail "upgrading"; }
inside 'apt-get purge -y libnicol0.1 && ! command -v nicol-render && ! ls /usr/include/nicol.h' >"$folder/log" 2>&1 ||
    { tail "$folder/log"; fail "purging"; }
