# SPDX-License-Identifier: MIT
"""Nicol 0.1.0 for Python. Made of the C headers by samples/bindings/generate.py: change those, not this file."""

from __future__ import annotations

import os
from collections.abc import Sequence
from ctypes import POINTER, byref, c_char_p, c_double, c_float, c_int32, c_int64, c_uint32, c_uint64, c_void_p
from typing import TYPE_CHECKING, Any

from ._runtime import (
    Buffer, Callback, Handle, Struct, array, as_is, check, counted, declare, decoded, hold, lend, paired, pointee, text, texts,
)  # fmt: skip

if TYPE_CHECKING:
    from typing_extensions import Self

VERSION_MAJOR = 0
VERSION_MINOR = 1
VERSION_PATCH = 0
VERSION = 100
OK = 0
ERROR_INVALID_ARGUMENT = 1
ERROR_INVALID_HANDLE = 2
ERROR_OUT_OF_MEMORY = 3
ERROR_FILE_NOT_FOUND = 4
ERROR_INVALID_FILE = 5
ERROR_WRITE_FAILED = 6
ERROR_UNSUPPORTED = 7
ERROR_NO_BACKEND = 8
ERROR_CANCELLED = 9
ERROR_OPENGL = 10
ERROR_INTERNAL = 11
ERROR_NOT_CURRENT = 12
ERROR_TIMEOUT = 13
ERROR_BUSY = 14
LOG_INFO = 0
LOG_NOTICE = 1
LOG_WARNING = 2
MAX_CHANNELS = 16
MAX_ORDER = 32
ORDER_AUTOMATIC = 4294967295
MAX_SIZE = 16384
NO_LIMIT = 18446744073709551615
BACKEND_AUTOMATIC = 0
BACKEND_EGL = 1
BACKEND_OSMESA = 2
BACKEND_HOST = 3
TEXTURE_FILTER_NEAREST = 0
TEXTURE_FILTER_BILINEAR = 1
TEXTURE_FILTER_MIPMAP = 2
TEXTURE_WRAP_REPEAT = 0
TEXTURE_WRAP_MIRROR = 1
TEXTURE_WRAP_CLAMP = 2
TEXEL_UINT8 = 0
TEXEL_UINT16 = 1
TEXEL_FLOAT32 = 2
DISTRIBUTION_BECKMANN = 0
DISTRIBUTION_GGX = 1
WAVELENGTH_LINEAR = 0
WAVELENGTH_NEAREST = 1
PROJECTION_PERSPECTIVE = 0
PROJECTION_ORTHOGRAPHIC = 1
LIGHT_DIRECTIONAL = 0
LIGHT_POINT = 1
LIGHT_SPOT = 2
LIGHT_PROJECTOR = 3
POLARIZATION_ELEMENT_POLARIZER = 0
POLARIZATION_ELEMENT_RETARDER = 1
POLARIZATION_ELEMENT_RIGHT_CIRCULAR = 2
POLARIZATION_ELEMENT_LEFT_CIRCULAR = 3
POLARIZATION_ELEMENT_RECTANGLE = 0
POLARIZATION_ELEMENT_DISK = 1
INSTANCE_CASTS_NO_SHADOWS = 1
INSTANCE_RECEIVES_NO_SHADOWS = 2
INSTANCE_INVISIBLE = 4
METHOD_FACTORED = 0
METHOD_DENSE = 1
METHOD_REFERENCE = 2
HIGH_ORDERS_SPLIT = 0
HIGH_ORDERS_CONVOLUTION = 1
HIGH_ORDERS_NONE = 2
SHADE_AT_AUTOMATIC = 0
SHADE_AT_VERTICES = 1
SHADE_AT_PIXELS = 2
EXECUTOR_AUTOMATIC = 0
EXECUTOR_CPU = 1
EXECUTOR_COMPUTE = 2
OPTIMISATION_UNCHANGED = 1
OPTIMISATION_LIGHT_COMPONENTS = 2
OPTIMISATION_CHANNELS = 4
OPTIMISATION_ORDERS = 8
OPTIMISATION_RESPONSE_ROWS = 16
OPTIMISATION_HIDDEN = 32
OPTIMISATION_UNOCCLUDED = 64
OPTIMISATION_RAYS = 128
OPTIMISATION_DIM_LIGHTS = 256
OPTIMISATION_ALL = 511
AOV_DEPTH = 1
AOV_NORMAL = 2
AOV_POSITION = 4
AOV_INSTANCE = 8
AOV_ALPHA = 32
AOV_ALL = 47
AOV_VARIANCE = 16
COMPONENTS_ALL = 0
COMPONENTS_S0 = 1
COMPONENTS_LINEAR = 3
FILTER_BOX = 0
FILTER_GAUSSIAN = 1
FILTER_TENT = 2
FILTER_MITCHELL = 3
FILTER_CATMULLROM = 4
FILTER_LANCZOS = 5
DIRECTIONS_AUTOMATIC = 0
DEPTH_UNLIMITED = -1
SPLIT_AUTOMATIC = -1
MAX_SPLIT_LIGHTS = 64
QUALITY_REALTIME = 0
QUALITY_PREVIEW = 1
QUALITY_FINAL = 2
MAX_VIEWS = 1024
MAX_JOBS = 256
JOB_WAITING = 0
JOB_RUNNING = 1
JOB_DONE = 2
WAIT_FOREVER = 4294967295
PLANE_S0 = 0
PLANE_S1 = 1
PLANE_S2 = 2
PLANE_S3 = 3
PLANE_STOKES = 4
PLANE_DOLP = 5
PLANE_AOLP = 6
PLANE_DEPTH = 7
PLANE_NORMAL = 8
PLANE_POSITION = 9
PLANE_INSTANCE = 10
NO_INSTANCE = 4294967295
PLANE_VARIANCE = 11
PLANE_ALPHA = 12
PLANE_POLARIZER = 13
FORMAT_AUTOMATIC = 0
FORMAT_FLOAT32 = 1
FORMAT_FLOAT16 = 2
FORMAT_UINT32 = 3
ALL_CHANNELS = 4294967295
OBSERVATION_S0 = 0
OBSERVATION_S1 = 1
OBSERVATION_S2 = 2
OBSERVATION_S3 = 3
OBSERVATION_DOLP = 4
OBSERVATION_AOLP = 5
OBSERVATION_POLARIZER = 6
MOSAIC_PLAIN = 0
MOSAIC_POLARIZED = 1
MOSAIC_POLARIZED_BAYER = 2
SENSOR_PRESET_IMX250MZR = 0
SENSOR_PRESET_IMX250MYR = 1
DEMOSAIC_BILINEAR = 0
DEMOSAIC_BLOCKS = 1
DEMOSAIC_GRADIENT = 2
HOST_SETS_STATE = 1
HOST_VALIDATE = 2
ENCODING_LINEAR = 0
ENCODING_SRGB = 1
DEPTH_MAPPING_PERSPECTIVE = 0
DEPTH_MAPPING_PERSPECTIVE_REVERSED = 1
DEPTH_MAPPING_ORTHOGRAPHIC = 2
DEPTH_MAPPING_ORTHOGRAPHIC_REVERSED = 3
PSH_MAX_ORDER = 4096
PSH_MAX_MATRIX_ORDER = 64
PSH_GRID_FEJER = 0
PSH_GRID_CLENSHAW_CURTIS = 1
PSH_GRID_GAUSS_LEGENDRE = 2
PSH_BAND_SIZE = 16
FILE_LIGHT_IMAGE = 1
FILE_LIGHT_CROSS = 2
FILE_LIGHT_PSH = 3
FILE_MATERIAL_PSH = 4
FILE_MATERIAL_MEASURED = 5
FILE_MATERIAL_TABLE = 6
FILE_BAND_LIMITED = 1
FILE_PHYSICAL = 2
FILE_ORDER_AUTOMATIC = 4294967295

LogCallback = Callback(None, (c_void_p, None), (c_uint32, as_is), (c_int32, as_is), (c_char_p, decoded))
ErrorCallback = Callback(None, (c_void_p, None), (c_int32, as_is), (c_char_p, decoded), (c_char_p, decoded))
ProgressCallback = Callback(c_int32, (c_void_p, None), (c_char_p, decoded), (c_double, as_is))
Task = Callback(None, (c_void_p, None))
StartTasks = Callback(c_void_p, (c_void_p, None), (c_uint32, as_is), (Task.type, as_is), (c_void_p, None))
FinishTasks = Callback(None, (c_void_p, None), (c_void_p, None))
MemoryCallback = Callback(c_int32, (c_void_p, None), (c_int64, as_is))
ResolveCallback = Callback(c_int32, (c_void_p, None), (c_char_p, decoded), (c_void_p, as_is))
SinkCallback = Callback(c_int32, (c_void_p, None), (c_void_p, as_is), (c_uint64, as_is))
ReleaseCallback = Callback(None, (c_void_p, None))
MuellerCallback = Callback(c_int32, (c_void_p, None), (c_uint32, as_is), (POINTER(c_double * 3), pointee), (POINTER(c_double * 3), pointee), (POINTER(c_double * 16), pointee))
GetProcAddressCallback = Callback(c_void_p, (c_void_p, None), (c_char_p, decoded))
IsCurrentCallback = Callback(c_int32, (c_void_p, None))
PshMuellerCallback = Callback(c_int32, (c_void_p, None), (POINTER(c_double * 3), pointee), (POINTER(c_double * 3), pointee), (POINTER(c_double * 16), pointee))
PshKernelCallback = Callback(c_int32, (c_void_p, None), (c_double, as_is), (POINTER(c_double * 16), pointee))


class Spectrum(Struct):
    """Values per colour channel. count 0: not given, so that the default of the field or argument applies; 1: one
    value for every channel; else the scene's number of channels."""
    _fields_ = [
        ("count", c_uint32),
        ("values", c_float * 16),
    ]
    count: int
    values: Any


class DeviceInfo(Struct):
    """Fields:
    software: 1 if OpenGL would run on the CPU, else 0
    name: Name from the driver, or another name that identifies the device. The strings are valid as long as the
        library.
    vendor: vendor; "" if EGL does not report one
    file: device file, such as /dev/dri/renderD128; "" if none
    pci_address: Address on the PCI bus (domain, bus, device, function), such as "0000:65:00.0", by which CUDA and
        Vulkan (VK_EXT_pci_bus_info) list the same device; "" if the device has none. nicol_context_info has
        UUIDs, which a driver tells only to a context; LUIDs exist on Windows alone."""
    _fields_ = [
        ("struct_size", c_uint32),
        ("software", c_uint32),
        ("name", c_char_p),
        ("vendor", c_char_p),
        ("file", c_char_p),
        ("pci_address", c_char_p),
    ]
    software: int
    name: str | None
    vendor: str | None
    file: str | None
    pci_address: str | None


class ContextOptions(Struct):
    """Fields:
    backend: backend, default automatic; an explicit choice never falls back to another
    device: Device, at most 1024. 0, the default: automatic; n: the device n of nicol_device_get_info, EGL's n -
        1.
    threads: Number of threads, at most 1024. 0, the default: one per core, which is also the largest number
        used.
    log: Log callback, on any thread, on several at once; NULL, the default: silent. nicol_context_set_log
        replaces it.
    cache_folder: Folder in which material tables and baked visibility are kept between runs; created if missing. NULL,
        the default, or "": the folder of the environment variable NICOL_CACHE, or no cache if the variable is
        not set or empty. Processes may share the folder, and the folder may be emptied at any time. The
        environment variable NICOL_CACHE_LIMIT limits the folder's bytes (default 4 GiB; 0: no limit): beyond
        the limit, the least recently used files are removed. A folder that cannot be used causes a notice to
        the log, not an error.
    memory_limit: Limit of the bytes that each scene keeps at run time, including those on the device; default
        NICOL_NO_LIMIT. The limit covers visibility_bytes and transfer_bytes of the statistics, the OpenGL
        buffers of the scene's vertices (without the work space of compute shaders), the textures of
        polarization elements, and the memory beside the framebuffer for AOVs, several samples and shading at
        pixels; with the reference method, the scene's triangles. A render computes an upper bound before it
        bakes or allocates. If the bound exceeds the limit, the render fails with NICOL_ERROR_OUT_OF_MEMORY,
        and the message has both numbers. If orders are automatic, the bound is for the orders 4 and 9.
    load_bytes_limit: Limit of the bytes of each call that loads from files: 1 or more, or NICOL_NO_LIMIT; default 8 GiB. The
        limit covers all files together and the data decoded from the files, counted before they are decoded: 4
        bytes per value of an image, 16 more per pixel of a texture, 16 per pixel and channel of an
        environment, inflated meshes and arrays, and tables of materials. Beyond this limit or one of the next
        three, the call fails with NICOL_ERROR_UNSUPPORTED, and the message names the option.
    vertex_limit: Limit of the vertices of each call that loads from files, for a mesh or for all instances of a scene
        together: 1 or more, or NICOL_NO_LIMIT; default 2^26.
    triangle_limit: Limit of the triangles of each call that loads from files, for a mesh or for all instances of a scene
        together: 1 or more, or NICOL_NO_LIMIT; default 2^27.
    load_seconds_limit: Limit of the seconds of each call that loads from files; above 0, default 600. The time is checked
        continually while files are read and their content is prepared. Only the decoding of one PNG or JPEG
        and the parsing of one glTF file's JSON are not interrupted.
    load_progress: Progress callback of calls that load; NULL, the default: none. The loading thread calls the function
        about ten times a second with the verb "load" and the fraction 0. If the function returns 0, the load
        ends with NICOL_ERROR_CANCELLED. Threads that load at the same time call the function at the same
        time.
    error: Error callback of failed calls that were given an object of the context, on any thread; NULL, the
        default: none.
    start_tasks: Task system of a host, whose threads help in the parallel loops of renders and loads: `threads` - 1 of
        them beside the thread that renders or loads. Both functions, or NULL for both, the default: the
        library's own threads help. OpenGL has a thread of its own all the same, and software OpenGL has more.
        Functions that take no object of a context use the library's threads.
    memory: Memory monitor; NULL, the default: none. The monitor is told of each OpenGL buffer, texture and
        framebuffer; of meshes, textures, images of light and measured tables when they have been made or
        loaded, before the call returns their object; and of what a scene keeps for its renders: tables, bakes
        and light. A render asks for an upper bound of visibility_bytes and transfer_bytes before it computes
        anything, once more when meshes were refined, and at its end replaces the bound by what it keeps, which
        includes response_bytes. Bytes beyond the bound are told at the end; if the monitor refuses them, the
        render does not fail and they stay uncounted. A render that failed keeps its bound until the scene's
        next render. The sum of the numbers that were not refused is 0 when all objects of the context are
        released."""
    _callbacks_ = {"log": LogCallback, "load_progress": ProgressCallback, "error": ErrorCallback, "start_tasks": StartTasks, "finish_tasks": FinishTasks, "memory": MemoryCallback}
    _fields_ = [
        ("struct_size", c_uint32),
        ("backend", c_uint32),
        ("device", c_uint32),
        ("threads", c_uint32),
        ("log", LogCallback.type),
        ("log_user", c_void_p),
        ("cache_folder", c_char_p),
        ("memory_limit", c_uint64),
        ("load_bytes_limit", c_uint64),
        ("vertex_limit", c_uint64),
        ("triangle_limit", c_uint64),
        ("load_seconds_limit", c_double),
        ("load_progress", ProgressCallback.type),
        ("load_progress_user", c_void_p),
        ("error", ErrorCallback.type),
        ("error_user", c_void_p),
        ("start_tasks", StartTasks.type),
        ("finish_tasks", FinishTasks.type),
        ("tasks_user", c_void_p),
        ("memory", MemoryCallback.type),
        ("memory_user", c_void_p),
    ]
    backend: Any
    device: int
    threads: int
    log: Any
    log_user: Any
    cache_folder: str | None
    memory_limit: int
    load_bytes_limit: int
    vertex_limit: int
    triangle_limit: int
    load_seconds_limit: float
    load_progress: Any
    load_progress_user: Any
    error: Any
    error_user: Any
    start_tasks: Any
    finish_tasks: Any
    tasks_user: Any
    memory: Any
    memory_user: Any


class ContextInfo(Struct):
    """Fields:
    software: 1 if OpenGL itself runs on the CPU, else 0
    threads: number of threads for the mathematics
    renderer: GL_RENDERER; lives as long as the context
    vendor: GL_VENDOR; lives as long as the context
    version: GL_VERSION; lives as long as the context
    max_framebuffer_size: Largest width and height of a framebuffer, pixels: NICOL_MAX_SIZE, or less if the driver allows
        less.
    memory_limit: Limits in effect: this field and the next four, see nicol_context_options.
    device_uuid: UUIDs of the device and of the driver, by which Vulkan, CUDA and others find the same device: 32
        hexadecimal digits, or "" if OpenGL does not tell (GL_EXT_memory_object); live as long as the context.
    device_bytes: Bytes of the OpenGL objects that the context holds now: buffers, textures and framebuffers, as
        requested."""
    _fields_ = [
        ("struct_size", c_uint32),
        ("backend", c_uint32),
        ("software", c_uint32),
        ("threads", c_uint32),
        ("renderer", c_char_p),
        ("vendor", c_char_p),
        ("version", c_char_p),
        ("max_framebuffer_size", c_uint32),
        ("reserved", c_uint32),
        ("memory_limit", c_uint64),
        ("load_bytes_limit", c_uint64),
        ("vertex_limit", c_uint64),
        ("triangle_limit", c_uint64),
        ("load_seconds_limit", c_double),
        ("device_uuid", c_char_p),
        ("driver_uuid", c_char_p),
        ("device_bytes", c_uint64),
    ]
    backend: Any
    software: int
    threads: int
    renderer: str | None
    vendor: str | None
    version: str | None
    max_framebuffer_size: int
    memory_limit: int
    load_bytes_limit: int
    vertex_limit: int
    triangle_limit: int
    load_seconds_limit: float
    device_uuid: str | None
    driver_uuid: str | None
    device_bytes: int


class FileContent(Struct):
    """Content of a file that a resolver returns.

    Fields:
    bytes: content; stays valid and unchanged until the loading call returns; default NULL
    byte_size: size of the content, bytes, default 0"""
    _read_only_ = {"bytes"}
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("bytes", c_void_p),
        ("byte_size", c_uint64),
    ]
    bytes: Any
    byte_size: int


class MemoryFile(Struct):
    """A file in memory. The ..._load_memory functions read it as the ..._load functions read a file, within the
    same limits, and with the same result. They read nothing from the file system. If the resolver does not
    have a file, they return NICOL_ERROR_FILE_NOT_FOUND, and the message has the file's name.

    Fields:
    name: Name for messages. Its suffix determines the format, as for files on disk. Without a suffix, or if the
        name is NULL, the default, the content determines the format; only TGA images need a suffix.
    bytes: content, not used after the call; default NULL
    byte_size: size of the content, bytes, default 0
    resolve: Resolver of the files that this file names; NULL, the default: there are none.
    resolve_user: first argument of resolve, default NULL"""
    _callbacks_ = {"resolve": ResolveCallback}
    _read_only_ = {"bytes"}
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("name", c_char_p),
        ("bytes", c_void_p),
        ("byte_size", c_uint64),
        ("resolve", ResolveCallback.type),
        ("resolve_user", c_void_p),
    ]
    name: str | None
    bytes: Any
    byte_size: int
    resolve: Any
    resolve_user: Any


class Image(Struct):
    """Equirectangular image over the directions that light comes FROM, in Mitsuba 3's layout: column u = atan2(x,
    -z) / 2 pi (pixel-centred), row v = acos(y) / pi (row 0 is the pole itself, the last row the other
    pole).

    Fields:
    width: size, pixels, 2 to NICOL_MAX_SIZE
    height: size, pixels, 2 to NICOL_MAX_SIZE
    channels: number of colour channels, 1 to NICOL_MAX_CHANNELS
    components: Number of Stokes components. 1: s0 alone; 4: s0..s3 in the frame z = propagation, x = horizontal, along
        growing u as seen from the scene's centre, y = z cross x.
    pixels: Values [row][column][channel][component]: finite, s0 >= 0, sqrt(s1^2 + s2^2 + s3^2) up to s0
        (Eq. 70).
    row_stride: bytes from row to row; 0, the default: tightly packed
    byte_size: size of the memory that pixels points to, bytes; checked
    release: Release callback; NULL, the default: none. Called once the library no longer reads pixels, on failure
        too."""
    _callbacks_ = {"release": ReleaseCallback}
    _fields_ = [
        ("struct_size", c_uint32),
        ("width", c_uint32),
        ("height", c_uint32),
        ("channels", c_uint32),
        ("components", c_uint32),
        ("pixels", POINTER(c_float)),
        ("row_stride", c_uint64),
        ("byte_size", c_uint64),
        ("release", ReleaseCallback.type),
        ("release_user", c_void_p),
    ]
    width: int
    height: int
    channels: int
    components: int
    pixels: Any
    row_stride: int
    byte_size: int
    release: Any
    release_user: Any


class Sky(Struct):
    """Clear sky without the sun's own disc. At the angle g from the sun, the degree of linear polarization is
    dop_max sin^2 g / (1 + cos^2 g), the electric field is along sun x view, and s3 is 0.

    Turbidity 0: light is scattered once, with radiance * 3/4 (1 + cos^2 g) over the whole sphere, below the
    horizon too.

    Turbidity 1.7 (very clear) to 10 (hazy): brightness and, in three channels, colour follow Perez's formula,
    scaled so that the mean luminance over the upper half is 1, times radiance. Below the horizon is an
    unpolarized, uniform ground that reflects ground_albedo of each channel's irradiance. The sun must not be
    below the horizon.

    Fields:
    dop_max: largest degree of linear polarization, 0 (unpolarized) to 1, default 0.8
    sun_direction: direction to the sun, of any length but 0; default (0, 1, 0), straight up
    radiance: factor on the radiance, finite, not negative; default 1 in three channels
    turbidity: turbidity, 1.7 to 10, or 0, the default: light is scattered once
    ground_albedo: albedo of the ground, 0 to 1, default 0.2; without effect if turbidity is 0"""
    _fields_ = [
        ("struct_size", c_uint32),
        ("dop_max", c_float),
        ("sun_direction", c_float * 3),
        ("radiance", Spectrum),
        ("turbidity", c_float),
        ("ground_albedo", c_float),
    ]
    dop_max: float
    sun_direction: Any
    radiance: Any
    turbidity: float
    ground_albedo: float

    def get_sun(self) -> Light:
        """Fills a light with the sun of a sky: a directional light that comes from sun_direction, with an
        angular_radius of 0.27 degrees. Its value is an irradiance in the units of the sky's radiance. The sun is a
        black body of 5778 K and 128 klx above the atmosphere, attenuated by the air, haze and ozone of the sky's
        turbidity (Preetham et al. 1999). A sky of turbidity 0 gets the sun of turbidity 1.7. A sun below the
        horizon has a value of 0."""
        light = Light()
        check(_sky_get_sun(byref(self), byref(light)))
        return light


class EnvironmentLoadOptions(Struct):
    """Fields:
    scale: factor on the radiance, finite and not negative, default 1
    wavelengths: Wavelengths to read from a spectral OpenEXR file, nm, within the file's range: the nearest channels of
        the file, in this order. count 0, the default: all channels of the file."""
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("scale", c_double),
        ("wavelengths", Spectrum),
    ]
    scale: float
    wavelengths: Any


class EnvironmentInfo(Struct):
    """Fields:
    polarized: 1 if some s1, s2 or s3 is not 0, else 0
    circular: 1 if some s3 is not 0, else 0
    wavelength_count: number of wavelengths: channels for spectral light, else 0
    wavelengths: wavelengths of spectral light, nm"""
    _fields_ = [
        ("struct_size", c_uint32),
        ("channels", c_uint32),
        ("polarized", c_uint32),
        ("circular", c_uint32),
        ("wavelength_count", c_uint32),
        ("reserved", c_uint32),
        ("wavelengths", c_double * 16),
    ]
    channels: int
    polarized: int
    circular: int
    wavelength_count: int
    wavelengths: Any


class TextureImage(Struct):
    """Fields:
    width: size, pixels, 1 to 32768 each, and at most 3 * 2^26 pixels in all
    height: size, pixels, 1 to 32768 each, and at most 3 * 2^26 pixels in all
    channels: number of channels: 1, 3 (red, green, blue) or 4 (and coverage)
    pixels: values [row][column][channel], first row at the top; finite
    row_stride: bytes from row to row; 0, the default: tightly packed
    byte_size: size of the memory that pixels points to, bytes; checked"""
    _read_only_ = {"pixels"}
    _fields_ = [
        ("struct_size", c_uint32),
        ("type", c_uint32),
        ("width", c_uint32),
        ("height", c_uint32),
        ("channels", c_uint32),
        ("reserved", c_uint32),
        ("pixels", c_void_p),
        ("row_stride", c_uint64),
        ("byte_size", c_uint64),
    ]
    type: Any
    width: int
    height: int
    channels: int
    pixels: Any
    row_stride: int
    byte_size: int


