#!/bin/sh
# SPDX-License-Identifier: MIT
# Checks the Debian packages: their files, their dependencies, and that their programs run.
# usage: package_test.sh CPACK BUILD_FOLDER VERSION
set -eu
cpack=$1
build=$2
version=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

fail() {
    echo "failed: $*" >&2
    exit 1
}

for tool in dpkg-deb dpkg-shlibdeps; do
    command -v $tool >/dev/null || { echo "skipped: $tool is absent"; exit 77; }
done
(cd "$build" && "$cpack" -G DEB -B "$folder") >"$folder/log" 2>&1 || { cat "$folder/log"; fail "cpack"; }

# has NAME PATTERN...: checks that package NAME has one file for each pattern and no others.
has() {
    expected=$(($# - 1))
    contains "$@"
    [ "$count" -eq "$expected" ] || { cat "$folder/files"; fail "$count files in $package, not $expected"; }
}

# contains NAME PATTERN...: checks that package NAME has one file for each pattern.
contains() {
    package=$(echo "$folder/$1"_*.deb)
    [ -f "$package" ] || fail "no package $1"
    [ "$(dpkg-deb -f "$package" Version)" = "$version" ] || fail "the version of $1"
    dpkg-deb -c "$package" | sed -n 's/^[^d].* \.\(\/[^ ]*\).*/\1/p' >"$folder/files"
    count=$(wc -l <"$folder/files")
    shift
    for pattern; do
        grep -qx "$pattern" "$folder/files" || { cat "$folder/files"; fail "no $pattern in $package"; }
    done
    dpkg-deb -x "$package" "$folder/root"
}
depends() { dpkg-deb -f "$folder/$1"_*.deb Depends; }

# Manual pages are there where help2man is.
manual() { [ ! -f "$build/debian/$1.1.gz" ] || echo "/usr/share/man/man1/$1\.1\.gz"; }
completions() { echo "/usr/share/bash-completion/completions/$1" "/usr/share/zsh/vendor-completions/_$1"; }
policy() { echo "/usr/share/doc/$1/copyright" "/usr/share/doc/$1/changelog\.gz"; }

has libnicol0.1 '/usr/lib.*/libnicol\.so\.0\.1' '/usr/lib.*/libnicol\.so\.0\.1\.[0-9]*' /usr/share/doc/nicol/LICENSE \
    /usr/share/doc/nicol/third_party.txt $(policy 'libnicol0\.1')
contains libnicol-dev /usr/include/nicol.h /usr/include/nicol.hpp /usr/include/nicol_classes.hpp /usr/include/nicol_files.h /usr/include/nicol_psh.h \
    '/usr/lib.*/libnicol\.so' '/usr/lib.*/pkgconfig/nicol\.pc' \
    '/usr/lib.*/cmake/nicol/nicolConfig\.cmake' '/usr/lib.*/cmake/nicol/nicolConfig-.*\.cmake' \
    '/usr/lib.*/cmake/nicol/nicolConfigVersion\.cmake' $(policy libnicol-dev) \
    '/usr/share/doc/libnicol-dev/samples/render/README\.md' '/usr/share/doc/libnicol-dev/examples/embed_c/hello_stokes\.c'
# The header names these documents.
for document in $(grep -o 'capi/reference/[a-z_]*\.md' "$folder/root/usr/include/nicol.h"); do
    [ -f "$folder/root/usr/share/doc/libnicol-dev/$document" ] || fail "no $document"
done
has nicol-tools /usr/bin/nicol-render /usr/bin/nicol-convert $(completions nicol-render) $(completions nicol-convert) \
    $(policy nicol-tools) $(manual nicol-render) $(manual nicol-convert)
has nicol-serve /usr/bin/nicol-serve /usr/lib/systemd/system/nicol-serve.service \
    /usr/share/doc/nicol-serve/nicol-serve.default $(completions nicol-serve) $(policy nicol-serve) $(manual nicol-serve)
contains python3-nicol '/usr/lib/python3/dist-packages/nicol/__init__\.py' '/usr/lib/python3/dist-packages/nicol/py\.typed' \
    /usr/bin/nicol-dataset $(completions nicol-dataset) $(policy python3-nicol) $(manual nicol-dataset)

depends libnicol0.1 | grep -q 'libc6' || fail "libnicol0.1 depends on: $(depends libnicol0.1)"
depends libnicol0.1 | grep -q 'libembree4-4 | libembree3-3' || fail "libnicol0.1 depends on: $(depends libnicol0.1)"
for package in libnicol-dev nicol-tools nicol-serve python3-nicol; do
    depends $package | grep -q "libnicol0.1 (= $version)" || fail "$package depends on: $(depends $package)"
done
ls "$folder"/*.deb
"$folder/root/usr/bin/nicol-render" --version
"$folder/root/usr/bin/nicol-convert" --version
! command -v lintian >/dev/null || lintian --fail-on error "$folder"/*.deb || fail "lintian"
