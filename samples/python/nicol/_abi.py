# SPDX-License-Identifier: MIT
"""Nicol 0.1.0 for Python. Made of the C headers by samples/bindings/generate.py: change those, not this file."""

from ctypes import POINTER, byref, c_char_p, c_double, c_float, c_int32, c_uint32, c_uint64, c_void_p

from ._runtime import (
    Buffer, Callback, Handle, Struct, array, as_is, check, counted, declare, decoded, lend, pointee, text, texts,
)  # fmt: skip

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
OPTIMISATION_ALL = 255
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


class DeviceInfo(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("software", c_uint32),
        ("name", c_char_p),
        ("vendor", c_char_p),
        ("file", c_char_p),
    ]


class ContextOptions(Struct):
    _callbacks_ = {"log": LogCallback, "load_progress": ProgressCallback, "error": ErrorCallback, "start_tasks": StartTasks, "finish_tasks": FinishTasks}
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
    ]


class ContextInfo(Struct):
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


class Image(Struct):
    """Equirectangular image over the directions that light comes FROM, in Mitsuba 3's layout: column u = atan2(x,
    -z) / 2 pi (pixel-centred), row v = acos(y) / pi (row 0 is the pole itself, the last row the other
    pole)."""
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


class Sky(Struct):
    """Clear sky without the sun's own disc. At the angle g from the sun, the degree of linear polarization is
    dop_max sin^2 g / (1 + cos^2 g), the electric field is along sun x view, and s3 is 0.

    Turbidity 0: light is scattered once, with radiance * 3/4 (1 + cos^2 g) over the whole sphere, below the
    horizon too.

    Turbidity 1.7 (very clear) to 10 (hazy): brightness and, in three channels, colour follow Perez's formula,
    scaled so that the mean luminance over the upper half is 1, times radiance. Below the horizon is an
    unpolarized, uniform ground that reflects ground_albedo of each channel's irradiance. The sun must not be
    below the horizon."""
    _fields_ = [
        ("struct_size", c_uint32),
        ("dop_max", c_float),
        ("sun_direction", c_float * 3),
        ("radiance", Spectrum),
        ("turbidity", c_float),
        ("ground_albedo", c_float),
    ]


class EnvironmentLoadOptions(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("scale", c_double),
        ("wavelengths", Spectrum),
    ]


class EnvironmentInfo(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("channels", c_uint32),
        ("polarized", c_uint32),
        ("circular", c_uint32),
        ("wavelength_count", c_uint32),
        ("reserved", c_uint32),
        ("wavelengths", c_double * 16),
    ]


class TextureImage(Struct):
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


class TextureOptions(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("filter", c_uint32),
        ("wrap", c_uint32),
        ("raw", c_uint32),
        ("to_uv", c_double * 9),
    ]


class Pplastic(Struct):
    """Plastic as Mitsuba 3's pplastic: rough Fresnel reflection over a diffuse base, both polarizing. Only the
    front side reflects."""
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
    ]


class Plastic(Struct):
    """Plastic as Mitsuba 3's plastic and roughplastic: Fresnel reflection over a diffuse base, both depolarizing.
    nicol_pplastic is the model that polarizes. Only the front side reflects."""
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


class Principled(Struct):
    """Disney's material as Mitsuba 3's principled. What it reflects is unpolarized. Light that passes the surface
    (spec_trans above 0) is followed as that of a rough nicol_dielectric. Only the front side reflects. Numbers
    are 0 to 1, default 0, unless stated otherwise."""
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


class Conductor(Struct):
    """Metal as Mitsuba 3's conductor and roughconductor: single reflection off the facets of an opaque metal. The
    complex index is eta - i k, relative to air. With k = 0 and the index of a dielectric as eta, the material
    reflects like the surface of the dielectric, such as glass whose inside is not seen. Only the front side
    reflects."""
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
    ]


class Dielectric(Struct):
    """Glass as Mitsuba 3's dielectric, roughdielectric and thindielectric: a boundary that reflects and transmits
    light, polarized as Fresnel's formulas say. The factored method follows light through it by rays at pixels,
    the reference method by its paths; max_depth of nicol_render_options limits how often. By the factored
    method the light of lamps passes glass straight on to other surfaces, dimmed in each channel as unpolarized
    light is; the light of the environment is not dimmed, and nothing is focused. The dense method and shading
    at vertices return NICOL_ERROR_UNSUPPORTED. The surface of a body must be closed, its normals pointing
    outwards, and bodies must not overlap."""
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
    ]


class Measured(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("sampling", c_uint32),
        ("wavelengths", Spectrum),
        ("symmetrize", c_uint32),
    ]


class PshMatrix(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("symmetrize", c_uint32),
        ("scale", Spectrum),
    ]


class CallbackMaterial(Struct):
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


class MeshData(Struct):
    """Triangles in memory. All numbers must be finite and all indices valid. Triangles without area are left out,
    and logged once."""
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


class Deformation(Struct):
    """Other places of a mesh's vertices, such as those of the next frame of an animated character."""
    _fields_ = [
        ("struct_size", c_uint32),
        ("vertex_count", c_uint32),
        ("positions", POINTER(c_float)),
        ("normals", POINTER(c_float)),
    ]


class Camera(Struct):
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

    def look_at(self, origin, target, up):
        """Sets to_world, and no other field, to that of a camera at `origin` that looks at `target`. `up` must not
        lie along the view."""
        check(_camera_look_at(byref(self), array(origin, c_double, 3), array(target, c_double, 3), array(up, c_double, 3)))
        return self

    def set_opencv(self, K, R, t, width, height):
        """Sets to_world, fov, shift, pixel_aspect and projection, and no other field, to those of a pinhole camera in
        OpenCV's convention: a point X of the world is at x = R X + t, with x[0] to the right, x[1] down and x[2]
        forward, and there at the pixel (fx x[0] / x[2] + cx, fy x[1] / x[2] + cy), where (0, 0) is the MIDDLE of
        the first pixel and K = [fx 0 cx; 0 fy cy; 0 0 1]. Matrices are row-major. Undistort images first: there is
        no lens distortion. (COLMAP has the same R and t, and 0.5 more in cx and cy.)"""
        check(_camera_set_opencv(byref(self), array(K, c_double, 9), array(R, c_double, 9), array(t, c_double, 3), width, height))
        return self

    def get_opencv(self, width, height):
        """Gets the pinhole camera of a perspective camera, for an image of this size; jitter is left out."""
        K = (c_double * 9)()
        R = (c_double * 9)()
        t = (c_double * 3)()
        check(_camera_get_opencv(byref(self), width, height, K, R, t))
        return tuple(K), tuple(R), tuple(t)

    def frame(self, lower, upper, width, height):
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
    quarter-wave plate behind this polarizer gives docp 1 or -1."""
    _fields_ = [
        ("dolp", c_double),
        ("aolp", c_double),
        ("docp", c_double),
        ("axis", c_double * 3),
    ]


class Light(Struct):
    """Local light without a surface, beside the environment. In its own axes the light emits along +z, from the
    origin unless it is directional. +y is up, and +x is to the left of a viewer who looks along +z, as for
    cameras. Fields of other kinds have no effect."""
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


class Emission(Struct):
    """Emission of an instance, in addition to its reflection."""
    _fields_ = [
        ("struct_size", c_uint32),
        ("two_sided", c_uint32),
        ("radiance", Spectrum),
        ("reserved", c_uint32),
        ("texture", c_void_p),
        ("polarization", Polarization),
    ]


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
    with the tilt."""
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_uint32),
        ("outline", c_uint32),
        ("reserved", c_uint32),
        ("to_world", c_double * 16),
        ("angle", c_double),
        ("retardance", c_double),
        ("transmittance", c_double),
    ]


class Instance(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("mesh", c_void_p),
        ("material", c_void_p),
        ("to_world", c_double * 16),
    ]


class SceneFile(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_uint32),
        ("path", c_char_p),
        ("digest", c_char_p),
        ("bytes", c_uint64),
    ]


class Filter(Struct):
    """Reconstruction filter of an image. A pixel is the weighted mean of the samples of all pixels within the
    filter's radius; no samples lie beyond the border of the image. The filter applies to each Stokes component
    and not to AOVs, except that the reference method's alpha and variance are those of the weighted samples."""
    _fields_ = [
        ("kind", c_uint32),
        ("reserved", c_uint32),
        ("size", c_double),
        ("b", c_double),
        ("c", c_double),
    ]