class TextureOptions(Struct):
    """Fields:
    filter: filter, default bilinear
    wrap: wrap mode, default repeat
    raw: Encoding of integers. 0, the default: integers of 8 and 16 bits are decoded from sRGB, except coverage.
        1: integers are linear values, as for roughness, normals and heights. Floats are always linear
        values.
    to_uv: 3 x 3 transform from (u, v, 1) of the surface to that of the texture; last row 0 0 1; default the
        identity."""
    _fields_ = [
        ("struct_size", c_uint32),
        ("filter", c_uint32),
        ("wrap", c_uint32),
        ("raw", c_uint32),
        ("to_uv", c_double * 9),
    ]
    filter: Any
    wrap: Any
    raw: int
    to_uv: Any


class Film(Struct):
    """Thin film on a surface, such as an oxide, oil, soap or the coating of a lens. All reflections inside the
    film interfere: their complex amplitudes are summed for s and p apart (Airy). A channel of red, green or
    blue has the mean over its response to the spectrum, of the CIE 1931 observer under D65, clipped to what is
    physically possible; a channel of one wavelength is exact.

    Fields:
    thickness: thickness, nm, 0 to 10000; 0, the default: no film
    eta: real part of the refractive index, 0.1 to 100, default 1.5
    k: extinction coefficient of the refractive index, 0 to 100, default 0
    wavelengths: Wavelengths, one per channel of the material, nm, 100 to 5000. count 0, the default: red, green and
        blue."""
    _fields_ = [
        ("thickness", c_float),
        ("eta", c_float),
        ("k", c_float),
        ("reserved", c_uint32),
        ("wavelengths", Spectrum),
    ]
    thickness: float
    eta: float
    k: float
    wavelengths: Any


class Pplastic(Struct):
    """Plastic as Mitsuba 3's pplastic: rough Fresnel reflection over a diffuse base, both polarizing. Only the
    front side reflects.

    Fields:
    distribution: distribution of the facets, default Beckmann
    diffuse_reflectance: reflectance of the base, 0 to 1, default 0.5
    specular_reflectance: factor on the Fresnel reflection, 0 to 1, default 1
    int_ior: refractive index inside, above 0, default 1.49
    ext_ior: refractive index outside, above 0, default 1.000277
    alpha: roughness, 0.001 to 1, default 0.1
    diffuse_reflectance_texture: Texture that replaces diffuse_reflectance; NULL, the default: none.
    specular_reflectance_texture: Texture that replaces specular_reflectance; NULL, the default: none.
    alpha_texture: Texture whose first channel, clamped to 0.01 to 1, replaces alpha; NULL, the default: none.
    alpha_u: Roughness along texture coordinates u and v, 0.001 to 1; 0, the default: alpha. If the two differ, the
        surface is anisotropic, see nicol_conductor.
    alpha_u_texture: Textures that replace alpha_u and alpha_v; NULL, the default: none, but alpha_texture if the number is
        0.
    film: film on the boundary, default none
    film_thickness_texture: Texture whose first channel, clamped to 0 to 1, varies the thickness of the film: film_thickness_least
        at 0, film.thickness at 1, linear between; NULL, the default: none. A texture of more than 16 values is
        interpolated between up to 25 thicknesses.
    film_thickness_least: thickness of the film where its texture is 0, nm, 0 to 10000, default 0"""
    _fields_ = [
        ("struct_size", c_uint32),
        ("distribution", c_uint32),
        ("diffuse_reflectance", Spectrum),
        ("specular_reflectance", Spectrum),
        ("int_ior", c_float),
        ("ext_ior", c_float),
        ("alpha", c_float),
        ("reserved", c_uint32),
        ("diffuse_reflectance_texture", c_void_p),
        ("specular_reflectance_texture", c_void_p),
        ("alpha_texture", c_void_p),
        ("alpha_u", c_float),
        ("alpha_v", c_float),
        ("alpha_u_texture", c_void_p),
        ("alpha_v_texture", c_void_p),
        ("film", Film),
        ("film_thickness_texture", c_void_p),
        ("film_thickness_least", c_double),
    ]
    distribution: Any
    diffuse_reflectance: Any
    specular_reflectance: Any
    int_ior: float
    ext_ior: float
    alpha: float
    diffuse_reflectance_texture: Texture
    specular_reflectance_texture: Texture
    alpha_texture: Texture
    alpha_u: float
    alpha_v: float
    alpha_u_texture: Texture
    alpha_v_texture: Texture
    film: Film
    film_thickness_texture: Texture
    film_thickness_least: float


class Plastic(Struct):
    """Plastic as Mitsuba 3's plastic and roughplastic: Fresnel reflection over a diffuse base, both depolarizing.
    nicol_pplastic is the model that polarizes. Only the front side reflects.

    Fields:
    distribution: distribution of the facets of a rough surface, default Beckmann
    diffuse_reflectance: reflectance of the base, 0 to 1, default 0.5
    specular_reflectance: factor on the Fresnel reflection, 0 to 1, default 1
    int_ior: refractive index inside, above 0, default 1.49
    ext_ior: refractive index outside, above 0, default 1.000277
    alpha: roughness, 0.001 to 1; 0, the default: smooth, see alpha of nicol_conductor
    nonlinear: Whether light that the surface returns to the base takes the base's colour each time, which makes
        colours deeper: 0, the default, or 1.
    diffuse_reflectance_texture: Texture that replaces diffuse_reflectance; NULL, the default: none.
    specular_reflectance_texture: Texture that replaces specular_reflectance; NULL, the default: none.
    alpha_texture: Texture whose first channel, clamped to 0.01 to 1, replaces alpha; NULL, the default: none."""
    _fields_ = [
        ("struct_size", c_uint32),
        ("distribution", c_uint32),
        ("diffuse_reflectance", Spectrum),
        ("specular_reflectance", Spectrum),
        ("int_ior", c_float),
        ("ext_ior", c_float),
        ("alpha", c_float),
        ("nonlinear", c_uint32),
        ("diffuse_reflectance_texture", c_void_p),
        ("specular_reflectance_texture", c_void_p),
        ("alpha_texture", c_void_p),
    ]
    distribution: Any
    diffuse_reflectance: Any
    specular_reflectance: Any
    int_ior: float
    ext_ior: float
    alpha: float
    nonlinear: int
    diffuse_reflectance_texture: Texture
    specular_reflectance_texture: Texture
    alpha_texture: Texture


class Principled(Struct):
    """Disney's material as Mitsuba 3's principled. What it reflects is unpolarized. Light that passes the surface
    (spec_trans above 0) is followed as that of a rough nicol_dielectric. Only the front side reflects. Numbers
    are 0 to 1, default 0, unless stated otherwise.

    Fields:
    eta: Relative refractive index of the facets, 0.001 to 1000, default 1.5. 1: no facets, not even of a metal.
        Disney's `specular` corresponds to the index 2 / (1 - sqrt(0.08 specular)) - 1.
    base_color: colour of the base, 0 to 1, default 0.5
    roughness: roughness, 0 to 1, default 0.5; GGX facets have alpha = roughness^2
    anisotropic: Anisotropy: the facets' alpha along growing u is 1 / (1 - 0.9 anisotropic) times the alpha across
        u.
    spec_trans: Fraction of the diffuse base that transmits light instead of reflecting it, times the square root of
        base_color; the means of textures.
    spec_tint: Tint of the reflection, from white (0) to the tint of the base (1), which is its colour over its
        luminance.
    sheen_tint: tint of the sheen, from white (0) to the tint of the base (1)
    flatness: shape of the base, from diffuse (0) to one like subsurface scattering (1)
    base_color_texture: Textures: each replaces the number of its name; NULL, the default: the number is used.
        base_color_texture gives colours, and must not have the colours of a mesh beside spec_tint or
        sheen_tint. The other textures give their first channel, clamped to 0 to 1; roughness is clamped to 0.1
        to 1, anisotropic and clearcoat_gloss to 0.01 to 1."""
    _fields_ = [
        ("struct_size", c_uint32),
        ("eta", c_float),
        ("base_color", Spectrum),
        ("roughness", c_float),
        ("anisotropic", c_float),
        ("metallic", c_float),
        ("spec_trans", c_float),
        ("spec_tint", c_float),
        ("sheen", c_float),
        ("sheen_tint", c_float),
        ("flatness", c_float),
        ("clearcoat", c_float),
        ("clearcoat_gloss", c_float),
        ("reserved", c_uint32),
        ("base_color_texture", c_void_p),
        ("roughness_texture", c_void_p),
        ("anisotropic_texture", c_void_p),
        ("metallic_texture", c_void_p),
        ("spec_trans_texture", c_void_p),
        ("spec_tint_texture", c_void_p),
        ("sheen_texture", c_void_p),
        ("sheen_tint_texture", c_void_p),
        ("flatness_texture", c_void_p),
        ("clearcoat_texture", c_void_p),
        ("clearcoat_gloss_texture", c_void_p),
    ]
    eta: float
    base_color: Any
    roughness: float
    anisotropic: float
    metallic: float
    spec_trans: float
    spec_tint: float
    sheen: float
    sheen_tint: float
    flatness: float
    clearcoat: float
    clearcoat_gloss: float
    base_color_texture: Texture
    roughness_texture: Texture
    anisotropic_texture: Texture
    metallic_texture: Texture
    spec_trans_texture: Texture
    spec_tint_texture: Texture
    sheen_texture: Texture
    sheen_tint_texture: Texture
    flatness_texture: Texture
    clearcoat_texture: Texture
    clearcoat_gloss_texture: Texture


class Conductor(Struct):
    """Metal as Mitsuba 3's conductor and roughconductor: single reflection off the facets of an opaque metal. The
    complex index is eta - i k, relative to air. With k = 0 and the index of a dielectric as eta, the material
    reflects like the surface of the dielectric, such as glass whose inside is not seen. Only the front side
    reflects.

    Fields:
    distribution: distribution of the facets of a rough surface, default Beckmann
    alpha: Roughness, 0.001 to 1; 0, the default: smooth. Beckmann's facets of roughness 0.01 stand for a smooth
        surface, which is a blur of one degree. The factored method mirrors local lights with a size, and the
        image of an environment, without this blur; the reference method mirrors everything without it where
        the material has no other terms, such as smooth metal. A smooth surface does not reflect lights without
        a size (points, spots, projectors, and directional lights whose angular_radius is 0), because a mirror
        would show them as points.
    metal: Name of a metal with measured values: a name of Mitsuba's list such as "Au", "Ag", "Cu", "Al", "W" or
        "TiN_palik", or "gold", "silver", "copper" or "aluminium". eta and k must be empty beside a name. NULL,
        the default, or "": eta and k are used.
    eta: real part of the index, 0 to 100, default 0
    k: Extinction coefficient of the index, 0 to 100, default 1, which is a perfect mirror with eta = 0; eta^2
        + k^2 must be 1e-6 or more.
    wavelengths: Wavelengths of a named metal, one per channel, nm, 380 to 800. count 0, the default: red, green and
        blue as in Mitsuba, the colours of light with the spectra of eta and of k. A constant spectrum is white
        of equal energy.
    specular_reflectance: factor on the reflection, 0 to 1, default 1
    specular_reflectance_texture: Texture that replaces specular_reflectance; NULL, the default: none.
    alpha_texture: Texture whose first channel, clamped to 0.01 to 1, replaces alpha; NULL, the default: none.
    alpha_u: Roughness along texture coordinate u, 0.001 to 1, as of brushed metal; 0, the default: alpha. If
        alpha_u and alpha_v differ, the reflection follows the direction of u, which is arbitrary for a mesh
        without texture coordinates. Only light in harmonics, of the dense method, of
        NICOL_HIGH_ORDERS_CONVOLUTION and of bsdf_samples 0, is reflected with the roughness
        sqrt(alpha_u alpha_v).
    alpha_v: Roughness along texture coordinate v, 0.001 to 1; 0, the default: alpha.
    alpha_u_texture: Texture that replaces alpha_u; NULL, the default: none, but alpha_texture if alpha_u is 0.
    alpha_v_texture: Texture that replaces alpha_v; NULL, the default: none, but alpha_texture if alpha_v is 0.
    film: film on the facets, default none
    film_thickness_texture: Texture whose first channel, clamped to 0 to 1, varies the thickness of the film: film_thickness_least
        at 0, film.thickness at 1, linear between; NULL, the default: none. A texture of more than 16 values is
        interpolated between up to 25 thicknesses.
    film_thickness_least: thickness of the film where its texture is 0, nm, 0 to 10000, default 0"""
    _fields_ = [
        ("struct_size", c_uint32),
        ("distribution", c_uint32),
        ("alpha", c_float),
        ("reserved", c_uint32),
        ("metal", c_char_p),
        ("eta", Spectrum),
        ("k", Spectrum),
        ("wavelengths", Spectrum),
        ("specular_reflectance", Spectrum),
        ("specular_reflectance_texture", c_void_p),
        ("alpha_texture", c_void_p),
        ("alpha_u", c_float),
        ("alpha_v", c_float),
        ("alpha_u_texture", c_void_p),
        ("alpha_v_texture", c_void_p),
        ("film", Film),
        ("film_thickness_texture", c_void_p),
        ("film_thickness_least", c_double),
    ]
    distribution: Any
    alpha: float
    metal: str | None
    eta: Any
    k: Any
    wavelengths: Any
    specular_reflectance: Any
    specular_reflectance_texture: Texture
    alpha_texture: Texture
    alpha_u: float
    alpha_v: float
    alpha_u_texture: Texture
    alpha_v_texture: Texture
    film: Film
    film_thickness_texture: Texture
    film_thickness_least: float


class Dielectric(Struct):
    """Glass as Mitsuba 3's dielectric, roughdielectric and thindielectric: a boundary that reflects and transmits
    light, polarized as Fresnel's formulas say. The factored method follows light through it by rays at pixels,
    the reference method by its paths; max_depth of nicol_render_options limits how often. By the factored
    method with a max_depth above 2, smooth glass and smooth metal bend the light of local lights to other
    surfaces, as unpolarized light: 131,072 paths, found anew when local lights, bright parts of the
    environment or surfaces change or turn, make caustics. Otherwise, and through rough glass, the light of
    local lights passes straight on, dimmed in each channel as unpolarized light is; the light of the
    environment passes straight on and is dimmed equally in all channels, by their mean. Metal of a roughness
    below 0.25 shows the environment as glass bends it. The dense method and shading at vertices return
    NICOL_ERROR_UNSUPPORTED. The surface of a body must be closed, its normals pointing outwards, and bodies
    must not overlap.

    Fields:
    thin: 0, the default: the surface bounds a body, and refracts the light that it transmits. 1: the surface is
        a thin pane, such as a window of one rectangle, which transmits light straight on; all reflections
        inside the pane are summed, without interference.
    int_ior: refractive index inside, 0.001 to 1000, default 1.5046 (borosilicate glass)
    ext_ior: refractive index outside, 0.001 to 1000, default 1.000277 (air)
    specular_reflectance: factor on reflected light, 0 to 1, default 1
    specular_transmittance: factor on transmitted light, 0 to 1, default 1
    absorption: Absorption coefficient of the inside, per unit of length in the world, 0 or more, default 0: a path of
        length d through the body transmits exp(-absorption d) (Beer's law). Only 0 for a thin pane.
    alpha: Roughness of facets, 0.001 to 1; 0, the default: smooth. Light through a rough surface is sampled at
        each pixel, so it is noisy; more pixel_samples reduce the noise. The factored method shows no lights
        without a size (points, spots, projectors, and directional lights whose angular_radius is 0) through
        glass. A smooth surface does not reflect them either.
    distribution: distribution of the facets of a rough surface, default Beckmann
    alpha_texture: Texture whose first channel, clamped to 0.01 to 1, replaces alpha; NULL, the default: none. The texture
        varies what a body reflects; facets that transmit light, and those of a thin pane, have its mean.
    film: Film on the boundary, or on both sides of a thin pane, default none. A soap film in air is a film on a
        body whose int_ior equals ext_ior."""
    _fields_ = [
        ("struct_size", c_uint32),
        ("thin", c_uint32),
        ("int_ior", c_float),
        ("ext_ior", c_float),
        ("specular_reflectance", Spectrum),
        ("specular_transmittance", Spectrum),
        ("absorption", Spectrum),
        ("alpha", c_float),
        ("distribution", c_uint32),
        ("alpha_texture", c_void_p),
        ("film", Film),
    ]
    thin: int
    int_ior: float
    ext_ior: float
    specular_reflectance: Any
    specular_transmittance: Any
    absorption: Any
    alpha: float
    distribution: Any
    alpha_texture: Texture
    film: Film


class Measured(Struct):
    """Fields:
    sampling: Interpolation between measured wavelengths, default linear; used only for the wavelengths of the next
        field.
    wavelengths: Wavelengths, one per channel, nm, 100 to 5000. count 0, the default: red, green and blue by the CIE
        1931 observer under D65, or one channel if the file has one wavelength.
    symmetrize: Whether the part that breaks mirror symmetry, which contains noise of the measurement, is removed: 0,
        the default, or 1."""
    _fields_ = [
        ("struct_size", c_uint32),
        ("sampling", c_uint32),
        ("wavelengths", Spectrum),
        ("symmetrize", c_uint32),
    ]
    sampling: Any
    wavelengths: Any
    symmetrize: int


class PshMatrix(Struct):
    """Fields:
    symmetrize: whether the part that breaks mirror symmetry is removed: 0, the default, or 1
    scale: factor on the matrix, not negative, default 1"""
    _fields_ = [
        ("struct_size", c_uint32),
        ("symmetrize", c_uint32),
        ("scale", Spectrum),
    ]
    symmetrize: int
    scale: Any


class CallbackMaterial(Struct):
    """Fields:
    channels: number of colour channels, 1 to NICOL_MAX_CHANNELS, default 1
    user: first argument of mueller, and the argument of release
    release: Release callback; NULL, the default: none. Called once, when `user` is no longer needed: on failure
        before the call returns, else when the material and all its users are released, on the thread of the
        last release.
    lobe_width: Angular radius of the narrowest feature about the mirror direction, radians, 0.001 to 1, default 1. A
        value that is too large loses highlights; a value that is too small costs time."""
    _callbacks_ = {"mueller": MuellerCallback, "release": ReleaseCallback}
    _fields_ = [
        ("struct_size", c_uint32),
        ("channels", c_uint32),
        ("mueller", MuellerCallback.type),
        ("user", c_void_p),
        ("release", ReleaseCallback.type),
        ("lobe_width", c_float),
        ("reserved", c_uint32),
    ]
    channels: int
    mueller: Any
    user: Any
    release: Any
    lobe_width: float


class MeshData(Struct):
    """Triangles in memory. All numbers must be finite and all indices valid. Triangles without area are left out,
    and logged once.

    Fields:
    vertex_count: number of vertices, 1 or more
    triangle_count: number of triangles, 1 or more
    texcoord_count: Number of pairs in texcoords; 0, the default: vertex_count if texcoords is not NULL.
    positions: positions, 3 numbers per vertex
    normals: Normals, 3 numbers per vertex, of any length; a normal of length 0 stands for the smooth normal. NULL,
        the default: normals made from the triangles, smooth across edges whose faces share vertices.
    indices: vertex indices, 3 per triangle, counter-clockwise from the front
    texcoords: texture coordinates u, v, see nicol_texture_image; NULL, the default: none
    texcoord_indices: Indices into texcoords, 3 per triangle, so that a seam of texture coordinates splits no vertex. NULL,
        the default: indices is used, with one pair of texture coordinates per vertex.
    colors: Linear colours, 3 per vertex, see nicol_texture_create_vertex_colors; NULL, the default: none.
    face_colors: Linear colours, 3 per triangle, see nicol_texture_create_face_colors; NULL, the default: none.
    tangents: Tangents, 4 numbers per pair in texcoords, as in glTF: x, y and z, of any length, are the x axis of
        normal maps and of anisotropic materials, which otherwise is the direction of growing u; the y axis is
        w cross(normal, x), w 1 or -1. NULL, the default, or of length 0: the directions of u and v."""
    _fields_ = [
        ("struct_size", c_uint32),
        ("vertex_count", c_uint32),
        ("triangle_count", c_uint32),
        ("texcoord_count", c_uint32),
        ("positions", POINTER(c_float)),
        ("normals", POINTER(c_float)),
        ("indices", POINTER(c_uint32)),
        ("texcoords", POINTER(c_float)),
        ("texcoord_indices", POINTER(c_uint32)),
        ("colors", POINTER(c_float)),
        ("face_colors", POINTER(c_float)),
        ("tangents", POINTER(c_float)),
    ]
    vertex_count: int
    triangle_count: int
    texcoord_count: int
    positions: Any
    normals: Any
    indices: Any
    texcoords: Any
    texcoord_indices: Any
    colors: Any
    face_colors: Any
    tangents: Any


class Deformation(Struct):
    """Other places of a mesh's vertices, such as those of the next frame of an animated character.

    Fields:
    vertex_count: number of vertices of the mesh, see nicol_mesh_get_size
    positions: positions, 3 finite numbers per vertex
    normals: Normals, 3 finite numbers per vertex, of any length; a normal of length 0 stands for the smooth normal.
        NULL, the default: smooth normals."""
    _fields_ = [
        ("struct_size", c_uint32),
        ("vertex_count", c_uint32),
        ("positions", POINTER(c_float)),
        ("normals", POINTER(c_float)),
    ]
    vertex_count: int
    positions: Any
    normals: Any


class Camera(Struct):
    """Fields:
    projection: projection, default perspective
    to_world: Transform from camera space to the world, with axes at right angles and right-handed; default the
        identity. Camera space is Mitsuba's: +z forward, +y up, +x to the image's LEFT. A scale in x and y is
        the half extent of an orthographic image.
    fov: horizontal field of view if perspective, degrees, above 0, below 180, default 45
    near_clip: near distance along +z, in the scene's units, above 0, default 0.01
    far_clip: Far distance along +z, in the scene's units, above near_clip, default 10000. INFINITY: a perspective
        camera has no far plane.
    jitter: Sample point inside each pixel, relative to its centre, in pixels to the right and down, -0.5 to 0.5
        each, default 0. The mean of images with different jitter is anti-aliased.
    shift: Offset of the image's middle from the view direction (the principal point), right and down, in widths
        and heights of the image, -1e5 to 1e5 each, default 0. A crop of a larger image has its own fov and
        shift.
    pixel_aspect: width of a pixel over its height on the image plane, 0.01 to 100, default 1"""
    _fields_ = [
        ("struct_size", c_uint32),
        ("projection", c_uint32),
        ("to_world", c_double * 16),
        ("fov", c_double),
        ("near_clip", c_double),
        ("far_clip", c_double),
        ("jitter", c_double * 2),
        ("shift", c_double * 2),
        ("pixel_aspect", c_double),
    ]
    projection: Any
    to_world: Any
    fov: float
    near_clip: float
    far_clip: float
    jitter: Any
    shift: Any
    pixel_aspect: float

    def look_at(self, origin: Any, target: Any, up: Any) -> Self:
        """Sets to_world, and no other field, to that of a camera at `origin` that looks at `target`. `up` must not
        lie along the view."""
        check(_camera_look_at(byref(self), array(origin, c_double, 3), array(target, c_double, 3), array(up, c_double, 3)))
        return self

    def set_opencv(self, K: Any, R: Any, t: Any, width: int, height: int) -> Self:
        """Sets to_world, fov, shift, pixel_aspect and projection, and no other field, to those of a pinhole camera in
        OpenCV's convention: a point X of the world is at x = R X + t, with x[0] to the right, x[1] down and x[2]
        forward, and there at the pixel (fx x[0] / x[2] + cx, fy x[1] / x[2] + cy), where (0, 0) is the MIDDLE of
        the first pixel and K = [fx 0 cx; 0 fy cy; 0 0 1]. Matrices are row-major. Undistort images first: there is
        no lens distortion. (COLMAP has the same R and t, and 0.5 more in cx and cy.)"""
        check(_camera_set_opencv(byref(self), array(K, c_double, 9), array(R, c_double, 9), array(t, c_double, 3), width, height))
        return self

    def get_opencv(self, width: int, height: int) -> tuple[tuple[float, ...], tuple[float, ...], tuple[float, ...]]:
        """Gets the pinhole camera of a perspective camera, for an image of this size; jitter is left out."""
        K = (c_double * 9)()
        R = (c_double * 9)()
        t = (c_double * 3)()
        check(_camera_get_opencv(byref(self), width, height, K, R, t))
        return tuple(K), tuple(R), tuple(t)

    def frame(self, lower: Any, upper: Any, width: int, height: int) -> Self:
        """Moves the camera, without turning it, so that the box from `lower` to `upper` is in the image of this size
        and as large as it can be. near_clip and far_clip enclose the box; an orthographic camera gets another half
        extent. nicol_scene_get_bounds has the box of a scene."""
        check(_camera_frame(byref(self), array(lower, c_double, 3), array(upper, c_double, 3), width, height))
        return self


