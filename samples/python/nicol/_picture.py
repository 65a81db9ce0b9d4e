# SPDX-License-Identifier: MIT
"""Scenes and pictures in one call each: load(), render() and what a Picture shows."""

from __future__ import annotations

import functools
import os
from collections.abc import Sequence
from typing import Any, overload

from . import Context, Framebuffer, _abi, numpy
from ._memory import Files, collected, memory_file
from ._runtime import constant

_SAMPLES_WITHOUT_SAMPLER, _MOST_SAMPLES = 8, 64


@functools.cache
def default_context() -> Context:
    """Returns the context that load() uses, which is made at the first call."""
    return Context.create()


class Scene(_abi.Scene):
    __doc__ = _abi.Scene.__doc__
    context: Context
    has_film = False  # whether a file gave the scene a camera, a film and samples

    @classmethod
    def create(cls, context: Context) -> Scene:  # type: ignore[override]
        """Creates an empty, dark scene."""
        scene = super().create(context)
        scene.context = context
        return scene

    @classmethod
    def load(  # type: ignore[override]
        cls, context: Context, path: str | os.PathLike[str], definitions: Any = ()
    ) -> Scene:
        """Loads a scene from a file, see nicol_scene_load."""
        scene = super().load(context, path, definitions)
        scene.context = context
        scene.has_film = True
        return scene

    @classmethod
    def load_memory(  # type: ignore[override]
        cls, context: Context, file: _abi.MemoryFile, definitions: Any = ()
    ) -> Scene:
        """Loads a scene from memory_file(), see nicol_scene_load_memory."""
        scene = super().load_memory(context, file, definitions)
        scene.context = context
        scene.has_film = True
        return scene

    def get_instance_ids(self, ids: Any = None) -> Any:
        """Returns the ids of all instances, ascending, or writes them into `ids`."""
        return _ids(super().get_instance_ids, self.get_instance_count, ids)

    def get_light_ids(self, ids: Any = None) -> Any:
        """Returns the ids of all lights, ascending, or writes them into `ids`."""
        return _ids(super().get_light_ids, self.get_light_count, ids)

    def get_polarization_element_ids(self, ids: Any = None) -> Any:
        """Returns the ids of all polarization elements, ascending, or writes them into `ids`."""
        return _ids(super().get_polarization_element_ids, self.get_polarization_element_count, ids)


def _ids(get: Any, count: Any, ids: Any) -> Any:
    if ids is not None:
        return get(ids)
    room = memoryview(bytearray(4 * count())).cast("I")
    get(room)
    return room.tolist()


def load(
    path: str | os.PathLike[str] | bytes | bytearray | memoryview,
    context: Context | None = None,
    *,
    files: Files | None = None,
    **definitions: Any,
) -> Scene:
    """Loads a scene, Mitsuba 3's .xml or glTF's .gltf or .glb, from a file, or from its bytes. The bytes' `files` are those that
    the scene names: a mapping from names to bytes, or a function; nothing is read from the file system. Keywords replace the
    values of the scene's <default>s: load("scene.xml", light_angle=30)."""
    words = [f"{name}={value}" for name, value in definitions.items()]
    context = default_context() if context is None else context
    if isinstance(path, (bytes, bytearray, memoryview)):
        return Scene.load_memory(context, memory_file(path, files=files), words)
    if files is not None:
        raise TypeError("`files` belong to a scene in memory, which is given as bytes")
    return Scene.load(context, path, words)