class RenderOptions(Struct):
    """Options of a render. The reference method uses only samples, seed, max_depth, shadows, aovs, filter,
    progress and NICOL_OPTIMISATION_UNCHANGED; the other options are those of the factored and the dense
    method."""
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

    def set_quality(self, quality):
        """Sets the options of the real-time methods that trade time for accuracy: tolerance, pixel_samples,
        bake_directions, refine_tolerance, light_samples and bsdf_samples. All other options stay. Options that are
        set afterwards win. Returns NICOL_ERROR_INVALID_ARGUMENT for another quality."""
        check(_render_options_set_quality(byref(self), quality))
        return self


class JobStatus(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("state", c_uint32),
        ("result", c_int32),
        ("reserved", c_uint32),
        ("fraction", c_double),
        ("verb", c_char_p),
    ]


class Statistics(Struct):
    """Statistics of the last render into a framebuffer. Milliseconds are 0 for verbs that did not run."""
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
    ]


class PlaneBuffer(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("plane", c_uint32),
        ("format", c_uint32),
        ("channel", c_uint32),
        ("pixels", c_void_p),
        ("row_stride", c_uint64),
        ("byte_size", c_uint64),
    ]


class Observation(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_uint32),
        ("exposure", c_float),
        ("scale", c_float),
        ("polarizer_angle", c_float),
    ]


class Sensor(Struct):
    """Linear image sensor, by the figures of the standard EMVA 1288. A pixel collects
        n = Poisson(quantum_efficiency * exposure * I + dark_current * exposure_time)
    electrons, at most full_well, where I is s0 behind the optics and the pixel's polarizer, and gives the number
        floor(gain * (n + read noise + offset) + black_level + 1/2), cut to 0 .. 2^bits - 1.
    Noise belongs to the seed, the frame and the pixel. The polarizers' angles and transmittances, the offsets and the
    sensitivities belong to the seed and the pixel. All of them have the same bits on every machine and for any number
    of threads, so that the same Stokes image gives the same bytes."""
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
        ("quantum_efficiency", Spectrum),
        ("reserved", c_uint32),
    ]

    def set_preset(self, preset):
        """Sets the fields of a preset."""
        check(_sensor_set_preset(byref(self), preset))
        return self

    def load(self, path):
        """Sets the fields that a JSON file names, or those of a mosaic that nicol_sensor_write_png wrote. The file is
        an object with the names of the fields, and "preset" ("imx250mzr", "imx250myr") and "elements", a list of
        objects with "kind" ("polarizer", "retarder", "right_circular", "left_circular"), "angle", "retardance",
        "transmittance" and "extinction_ratio", in the order of the light."""
        check(_sensor_load(byref(self), text(path)))
        return self

    def add_element(self, element, extinction_ratio):
        """Multiplies the sensor's optics by the matrix of an element that faces the camera, between the optics and
        the sensor; angles are counter-clockwise from image right. The element's to_world must be the identity, and
        its outline has no effect. extinction_ratio: transmittance along over across a polarizer's axis, at least
        1; 0: an ideal polarizer."""
        check(_sensor_add_element(byref(self), byref(element) if element is not None else None, extinction_ratio))
        return self

    def expose(self, light, frame, to):
        """Exposes the sensor to light, and writes the numbers to `to`, which has the light's size. Frames with other
        numbers have other noise. Light that is not finite is refused."""
        check(_sensor_expose(byref(self), byref(light) if light is not None else None, frame, byref(to) if to is not None else None))
        return self

    def write_png(self, raw, path):
        """Writes numbers as a grey PNG: 8 bits, or 16 bits if the sensor has more than 8. The file names the mosaic,
        the bits and the sensor in the text chunks Nicol:Mosaic, Nicol:Bits and Nicol:Sensor."""
        check(_sensor_write_png(byref(self), byref(raw) if raw is not None else None, text(path)))
        return self

    def demosaic(self, raw, method, to):
        """Computes the light on the sensor, behind its optics, from numbers of its pixels, by the sensor's exposure,
        quantum efficiency, gain, levels and extinction ratio. The pixels' own errors and crosstalk are not undone.
        `to` has 3 channels with colour filters, else 1, and s3 = 0; NICOL_MOSAIC_PLAIN gives s0 alone."""
        check(_sensor_demosaic(byref(self), byref(raw) if raw is not None else None, method, byref(to) if to is not None else None))
        return self


class StokesImage(Struct):
    """Stokes image in the caller's memory, in the frame of rendered images: x right, y up."""
    _fields_ = [
        ("struct_size", c_uint32),
        ("width", c_uint32),
        ("height", c_uint32),
        ("channels", c_uint32),
        ("pixels", c_void_p),
        ("row_stride", c_uint64),
        ("byte_size", c_uint64),
    ]


class RawImage(Struct):
    """Numbers of a sensor's pixels in the caller's memory."""
    _fields_ = [
        ("struct_size", c_uint32),
        ("width", c_uint32),
        ("height", c_uint32),
        ("reserved", c_uint32),
        ("pixels", c_void_p),
        ("row_stride", c_uint64),
        ("byte_size", c_uint64),
    ]


class Host(Struct):
    _callbacks_ = {"get_proc_address": GetProcAddressCallback, "is_current": IsCurrentCallback}
    _fields_ = [
        ("struct_size", c_uint32),
        ("flags", c_uint32),
        ("get_proc_address", GetProcAddressCallback.type),
        ("is_current", IsCurrentCallback.type),
        ("user", c_void_p),
    ]


class GlTexture(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("name", c_uint32),
        ("target", c_uint32),
        ("internal_format", c_uint32),
        ("width", c_uint32),
        ("height", c_uint32),
    ]


class TextureTarget(Struct):
    """Texture of the host's to draw into: level 0 of a GL_TEXTURE_2D of GL_RGBA8, GL_SRGB8_ALPHA8, GL_RGBA16F or
    GL_RGBA32F, as large as the framebuffer."""
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


class PshSampling(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("grid", c_uint32),
        ("order", c_uint32),
        ("rows", c_uint32),
        ("columns", c_uint32),
        ("reserved", c_uint32),
        ("phi0", c_double),
    ]


class PshMuellerField(Struct):
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


class FileOptions(Struct):
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


class LightReport(Struct):
    """Report of a light, by channel. Means and fractions are taken over the sphere, weighted by solid angle, for
    the image that would be written."""
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


class MaterialReport(Struct):
    """Report of a material, by channel, as far as coefficients up to `order` describe the material."""
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


class Context(Handle):
    """OpenGL context on its own thread, or a host's"""

    @classmethod
    def create(cls, options=None):
        """Creates a context. options may be NULL: all defaults. Returns NICOL_ERROR_NO_BACKEND if no such OpenGL
        context can be created."""
        options = lend(options)
        context = cls()
        check(_context_create(byref(options) if options is not None else None, byref(context)))
        return context

    def get_info(self):
        """Gets the properties of the OpenGL context, and the limits in effect."""
        info = ContextInfo()
        check(_context_get_info(self, byref(info)))
        return info

    @classmethod
    def create_host(cls, host, options=None):
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
    def load(cls, context, path, options=None):
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
    def create_image(cls, context, image):
        """Creates an environment from an image in memory."""
        image = lend(image)
        environment = cls()
        check(_environment_create_image(context, byref(image) if image is not None else None, byref(environment)))
        return environment

    @classmethod
    def create_constant(cls, context, radiance):
        """Creates an environment of unpolarized light that is equal from all directions. radiance is finite and not
        negative; NULL or not given: 1 in one channel."""
        radiance = radiance if radiance is None or isinstance(radiance, Spectrum) else Spectrum.of(radiance)
        environment = cls()
        check(_environment_create_constant(context, byref(radiance) if radiance is not None else None, byref(environment)))
        return environment

    @classmethod
    def create_sky(cls, context, sky):
        """Creates a clear sky without the sun's own disc."""
        environment = cls()
        check(_environment_create_sky(context, byref(sky) if sky is not None else None, byref(environment)))
        return environment

    @classmethod
    def create_psh(cls, context, order, channels, coefficients):
        """Creates an environment from PSH coefficients over PROPAGATION directions in the world's axes,
        [channel][l*l + l + m][4] as nicol_psh.h defines. order is up to NICOL_PSH_MAX_ORDER (4096), channels 1 to
        NICOL_MAX_CHANNELS, and count = channels * 4 (order+1)^2. Coefficients p = 1, 2 below l = 2 must be 0. The
        light is band-limited and may ring: s0 may be below 0, and the polarization above s0."""
        coefficients = Buffer(coefficients, c_double)
        environment = cls()
        check(_environment_create_psh(context, order, channels, coefficients.pointer, coefficients.count, byref(environment)))
        return environment

    def get_info(self):
        """Gets the properties of the light."""
        info = EnvironmentInfo()
        check(_environment_get_info(self, byref(info)))
        return info

    def write(self, options, path):
        """Writes an environment to a file in the kind that the path says, as nicol_file_convert does. options may be
        NULL, and must have no wavelengths."""
        check(_environment_write(self, byref(options) if options is not None else None, text(path)))


