# SPDX-License-Identifier: MIT
"""abidiff sees whatever abi.py calls a break in libraries that a compiler makes of the interfaces. It sees more: to it
the growth of a struct is a change too, and its suppressions for that hide other changes of the same struct.

usage: abi_tool_test.py C_COMPILER INCLUDE_FOLDER NICOL_ABI, with PYTHONPATH naming the folders of abi.py and abi_test.py
"""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest

COMPILER, (INCLUDE, NICOL_ABI) = sys.argv.pop(1), sys.argv[1:]

import abi  # noqa: E402
import abi_test  # noqa: E402
import reader  # noqa: E402

CHANGE, INCOMPATIBLE = 4, 8


def changes(old, new):
    """abidiff's verdict on two interfaces, CHANGE and INCOMPATIBLE, or 0."""
    with tempfile.TemporaryDirectory() as folder:
        paths = []
        for name, interface in (("old", old), ("new", new)):
            paths.append(os.path.join(folder, name, "libnicol.so"))
            os.mkdir(os.path.dirname(paths[-1]))
            command = [COMPILER, "-g", "-shared", "-fPIC", "-x", "c", "-", "-o", paths[-1]]
            subprocess.run(command, input=abi.source(interface), text=True, check=True)
        ended = subprocess.run(["abidiff", "--harmless", "--no-added-syms", *paths], capture_output=True, text=True)
        if ended.returncode & 3:
            raise RuntimeError(ended.stderr)
        return ended.returncode


class AbiToolTest(unittest.TestCase):
    def test_promises_are_kept(self):
        with open(NICOL_ABI, encoding="utf-8") as file:
            old = abi.parse(file)
        self.assertEqual(changes(old, old), 0)
        self.assertEqual(changes(old, abi.parse(abi.interface(reader.read(INCLUDE)))) & INCOMPATIBLE, 0)

    def test_breaks(self):
        for change, _ in abi_test.BREAKS:
            old, new = abi_test.interfaces(change)
            if {kind for (kind, _), _ in {*old.items()} ^ {*new.items()}} == {"constant"}:
                continue  # no library knows them
            with self.subTest(change):
                self.assertTrue(changes(old, new) & CHANGE)


if __name__ == "__main__":
    if not shutil.which("abidiff"):
        print("skipped: abidiff is absent")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