class Polarization(Struct):
    """Polarization of the emission of a light, equal in all directions. The frame, as seen by a viewer who looks into the
    light:

     y|  / E-vector
      | /    z  points towards the viewer, along the light
      |/     x  is the part of axis perpendicular to z (for an axis along z: growing angle from the light's own +z)
      +---x  y  = z cross x; the AoLP counts from x to y, counter-clockwise

    A sheet polarizer before the light that absorbs along `axis` is dolp 1 and aolp pi / 2, seen from anywhere. A
    quarter-wave plate behind this polarizer gives docp 1 or -1.

    Fields:
    dolp: degree of linear polarization, 0 to 1, default 0
    aolp: angle of linear polarization, radians as NICOL_PLANE_AOLP, finite, default 0
    docp: Ratio s3 / s0, -1 (left circular) to 1 (right), default 0; dolp^2 + docp^2 may be up to 1.
    axis: direction of AoLP 0, in the light's own axes, of any length but 0; default (1, 0, 0)"""
    _fields_ = [
        ("dolp", c_double),
        ("aolp", c_double),
        ("docp", c_double),
        ("axis", c_double * 3),
    ]
    dolp: float
    aolp: float
    docp: float
    axis: Any


class Light(Struct):
    """Local light without a surface, beside the environment. In its own axes the light emits along +z, from the
    origin unless it is directional. +y is up, and +x is to the left of a viewer who looks along +z, as for
    cameras. Fields of other kinds have no effect.

    Fields:
    kind: kind of light, default point
    value: Brightness, finite and not negative, default 1. Directional: irradiance on a surface that faces the
        light, which is the irradiance from the whole disc for a light with a size. Point and spot: radiant
        intensity, power per solid angle; for a spot, the intensity on the axis. Projector: irradiance on the
        plane at distance 1.
    to_world: rotation and translation of the light, default the identity
    angular_radius: directional: disc's radius, degrees, 0 to 90, default 0; the sun's is 0.27
    cutoff_angle: spot: angle from the axis to the edge, degrees, 0.01 to 90, default 20
    beam_width: Spot: angle from the axis at which the intensity begins to fall, degrees, 0 to cutoff_angle, default
        15. The intensity reaches 0 at cutoff_angle, linearly in the angle.
    fov: projector: angle of the rectangle's width, degrees, 0.01 to 179.98, default 45
    aspect: projector: width over height of the rectangle, above 0, default 1
    texture: Spot: factor on the intensity, over the square around the cone. Projector: factor on value, over the
        rectangle. The texture has 1 or 3 channels, is not negative, and has no colours of a mesh; the image's
        top is up. NULL, the default: 1.
    polarization: polarization of the emission, default unpolarized"""
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_uint32),
        ("value", Spectrum),
        ("reserved", c_uint32),
        ("to_world", c_double * 16),
        ("angular_radius", c_double),
        ("cutoff_angle", c_double),
        ("beam_width", c_double),
        ("fov", c_double),
        ("aspect", c_double),
        ("texture", c_void_p),
        ("polarization", Polarization),
    ]
    kind: Any
    value: Any
    to_world: Any
    angular_radius: float
    cutoff_angle: float
    beam_width: float
    fov: float
    aspect: float
    texture: Texture
    polarization: Polarization


class Emission(Struct):
    """Emission of an instance, in addition to its reflection.

    Fields:
    two_sided: whether both sides emit: 1, or 0, the default: the front alone
    radiance: radiance, finite and not negative, default 1
    texture: Factor on radiance: 1 or 3 channels, not negative; NULL, the default: 1. If both the texture and the
        material use colours of the mesh, both use those of its vertices, or both those of its triangles.
    polarization: polarization of the emission, whose axis is in the mesh's axes"""
    _fields_ = [
        ("struct_size", c_uint32),
        ("two_sided", c_uint32),
        ("radiance", Spectrum),
        ("reserved", c_uint32),
        ("texture", c_void_p),
        ("polarization", Polarization),
    ]
    two_sided: int
    radiance: Any
    texture: Texture
    polarization: Polarization


class PolarizationElement(Struct):
    """Ideal, infinitely thin polarization element. The camera sees what is behind the element through its Mueller matrix.
    Several elements along a ray act in their order. An element casts no shadow, and light passes it unchanged on its way
    to surfaces. In its own axes an element lies in the plane z = 0 about the origin; light passes in both directions with
    equal effect.

      y
      |  / axis   x  is where to_world takes the element's x, z its normal, and y = z cross x
      | /) angle
      +------x

    Light at an angle to the normal is treated as in Mitsuba 3. A polarizer absorbs along the part of its absorbing axis
    that is perpendicular to the ray. The retardance is multiplied by the cosine of the angle. The effective fast axis of
    a retarder is the part of its fast axis that is perpendicular to the ray, whereas Mitsuba 3.9 rotates the fast axis
    with the tilt.

    Fields:
    kind: kind of element, default polarizer
    outline: outline, default rectangle
    to_world: Transform from the element's axes to the world: affine, invertible, last row 0 0 0 1; default the
        identity.
    angle: Angle of a polarizer's transmission axis or of a retarder's fast axis, degrees from x to y, -1e6 to
        1e6, default 0. The angle has no effect on circular polarizers, which have no axis.
    retardance: Retardance of a retarder at normal incidence, degrees, -1e6 to 1e6, default 90, a quarter-wave plate.
    transmittance: factor on the transmittance of the ideal element, 0 to 1, default 1
    angle_texture: factor on angle, in the first channel; NULL, the default: 1
    retardance_texture: Factor on the retardance of a retarder: one channel, or red, green and blue, as of a plate whose
        retardance is a length; NULL, the default: 1."""
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_uint32),
        ("outline", c_uint32),
        ("reserved", c_uint32),
        ("to_world", c_double * 16),
        ("angle", c_double),
        ("retardance", c_double),
        ("transmittance", c_double),
        ("angle_texture", c_void_p),
        ("retardance_texture", c_void_p),
    ]
    kind: Any
    outline: Any
    to_world: Any
    angle: float
    retardance: float
    transmittance: float
    angle_texture: Texture
    retardance_texture: Texture


class Instance(Struct):
    """Fields:
    flags: Sum of NICOL_INSTANCE_...; 0, the default: the instance casts and receives shadows and is visible. Its
        emission lights the scene with any flags. Invisible smooth glass dims no light.
    to_world: Transform from the mesh's axes to the world: affine, invertible, last row 0 0 0 1; default the
        identity."""
    _fields_ = [
        ("struct_size", c_uint32),
        ("flags", c_uint32),
        ("mesh", c_void_p),
        ("material", c_void_p),
        ("to_world", c_double * 16),
    ]
    flags: int
    mesh: Mesh
    material: Material
    to_world: Any


class SceneFile(Struct):
    """Fields:
    path: path with which the file was opened; lives as long as the scene
    digest: Digest of the bytes that were read: 32 hexadecimal digits, not a cryptographic hash; lives as long as
        the scene."""
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("path", c_char_p),
        ("digest", c_char_p),
        ("bytes", c_uint64),
    ]
    path: str | None
    digest: str | None
    bytes: int


class Filter(Struct):
    """Reconstruction filter of an image. A pixel is the weighted mean of the samples of all pixels within the
    filter's radius; no samples lie beyond the border of the image. The filter applies to each Stokes component
    and not to AOVs, except that the reference method's alpha and variance are those of the weighted samples.

    Fields:
    kind: kind of filter, default box
    size: Gaussian: standard deviation, 0.125 to 4 pixels. Tent: radius, 0.5 to 16 pixels. Lanczos: number of
        lobes on each side, 1 to 16. 0, the default: 0.5, 1 and 3. No effect on other kinds.
    b: Mitchell: blur, 0 to 1, default 1/3
    c: Mitchell: ringing, 0 to 1, default 1/3"""
    _fields_ = [
        ("kind", c_uint32),
        ("reserved", c_uint32),
        ("size", c_double),
        ("b", c_double),
        ("c", c_double),
    ]
    kind: Any
    size: float
    b: float
    c: float


class RenderOptions(Struct):
    """Options of a render. The reference method uses only samples, seed, max_depth, shadows, aovs, filter,
    progress and NICOL_OPTIMISATION_UNCHANGED; the other options are those of the factored and the dense
    method.

    Fields:
    method: method, default factored
    order_low: Highest order of the light that is shaded with the material's full response, 0 to NICOL_MAX_ORDER;
        default NICOL_ORDER_AUTOMATIC, see tolerance.
    order_high: Highest order of the light that is rendered, at most 64; default NICOL_ORDER_AUTOMATIC, see tolerance.
        high_orders renders the orders above order_low; there are none if order_high is order_low or
        below.
    high_orders: reflection of the orders above order_low, default split
    shadows: Whether surfaces shadow each other and themselves: 1, the default, or 0.
    bake_directions: Number of directions of rays at each vertex, 256 to 65536. More directions take more time and memory to
        bake and leave less noise in the shadows. NICOL_DIRECTIONS_AUTOMATIC, the default: 2048. If orders are
        chosen, the automatic number is 1024 for a tolerance of 0.03 or more, which leaves noise of about a
        tenth of 0.03, 2048 down to 0.015, 4096 down to 0.0075, else 8192.
    physical: Whether Stokes vectors are made physically realizable (Eq. 70), 1, the default, or 0: s0 below 0
        becomes 0, and polarization beyond s0 is shortened to s0, which stays. Truncated light may violate
        both. The correction is made at vertices, or at pixels if pixels are shaded. If orders are chosen,
        light that is as weak as the predicted error becomes less polarized, so that there is no false DoLP in
        the dark.
    dering: Strength of the window against ringing, finite and not negative, default 0 (no window); 0.0001 to 0.01
        are of use. The light's order l is multiplied by 1 / (1 + dering (l (l + 1))^2).
    progress: Progress callback; NULL, the default: none. The verbs are project, bake, relight, shade and draw; the
        reference method has the verb trace.
    samples: Number of camera rays per pixel of the reference method, 1 to 2^20, default 256. Powers of two are
        spread best.
    executor: device that runs relight and shade, default automatic
    seed: Seed of the reference method and of the samples of lights and lobes, default 0. Equal seeds give equal
        images, whatever the number of threads.
    tolerance: Largest predicted error of the orders left out and of shadows between baked vertices if both orders are
        automatic, finite and not negative, default 0.03: the RMSE of s0, s1 and s2 relative to the RMS of s0.
        The fastest orders are chosen, order_low up to 16, that keep what shadows leave of the tolerance, or
        half of it. If no orders do, the product of squared error and a frame's time decides among orders that
        err at most 1.5 times as much as the best ones. The error of the DoLP, as the mean over pixels, is no
        larger than the prediction. Orders are as high as fits if the data of vertices would exceed 1 GiB or
        the context's memory_limit. Automatic orders are 4 and 9 without a prediction: for the dense method,
        for convolution, for a tolerance of 0, and beside an order that is given.
    components: Stokes components of the image, default all
    disabled_optimisations: Sum of NICOL_OPTIMISATION_... to disable, in order to measure what the optimisations save; default 0:
        none. Compute shaders shade all vertices and rows in any case.
    high_order_shadows: Whether high orders are multiplied by the visible fraction of their lobe: 1, the default, or 0
        (unshadowed highlights).
    aovs: sum of NICOL_AOV_... to make, default 0: none
    shade_at: place of shading, default automatic
    pixel_samples: Number of samples per pixel of the real-time methods, 1 to 1024; 0, the default, is 1. A pixel is the
        mean of surfaces and environment, weighted by the number of samples that show them. 4 and 8 samples are
        drawn together: shading at pixels shades each surface once per pixel, at the mean of its samples, but
        for narrow highlights of local lights on normal maps, which each sample has of its own. Other numbers
        are drawn and shaded one by one, each sample at the cost of an image, which also averages normal maps
        and soft shadows; AOVs are then those of 8 samples.
    refine_tolerance: Largest interpolation error of shadows, as a fraction of the light, 0 to 1, default 0.02; 0: no
        triangle is split. The bake splits triangles where shadows change faster than the mesh is fine, until
        the error of uniform light is at most this fraction of what arrives, or of a quarter of it all.
    max_vertices: Largest number of vertices after splitting; 0, the default: 65536, or four times the original number if
        that is more. A memory_limit lowers the number.
    split_lights: Largest number of extracted lights of the factored method: bright parts of the environment, such as a
        sun, that are taken out of the environment and rendered as local lights. 0 to NICOL_MAX_SPLIT_LIGHTS;
        default NICOL_SPLIT_AUTOMATIC: the lights that the orders would miss.
    light_samples: Number of light samples of the real-time methods, per local light with a size and per point or pixel, 1
        to 1024, default 16; up to twice as many for very wide lights. Fewer are faster and noisier.
    bsdf_samples: Largest number of samples of the environment, per lobe and per point or pixel, that the factored method
        takes for lobes which harmonics cannot hold, 0 to 1024, default 32: anisotropic lobes, and lobes
        narrower than 0.1 if the environment is an image or surfaces hide it from each other. If
        pixel_samples is above 1 and both orders are automatic, the limit rises to at most 0.35 for lobes
        that a tenth of the image shows at grazing angles. Longer lobes take more; those of GGX up to half
        as many again. Samples are weighted by the pBRDF, see the environment averaged over the gaps between
        them, and cast shadow rays. 0: none; all lobes are those of harmonics, and anisotropic ones round.
    max_depth: Largest number of segments of a path from the camera to a light, counted as Mitsuba's max_depth: 1 is
        light that the camera sees directly, 2 adds light that a surface reflects once (direct light), 3 adds
        light that two surfaces reflect, and so on; NICOL_DEPTH_UNLIMITED: no limit. 0, the default: 2. The
        factored method computes the light that surfaces reflect to each other at vertices, up to order 3 of
        its incident field (5 without an environment), and stops at 0.002 of all light; rays from pixels find
        what mirrors and narrow lobes of metal reflect. It refuses 1 and the dense method refuses everything
        but 0 and 2, with NICOL_ERROR_UNSUPPORTED. More than 2 needs shadows. Smooth glass and mirrors count as
        well: the rays of the factored method have max_depth - 1 reflections and refractions, at most 64, but
        eight for 0 and 2, because direct light would not leave a body of glass.
    fail_if_busy: Behaviour of nicol_render and nicol_render_views while another render of the scene runs, such as a job.
        0, the default: they wait; 1: they return NICOL_ERROR_BUSY. No effect on nicol_render_async.
    bake_budget_ms: Time that a render of a real-time method spends on shadows, bake and relight of changed vertices, in
        milliseconds: about that much, and at least one step. 0, the default: as long as the final picture
        takes. Above 0, a render uses the shadows that are there, and the next renders, also of an unchanged
        scene, go on: nearest to the change and visible first. vertices_pending of the statistics says how much
        is left; at 0 the picture is that of a render without a budget. Until then it approximates: a vertex
        keeps its former shadows, those of a moved or deformed object on itself move with it, a new object
        casts and receives none, and orders stay as chosen before. The cache folder is not used for these
        shadows. A scene that was rendered with a budget stays divided into steps; 0 then completes all of
        them.
    filter: Reconstruction filter, default box: a pixel is the mean of its own samples. With any other filter, the
        real-time methods draw and shade all numbers of pixel_samples one by one, and the reference method
        places its samples by the filter.
    time_budget_ms: Time that a frame of a real-time method may take on this machine, in milliseconds, without project and
        bake, which do not repeat; finite and not negative. 0, the default: as long as it takes, and the
        picture does not depend on time. Above 0, the options are the best picture that is wanted, and the
        scene's renders measure how much of it they can keep. They give up pixel_samples, light_samples and
        bsdf_samples (down to a quarter) and, if automatic, shading at pixels and orders (down to those of
        eight times the tolerance): what loses least and saves enough. Two frames in succession that exceed the
        budget by a tenth lower the effort; eight in succession below 0.7 of it may raise it. The statistics
        say what was given up (given_up). A scene that does not change keeps its picture."""
    _callbacks_ = {"progress": ProgressCallback}
    _fields_ = [
        ("struct_size", c_uint32),
        ("method", c_uint32),
        ("order_low", c_uint32),
        ("order_high", c_uint32),
        ("high_orders", c_uint32),
        ("shadows", c_uint32),
        ("bake_directions", c_uint32),
        ("physical", c_uint32),
        ("dering", c_double),
        ("progress", ProgressCallback.type),
        ("progress_user", c_void_p),
        ("samples", c_uint32),
        ("executor", c_uint32),
        ("seed", c_uint64),
        ("tolerance", c_double),
        ("components", c_uint32),
        ("disabled_optimisations", c_uint32),
        ("high_order_shadows", c_uint32),
        ("aovs", c_uint32),
        ("shade_at", c_uint32),
        ("pixel_samples", c_uint32),
        ("refine_tolerance", c_double),
        ("max_vertices", c_uint64),
        ("split_lights", c_int32),
        ("light_samples", c_uint32),
        ("bsdf_samples", c_uint32),
        ("max_depth", c_int32),
        ("fail_if_busy", c_uint32),
        ("reserved", c_uint32),
        ("bake_budget_ms", c_double),
        ("filter", Filter),
        ("time_budget_ms", c_double),
    ]
    method: Any
    order_low: int
    order_high: int
    high_orders: Any
    shadows: int
    bake_directions: int
    physical: int
    dering: float
    progress: Any
    progress_user: Any
    samples: int
    executor: Any
    seed: int
    tolerance: float
    components: Any
    disabled_optimisations: int
    high_order_shadows: int
    aovs: int
    shade_at: Any
    pixel_samples: int
    refine_tolerance: float
    max_vertices: int
    split_lights: int
    light_samples: int
    bsdf_samples: int
    max_depth: int
    fail_if_busy: int
    bake_budget_ms: float
    filter: Filter
    time_budget_ms: float

    def set_quality(self, quality: Any) -> Self:
        """Sets the options of the real-time methods that trade time for accuracy: tolerance, pixel_samples,
        bake_directions, refine_tolerance, light_samples and bsdf_samples. All other options stay. Options that are
        set afterwards win. Returns NICOL_ERROR_INVALID_ARGUMENT for another quality."""
        check(_render_options_set_quality(byref(self), quality))
        return self


class JobStatus(Struct):
    """Fields:
    result: result of a job that is done, as nicol_render would return it; else NICOL_OK
    fraction: fraction of the current verb, 0 to 1; 1 after success
    verb: Verb of a progress callback, "" before the job runs and once it is done; lives as long as the
        library."""
    _fields_ = [
        ("struct_size", c_uint32),
        ("state", c_uint32),
        ("result", c_int32),
        ("reserved", c_uint32),
        ("fraction", c_double),
        ("verb", c_char_p),
    ]
    state: Any
    result: Any
    fraction: float
    verb: str | None


class Statistics(Struct):
    """Statistics of the last render into a framebuffer. Milliseconds are 0 for verbs that did not run.

    Fields:
    order: highest order of the rendered light: order_high, or less if the light has no more,
                                               but at least order_low; 0 with the reference method
    vertices: number of vertices of all instances, including vertices_added
    triangles: number of triangles of all instances
    project_ms: time of projecting light and materials to coefficients, tables and lobes
    bake_ms: time of baking visibility at the vertices, and the dense method's matrices; with the
                                               reference method, its hierarchy of triangles and table of light
    relight_ms: time of bringing light, times shadows, into the vertices' frames
    shade_ms: time of multiplying light by the response at the view, high orders included
    draw_ms: time of rasterisation, of interpolation between shaded vertices, or of copying the
                                               image into the framebuffer
    observe_ms: time of reading and writing images since the last render
    bake_trace_ms: part of bake_ms that traced rays; 0 if the bake came from the cache
    bake_rays: rays that the bake traced; 0 if the bake came from the cache
    vertices_skipped: vertices not shaded because they face away or lie outside the view
    vertices_unoccluded: vertices with nothing above their horizon, and so no shadow to compute
    vertices_unphysical: vertices, times channels, that `physical` moved into the physically realizable range;
                                               pixels are not counted
    light_columns_skipped: Stokes components of the light that are zero everywhere, times channels
    response_rows_skipped: Stokes components that no material reflects, times channels
    channels_shared: colour channels of light that are multiples of one and are not computed again
    response_bytes: bytes of material tables
    visibility_bytes: bytes of visibility by direction at each vertex
    transfer_bytes: bytes kept for relight and shade: light, shadows, matrices and geometry per vertex,
                                               focused light, the surfaces that pixels show, and the image, unless OpenGL draws
                                               it
    buffer_bytes: bytes of OpenGL buffers: vertices, triangles, and work space of compute shaders
    texture_bytes: bytes of OpenGL textures, framebuffer included
    camera_rays: rays from the camera: of the reference method, or those that found the triangles
                                               at pixels where these are much finer than pixels; 0: triangles were drawn, or the
                                               triangles of the image before were kept
    shadow_rays: reference: rays towards the light
    trace_ms: reference: time of tracing rays
    compute: 1 if compute shaders relit and shaded, 0 if threads did
    order_low: order_low of the rendered light, as the option says or as it was chosen
    predicted_error: predicted error of the orders left out, if a tolerance was given, of shadows
                                               between baked vertices, of interpolation between shaded vertices, of the samples
                                               of lights and lobes, and of bounced light: of surfaces, relative to the RMS of
                                               their s0, without edges of objects, shadows and textures, which are
                                               pixel_samples'
    lights_projected: environments projected to coefficients
    materials_projected: tables, matrices and sets of lobes of materials, also from the cache folder
    vertices_traced: vertices whose shadows the bake found, by rays or because nothing can block them
    matrices_baked: dense: matrices of vertices
    vertices_relit: vertices into whose frames light was brought: of threads, those that the image shows
    vertices_shaded: vertices whose Stokes vectors were computed
    pixels_shaded: pixels whose Stokes vectors were computed
    vertices_added: vertices that the bake added by splitting triangles, and their small reserve, recomputed or kept
    local_lights: local lights: the scene's, each instance that emits light, and lights_split
    lights_split: extracted lights that were taken out of the environment
    light_rays: real-time methods: rays from vertices and pixels to local lights, and of the light
                                               that glass and mirrors focus or narrow lobes send on
    light_ms: part of shade_ms for local lights, their shadows and the light that glass and mirrors
                                               focus, which is found anew when lights or surfaces change
    smooth_rays: real-time methods: rays from pixels that show glass, mirrors or narrow lobes of
                                               metal, by threads; 0 if compute shaders shaded: smooth surfaces then mirror
                                               lights alone, no surfaces, and narrow lobes the light at vertices
    vertices_pending: vertices whose shadows are not final (bake_budget_ms); 0: the picture is
    bounce_ms: real-time methods: part of relight_ms for light that surfaces reflect to each other
    bounce_links: pairs of a vertex and a point of a surface that it sees, along which light bounces
    bounce_rounds: bounces that were computed; 0: direct light alone
    bounced_light: RMS over vertices of bounced light, relative to that of all light
    bounced_left: estimate of the bounces that were left out, in the same unit
    bake_rays_skipped: rays above the horizon of baked points whose result was known without, beside bake_rays
    vertices_unbaked: vertices that were not baked, or not since the scene changed, because no image has
                                               needed their shadows yet
    given_up: number of better pictures that time_budget_ms does not allow; 0: nothing is given up
    pixel_samples: real-time methods: samples per pixel of the image
    light_samples: real-time methods: light_samples of the image
    bsdf_samples: real-time methods: bsdf_samples of the image
    order_tolerance: tolerance of orders and shadows for which orders were chosen: the option's, or more
                                               by time_budget_ms; 0 if they were not chosen
    light_rays_skipped: rays to dim lights that were not traced (NICOL_OPTIMISATION_DIM_LIGHTS), beside light_rays"""
    _fields_ = [
        ("struct_size", c_uint32),
        ("order", c_uint32),
        ("vertices", c_uint64),
        ("triangles", c_uint64),
        ("project_ms", c_double),
        ("bake_ms", c_double),
        ("relight_ms", c_double),
        ("shade_ms", c_double),
        ("draw_ms", c_double),
        ("observe_ms", c_double),
        ("bake_trace_ms", c_double),
        ("bake_rays", c_uint64),
        ("vertices_skipped", c_uint64),
        ("vertices_unoccluded", c_uint64),
        ("vertices_unphysical", c_uint64),
        ("light_columns_skipped", c_uint64),
        ("response_rows_skipped", c_uint64),
        ("channels_shared", c_uint64),
        ("response_bytes", c_uint64),
        ("visibility_bytes", c_uint64),
        ("transfer_bytes", c_uint64),
        ("buffer_bytes", c_uint64),
        ("texture_bytes", c_uint64),
        ("camera_rays", c_uint64),
        ("shadow_rays", c_uint64),
        ("trace_ms", c_double),
        ("compute", c_uint32),
        ("order_low", c_uint32),
        ("predicted_error", c_double),
        ("lights_projected", c_uint64),
        ("materials_projected", c_uint64),
        ("vertices_traced", c_uint64),
        ("matrices_baked", c_uint64),
        ("vertices_relit", c_uint64),
        ("vertices_shaded", c_uint64),
        ("pixels_shaded", c_uint64),
        ("vertices_added", c_uint64),
        ("local_lights", c_uint64),
        ("lights_split", c_uint64),
        ("light_rays", c_uint64),
        ("light_ms", c_double),
        ("smooth_rays", c_uint64),
        ("vertices_pending", c_uint64),
        ("bounce_ms", c_double),
        ("bounce_links", c_uint64),
        ("bounce_rounds", c_uint64),
        ("bounced_light", c_double),
        ("bounced_left", c_double),
        ("bake_rays_skipped", c_uint64),
        ("vertices_unbaked", c_uint64),
        ("given_up", c_uint32),
        ("pixel_samples", c_uint32),
        ("light_samples", c_uint32),
        ("bsdf_samples", c_uint32),
        ("order_tolerance", c_double),
        ("light_rays_skipped", c_uint64),
    ]
    order: int
    vertices: int
    triangles: int
    project_ms: float
    bake_ms: float
    relight_ms: float
    shade_ms: float
    draw_ms: float
    observe_ms: float
    bake_trace_ms: float
    bake_rays: int
    vertices_skipped: int
    vertices_unoccluded: int
    vertices_unphysical: int
    light_columns_skipped: int
    response_rows_skipped: int
    channels_shared: int
    response_bytes: int
    visibility_bytes: int
    transfer_bytes: int
    buffer_bytes: int
    texture_bytes: int
    camera_rays: int
    shadow_rays: int
    trace_ms: float
    compute: int
    order_low: int
    predicted_error: float
    lights_projected: int
    materials_projected: int
    vertices_traced: int
    matrices_baked: int
    vertices_relit: int
    vertices_shaded: int
    pixels_shaded: int
    vertices_added: int
    local_lights: int
    lights_split: int
    light_rays: int
    light_ms: float
    smooth_rays: int
    vertices_pending: int
    bounce_ms: float
    bounce_links: int
    bounce_rounds: int
    bounced_light: float
    bounced_left: float
    bake_rays_skipped: int
    vertices_unbaked: int
    given_up: int
    pixel_samples: int
    light_samples: int
    bsdf_samples: int
    order_tolerance: float
    light_rays_skipped: int