class Texture(Handle):
    """values that vary over a surface; immutable"""

    @classmethod
    def create_image(cls, context, image, options=None):
        """Creates a texture from an image in memory and copies the pixels. options may be NULL: all defaults."""
        texture = cls()
        check(_texture_create_image(context, byref(image) if image is not None else None, byref(options) if options is not None else None, byref(texture)))
        return texture

    @classmethod
    def load(cls, context, path, options=None):
        """Loads a texture from a file of PNG, JPEG, BMP, TGA, Radiance HDR, or OpenEXR with R G B or Y; A is the
        coverage. options may be NULL: all defaults."""
        texture = cls()
        check(_texture_load(context, text(path), byref(options) if options is not None else None, byref(texture)))
        return texture

    @classmethod
    def create_checkerboard(cls, context, color0, color1, to_uv):
        """Creates Mitsuba 3's checkerboard of colours: four squares per unit square of u and v, color0 at u = v = 0.
        Colours have 1 or 3 values; NULL or not given: 0.4 and 0.2. to_uv is that of nicol_texture_options; NULL:
        identity."""
        color0 = color0 if color0 is None or isinstance(color0, Spectrum) else Spectrum.of(color0)
        color1 = color1 if color1 is None or isinstance(color1, Spectrum) else Spectrum.of(color1)
        texture = cls()
        check(_texture_create_checkerboard(context, byref(color0) if color0 is not None else None, byref(color1) if color1 is not None else None, array(to_uv, c_double, 9), byref(texture)))
        return texture

    @classmethod
    def create_vertex_colors(cls, context):
        """Creates a texture of the colours of the mesh's vertices, interpolated."""
        texture = cls()
        check(_texture_create_vertex_colors(context, byref(texture)))
        return texture

    @classmethod
    def create_face_colors(cls, context):
        """Creates a texture of the colours of the mesh's triangles. A material may use colours of triangles or of
        vertices, not both."""
        texture = cls()
        check(_texture_create_face_colors(context, byref(texture)))
        return texture


class Material(Handle):
    """polarimetric BRDF (pBRDF); immutable"""

    @classmethod
    def create_pplastic(cls, context, parameters):
        """Creates a material from nicol_pplastic. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that is
        out of range."""
        material = cls()
        check(_material_create_pplastic(context, byref(parameters) if parameters is not None else None, byref(material)))
        return material

    @classmethod
    def create_plastic(cls, context, parameters):
        """Creates a material from nicol_plastic. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that is
        out of range."""
        material = cls()
        check(_material_create_plastic(context, byref(parameters) if parameters is not None else None, byref(material)))
        return material

    @classmethod
    def create_principled(cls, context, parameters):
        """Creates a material from nicol_principled. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that
        is out of range. Returns NICOL_ERROR_UNSUPPORTED for a tint of a mesh's colours."""
        material = cls()
        check(_material_create_principled(context, byref(parameters) if parameters is not None else None, byref(material)))
        return material

    @classmethod
    def create_diffuse(cls, context, reflectance):
        """Creates a Lambertian, depolarizing material. reflectance is 0 to 1; NULL or not given: 0.5. Only the front
        side reflects."""
        reflectance = reflectance if reflectance is None or isinstance(reflectance, Spectrum) else Spectrum.of(reflectance)
        material = cls()
        check(_material_create_diffuse(context, byref(reflectance) if reflectance is not None else None, byref(material)))
        return material

    @classmethod
    def create_conductor(cls, context, parameters):
        """Creates a material from nicol_conductor. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that
        is out of range or, for an unknown metal, the known metals."""
        material = cls()
        check(_material_create_conductor(context, byref(parameters) if parameters is not None else None, byref(material)))
        return material

    @classmethod
    def create_dielectric(cls, context, parameters):
        """Creates a material from nicol_dielectric. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that
        is out of range."""
        material = cls()
        check(_material_create_dielectric(context, byref(parameters) if parameters is not None else None, byref(material)))
        return material

    @classmethod
    def load_measured(cls, context, path, options=None):
        """Loads a material as Mitsuba 3's measured_polarized from a .pbsdf file, such as the KAIST data set has. The
        file is streamed: about 102 MB per channel stay in memory at the data set's resolution, or half as much if
        symmetrized. options may be NULL: all defaults. Only the front side reflects."""
        material = cls()
        check(_material_load_measured(context, text(path), byref(options) if options is not None else None, byref(material)))
        return material

    @classmethod
    def load_psh(cls, context, path, options=None):
        """Loads an isotropic material from one PSH coefficient matrix per channel, cosine included: the .npz files of
        the Python package polarsh (SHMat in the layout ISOBI2). The material does not reflect light of orders
        above the matrix's. options may be NULL: all defaults. Only the front side reflects."""
        material = cls()
        check(_material_load_psh(context, text(path), byref(options) if options is not None else None, byref(material)))
        return material

    @classmethod
    def create_twosided(cls, context, front):
        """Creates a material whose back side reflects as its front side. `front` may be released afterwards."""
        material = cls()
        check(_material_create_twosided(context, front, byref(material)))
        return material

    @classmethod
    def create_scaled(cls, context, base, scale):
        """Creates the product of a material and a texture: a diffuse material of reflectance 1 gets the texture's
        colours. The given handles may be released afterwards."""
        material = cls()
        check(_material_create_scaled(context, base, scale, byref(material)))
        return material

    @classmethod
    def create_blend(cls, context, first, second, weight):
        """Creates the mixture first (1 - t) + second t, with t = the weight's first channel, clamped to 0 to 1
        (Mitsuba 3's blendbsdf). If one material is two-sided, the mixture is too, and the other material is black
        on the back. The given handles may be released afterwards."""
        material = cls()
        check(_material_create_blend(context, first, second, weight, byref(material)))
        return material

    @classmethod
    def create_normal_map(cls, context, base, normals, mirrored_y):
        """Creates a material with perturbed normals from a raw texture with values t: shading normals 2 t - 1 in the
        frame of the surface, with x along growing u (Mitsuba 3's normalmap). mirrored_y 0: y completes a
        right-handed frame; 1: y points to where v falls, as in glTF. The two values differ where texture
        coordinates are mirrored. The given handles may be released afterwards."""
        material = cls()
        check(_material_create_normal_map(context, base, normals, mirrored_y, byref(material)))
        return material

    @classmethod
    def create_bump_map(cls, context, base, heights, scale):
        """Creates a material with perturbed normals from heights: shading normals of a surface that is displaced
        along its normal by scale times the texture's first channel, in the scene's units (Mitsuba 3's bumpmap).
        The given handles may be released afterwards."""
        material = cls()
        check(_material_create_bump_map(context, base, heights, scale, byref(material)))
        return material

    @classmethod
    def create_rotated(cls, context, base, directions, angle):
        """Creates a material whose anisotropic parts are rotated within the surface, as by glTF's
        KHR_materials_anisotropy. directions is a raw texture with values t, or NULL: the first two of 2 t - 1 are
        the direction in which u would grow, in the frame of x along growing u and y to where v falls. angle, in
        radians from x towards y, is added. The given handles may be released afterwards."""
        material = cls()
        check(_material_create_rotated(context, base, directions, angle, byref(material)))
        return material

    @classmethod
    def create_mask(cls, context, base, opacity):
        """Creates a material with an alpha mask: the surface is cut out where the opacity is below 0.5 (Mitsuba 3's
        mask of opacities 0 and 1). The opacity is the texture's coverage or, with fewer than four channels, the
        first channel. The given handles may be released afterwards."""
        material = cls()
        check(_material_create_mask(context, base, opacity, byref(material)))
        return material

    @classmethod
    def create_callback(cls, context, parameters):
        """Creates a material from a function, which must be isotropic, mirror symmetric about every plane through the
        normal, and finite. Returns NICOL_ERROR_INVALID_ARGUMENT if a test at some directions shows that the
        function is not. Only the front side reflects."""
        parameters = lend(parameters)
        material = cls()
        check(_material_create_callback(context, byref(parameters) if parameters is not None else None, byref(material)))
        return material

    def write(self, options, path):
        """Writes a material to a file in the kind that the path says, as nicol_file_convert does. options may be
        NULL, and must have no wavelengths."""
        check(_material_write(self, byref(options) if options is not None else None, text(path)))


