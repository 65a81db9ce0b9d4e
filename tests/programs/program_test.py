# SPDX-License-Identifier: MIT
"""Shared base of the program tests: a folder for each test, a program run in it, and the files that it left."""

import os
import subprocess
import sys

from folder_test import FolderTest

# The first argument is the program. unittest reads the others.
PROGRAM = os.path.abspath(sys.argv.pop(1))


def run(folder, *arguments, timeout=500, **environment):
    """Runs the program in this folder, with these variables added to those of the test, without those that are None, and
    returns its result."""
    variables = {name: value for name, value in {**os.environ, **environment}.items() if value is not None}
    return subprocess.run(
        [PROGRAM, *arguments],
        cwd=folder,
        env=variables,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        timeout=timeout,
    )


class ProgramTest(FolderTest):
    def write(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content if isinstance(content, bytes) else content.encode())
        return self.path(name)

    def run_program(self, *arguments, **environment):
        return run(self.folder, *arguments, **environment)

    def files(self):
        result = {}
        for folder, _, names in os.walk(self.folder):
            for name in names:
                with open(os.path.join(folder, name), "rb") as file:
                    result[os.path.join(folder, name)] = file.read()
        return result

    def error_lines(self, stderr):
        """Returns the lines of an error. Tests of programs that also print notices override this to remove them."""
        return stderr.splitlines()

    def assert_succeeds(self, *arguments, **environment):
        ended = self.run_program(*arguments, **environment)
        self.assertEqual(ended.returncode, 0, ended.stderr)
        return ended

    def assert_fails(self, words, *arguments, **environment):
        """Checks for exit code 2, one line that contains each of the words, and no file made or changed."""
        before = self.files()
        ended = self.run_program(*arguments, **environment)
        self.assertEqual(ended.returncode, 2, f"{arguments}: {ended.stderr}")
        lines = self.error_lines(ended.stderr)
        self.assertEqual(len(lines), 1, ended.stderr)
        for word in words:
            self.assertIn(word, lines[0])
        self.assertEqual(ended.stdout, "")
        after = self.files()
        self.assertEqual(sorted(before), sorted(after))
        for name in before:
            self.assertEqual(before[name], after[name], name)
        return lines[0]

    def assert_each_fails(self, table, *before):
        """Calls assert_fails() for each row (words, arguments). The arguments of a row are one text and follow those in
        `before`."""
        for words, arguments in table:
            with self.subTest(arguments=arguments):
                self.assert_fails(words, *before, *arguments.split())
