# SPDX-License-Identifier: MIT
"""Files in memory: what Scene.load_memory and its like read, and the bytes of images."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Mapping
from typing import Any, Union

from . import _abi
from ._runtime import Memory

Files = Union[Mapping[str, Any], Callable[[str], Any]]


def memory_file(content: Any, name: str | None = None, files: Files | None = None) -> _abi.MemoryFile:
    """Returns a file in memory for Scene.load_memory, Mesh.load_memory and their like. content: bytes, or anything with a
    buffer. name: for messages, for the folder of the names in the file, and for the format, which the content says if the
    name has no suffix. files: the files that this one names, a mapping from names to contents, or a function that returns a
    content or None. Nothing is read from the file system."""
    given: dict[str, Any] = {"bytes": content, "byte_size": memoryview(content).nbytes}
    if name is not None:
        given["name"] = name
    if files is not None:
        find = files.get if isinstance(files, Mapping) else files
        kept = []  # as long as the struct has the function

        def resolve(wanted: str, address: int) -> bool:
            found = find(wanted)
            if found is None:
                return False
            memory = Memory(found, writable=False)
            kept.append(memory)
            target = _abi.FileContent.from_address(address)
            target.bytes, target.byte_size = memory.address, memoryview(found).nbytes
            return True

        given["resolve"] = resolve
    return _abi.MemoryFile(**given)


def collected(encode: Callable[[Any], None]) -> bytes:
    """Returns all bytes that encode(sink) gives."""
    parts: list[bytes] = []
    encode(lambda address, size: parts.append(ctypes.string_at(address, size)))
    return b"".join(parts)