class Mesh(Handle):
    """triangles; immutable"""

    @classmethod
    def load(cls, context, path):
        """Loads a mesh from OBJ, PLY, OFF, STL or the first mesh of Mitsuba's .serialized, by the file's suffix.
        Polygons may be concave. Triangles without area, vertices without a face, and elements that the reader
        ignores (materials) are left out; one line of the log counts them. Texture coordinates and colours of
        vertices and faces are kept. v of OBJ, which points up, becomes 1 - v. The message of
        NICOL_ERROR_INVALID_FILE names the line, vertex or face."""
        mesh = cls()
        check(_mesh_load(context, text(path), byref(mesh)))
        return mesh

    @classmethod
    def create(cls, context, data):
        """Creates a mesh from arrays and copies the arrays. A render adds vertices where shadows need them, see
        refine_tolerance of nicol_render_options."""
        mesh = cls()
        check(_mesh_create(context, byref(data) if data is not None else None, byref(mesh)))
        return mesh

    @classmethod
    def create_sphere(cls, context):
        """Creates the unit sphere, divided finely enough for per-vertex shading, with the texture coordinates of
        Mitsuba 3's sphere."""
        mesh = cls()
        check(_mesh_create_sphere(context, byref(mesh)))
        return mesh

    @classmethod
    def create_rectangle(cls, context):
        """Creates the rectangle [-1, 1]^2 in the plane z = 0, facing +z, with the texture coordinates of Mitsuba 3's
        rectangle."""
        mesh = cls()
        check(_mesh_create_rectangle(context, byref(mesh)))
        return mesh

    @classmethod
    def create_cube(cls, context):
        """Creates the cube [-1, 1]^3, with the texture coordinates of Mitsuba 3's cube."""
        mesh = cls()
        check(_mesh_create_cube(context, byref(mesh)))
        return mesh

    @classmethod
    def create_disk(cls, context):
        """Creates the disk of radius 1 in the plane z = 0, facing +z: 180 sectors of 16 rings, with the texture
        coordinates of Mitsuba 3's disk."""
        mesh = cls()
        check(_mesh_create_disk(context, byref(mesh)))
        return mesh

    @classmethod
    def create_cylinder(cls, context, p0, p1, radius):
        """Creates the cylinder of this radius around the line from p0 to p1, in the scene's units, without its ends:
        180 sides, with the texture coordinates of Mitsuba 3's cylinder. The front is outside. radius must be above
        0, and p0 and p1 must differ."""
        mesh = cls()
        check(_mesh_create_cylinder(context, array(p0, c_double, 3), array(p1, c_double, 3), radius, byref(mesh)))
        return mesh

    @classmethod
    def create_deformed(cls, context, base, deformation):
        """Creates a mesh with the triangles, texture coordinates and colours of `base`, without its tangents, and
        with other positions and normals, for nicol_scene_set_mesh. Triangles may lose their area, and stay. `base`
        may be released afterwards."""
        mesh = cls()
        check(_mesh_create_deformed(context, base, byref(deformation) if deformation is not None else None, byref(mesh)))
        return mesh

    def get_size(self):
        """Gets the numbers of vertices and triangles of a mesh."""
        vertices = c_uint32()
        triangles = c_uint32()
        check(_mesh_get_size(self, byref(vertices), byref(triangles)))
        return vertices.value, triangles.value

    def get_bounds(self):
        """Gets the box of the mesh in its own axes: the least and the largest coordinates."""
        lower = (c_double * 3)()
        upper = (c_double * 3)()
        check(_mesh_get_bounds(self, lower, upper))
        return tuple(lower), tuple(upper)