class Picture:
    """Stokes image of a render. Arrays are of numpy (memoryviews without numpy), of 32-bit floats unless said otherwise, with
    the first row at the top: (height, width, channels) for light, (height, width) or (height, width, 3) for surfaces, which
    a render has made only if its `aovs` name them. Each attribute is copied from the framebuffer when it is first asked
    for; the framebuffer must not be rendered to meanwhile."""

    _PLANES = {
        "stokes": (_abi.PLANE_STOKES, True),  # (height, width, channels, 4)
        "s0": (_abi.PLANE_S0, True),
        "s1": (_abi.PLANE_S1, True),
        "s2": (_abi.PLANE_S2, True),
        "s3": (_abi.PLANE_S3, True),
        "dolp": (_abi.PLANE_DOLP, True),  # 0 where s0 is not above 0
        "aolp": (_abi.PLANE_AOLP, True),  # radians in (-pi/2, pi/2], counter-clockwise from image right
        "variance": (_abi.PLANE_VARIANCE, True),  # (height, width, channels, 4), of each Stokes component
        "depth": (_abi.PLANE_DEPTH, False),  # along the camera's view; infinite without a surface
        "normal": (_abi.PLANE_NORMAL, False),
        "position": (_abi.PLANE_POSITION, False),
        "instance": (_abi.PLANE_INSTANCE, False),  # unsigned integers, NO_INSTANCE without a surface
        "alpha": (_abi.PLANE_ALPHA, False),
    }

    def __init__(self, framebuffer: Framebuffer) -> None:
        self.framebuffer = framebuffer
        self.width, self.height, self.channels = framebuffer.get_size()

    def __getattr__(self, name: str) -> Any:
        if name not in self._PLANES:
            raise AttributeError(f"a nicol.Picture has no {name}; it has {', '.join(self._PLANES)}")
        plane, colored = self._PLANES[name]
        array = self.framebuffer.plane(plane, _abi.ALL_CHANNELS if colored else 0)
        setattr(self, name, array)
        return array

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._PLANES]

    def polarizer(self, angle: float) -> Any:
        """Returns the light behind an ideal polarizer, (height, width, channels). angle: degrees, counter-clockwise from image
        right."""
        from . import conventions  # needs numpy, which the rest of a picture does not

        return conventions.angles(self.stokes, [angle])[0]

    @property
    def statistics(self) -> _abi.Statistics:
        """Work of the render, and its predicted_error."""
        return self.framebuffer.get_statistics()

    def save(self, path: str | os.PathLike[str], show: str = "s0", **observation: Any) -> None:
        """Writes a file by the ending of its name: .exr, the Stokes image and what `aovs` named; .npy, `stokes`; .png, what
        `show` names: s0, s1, s2, s3, dolp, aolp or polarizer. Other keywords are fields of an Observation:
        save("x.png", show="polarizer", polarizer_angle=45)."""
        ending = os.path.splitext(os.fspath(path))[1].lower()
        if ending == ".exr":
            self.framebuffer.write_exr(path)
        elif ending == ".png":
            self.framebuffer.write_png(_abi.Observation(kind=show, **observation), path)
        elif ending == ".npy" and numpy is not None:
            numpy.save(path, self.stokes)
        else:
            raise ValueError(f"{os.fspath(path)}: the name must end in .exr, .png, or, with numpy, .npy")

    def png(self, show: str = "s0", **observation: Any) -> bytes:
        """Returns the bytes of the file that save() writes to a name in .png."""
        shown = _abi.Observation(kind=show, **observation)
        return collected(lambda sink: self.framebuffer.encode_png(shown, sink))

    def exr(self) -> bytes:
        """Returns the bytes of the file that save() writes to a name in .exr."""
        return collected(self.framebuffer.encode_exr)

    def _repr_png_(self) -> bytes | None:
        """Returns s0 as PNG, which notebooks show."""
        return self.png() if self.channels in (1, 3) else None

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Any:
        return numpy.array(self.stokes, dtype, copy=bool(copy) or dtype is not None)

    def __dlpack__(self, **wanted: Any) -> Any:
        return self.stokes.__dlpack__(**wanted)

    def __dlpack_device__(self) -> tuple[int, int]:
        return self.stokes.__dlpack_device__()

    def __repr__(self) -> str:
        return f"<nicol.Picture {self.width} x {self.height}, {self.channels} channels>"


@overload
def render(
    scene: Scene | str | os.PathLike[str],
    camera: _abi.Camera | None = None,
    options: _abi.RenderOptions | None = None,
    framebuffer: None = None,
    *,
    size: tuple[int, int] | None = None,
    quality: str | int | None = None,
    aovs: Sequence[str] = ...,
    **fields: Any,
) -> Picture: ...


@overload
def render(
    scene: Scene, camera: _abi.Camera | None, options: _abi.RenderOptions | None, framebuffer: Framebuffer
) -> None: ...


def render(
    scene: Scene | str | os.PathLike[str],
    camera: _abi.Camera | None = None,
    options: _abi.RenderOptions | None = None,
    framebuffer: Framebuffer | None = None,
    *,
    size: tuple[int, int] | None = None,
    quality: str | int | None = None,
    aovs: Sequence[str] = ("depth", "normal", "position", "instance", "alpha"),
    **fields: Any,
) -> Picture | None:
    """Renders a scene, or the file of one, and returns a Picture. camera: the scene's by default. size: (width, height), the
    film's by default. quality: "realtime", "preview" or "final"; by default samples, filter and max_depth are the scene's, as
    by nicol-render. Other keywords are fields of RenderOptions, with words for constants: shade_at="pixels". aovs: what the
    picture has of surfaces, see Picture.

    With a framebuffer this is nicol_render, which returns None: """
    if framebuffer is not None:
        if size is not None or quality is not None or fields:
            raise TypeError("with a framebuffer, options say all, and the framebuffer has the size")
        _abi.render(scene, camera, options, framebuffer)  # type: ignore[arg-type]  # which it says itself
        return None
    if not isinstance(scene, _abi.Scene):
        scene = load(scene)
    if options is not None and (quality is not None or fields):
        raise TypeError("either options are given, or quality and their fields")
    if options is None:
        options = _options_of(scene, quality, fields)
        options.aovs = sum({constant("aov", name) for name in aovs})
    target = Framebuffer.create(scene.context, *(size or scene.get_film_size()), scene.get_channels())
    _abi.render(scene, camera or scene.get_camera(), options, target)
    return Picture(target)


render.__doc__ = str(render.__doc__) + str(_abi.render.__doc__)


def _options_of(scene: Scene, quality: str | int | None, fields: dict[str, Any]) -> _abi.RenderOptions:
    """Returns options as nicol-render has them for a scene; of a scene that was not loaded, those of a file that says nothing."""
    options = _abi.RenderOptions()
    samples = scene.get_sample_count() if scene.has_film else 0
    options.pixel_samples = min(samples or _SAMPLES_WITHOUT_SAMPLER, _MOST_SAMPLES)
    if quality is not None:
        options.set_quality(constant("quality", quality))
    if scene.has_film:
        options.filter = scene.get_filter()
    for name, value in fields.items():
        setattr(options, name, value)
    if scene.has_film and "max_depth" not in fields and options.method != _abi.METHOD_DENSE and options.shadows:
        depth = scene.get_max_depth()
        options.max_depth = 0 if depth == 1 and options.method != _abi.METHOD_REFERENCE else depth
    return options
