# SPDX-License-Identifier: MIT
"""Writes files as a C++ source that defines assets(). usage: embed_assets.py OUTPUT FILE..."""

import os
import sys

TYPES = {
    ".html": "text/html; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".svg": "image/svg+xml",
}

lines = ['#include "assets.hpp"', "", "namespace {", ""]
rows = []
for number, path in enumerate(sys.argv[2:]):
    with open(path, "rb") as file:
        data = file.read()
    name = os.path.basename(path)
    place = "/" if name == "index.html" else "/" + name
    # Numbers are used instead of a string, whose length compilers limit.
    lines.append(f"constexpr char file_{number}[] = {{{','.join(str(b if b < 128 else b - 256) for b in data)}}};")
    rows.append(f'    {{"{place}", "{TYPES[os.path.splitext(name)[1]]}", {{file_{number}, sizeof file_{number}}}}},')
lines += ["", "constexpr Asset table[] = {", *rows, "};", "", "}  // namespace", ""]
lines += ["std::span<const Asset> assets() {", "    return table;", "}", ""]
with open(sys.argv[1], "w", encoding="ascii") as file:
    file.write("\n".join(lines))