class Scene(Handle):
    """instances, light and polarization elements"""

    @classmethod
    def create(cls, context):
        """Creates an empty, dark scene."""
        scene = cls()
        check(_scene_create(context, byref(scene)))
        return scene

    @classmethod
    def load(cls, context, path, definitions=()):
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

    def add_instance(self, instance):
        """Adds an instance. id may be NULL; ids count up from 0, past those of removed instances too. The mesh must
        have the texture coordinates and colours that the material needs. Materials and environment of a scene must
        have one colour channel or the same number of channels."""
        id = c_uint32()
        check(_scene_add_instance(self, byref(instance) if instance is not None else None, byref(id)))
        return id.value

    def set_transform(self, id, to_world):
        """Sets the transform of an instance; to_world is that of nicol_instance. The next render bakes again the
        vertices that the instance may shadow, before or now. A scene that rotates and moves as a whole is only
        relit."""
        check(_scene_set_transform(self, id, array(to_world, c_double, 16)))

    def set_mesh(self, id, mesh):
        """Sets the mesh of an instance, under the conditions of nicol_scene_add_instance. The next render bakes again
        the instance and the vertices that it may shadow, before or now. An instance whose meshes have the same
        triangles, such as those of nicol_mesh_create_deformed, keeps its former shadows until they are baked, see
        bake_budget_ms of nicol_render_options."""
        check(_scene_set_mesh(self, id, mesh))

    def set_material(self, id, material):
        """Sets the material of an instance, under the conditions of nicol_scene_add_instance. The next render
        projects the material, if it is new to the scene, and shades the instance."""
        check(_scene_set_material(self, id, material))

    def remove_instance(self, id):
        """Removes an instance. The id is not used again; other instances keep their ids."""
        check(_scene_remove_instance(self, id))

    def get_instance(self, id):
        """Gets the parts of an instance: mesh and material as handles to release, and the transform. Each of the
        three may be NULL."""
        mesh = Mesh()
        material = Material()
        to_world = (c_double * 16)()
        check(_scene_get_instance(self, id, byref(mesh), byref(material), to_world))
        return mesh if mesh.value else None, material if material.value else None, tuple(to_world)

    def get_bounds(self):
        """Gets the box of all instances in the world, without local lights, which have no surface. Returns
        NICOL_ERROR_INVALID_ARGUMENT for a scene without instances."""
        lower = (c_double * 3)()
        upper = (c_double * 3)()
        check(_scene_get_bounds(self, lower, upper))
        return tuple(lower), tuple(upper)

    def get_instance_count(self):
        """Gets the number of instances."""
        instances = c_uint32()
        check(_scene_get_instance_count(self, byref(instances)))
        return instances.value

    def get_instance_ids(self, ids):
        """Gets the ids of all instances, ascending. count must be the number of instances."""
        ids = Buffer(ids, c_uint32, writable=True)
        check(_scene_get_instance_ids(self, ids.pointer, ids.count))

    def set_environment(self, environment, to_world, scale):
        """Sets the environment; NULL: darkness. to_world is a proper rotation of the environment; NULL: identity.
        scale is a factor on the radiance, finite and not negative; 1: no change; 0: darkness."""
        check(_scene_set_environment(self, environment, array(to_world, c_double, 16), scale))

    def get_environment(self):
        """Gets the arguments of nicol_scene_set_environment: the environment, as a handle to release, its rotation
        and scale. to_world and scale may be NULL. In darkness, including a file's scale of 0, *environment is
        NULL, to_world the identity and scale 1."""
        environment = Environment()
        to_world = (c_double * 16)()
        scale = c_double()
        check(_scene_get_environment(self, byref(environment), to_world, byref(scale)))
        return environment if environment.value else None, tuple(to_world), scale.value

    def hide_emitters(self, hide):
        """Sets whether emitters are hidden from the camera. hide 1: no light goes straight to the camera from the
        environment, which leaves black (alpha 0), or from instances that emit, which show only their reflection;
        both light the scene as before. hide 0: the camera sees emitters, unless the scene's file has
        hide_emitters."""
        check(_scene_hide_emitters(self, hide))

    def add_light(self, light):
        """Adds a light. id may be NULL; ids of lights count up from 0, independently of instances. Lights, and the
        emission of instances, must have one colour channel or as many as the scene. The handle of the texture may
        be released afterwards. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that is out of
        range."""
        id = c_uint32()
        check(_scene_add_light(self, byref(light) if light is not None else None, byref(id)))
        return id.value

    def set_light(self, id, light):
        """Replaces all fields of a light. The next render bakes nothing. The message of NICOL_ERROR_INVALID_ARGUMENT
        names the field that is out of range."""
        check(_scene_set_light(self, id, byref(light) if light is not None else None))

    def remove_light(self, id):
        """Removes a light. The id is not used again; other lights keep their ids."""
        check(_scene_remove_light(self, id))

    def get_light(self, id):
        """Gets a light as it was given. *texture, and not light->texture, is the light's texture as a handle to
        release, or NULL if the light has none. texture may be NULL."""
        light = Light()
        texture = Texture()
        check(_scene_get_light(self, id, byref(light), byref(texture)))
        return light, texture if texture.value else None

    def get_light_count(self):
        """Gets the number of lights."""
        lights = c_uint32()
        check(_scene_get_light_count(self, byref(lights)))
        return lights.value

    def get_light_ids(self, ids):
        """Gets the ids of all lights, ascending. count must be the number of lights."""
        ids = Buffer(ids, c_uint32, writable=True)
        check(_scene_get_light_ids(self, ids.pointer, ids.count))

    def set_emission(self, id, emission):
        """Sets the emission of the instance `id`; NULL: the instance emits no light. A texture needs texture
        coordinates of the mesh. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that is out of
        range."""
        check(_scene_set_emission(self, id, byref(emission) if emission is not None else None))

    def get_emission(self, id):
        """Gets the emission of an instance, with its texture as nicol_scene_get_light does. The radiance is 0 for an
        instance that emits no light."""
        emission = Emission()
        texture = Texture()
        check(_scene_get_emission(self, id, byref(emission), byref(texture)))
        return emission, texture if texture.value else None

    def add_polarization_element(self, element):
        """Adds a polarization element. id may be NULL; ids of elements count up from 0, independently of instances
        and lights. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that is out of range."""
        id = c_uint32()
        check(_scene_add_polarization_element(self, byref(element) if element is not None else None, byref(id)))
        return id.value

    def set_polarization_element(self, id, element):
        """Replaces all fields of a polarization element. The message of NICOL_ERROR_INVALID_ARGUMENT names the field
        that is out of range."""
        check(_scene_set_polarization_element(self, id, byref(element) if element is not None else None))

    def remove_polarization_element(self, id):
        """Removes a polarization element. The id is not used again; other elements keep their ids."""
        check(_scene_remove_polarization_element(self, id))

    def get_polarization_element(self, id):
        """Gets a polarization element as it was given."""
        element = PolarizationElement()
        check(_scene_get_polarization_element(self, id, byref(element)))
        return element

    def get_polarization_element_count(self):
        """Gets the number of polarization elements."""
        elements = c_uint32()
        check(_scene_get_polarization_element_count(self, byref(elements)))
        return elements.value

    def get_polarization_element_ids(self, ids):
        """Gets the ids of all polarization elements, ascending. count must be the number of elements."""
        ids = Buffer(ids, c_uint32, writable=True)
        check(_scene_get_polarization_element_ids(self, ids.pointer, ids.count))

    def get_camera(self):
        """Gets the camera of a loaded file. Returns NICOL_ERROR_UNSUPPORTED for a scene that was not loaded."""
        camera = Camera()
        check(_scene_get_camera(self, byref(camera)))
        return camera

    def get_film_size(self):
        """Gets the film size of a loaded file, in pixels. Returns NICOL_ERROR_UNSUPPORTED for a scene that was not
        loaded."""
        width = c_uint32()
        height = c_uint32()
        check(_scene_get_film_size(self, byref(width), byref(height)))
        return width.value, height.value

    def get_sample_count(self):
        """Gets the samples of a pixel that the sampler of a loaded file asks for, 0 if there is no sampler; for the
        pixel_samples of nicol_render_options. Returns NICOL_ERROR_UNSUPPORTED for a scene that was not loaded."""
        samples = c_uint32()
        check(_scene_get_sample_count(self, byref(samples)))
        return samples.value

    def get_max_depth(self):
        """Gets the largest max_depth that the integrators of a loaded file ask for, for nicol_render_options: 1 or
        more, or NICOL_DEPTH_UNLIMITED, which is Mitsuba's default; 0 if there is no integrator. Returns
        NICOL_ERROR_UNSUPPORTED for a scene that was not loaded."""
        max_depth = c_int32()
        check(_scene_get_max_depth(self, byref(max_depth)))
        return max_depth.value

    def get_aovs(self):
        """Gets the AOVs that the integrators of a loaded file ask for, a sum of NICOL_AOV_... for
        nicol_render_options. Returns NICOL_ERROR_UNSUPPORTED for a scene that was not loaded."""
        aovs = c_uint32()
        check(_scene_get_aovs(self, byref(aovs)))
        return aovs.value

    def get_file_count(self):
        """Gets the number of files that nicol_scene_load has read, or 0 for a scene that was not loaded. Each file
        counts once: the scene file, the files that it includes (the buffers of glTF), then light, materials and
        meshes. Scenes whose files have equal digests are equal."""
        count = c_uint32()
        check(_scene_get_file_count(self, byref(count)))
        return count.value

    def get_file(self, index):
        """Gets a file that nicol_scene_load has read; index counts from 0. Returns NICOL_ERROR_INVALID_ARGUMENT for
        an index beyond the last file."""
        file = SceneFile()
        check(_scene_get_file(self, index, byref(file)))
        return file

    def get_channels(self):
        """Gets the number of colour channels of the scene's images: the number of everything in the scene, 1 (all
        grey) or more, and 1 if the film of a loaded file is luminance."""
        channels = c_uint32()
        check(_scene_get_channels(self, byref(channels)))
        return channels.value

    def get_filter(self):
        """Gets the filter that the film of a loaded file asks for, for nicol_render_options: Gaussian, which is
        Mitsuba's default, if a Mitsuba file names none; box for glTF. Returns NICOL_ERROR_UNSUPPORTED for a scene
        that was not loaded."""
        filter = Filter()
        check(_scene_get_filter(self, byref(filter)))
        return filter