class PlaneBuffer(Struct):
    """Fields:
    channel: Colour channel, counted from 0, or NICOL_ALL_CHANNELS: every channel, interleaved; default 0. Planes
        without channels need 0.
    pixels: Room for [row][column][channel][component], first row at the top; aligned to its numbers.
    row_stride: Bytes from row to row, a multiple of a number's size; 0, the default: tightly packed.
    byte_size: room at pixels, bytes; checked
    polarizer_angle: NICOL_PLANE_POLARIZER: angle of the polarizer's transmission axis, counter-clockwise from image right,
        degrees, finite, default 0."""
    _fields_ = [
        ("struct_size", c_uint32),
        ("plane", c_uint32),
        ("format", c_uint32),
        ("channel", c_uint32),
        ("pixels", c_void_p),
        ("row_stride", c_uint64),
        ("byte_size", c_uint64),
        ("polarizer_angle", c_double),
    ]
    plane: Any
    format: Any
    channel: int
    pixels: Any
    row_stride: int
    byte_size: int
    polarizer_angle: float


class Observation(Struct):
    """Fields:
    exposure: exposure of s0 and polarizer, stops, default 0
    scale: Value of s1..s3 that is shown at full colour; 0, the default: automatic, the largest value in the
        image. The file states the scale.
    polarizer_angle: angle of the polarizer, degrees counter-clockwise from image right, default 0"""
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_uint32),
        ("exposure", c_float),
        ("scale", c_float),
        ("polarizer_angle", c_float),
    ]
    kind: Any
    exposure: float
    scale: float
    polarizer_angle: float


class Sensor(Struct):
    """Linear image sensor, by the figures of the standard EMVA 1288. A pixel collects
        n = Poisson(quantum_efficiency * exposure * I + dark_current * exposure_time)
    electrons, at most full_well, where I is s0 behind the optics and the pixel's polarizer, and gives the number
        floor(gain * (n + read noise + offset) + black_level + 1/2), cut to 0 .. 2^bits - 1.
    Noise belongs to the seed, the frame and the pixel. The polarizers' angles and transmittances, the offsets and the
    sensitivities belong to the seed and the pixel, as does the crosstalk. All of them have the same bits on every machine and for any number
    of threads, so that the same Stokes image gives the same bytes.

    Fields:
    mosaic: polarizers and colour filters, default NICOL_MOSAIC_POLARIZED
    bits: bits of a number, 8, 10, 12 or 16, default 12
    shot_noise: 1, the default: electrons are Poisson distributed; 0: their mean, not rounded
    seed: seed of noise and of the pixels' errors, default 0
    optics: Mueller matrix of the optics in front of the sensor, row-major, in the image's frame; default the
        identity. nicol_sensor_add_element adds an element.
    exposure: Photons that reach a pixel where s0 = 1, before its polarizer. 0, the default: as many as fill the well
        where unpolarized light has s0 = 1.
    exposure_time: time in which dark current flows, seconds, default 0.01
    full_well: largest number of electrons, 1 to 1e9, default 10000
    gain: system gain K, numbers per electron; 0, the default: the full well gives 2^bits - 1
    black_level: number without electrons, default 0
    read_noise: temporal dark noise sigma_d, electrons, default 2.5
    dark_current: dark current, electrons per second, default 0
    dsnu: dark signal nonuniformity: standard deviation of the offsets, electrons, default 0
    prnu: photo response nonuniformity: relative standard deviation, 0 to 1, default 0
    extinction_ratio: Transmittance of a pixel's polarizer along its axis (1) over that across it, at least 1. 0, the
        default: an ideal polarizer.
    extinction_spread: relative standard deviation of the transmittance across, 0 to 1, default 0
    misalignment: standard deviation of the polarizers' angles, degrees, 0 to 5, default 0
    crosstalk: fraction of a pixel's electrons that its four neighbours get, 0 to 0.8, default 0
    crosstalk_spread: relative standard deviation of that fraction over pixels, 0 to 1, default 0
    blur: standard deviation of the lens's blur, which is normal, pixels, 0 to 16, default 0
    vignetting: Part of the light that the lens loses in the image's corners, 0 to 0.99, default 0. The rest of the
        image follows the fourth power of the cosine of the angle from the optical axis, the image's middle.
    quantum_efficiency: Quantum efficiency of the channels, above 0 and at most 1, for light along the polarizer's axis;
        default 0.6."""
    _fields_ = [
        ("struct_size", c_uint32),
        ("mosaic", c_uint32),
        ("bits", c_uint32),
        ("shot_noise", c_uint32),
        ("seed", c_uint64),
        ("optics", c_double * 16),
        ("exposure", c_double),
        ("exposure_time", c_double),
        ("full_well", c_double),
        ("gain", c_double),
        ("black_level", c_double),
        ("read_noise", c_double),
        ("dark_current", c_double),
        ("dsnu", c_double),
        ("prnu", c_double),
        ("extinction_ratio", c_double),
        ("extinction_spread", c_double),
        ("misalignment", c_double),
        ("crosstalk", c_double),
        ("crosstalk_spread", c_double),
        ("blur", c_double),
        ("vignetting", c_double),
        ("quantum_efficiency", Spectrum),
        ("reserved", c_uint32),
    ]
    mosaic: Any
    bits: int
    shot_noise: int
    seed: int
    optics: Any
    exposure: float
    exposure_time: float
    full_well: float
    gain: float
    black_level: float
    read_noise: float
    dark_current: float
    dsnu: float
    prnu: float
    extinction_ratio: float
    extinction_spread: float
    misalignment: float
    crosstalk: float
    crosstalk_spread: float
    blur: float
    vignetting: float
    quantum_efficiency: Any

    def set_preset(self, preset: Any) -> Self:
        """Sets the fields of a preset."""
        check(_sensor_set_preset(byref(self), preset))
        return self

    def load(self, path: str | os.PathLike[str]) -> Self:
        """Sets the fields that a JSON file names, or those of a mosaic that nicol_sensor_write_png wrote. The file is
        an object with the names of the fields, and "preset" ("imx250mzr", "imx250myr") and "elements", a list of
        objects with "kind" ("polarizer", "retarder", "right_circular", "left_circular"), "angle", "retardance",
        "transmittance" and "extinction_ratio", in the order of the light."""
        check(_sensor_load(byref(self), text(path)))
        return self

    def load_memory(self, file: MemoryFile) -> Self:
        """Sets the fields that a file in memory names, as nicol_sensor_load does."""
        check(_sensor_load_memory(byref(self), byref(file) if file is not None else None))
        return self

    def add_element(self, element: PolarizationElement, extinction_ratio: float) -> Self:
        """Multiplies the sensor's optics by the matrix of an element that faces the camera, between the optics and
        the sensor; angles are counter-clockwise from image right. The element's to_world must be the identity, and
        its outline has no effect, and it must have no textures. extinction_ratio: transmittance along over across
        a polarizer's axis, at least 1; 0: an ideal polarizer."""
        check(_sensor_add_element(byref(self), byref(element) if element is not None else None, extinction_ratio))
        return self

    def expose(self, light: StokesImage, frame: int, to: RawImage) -> Self:
        """Exposes the sensor to light, and writes the numbers to `to`, which has the light's size. Frames with other
        numbers have other noise. Light that is not finite is refused."""
        check(_sensor_expose(byref(self), byref(light) if light is not None else None, frame, byref(to) if to is not None else None))
        return self

    def write_png(self, raw: RawImage, path: str | os.PathLike[str]) -> Self:
        """Writes numbers as a grey PNG: 8 bits, or 16 bits if the sensor has more than 8. The file names the mosaic,
        the bits and the sensor in the text chunks Nicol:Mosaic, Nicol:Bits and Nicol:Sensor."""
        check(_sensor_write_png(byref(self), byref(raw) if raw is not None else None, text(path)))
        return self

    def demosaic(self, raw: RawImage, method: Any, to: StokesImage) -> Self:
        """Computes the light on the sensor, behind its optics, from numbers of its pixels, by the sensor's exposure,
        quantum efficiency, gain, levels and extinction ratio. The pixels' own errors and crosstalk are not undone.
        `to` has 3 channels with colour filters, else 1, and s3 = 0; NICOL_MOSAIC_PLAIN gives s0 alone."""
        check(_sensor_demosaic(byref(self), byref(raw) if raw is not None else None, method, byref(to) if to is not None else None))
        return self


class StokesImage(Struct):
    """Stokes image in the caller's memory, in the frame of rendered images: x right, y up.

    Fields:
    width: size, pixels, 1 to NICOL_MAX_SIZE
    height: size, pixels, 1 to NICOL_MAX_SIZE
    channels: number of colour channels, 1 to NICOL_MAX_CHANNELS
    pixels: Floats [row][column][channel][component], first row at the top; finite.
    row_stride: bytes from row to row, a multiple of 4; 0, the default: tightly packed
    byte_size: room at pixels, bytes; checked"""
    _fields_ = [
        ("struct_size", c_uint32),
        ("width", c_uint32),
        ("height", c_uint32),
        ("channels", c_uint32),
        ("pixels", c_void_p),
        ("row_stride", c_uint64),
        ("byte_size", c_uint64),
    ]
    width: int
    height: int
    channels: int
    pixels: Any
    row_stride: int
    byte_size: int


class RawImage(Struct):
    """Numbers of a sensor's pixels in the caller's memory.

    Fields:
    width: size, pixels, 1 to NICOL_MAX_SIZE
    height: size, pixels, 1 to NICOL_MAX_SIZE
    pixels: uint16_t [row][column], first row at the top
    row_stride: bytes from row to row, a multiple of 2; 0, the default: tightly packed
    byte_size: room at pixels, bytes; checked"""
    _fields_ = [
        ("struct_size", c_uint32),
        ("width", c_uint32),
        ("height", c_uint32),
        ("reserved", c_uint32),
        ("pixels", c_void_p),
        ("row_stride", c_uint64),
        ("byte_size", c_uint64),
    ]
    width: int
    height: int
    pixels: Any
    row_stride: int
    byte_size: int


class Gradient(Struct):
    """Room for gradients of a function f of a picture, which nicol_render_adjoint writes. NULL, the default: the
    gradient is not wanted.

    Fields:
    environment: Derivatives of f by the coefficients of the environment up to order_low, in its own axes:
        [channel][l*l + l + m][4] as nicol_environment_create_psh has them, in all channels of the scene. The
        derivative by an environment of one channel is the sum over the channels. Components p = 1, 2 below l =
        2 are 0. All four components are computed, also those that the environment lacks.
    environment_count: number of doubles at environment: channels * 4 (order_low + 1)^2
    lights: Derivatives of f by the Stokes vectors of the local lights, [light][channel][4], lights in the order of
        nicol_scene_get_light_ids. A light's Stokes vector in a channel is its value times (1, dolp cos 2 aolp,
        dolp sin 2 aolp, docp).
    lights_count: number of doubles at lights: lights * channels * 4
    instances: Derivatives of f by a factor of all that an instance reflects, at the factor 1: [instance][channel],
        instances in the order of nicol_scene_get_instance_ids. The derivative by the reflectance of a diffuse
        material is the sum over its instances, divided by the reflectance.
    instances_count: number of doubles at instances: instances * channels
    texture: image whose texels are not all equal; NULL: texels must be NULL, too
    texels_count: number of doubles at texels: rows * columns * channels of the texture"""
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("environment", POINTER(c_double)),
        ("environment_count", c_uint64),
        ("lights", POINTER(c_double)),
        ("lights_count", c_uint64),
        ("instances", POINTER(c_double)),
        ("instances_count", c_uint64),
        ("texture", c_void_p),
        ("texels", POINTER(c_double)),
        ("texels_count", c_uint64),
    ]
    environment: Any
    environment_count: int
    lights: Any
    lights_count: int
    instances: Any
    instances_count: int
    texture: Texture
    texels: Any
    texels_count: int


class Host(Struct):
    """Fields:
    flags: sum of NICOL_HOST_..., default 0: none
    is_current: Callback that tells whether the context is current. NULL, the default: OpenGL is queried, which needs
        OpenGL functions that may be called without a context, as with libglvnd and Mesa.
    user: argument of both callbacks; used until the last object of the context is released"""
    _callbacks_ = {"get_proc_address": GetProcAddressCallback, "is_current": IsCurrentCallback}
    _fields_ = [
        ("struct_size", c_uint32),
        ("flags", c_uint32),
        ("get_proc_address", GetProcAddressCallback.type),
        ("is_current", IsCurrentCallback.type),
        ("user", c_void_p),
    ]
    flags: int
    get_proc_address: Any
    is_current: Any
    user: Any


class GlTexture(Struct):
    """Fields:
    name: OpenGL's name of the texture
    target: GL_TEXTURE_2D
    internal_format: GL_RGBA32F"""
    _fields_ = [
        ("struct_size", c_uint32),
        ("name", c_uint32),
        ("target", c_uint32),
        ("internal_format", c_uint32),
        ("width", c_uint32),
        ("height", c_uint32),
    ]
    name: int
    target: int
    internal_format: int
    width: int
    height: int


class TextureTarget(Struct):
    """Texture of the host's to draw into: level 0 of a GL_TEXTURE_2D of GL_RGBA8, GL_SRGB8_ALPHA8, GL_RGBA16F or
    GL_RGBA32F, as large as the framebuffer.

    Fields:
    texture: OpenGL's name of the texture
    bottom_up: Meaning of row 0. 0, the default: the image's top; 1: the image's bottom, as in OpenGL's own
        images.
    encoding: Encoding of the images S0, POLARIZER, DOLP and AOLP, default linear: the numbers whose sRGB encoding a
        PNG file has. SRGB8_ALPHA8 gets the encoded numbers unchanged.
    depth_texture: Depth texture of the host's, of the same size and with the same row 0; default 0: none. The image is
        then drawn only where its surfaces are nearer than the texture's depths, and its depths replace these:
        what the host has drawn hides Nicol's surfaces, and these hide what the host draws next. Pixels without
        a surface are infinitely far. The render needs NICOL_AOV_DEPTH and the host's own view. Formats:
        GL_DEPTH_COMPONENT16, 24 or 32F, GL_DEPTH24_STENCIL8 or GL_DEPTH32F_STENCIL8.
    depth_mapping: numbers in depth_texture, default NICOL_DEPTH_MAPPING_PERSPECTIVE
    depth_near: the host's near plane, default 0: above 0 is needed in perspective
    depth_far: the host's far plane; 0, the default: none, in perspective"""
    _fields_ = [
        ("struct_size", c_uint32),
        ("texture", c_uint32),
        ("bottom_up", c_uint32),
        ("encoding", c_uint32),
        ("depth_texture", c_uint32),
        ("depth_mapping", c_uint32),
        ("depth_near", c_float),
        ("depth_far", c_float),
    ]
    texture: int
    bottom_up: int
    encoding: Any
    depth_texture: int
    depth_mapping: Any
    depth_near: float
    depth_far: float


class PshSampling(Struct):
    """Fields:
    order: highest order, 0 to NICOL_PSH_MAX_ORDER; the default 0 is order 0
    rows: Number of rows, at most 32768 (Gauss-Legendre: 16384). 0, the default: the fewest rows that are exact
        for fields of this order: 2 order + 1, or order + 1 with Gauss-Legendre, and at least 2 with
        Clenshaw-Curtis.
    columns: Number of columns, 2 order + 1 to 131072, at the azimuths phi0 + 2 pi c / columns. 0, the default: 2
        order + 1.
    phi0: azimuth of column 0, radians, finite, default 0"""
    _fields_ = [
        ("struct_size", c_uint32),
        ("grid", c_uint32),
        ("order", c_uint32),
        ("rows", c_uint32),
        ("columns", c_uint32),
        ("reserved", c_uint32),
        ("phi0", c_double),
    ]
    grid: Any
    order: int
    rows: int
    columns: int
    phi0: float


class PshMuellerField(Struct):
    """Fields:
    isotropic: 1: the field depends on the azimuths only by their difference, as an isotropic pBRDF in its surface's
        frame does; `out` is then sampled at azimuth 0 only. 0, the default: any field.
    rows_out: Numbers of Gauss-Legendre rows and even columns at which the field is sampled, for each of the two
        directions, at most 4096. 0, the default: 2 order + 2 rows and 4 order + 4 columns, exact for fields up
        to three times the order.
    columns_out: Numbers of Gauss-Legendre rows and even columns at which the field is sampled, for each of the two
        directions, at most 4096. 0, the default: 2 order + 2 rows and 4 order + 4 columns, exact for fields up
        to three times the order."""
    _callbacks_ = {"callback": PshMuellerCallback}
    _fields_ = [
        ("struct_size", c_uint32),
        ("isotropic", c_uint32),
        ("order_out", c_uint32),
        ("order_in", c_uint32),
        ("rows_out", c_uint32),
        ("columns_out", c_uint32),
        ("rows_in", c_uint32),
        ("columns_in", c_uint32),
        ("callback", PshMuellerCallback.type),
        ("user", c_void_p),
    ]
    isotropic: int
    order_out: int
    order_in: int
    rows_out: int
    columns_out: int
    rows_in: int
    columns_in: int
    callback: Any
    user: Any


class FileOptions(Struct):
    """Fields:
    order: Highest order of coefficients and tables, also of an image if the order is given: at most 4096 for
        light and 64 for materials (NICOL_PSH_MAX_ORDER, NICOL_PSH_MAX_MATRIX_ORDER). Default
        NICOL_FILE_ORDER_AUTOMATIC: the file's own order if there is one, else 32 for light and 16 for
        materials.
    width: Size of an image to write, pixels, both or none; height at least 2. 0, the default: automatic. An image
        then keeps its size, and a cross of edge e gets 8 e columns (4 e above 256). Coefficients get 512 x
        257, doubled until there are 4 (order + 1) columns, at most 4096 x 2049, and lose the orders that fewer
        than 2 order + 1 columns or rows cannot hold.
    height: Size of an image to write, pixels, both or none; height at least 2. 0, the default: automatic. An image
        then keeps its size, and a cross of edge e gets 8 e columns (4 e above 256). Coefficients get 512 x
        257, doubled until there are 4 (order + 1) columns, at most 4096 x 2049, and lose the orders that fewer
        than 2 order + 1 columns or rows cannot hold.
    edge: edge of a cross's face to write, pixels, 2 to 4096; 0, the default: automatic, 256
    flags: sum of NICOL_FILE_BAND_LIMITED and NICOL_FILE_PHYSICAL, default 0
    scale: factor on radiance or reflectance, 0 to 1e12, default 1
    rotation: Rotation of light, row-major, default the identity: exact for coefficients, by bilinear interpolation
        for images. Materials need the identity.
    wavelengths: Wavelengths of the channels of spectral files, nm: the nearest channel of an image, or linear between
        the wavelengths of a material. count 0, the default: every wavelength of an image; red, green and blue
        of a measured material."""
    _fields_ = [
        ("struct_size", c_uint32),
        ("order", c_uint32),
        ("width", c_uint32),
        ("height", c_uint32),
        ("edge", c_uint32),
        ("flags", c_uint32),
        ("scale", c_double),
        ("rotation", c_double * 9),
        ("wavelengths", Spectrum),
        ("reserved", c_uint32),
    ]
    order: int
    width: int
    height: int
    edge: int
    flags: int
    scale: float
    rotation: Any
    wavelengths: Any


class LightReport(Struct):
    """Report of a light, by channel. Means and fractions are taken over the sphere, weighted by solid angle, for
    the image that would be written.

    Fields:
    order: highest order of the energies
    width: width of the image, pixels
    height: height of the image, pixels
    polarized: 1 if some s1, s2 or s3 is not 0, else 0
    circular: 1 if some s3 is not 0, else 0
    wavelengths: wavelengths, nm; 0: the channels are colours
    mean: mean s0
    smallest: smallest s0
    largest: largest s0
    direction: Mean of the directions that light comes from, weighted by s0 > 0: of length 0 (evenly) to 1 (from one
        point).
    mean_dolp: mean degree of linear polarization, weighted by s0
    largest_dolp: largest degree of linear polarization where s0 > 0
    largest_circular: largest |s3| / s0 where s0 > 0
    unphysical: Fraction of the sphere that violates Eq. 70 by more than 1e-5 s0.
    largest_excess: Largest sqrt(s1^2 + s2^2 + s3^2) - s0 where Eq. 70 is violated, over the mean s0."""
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_uint32),
        ("channels", c_uint32),
        ("order", c_uint32),
        ("width", c_uint32),
        ("height", c_uint32),
        ("polarized", c_uint32),
        ("circular", c_uint32),
        ("wavelengths", c_double * 16),
        ("mean", c_double * 16),
        ("smallest", c_double * 16),
        ("largest", c_double * 16),
        ("direction", c_double * 48),
        ("mean_dolp", c_double * 16),
        ("largest_dolp", c_double * 16),
        ("largest_circular", c_double * 16),
        ("unphysical", c_double * 16),
        ("largest_excess", c_double * 16),
    ]
    kind: Any
    channels: int
    order: int
    width: int
    height: int
    polarized: int
    circular: int
    wavelengths: Any
    mean: Any
    smallest: Any
    largest: Any
    direction: Any
    mean_dolp: Any
    largest_dolp: Any
    largest_circular: Any
    unphysical: Any
    largest_excess: Any


class MaterialReport(Struct):
    """Report of a material, by channel, as far as coefficients up to `order` describe the material.

    Fields:
    order: highest order of the values below
    file_order: order of the file's own coefficients or table; 0 if measured
    stokes_columns: Number of Stokes components of the light that the material is defined for: 4; for a table also 1
        (unpolarized light) or 3 (linearly polarized light).
    measured_wavelengths: number of wavelengths of a measured material, else 0
    measured_range: first and last measured wavelength, nm
    wavelengths: wavelengths, nm; 0: the channels are colours
    albedo: reflected fraction of unpolarized light that arrives evenly
    largest_albedo: Largest reflected fraction of light from one direction, for directions up to 75 degrees from the normal
        and the worst polarization. Above 1 energy appears: the material is not passive.
    norms: Frobenius norms of the parts of the matrix between the groups s0, (s1, s2), s3:
        [channel][out][in].
    asymmetry: Norm of the part that breaks mirror symmetry, over the norm of all: mostly errors of a measurement. The
        option symmetrize removes the part when the material is loaded.
    unphysical: Fraction of all pairs of directions, by projected solid angle, for which some fully polarized light
        leaves with sqrt(s1^2 + s2^2 + s3^2) above s0 by more than 0.001 of the mean M00.
    excess: Mean over all pairs of directions of the largest sqrt(s1^2 + s2^2 + s3^2) - s0 above 0, over the mean
        M00."""
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_uint32),
        ("channels", c_uint32),
        ("order", c_uint32),
        ("file_order", c_uint32),
        ("stokes_columns", c_uint32),
        ("measured_wavelengths", c_uint32),
        ("reserved", c_uint32),
        ("measured_range", c_double * 2),
        ("wavelengths", c_double * 16),
        ("albedo", c_double * 16),
        ("largest_albedo", c_double * 16),
        ("norms", c_double * 144),
        ("asymmetry", c_double * 16),
        ("unphysical", c_double * 16),
        ("excess", c_double * 16),
    ]
    kind: Any
    channels: int
    order: int
    file_order: int
    stokes_columns: int
    measured_wavelengths: int
    measured_range: Any
    wavelengths: Any
    albedo: Any
    largest_albedo: Any
    norms: Any
    asymmetry: Any
    unphysical: Any
    excess: Any


