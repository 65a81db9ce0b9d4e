# SPDX-License-Identifier: MIT
"""nicol-dataset: renders frames of a recipe into a folder."""

import argparse
import collections
import concurrent.futures
import signal
import sys
import time

import nicol

from . import outputs, store
from .folder import Folder, FolderError
from .recipe import Recipe
from .renderer import Renderer
from .values import RecipeError

_AT_ONCE = 3  # pictures in memory: one that is rendered, two that are written
_FAILURES = (RecipeError, FolderError, OSError, nicol.Error)


def _range(text):
    first, colon, end = text.partition(":")
    if not (colon and first.isdigit() and end.isdigit() and int(first) <= int(end)):
        raise argparse.ArgumentTypeError(f"'{text}'; it must be A:B with whole numbers, A not above B: frames A to B - 1")
    return range(int(first), int(end))


def _parser():
    parser = argparse.ArgumentParser(
        prog="nicol-dataset", description="Renders frames of a recipe. The bytes of a frame depend on the recipe and its number "
        "alone. Frames that are complete are not rendered again.")  # fmt: skip
    parser.add_argument("recipe", metavar="RECIPE", help="JSON or YAML file, see samples/dataset/README.md")
    parser.add_argument("--frames", metavar="A:B", type=_range, help="frames A to B - 1")
    parser.add_argument("--output", metavar="DIR", help="folder of the data set, made if missing")
    parser.add_argument("--copy-to", metavar="URL", help="also copies frames A to B - 1 there, by fsspec: s3://bucket/name, ...")
    parser.add_argument("--threads", metavar="N", type=int, default=0, help="default: one per core")
    parser.add_argument("--check", action="store_true", help="reads the recipe and tries its ranges, and renders nothing")
    parser.add_argument(
        "--verify", action="store_true", help="compares the files in DIR with their digests, and renders nothing"
    )
    parser.add_argument("--no-files", action="store_true", help="renders without writing, to measure")
    return parser


class _Writer:
    """Renders pictures, and reads and writes them on threads of its own while the next are rendered."""

    def __init__(self, renderer, folder):
        self.renderer, self.folder, self.wanted = renderer, folder, renderer.recipe.write
        self.half = ("stokes",) if self.wanted.get("stokes", {}).get("half") else ()
        self.pool = concurrent.futures.ThreadPoolExecutor(_AT_ONCE - 1)
        self.begun, self.free = collections.deque(), collections.defaultdict(list)

    def _framebuffer(self, frame):
        """Returns a framebuffer that nothing uses any more."""
        free = self.free[self.renderer.channels(frame)]
        return free.pop() if free else self.renderer.framebuffer(frame)

    def add(self, frame):
        framebuffer = self._framebuffer(frame)
        picture = self.renderer.render(frame, tuple(self.wanted), framebuffer, self.half)
        self.begun.append((self.pool.submit(self._write, picture, framebuffer), framebuffer))
        if len(self.begun) >= _AT_ONCE:
            self._end_first()

    def finish(self):
        while self.begun:
            self._end_first()

    def close(self):
        self.pool.shutdown(cancel_futures=True)

    def _end_first(self):
        future, framebuffer = self.begun.popleft()
        future.result()
        self.free[framebuffer.get_size()[2]].append(framebuffer)

    def _write(self, picture, framebuffer):
        self.renderer.read(picture, self.wanted, self.half)
        if self.folder is None:
            return
        place = self.folder.begin(picture.facts["frame"])
        outputs.write(place, self.wanted, picture.arrays, self.renderer.sensor)
        outputs.write_shown(place, self.wanted, framebuffer)
        self.folder.complete(place, picture.facts)


def render(renderer, folder, frames):
    """Renders frames and writes them into a folder, if there is one; returns how many."""
    writer = _Writer(renderer, folder)
    try:
        for frame in frames:
            writer.add(frame)
        writer.finish()
    finally:
        writer.close()
    return len(frames)


def _report(rendered, there, seconds, where):
    rate = f", {60 * rendered / seconds:,.0f} a minute" if rendered else ""
    print(f"nicol-dataset: {rendered} frames rendered{rate}, {there} were complete{where}")


def _run(arguments):
    recipe = Recipe(arguments.recipe)
    if arguments.verify:
        return _verify(Folder(arguments.output, recipe))
    renderer = Renderer(recipe, arguments.threads, _log)
    renderer.check()
    if arguments.check:
        print(f"nicol-dataset: {arguments.recipe}: no fault found")
        return 0
    start = time.monotonic()
    if arguments.no_files:
        _report(render(renderer, None, arguments.frames), 0, time.monotonic() - start, "; nothing is written")
        return 0
    with Folder(arguments.output, recipe) as folder:
        missing = [frame for frame in arguments.frames if not folder.has(frame)]
        render(renderer, folder, missing)
        folder.index()
    if arguments.copy_to:
        store.copy(folder, arguments.frames, arguments.copy_to)
    _report(len(missing), len(arguments.frames) - len(missing), time.monotonic() - start, f" in {arguments.output}")
    return 0


def _verify(folder):
    faults = folder.faults()
    for path in faults:
        print(f"nicol-dataset: {path}: missing or not as it was written", file=sys.stderr)
    if not faults:
        print(f"nicol-dataset: {len(folder.complete_frames())} frames are as they were written")
    return 2 if faults else 0


def _log(severity, code, message):
    if severity >= nicol.LOG_WARNING:
        print(f"nicol-dataset: warning: {message}", file=sys.stderr)


def main(given=None):
    parser = _parser()
    arguments = parser.parse_args(given)
    if not (arguments.check or arguments.verify) and arguments.frames is None:
        parser.error("--frames A:B is missing")
    if not (arguments.check or arguments.no_files) and arguments.output is None:
        parser.error("--output DIR is missing")
    # A request to end runs the `with` blocks, which remove what is not complete.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    try:
        return _run(arguments)
    except _FAILURES as error:
        print(f"nicol-dataset: {' '.join(str(_with_path(error)).split())}", file=sys.stderr)
    except KeyboardInterrupt:
        return 130
    return 2


def _with_path(error):
    """Returns the message of an error of the system as "path: reason"."""
    if isinstance(error, OSError) and error.filename is not None:
        return f"{error.filename}: {error.strerror}"
    return error