class Framebuffer(Handle):
    """Stokes image of the last render into it"""

    @classmethod
    def create(cls, context, width, height, channels):
        """Creates a framebuffer. width and height are 1 to NICOL_MAX_SIZE pixels (the driver may allow less), and at
        most 2^26 pixels in all. channels is the scene's number, or 1 for the luminance of a scene of three
        channels: 0.2126 R + 0.7152 G + 0.0722 B of each Stokes component."""
        framebuffer = cls()
        check(_framebuffer_create(context, width, height, channels, byref(framebuffer)))
        return framebuffer

    def resize(self, width, height):
        """Changes the size, within the limits of nicol_framebuffer_create, and keeps the handle and the channels. The
        content is lost and undefined until the next render, and textures get other names; nothing happens if the
        size is the same. A job or another render that was given the framebuffer before puts its image into the
        former content, which is lost."""
        check(_framebuffer_resize(self, width, height))

    def get_size(self):
        """Gets the width, height and channels of the framebuffer."""
        width = c_uint32()
        height = c_uint32()
        channels = c_uint32()
        check(_framebuffer_get_size(self, byref(width), byref(height), byref(channels)))
        return width.value, height.value, channels.value

    def get_statistics(self):
        """Gets the statistics of the last render into a framebuffer: all zeros before the first render."""
        statistics = Statistics()
        check(_framebuffer_get_statistics(self, byref(statistics)))
        return statistics

    def read(self, plane, channel, pixels):
        """Copies one plane of one colour channel, first row at the top. row_stride is in bytes; 0: tightly packed.
        byte_size is the room at pixels, in bytes. Returns NICOL_ERROR_INVALID_ARGUMENT for a plane that does not
        exist, and for NICOL_PLANE_INSTANCE, which holds no floats."""
        pixels = Buffer(pixels, c_float, writable=True, rows=True)
        check(_framebuffer_read(self, plane, channel, pixels.pointer, pixels.stride, pixels.nbytes))

    def read_plane(self, to):
        """Copies a plane in the format and with the channels of `to`. Bytes between rows are not written. A call that
        fails writes nothing."""
        check(_framebuffer_read_plane(self, byref(to) if to is not None else None))

    def write_exr(self, path):
        """Writes an OpenEXR file of 32-bit floats, whose channels are named by the number of colour channels:
          3             R G B (which are s0) and S0.R S0.G S0.B to S3.R S3.G S3.B, as Mitsuba 3's stokes integrator
          1             Y (which is s0) and S0.Y to S3.Y
          2, 4 to 16    S0.0 S0.1 ... to S3.0 S3.1 ...
        A path that ends as the names of another kind of image do, such as .png, is refused.
        AOVs of the last render are Z (depth), N.X N.Y N.Z, P.X P.Y P.Z, id (32-bit unsigned), A (alpha; R G B still have the
        environment) and, for each Stokes channel, variance.S0.R ... variance.S3.B."""
        check(_framebuffer_write_exr(self, text(path)))

    def write_png(self, observation, path):
        """Writes a PNG file of 8-bit RGB; a path that ends as the names of another kind of image do, such as .jpg, is
        refused. S0 and POLARIZER need a framebuffer of 1 or 3 channels; the other kinds
        show the mean of the channels."""
        check(_framebuffer_write_png(self, byref(observation) if observation is not None else None, text(path)))

    def expose(self, sensor, frame, to):
        """Exposes the sensor to the last image of a framebuffer."""
        check(_framebuffer_expose(self, byref(sensor) if sensor is not None else None, frame, byref(to) if to is not None else None))

    @classmethod
    def create_textures(cls, context, channels):
        """Creates a framebuffer whose images are textures of the host's, one for each channel: level 0 of a
        GL_TEXTURE_2D of GL_RGBA32F, allocated by glTexStorage2D or glTextureStorage2D, all of one size. A texel is
        the Stokes vector, and row 0 the image's TOP. The textures must live until the framebuffer is released;
        Nicol never deletes them. The host may sample them between renders, and must not write them while the
        framebuffer lives. nicol_framebuffer_resize fails with NICOL_ERROR_UNSUPPORTED. Returns
        NICOL_ERROR_INVALID_ARGUMENT that names a texture which cannot be used, and NICOL_ERROR_UNSUPPORTED for a
        context that is not a host's."""
        textures = c_uint32()
        framebuffer = cls()
        check(_framebuffer_create_textures(context, byref(textures), channels, byref(framebuffer)))
        return textures.value, framebuffer

    def get_texture(self, channel):
        """Gets the texture of a colour channel: a texel is the Stokes vector (s0, s1, s2, s3), and row 0 is the
        image's TOP. The name is valid, and stays the same, until the framebuffer is released or resized; the
        content is that of the last render. The host may sample the texture and change its filters and wrap modes,
        but not its swizzle, and must neither write nor delete the texture. Returns NICOL_ERROR_UNSUPPORTED for a
        framebuffer whose context is not a host's."""
        texture = GlTexture()
        check(_framebuffer_get_texture(self, channel, byref(texture)))
        return texture

    def draw_plane(self, plane, channel, target):
        """Copies a plane of one channel into a texture; nothing is read back. A texel gets the numbers that
        nicol_framebuffer_read copies, in red, green, blue and alpha; components that the plane does not have are
        0, and alpha 1. The texture may also be of GL_R16F or GL_R32F for one component, and is of GL_R32UI for
        NICOL_PLANE_INSTANCE. Returns NICOL_ERROR_INVALID_ARGUMENT for NICOL_PLANE_VARIANCE, which is not on the
        device, and NICOL_ERROR_UNSUPPORTED for a framebuffer whose context is not a host's."""
        check(_framebuffer_draw_plane(self, plane, channel, byref(target) if target is not None else None))

    def draw_stokes(self, channel, target):
        """Draws the plane NICOL_PLANE_STOKES."""
        check(_framebuffer_draw_stokes(self, channel, byref(target) if target is not None else None))

    def draw_observation(self, observation, target):
        """Draws the image of nicol_framebuffer_write_png into a texture, as red, green, blue and alpha 1. s1 to s3
        need a scale above 0, because nothing is read back. Returns NICOL_ERROR_UNSUPPORTED for a framebuffer whose
        context is not a host's."""
        check(_framebuffer_draw_observation(self, byref(observation) if observation is not None else None, byref(target) if target is not None else None))


class Job(Handle):
    """Asynchronous render. Jobs of one context run one after another, in the order of submission, on a thread of
    the context. Only nicol_render of the same scene waits for a running job, unless fail_if_busy is set. Other
    functions return while it runs: those that use OpenGL wait at most for the step that the job gives to
    OpenGL, and those that use its framebuffer for the step that puts the image there. A job may be used from
    any thread; nicol_job_poll and nicol_job_cancel may also be called from callbacks. "Inside a host's OpenGL"
    says how jobs differ there."""

    def poll(self):
        """Gets the job's progress, and never waits for the job."""
        status = JobStatus()
        check(_job_poll(self, byref(status)))
        return status

    def wait(self, timeout_ms):
        """Waits until the job is done, at most timeout_ms milliseconds (0: not at all), and returns the job's result.
        After a failure of the job, nicol_last_error() has its message. Returns NICOL_ERROR_TIMEOUT if the job is
        not done in time, and NICOL_ERROR_NOT_CURRENT if the job needs a host's OpenGL context that is not current
        on the calling thread. Returns NICOL_ERROR_INVALID_ARGUMENT inside a callback of the context, because
        waiting there would be a deadlock."""
        check(_job_wait(self, timeout_ms))

    def cancel(self):
        """Cancels a queued job at once, or a running job when it would next call a progress callback. The job's
        result is NICOL_ERROR_CANCELLED. A job that is done or almost done is not affected. The function does not
        wait."""
        check(_job_cancel(self))


class PshTransform(Handle):
    """Transform between samples [vector][row][column][4], north to south, and coefficients, in O(order^3). The
    transform needs no context and holds its work space: no call allocates after creation. Calls on one
    transform are serialised."""

    @classmethod
    def create(cls, sampling):
        """Creates a transform. Returns NICOL_ERROR_INVALID_ARGUMENT if the sampling is too coarse for the
        order."""
        transform = cls()
        check(_psh_transform_create(byref(sampling) if sampling is not None else None, byref(transform)))
        return transform

    def get_size(self):
        """Gets the numbers of rows and columns of the transform's grid."""
        rows = c_uint32()
        columns = c_uint32()
        check(_psh_transform_get_size(self, byref(rows), byref(columns)))
        return rows.value, columns.value

    def get_rows(self, theta, weight):
        """Gets theta of each row, and the rows' weights for the integral over cos theta, which sum to 2;
        count = rows."""
        theta, weight = Buffer(theta, c_double, writable=True), Buffer(weight, c_double, writable=True)
        check(_psh_transform_get_rows(self, theta.pointer, weight.pointer, counted(theta, weight)))


def version():
    """Returns the version of the running library: major * 10000 + minor * 100 + patch."""
    return _version()


def version_string():
    """Returns the version of the running library as text, such as "0.1.0". The string lives as long as the
    library."""
    return decoded(_version_string())


def build_info(index):
    """Returns a property of this build as "key=value" (source, compiler, backends, methods, max_order, ...).
    index counts from 0; an index past the last property gives NULL. "files" lists the kinds of files that the
    build reads: exr, bitmaps, mesh_files and scene_files may be left out; calls for the others fail with
    NICOL_ERROR_UNSUPPORTED. The string lives as long as the library."""
    return decoded(_build_info(index))


def last_error():
    """Returns the message of the last failed call on this thread: one line that names the file, line, field or
    argument and what is expected. The message is never NULL, and "" before the first failure. The string is
    valid until this thread's next failed call. Tasks that move between threads, as in Go and in asynchronous
    runtimes, may see another task's message: they keep their thread for both calls, or use the error callback
    of nicol_context_options."""
    return decoded(_last_error())


def result_name(result):
    """Returns a name such as "out of memory" for a result code. The string lives as long as the library."""
    return decoded(_result_name(result))


def device_count():
    """Gets the number of devices for nicol_context_options.device. The devices are those that EGL lists, in EGL's
    order, which is neither CUDA's nor the kernel's. Without EGL the number is 0. The list may change when
    devices or drivers are added or removed."""
    count = c_uint32()
    check(_device_count(byref(count)))
    return count.value


def device_get_info(device):
    """Gets the properties of a device; device is 1 to the number of nicol_device_count. Creating a context on the
    device may still fail, because this function does not create one."""
    info = DeviceInfo()
    check(_device_get_info(device, byref(info)))
    return info