class Context(Handle):
    """OpenGL context on its own thread, or a host's"""

    @classmethod
    def create(cls, options: Any = None) -> Self:
        """Creates a context. options may be NULL: all defaults. Returns NICOL_ERROR_NO_BACKEND if no such OpenGL
        context can be created."""
        options = lend(options)
        context = cls()
        check(_context_create(byref(options) if options is not None else None, byref(context)))
        return context

    def set_log(self, log: Any) -> None:
        """Replaces the log callback of nicol_context_options; NULL: silent from now on. When the function returns, no
        thread is in the callback before, whose user data may then be released."""
        log = LogCallback(log)
        check(_context_set_log(self, log, None))
        hold(self, log)

    def get_info(self) -> ContextInfo:
        """Gets the properties of the OpenGL context, and the limits in effect."""
        info = ContextInfo()
        check(_context_get_info(self, byref(info)))
        return info

    @classmethod
    def create_host(cls, host: Any, options: Any = None) -> Self:
        """Creates a context inside the OpenGL context that is current: OpenGL 4.5 or newer, of the core or the
        compatibility profile. options are those of nicol_context_create, with backend and device 0. Returns
        NICOL_ERROR_NOT_CURRENT if is_current returns 0, and NICOL_ERROR_NO_BACKEND if there is no such
        OpenGL."""
        host = lend(host)
        options = lend(options)
        context = cls()
        check(_context_create_host(byref(host) if host is not None else None, byref(options) if options is not None else None, byref(context)))
        return context


class Environment(Handle):
    """light from infinitely far; immutable"""

    @classmethod
    def load(cls, context: Context | None, path: str | os.PathLike[str] | None, options: EnvironmentLoadOptions | None = None) -> Self:
        """Loads an environment from files in the format that the path names:
          NAME.exr      OpenEXR, equirectangular as nicol_image: R, G, B or Y are unpolarized light; S0.<colour> to
                        S3.<colour> are polarized light, in nicol_image's frames. Spectral files (S0.550,000000nm and so on)
                        have one channel per wavelength.
          NAME_s0.exr   to NAME_s3.exr, any of the four, or NAME alone: a cube map as a cross of 4 x 3 faces, one file per
                        Stokes component, as the Python package polarsh writes them.
          NAME.hdr      Radiance HDR, equirectangular, unpolarized light.
          NAME.png      or NAME.jpg, .bmp, .tga: equirectangular, unpolarized light, decoded from sRGB to 0 to 1.
          NAME.npz      PSH coefficients as polarsh writes them (SHVec).
        options may be NULL: all defaults."""
        environment = cls()
        check(_environment_load(context, text(path), byref(options) if options is not None else None, byref(environment)))
        return environment

    @classmethod
    def load_memory(cls, context: Context, file: MemoryFile, options: EnvironmentLoadOptions | None = None) -> Self:
        """Loads an environment from memory. The resolver returns the other files of a cube map."""
        environment = cls()
        check(_environment_load_memory(context, byref(file) if file is not None else None, byref(options) if options is not None else None, byref(environment)))
        return environment

    @classmethod
    def create_image(cls, context: Context, image: Any) -> Self:
        """Creates an environment from an image in memory."""
        image = lend(image)
        environment = cls()
        check(_environment_create_image(context, byref(image) if image is not None else None, byref(environment)))
        return environment

    @classmethod
    def create_constant(cls, context: Context | None, radiance: Any) -> Self:
        """Creates an environment of unpolarized light that is equal from all directions. radiance is finite and not
        negative; NULL or not given: 1 in one channel."""
        radiance = radiance if radiance is None or isinstance(radiance, Spectrum) else Spectrum.of(radiance)
        environment = cls()
        check(_environment_create_constant(context, byref(radiance) if radiance is not None else None, byref(environment)))
        return environment

    @classmethod
    def create_sky(cls, context: Context, sky: Sky) -> Self:
        """Creates a clear sky without the sun's own disc."""
        environment = cls()
        check(_environment_create_sky(context, byref(sky) if sky is not None else None, byref(environment)))
        return environment

    @classmethod
    def create_psh(cls, context: Context, order: int, channels: int, coefficients: Any) -> Self:
        """Creates an environment from PSH coefficients over PROPAGATION directions in the world's axes,
        [channel][l*l + l + m][4] as nicol_psh.h defines. order is up to NICOL_PSH_MAX_ORDER (4096), channels 1 to
        NICOL_MAX_CHANNELS, and count = channels * 4 (order+1)^2. Coefficients p = 1, 2 below l = 2 must be 0. The
        light is band-limited and may ring: s0 may be below 0, and the polarization above s0."""
        coefficients = Buffer(coefficients, c_double)
        environment = cls()
        check(_environment_create_psh(context, order, channels, coefficients.pointer, coefficients.count, byref(environment)))
        return environment

    def get_info(self) -> EnvironmentInfo:
        """Gets the properties of the light."""
        info = EnvironmentInfo()
        check(_environment_get_info(self, byref(info)))
        return info

    def write(self, options: FileOptions | None, path: str | os.PathLike[str] | None) -> None:
        """Writes an environment to a file in the kind that the path says, as nicol_file_convert does. options may be
        NULL, and must have no wavelengths."""
        check(_environment_write(self, byref(options) if options is not None else None, text(path)))


class Texture(Handle):
    """values that vary over a surface; immutable"""

    @classmethod
    def create_image(cls, context: Context | None, image: TextureImage | None, options: TextureOptions | None = None) -> Self:
        """Creates a texture from an image in memory and copies the pixels. options may be NULL: all defaults."""
        texture = cls()
        check(_texture_create_image(context, byref(image) if image is not None else None, byref(options) if options is not None else None, byref(texture)))
        return texture

    @classmethod
    def load(cls, context: Context | None, path: str | os.PathLike[str] | None, options: TextureOptions | None = None) -> Self:
        """Loads a texture from a file of PNG, JPEG, BMP, TGA, Radiance HDR, or OpenEXR with R G B or Y; A is the
        coverage. options may be NULL: all defaults."""
        texture = cls()
        check(_texture_load(context, text(path), byref(options) if options is not None else None, byref(texture)))
        return texture

    @classmethod
    def load_memory(cls, context: Context, file: MemoryFile, options: TextureOptions | None = None) -> Self:
        """Loads a texture from memory."""
        texture = cls()
        check(_texture_load_memory(context, byref(file) if file is not None else None, byref(options) if options is not None else None, byref(texture)))
        return texture

    @classmethod
    def create_checkerboard(cls, context: Context | None, color0: Any, color1: Any, to_uv: Any) -> Self:
        """Creates Mitsuba 3's checkerboard of colours: four squares per unit square of u and v, color0 at u = v = 0.
        Colours have 1 or 3 values; NULL or not given: 0.4 and 0.2. to_uv is that of nicol_texture_options; NULL:
        identity."""
        color0 = color0 if color0 is None or isinstance(color0, Spectrum) else Spectrum.of(color0)
        color1 = color1 if color1 is None or isinstance(color1, Spectrum) else Spectrum.of(color1)
        texture = cls()
        check(_texture_create_checkerboard(context, byref(color0) if color0 is not None else None, byref(color1) if color1 is not None else None, array(to_uv, c_double, 9), byref(texture)))
        return texture

    @classmethod
    def create_vertex_colors(cls, context: Context) -> Self:
        """Creates a texture of the colours of the mesh's vertices, interpolated."""
        texture = cls()
        check(_texture_create_vertex_colors(context, byref(texture)))
        return texture

    @classmethod
    def create_face_colors(cls, context: Context) -> Self:
        """Creates a texture of the colours of the mesh's triangles. A material may use colours of triangles or of
        vertices, not both."""
        texture = cls()
        check(_texture_create_face_colors(context, byref(texture)))
        return texture


class Material(Handle):
    """polarimetric BRDF (pBRDF); immutable"""

    @classmethod
    def create_pplastic(cls, context: Context, parameters: Pplastic) -> Self:
        """Creates a material from nicol_pplastic. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that is
        out of range."""
        material = cls()
        check(_material_create_pplastic(context, byref(parameters) if parameters is not None else None, byref(material)))
        return material

    @classmethod
    def create_plastic(cls, context: Context, parameters: Plastic) -> Self:
        """Creates a material from nicol_plastic. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that is
        out of range."""
        material = cls()
        check(_material_create_plastic(context, byref(parameters) if parameters is not None else None, byref(material)))
        return material

    @classmethod
    def create_principled(cls, context: Context, parameters: Principled) -> Self:
        """Creates a material from nicol_principled. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that
        is out of range. Returns NICOL_ERROR_UNSUPPORTED for a tint of a mesh's colours."""
        material = cls()
        check(_material_create_principled(context, byref(parameters) if parameters is not None else None, byref(material)))
        return material

    @classmethod
    def create_diffuse(cls, context: Context | None, reflectance: Any) -> Self:
        """Creates a Lambertian, depolarizing material. reflectance is 0 to 1; NULL or not given: 0.5. Only the front
        side reflects."""
        reflectance = reflectance if reflectance is None or isinstance(reflectance, Spectrum) else Spectrum.of(reflectance)
        material = cls()
        check(_material_create_diffuse(context, byref(reflectance) if reflectance is not None else None, byref(material)))
        return material

    @classmethod
    def create_conductor(cls, context: Context, parameters: Conductor) -> Self:
        """Creates a material from nicol_conductor. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that
        is out of range or, for an unknown metal, the known metals."""
        material = cls()
        check(_material_create_conductor(context, byref(parameters) if parameters is not None else None, byref(material)))
        return material

    @classmethod
    def create_dielectric(cls, context: Context, parameters: Dielectric) -> Self:
        """Creates a material from nicol_dielectric. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that
        is out of range."""
        material = cls()
        check(_material_create_dielectric(context, byref(parameters) if parameters is not None else None, byref(material)))
        return material

    @classmethod
    def load_measured(cls, context: Context | None, path: str | os.PathLike[str] | None, options: Measured | None = None) -> Self:
        """Loads a material as Mitsuba 3's measured_polarized from a .pbsdf file, such as the KAIST data set has. The
        file is streamed: about 102 MB per channel stay in memory at the data set's resolution, or half as much if
        symmetrized. options may be NULL: all defaults. Only the front side reflects."""
        material = cls()
        check(_material_load_measured(context, text(path), byref(options) if options is not None else None, byref(material)))
        return material

    @classmethod
    def load_measured_memory(cls, context: Context, file: MemoryFile, options: Measured | None = None) -> Self:
        """Loads a measured material from memory."""
        material = cls()
        check(_material_load_measured_memory(context, byref(file) if file is not None else None, byref(options) if options is not None else None, byref(material)))
        return material

    @classmethod
    def load_psh(cls, context: Context | None, path: str | os.PathLike[str] | None, options: PshMatrix | None = None) -> Self:
        """Loads an isotropic material from one PSH coefficient matrix per channel, cosine included: the .npz files of
        the Python package polarsh (SHMat in the layout ISOBI2). The material does not reflect light of orders
        above the matrix's. options may be NULL: all defaults. Only the front side reflects."""
        material = cls()
        check(_material_load_psh(context, text(path), byref(options) if options is not None else None, byref(material)))
        return material

    @classmethod
    def load_psh_memory(cls, context: Context, file: MemoryFile, options: PshMatrix | None = None) -> Self:
        """Loads a material of PSH matrices from memory."""
        material = cls()
        check(_material_load_psh_memory(context, byref(file) if file is not None else None, byref(options) if options is not None else None, byref(material)))
        return material

    @classmethod
    def create_twosided(cls, context: Context, front: Material) -> Self:
        """Creates a material whose back side reflects as its front side. `front` may be released afterwards."""
        material = cls()
        check(_material_create_twosided(context, front, byref(material)))
        return material

    @classmethod
    def create_scaled(cls, context: Context, base: Material, scale: Texture) -> Self:
        """Creates the product of a material and a texture: a diffuse material of reflectance 1 gets the texture's
        colours. The given handles may be released afterwards."""
        material = cls()
        check(_material_create_scaled(context, base, scale, byref(material)))
        return material

    @classmethod
    def create_blend(cls, context: Context, first: Material, second: Material, weight: Texture) -> Self:
        """Creates the mixture first (1 - t) + second t, with t = the weight's first channel, clamped to 0 to 1
        (Mitsuba 3's blendbsdf). If one material is two-sided, the mixture is too, and the other material is black
        on the back. The given handles may be released afterwards."""
        material = cls()
        check(_material_create_blend(context, first, second, weight, byref(material)))
        return material

    @classmethod
    def create_normal_map(cls, context: Context, base: Material, normals: Texture, mirrored_y: int) -> Self:
        """Creates a material with perturbed normals from a raw texture with values t: shading normals 2 t - 1 in the
        frame of the surface, with x along growing u (Mitsuba 3's normalmap). mirrored_y 0: y completes a
        right-handed frame; 1: y points to where v falls, as in glTF. The two values differ where texture
        coordinates are mirrored. The given handles may be released afterwards."""
        material = cls()
        check(_material_create_normal_map(context, base, normals, mirrored_y, byref(material)))
        return material

    @classmethod
    def create_bump_map(cls, context: Context, base: Material, heights: Texture, scale: float) -> Self:
        """Creates a material with perturbed normals from heights: shading normals of a surface that is displaced
        along its normal by scale times the texture's first channel, in the scene's units (Mitsuba 3's bumpmap).
        The given handles may be released afterwards."""
        material = cls()
        check(_material_create_bump_map(context, base, heights, scale, byref(material)))
        return material

    @classmethod
    def create_rotated(cls, context: Context | None, base: Material | None, directions: Texture | None, angle: float) -> Self:
        """Creates a material whose anisotropic parts are rotated within the surface, as by glTF's
        KHR_materials_anisotropy. directions is a raw texture with values t, or NULL: the first two of 2 t - 1 are
        the direction in which u would grow, in the frame of x along growing u and y to where v falls. angle, in
        radians from x towards y, is added. The given handles may be released afterwards."""
        material = cls()
        check(_material_create_rotated(context, base, directions, angle, byref(material)))
        return material

    @classmethod
    def create_mask(cls, context: Context, base: Material, opacity: Texture) -> Self:
        """Creates a material with an alpha mask: the surface is cut out where the opacity is below 0.5 (Mitsuba 3's
        mask of opacities 0 and 1). The opacity is the texture's coverage or, with fewer than four channels, the
        first channel. The given handles may be released afterwards."""
        material = cls()
        check(_material_create_mask(context, base, opacity, byref(material)))
        return material

    @classmethod
    def create_callback(cls, context: Context, parameters: Any) -> Self:
        """Creates a material from a function, which must be isotropic, mirror symmetric about every plane through the
        normal, and finite. Returns NICOL_ERROR_INVALID_ARGUMENT if a test at some directions shows that the
        function is not. Only the front side reflects."""
        parameters = lend(parameters)
        material = cls()
        check(_material_create_callback(context, byref(parameters) if parameters is not None else None, byref(material)))
        return material

    def write(self, options: FileOptions | None, path: str | os.PathLike[str] | None) -> None:
        """Writes a material to a file in the kind that the path says, as nicol_file_convert does. options may be
        NULL, and must have no wavelengths."""
        check(_material_write(self, byref(options) if options is not None else None, text(path)))


class Mesh(Handle):
    """triangles; immutable"""

    @classmethod
    def load(cls, context: Context, path: str | os.PathLike[str]) -> Self:
        """Loads a mesh from OBJ, PLY, OFF, STL or the first mesh of Mitsuba's .serialized, by the file's suffix.
        Polygons may be concave. Triangles without area, vertices without a face, and elements that the reader
        ignores (materials) are left out; one line of the log counts them. Texture coordinates and colours of
        vertices and faces are kept. v of OBJ, which points up, becomes 1 - v. The message of
        NICOL_ERROR_INVALID_FILE names the line, vertex or face."""
        mesh = cls()
        check(_mesh_load(context, text(path), byref(mesh)))
        return mesh

    @classmethod
    def load_memory(cls, context: Context, file: MemoryFile) -> Self:
        """Loads a mesh from memory."""
        mesh = cls()
        check(_mesh_load_memory(context, byref(file) if file is not None else None, byref(mesh)))
        return mesh

    @classmethod
    def create(cls, context: Context, data: MeshData) -> Self:
        """Creates a mesh from arrays and copies the arrays. A render adds vertices where shadows need them, see
        refine_tolerance of nicol_render_options."""
        mesh = cls()
        check(_mesh_create(context, byref(data) if data is not None else None, byref(mesh)))
        return mesh

    @classmethod
    def create_sphere(cls, context: Context) -> Self:
        """Creates the unit sphere, divided finely enough for per-vertex shading, with the texture coordinates of
        Mitsuba 3's sphere."""
        mesh = cls()
        check(_mesh_create_sphere(context, byref(mesh)))
        return mesh

    @classmethod
    def create_divided_sphere(cls, context: Context, segments: int) -> Self:
        """Creates the unit sphere with a chosen number of vertices: 10 segments^2 + 2. The sphere is an icosahedron
        whose edges are each cut into `segments` parts; segments is even, 2 to 512. nicol_mesh_create_sphere has 38
        segments."""
        mesh = cls()
        check(_mesh_create_divided_sphere(context, segments, byref(mesh)))
        return mesh

    @classmethod
    def create_rectangle(cls, context: Context) -> Self:
        """Creates the rectangle [-1, 1]^2 in the plane z = 0, facing +z, with the texture coordinates of Mitsuba 3's
        rectangle."""
        mesh = cls()
        check(_mesh_create_rectangle(context, byref(mesh)))
        return mesh

    @classmethod
    def create_cube(cls, context: Context) -> Self:
        """Creates the cube [-1, 1]^3, with the texture coordinates of Mitsuba 3's cube."""
        mesh = cls()
        check(_mesh_create_cube(context, byref(mesh)))
        return mesh

    @classmethod
    def create_disk(cls, context: Context) -> Self:
        """Creates the disk of radius 1 in the plane z = 0, facing +z: 180 sectors of 16 rings, with the texture
        coordinates of Mitsuba 3's disk."""
        mesh = cls()
        check(_mesh_create_disk(context, byref(mesh)))
        return mesh

    @classmethod
    def create_cylinder(cls, context: Context, p0: Any, p1: Any, radius: float) -> Self:
        """Creates the cylinder of this radius around the line from p0 to p1, in the scene's units, without its ends:
        180 sides, with the texture coordinates of Mitsuba 3's cylinder. The front is outside. radius must be above
        0, and p0 and p1 must differ."""
        mesh = cls()
        check(_mesh_create_cylinder(context, array(p0, c_double, 3), array(p1, c_double, 3), radius, byref(mesh)))
        return mesh

    @classmethod
    def create_deformed(cls, context: Context, base: Mesh, deformation: Deformation) -> Self:
        """Creates a mesh with the triangles, texture coordinates and colours of `base`, without its tangents, and
        with other positions and normals, for nicol_scene_set_mesh. Triangles may lose their area, and stay. `base`
        may be released afterwards."""
        mesh = cls()
        check(_mesh_create_deformed(context, base, byref(deformation) if deformation is not None else None, byref(mesh)))
        return mesh

    def get_size(self) -> tuple[int, int]:
        """Gets the numbers of vertices and triangles of a mesh."""
        vertices = c_uint32()
        triangles = c_uint32()
        check(_mesh_get_size(self, byref(vertices), byref(triangles)))
        return vertices.value, triangles.value

    def get_bounds(self) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """Gets the box of the mesh in its own axes: the least and the largest coordinates."""
        lower = (c_double * 3)()
        upper = (c_double * 3)()
        check(_mesh_get_bounds(self, lower, upper))
        return tuple(lower), tuple(upper)


