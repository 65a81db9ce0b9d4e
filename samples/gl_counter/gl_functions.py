# SPDX-License-Identifier: MIT
"""Prints GL_FUNCTION(type, name) for every function of a loader that glad made. Usage: gl_functions.py GL_H"""
import re
import sys

with open(sys.argv[1], encoding="utf-8") as header:
    for kind, name in re.findall(r"^    (PFNGL\w+PROC) (\w+);", header.read(), re.MULTILINE):
        print(f"GL_FUNCTION({kind}, {name})")