def render(scene, camera, options, framebuffer):
    """Renders a scene into a framebuffer. options may be NULL: all defaults. Results that a change of the scene,
    the camera or the options does not affect are kept from the scene's last render; if nothing changed,
    nothing runs. On failure or cancellation the framebuffer keeps its content and statistics. Returns
    NICOL_ERROR_INVALID_ARGUMENT for options and cameras out of range and for channels that do not fit. Returns
    NICOL_ERROR_UNSUPPORTED for an unknown method, for compute shaders if the driver lacks features, and, if a
    material varies by a texture, for the dense method and for shading at vertices. Returns
    NICOL_ERROR_CANCELLED if a callback returned 0, NICOL_ERROR_BUSY as fail_if_busy says, and
    NICOL_ERROR_OUT_OF_MEMORY also beyond the context's memory_limit."""
    check(_render(scene, byref(camera) if camera is not None else None, byref(options) if options is not None else None, framebuffer))


def render_async(scene, camera, options, framebuffer):
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


def psh_project_image(image, order, coefficients):
    """Projects an image to coefficients, one vector per channel, in the world's axes. The image is the bilinear
    function between its pixels and, as an environment, must be physically realizable: polarization up to s0.
    Returns NICOL_ERROR_INVALID_ARGUMENT unless count is channels * 4 (order+1)^2."""
    image = lend(image)
    coefficients = Buffer(coefficients, c_double, writable=True)
    check(_psh_project_image(byref(image) if image is not None else None, order, coefficients.pointer, coefficients.count))


def psh_project_environment(environment, order, coefficients):
    """Projects an environment to coefficients, one vector per channel, in the world's axes. Returns
    NICOL_ERROR_INVALID_ARGUMENT unless count is channels * 4 (order+1)^2."""
    coefficients = Buffer(coefficients, c_double, writable=True)
    check(_psh_project_environment(environment, order, coefficients.pointer, coefficients.count))


def psh_project_file(path, order, coefficients=None):
    """Projects a file that nicol_environment_load can read to coefficients, one vector per channel, in the
    world's axes. channels may be NULL; coefficients NULL with count 0 gets only the number of channels.
    Otherwise returns NICOL_ERROR_INVALID_ARGUMENT unless count is channels * 4 (order+1)^2."""
    channels = c_uint32()
    coefficients = Buffer(coefficients, c_double, writable=True)
    check(_psh_project_file(text(path), order, byref(channels), coefficients.pointer, coefficients.count))
    return channels.value


def psh_analyze(transform, vectors, samples, coefficients):
    """Computes coefficients from samples: inner products with the basis (Eq. 32) by the rows' weights."""
    samples = Buffer(samples, c_double)
    coefficients = Buffer(coefficients, c_double, writable=True)
    check(_psh_analyze(transform, vectors, samples.pointer, samples.count, coefficients.pointer, coefficients.count))


def psh_synthesize(transform, vectors, coefficients, samples):
    """Computes samples from coefficients: the field of the coefficients (Eq. 30) at the grid."""
    coefficients = Buffer(coefficients, c_double)
    samples = Buffer(samples, c_double, writable=True)
    check(_psh_synthesize(transform, vectors, coefficients.pointer, coefficients.count, samples.pointer, samples.count))


def psh_evaluate(order, vectors, coefficients, directions, stokes):
    """Computes Stokes vectors [vector][direction][4] at directions [direction][3] of any length but 0."""
    coefficients = Buffer(coefficients, c_double)
    directions = Buffer(directions, c_double)
    stokes = Buffer(stokes, c_double, writable=True)
    check(_psh_evaluate(order, vectors, coefficients.pointer, coefficients.count, directions.pointer, directions.count, stokes.pointer, stokes.count))


def psh_rotate(order, vectors, in_, rotation, out):
    """Rotates fields: (R f)(w) = R f(R^-1 w) (Eqs. 25, 36). The rotation must be orthonormal to 1e-5 and
    right-handed. out may be in."""
    in_ = Buffer(in_, c_double)
    out = Buffer(out, c_double, writable=True)
    check(_psh_rotate(order, vectors, in_.pointer, in_.count, array(rotation, c_double, 9), out.pointer, out.count))


def psh_reflect(order, vectors, in_, out):
    """Mirrors fields in the plane z = 0 (Eq. 214, with its conjugation). out may be in."""
    in_ = Buffer(in_, c_double)
    out = Buffer(out, c_double, writable=True)
    check(_psh_reflect(order, vectors, in_.pointer, in_.count, out.pointer, out.count))


def psh_multiply(scalar_order, scalar, order, vectors, in_, order_out, out):
    """Multiplies each field by a scalar field, (scalar_order+1)^2 coefficients over real harmonics, such as
    visibility, and cuts the product above order_out. The product is exact, through a grid, in O(order^3). out
    may be in if the orders agree."""
    scalar = Buffer(scalar, c_double)
    in_ = Buffer(in_, c_double)
    out = Buffer(out, c_double, writable=True)
    check(_psh_multiply(scalar_order, scalar.pointer, scalar.count, order, vectors, in_.pointer, in_.count, order_out, out.pointer, out.count))


def psh_shadow_matrix(scalar_order, scalar, order_out, order_in, matrix):
    """Computes the matrix of nicol_psh_multiply for a scalar field (Eq. 54, by the triple products of Eqs. 215
    and 216)."""
    scalar = Buffer(scalar, c_double)
    matrix = Buffer(matrix, c_double, writable=True)
    check(_psh_shadow_matrix(scalar_order, scalar.pointer, scalar.count, order_out, order_in, matrix.pointer, matrix.count))


def psh_project_matrix(field, matrix):
    """Computes the matrix of the operator "integrate the field times the light over the incoming directions"
    (Eqs. 39, 40), by quadrature."""
    matrix = Buffer(matrix, c_double, writable=True)
    check(_psh_project_matrix(byref(field) if field is not None else None, matrix.pointer, matrix.count))


def psh_apply_matrix(order_out, order_in, matrix, vectors, in_, out):
    """Computes out = matrix * in, vector by vector (Eq. 41)."""
    matrix = Buffer(matrix, c_double)
    in_ = Buffer(in_, c_double)
    out = Buffer(out, c_double, writable=True)
    check(_psh_apply_matrix(order_out, order_in, matrix.pointer, matrix.count, vectors, in_.pointer, in_.count, out.pointer, out.count))


def psh_compose_matrix(order_out, order_between, order_in, second, first, matrix):
    """Computes the matrix of `second` after `first`."""
    second = Buffer(second, c_double)
    first = Buffer(first, c_double)
    matrix = Buffer(matrix, c_double, writable=True)
    check(_psh_compose_matrix(order_out, order_between, order_in, second.pointer, second.count, first.pointer, first.count, matrix.pointer, matrix.count))


def psh_project_kernel(callback, order, rows, bands):
    """Computes the bands of a kernel by quadrature (Eq. 68). rows is the number of Gauss-Legendre rows, at most
    16384; 0: 2 order + 2."""
    bands = Buffer(bands, c_double, writable=True)
    check(_psh_project_kernel(PshKernelCallback(callback), None, order, rows, bands.pointer, bands.count))


def psh_kernel_at(order, bands, theta, mueller):
    """Computes Mueller matrices [angle][16] of a kernel at angles in 0 to pi, the inverse of
    nicol_psh_project_kernel."""
    bands = Buffer(bands, c_double)
    theta = Buffer(theta, c_double)
    mueller = Buffer(mueller, c_double, writable=True)
    check(_psh_kernel_at(order, bands.pointer, bands.count, theta.pointer, theta.count, mueller.pointer, mueller.count))


def psh_convolve(order, bands, vectors, in_, out):
    """Convolves each field with a kernel (Eq. 69). out may be in."""
    bands = Buffer(bands, c_double)
    in_ = Buffer(in_, c_double)
    out = Buffer(out, c_double, writable=True)
    check(_psh_convolve(order, bands.pointer, bands.count, vectors, in_.pointer, in_.count, out.pointer, out.count))


def psh_kernel_matrix(order, bands, matrix):
    """Computes the matrix of a convolution (supplement E.9); both sides of the matrix have this order."""
    bands = Buffer(bands, c_double)
    matrix = Buffer(matrix, c_double, writable=True)
    check(_psh_kernel_matrix(order, bands.pointer, bands.count, matrix.pointer, matrix.count))


