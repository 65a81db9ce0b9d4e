#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes nicol_blender.zip. usage: make_zip.py [WHEEL] [-o FILE]

WHEEL is Nicol's Python package, as samples/python/wheel.sh makes it; Blender 4.2 and later install it with the add-on, as an extension.
Without WHEEL the zip is an add-on for earlier versions, whose Python must have the module nicol."""

import argparse
import pathlib
import zipfile

FOLDER = pathlib.Path(__file__).resolve().parent / "nicol_blender"


def make_extension(wheel: pathlib.Path, target: pathlib.Path) -> None:
    manifest = (FOLDER / "blender_manifest.toml").read_text(encoding="utf-8")
    # Keys after a table belong to the table.
    manifest = manifest.replace("\n[permissions]", f'wheels = ["./wheels/{wheel.name}"]\n\n[permissions]')
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as zipped:
        zipped.writestr("blender_manifest.toml", manifest)
        for path in sorted(FOLDER.glob("*.py")):
            zipped.write(path, path.name)
        zipped.write(wheel, f"wheels/{wheel.name}", zipfile.ZIP_STORED)


def make_add_on(target: pathlib.Path) -> None:
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as zipped:
        for path in sorted(FOLDER.glob("*.py")):
            zipped.write(path, f"{FOLDER.name}/{path.name}")


def main() -> None:
    parser = argparse.ArgumentParser(description="Makes the zip of the add-on for Blender.")
    parser.add_argument("wheel", type=pathlib.Path, nargs="?")
    parser.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("nicol_blender.zip"))
    options = parser.parse_args()
    if options.wheel is None:
        make_add_on(options.output)
    else:
        make_extension(options.wheel, options.output)
    print(f"{options.output}: {options.output.stat().st_size} bytes")


if __name__ == "__main__":
    main()