class Scene(Handle):
    """instances, light and polarization elements"""

    @classmethod
    def create(cls, context: Context) -> Self:
        """Creates an empty, dark scene."""
        scene = cls()
        check(_scene_create(context, byref(scene)))
        return scene

    @classmethod
    def load(cls, context: Context, path: str | os.PathLike[str], definitions: Any = ()) -> Self:
        """Loads a scene from a Mitsuba 3 XML file, or from glTF 2.0 if the name ends in .gltf or .glb (the subsets
        that samples/render/README.md lists). definitions are "name=value" strings that override <default>s of the
        XML. Those of glTF are time=SECONDS, at which the file's animation is drawn, and animation=NAME, its name
        or number, the first by default. A glTF file has no environment, and may have lights. Lights that
        polarization elements of the file cover get the polarization state and the brightness that their light has
        behind the elements."""
        definitions = texts(definitions)
        scene = cls()
        check(_scene_load(context, text(path), definitions, len(definitions), byref(scene)))
        return scene

    def set_time(self, time: float) -> None:
        """Moves a scene that was loaded from a glTF file with animations to a time, in seconds. Instances, deformed
        meshes, lights and camera (nicol_scene_get_camera) become those that nicol_scene_load gives for the
        definition time. The animation is that of the scene's definition animation, or the first one. Meshes,
        transforms and places of lights that were set after loading are replaced; removed instances and lights stay
        removed. An instance that the animation scales to 0 is removed, and returns under another id. The next
        render bakes what has moved. Returns NICOL_ERROR_INVALID_ARGUMENT for a time that is not finite, and
        NICOL_ERROR_UNSUPPORTED for a scene without animations."""
        check(_scene_set_time(self, time))

    @classmethod
    def load_memory(cls, context: Context, file: MemoryFile, definitions: Any = ()) -> Self:
        """Loads a scene from memory: XML, glTF as JSON, or GLB. The resolver returns the scene's other files."""
        definitions = texts(definitions)
        scene = cls()
        check(_scene_load_memory(context, byref(file) if file is not None else None, definitions, len(definitions), byref(scene)))
        return scene

    def add_instance(self, instance: Instance | None) -> int:
        """Adds an instance. id may be NULL; ids count up from 0, past those of removed instances too. The mesh must
        have the texture coordinates and colours that the material needs. Materials and environment of a scene must
        have one colour channel or the same number of channels."""
        id = c_uint32()
        check(_scene_add_instance(self, byref(instance) if instance is not None else None, byref(id)))
        return id.value

    def set_transform(self, id: int, to_world: Any) -> None:
        """Sets the transform of an instance; to_world is that of nicol_instance. The next render bakes again the
        vertices that the instance may shadow, before or now. A scene that rotates and moves as a whole is only
        relit."""
        check(_scene_set_transform(self, id, array(to_world, c_double, 16)))

    def set_mesh(self, id: int, mesh: Mesh) -> None:
        """Sets the mesh of an instance, under the conditions of nicol_scene_add_instance. The next render bakes again
        the instance and the vertices that it may shadow, before or now. An instance whose meshes have the same
        triangles, such as those of nicol_mesh_create_deformed, keeps its former shadows until they are baked, see
        bake_budget_ms of nicol_render_options."""
        check(_scene_set_mesh(self, id, mesh))

    def set_material(self, id: int, material: Material) -> None:
        """Sets the material of an instance, under the conditions of nicol_scene_add_instance. The next render
        projects the material, if it is new to the scene, and shades the instance."""
        check(_scene_set_material(self, id, material))

    def set_instance_flags(self, id: int, flags: int) -> None:
        """Sets the flags of an instance, as in nicol_instance. The next render repeats the bake of the instance
        and of the vertices that it may shadow. Returns NICOL_ERROR_INVALID_ARGUMENT for unknown flags."""
        check(_scene_set_instance_flags(self, id, flags))

    def get_instance_flags(self, id: int) -> int:
        """Gets the flags of an instance."""
        flags = c_uint32()
        check(_scene_get_instance_flags(self, id, byref(flags)))
        return flags.value

    def remove_instance(self, id: int) -> None:
        """Removes an instance. The id is not used again; other instances keep their ids."""
        check(_scene_remove_instance(self, id))

    def get_instance(self, id: int) -> tuple[Mesh | None, Material | None, tuple[float, ...]]:
        """Gets the parts of an instance: mesh and material as handles to release, and the transform. Each of the
        three may be NULL."""
        mesh = Mesh()
        material = Material()
        to_world = (c_double * 16)()
        check(_scene_get_instance(self, id, byref(mesh), byref(material), to_world))
        return mesh if mesh.value else None, material if material.value else None, tuple(to_world)

    def get_bounds(self) -> tuple[tuple[float, ...], tuple[float, ...]]:
        """Gets the box of all instances in the world, without local lights, which have no surface. Returns
        NICOL_ERROR_INVALID_ARGUMENT for a scene without instances."""
        lower = (c_double * 3)()
        upper = (c_double * 3)()
        check(_scene_get_bounds(self, lower, upper))
        return tuple(lower), tuple(upper)

    def get_instance_count(self) -> int:
        """Gets the number of instances."""
        instances = c_uint32()
        check(_scene_get_instance_count(self, byref(instances)))
        return instances.value

    def get_instance_ids(self, ids: Any) -> None:
        """Gets the ids of all instances, ascending. count must be the number of instances."""
        ids = Buffer(ids, c_uint32, writable=True)
        check(_scene_get_instance_ids(self, ids.pointer, ids.count))

    def set_environment(self, environment: Environment | None, to_world: Any, scale: float) -> None:
        """Sets the environment; NULL: darkness. to_world is a proper rotation of the environment; NULL: identity.
        scale is a factor on the radiance, finite and not negative; 1: no change; 0: darkness."""
        check(_scene_set_environment(self, environment, array(to_world, c_double, 16), scale))

    def get_environment(self) -> tuple[Environment | None, tuple[float, ...], float]:
        """Gets the arguments of nicol_scene_set_environment: the environment, as a handle to release, its rotation
        and scale. to_world and scale may be NULL. In darkness, including a file's scale of 0, *environment is
        NULL, to_world the identity and scale 1."""
        environment = Environment()
        to_world = (c_double * 16)()
        scale = c_double()
        check(_scene_get_environment(self, byref(environment), to_world, byref(scale)))
        return environment if environment.value else None, tuple(to_world), scale.value

    def hide_emitters(self, hide: int) -> None:
        """Sets whether emitters are hidden from the camera. hide 1: no light goes straight to the camera from the
        environment, which leaves black (alpha 0), or from instances that emit, which show only their reflection;
        both light the scene as before. hide 0: the camera sees emitters, unless the scene's file has
        hide_emitters."""
        check(_scene_hide_emitters(self, hide))

    def add_light(self, light: Light | None) -> int:
        """Adds a light. id may be NULL; ids of lights count up from 0, independently of instances. Lights, and the
        emission of instances, must have one colour channel or as many as the scene. The handle of the texture may
        be released afterwards. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that is out of
        range."""
        id = c_uint32()
        check(_scene_add_light(self, byref(light) if light is not None else None, byref(id)))
        return id.value

    def set_light(self, id: int, light: Light) -> None:
        """Replaces all fields of a light. The next render bakes nothing. The message of NICOL_ERROR_INVALID_ARGUMENT
        names the field that is out of range."""
        check(_scene_set_light(self, id, byref(light) if light is not None else None))

    def remove_light(self, id: int) -> None:
        """Removes a light. The id is not used again; other lights keep their ids."""
        check(_scene_remove_light(self, id))

    def get_light(self, id: int) -> tuple[Light, Texture | None]:
        """Gets a light as it was given. *texture, and not light->texture, is the light's texture as a handle to
        release, or NULL if the light has none. texture may be NULL."""
        light = Light()
        texture = Texture()
        check(_scene_get_light(self, id, byref(light), byref(texture)))
        return light, texture if texture.value else None

    def get_light_count(self) -> int:
        """Gets the number of lights."""
        lights = c_uint32()
        check(_scene_get_light_count(self, byref(lights)))
        return lights.value

    def get_light_ids(self, ids: Any) -> None:
        """Gets the ids of all lights, ascending. count must be the number of lights."""
        ids = Buffer(ids, c_uint32, writable=True)
        check(_scene_get_light_ids(self, ids.pointer, ids.count))

    def set_emission(self, id: int, emission: Emission | None) -> None:
        """Sets the emission of the instance `id`; NULL: the instance emits no light. A texture needs texture
        coordinates of the mesh. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that is out of
        range."""
        check(_scene_set_emission(self, id, byref(emission) if emission is not None else None))

    def get_emission(self, id: int) -> tuple[Emission, Texture | None]:
        """Gets the emission of an instance, with its texture as nicol_scene_get_light does. The radiance is 0 for an
        instance that emits no light."""
        emission = Emission()
        texture = Texture()
        check(_scene_get_emission(self, id, byref(emission), byref(texture)))
        return emission, texture if texture.value else None

    def add_polarization_element(self, element: PolarizationElement | None) -> int:
        """Adds a polarization element. id may be NULL; ids of elements count up from 0, independently of instances
        and lights. The handles of the textures may be released afterwards. The message of
        NICOL_ERROR_INVALID_ARGUMENT names the field that is out of range."""
        id = c_uint32()
        check(_scene_add_polarization_element(self, byref(element) if element is not None else None, byref(id)))
        return id.value

    def set_polarization_element(self, id: int, element: PolarizationElement) -> None:
        """Replaces all fields of a polarization element. The message of NICOL_ERROR_INVALID_ARGUMENT names the field
        that is out of range."""
        check(_scene_set_polarization_element(self, id, byref(element) if element is not None else None))

    def remove_polarization_element(self, id: int) -> None:
        """Removes a polarization element. The id is not used again; other elements keep their ids."""
        check(_scene_remove_polarization_element(self, id))

    def get_polarization_element(self, id: int) -> PolarizationElement:
        """Gets a polarization element as it was given, but for its textures, which are NULL."""
        element = PolarizationElement()
        check(_scene_get_polarization_element(self, id, byref(element)))
        return element

    def get_polarization_element_textures(self, id: int) -> tuple[Texture | None, Texture | None]:
        """Gets the textures of a polarization element as handles to release; NULL for none. angle or retardance may
        be NULL."""
        angle = Texture()
        retardance = Texture()
        check(_scene_get_polarization_element_textures(self, id, byref(angle), byref(retardance)))
        return angle if angle.value else None, retardance if retardance.value else None

    def get_polarization_element_count(self) -> int:
        """Gets the number of polarization elements."""
        elements = c_uint32()
        check(_scene_get_polarization_element_count(self, byref(elements)))
        return elements.value

    def get_polarization_element_ids(self, ids: Any) -> None:
        """Gets the ids of all polarization elements, ascending. count must be the number of elements."""
        ids = Buffer(ids, c_uint32, writable=True)
        check(_scene_get_polarization_element_ids(self, ids.pointer, ids.count))

    def get_camera(self) -> Camera:
        """Gets the camera of a loaded file. Returns NICOL_ERROR_UNSUPPORTED for a scene that was not loaded."""
        camera = Camera()
        check(_scene_get_camera(self, byref(camera)))
        return camera

    def get_film_size(self) -> tuple[int, int]:
        """Gets the film size of a loaded file, in pixels. Returns NICOL_ERROR_UNSUPPORTED for a scene that was not
        loaded."""
        width = c_uint32()
        height = c_uint32()
        check(_scene_get_film_size(self, byref(width), byref(height)))
        return width.value, height.value

    def get_sample_count(self) -> int:
        """Gets the samples of a pixel that the sampler of a loaded file asks for, 0 if there is no sampler; for the
        pixel_samples of nicol_render_options. Returns NICOL_ERROR_UNSUPPORTED for a scene that was not loaded."""
        samples = c_uint32()
        check(_scene_get_sample_count(self, byref(samples)))
        return samples.value

    def get_max_depth(self) -> int:
        """Gets the largest max_depth that the integrators of a loaded file ask for, for nicol_render_options: 1 or
        more, or NICOL_DEPTH_UNLIMITED, which is Mitsuba's default; 0 if there is no integrator. Returns
        NICOL_ERROR_UNSUPPORTED for a scene that was not loaded."""
        max_depth = c_int32()
        check(_scene_get_max_depth(self, byref(max_depth)))
        return max_depth.value

    def get_aovs(self) -> int:
        """Gets the AOVs that the integrators of a loaded file ask for, a sum of NICOL_AOV_... for
        nicol_render_options. Returns NICOL_ERROR_UNSUPPORTED for a scene that was not loaded."""
        aovs = c_uint32()
        check(_scene_get_aovs(self, byref(aovs)))
        return aovs.value

    def get_file_count(self) -> int:
        """Gets the number of files that nicol_scene_load has read, or 0 for a scene that was not loaded. Each file
        counts once: the scene file, the files that it includes (the buffers of glTF), then light, materials and
        meshes. Scenes whose files have equal digests are equal."""
        count = c_uint32()
        check(_scene_get_file_count(self, byref(count)))
        return count.value

    def get_file(self, index: int) -> SceneFile:
        """Gets a file that nicol_scene_load has read; index counts from 0. Returns NICOL_ERROR_INVALID_ARGUMENT for
        an index beyond the last file."""
        file = SceneFile()
        check(_scene_get_file(self, index, byref(file)))
        return file

    def get_channels(self) -> int:
        """Gets the number of colour channels of the scene's images: the number of everything in the scene, 1 (all
        grey) or more, and 1 if the film of a loaded file is luminance."""
        channels = c_uint32()
        check(_scene_get_channels(self, byref(channels)))
        return channels.value

    def get_filter(self) -> Filter:
        """Gets the filter that the film of a loaded file asks for, for nicol_render_options: Gaussian, which is
        Mitsuba's default, if a Mitsuba file names none; box for glTF. Returns NICOL_ERROR_UNSUPPORTED for a scene
        that was not loaded."""
        filter = Filter()
        check(_scene_get_filter(self, byref(filter)))
        return filter


class Framebuffer(Handle):
    """Stokes image of the last render into it"""

    @classmethod
    def create(cls, context: Context, width: int, height: int, channels: int) -> Self:
        """Creates a framebuffer. width and height are 1 to NICOL_MAX_SIZE pixels (the driver may allow less), and at
        most 2^26 pixels in all. channels is the scene's number, or 1 for the luminance of a scene of three
        channels: 0.2126 R + 0.7152 G + 0.0722 B of each Stokes component."""
        framebuffer = cls()
        check(_framebuffer_create(context, width, height, channels, byref(framebuffer)))
        return framebuffer

    def resize(self, width: int, height: int) -> None:
        """Changes the size, within the limits of nicol_framebuffer_create, and keeps the handle and the channels. The
        content is lost and undefined until the next render, and textures get other names; nothing happens if the
        size is the same. A job or another render that was given the framebuffer before puts its image into the
        former content, which is lost."""
        check(_framebuffer_resize(self, width, height))

    def get_size(self) -> tuple[int, int, int]:
        """Gets the width, height and channels of the framebuffer."""
        width = c_uint32()
        height = c_uint32()
        channels = c_uint32()
        check(_framebuffer_get_size(self, byref(width), byref(height), byref(channels)))
        return width.value, height.value, channels.value

    def blend(self, other: Framebuffer, weight: float) -> None:
        """Replaces the image of a framebuffer by (1 - weight) times this image plus weight times the image of
        `other`, in each Stokes component. weight is 0 to 1. AOVs and statistics do not change. For motion blur,
        the mean of n pictures, blend picture k, counted from 1, with weight 1 / k. Returns
        NICOL_ERROR_INVALID_ARGUMENT if the framebuffers are the same one, or differ in size or channels."""
        check(_framebuffer_blend(self, other, weight))

    def get_statistics(self) -> Statistics:
        """Gets the statistics of the last render into a framebuffer: all zeros before the first render."""
        statistics = Statistics()
        check(_framebuffer_get_statistics(self, byref(statistics)))
        return statistics

    def read(self, plane: Any, channel: int, pixels: Any) -> None:
        """Copies one plane of one colour channel, first row at the top. row_stride is in bytes; 0: tightly packed.
        byte_size is the room at pixels, in bytes. Returns NICOL_ERROR_INVALID_ARGUMENT for a plane that does not
        exist, and for NICOL_PLANE_INSTANCE, which holds no floats."""
        pixels = Buffer(pixels, c_float, writable=True, rows=True)
        check(_framebuffer_read(self, plane, channel, pixels.pointer, pixels.stride, pixels.nbytes))

    def read_plane(self, to: PlaneBuffer) -> None:
        """Copies a plane in the format and with the channels of `to`. Bytes between rows are not written. A call that
        fails writes nothing."""
        check(_framebuffer_read_plane(self, byref(to) if to is not None else None))

    def write_exr(self, path: str | os.PathLike[str]) -> None:
        """Writes an OpenEXR file of 32-bit floats, whose channels are named by the number of colour channels:
          3             R G B (which are s0) and S0.R S0.G S0.B to S3.R S3.G S3.B, as Mitsuba 3's stokes integrator
          1             Y (which is s0) and S0.Y to S3.Y
          2, 4 to 16    S0.0 S0.1 ... to S3.0 S3.1 ...
        A path that ends as the names of another kind of image do, such as .png, is refused.
        AOVs of the last render are Z (depth), N.X N.Y N.Z, P.X P.Y P.Z, id (32-bit unsigned), A (alpha; R G B still have the
        environment) and, for each Stokes channel, variance.S0.R ... variance.S3.B."""
        check(_framebuffer_write_exr(self, text(path)))

    def encode_exr(self, sink: Any) -> None:
        """Passes the bytes of the file that nicol_framebuffer_write_exr writes to a sink. The sink is called after
        all bytes are made; user is its first argument."""
        check(_framebuffer_encode_exr(self, SinkCallback(sink), None))

    def write_png(self, observation: Observation, path: str | os.PathLike[str]) -> None:
        """Writes a PNG file of 8-bit RGB; a path that ends as the names of another kind of image do, such as .jpg, is
        refused. S0 and POLARIZER need a framebuffer of 1 or 3 channels; the other kinds
        show the mean of the channels."""
        check(_framebuffer_write_png(self, byref(observation) if observation is not None else None, text(path)))

    def encode_png(self, observation: Observation, sink: Any) -> None:
        """Passes the bytes of the file that nicol_framebuffer_write_png writes to a sink. The sink is called after
        all bytes are made; user is its first argument."""
        check(_framebuffer_encode_png(self, byref(observation) if observation is not None else None, SinkCallback(sink), None))

    def expose(self, sensor: Sensor, frame: int, to: RawImage) -> None:
        """Exposes the sensor to the last image of a framebuffer."""
        check(_framebuffer_expose(self, byref(sensor) if sensor is not None else None, frame, byref(to) if to is not None else None))

    @classmethod
    def create_textures(cls, context: Context, textures: Any) -> Self:
        """Creates a framebuffer whose images are textures of the host's, one for each channel: level 0 of a
        GL_TEXTURE_2D of GL_RGBA32F, allocated by glTexStorage2D or glTextureStorage2D, all of one size. A texel is
        the Stokes vector, and row 0 the image's TOP. The textures must live until the framebuffer is released;
        Nicol never deletes them. The host may sample them between renders, and must not write them while the
        framebuffer lives. nicol_framebuffer_resize fails with NICOL_ERROR_UNSUPPORTED. Returns
        NICOL_ERROR_INVALID_ARGUMENT that names a texture which cannot be used, and NICOL_ERROR_UNSUPPORTED for a
        context that is not a host's."""
        textures = Buffer(textures, c_uint32)
        framebuffer = cls()
        check(_framebuffer_create_textures(context, textures.pointer, textures.count, byref(framebuffer)))
        return framebuffer

    def get_texture(self, channel: int) -> GlTexture:
        """Gets the texture of a colour channel: a texel is the Stokes vector (s0, s1, s2, s3), and row 0 is the
        image's TOP. The name is valid, and stays the same, until the framebuffer is released or resized; the
        content is that of the last render. The host may sample the texture and change its filters and wrap modes,
        but not its swizzle, and must neither write nor delete the texture. Returns NICOL_ERROR_UNSUPPORTED for a
        framebuffer whose context is not a host's."""
        texture = GlTexture()
        check(_framebuffer_get_texture(self, channel, byref(texture)))
        return texture

    def draw_plane(self, plane: Any, channel: int, target: TextureTarget) -> None:
        """Copies a plane of one channel into a texture; nothing is read back. A texel gets the numbers that
        nicol_framebuffer_read copies, in red, green, blue and alpha; components that the plane does not have are
        0, and alpha 1. The texture may also be of GL_R16F or GL_R32F for one component, and is of GL_R32UI for
        NICOL_PLANE_INSTANCE. Returns NICOL_ERROR_INVALID_ARGUMENT for NICOL_PLANE_VARIANCE, which is not on the
        device, and for NICOL_PLANE_POLARIZER, which nicol_framebuffer_draw_observation draws, and
        NICOL_ERROR_UNSUPPORTED for a framebuffer whose context is not a host's."""
        check(_framebuffer_draw_plane(self, plane, channel, byref(target) if target is not None else None))

    def draw_stokes(self, channel: int, target: TextureTarget) -> None:
        """Draws the plane NICOL_PLANE_STOKES."""
        check(_framebuffer_draw_stokes(self, channel, byref(target) if target is not None else None))

    def draw_observation(self, observation: Observation, target: TextureTarget) -> None:
        """Draws the image of nicol_framebuffer_write_png into a texture, as red, green, blue and alpha 1. s1 to s3
        need a scale above 0, because nothing is read back. Returns NICOL_ERROR_UNSUPPORTED for a framebuffer whose
        context is not a host's."""
        check(_framebuffer_draw_observation(self, byref(observation) if observation is not None else None, byref(target) if target is not None else None))


class Job(Handle):
    """Asynchronous render. Jobs of one context run one after another, in the order of submission, on a thread of
    the context. Only nicol_render and nicol_render_views of the same scene wait for a running job, unless
    fail_if_busy is set. Other functions return while it runs: those that use OpenGL wait at most for the step
    that the job gives to OpenGL, and those that use its framebuffer for the step that puts the image there. A
    job may be used from any thread; nicol_job_poll and nicol_job_cancel may also be called from callbacks.
    "Inside a host's OpenGL" says how jobs differ there."""

    def poll(self) -> JobStatus:
        """Gets the job's progress, and never waits for the job."""
        status = JobStatus()
        check(_job_poll(self, byref(status)))
        return status

    def wait(self, timeout_ms: int) -> None:
        """Waits until the job is done, at most timeout_ms milliseconds (0: not at all), and returns the job's result.
        After a failure of the job, nicol_last_error() has its message. Returns NICOL_ERROR_TIMEOUT if the job is
        not done in time, and NICOL_ERROR_NOT_CURRENT if the job needs a host's OpenGL context that is not current
        on the calling thread. Returns NICOL_ERROR_INVALID_ARGUMENT inside a callback of the context, because
        waiting there would be a deadlock."""
        check(_job_wait(self, timeout_ms))

    def cancel(self) -> None:
        """Cancels a queued job at once, or a running job when it would next call a progress callback. The job's
        result is NICOL_ERROR_CANCELLED. A job that is done or almost done is not affected. The function does not
        wait."""
        check(_job_cancel(self))


class PshTransform(Handle):
    """Transform between samples [vector][row][column][4], north to south, and coefficients, in O(order^3). The
    transform needs no context and holds its work space: no call allocates after creation. Calls on one
    transform are serialised."""

    @classmethod
    def create(cls, sampling: PshSampling) -> Self:
        """Creates a transform. Returns NICOL_ERROR_INVALID_ARGUMENT if the sampling is too coarse for the
        order."""
        transform = cls()
        check(_psh_transform_create(byref(sampling) if sampling is not None else None, byref(transform)))
        return transform

    def get_size(self) -> tuple[int, int]:
        """Gets the numbers of rows and columns of the transform's grid."""
        rows = c_uint32()
        columns = c_uint32()
        check(_psh_transform_get_size(self, byref(rows), byref(columns)))
        return rows.value, columns.value

    def get_rows(self, theta: Any, weight: Any) -> None:
        """Gets theta of each row, and the rows' weights for the integral over cos theta, which sum to 2;
        count = rows."""
        theta, weight = Buffer(theta, c_double, writable=True), Buffer(weight, c_double, writable=True)
        check(_psh_transform_get_rows(self, theta.pointer, weight.pointer, counted(theta, weight)))


def version() -> int:
    """Returns the version of the running library: major * 10000 + minor * 100 + patch."""
    return _version()


def version_string() -> str:
    """Returns the version of the running library as text, such as "0.1.0". The string lives as long as the
    library."""
    return decoded(_version_string())


def build_info(index: int) -> str | None:
    """Returns a property of this build as "key=value" (source, compiler, backends, methods, max_order, ...).
    index counts from 0; an index past the last property gives NULL. "files" lists the kinds of files that the
    build reads: exr, bitmaps, mesh_files and scene_files may be left out; calls for the others fail with
    NICOL_ERROR_UNSUPPORTED. The string lives as long as the library."""
    return decoded(_build_info(index))


def last_error() -> str:
    """Returns the message of the last failed call on this thread: one line that names the file, line, field or
    argument and what is expected. The message is never NULL, and "" before the first failure. The string is
    valid until this thread's next failed call. Tasks that move between threads, as in Go and in asynchronous
    runtimes, may see another task's message: they keep their thread for both calls, or use the error callback
    of nicol_context_options."""
    return decoded(_last_error())


def result_name(result: Any) -> str:
    """Returns a name such as "out of memory" for a result code. The string lives as long as the library."""
    return decoded(_result_name(result))


def device_count() -> int:
    """Gets the number of devices for nicol_context_options.device. The devices are those that EGL lists, in EGL's
    order, which is neither CUDA's nor the kernel's. Without EGL the number is 0. The list may change when
    devices or drivers are added or removed."""
    count = c_uint32()
    check(_device_count(byref(count)))
    return count.value


def device_get_info(device: int) -> DeviceInfo:
    """Gets the properties of a device; device is 1 to the number of nicol_device_count. Creating a context on the
    device may still fail, because this function does not create one."""
    info = DeviceInfo()
    check(_device_get_info(device, byref(info)))
    return info


def render(scene: Scene | None, camera: Camera | None, options: RenderOptions | None, framebuffer: Framebuffer | None) -> None:
    """Renders a scene into a framebuffer. options may be NULL: all defaults. Results that a change of the scene,
    the camera or the options does not affect are kept from the scene's last render; if nothing changed,
    nothing runs. On failure or cancellation the framebuffer keeps its content and statistics. Returns
    NICOL_ERROR_INVALID_ARGUMENT for options and cameras out of range and for channels that do not fit. Returns
    NICOL_ERROR_UNSUPPORTED for an unknown method, for compute shaders if the driver lacks features, and, if a
    material varies by a texture, for the dense method and for shading at vertices. Returns
    NICOL_ERROR_CANCELLED if a callback returned 0, NICOL_ERROR_BUSY as fail_if_busy says, and
    NICOL_ERROR_OUT_OF_MEMORY also beyond the context's memory_limit."""
    check(_render(scene, byref(camera) if camera is not None else None, byref(options) if options is not None else None, framebuffer))


def render_views(scene: Scene | None, cameras: Sequence[Camera], framebuffers: Sequence[Framebuffer], options: RenderOptions | None = None) -> None:
    """Renders several views of a scene, such as the faces of a cube or the cameras of a rig: the view of
    cameras[i] into framebuffers[i]. The images are those of nicol_render, called for one view after the other,
    but the views share one bake of what all of them need, and the light of each vertex. count is the number of
    views, 1 to NICOL_MAX_VIEWS. All cameras have the struct_size of cameras[0]. The framebuffers are different
    ones and may differ in size. options apply to each view, NULL: all defaults; bake_budget_ms is the time for
    all views together. The statistics of the first view that is drawn include the bake. Invalid arguments are
    refused before anything is rendered. After another failure or cancellation, the views before it have their
    images. Returns the results of nicol_render."""
    cameras, framebuffers = paired(cameras, Camera, framebuffers, Framebuffer)
    check(_render_views(scene, cameras, framebuffers, len(cameras), byref(options) if options is not None else None))


def render_async(scene: Scene, camera: Camera, options: Any, framebuffer: Framebuffer) -> Job:
    """Submits nicol_render as a job. The job copies the scene's state: later changes affect later renders only.
    The framebuffer keeps its content until the job puts its image there. Scene, framebuffer and all they need
    are kept alive. The caller may release them, and the job too, which runs all the same. The progress
    callback runs on the context's thread, and progress_user must live until the job is done. Invalid arguments
    are refused at once if possible; other errors are the job's result. Returns NICOL_ERROR_BUSY if
    NICOL_MAX_JOBS jobs are queued. A process that exits cancels its jobs."""
    options = lend(options)
    job = Job()
    check(_render_async(scene, byref(camera) if camera is not None else None, byref(options) if options is not None else None, framebuffer, byref(job)))
    return job


