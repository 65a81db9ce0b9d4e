# SPDX-License-Identifier: MIT
"""The programs in README.md run as they stand, by the commands that it gives.

usage: readme_test.py SOURCE_TREE BUILD_TREE C_COMPILER PYTHON
"""

import os
import re
import subprocess
import sys
import tempfile
import unittest

SOURCE, BUILD, COMPILER, PYTHON = sys.argv[1:5]
del sys.argv[1:]


def blocks():
    """Returns (language, text) of the fenced blocks of README.md."""
    with open(os.path.join(SOURCE, "README.md"), encoding="utf-8") as file:
        return re.findall(r"^```(\w+)\n(.*?)^```$", file.read(), re.MULTILINE | re.DOTALL)


class ReadmeTest(unittest.TestCase):
    def test_programs(self):
        with tempfile.TemporaryDirectory() as folder:
            # The folder looks like a built clone. Its compiler and interpreter are those of this build.
            for name, target in {"samples": f"{SOURCE}/samples", "include": f"{SOURCE}/include", "build": BUILD}.items():
                os.symlink(target, os.path.join(folder, name))
            python = subprocess.check_output([PYTHON, "-c", "import sys; print(sys.executable)"], text=True).strip()
            for name, target in {"cc": COMPILER, "python3": python}.items():
                with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                    file.write(f"#!/bin/sh\nexec '{target}' \"$@\"\n")
                os.chmod(file.name, 0o755)
            programs = [re.match(r"(?:/\* |# )([\w.]+)", text) for language, text in blocks() if language != "sh"]
            self.assertEqual([program.group(1) for program in programs], ["first.c", "first.py"])
            for program in programs:
                with open(os.path.join(folder, program.group(1)), "w", encoding="utf-8") as file:
                    file.write(program.string)
            environment = {name: value for name, value in os.environ.items() if name not in ("NICOL_LIBRARY", "LD_LIBRARY_PATH")}
            environment["PATH"] = folder + os.pathsep + environment["PATH"]
            for commands in (text for language, text in blocks() if language == "sh"):
                ended = subprocess.run(["sh", "-e", "-c", commands], cwd=folder, env=environment, capture_output=True, encoding="utf-8", errors="replace")
                self.assertEqual(ended.returncode, 0, ended.stderr)
                self.assertIn("(480, 640, 3, 4)", ended.stdout)
            for name in ("first.exr", "first_python.exr"):
                self.assertGreater(os.path.getsize(os.path.join(folder, name)), 100000)

    def test_links(self):
        with open(os.path.join(SOURCE, "README.md"), encoding="utf-8") as file:
            text = file.read()
        self.assertLessEqual(text.count("\n"), 120)
        for target in re.findall(r"\]\((?!https?:)([^)#]+)\)", text) + re.findall(r"\bsamples/assets/[\w.]+\w", text):
            self.assertTrue(os.path.exists(os.path.join(SOURCE, target)), target)


if __name__ == "__main__":
    unittest.main()
