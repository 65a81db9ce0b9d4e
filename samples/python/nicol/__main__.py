# SPDX-License-Identifier: MIT
"""The programs of Nicol: `python -m nicol render SCENE.xml ...` is nicol-render."""

import os
import shutil
import sys

PROGRAMS = ("render", "convert", "serve")


def run(name, arguments):
    """Becomes the program nicol-NAME, that of this package if it has one."""
    program = f"nicol-{name}"
    packaged = os.path.join(os.path.dirname(__file__), "bin", program)
    path = packaged if os.path.exists(packaged) else shutil.which(program)
    # A console script has the program's name and must not find itself.
    if path is None or os.path.realpath(path) == os.path.realpath(sys.argv[0]):
        sys.exit(f"{program} was found neither in the package nor on the path")
    os.execv(path, [program, *arguments])


def render():
    run("render", sys.argv[1:])


def convert():
    run("convert", sys.argv[1:])


def serve():
    run("serve", sys.argv[1:])


def main():
    if len(sys.argv) < 2 or sys.argv[1] not in (*PROGRAMS, "dataset"):
        sys.exit(f"usage: python -m nicol {'|'.join(PROGRAMS)}|dataset ...")
    if sys.argv[1] == "dataset":
        from .dataset import program

        sys.exit(program.main(sys.argv[2:]))
    run(sys.argv[1], sys.argv[2:])


if __name__ == "__main__":
    main()
