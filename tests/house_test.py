# SPDX-License-Identifier: MIT
"""The folders of src/ stand in a row: each includes itself and those before it. capi/ includes any of them, and what
users include (include/, samples/) includes none. Usage: house_test.py [ROOT], the root of the repository."""
import pathlib
import re
import sys

FOLDERS = """error.hpp arguments.hpp floating_environment.hpp forked.hpp memory_share.hpp progress.hpp shortest_text.hpp versioned.hpp worker_count.hpp idle_arenas.hpp worker_pool.hpp simd polarization harmonics files image sensor texture light material geometry visibility
transfer specular shading gl scene import reference stage surfaces methods draw devices render inspect""".split()
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)


def room(path):
    """Returns the first part of a path below src/: a folder or one of the headers beside them."""
    return path.parts[0]


def arrows(root):
    """Yields (file, included path) for everything in `root` that includes something of src/."""
    for file in sorted(root.rglob("*")):
        if file.suffix in (".h", ".hpp", ".cpp", ".inc"):
            for name in INCLUDE.findall(file.read_text(encoding="utf-8")):
                yield file, pathlib.PurePath(name)


def faults(repository):
    source = repository / "src"
    for entry in sorted(source.iterdir()):
        if entry.name != "CMakeLists.txt" and entry.name not in FOLDERS:
            yield f"src/{entry.name}: is not in the row of folders (tests/house_test.py)"
    for file, name in arrows(source):
        own = room(file.relative_to(source))
        if not (source / name).is_file():
            yield f'{file}: "{name}" must be written from src/, as "folder/file"'
        elif own in FOLDERS and room(name) in FOLDERS and FOLDERS.index(room(name)) > FOLDERS.index(own):
            yield f'{file}: includes "{name}", but {room(name)} comes after {own}'
    for folder in ("include", "samples"):
        for file, name in arrows(repository / folder):
            if (source / name).is_file() and not (file.parent / name).is_file():
                yield f'{file}: includes "{name}" of src/; it may include what users have alone'


def main():
    found = list(faults(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()))
    print("\n".join(found) if found else "every include points to an earlier folder")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