def render_adjoint(scene: Scene, camera: Camera, options: RenderOptions | None, picture: StokesImage, gradient: Gradient) -> None:
    """Computes gradients of a function f of the image that nicol_render makes with this camera and these options. The image is
    linear in its light: image = A light. The gradient by the light is the transpose of A times the gradient by the image. For
    f = |image - measured|^2 / 2, `picture` is image - measured, and conjugate gradients recover the light.
      picture       Derivatives of f by the Stokes vectors of the pixels, in all channels of the scene. Its size is the image's.
      Cost          About that of an image whose light has changed, and by texels three to five times as much: with 512 x 512
                    pixels, an image took 86 ms, gradients by instances 151, by the environment 108 and by texels 245 ms.
                    Nothing is drawn into a framebuffer.
      Bake          Gradients need all Stokes components. Callers that alternate between images and gradients should disable
                    NICOL_OPTIMISATION_LIGHT_COMPONENTS for both, because the bake then serves both.
      Options       method factored; executor automatic or cpu; physical 0; order_low and order_high given and equal, or
                    high_orders none; shade_at pixels, or automatic if that shades pixels; pixel_samples 0, 1, 4 or 8; filter
                    box; max_depth 0 or 2, or more for the gradient by the environment alone; both time budgets 0; split_lights
                    0 and bsdf_samples 0 if the image would otherwise have extracted lights or samples of the environment.
      Scene         No mirrors, no smooth glass, and with a max_depth above 2 no narrow metal; no polarization elements. The
                    gradient by the environment needs hidden emitters, that by instances no emissive surfaces, and those by
                    lights, by instances and by texels no local light of the value 0.
    Returns NICOL_ERROR_UNSUPPORTED for other options and scenes, with a message that says what to change.
    Returns NICOL_ERROR_INVALID_ARGUMENT for sizes that do not fit, for numbers that are not finite, for a local light of the
    value 0, and if the gradient by the environment is wanted without an environment, or by a texture that no instance's material
    reflects by; else the results of nicol_render. A call that fails writes nothing."""
    check(_render_adjoint(scene, byref(camera) if camera is not None else None, byref(options) if options is not None else None, byref(picture) if picture is not None else None, byref(gradient) if gradient is not None else None))


def psh_project_image(image: Any, order: int, coefficients: Any) -> None:
    """Projects an image to coefficients, one vector per channel, in the world's axes. The image is the bilinear
    function between its pixels and, as an environment, must be physically realizable: polarization up to s0.
    Returns NICOL_ERROR_INVALID_ARGUMENT unless count is channels * 4 (order+1)^2."""
    image = lend(image)
    coefficients = Buffer(coefficients, c_double, writable=True)
    check(_psh_project_image(byref(image) if image is not None else None, order, coefficients.pointer, coefficients.count))


def psh_project_environment(environment: Environment, order: int, coefficients: Any) -> None:
    """Projects an environment to coefficients, one vector per channel, in the world's axes. Returns
    NICOL_ERROR_INVALID_ARGUMENT unless count is channels * 4 (order+1)^2."""
    coefficients = Buffer(coefficients, c_double, writable=True)
    check(_psh_project_environment(environment, order, coefficients.pointer, coefficients.count))


def psh_project_file(path: str | os.PathLike[str] | None, order: int, coefficients: Any = None) -> int:
    """Projects a file that nicol_environment_load can read to coefficients, one vector per channel, in the
    world's axes. channels may be NULL; coefficients NULL with count 0 gets only the number of channels.
    Otherwise returns NICOL_ERROR_INVALID_ARGUMENT unless count is channels * 4 (order+1)^2."""
    channels = c_uint32()
    coefficients = Buffer(coefficients, c_double, writable=True)
    check(_psh_project_file(text(path), order, byref(channels), coefficients.pointer, coefficients.count))
    return channels.value


def psh_analyze(transform: PshTransform, vectors: int, samples: Any, coefficients: Any) -> None:
    """Computes coefficients from samples: inner products with the basis (Eq. 32) by the rows' weights."""
    samples = Buffer(samples, c_double)
    coefficients = Buffer(coefficients, c_double, writable=True)
    check(_psh_analyze(transform, vectors, samples.pointer, samples.count, coefficients.pointer, coefficients.count))


def psh_synthesize(transform: PshTransform, vectors: int, coefficients: Any, samples: Any) -> None:
    """Computes samples from coefficients: the field of the coefficients (Eq. 30) at the grid."""
    coefficients = Buffer(coefficients, c_double)
    samples = Buffer(samples, c_double, writable=True)
    check(_psh_synthesize(transform, vectors, coefficients.pointer, coefficients.count, samples.pointer, samples.count))


def psh_evaluate(order: int, vectors: int, coefficients: Any, directions: Any, stokes: Any) -> None:
    """Computes Stokes vectors [vector][direction][4] at directions [direction][3] of any length but 0."""
    coefficients = Buffer(coefficients, c_double)
    directions = Buffer(directions, c_double)
    stokes = Buffer(stokes, c_double, writable=True)
    check(_psh_evaluate(order, vectors, coefficients.pointer, coefficients.count, directions.pointer, directions.count, stokes.pointer, stokes.count))


def psh_rotate(order: int, vectors: int, in_: Any, rotation: Any, out: Any) -> None:
    """Rotates fields: (R f)(w) = R f(R^-1 w) (Eqs. 25, 36). The rotation must be orthonormal to 1e-5 and
    right-handed. out may be in."""
    in_ = Buffer(in_, c_double)
    out = Buffer(out, c_double, writable=True)
    check(_psh_rotate(order, vectors, in_.pointer, in_.count, array(rotation, c_double, 9), out.pointer, out.count))


def psh_reflect(order: int, vectors: int, in_: Any, out: Any) -> None:
    """Mirrors fields in the plane z = 0 (Eq. 214, with its conjugation). out may be in."""
    in_ = Buffer(in_, c_double)
    out = Buffer(out, c_double, writable=True)
    check(_psh_reflect(order, vectors, in_.pointer, in_.count, out.pointer, out.count))


def psh_multiply(scalar_order: int, scalar: Any, order: int, vectors: int, in_: Any, order_out: int, out: Any) -> None:
    """Multiplies each field by a scalar field, (scalar_order+1)^2 coefficients over real harmonics, such as
    visibility, and cuts the product above order_out. The product is exact, through a grid, in O(order^3). out
    may be in if the orders agree."""
    scalar = Buffer(scalar, c_double)
    in_ = Buffer(in_, c_double)
    out = Buffer(out, c_double, writable=True)
    check(_psh_multiply(scalar_order, scalar.pointer, scalar.count, order, vectors, in_.pointer, in_.count, order_out, out.pointer, out.count))


def psh_shadow_matrix(scalar_order: int, scalar: Any, order_out: int, order_in: int, matrix: Any) -> None:
    """Computes the matrix of nicol_psh_multiply for a scalar field (Eq. 54, by the triple products of Eqs. 215
    and 216)."""
    scalar = Buffer(scalar, c_double)
    matrix = Buffer(matrix, c_double, writable=True)
    check(_psh_shadow_matrix(scalar_order, scalar.pointer, scalar.count, order_out, order_in, matrix.pointer, matrix.count))


def psh_project_matrix(field: PshMuellerField, matrix: Any) -> None:
    """Computes the matrix of the operator "integrate the field times the light over the incoming directions"
    (Eqs. 39, 40), by quadrature."""
    matrix = Buffer(matrix, c_double, writable=True)
    check(_psh_project_matrix(byref(field) if field is not None else None, matrix.pointer, matrix.count))


def psh_apply_matrix(order_out: int, order_in: int, matrix: Any, vectors: int, in_: Any, out: Any) -> None:
    """Computes out = matrix * in, vector by vector (Eq. 41)."""
    matrix = Buffer(matrix, c_double)
    in_ = Buffer(in_, c_double)
    out = Buffer(out, c_double, writable=True)
    check(_psh_apply_matrix(order_out, order_in, matrix.pointer, matrix.count, vectors, in_.pointer, in_.count, out.pointer, out.count))


def psh_compose_matrix(order_out: int, order_between: int, order_in: int, second: Any, first: Any, matrix: Any) -> None:
    """Computes the matrix of `second` after `first`."""
    second = Buffer(second, c_double)
    first = Buffer(first, c_double)
    matrix = Buffer(matrix, c_double, writable=True)
    check(_psh_compose_matrix(order_out, order_between, order_in, second.pointer, second.count, first.pointer, first.count, matrix.pointer, matrix.count))


def psh_project_kernel(callback: Any, order: int, rows: int, bands: Any) -> None:
    """Computes the bands of a kernel by quadrature (Eq. 68). rows is the number of Gauss-Legendre rows, at most
    16384; 0: 2 order + 2."""
    bands = Buffer(bands, c_double, writable=True)
    check(_psh_project_kernel(PshKernelCallback(callback), None, order, rows, bands.pointer, bands.count))


def psh_kernel_at(order: int, bands: Any, theta: Any, mueller: Any) -> None:
    """Computes Mueller matrices [angle][16] of a kernel at angles in 0 to pi, the inverse of
    nicol_psh_project_kernel."""
    bands = Buffer(bands, c_double)
    theta = Buffer(theta, c_double)
    mueller = Buffer(mueller, c_double, writable=True)
    check(_psh_kernel_at(order, bands.pointer, bands.count, theta.pointer, theta.count, mueller.pointer, mueller.count))


def psh_convolve(order: int, bands: Any, vectors: int, in_: Any, out: Any) -> None:
    """Convolves each field with a kernel (Eq. 69). out may be in."""
    bands = Buffer(bands, c_double)
    in_ = Buffer(in_, c_double)
    out = Buffer(out, c_double, writable=True)
    check(_psh_convolve(order, bands.pointer, bands.count, vectors, in_.pointer, in_.count, out.pointer, out.count))


def psh_kernel_matrix(order: int, bands: Any, matrix: Any) -> None:
    """Computes the matrix of a convolution (supplement E.9); both sides of the matrix have this order."""
    bands = Buffer(bands, c_double)
    matrix = Buffer(matrix, c_double, writable=True)
    check(_psh_kernel_matrix(order, bands.pointer, bands.count, matrix.pointer, matrix.count))


def psh_nearest_kernel(order: int, matrix: Any, bands: Any) -> None:
    """Computes the kernel nearest to a matrix in the Frobenius norm (supplement E.9); both sides of the matrix
    have this order."""
    matrix = Buffer(matrix, c_double)
    bands = Buffer(bands, c_double, writable=True)
    check(_psh_nearest_kernel(order, matrix.pointer, matrix.count, bands.pointer, bands.count))


def file_identify(path: str | os.PathLike[str]) -> int:
    """Gets the kind of a file from its suffix and headers alone; the file may yet prove damaged. Returns
    NICOL_ERROR_UNSUPPORTED for another suffix or an archive of another kind."""
    kind = c_uint32()
    check(_file_identify(text(path), byref(kind)))
    return kind.value


def file_describe_light(path: str | os.PathLike[str] | None, options: FileOptions | None, energy: Any = None) -> LightReport:
    """Gets the report of a light, and its energies [channel][l][p], 4 (order + 1) per channel: squares of the
    coefficients, summed over m. energy has room for count doubles, and may be NULL with count 0. options may
    be NULL. Scale and rotation change the report as they would change an output. Options of images to write
    must be 0. The order limits the energies of an image, and everything for coefficients. An image that
    violates Eq. 70 is described, although it is refused as a light."""
    report = LightReport()
    energy = Buffer(energy, c_double, writable=True)
    check(_file_describe_light(text(path), byref(options) if options is not None else None, byref(report), energy.pointer, energy.count))
    return report


def file_describe_material(path: str | os.PathLike[str], options: FileOptions | None, energy: Any) -> MaterialReport:
    """Gets the report of a material, and its energies [channel][l], order + 1 per channel: squares of the matrix'
    entries between two orders, the larger of which is l. options are those of nicol_file_describe_light."""
    report = MaterialReport()
    energy = Buffer(energy, c_double, writable=True)
    check(_file_describe_material(text(path), byref(options) if options is not None else None, byref(report), energy.pointer, energy.count))
    return report


def file_convert(in_: str | os.PathLike[str] | None, options: FileOptions | None, out: str | os.PathLike[str] | None) -> None:
    """Reads the file `in` and writes `out` in the kind that the name of `out` says: .exr, _s0.exr (all four
    files), .npz or a cache folder. Light becomes light, and a material becomes a material. options may be
    NULL."""
    check(_file_convert(text(in_), byref(options) if options is not None else None, text(out)))


def file_demosaic(in_: str | os.PathLike[str], sensor: Sensor, method: Any, out: str | os.PathLike[str]) -> None:
    """Reads a mosaic from a grey image of 8 or 16 bits, as of a polarization camera or nicol_sensor_write_png,
    and writes the Stokes image of nicol_sensor_demosaic to an OpenEXR file."""
    check(_file_demosaic(text(in_), byref(sensor) if sensor is not None else None, method, text(out)))


def file_combine_angles(at_0: str | os.PathLike[str], at_45: str | os.PathLike[str], at_90: str | os.PathLike[str], at_135: str | os.PathLike[str], out: str | os.PathLike[str]) -> None:
    """Reads pictures of one view behind a polarizer at 0, 45, 90 and 135 degrees counter-clockwise from image
    right, and writes the Stokes image in front of it to an OpenEXR file, with s3 = 0. EXR files give s0. Other
    images give their numbers as linear light in 0 to 1, without a curve."""
    check(_file_combine_angles(text(at_0), text(at_45), text(at_90), text(at_135), text(out)))


def psh_write_file(path: str | os.PathLike[str], order: int, vectors: int, coefficients: Any) -> None:
    """Writes coefficients of 1 to NICOL_MAX_CHANNELS vectors to a file of the kind NICOL_FILE_LIGHT_PSH."""
    coefficients = Buffer(coefficients, c_double)
    check(_psh_write_file(text(path), order, vectors, coefficients.pointer, coefficients.count))


