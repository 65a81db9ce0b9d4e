# SPDX-License-Identifier: MIT
"""Copies of a data set in object stores, which fsspec knows by their URL."""

import os

from .folder import FolderError


def copy(folder, frames, url):
    """Copies complete frames that are not at the URL yet, and the files beside them. A frame's frame.json comes last, so that
    what has one is complete. Raises FolderError."""
    try:
        import fsspec
    except ImportError:
        raise FolderError(f"{url}: copies need the Python package fsspec; install it, or copy {folder.path} yourself") from None
    try:
        store, root = fsspec.core.url_to_fs(url)
        for frame in frames:
            there = f"{root}/frames/{frame:06d}"
            if not store.exists(f"{there}/frame.json"):
                for name in [*folder.facts(frame)["files"], "frame.json"]:
                    _put(store, os.path.join(folder.frame(frame), name), f"{there}/{name}")
        for place, _, names in os.walk(folder.path):
            below = os.path.relpath(place, folder.path)
            if below == "." or below.split(os.sep)[0] == "poses":
                for name in names:
                    if not name.startswith("."):
                        _put(store, os.path.join(place, name), os.path.normpath(f"{root}/{below}/{name}"))
    except Exception as error:  # stores raise what they like
        raise FolderError(f"{url}: cannot be written: {type(error).__name__}: {error}") from None


def _put(store, path, there):
    store.makedirs(os.path.dirname(there), exist_ok=True)
    store.put_file(path, there)
