# SPDX-License-Identifier: MIT
"""The folder of a data set.

    dataset.json          recipe, fingerprint, library, files that the recipe's folders held
    manifest.json         SHA-256 of each file of each frame
    frames/000123/        a frame: frame.json and its files
    poses/000004/         of a scene: transforms.json, poses_bounds.npy, colmap/
    .work-HOST-PID-xxxx/  of a run: what it has not completed

A frame's folder is renamed to its name when all its files are written, so that a run may end at any time. Runs on several
machines may share the folder. A run holds a lock on a file of its .work folder; what has no owner any more is removed by the
next run."""

import contextlib
import errno
import fcntl
import hashlib
import json
import os
import shutil
import socket
import tempfile

from . import poses
from .recipe import library


_OTHER = {"recipe": "recipe", "folders": "content of the recipe's folders", "library": "version of the library"}


class FolderError(Exception):
    """A folder that cannot be used, or files that are not as they were written."""


def _text(value):
    return json.dumps(value, indent=1, sort_keys=True) + "\n"


def _digest(path):
    digest = hashlib.sha256()
    with open(path, "rb") as file:
        while block := file.read(1 << 20):
            digest.update(block)
    return digest.hexdigest()


class Folder:
    """The folder of a recipe's data set, made if it is missing."""

    def __init__(self, path, recipe):
        self.path, self.recipe, self.work, self.lock = os.path.abspath(path), recipe, None, None
        os.makedirs(os.path.join(self.path, "frames"), exist_ok=True)

    def __enter__(self):
        self.work = tempfile.mkdtemp(prefix=f".work-{socket.gethostname()}-{os.getpid()}-", dir=self.path)
        self.lock = open(os.path.join(self.work, "lock"), "w")
        try:
            fcntl.flock(self.lock, fcntl.LOCK_EX)
            with self._alone():
                self._remove_abandoned()
                self._claim()
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        shutil.rmtree(self.work, ignore_errors=True)
        self.lock.close()

    def frame(self, frame):
        return os.path.join(self.path, "frames", f"{frame:06d}")

    def has(self, frame):
        return os.path.isdir(self.frame(frame))

    def begin(self, frame):
        """Returns an empty folder for the files of a frame."""
        return tempfile.mkdtemp(prefix=f"{frame:06d}-", dir=self.work)

    def complete(self, begun, facts):
        """Makes the files of a folder of begin() those of the frame, with frame.json."""
        files = {name: _digest(os.path.join(begun, name)) for name in sorted(os.listdir(begun))}
        with open(os.path.join(begun, "frame.json"), "w", encoding="utf-8") as file:
            file.write(_text(facts | {"files": files}))
        os.chmod(begun, 0o755)
        try:
            os.rename(begun, self.frame(facts["frame"]))
        except OSError as error:
            if error.errno not in (errno.ENOTEMPTY, errno.EEXIST):
                raise
            shutil.rmtree(begun)  # another run was faster; its bytes are the same

    def complete_frames(self):
        return sorted(int(name) for name in os.listdir(os.path.join(self.path, "frames")) if name.isdigit())

    def facts(self, frame):
        """Returns what a complete frame's frame.json says."""
        with open(os.path.join(self.frame(frame), "frame.json"), encoding="utf-8") as file:
            return json.load(file)

    def faults(self):
        """Returns the files of complete frames that are missing or not as they were written."""
        found = []
        for frame in self.complete_frames():
            for name, digest in self.facts(frame)["files"].items():
                path = os.path.join(self.frame(frame), name)
                if not os.path.isfile(path) or _digest(path) != digest:
                    found.append(path)
        return found

    def index(self):
        """Writes manifest.json and the poses of all complete frames. The last of several runs sees all of them, because each
        reads and writes alone."""
        with self._alone():
            scenes, manifest = {}, {}
            for frame in self.complete_frames():
                facts = self.facts(frame)
                manifest[f"{frame:06d}"] = facts["files"]
                scenes.setdefault(facts["scene"], []).append(facts)
            self._put("manifest.json", _text({"frames": manifest}))
            for scene, frames in scenes.items() if self.recipe.poses else ():
                for name, data in poses.files(self.recipe.poses, frames).items():
                    self._put(os.path.join("poses", f"{scene:06d}", name), data)

    def _claim(self):
        """Writes dataset.json, or checks that the frames that are there are of the same recipe."""
        claimed = {"recipe": self.recipe.json, "folders": self.recipe.source.files, "library": library()}
        claimed["fingerprint"] = self.recipe.fingerprint()
        path = os.path.join(self.path, "dataset.json")
        if self.complete_frames() and os.path.exists(path):
            with open(path, encoding="utf-8") as file:
                there = json.load(file)
            different = [name for name, value in claimed.items() if there.get(name) != value]
            if different:
                what = _OTHER.get(different[0], "size of the files of its folders")
                raise FolderError(f"{self.path}: holds frames of another {what}; choose another folder, or remove this one")
        else:
            self._put("dataset.json", _text(claimed))

    def _put(self, name, data):
        """Puts a file in its place once it is complete."""
        path = os.path.join(self.path, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        made = os.path.join(self.work, "file")
        with open(made, "wb") as file:
            file.write(data.encode() if isinstance(data, str) else data)
        os.replace(made, path)

    @contextlib.contextmanager
    def _alone(self):
        with open(os.path.join(self.path, ".lock"), "w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            yield

    def _remove_abandoned(self):
        """Removes what runs left that were killed: .work folders whose lock nobody holds."""
        for name in os.listdir(self.path):
            place = os.path.join(self.path, name)
            if not name.startswith(".work-") or place == self.work:
                continue
            try:
                with open(os.path.join(place, "lock")) as lock:
                    fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
                    shutil.rmtree(place, ignore_errors=True)
            except (BlockingIOError, FileNotFoundError):
                pass