def psh_nearest_kernel(order, matrix, bands):
    """Computes the kernel nearest to a matrix in the Frobenius norm (supplement E.9); both sides of the matrix
    have this order."""
    matrix = Buffer(matrix, c_double)
    bands = Buffer(bands, c_double, writable=True)
    check(_psh_nearest_kernel(order, matrix.pointer, matrix.count, bands.pointer, bands.count))


def file_identify(path):
    """Gets the kind of a file from its suffix and headers alone; the file may yet prove damaged. Returns
    NICOL_ERROR_UNSUPPORTED for another suffix or an archive of another kind."""
    kind = c_uint32()
    check(_file_identify(text(path), byref(kind)))
    return kind.value


def file_describe_light(path, options, energy=None):
    """Gets the report of a light, and its energies [channel][l][p], 4 (order + 1) per channel: squares of the
    coefficients, summed over m. energy has room for count doubles, and may be NULL with count 0. options may
    be NULL. Scale and rotation change the report as they would change an output. Options of images to write
    must be 0. The order limits the energies of an image, and everything for coefficients. An image that
    violates Eq. 70 is described, although it is refused as a light."""
    report = LightReport()
    energy = Buffer(energy, c_double, writable=True)
    check(_file_describe_light(text(path), byref(options) if options is not None else None, byref(report), energy.pointer, energy.count))
    return report


def file_describe_material(path, options, energy):
    """Gets the report of a material, and its energies [channel][l], order + 1 per channel: squares of the matrix'
    entries between two orders, the larger of which is l. options are those of nicol_file_describe_light."""
    report = MaterialReport()
    energy = Buffer(energy, c_double, writable=True)
    check(_file_describe_material(text(path), byref(options) if options is not None else None, byref(report), energy.pointer, energy.count))
    return report


def file_convert(in_, options, out):
    """Reads the file `in` and writes `out` in the kind that the name of `out` says: .exr, _s0.exr (all four
    files), .npz or a cache folder. Light becomes light, and a material becomes a material. options may be
    NULL."""
    check(_file_convert(text(in_), byref(options) if options is not None else None, text(out)))


def file_demosaic(in_, sensor, method, out):
    """Reads a mosaic from a grey image of 8 or 16 bits, as of a polarization camera or nicol_sensor_write_png,
    and writes the Stokes image of nicol_sensor_demosaic to an OpenEXR file."""
    check(_file_demosaic(text(in_), byref(sensor) if sensor is not None else None, method, text(out)))


def file_combine_angles(at_0, at_45, at_90, at_135, out):
    """Reads pictures of one view behind a polarizer at 0, 45, 90 and 135 degrees counter-clockwise from image
    right, and writes the Stokes image in front of it to an OpenEXR file, with s3 = 0. EXR files give s0. Other
    images give their numbers as linear light in 0 to 1, without a curve."""
    check(_file_combine_angles(text(at_0), text(at_45), text(at_90), text(at_135), text(out)))


def psh_write_file(path, order, vectors, coefficients):
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
_context_get_info = declare("nicol_context_get_info", c_int32, Context, POINTER(ContextInfo))
Image._init = declare("nicol_image_init", c_int32, POINTER(Image), c_uint32)
Sky._init = declare("nicol_sky_init", c_int32, POINTER(Sky), c_uint32)
EnvironmentLoadOptions._init = declare("nicol_environment_load_options_init", c_int32, POINTER(EnvironmentLoadOptions), c_uint32)
_environment_load = declare("nicol_environment_load", c_int32, Context, c_char_p, POINTER(EnvironmentLoadOptions), POINTER(Environment))
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
_texture_create_checkerboard = declare("nicol_texture_create_checkerboard", c_int32, Context, POINTER(Spectrum), POINTER(Spectrum), POINTER(c_double), POINTER(Texture))
_texture_create_vertex_colors = declare("nicol_texture_create_vertex_colors", c_int32, Context, POINTER(Texture))
_texture_create_face_colors = declare("nicol_texture_create_face_colors", c_int32, Context, POINTER(Texture))
Texture._release = declare("nicol_texture_release", c_int32, c_void_p)
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
PshMatrix._init = declare("nicol_psh_matrix_init", c_int32, POINTER(PshMatrix), c_uint32)
_material_load_psh = declare("nicol_material_load_psh", c_int32, Context, c_char_p, POINTER(PshMatrix), POINTER(Material))
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
_mesh_create = declare("nicol_mesh_create", c_int32, Context, POINTER(MeshData), POINTER(Mesh))
_mesh_create_sphere = declare("nicol_mesh_create_sphere", c_int32, Context, POINTER(Mesh))
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
Emission._init = declare("nicol_emission_init", c_int32, POINTER(Emission), c_uint32)
PolarizationElement._init = declare("nicol_polarization_element_init", c_int32, POINTER(PolarizationElement), c_uint32)
Instance._init = declare("nicol_instance_init", c_int32, POINTER(Instance), c_uint32)
_scene_create = declare("nicol_scene_create", c_int32, Context, POINTER(Scene))
_scene_load = declare("nicol_scene_load", c_int32, Context, c_char_p, POINTER(c_char_p), c_uint32, POINTER(Scene))
_scene_add_instance = declare("nicol_scene_add_instance", c_int32, Scene, POINTER(Instance), POINTER(c_uint32))
_scene_set_transform = declare("nicol_scene_set_transform", c_int32, Scene, c_uint32, POINTER(c_double))
_scene_set_mesh = declare("nicol_scene_set_mesh", c_int32, Scene, c_uint32, Mesh)
_scene_set_material = declare("nicol_scene_set_material", c_int32, Scene, c_uint32, Material)
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
Framebuffer._release = declare("nicol_framebuffer_release", c_int32, c_void_p)
_render = declare("nicol_render", c_int32, Scene, POINTER(Camera), POINTER(RenderOptions), Framebuffer)
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
Observation._init = declare("nicol_observation_init", c_int32, POINTER(Observation), c_uint32)
_framebuffer_write_png = declare("nicol_framebuffer_write_png", c_int32, Framebuffer, POINTER(Observation), c_char_p)
Sensor._init = declare("nicol_sensor_init", c_int32, POINTER(Sensor), c_uint32)
_sensor_set_preset = declare("nicol_sensor_set_preset", c_int32, POINTER(Sensor), c_uint32)
_sensor_load = declare("nicol_sensor_load", c_int32, POINTER(Sensor), c_char_p)
_sensor_add_element = declare("nicol_sensor_add_element", c_int32, POINTER(Sensor), POINTER(PolarizationElement), c_double)
StokesImage._init = declare("nicol_stokes_image_init", c_int32, POINTER(StokesImage), c_uint32)
RawImage._init = declare("nicol_raw_image_init", c_int32, POINTER(RawImage), c_uint32)
_sensor_expose = declare("nicol_sensor_expose", c_int32, POINTER(Sensor), POINTER(StokesImage), c_uint64, POINTER(RawImage))
_framebuffer_expose = declare("nicol_framebuffer_expose", c_int32, Framebuffer, POINTER(Sensor), c_uint64, POINTER(RawImage))
_sensor_write_png = declare("nicol_sensor_write_png", c_int32, POINTER(Sensor), POINTER(RawImage), c_char_p)
_sensor_demosaic = declare("nicol_sensor_demosaic", c_int32, POINTER(Sensor), POINTER(RawImage), c_uint32, POINTER(StokesImage))
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
    "Camera",
    "Conductor",
    "Context",
    "ContextInfo",
    "ContextOptions",
    "DEMOSAIC_BILINEAR",
    "DEMOSAIC_BLOCKS",
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
    "FileOptions",
    "Filter",
    "Framebuffer",
    "GlTexture",
    "HIGH_ORDERS_CONVOLUTION",
    "HIGH_ORDERS_NONE",
    "HIGH_ORDERS_SPLIT",
    "HOST_SETS_STATE",
    "HOST_VALIDATE",
    "Host",
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
    "METHOD_DENSE",
    "METHOD_FACTORED",
    "METHOD_REFERENCE",
    "MOSAIC_PLAIN",
    "MOSAIC_POLARIZED",
    "MOSAIC_POLARIZED_BAYER",
    "Material",
    "MaterialReport",
    "Measured",
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
    "Scene",
    "SceneFile",
    "Sensor",
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
    "render",
    "render_async",
    "result_name",
    "version",
    "version_string",
]