_version = declare("nicol_version", c_uint32)
_version_string = declare("nicol_version_string", c_char_p)
_build_info = declare("nicol_build_info", c_char_p, c_uint32)
_last_error = declare("nicol_last_error", c_char_p)
_result_name = declare("nicol_result_name", c_char_p, c_int32)
Spectrum._init = declare("nicol_spectrum_init", c_int32, POINTER(Spectrum), c_uint32)
_device_count = declare("nicol_device_count", c_int32, POINTER(c_uint32))
DeviceInfo._init = declare("nicol_device_info_init", c_int32, POINTER(DeviceInfo), c_uint32)
_device_get_info = declare("nicol_device_get_info", c_int32, c_uint32, POINTER(DeviceInfo))
ContextOptions._init = declare("nicol_context_options_init", c_int32, POINTER(ContextOptions), c_uint32)
ContextInfo._init = declare("nicol_context_info_init", c_int32, POINTER(ContextInfo), c_uint32)
_context_create = declare("nicol_context_create", c_int32, POINTER(ContextOptions), POINTER(Context))
Context._release = declare("nicol_context_release", c_int32, c_void_p)
_context_set_log = declare("nicol_context_set_log", c_int32, Context, LogCallback.type, c_void_p)
_context_get_info = declare("nicol_context_get_info", c_int32, Context, POINTER(ContextInfo))
FileContent._init = declare("nicol_file_content_init", c_int32, POINTER(FileContent), c_uint32)
MemoryFile._init = declare("nicol_memory_file_init", c_int32, POINTER(MemoryFile), c_uint32)
Image._init = declare("nicol_image_init", c_int32, POINTER(Image), c_uint32)
Sky._init = declare("nicol_sky_init", c_int32, POINTER(Sky), c_uint32)
EnvironmentLoadOptions._init = declare("nicol_environment_load_options_init", c_int32, POINTER(EnvironmentLoadOptions), c_uint32)
_environment_load = declare("nicol_environment_load", c_int32, Context, c_char_p, POINTER(EnvironmentLoadOptions), POINTER(Environment))
_environment_load_memory = declare("nicol_environment_load_memory", c_int32, Context, POINTER(MemoryFile), POINTER(EnvironmentLoadOptions), POINTER(Environment))
_environment_create_image = declare("nicol_environment_create_image", c_int32, Context, POINTER(Image), POINTER(Environment))
_environment_create_constant = declare("nicol_environment_create_constant", c_int32, Context, POINTER(Spectrum), POINTER(Environment))
_environment_create_sky = declare("nicol_environment_create_sky", c_int32, Context, POINTER(Sky), POINTER(Environment))
_environment_create_psh = declare("nicol_environment_create_psh", c_int32, Context, c_uint32, c_uint32, POINTER(c_double), c_uint64, POINTER(Environment))
EnvironmentInfo._init = declare("nicol_environment_info_init", c_int32, POINTER(EnvironmentInfo), c_uint32)
_environment_get_info = declare("nicol_environment_get_info", c_int32, Environment, POINTER(EnvironmentInfo))
Environment._release = declare("nicol_environment_release", c_int32, c_void_p)
TextureImage._init = declare("nicol_texture_image_init", c_int32, POINTER(TextureImage), c_uint32)
TextureOptions._init = declare("nicol_texture_options_init", c_int32, POINTER(TextureOptions), c_uint32)
_texture_create_image = declare("nicol_texture_create_image", c_int32, Context, POINTER(TextureImage), POINTER(TextureOptions), POINTER(Texture))
_texture_load = declare("nicol_texture_load", c_int32, Context, c_char_p, POINTER(TextureOptions), POINTER(Texture))
_texture_load_memory = declare("nicol_texture_load_memory", c_int32, Context, POINTER(MemoryFile), POINTER(TextureOptions), POINTER(Texture))
_texture_create_checkerboard = declare("nicol_texture_create_checkerboard", c_int32, Context, POINTER(Spectrum), POINTER(Spectrum), POINTER(c_double), POINTER(Texture))
_texture_create_vertex_colors = declare("nicol_texture_create_vertex_colors", c_int32, Context, POINTER(Texture))
_texture_create_face_colors = declare("nicol_texture_create_face_colors", c_int32, Context, POINTER(Texture))
Texture._release = declare("nicol_texture_release", c_int32, c_void_p)
Film._init = declare("nicol_film_init", c_int32, POINTER(Film), c_uint32)
Pplastic._init = declare("nicol_pplastic_init", c_int32, POINTER(Pplastic), c_uint32)
_material_create_pplastic = declare("nicol_material_create_pplastic", c_int32, Context, POINTER(Pplastic), POINTER(Material))
Plastic._init = declare("nicol_plastic_init", c_int32, POINTER(Plastic), c_uint32)
_material_create_plastic = declare("nicol_material_create_plastic", c_int32, Context, POINTER(Plastic), POINTER(Material))
Principled._init = declare("nicol_principled_init", c_int32, POINTER(Principled), c_uint32)
_material_create_principled = declare("nicol_material_create_principled", c_int32, Context, POINTER(Principled), POINTER(Material))
_material_create_diffuse = declare("nicol_material_create_diffuse", c_int32, Context, POINTER(Spectrum), POINTER(Material))
Conductor._init = declare("nicol_conductor_init", c_int32, POINTER(Conductor), c_uint32)
_material_create_conductor = declare("nicol_material_create_conductor", c_int32, Context, POINTER(Conductor), POINTER(Material))
Dielectric._init = declare("nicol_dielectric_init", c_int32, POINTER(Dielectric), c_uint32)
_material_create_dielectric = declare("nicol_material_create_dielectric", c_int32, Context, POINTER(Dielectric), POINTER(Material))
Measured._init = declare("nicol_measured_init", c_int32, POINTER(Measured), c_uint32)
_material_load_measured = declare("nicol_material_load_measured", c_int32, Context, c_char_p, POINTER(Measured), POINTER(Material))
_material_load_measured_memory = declare("nicol_material_load_measured_memory", c_int32, Context, POINTER(MemoryFile), POINTER(Measured), POINTER(Material))
PshMatrix._init = declare("nicol_psh_matrix_init", c_int32, POINTER(PshMatrix), c_uint32)
_material_load_psh = declare("nicol_material_load_psh", c_int32, Context, c_char_p, POINTER(PshMatrix), POINTER(Material))
_material_load_psh_memory = declare("nicol_material_load_psh_memory", c_int32, Context, POINTER(MemoryFile), POINTER(PshMatrix), POINTER(Material))
_material_create_twosided = declare("nicol_material_create_twosided", c_int32, Context, Material, POINTER(Material))
_material_create_scaled = declare("nicol_material_create_scaled", c_int32, Context, Material, Texture, POINTER(Material))
_material_create_blend = declare("nicol_material_create_blend", c_int32, Context, Material, Material, Texture, POINTER(Material))
_material_create_normal_map = declare("nicol_material_create_normal_map", c_int32, Context, Material, Texture, c_uint32, POINTER(Material))
_material_create_bump_map = declare("nicol_material_create_bump_map", c_int32, Context, Material, Texture, c_double, POINTER(Material))
_material_create_rotated = declare("nicol_material_create_rotated", c_int32, Context, Material, Texture, c_double, POINTER(Material))
_material_create_mask = declare("nicol_material_create_mask", c_int32, Context, Material, Texture, POINTER(Material))
CallbackMaterial._init = declare("nicol_callback_material_init", c_int32, POINTER(CallbackMaterial), c_uint32)
_material_create_callback = declare("nicol_material_create_callback", c_int32, Context, POINTER(CallbackMaterial), POINTER(Material))
Material._release = declare("nicol_material_release", c_int32, c_void_p)
MeshData._init = declare("nicol_mesh_data_init", c_int32, POINTER(MeshData), c_uint32)
_mesh_load = declare("nicol_mesh_load", c_int32, Context, c_char_p, POINTER(Mesh))
_mesh_load_memory = declare("nicol_mesh_load_memory", c_int32, Context, POINTER(MemoryFile), POINTER(Mesh))
_mesh_create = declare("nicol_mesh_create", c_int32, Context, POINTER(MeshData), POINTER(Mesh))
_mesh_create_sphere = declare("nicol_mesh_create_sphere", c_int32, Context, POINTER(Mesh))
_mesh_create_divided_sphere = declare("nicol_mesh_create_divided_sphere", c_int32, Context, c_uint32, POINTER(Mesh))
_mesh_create_rectangle = declare("nicol_mesh_create_rectangle", c_int32, Context, POINTER(Mesh))
_mesh_create_cube = declare("nicol_mesh_create_cube", c_int32, Context, POINTER(Mesh))
_mesh_create_disk = declare("nicol_mesh_create_disk", c_int32, Context, POINTER(Mesh))
_mesh_create_cylinder = declare("nicol_mesh_create_cylinder", c_int32, Context, POINTER(c_double), POINTER(c_double), c_double, POINTER(Mesh))
Deformation._init = declare("nicol_deformation_init", c_int32, POINTER(Deformation), c_uint32)
_mesh_create_deformed = declare("nicol_mesh_create_deformed", c_int32, Context, Mesh, POINTER(Deformation), POINTER(Mesh))
_mesh_get_size = declare("nicol_mesh_get_size", c_int32, Mesh, POINTER(c_uint32), POINTER(c_uint32))
_mesh_get_bounds = declare("nicol_mesh_get_bounds", c_int32, Mesh, POINTER(c_double), POINTER(c_double))
Mesh._release = declare("nicol_mesh_release", c_int32, c_void_p)
Camera._init = declare("nicol_camera_init", c_int32, POINTER(Camera), c_uint32)
_camera_look_at = declare("nicol_camera_look_at", c_int32, POINTER(Camera), POINTER(c_double), POINTER(c_double), POINTER(c_double))
_camera_set_opencv = declare("nicol_camera_set_opencv", c_int32, POINTER(Camera), POINTER(c_double), POINTER(c_double), POINTER(c_double), c_uint32, c_uint32)
_camera_get_opencv = declare("nicol_camera_get_opencv", c_int32, POINTER(Camera), c_uint32, c_uint32, POINTER(c_double), POINTER(c_double), POINTER(c_double))
_camera_frame = declare("nicol_camera_frame", c_int32, POINTER(Camera), POINTER(c_double), POINTER(c_double), c_uint32, c_uint32)
Polarization._init = declare("nicol_polarization_init", c_int32, POINTER(Polarization), c_uint32)
Light._init = declare("nicol_light_init", c_int32, POINTER(Light), c_uint32)
_sky_get_sun = declare("nicol_sky_get_sun", c_int32, POINTER(Sky), POINTER(Light))
Emission._init = declare("nicol_emission_init", c_int32, POINTER(Emission), c_uint32)
PolarizationElement._init = declare("nicol_polarization_element_init", c_int32, POINTER(PolarizationElement), c_uint32)
Instance._init = declare("nicol_instance_init", c_int32, POINTER(Instance), c_uint32)
_scene_create = declare("nicol_scene_create", c_int32, Context, POINTER(Scene))
_scene_load = declare("nicol_scene_load", c_int32, Context, c_char_p, POINTER(c_char_p), c_uint32, POINTER(Scene))
_scene_set_time = declare("nicol_scene_set_time", c_int32, Scene, c_double)
_scene_load_memory = declare("nicol_scene_load_memory", c_int32, Context, POINTER(MemoryFile), POINTER(c_char_p), c_uint32, POINTER(Scene))
_scene_add_instance = declare("nicol_scene_add_instance", c_int32, Scene, POINTER(Instance), POINTER(c_uint32))
_scene_set_transform = declare("nicol_scene_set_transform", c_int32, Scene, c_uint32, POINTER(c_double))
_scene_set_mesh = declare("nicol_scene_set_mesh", c_int32, Scene, c_uint32, Mesh)
_scene_set_material = declare("nicol_scene_set_material", c_int32, Scene, c_uint32, Material)
_scene_set_instance_flags = declare("nicol_scene_set_instance_flags", c_int32, Scene, c_uint32, c_uint32)
_scene_get_instance_flags = declare("nicol_scene_get_instance_flags", c_int32, Scene, c_uint32, POINTER(c_uint32))
_scene_remove_instance = declare("nicol_scene_remove_instance", c_int32, Scene, c_uint32)
_scene_get_instance = declare("nicol_scene_get_instance", c_int32, Scene, c_uint32, POINTER(Mesh), POINTER(Material), POINTER(c_double))
_scene_get_bounds = declare("nicol_scene_get_bounds", c_int32, Scene, POINTER(c_double), POINTER(c_double))
_scene_get_instance_count = declare("nicol_scene_get_instance_count", c_int32, Scene, POINTER(c_uint32))
_scene_get_instance_ids = declare("nicol_scene_get_instance_ids", c_int32, Scene, POINTER(c_uint32), c_uint64)
_scene_set_environment = declare("nicol_scene_set_environment", c_int32, Scene, Environment, POINTER(c_double), c_double)
_scene_get_environment = declare("nicol_scene_get_environment", c_int32, Scene, POINTER(Environment), POINTER(c_double), POINTER(c_double))
_scene_hide_emitters = declare("nicol_scene_hide_emitters", c_int32, Scene, c_uint32)
_scene_add_light = declare("nicol_scene_add_light", c_int32, Scene, POINTER(Light), POINTER(c_uint32))
_scene_set_light = declare("nicol_scene_set_light", c_int32, Scene, c_uint32, POINTER(Light))
_scene_remove_light = declare("nicol_scene_remove_light", c_int32, Scene, c_uint32)
_scene_get_light = declare("nicol_scene_get_light", c_int32, Scene, c_uint32, POINTER(Light), POINTER(Texture))
_scene_get_light_count = declare("nicol_scene_get_light_count", c_int32, Scene, POINTER(c_uint32))
_scene_get_light_ids = declare("nicol_scene_get_light_ids", c_int32, Scene, POINTER(c_uint32), c_uint64)
_scene_set_emission = declare("nicol_scene_set_emission", c_int32, Scene, c_uint32, POINTER(Emission))
_scene_get_emission = declare("nicol_scene_get_emission", c_int32, Scene, c_uint32, POINTER(Emission), POINTER(Texture))
_scene_add_polarization_element = declare("nicol_scene_add_polarization_element", c_int32, Scene, POINTER(PolarizationElement), POINTER(c_uint32))
_scene_set_polarization_element = declare("nicol_scene_set_polarization_element", c_int32, Scene, c_uint32, POINTER(PolarizationElement))
_scene_remove_polarization_element = declare("nicol_scene_remove_polarization_element", c_int32, Scene, c_uint32)
_scene_get_polarization_element = declare("nicol_scene_get_polarization_element", c_int32, Scene, c_uint32, POINTER(PolarizationElement))
_scene_get_polarization_element_textures = declare("nicol_scene_get_polarization_element_textures", c_int32, Scene, c_uint32, POINTER(Texture), POINTER(Texture))
_scene_get_polarization_element_count = declare("nicol_scene_get_polarization_element_count", c_int32, Scene, POINTER(c_uint32))
_scene_get_polarization_element_ids = declare("nicol_scene_get_polarization_element_ids", c_int32, Scene, POINTER(c_uint32), c_uint64)
_scene_get_camera = declare("nicol_scene_get_camera", c_int32, Scene, POINTER(Camera))
_scene_get_film_size = declare("nicol_scene_get_film_size", c_int32, Scene, POINTER(c_uint32), POINTER(c_uint32))
_scene_get_sample_count = declare("nicol_scene_get_sample_count", c_int32, Scene, POINTER(c_uint32))
_scene_get_max_depth = declare("nicol_scene_get_max_depth", c_int32, Scene, POINTER(c_int32))
_scene_get_aovs = declare("nicol_scene_get_aovs", c_int32, Scene, POINTER(c_uint32))
SceneFile._init = declare("nicol_scene_file_init", c_int32, POINTER(SceneFile), c_uint32)
_scene_get_file_count = declare("nicol_scene_get_file_count", c_int32, Scene, POINTER(c_uint32))
_scene_get_file = declare("nicol_scene_get_file", c_int32, Scene, c_uint32, POINTER(SceneFile))
_scene_get_channels = declare("nicol_scene_get_channels", c_int32, Scene, POINTER(c_uint32))
Scene._release = declare("nicol_scene_release", c_int32, c_void_p)
Filter._init = declare("nicol_filter_init", c_int32, POINTER(Filter), c_uint32)
_scene_get_filter = declare("nicol_scene_get_filter", c_int32, Scene, POINTER(Filter))
RenderOptions._init = declare("nicol_render_options_init", c_int32, POINTER(RenderOptions), c_uint32)
_render_options_set_quality = declare("nicol_render_options_set_quality", c_int32, POINTER(RenderOptions), c_uint32)
_framebuffer_create = declare("nicol_framebuffer_create", c_int32, Context, c_uint32, c_uint32, c_uint32, POINTER(Framebuffer))
_framebuffer_resize = declare("nicol_framebuffer_resize", c_int32, Framebuffer, c_uint32, c_uint32)
_framebuffer_get_size = declare("nicol_framebuffer_get_size", c_int32, Framebuffer, POINTER(c_uint32), POINTER(c_uint32), POINTER(c_uint32))
_framebuffer_blend = declare("nicol_framebuffer_blend", c_int32, Framebuffer, Framebuffer, c_double)
Framebuffer._release = declare("nicol_framebuffer_release", c_int32, c_void_p)
_render = declare("nicol_render", c_int32, Scene, POINTER(Camera), POINTER(RenderOptions), Framebuffer)
_render_views = declare("nicol_render_views", c_int32, Scene, POINTER(Camera), POINTER(Framebuffer), c_uint32, POINTER(RenderOptions))
_render_async = declare("nicol_render_async", c_int32, Scene, POINTER(Camera), POINTER(RenderOptions), Framebuffer, POINTER(Job))
JobStatus._init = declare("nicol_job_status_init", c_int32, POINTER(JobStatus), c_uint32)
_job_poll = declare("nicol_job_poll", c_int32, Job, POINTER(JobStatus))
_job_wait = declare("nicol_job_wait", c_int32, Job, c_uint32)
_job_cancel = declare("nicol_job_cancel", c_int32, Job)
Job._release = declare("nicol_job_release", c_int32, c_void_p)
Statistics._init = declare("nicol_statistics_init", c_int32, POINTER(Statistics), c_uint32)
_framebuffer_get_statistics = declare("nicol_framebuffer_get_statistics", c_int32, Framebuffer, POINTER(Statistics))
_framebuffer_read = declare("nicol_framebuffer_read", c_int32, Framebuffer, c_uint32, c_uint32, POINTER(c_float), c_uint64, c_uint64)
PlaneBuffer._init = declare("nicol_plane_buffer_init", c_int32, POINTER(PlaneBuffer), c_uint32)
_framebuffer_read_plane = declare("nicol_framebuffer_read_plane", c_int32, Framebuffer, POINTER(PlaneBuffer))
_framebuffer_write_exr = declare("nicol_framebuffer_write_exr", c_int32, Framebuffer, c_char_p)
_framebuffer_encode_exr = declare("nicol_framebuffer_encode_exr", c_int32, Framebuffer, SinkCallback.type, c_void_p)
Observation._init = declare("nicol_observation_init", c_int32, POINTER(Observation), c_uint32)
_framebuffer_write_png = declare("nicol_framebuffer_write_png", c_int32, Framebuffer, POINTER(Observation), c_char_p)
_framebuffer_encode_png = declare("nicol_framebuffer_encode_png", c_int32, Framebuffer, POINTER(Observation), SinkCallback.type, c_void_p)
Sensor._init = declare("nicol_sensor_init", c_int32, POINTER(Sensor), c_uint32)
_sensor_set_preset = declare("nicol_sensor_set_preset", c_int32, POINTER(Sensor), c_uint32)
_sensor_load = declare("nicol_sensor_load", c_int32, POINTER(Sensor), c_char_p)
_sensor_load_memory = declare("nicol_sensor_load_memory", c_int32, POINTER(Sensor), POINTER(MemoryFile))
_sensor_add_element = declare("nicol_sensor_add_element", c_int32, POINTER(Sensor), POINTER(PolarizationElement), c_double)
StokesImage._init = declare("nicol_stokes_image_init", c_int32, POINTER(StokesImage), c_uint32)
RawImage._init = declare("nicol_raw_image_init", c_int32, POINTER(RawImage), c_uint32)
_sensor_expose = declare("nicol_sensor_expose", c_int32, POINTER(Sensor), POINTER(StokesImage), c_uint64, POINTER(RawImage))
_framebuffer_expose = declare("nicol_framebuffer_expose", c_int32, Framebuffer, POINTER(Sensor), c_uint64, POINTER(RawImage))
_sensor_write_png = declare("nicol_sensor_write_png", c_int32, POINTER(Sensor), POINTER(RawImage), c_char_p)
_sensor_demosaic = declare("nicol_sensor_demosaic", c_int32, POINTER(Sensor), POINTER(RawImage), c_uint32, POINTER(StokesImage))
Gradient._init = declare("nicol_gradient_init", c_int32, POINTER(Gradient), c_uint32)
_render_adjoint = declare("nicol_render_adjoint", c_int32, Scene, POINTER(Camera), POINTER(RenderOptions), POINTER(StokesImage), POINTER(Gradient))
Host._init = declare("nicol_host_init", c_int32, POINTER(Host), c_uint32)
_context_create_host = declare("nicol_context_create_host", c_int32, POINTER(Host), POINTER(ContextOptions), POINTER(Context))
_framebuffer_create_textures = declare("nicol_framebuffer_create_textures", c_int32, Context, POINTER(c_uint32), c_uint32, POINTER(Framebuffer))
GlTexture._init = declare("nicol_gl_texture_init", c_int32, POINTER(GlTexture), c_uint32)
_framebuffer_get_texture = declare("nicol_framebuffer_get_texture", c_int32, Framebuffer, c_uint32, POINTER(GlTexture))
TextureTarget._init = declare("nicol_texture_target_init", c_int32, POINTER(TextureTarget), c_uint32)
_framebuffer_draw_plane = declare("nicol_framebuffer_draw_plane", c_int32, Framebuffer, c_uint32, c_uint32, POINTER(TextureTarget))
_framebuffer_draw_stokes = declare("nicol_framebuffer_draw_stokes", c_int32, Framebuffer, c_uint32, POINTER(TextureTarget))
_framebuffer_draw_observation = declare("nicol_framebuffer_draw_observation", c_int32, Framebuffer, POINTER(Observation), POINTER(TextureTarget))
_psh_project_image = declare("nicol_psh_project_image", c_int32, POINTER(Image), c_uint32, POINTER(c_double), c_uint64)
_psh_project_environment = declare("nicol_psh_project_environment", c_int32, Environment, c_uint32, POINTER(c_double), c_uint64)
_psh_project_file = declare("nicol_psh_project_file", c_int32, c_char_p, c_uint32, POINTER(c_uint32), POINTER(c_double), c_uint64)
PshSampling._init = declare("nicol_psh_sampling_init", c_int32, POINTER(PshSampling), c_uint32)
_psh_transform_create = declare("nicol_psh_transform_create", c_int32, POINTER(PshSampling), POINTER(PshTransform))
PshTransform._release = declare("nicol_psh_transform_release", c_int32, c_void_p)
_psh_transform_get_size = declare("nicol_psh_transform_get_size", c_int32, PshTransform, POINTER(c_uint32), POINTER(c_uint32))
_psh_transform_get_rows = declare("nicol_psh_transform_get_rows", c_int32, PshTransform, POINTER(c_double), POINTER(c_double), c_uint64)
_psh_analyze = declare("nicol_psh_analyze", c_int32, PshTransform, c_uint64, POINTER(c_double), c_uint64, POINTER(c_double), c_uint64)
_psh_synthesize = declare("nicol_psh_synthesize", c_int32, PshTransform, c_uint64, POINTER(c_double), c_uint64, POINTER(c_double), c_uint64)
_psh_evaluate = declare("nicol_psh_evaluate", c_int32, c_uint32, c_uint64, POINTER(c_double), c_uint64, POINTER(c_double), c_uint64, POINTER(c_double), c_uint64)
_psh_rotate = declare("nicol_psh_rotate", c_int32, c_uint32, c_uint64, POINTER(c_double), c_uint64, POINTER(c_double), POINTER(c_double), c_uint64)
_psh_reflect = declare("nicol_psh_reflect", c_int32, c_uint32, c_uint64, POINTER(c_double), c_uint64, POINTER(c_double), c_uint64)
_psh_multiply = declare("nicol_psh_multiply", c_int32, c_uint32, POINTER(c_double), c_uint64, c_uint32, c_uint64, POINTER(c_double), c_uint64, c_uint32, POINTER(c_double), c_uint64)
_psh_shadow_matrix = declare("nicol_psh_shadow_matrix", c_int32, c_uint32, POINTER(c_double), c_uint64, c_uint32, c_uint32, POINTER(c_double), c_uint64)
PshMuellerField._init = declare("nicol_psh_mueller_field_init", c_int32, POINTER(PshMuellerField), c_uint32)
_psh_project_matrix = declare("nicol_psh_project_matrix", c_int32, POINTER(PshMuellerField), POINTER(c_double), c_uint64)
_psh_apply_matrix = declare("nicol_psh_apply_matrix", c_int32, c_uint32, c_uint32, POINTER(c_double), c_uint64, c_uint64, POINTER(c_double), c_uint64, POINTER(c_double), c_uint64)
_psh_compose_matrix = declare("nicol_psh_compose_matrix", c_int32, c_uint32, c_uint32, c_uint32, POINTER(c_double), c_uint64, POINTER(c_double), c_uint64, POINTER(c_double), c_uint64)
_psh_project_kernel = declare("nicol_psh_project_kernel", c_int32, PshKernelCallback.type, c_void_p, c_uint32, c_uint32, POINTER(c_double), c_uint64)
_psh_kernel_at = declare("nicol_psh_kernel_at", c_int32, c_uint32, POINTER(c_double), c_uint64, POINTER(c_double), c_uint64, POINTER(c_double), c_uint64)
_psh_convolve = declare("nicol_psh_convolve", c_int32, c_uint32, POINTER(c_double), c_uint64, c_uint64, POINTER(c_double), c_uint64, POINTER(c_double), c_uint64)
_psh_kernel_matrix = declare("nicol_psh_kernel_matrix", c_int32, c_uint32, POINTER(c_double), c_uint64, POINTER(c_double), c_uint64)
_psh_nearest_kernel = declare("nicol_psh_nearest_kernel", c_int32, c_uint32, POINTER(c_double), c_uint64, POINTER(c_double), c_uint64)
FileOptions._init = declare("nicol_file_options_init", c_int32, POINTER(FileOptions), c_uint32)
LightReport._init = declare("nicol_light_report_init", c_int32, POINTER(LightReport), c_uint32)
MaterialReport._init = declare("nicol_material_report_init", c_int32, POINTER(MaterialReport), c_uint32)
_file_identify = declare("nicol_file_identify", c_int32, c_char_p, POINTER(c_uint32))
_file_describe_light = declare("nicol_file_describe_light", c_int32, c_char_p, POINTER(FileOptions), POINTER(LightReport), POINTER(c_double), c_uint64)
_file_describe_material = declare("nicol_file_describe_material", c_int32, c_char_p, POINTER(FileOptions), POINTER(MaterialReport), POINTER(c_double), c_uint64)
_file_convert = declare("nicol_file_convert", c_int32, c_char_p, POINTER(FileOptions), c_char_p)
_environment_write = declare("nicol_environment_write", c_int32, Environment, POINTER(FileOptions), c_char_p)
_material_write = declare("nicol_material_write", c_int32, Material, POINTER(FileOptions), c_char_p)
_file_demosaic = declare("nicol_file_demosaic", c_int32, c_char_p, POINTER(Sensor), c_uint32, c_char_p)
_file_combine_angles = declare("nicol_file_combine_angles", c_int32, c_char_p, c_char_p, c_char_p, c_char_p, c_char_p)
_psh_write_file = declare("nicol_psh_write_file", c_int32, c_char_p, c_uint32, c_uint64, POINTER(c_double), c_uint64)

__all__ = [
    "ALL_CHANNELS",
    "AOV_ALL",
    "AOV_ALPHA",
    "AOV_DEPTH",
    "AOV_INSTANCE",
    "AOV_NORMAL",
    "AOV_POSITION",
    "AOV_VARIANCE",
    "BACKEND_AUTOMATIC",
    "BACKEND_EGL",
    "BACKEND_HOST",
    "BACKEND_OSMESA",
    "COMPONENTS_ALL",
    "COMPONENTS_LINEAR",
    "COMPONENTS_S0",
    "CallbackMaterial",
    "Conductor",
    "ContextInfo",
    "ContextOptions",
    "DEMOSAIC_BILINEAR",
    "DEMOSAIC_BLOCKS",
    "DEMOSAIC_GRADIENT",
    "DEPTH_MAPPING_ORTHOGRAPHIC",
    "DEPTH_MAPPING_ORTHOGRAPHIC_REVERSED",
    "DEPTH_MAPPING_PERSPECTIVE",
    "DEPTH_MAPPING_PERSPECTIVE_REVERSED",
    "DEPTH_UNLIMITED",
    "DIRECTIONS_AUTOMATIC",
    "DISTRIBUTION_BECKMANN",
    "DISTRIBUTION_GGX",
    "Deformation",
    "DeviceInfo",
    "Dielectric",
    "ENCODING_LINEAR",
    "ENCODING_SRGB",
    "ERROR_BUSY",
    "ERROR_CANCELLED",
    "ERROR_FILE_NOT_FOUND",
    "ERROR_INTERNAL",
    "ERROR_INVALID_ARGUMENT",
    "ERROR_INVALID_FILE",
    "ERROR_INVALID_HANDLE",
    "ERROR_NOT_CURRENT",
    "ERROR_NO_BACKEND",
    "ERROR_OPENGL",
    "ERROR_OUT_OF_MEMORY",
    "ERROR_TIMEOUT",
    "ERROR_UNSUPPORTED",
    "ERROR_WRITE_FAILED",
    "EXECUTOR_AUTOMATIC",
    "EXECUTOR_COMPUTE",
    "EXECUTOR_CPU",
    "Emission",
    "Environment",
    "EnvironmentInfo",
    "EnvironmentLoadOptions",
    "FILE_BAND_LIMITED",
    "FILE_LIGHT_CROSS",
    "FILE_LIGHT_IMAGE",
    "FILE_LIGHT_PSH",
    "FILE_MATERIAL_MEASURED",
    "FILE_MATERIAL_PSH",
    "FILE_MATERIAL_TABLE",
    "FILE_ORDER_AUTOMATIC",
    "FILE_PHYSICAL",
    "FILTER_BOX",
    "FILTER_CATMULLROM",
    "FILTER_GAUSSIAN",
    "FILTER_LANCZOS",
    "FILTER_MITCHELL",
    "FILTER_TENT",
    "FORMAT_AUTOMATIC",
    "FORMAT_FLOAT16",
    "FORMAT_FLOAT32",
    "FORMAT_UINT32",
    "FileContent",
    "FileOptions",
    "Film",
    "Filter",
    "GlTexture",
    "Gradient",
    "HIGH_ORDERS_CONVOLUTION",
    "HIGH_ORDERS_NONE",
    "HIGH_ORDERS_SPLIT",
    "HOST_SETS_STATE",
    "HOST_VALIDATE",
    "Host",
    "INSTANCE_CASTS_NO_SHADOWS",
    "INSTANCE_INVISIBLE",
    "INSTANCE_RECEIVES_NO_SHADOWS",
    "Image",
    "Instance",
    "JOB_DONE",
    "JOB_RUNNING",
    "JOB_WAITING",
    "Job",
    "JobStatus",
    "LIGHT_DIRECTIONAL",
    "LIGHT_POINT",
    "LIGHT_PROJECTOR",
    "LIGHT_SPOT",
    "LOG_INFO",
    "LOG_NOTICE",
    "LOG_WARNING",
    "Light",
    "LightReport",
    "MAX_CHANNELS",
    "MAX_JOBS",
    "MAX_ORDER",
    "MAX_SIZE",
    "MAX_SPLIT_LIGHTS",
    "MAX_VIEWS",
    "METHOD_DENSE",
    "METHOD_FACTORED",
    "METHOD_REFERENCE",
    "MOSAIC_PLAIN",
    "MOSAIC_POLARIZED",
    "MOSAIC_POLARIZED_BAYER",
    "Material",
    "MaterialReport",
    "Measured",
    "MemoryFile",
    "Mesh",
    "MeshData",
    "NO_INSTANCE",
    "NO_LIMIT",
    "OBSERVATION_AOLP",
    "OBSERVATION_DOLP",
    "OBSERVATION_POLARIZER",
    "OBSERVATION_S0",
    "OBSERVATION_S1",
    "OBSERVATION_S2",
    "OBSERVATION_S3",
    "OK",
    "OPTIMISATION_ALL",
    "OPTIMISATION_CHANNELS",
    "OPTIMISATION_DIM_LIGHTS",
    "OPTIMISATION_HIDDEN",
    "OPTIMISATION_LIGHT_COMPONENTS",
    "OPTIMISATION_ORDERS",
    "OPTIMISATION_RAYS",
    "OPTIMISATION_RESPONSE_ROWS",
    "OPTIMISATION_UNCHANGED",
    "OPTIMISATION_UNOCCLUDED",
    "ORDER_AUTOMATIC",
    "Observation",
    "PLANE_ALPHA",
    "PLANE_AOLP",
    "PLANE_DEPTH",
    "PLANE_DOLP",
    "PLANE_INSTANCE",
    "PLANE_NORMAL",
    "PLANE_POLARIZER",
    "PLANE_POSITION",
    "PLANE_S0",
    "PLANE_S1",
    "PLANE_S2",
    "PLANE_S3",
    "PLANE_STOKES",
    "PLANE_VARIANCE",
    "POLARIZATION_ELEMENT_DISK",
    "POLARIZATION_ELEMENT_LEFT_CIRCULAR",
    "POLARIZATION_ELEMENT_POLARIZER",
    "POLARIZATION_ELEMENT_RECTANGLE",
    "POLARIZATION_ELEMENT_RETARDER",
    "POLARIZATION_ELEMENT_RIGHT_CIRCULAR",
    "PROJECTION_ORTHOGRAPHIC",
    "PROJECTION_PERSPECTIVE",
    "PSH_BAND_SIZE",
    "PSH_GRID_CLENSHAW_CURTIS",
    "PSH_GRID_FEJER",
    "PSH_GRID_GAUSS_LEGENDRE",
    "PSH_MAX_MATRIX_ORDER",
    "PSH_MAX_ORDER",
    "PlaneBuffer",
    "Plastic",
    "Polarization",
    "PolarizationElement",
    "Pplastic",
    "Principled",
    "PshMatrix",
    "PshMuellerField",
    "PshSampling",
    "PshTransform",
    "QUALITY_FINAL",
    "QUALITY_PREVIEW",
    "QUALITY_REALTIME",
    "RawImage",
    "RenderOptions",
    "SENSOR_PRESET_IMX250MYR",
    "SENSOR_PRESET_IMX250MZR",
    "SHADE_AT_AUTOMATIC",
    "SHADE_AT_PIXELS",
    "SHADE_AT_VERTICES",
    "SPLIT_AUTOMATIC",
    "SceneFile",
    "Sky",
    "Spectrum",
    "Statistics",
    "StokesImage",
    "TEXEL_FLOAT32",
    "TEXEL_UINT16",
    "TEXEL_UINT8",
    "TEXTURE_FILTER_BILINEAR",
    "TEXTURE_FILTER_MIPMAP",
    "TEXTURE_FILTER_NEAREST",
    "TEXTURE_WRAP_CLAMP",
    "TEXTURE_WRAP_MIRROR",
    "TEXTURE_WRAP_REPEAT",
    "Texture",
    "TextureImage",
    "TextureOptions",
    "TextureTarget",
    "VERSION",
    "VERSION_MAJOR",
    "VERSION_MINOR",
    "VERSION_PATCH",
    "WAIT_FOREVER",
    "WAVELENGTH_LINEAR",
    "WAVELENGTH_NEAREST",
    "build_info",
    "device_count",
    "device_get_info",
    "file_combine_angles",
    "file_convert",
    "file_demosaic",
    "file_describe_light",
    "file_describe_material",
    "file_identify",
    "last_error",
    "psh_analyze",
    "psh_apply_matrix",
    "psh_compose_matrix",
    "psh_convolve",
    "psh_evaluate",
    "psh_kernel_at",
    "psh_kernel_matrix",
    "psh_multiply",
    "psh_nearest_kernel",
    "psh_project_environment",
    "psh_project_file",
    "psh_project_image",
    "psh_project_kernel",
    "psh_project_matrix",
    "psh_reflect",
    "psh_rotate",
    "psh_shadow_matrix",
    "psh_synthesize",
    "psh_write_file",
    "render_adjoint",
    "render_async",
    "render_views",
    "result_name",
    "version",
    "version_string",
]
