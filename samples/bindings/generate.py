#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the bindings of other languages, and the classes of C++, from the C headers.

usage: generate.py            writes them
       generate.py --check    ends with 1 where a file is not what the headers would make it
"""

import difflib
import os
import sys

import reader
import to_cpp
import to_lua
import to_node
import to_python
import to_rust

SAMPLES = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
TARGETS = {
    "../include/nicol_classes.hpp": to_cpp,
    "lua/nicol_ffi.lua": to_lua,
    "node/nicol_abi.js": to_node,
    "python/nicol/_abi.py": to_python,
    "rust/src/abi.rs": to_rust,
}


def main():
    if sys.argv[1:] not in ([], ["--check"]):
        sys.exit(__doc__)
    model = reader.read(os.path.join(os.path.dirname(SAMPLES), "include"))
    stale = False
    for name, target in TARGETS.items():
        path, made = os.path.join(SAMPLES, name), target.generate(model)
        found = ""
        if os.path.exists(path):
            with open(path, encoding="utf-8") as file:
                found = file.read()
        if found == made:
            continue
        if sys.argv[1:]:
            stale = True
            difference = difflib.unified_diff(found.splitlines(), made.splitlines(), name, "as the headers have it", lineterm="", n=1)
            print("\n".join(list(difference)[:40]))
        else:
            with open(path, "w", encoding="utf-8") as file:
                file.write(made)
            print("wrote", os.path.normpath(os.path.join("samples", name)))
    if stale:
        sys.exit("the headers have changed: run python3 samples/bindings/generate.py and commit what it writes")


if __name__ == "__main__":
    main()
