// SPDX-License-Identifier: MIT
//! Nicol 0.1.0 for Rust. Made of the C headers by samples/bindings/generate.py: change those, not this file.
#![allow(non_camel_case_types)]
use std::ffi::{c_char, c_void};
use std::mem::{offset_of, size_of};

pub const NICOL_VERSION_MAJOR: u32 = 0;
pub const NICOL_VERSION_MINOR: u32 = 1;
pub const NICOL_VERSION_PATCH: u32 = 0;
pub const NICOL_VERSION: u32 = 100;
pub const NICOL_OK: nicol_result = 0;
pub const NICOL_ERROR_INVALID_ARGUMENT: nicol_result = 1;
pub const NICOL_ERROR_INVALID_HANDLE: nicol_result = 2;
pub const NICOL_ERROR_OUT_OF_MEMORY: nicol_result = 3;
pub const NICOL_ERROR_FILE_NOT_FOUND: nicol_result = 4;
pub const NICOL_ERROR_INVALID_FILE: nicol_result = 5;
pub const NICOL_ERROR_WRITE_FAILED: nicol_result = 6;
pub const NICOL_ERROR_UNSUPPORTED: nicol_result = 7;
pub const NICOL_ERROR_NO_BACKEND: nicol_result = 8;
pub const NICOL_ERROR_CANCELLED: nicol_result = 9;
pub const NICOL_ERROR_OPENGL: nicol_result = 10;
pub const NICOL_ERROR_INTERNAL: nicol_result = 11;
pub const NICOL_ERROR_NOT_CURRENT: nicol_result = 12;
pub const NICOL_ERROR_TIMEOUT: nicol_result = 13;
pub const NICOL_ERROR_BUSY: nicol_result = 14;
pub const NICOL_LOG_INFO: u32 = 0;
pub const NICOL_LOG_NOTICE: u32 = 1;
pub const NICOL_LOG_WARNING: u32 = 2;
pub const NICOL_MAX_CHANNELS: u32 = 16;
pub const NICOL_MAX_ORDER: u32 = 32;
pub const NICOL_ORDER_AUTOMATIC: u32 = 4294967295;
pub const NICOL_MAX_SIZE: u32 = 16384;
pub const NICOL_NO_LIMIT: u64 = 18446744073709551615;
pub const NICOL_BACKEND_AUTOMATIC: u32 = 0;
pub const NICOL_BACKEND_EGL: u32 = 1;
pub const NICOL_BACKEND_OSMESA: u32 = 2;
pub const NICOL_BACKEND_HOST: u32 = 3;
pub const NICOL_TEXTURE_FILTER_NEAREST: u32 = 0;
pub const NICOL_TEXTURE_FILTER_BILINEAR: u32 = 1;
pub const NICOL_TEXTURE_FILTER_MIPMAP: u32 = 2;
pub const NICOL_TEXTURE_WRAP_REPEAT: u32 = 0;
pub const NICOL_TEXTURE_WRAP_MIRROR: u32 = 1;
pub const NICOL_TEXTURE_WRAP_CLAMP: u32 = 2;
pub const NICOL_TEXEL_UINT8: u32 = 0;
pub const NICOL_TEXEL_UINT16: u32 = 1;
pub const NICOL_TEXEL_FLOAT32: u32 = 2;
pub const NICOL_DISTRIBUTION_BECKMANN: u32 = 0;
pub const NICOL_DISTRIBUTION_GGX: u32 = 1;
pub const NICOL_WAVELENGTH_LINEAR: u32 = 0;
pub const NICOL_WAVELENGTH_NEAREST: u32 = 1;
pub const NICOL_PROJECTION_PERSPECTIVE: u32 = 0;
pub const NICOL_PROJECTION_ORTHOGRAPHIC: u32 = 1;
pub const NICOL_LIGHT_DIRECTIONAL: u32 = 0;
pub const NICOL_LIGHT_POINT: u32 = 1;
pub const NICOL_LIGHT_SPOT: u32 = 2;
pub const NICOL_LIGHT_PROJECTOR: u32 = 3;
pub const NICOL_POLARIZATION_ELEMENT_POLARIZER: u32 = 0;
pub const NICOL_POLARIZATION_ELEMENT_RETARDER: u32 = 1;
pub const NICOL_POLARIZATION_ELEMENT_RIGHT_CIRCULAR: u32 = 2;
pub const NICOL_POLARIZATION_ELEMENT_LEFT_CIRCULAR: u32 = 3;
pub const NICOL_POLARIZATION_ELEMENT_RECTANGLE: u32 = 0;
pub const NICOL_POLARIZATION_ELEMENT_DISK: u32 = 1;
pub const NICOL_METHOD_FACTORED: u32 = 0;
pub const NICOL_METHOD_DENSE: u32 = 1;
pub const NICOL_METHOD_REFERENCE: u32 = 2;
pub const NICOL_HIGH_ORDERS_SPLIT: u32 = 0;
pub const NICOL_HIGH_ORDERS_CONVOLUTION: u32 = 1;
pub const NICOL_HIGH_ORDERS_NONE: u32 = 2;
pub const NICOL_SHADE_AT_AUTOMATIC: u32 = 0;
pub const NICOL_SHADE_AT_VERTICES: u32 = 1;
pub const NICOL_SHADE_AT_PIXELS: u32 = 2;
pub const NICOL_EXECUTOR_AUTOMATIC: u32 = 0;
pub const NICOL_EXECUTOR_CPU: u32 = 1;
pub const NICOL_EXECUTOR_COMPUTE: u32 = 2;
pub const NICOL_OPTIMISATION_UNCHANGED: u32 = 1;
pub const NICOL_OPTIMISATION_LIGHT_COMPONENTS: u32 = 2;
pub const NICOL_OPTIMISATION_CHANNELS: u32 = 4;
pub const NICOL_OPTIMISATION_ORDERS: u32 = 8;
pub const NICOL_OPTIMISATION_RESPONSE_ROWS: u32 = 16;
pub const NICOL_OPTIMISATION_HIDDEN: u32 = 32;
pub const NICOL_OPTIMISATION_UNOCCLUDED: u32 = 64;
pub const NICOL_OPTIMISATION_ALL: u32 = 127;
pub const NICOL_AOV_DEPTH: u32 = 1;
pub const NICOL_AOV_NORMAL: u32 = 2;
pub const NICOL_AOV_POSITION: u32 = 4;
pub const NICOL_AOV_INSTANCE: u32 = 8;
pub const NICOL_AOV_ALPHA: u32 = 32;
pub const NICOL_AOV_ALL: u32 = 47;
pub const NICOL_AOV_VARIANCE: u32 = 16;
pub const NICOL_COMPONENTS_ALL: u32 = 0;
pub const NICOL_COMPONENTS_S0: u32 = 1;
pub const NICOL_COMPONENTS_LINEAR: u32 = 3;
pub const NICOL_DIRECTIONS_AUTOMATIC: u32 = 0;
pub const NICOL_SPLIT_AUTOMATIC: i32 = -1;
pub const NICOL_MAX_SPLIT_LIGHTS: u32 = 64;
pub const NICOL_MAX_JOBS: u32 = 256;
pub const NICOL_JOB_WAITING: u32 = 0;
pub const NICOL_JOB_RUNNING: u32 = 1;
pub const NICOL_JOB_DONE: u32 = 2;
pub const NICOL_WAIT_FOREVER: u32 = 4294967295;
pub const NICOL_PLANE_S0: u32 = 0;
pub const NICOL_PLANE_S1: u32 = 1;
pub const NICOL_PLANE_S2: u32 = 2;
pub const NICOL_PLANE_S3: u32 = 3;
pub const NICOL_PLANE_STOKES: u32 = 4;
pub const NICOL_PLANE_DOLP: u32 = 5;
pub const NICOL_PLANE_AOLP: u32 = 6;
pub const NICOL_PLANE_DEPTH: u32 = 7;
pub const NICOL_PLANE_NORMAL: u32 = 8;
pub const NICOL_PLANE_POSITION: u32 = 9;
pub const NICOL_PLANE_INSTANCE: u32 = 10;
pub const NICOL_NO_INSTANCE: u32 = 4294967295;
pub const NICOL_PLANE_VARIANCE: u32 = 11;
pub const NICOL_PLANE_ALPHA: u32 = 12;
pub const NICOL_FORMAT_AUTOMATIC: u32 = 0;
pub const NICOL_FORMAT_FLOAT32: u32 = 1;
pub const NICOL_FORMAT_FLOAT16: u32 = 2;
pub const NICOL_FORMAT_UINT32: u32 = 3;
pub const NICOL_ALL_CHANNELS: u32 = 4294967295;
pub const NICOL_OBSERVATION_S0: u32 = 0;
pub const NICOL_OBSERVATION_S1: u32 = 1;
pub const NICOL_OBSERVATION_S2: u32 = 2;
pub const NICOL_OBSERVATION_S3: u32 = 3;
pub const NICOL_OBSERVATION_DOLP: u32 = 4;
pub const NICOL_OBSERVATION_AOLP: u32 = 5;
pub const NICOL_OBSERVATION_POLARIZER: u32 = 6;
pub const NICOL_ENCODING_LINEAR: u32 = 0;
pub const NICOL_ENCODING_SRGB: u32 = 1;
pub const NICOL_PSH_MAX_ORDER: u32 = 4096;
pub const NICOL_PSH_MAX_MATRIX_ORDER: u32 = 64;
pub const NICOL_PSH_GRID_FEJER: u32 = 0;
pub const NICOL_PSH_GRID_CLENSHAW_CURTIS: u32 = 1;
pub const NICOL_PSH_GRID_GAUSS_LEGENDRE: u32 = 2;
pub const NICOL_PSH_BAND_SIZE: u32 = 16;
pub const NICOL_FILE_LIGHT_IMAGE: u32 = 1;
pub const NICOL_FILE_LIGHT_CROSS: u32 = 2;
pub const NICOL_FILE_LIGHT_PSH: u32 = 3;
pub const NICOL_FILE_MATERIAL_PSH: u32 = 4;
pub const NICOL_FILE_MATERIAL_MEASURED: u32 = 5;
pub const NICOL_FILE_MATERIAL_TABLE: u32 = 6;
pub const NICOL_FILE_BAND_LIMITED: u32 = 1;
pub const NICOL_FILE_PHYSICAL: u32 = 2;
pub const NICOL_FILE_ORDER_AUTOMATIC: u32 = 4294967295;

pub type nicol_result = i32;

/// message is one line that lives as long as the call; code is NICOL_OK, or the error that a call would have
/// returned for what was worked round. It must not call Nicol with objects of the context.
pub type nicol_log_callback = Option<unsafe extern "C" fn(user: *mut c_void, severity: u32, code: nicol_result, message: *const c_char)>;

/// Called about ten times a second on the thread that called; fraction runs from 0 to 1. Return 1 to continue,
/// 0 to cancel: the call then returns NICOL_ERROR_CANCELLED. It must not call Nicol with objects of the same
/// context.
pub type nicol_progress_callback = Option<unsafe extern "C" fn(user: *mut c_void, verb: *const c_char, fraction: f64) -> i32>;

#[repr(C)]
pub struct nicol_context_impl {
    _private: [u8; 0],
}
/// an OpenGL context on a thread of its own
pub type nicol_context = *mut nicol_context_impl;

#[repr(C)]
pub struct nicol_environment_impl {
    _private: [u8; 0],
}
/// light from infinitely far; immutable
pub type nicol_environment = *mut nicol_environment_impl;

#[repr(C)]
pub struct nicol_texture_impl {
    _private: [u8; 0],
}
/// values that vary over a surface; immutable
pub type nicol_texture = *mut nicol_texture_impl;

#[repr(C)]
pub struct nicol_material_impl {
    _private: [u8; 0],
}
/// a polarimetric BRDF; immutable
pub type nicol_material = *mut nicol_material_impl;

#[repr(C)]
pub struct nicol_mesh_impl {
    _private: [u8; 0],
}
/// triangles; immutable
pub type nicol_mesh = *mut nicol_mesh_impl;

#[repr(C)]
pub struct nicol_scene_impl {
    _private: [u8; 0],
}
/// what is rendered, and by which light
pub type nicol_scene = *mut nicol_scene_impl;

#[repr(C)]
pub struct nicol_framebuffer_impl {
    _private: [u8; 0],
}
/// the Stokes image of the last render into it
pub type nicol_framebuffer = *mut nicol_framebuffer_impl;

/// One value a colour channel. count 0: not given, the default of where it is used; 1: the same in every
/// channel; else the scene's channel count.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_spectrum {
    pub count: u32,
    pub values: [f32; 16],
}
impl Default for nicol_spectrum {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        unsafe { std::mem::zeroed() }
    }
}
const _: () = {
    assert!(size_of::<nicol_spectrum>() == 68);
    assert!(offset_of!(nicol_spectrum, count) == 0);
    assert!(offset_of!(nicol_spectrum, values) == 4);
};
pub type nicol_backend = u32;

#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_device_info {
    pub struct_size: u32,
    pub software: u32,
    pub name: *const c_char,
    pub vendor: *const c_char,
    pub file: *const c_char,
}
impl Default for nicol_device_info {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_device_info>() == 32);
    assert!(offset_of!(nicol_device_info, struct_size) == 0);
    assert!(offset_of!(nicol_device_info, software) == 4);
    assert!(offset_of!(nicol_device_info, name) == 8);
    assert!(offset_of!(nicol_device_info, vendor) == 16);
    assert!(offset_of!(nicol_device_info, file) == 24);
};

#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_context_options {
    pub struct_size: u32,
    pub backend: nicol_backend,
    pub device: u32,
    pub threads: u32,
    pub log: nicol_log_callback,
    pub log_user: *mut c_void,
    pub cache_folder: *const c_char,
    pub memory_limit: u64,
    pub load_bytes_limit: u64,
    pub vertex_limit: u64,
    pub triangle_limit: u64,
    pub load_seconds_limit: f64,
    pub load_progress: nicol_progress_callback,
    pub load_progress_user: *mut c_void,
}
impl Default for nicol_context_options {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made.memory_limit = 18446744073709551615;
        made.load_bytes_limit = 8589934592;
        made.vertex_limit = 67108864;
        made.triangle_limit = 134217728;
        made.load_seconds_limit = 600.0;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_context_options>() == 96);
    assert!(offset_of!(nicol_context_options, struct_size) == 0);
    assert!(offset_of!(nicol_context_options, backend) == 4);
    assert!(offset_of!(nicol_context_options, device) == 8);
    assert!(offset_of!(nicol_context_options, threads) == 12);
    assert!(offset_of!(nicol_context_options, log) == 16);
    assert!(offset_of!(nicol_context_options, log_user) == 24);
    assert!(offset_of!(nicol_context_options, cache_folder) == 32);
    assert!(offset_of!(nicol_context_options, memory_limit) == 40);
    assert!(offset_of!(nicol_context_options, load_bytes_limit) == 48);
    assert!(offset_of!(nicol_context_options, vertex_limit) == 56);
    assert!(offset_of!(nicol_context_options, triangle_limit) == 64);
    assert!(offset_of!(nicol_context_options, load_seconds_limit) == 72);
    assert!(offset_of!(nicol_context_options, load_progress) == 80);
    assert!(offset_of!(nicol_context_options, load_progress_user) == 88);
};

#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_context_info {
    pub struct_size: u32,
    pub backend: nicol_backend,
    pub software: u32,
    pub threads: u32,
    pub renderer: *const c_char,
    pub vendor: *const c_char,
    pub version: *const c_char,
    pub max_framebuffer_size: u32,
    pub reserved: u32,
    pub memory_limit: u64,
    pub load_bytes_limit: u64,
    pub vertex_limit: u64,
    pub triangle_limit: u64,
    pub load_seconds_limit: f64,
}
impl Default for nicol_context_info {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_context_info>() == 88);
    assert!(offset_of!(nicol_context_info, struct_size) == 0);
    assert!(offset_of!(nicol_context_info, backend) == 4);
    assert!(offset_of!(nicol_context_info, software) == 8);
    assert!(offset_of!(nicol_context_info, threads) == 12);
    assert!(offset_of!(nicol_context_info, renderer) == 16);
    assert!(offset_of!(nicol_context_info, vendor) == 24);
    assert!(offset_of!(nicol_context_info, version) == 32);
    assert!(offset_of!(nicol_context_info, max_framebuffer_size) == 40);
    assert!(offset_of!(nicol_context_info, reserved) == 44);
    assert!(offset_of!(nicol_context_info, memory_limit) == 48);
    assert!(offset_of!(nicol_context_info, load_bytes_limit) == 56);
    assert!(offset_of!(nicol_context_info, vertex_limit) == 64);
    assert!(offset_of!(nicol_context_info, triangle_limit) == 72);
    assert!(offset_of!(nicol_context_info, load_seconds_limit) == 80);
};

pub type nicol_release_callback = Option<unsafe extern "C" fn(user: *mut c_void)>;

/// An equirectangular image over the directions light comes FROM, in Mitsuba 3's layout: column u = atan2(x,
/// -z) / 2 pi (pixel-centred), row v = acos(y) / pi (row 0 is the pole itself, the last row the other pole).
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_image {
    pub struct_size: u32,
    pub width: u32,
    pub height: u32,
    pub channels: u32,
    pub components: u32,
    pub pixels: *const f32,
    pub row_stride: u64,
    pub byte_size: u64,
    pub release: nicol_release_callback,
    pub release_user: *mut c_void,
}
impl Default for nicol_image {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_image>() == 64);
    assert!(offset_of!(nicol_image, struct_size) == 0);
    assert!(offset_of!(nicol_image, width) == 4);
    assert!(offset_of!(nicol_image, height) == 8);
    assert!(offset_of!(nicol_image, channels) == 12);
    assert!(offset_of!(nicol_image, components) == 16);
    assert!(offset_of!(nicol_image, pixels) == 24);
    assert!(offset_of!(nicol_image, row_stride) == 32);
    assert!(offset_of!(nicol_image, byte_size) == 40);
    assert!(offset_of!(nicol_image, release) == 48);
    assert!(offset_of!(nicol_image, release_user) == 56);
};

/// A clear sky; the sun's own disc is not part of it. At the angle g from the sun its degree of polarization
/// is dop_max sin^2 g / (1 + cos^2 g), the E-vector along sun x view, without s3.
///
/// With turbidity 0 light is scattered once: radiance * 3/4 (1 + cos^2 g) over the whole sphere, below the
/// horizon too.
///
/// With a turbidity of 1.7 (very clear) to 10 (hazy) brightness and, in three channels, colour follow Perez's
/// formula, mean luminance over the upper half 1, times radiance. Below the horizon is an unpolarized, uniform
/// ground that reflects ground_albedo of each channel's irradiance. The sun must not be below the horizon.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_sky {
    pub struct_size: u32,
    pub dop_max: f32,
    pub sun_direction: [f32; 3],
    pub radiance: nicol_spectrum,
    pub turbidity: f32,
    pub ground_albedo: f32,
}
impl Default for nicol_sky {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made.dop_max = 0.8;
        made.sun_direction = [0.0, 1.0, 0.0];
        made.ground_albedo = 0.2;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_sky>() == 96);
    assert!(offset_of!(nicol_sky, struct_size) == 0);
    assert!(offset_of!(nicol_sky, dop_max) == 4);
    assert!(offset_of!(nicol_sky, sun_direction) == 8);
    assert!(offset_of!(nicol_sky, radiance) == 20);
    assert!(offset_of!(nicol_sky, turbidity) == 88);
    assert!(offset_of!(nicol_sky, ground_albedo) == 92);
};

#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_environment_load_options {
    pub struct_size: u32,
    pub reserved: u32,
    pub scale: f64,
    pub wavelengths: nicol_spectrum,
}
impl Default for nicol_environment_load_options {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made.scale = 1.0;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_environment_load_options>() == 88);
    assert!(offset_of!(nicol_environment_load_options, struct_size) == 0);
    assert!(offset_of!(nicol_environment_load_options, reserved) == 4);
    assert!(offset_of!(nicol_environment_load_options, scale) == 8);
    assert!(offset_of!(nicol_environment_load_options, wavelengths) == 16);
};

#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_environment_info {
    pub struct_size: u32,
    pub channels: u32,
    pub polarized: u32,
    pub circular: u32,
    pub wavelength_count: u32,
    pub reserved: u32,
    pub wavelengths: [f64; 16],
}
impl Default for nicol_environment_info {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_environment_info>() == 152);
    assert!(offset_of!(nicol_environment_info, struct_size) == 0);
    assert!(offset_of!(nicol_environment_info, channels) == 4);
    assert!(offset_of!(nicol_environment_info, polarized) == 8);
    assert!(offset_of!(nicol_environment_info, circular) == 12);
    assert!(offset_of!(nicol_environment_info, wavelength_count) == 16);
    assert!(offset_of!(nicol_environment_info, reserved) == 20);
    assert!(offset_of!(nicol_environment_info, wavelengths) == 24);
};
pub type nicol_texture_filter = u32;
pub type nicol_texture_wrap = u32;
pub type nicol_texel = u32;

#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_texture_image {
    pub struct_size: u32,
    pub r#type: nicol_texel,
    pub width: u32,
    pub height: u32,
    pub channels: u32,
    pub reserved: u32,
    pub pixels: *const c_void,
    pub row_stride: u64,
    pub byte_size: u64,
}
impl Default for nicol_texture_image {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_texture_image>() == 48);
    assert!(offset_of!(nicol_texture_image, struct_size) == 0);
    assert!(offset_of!(nicol_texture_image, r#type) == 4);
    assert!(offset_of!(nicol_texture_image, width) == 8);
    assert!(offset_of!(nicol_texture_image, height) == 12);
    assert!(offset_of!(nicol_texture_image, channels) == 16);
    assert!(offset_of!(nicol_texture_image, reserved) == 20);
    assert!(offset_of!(nicol_texture_image, pixels) == 24);
    assert!(offset_of!(nicol_texture_image, row_stride) == 32);
    assert!(offset_of!(nicol_texture_image, byte_size) == 40);
};

#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_texture_options {
    pub struct_size: u32,
    pub filter: nicol_texture_filter,
    pub wrap: nicol_texture_wrap,
    pub raw: u32,
    pub to_uv: [f64; 9],
}
impl Default for nicol_texture_options {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made.filter = 1;
        made.to_uv = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_texture_options>() == 88);
    assert!(offset_of!(nicol_texture_options, struct_size) == 0);
    assert!(offset_of!(nicol_texture_options, filter) == 4);
    assert!(offset_of!(nicol_texture_options, wrap) == 8);
    assert!(offset_of!(nicol_texture_options, raw) == 12);
    assert!(offset_of!(nicol_texture_options, to_uv) == 16);
};
pub type nicol_distribution = u32;

/// Mitsuba 3's pplastic: rough Fresnel reflection over a diffuse base, both polarizing. Front side only.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_pplastic {
    pub struct_size: u32,
    pub distribution: nicol_distribution,
    pub diffuse_reflectance: nicol_spectrum,
    pub specular_reflectance: nicol_spectrum,
    pub int_ior: f32,
    pub ext_ior: f32,
    pub alpha: f32,
    pub reserved: u32,
    pub diffuse_reflectance_texture: nicol_texture,
    pub specular_reflectance_texture: nicol_texture,
    pub alpha_texture: nicol_texture,
}
impl Default for nicol_pplastic {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made.int_ior = 1.49;
        made.ext_ior = 1.000277;
        made.alpha = 0.1;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_pplastic>() == 184);
    assert!(offset_of!(nicol_pplastic, struct_size) == 0);
    assert!(offset_of!(nicol_pplastic, distribution) == 4);
    assert!(offset_of!(nicol_pplastic, diffuse_reflectance) == 8);
    assert!(offset_of!(nicol_pplastic, specular_reflectance) == 76);
    assert!(offset_of!(nicol_pplastic, int_ior) == 144);
    assert!(offset_of!(nicol_pplastic, ext_ior) == 148);
    assert!(offset_of!(nicol_pplastic, alpha) == 152);
    assert!(offset_of!(nicol_pplastic, reserved) == 156);
    assert!(offset_of!(nicol_pplastic, diffuse_reflectance_texture) == 160);
    assert!(offset_of!(nicol_pplastic, specular_reflectance_texture) == 168);
    assert!(offset_of!(nicol_pplastic, alpha_texture) == 176);
};

/// Mitsuba 3's plastic and roughplastic: Fresnel reflection over a diffuse base, both depolarizing;
/// nicol_pplastic is the model that polarizes. Front side only.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_plastic {
    pub struct_size: u32,
    pub distribution: nicol_distribution,
    pub diffuse_reflectance: nicol_spectrum,
    pub specular_reflectance: nicol_spectrum,
    pub int_ior: f32,
    pub ext_ior: f32,
    pub alpha: f32,
    pub nonlinear: u32,
    pub diffuse_reflectance_texture: nicol_texture,
    pub specular_reflectance_texture: nicol_texture,
    pub alpha_texture: nicol_texture,
}
impl Default for nicol_plastic {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made.int_ior = 1.49;
        made.ext_ior = 1.000277;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_plastic>() == 184);
    assert!(offset_of!(nicol_plastic, struct_size) == 0);
    assert!(offset_of!(nicol_plastic, distribution) == 4);
    assert!(offset_of!(nicol_plastic, diffuse_reflectance) == 8);
    assert!(offset_of!(nicol_plastic, specular_reflectance) == 76);
    assert!(offset_of!(nicol_plastic, int_ior) == 144);
    assert!(offset_of!(nicol_plastic, ext_ior) == 148);
    assert!(offset_of!(nicol_plastic, alpha) == 152);
    assert!(offset_of!(nicol_plastic, nonlinear) == 156);
    assert!(offset_of!(nicol_plastic, diffuse_reflectance_texture) == 160);
    assert!(offset_of!(nicol_plastic, specular_reflectance_texture) == 168);
    assert!(offset_of!(nicol_plastic, alpha_texture) == 176);
};

/// Mitsuba 3's principled, Disney's material, without what it transmits. It depolarizes. Front side only.
/// Numbers are 0 to 1, by default 0.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_principled {
    pub struct_size: u32,
    pub eta: f32,
    pub base_color: nicol_spectrum,
    pub roughness: f32,
    pub anisotropic: f32,
    pub metallic: f32,
    pub spec_trans: f32,
    pub spec_tint: f32,
    pub sheen: f32,
    pub sheen_tint: f32,
    pub flatness: f32,
    pub clearcoat: f32,
    pub clearcoat_gloss: f32,
    pub reserved: u32,
    pub base_color_texture: nicol_texture,
    pub roughness_texture: nicol_texture,
    pub anisotropic_texture: nicol_texture,
    pub metallic_texture: nicol_texture,
    pub spec_trans_texture: nicol_texture,
    pub spec_tint_texture: nicol_texture,
    pub sheen_texture: nicol_texture,
    pub sheen_tint_texture: nicol_texture,
    pub flatness_texture: nicol_texture,
    pub clearcoat_texture: nicol_texture,
    pub clearcoat_gloss_texture: nicol_texture,
}
impl Default for nicol_principled {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made.eta = 1.5;
        made.roughness = 0.5;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_principled>() == 208);
    assert!(offset_of!(nicol_principled, struct_size) == 0);
    assert!(offset_of!(nicol_principled, eta) == 4);
    assert!(offset_of!(nicol_principled, base_color) == 8);
    assert!(offset_of!(nicol_principled, roughness) == 76);
    assert!(offset_of!(nicol_principled, anisotropic) == 80);
    assert!(offset_of!(nicol_principled, metallic) == 84);
    assert!(offset_of!(nicol_principled, spec_trans) == 88);
    assert!(offset_of!(nicol_principled, spec_tint) == 92);
    assert!(offset_of!(nicol_principled, sheen) == 96);
    assert!(offset_of!(nicol_principled, sheen_tint) == 100);
    assert!(offset_of!(nicol_principled, flatness) == 104);
    assert!(offset_of!(nicol_principled, clearcoat) == 108);
    assert!(offset_of!(nicol_principled, clearcoat_gloss) == 112);
    assert!(offset_of!(nicol_principled, reserved) == 116);
    assert!(offset_of!(nicol_principled, base_color_texture) == 120);
    assert!(offset_of!(nicol_principled, roughness_texture) == 128);
    assert!(offset_of!(nicol_principled, anisotropic_texture) == 136);
    assert!(offset_of!(nicol_principled, metallic_texture) == 144);
    assert!(offset_of!(nicol_principled, spec_trans_texture) == 152);
    assert!(offset_of!(nicol_principled, spec_tint_texture) == 160);
    assert!(offset_of!(nicol_principled, sheen_texture) == 168);
    assert!(offset_of!(nicol_principled, sheen_tint_texture) == 176);
    assert!(offset_of!(nicol_principled, flatness_texture) == 184);
    assert!(offset_of!(nicol_principled, clearcoat_texture) == 192);
    assert!(offset_of!(nicol_principled, clearcoat_gloss_texture) == 200);
};

/// Mitsuba 3's conductor and roughconductor: single reflection off the facets of an opaque metal. The complex
/// index is eta - i k, relative to air. With k 0 and eta the index of a dielectric it is what the surface of
/// that reflects, as of glass whose inside is not seen. Front side only.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_conductor {
    pub struct_size: u32,
    pub distribution: nicol_distribution,
    pub alpha: f32,
    pub reserved: u32,
    pub metal: *const c_char,
    pub eta: nicol_spectrum,
    pub k: nicol_spectrum,
    pub wavelengths: nicol_spectrum,
    pub specular_reflectance: nicol_spectrum,
    pub specular_reflectance_texture: nicol_texture,
    pub alpha_texture: nicol_texture,
    pub alpha_u: f32,
    pub alpha_v: f32,
    pub alpha_u_texture: nicol_texture,
    pub alpha_v_texture: nicol_texture,
}
impl Default for nicol_conductor {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_conductor>() == 336);
    assert!(offset_of!(nicol_conductor, struct_size) == 0);
    assert!(offset_of!(nicol_conductor, distribution) == 4);
    assert!(offset_of!(nicol_conductor, alpha) == 8);
    assert!(offset_of!(nicol_conductor, reserved) == 12);
    assert!(offset_of!(nicol_conductor, metal) == 16);
    assert!(offset_of!(nicol_conductor, eta) == 24);
    assert!(offset_of!(nicol_conductor, k) == 92);
    assert!(offset_of!(nicol_conductor, wavelengths) == 160);
    assert!(offset_of!(nicol_conductor, specular_reflectance) == 228);
    assert!(offset_of!(nicol_conductor, specular_reflectance_texture) == 296);
    assert!(offset_of!(nicol_conductor, alpha_texture) == 304);
    assert!(offset_of!(nicol_conductor, alpha_u) == 312);
    assert!(offset_of!(nicol_conductor, alpha_v) == 316);
    assert!(offset_of!(nicol_conductor, alpha_u_texture) == 320);
    assert!(offset_of!(nicol_conductor, alpha_v_texture) == 328);
};
pub type nicol_wavelength_sampling = u32;

#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_measured {
    pub struct_size: u32,
    pub sampling: nicol_wavelength_sampling,
    pub wavelengths: nicol_spectrum,
    pub symmetrize: u32,
}
impl Default for nicol_measured {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_measured>() == 80);
    assert!(offset_of!(nicol_measured, struct_size) == 0);
    assert!(offset_of!(nicol_measured, sampling) == 4);
    assert!(offset_of!(nicol_measured, wavelengths) == 8);
    assert!(offset_of!(nicol_measured, symmetrize) == 76);
};

#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_psh_matrix {
    pub struct_size: u32,
    pub symmetrize: u32,
    pub scale: nicol_spectrum,
}
impl Default for nicol_psh_matrix {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_psh_matrix>() == 76);
    assert!(offset_of!(nicol_psh_matrix, struct_size) == 0);
    assert!(offset_of!(nicol_psh_matrix, symmetrize) == 4);
    assert!(offset_of!(nicol_psh_matrix, scale) == 8);
};

/// Writes the Mueller matrix of one colour channel, 16 row-major doubles, 1/sr and without the cosine, for
/// light from the direction `towards_light` into the direction `towards_viewer`: unit vectors in the surface's
/// frame, whose normal is z; both have z > 0. Both Stokes frames have x along the s-axis towards_light x
/// towards_viewer and z along the propagation, y = z cross x, as Fresnel's matrices do (where the directions
/// are equal, x is any perpendicular direction, the same for both). Return 1 to continue, 0 to end the call
/// that needs it with NICOL_ERROR_CANCELLED. It is called by nicol_material_create_callback and nicol_render,
/// on several threads at once, and must not call Nicol with objects of the material's context.
pub type nicol_mueller_callback = Option<unsafe extern "C" fn(user: *mut c_void, channel: u32, towards_light: *const [f64; 3], towards_viewer: *const [f64; 3], mueller: *mut [f64; 16]) -> i32>;

#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_callback_material {
    pub struct_size: u32,
    pub channels: u32,
    pub mueller: nicol_mueller_callback,
    pub user: *mut c_void,
    pub release: nicol_release_callback,
    pub lobe_width: f32,
    pub reserved: u32,
}
impl Default for nicol_callback_material {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made.channels = 1;
        made.lobe_width = 1.0;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_callback_material>() == 40);
    assert!(offset_of!(nicol_callback_material, struct_size) == 0);
    assert!(offset_of!(nicol_callback_material, channels) == 4);
    assert!(offset_of!(nicol_callback_material, mueller) == 8);
    assert!(offset_of!(nicol_callback_material, user) == 16);
    assert!(offset_of!(nicol_callback_material, release) == 24);
    assert!(offset_of!(nicol_callback_material, lobe_width) == 32);
    assert!(offset_of!(nicol_callback_material, reserved) == 36);
};

/// All numbers must be finite, indices valid. Triangles without area are left out, and logged once.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_mesh_data {
    pub struct_size: u32,
    pub vertex_count: u32,
    pub triangle_count: u32,
    pub texcoord_count: u32,
    pub positions: *const f32,
    pub normals: *const f32,
    pub indices: *const u32,
    pub texcoords: *const f32,
    pub texcoord_indices: *const u32,
    pub colors: *const f32,
    pub face_colors: *const f32,
}
impl Default for nicol_mesh_data {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_mesh_data>() == 72);
    assert!(offset_of!(nicol_mesh_data, struct_size) == 0);
    assert!(offset_of!(nicol_mesh_data, vertex_count) == 4);
    assert!(offset_of!(nicol_mesh_data, triangle_count) == 8);
    assert!(offset_of!(nicol_mesh_data, texcoord_count) == 12);
    assert!(offset_of!(nicol_mesh_data, positions) == 16);
    assert!(offset_of!(nicol_mesh_data, normals) == 24);
    assert!(offset_of!(nicol_mesh_data, indices) == 32);
    assert!(offset_of!(nicol_mesh_data, texcoords) == 40);
    assert!(offset_of!(nicol_mesh_data, texcoord_indices) == 48);
    assert!(offset_of!(nicol_mesh_data, colors) == 56);
    assert!(offset_of!(nicol_mesh_data, face_colors) == 64);
};
pub type nicol_projection = u32;

#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_camera {
    pub struct_size: u32,
    pub projection: nicol_projection,
    pub to_world: [f64; 16],
    pub fov: f64,
    pub near_clip: f64,
    pub far_clip: f64,
    pub jitter: [f64; 2],
    pub shift: [f64; 2],
}
impl Default for nicol_camera {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made.to_world = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];
        made.fov = 45.0;
        made.near_clip = 0.01;
        made.far_clip = 10000.0;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_camera>() == 192);
    assert!(offset_of!(nicol_camera, struct_size) == 0);
    assert!(offset_of!(nicol_camera, projection) == 4);
    assert!(offset_of!(nicol_camera, to_world) == 8);
    assert!(offset_of!(nicol_camera, fov) == 136);
    assert!(offset_of!(nicol_camera, near_clip) == 144);
    assert!(offset_of!(nicol_camera, far_clip) == 152);
    assert!(offset_of!(nicol_camera, jitter) == 160);
    assert!(offset_of!(nicol_camera, shift) == 176);
};

/// How what a light emits is polarized, all of it the same. Its frame, seen by who looks into the light:
///
///  y|  / E-vector
///   | /    z  comes towards the viewer, along the light
///   |/     x  is the part of axis across z (of an axis along z, the direction of growing angle from the light's own +z)
///   +---x  y  = z cross x; the AoLP counts from x to y, counter-clockwise
///
/// A sheet polarizer before the light that absorbs along `axis` is dolp 1 and aolp pi / 2, seen from anywhere; a
/// quarter-wave plate behind it docp 1 or -1.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_polarization {
    pub dolp: f64,
    pub aolp: f64,
    pub docp: f64,
    pub axis: [f64; 3],
}
impl Default for nicol_polarization {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.axis = [1.0, 0.0, 0.0];
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_polarization>() == 48);
    assert!(offset_of!(nicol_polarization, dolp) == 0);
    assert!(offset_of!(nicol_polarization, aolp) == 8);
    assert!(offset_of!(nicol_polarization, docp) == 16);
    assert!(offset_of!(nicol_polarization, axis) == 24);
};
pub type nicol_light_kind = u32;

/// A light without a surface, beside the environment. In its own axes it emits light along +z, from the origin
/// where it has a place; +y is up and +x to the left of who looks along +z, as of cameras. Fields of other
/// kinds have no effect.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_light {
    pub struct_size: u32,
    pub kind: nicol_light_kind,
    pub value: nicol_spectrum,
    pub reserved: u32,
    pub to_world: [f64; 16],
    pub angular_radius: f64,
    pub cutoff_angle: f64,
    pub beam_width: f64,
    pub fov: f64,
    pub aspect: f64,
    pub texture: nicol_texture,
    pub polarization: nicol_polarization,
}
impl Default for nicol_light {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made.kind = 1;
        made.to_world = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];
        made.cutoff_angle = 20.0;
        made.beam_width = 15.0;
        made.fov = 45.0;
        made.aspect = 1.0;
        made.polarization = nicol_polarization::default();
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_light>() == 304);
    assert!(offset_of!(nicol_light, struct_size) == 0);
    assert!(offset_of!(nicol_light, kind) == 4);
    assert!(offset_of!(nicol_light, value) == 8);
    assert!(offset_of!(nicol_light, reserved) == 76);
    assert!(offset_of!(nicol_light, to_world) == 80);
    assert!(offset_of!(nicol_light, angular_radius) == 208);
    assert!(offset_of!(nicol_light, cutoff_angle) == 216);
    assert!(offset_of!(nicol_light, beam_width) == 224);
    assert!(offset_of!(nicol_light, fov) == 232);
    assert!(offset_of!(nicol_light, aspect) == 240);
    assert!(offset_of!(nicol_light, texture) == 248);
    assert!(offset_of!(nicol_light, polarization) == 256);
};

/// What an instance emits, beside what it reflects.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_emission {
    pub struct_size: u32,
    pub two_sided: u32,
    pub radiance: nicol_spectrum,
    pub reserved: u32,
    pub texture: nicol_texture,
    pub polarization: nicol_polarization,
}
impl Default for nicol_emission {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made.polarization = nicol_polarization::default();
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_emission>() == 136);
    assert!(offset_of!(nicol_emission, struct_size) == 0);
    assert!(offset_of!(nicol_emission, two_sided) == 4);
    assert!(offset_of!(nicol_emission, radiance) == 8);
    assert!(offset_of!(nicol_emission, reserved) == 76);
    assert!(offset_of!(nicol_emission, texture) == 80);
    assert!(offset_of!(nicol_emission, polarization) == 88);
};
pub type nicol_polarization_element_kind = u32;
pub type nicol_polarization_element_outline = u32;

/// An ideal, infinitely thin sheet. The camera sees what is behind it through its Mueller matrix; several along a ray
/// act in their order. It casts no shadow, and light passes it unchanged on its way to surfaces.
/// In its own axes it lies in the plane z = 0 about the origin; light passes both ways alike.
///
///   y
///   |  / axis   x  is where to_world takes the element's x, z its normal, and y = z cross x
///   | /) angle
///   +------x
///
/// Light at an angle to the normal is treated as by Mitsuba 3: a polarizer absorbs along what is across the ray of the
/// direction that it absorbs, retardance is times the cosine of that angle. A fast axis is what is across the ray of it,
/// where Mitsuba 3.9 rotates it with the tilt.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_polarization_element {
    pub struct_size: u32,
    pub kind: nicol_polarization_element_kind,
    pub outline: nicol_polarization_element_outline,
    pub reserved: u32,
    pub to_world: [f64; 16],
    pub angle: f64,
    pub retardance: f64,
    pub transmittance: f64,
}
impl Default for nicol_polarization_element {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made.to_world = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];
        made.retardance = 90.0;
        made.transmittance = 1.0;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_polarization_element>() == 168);
    assert!(offset_of!(nicol_polarization_element, struct_size) == 0);
    assert!(offset_of!(nicol_polarization_element, kind) == 4);
    assert!(offset_of!(nicol_polarization_element, outline) == 8);
    assert!(offset_of!(nicol_polarization_element, reserved) == 12);
    assert!(offset_of!(nicol_polarization_element, to_world) == 16);
    assert!(offset_of!(nicol_polarization_element, angle) == 144);
    assert!(offset_of!(nicol_polarization_element, retardance) == 152);
    assert!(offset_of!(nicol_polarization_element, transmittance) == 160);
};

#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_instance {
    pub struct_size: u32,
    pub reserved: u32,
    pub mesh: nicol_mesh,
    pub material: nicol_material,
    pub to_world: [f64; 16],
}
impl Default for nicol_instance {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made.to_world = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_instance>() == 152);
    assert!(offset_of!(nicol_instance, struct_size) == 0);
    assert!(offset_of!(nicol_instance, reserved) == 4);
    assert!(offset_of!(nicol_instance, mesh) == 8);
    assert!(offset_of!(nicol_instance, material) == 16);
    assert!(offset_of!(nicol_instance, to_world) == 24);
};

#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_scene_file {
    pub struct_size: u32,
    pub reserved: u32,
    pub path: *const c_char,
    pub digest: *const c_char,
    pub bytes: u64,
}
impl Default for nicol_scene_file {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_scene_file>() == 32);
    assert!(offset_of!(nicol_scene_file, struct_size) == 0);
    assert!(offset_of!(nicol_scene_file, reserved) == 4);
    assert!(offset_of!(nicol_scene_file, path) == 8);
    assert!(offset_of!(nicol_scene_file, digest) == 16);
    assert!(offset_of!(nicol_scene_file, bytes) == 24);
};
pub type nicol_method = u32;
pub type nicol_high_orders = u32;
pub type nicol_shade_at = u32;
pub type nicol_executor = u32;
pub type nicol_components = u32;

#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_render_options {
    pub struct_size: u32,
    pub method: nicol_method,
    pub order_low: u32,
    pub order_high: u32,
    pub high_orders: nicol_high_orders,
    pub shadows: u32,
    pub bake_directions: u32,
    pub physical: u32,
    pub dering: f64,
    pub progress: nicol_progress_callback,
    pub progress_user: *mut c_void,
    pub samples: u32,
    pub executor: nicol_executor,
    pub seed: u64,
    pub tolerance: f64,
    pub components: nicol_components,
    pub disabled_optimisations: u32,
    pub high_order_shadows: u32,
    pub aovs: u32,
    pub shade_at: nicol_shade_at,
    pub pixel_samples: u32,
    pub refine_tolerance: f64,
    pub max_vertices: u64,
    pub split_lights: i32,
    pub light_samples: u32,
}
impl Default for nicol_render_options {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made.order_low = 4294967295;
        made.order_high = 4294967295;
        made.shadows = 1;
        made.physical = 1;
        made.samples = 256;
        made.tolerance = 0.03;
        made.high_order_shadows = 1;
        made.refine_tolerance = 0.02;
        made.split_lights = -1;
        made.light_samples = 16;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_render_options>() == 128);
    assert!(offset_of!(nicol_render_options, struct_size) == 0);
    assert!(offset_of!(nicol_render_options, method) == 4);
    assert!(offset_of!(nicol_render_options, order_low) == 8);
    assert!(offset_of!(nicol_render_options, order_high) == 12);
    assert!(offset_of!(nicol_render_options, high_orders) == 16);
    assert!(offset_of!(nicol_render_options, shadows) == 20);
    assert!(offset_of!(nicol_render_options, bake_directions) == 24);
    assert!(offset_of!(nicol_render_options, physical) == 28);
    assert!(offset_of!(nicol_render_options, dering) == 32);
    assert!(offset_of!(nicol_render_options, progress) == 40);
    assert!(offset_of!(nicol_render_options, progress_user) == 48);
    assert!(offset_of!(nicol_render_options, samples) == 56);
    assert!(offset_of!(nicol_render_options, executor) == 60);
    assert!(offset_of!(nicol_render_options, seed) == 64);
    assert!(offset_of!(nicol_render_options, tolerance) == 72);
    assert!(offset_of!(nicol_render_options, components) == 80);
    assert!(offset_of!(nicol_render_options, disabled_optimisations) == 84);
    assert!(offset_of!(nicol_render_options, high_order_shadows) == 88);
    assert!(offset_of!(nicol_render_options, aovs) == 92);
    assert!(offset_of!(nicol_render_options, shade_at) == 96);
    assert!(offset_of!(nicol_render_options, pixel_samples) == 100);
    assert!(offset_of!(nicol_render_options, refine_tolerance) == 104);
    assert!(offset_of!(nicol_render_options, max_vertices) == 112);
    assert!(offset_of!(nicol_render_options, split_lights) == 120);
    assert!(offset_of!(nicol_render_options, light_samples) == 124);
};

#[repr(C)]
pub struct nicol_job_impl {
    _private: [u8; 0],
}
/// An asynchronous render. Jobs of one context run one after another, in the order of submission, on a thread
/// of the context. A running job locks the context: calls that render, create, read and write its framebuffers
/// wait for it, but not for queued jobs. Calls that change or query scenes or make lights, materials and
/// meshes do not wait. May be used from any thread; nicol_job_poll and nicol_job_cancel from callbacks too.
/// What is different inside a host's OpenGL is told there.
pub type nicol_job = *mut nicol_job_impl;
pub type nicol_job_state = u32;

#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_job_status {
    pub struct_size: u32,
    pub state: nicol_job_state,
    pub result: nicol_result,
    pub reserved: u32,
    pub fraction: f64,
    pub verb: *const c_char,
}
impl Default for nicol_job_status {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_job_status>() == 32);
    assert!(offset_of!(nicol_job_status, struct_size) == 0);
    assert!(offset_of!(nicol_job_status, state) == 4);
    assert!(offset_of!(nicol_job_status, result) == 8);
    assert!(offset_of!(nicol_job_status, reserved) == 12);
    assert!(offset_of!(nicol_job_status, fraction) == 16);
    assert!(offset_of!(nicol_job_status, verb) == 24);
};

/// Statistics of the last render into a framebuffer. Milliseconds are 0 for verbs that did not run.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_statistics {
    pub struct_size: u32,
    pub order: u32,
    pub vertices: u64,
    pub triangles: u64,
    pub project_ms: f64,
    pub bake_ms: f64,
    pub relight_ms: f64,
    pub shade_ms: f64,
    pub draw_ms: f64,
    pub observe_ms: f64,
    pub bake_trace_ms: f64,
    pub bake_rays: u64,
    pub vertices_skipped: u64,
    pub vertices_unoccluded: u64,
    pub vertices_unphysical: u64,
    pub light_columns_skipped: u64,
    pub response_rows_skipped: u64,
    pub channels_shared: u64,
    pub response_bytes: u64,
    pub visibility_bytes: u64,
    pub transfer_bytes: u64,
    pub buffer_bytes: u64,
    pub texture_bytes: u64,
    pub camera_rays: u64,
    pub shadow_rays: u64,
    pub trace_ms: f64,
    pub compute: u32,
    pub order_low: u32,
    pub predicted_error: f64,
    pub lights_projected: u64,
    pub materials_projected: u64,
    pub vertices_traced: u64,
    pub matrices_baked: u64,
    pub vertices_relit: u64,
    pub vertices_shaded: u64,
    pub pixels_shaded: u64,
    pub vertices_added: u64,
    pub local_lights: u64,
    pub lights_split: u64,
    pub light_rays: u64,
    pub light_ms: f64,
}
impl Default for nicol_statistics {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_statistics>() == 312);
    assert!(offset_of!(nicol_statistics, struct_size) == 0);
    assert!(offset_of!(nicol_statistics, order) == 4);
    assert!(offset_of!(nicol_statistics, vertices) == 8);
    assert!(offset_of!(nicol_statistics, triangles) == 16);
    assert!(offset_of!(nicol_statistics, project_ms) == 24);
    assert!(offset_of!(nicol_statistics, bake_ms) == 32);
    assert!(offset_of!(nicol_statistics, relight_ms) == 40);
    assert!(offset_of!(nicol_statistics, shade_ms) == 48);
    assert!(offset_of!(nicol_statistics, draw_ms) == 56);
    assert!(offset_of!(nicol_statistics, observe_ms) == 64);
    assert!(offset_of!(nicol_statistics, bake_trace_ms) == 72);
    assert!(offset_of!(nicol_statistics, bake_rays) == 80);
    assert!(offset_of!(nicol_statistics, vertices_skipped) == 88);
    assert!(offset_of!(nicol_statistics, vertices_unoccluded) == 96);
    assert!(offset_of!(nicol_statistics, vertices_unphysical) == 104);
    assert!(offset_of!(nicol_statistics, light_columns_skipped) == 112);
    assert!(offset_of!(nicol_statistics, response_rows_skipped) == 120);
    assert!(offset_of!(nicol_statistics, channels_shared) == 128);
    assert!(offset_of!(nicol_statistics, response_bytes) == 136);
    assert!(offset_of!(nicol_statistics, visibility_bytes) == 144);
    assert!(offset_of!(nicol_statistics, transfer_bytes) == 152);
    assert!(offset_of!(nicol_statistics, buffer_bytes) == 160);
    assert!(offset_of!(nicol_statistics, texture_bytes) == 168);
    assert!(offset_of!(nicol_statistics, camera_rays) == 176);
    assert!(offset_of!(nicol_statistics, shadow_rays) == 184);
    assert!(offset_of!(nicol_statistics, trace_ms) == 192);
    assert!(offset_of!(nicol_statistics, compute) == 200);
    assert!(offset_of!(nicol_statistics, order_low) == 204);
    assert!(offset_of!(nicol_statistics, predicted_error) == 208);
    assert!(offset_of!(nicol_statistics, lights_projected) == 216);
    assert!(offset_of!(nicol_statistics, materials_projected) == 224);
    assert!(offset_of!(nicol_statistics, vertices_traced) == 232);
    assert!(offset_of!(nicol_statistics, matrices_baked) == 240);
    assert!(offset_of!(nicol_statistics, vertices_relit) == 248);
    assert!(offset_of!(nicol_statistics, vertices_shaded) == 256);
    assert!(offset_of!(nicol_statistics, pixels_shaded) == 264);
    assert!(offset_of!(nicol_statistics, vertices_added) == 272);
    assert!(offset_of!(nicol_statistics, local_lights) == 280);
    assert!(offset_of!(nicol_statistics, lights_split) == 288);
    assert!(offset_of!(nicol_statistics, light_rays) == 296);
    assert!(offset_of!(nicol_statistics, light_ms) == 304);
};
pub type nicol_plane = u32;
pub type nicol_format = u32;

#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_plane_buffer {
    pub struct_size: u32,
    pub plane: nicol_plane,
    pub format: nicol_format,
    pub channel: u32,
    pub pixels: *mut c_void,
    pub row_stride: u64,
    pub byte_size: u64,
}
impl Default for nicol_plane_buffer {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_plane_buffer>() == 40);
    assert!(offset_of!(nicol_plane_buffer, struct_size) == 0);
    assert!(offset_of!(nicol_plane_buffer, plane) == 4);
    assert!(offset_of!(nicol_plane_buffer, format) == 8);
    assert!(offset_of!(nicol_plane_buffer, channel) == 12);
    assert!(offset_of!(nicol_plane_buffer, pixels) == 16);
    assert!(offset_of!(nicol_plane_buffer, row_stride) == 24);
    assert!(offset_of!(nicol_plane_buffer, byte_size) == 32);
};
pub type nicol_observation_kind = u32;

#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_observation {
    pub struct_size: u32,
    pub kind: nicol_observation_kind,
    pub exposure: f32,
    pub scale: f32,
    pub polarizer_angle: f32,
}
impl Default for nicol_observation {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_observation>() == 20);
    assert!(offset_of!(nicol_observation, struct_size) == 0);
    assert!(offset_of!(nicol_observation, kind) == 4);
    assert!(offset_of!(nicol_observation, exposure) == 8);
    assert!(offset_of!(nicol_observation, scale) == 12);
    assert!(offset_of!(nicol_observation, polarizer_angle) == 16);
};

/// The address of an OpenGL function by its name, as from SDL_GL_GetProcAddress, eglGetProcAddress and others.
pub type nicol_get_proc_address_callback = Option<unsafe extern "C" fn(user: *mut c_void, name: *const c_char) -> *mut c_void>;

/// Returns 1 if the host's context is current on the calling thread, else 0.
pub type nicol_is_current_callback = Option<unsafe extern "C" fn(user: *mut c_void) -> i32>;

#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_host {
    pub struct_size: u32,
    pub reserved: u32,
    pub get_proc_address: nicol_get_proc_address_callback,
    pub is_current: nicol_is_current_callback,
    pub user: *mut c_void,
}
impl Default for nicol_host {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_host>() == 32);
    assert!(offset_of!(nicol_host, struct_size) == 0);
    assert!(offset_of!(nicol_host, reserved) == 4);
    assert!(offset_of!(nicol_host, get_proc_address) == 8);
    assert!(offset_of!(nicol_host, is_current) == 16);
    assert!(offset_of!(nicol_host, user) == 24);
};

#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_gl_texture {
    pub struct_size: u32,
    pub name: u32,
    pub target: u32,
    pub internal_format: u32,
    pub width: u32,
    pub height: u32,
}
impl Default for nicol_gl_texture {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_gl_texture>() == 24);
    assert!(offset_of!(nicol_gl_texture, struct_size) == 0);
    assert!(offset_of!(nicol_gl_texture, name) == 4);
    assert!(offset_of!(nicol_gl_texture, target) == 8);
    assert!(offset_of!(nicol_gl_texture, internal_format) == 12);
    assert!(offset_of!(nicol_gl_texture, width) == 16);
    assert!(offset_of!(nicol_gl_texture, height) == 20);
};
pub type nicol_encoding = u32;

/// A texture of the host's to draw into: level 0 of a GL_TEXTURE_2D of GL_RGBA8, GL_SRGB8_ALPHA8, GL_RGBA16F
/// or GL_RGBA32F, as large as the framebuffer.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_texture_target {
    pub struct_size: u32,
    pub texture: u32,
    pub bottom_up: u32,
    pub encoding: nicol_encoding,
}
impl Default for nicol_texture_target {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_texture_target>() == 16);
    assert!(offset_of!(nicol_texture_target, struct_size) == 0);
    assert!(offset_of!(nicol_texture_target, texture) == 4);
    assert!(offset_of!(nicol_texture_target, bottom_up) == 8);
    assert!(offset_of!(nicol_texture_target, encoding) == 12);
};
pub type nicol_psh_grid = u32;

#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_psh_sampling {
    pub struct_size: u32,
    pub grid: nicol_psh_grid,
    pub order: u32,
    pub rows: u32,
    pub columns: u32,
    pub reserved: u32,
    pub phi0: f64,
}
impl Default for nicol_psh_sampling {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_psh_sampling>() == 32);
    assert!(offset_of!(nicol_psh_sampling, struct_size) == 0);
    assert!(offset_of!(nicol_psh_sampling, grid) == 4);
    assert!(offset_of!(nicol_psh_sampling, order) == 8);
    assert!(offset_of!(nicol_psh_sampling, rows) == 12);
    assert!(offset_of!(nicol_psh_sampling, columns) == 16);
    assert!(offset_of!(nicol_psh_sampling, reserved) == 20);
    assert!(offset_of!(nicol_psh_sampling, phi0) == 24);
};

#[repr(C)]
pub struct nicol_psh_transform_impl {
    _private: [u8; 0],
}
/// Between samples [vector][row][column][4], north to south, and coefficients, in O(order^3). Needs no
/// context; holds its work space: after creation no call allocates. Calls on one transform are serialised.
pub type nicol_psh_transform = *mut nicol_psh_transform_impl;

/// Writes the Mueller matrix from the theta-phi frame of the propagation direction `in` to that of `out`,
/// cosine factors included (Eq. 38). Return 1 to continue, 0 to stop with NICOL_ERROR_CANCELLED. Called on the
/// calling thread. It may call Nicol.
pub type nicol_psh_mueller_callback = Option<unsafe extern "C" fn(user: *mut c_void, r#in: *const [f64; 3], out: *const [f64; 3], mueller: *mut [f64; 16]) -> i32>;

#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_psh_mueller_field {
    pub struct_size: u32,
    pub isotropic: u32,
    pub order_out: u32,
    pub order_in: u32,
    pub rows_out: u32,
    pub columns_out: u32,
    pub rows_in: u32,
    pub columns_in: u32,
    pub callback: nicol_psh_mueller_callback,
    pub user: *mut c_void,
}
impl Default for nicol_psh_mueller_field {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_psh_mueller_field>() == 48);
    assert!(offset_of!(nicol_psh_mueller_field, struct_size) == 0);
    assert!(offset_of!(nicol_psh_mueller_field, isotropic) == 4);
    assert!(offset_of!(nicol_psh_mueller_field, order_out) == 8);
    assert!(offset_of!(nicol_psh_mueller_field, order_in) == 12);
    assert!(offset_of!(nicol_psh_mueller_field, rows_out) == 16);
    assert!(offset_of!(nicol_psh_mueller_field, columns_out) == 20);
    assert!(offset_of!(nicol_psh_mueller_field, rows_in) == 24);
    assert!(offset_of!(nicol_psh_mueller_field, columns_in) == 28);
    assert!(offset_of!(nicol_psh_mueller_field, callback) == 32);
    assert!(offset_of!(nicol_psh_mueller_field, user) == 40);
};

/// Writes the Mueller matrix at the angle theta between input and output direction, frames with x along the
/// great circle, from input to output at both ends (Eq. 62). Returns as nicol_psh_mueller_callback.
pub type nicol_psh_kernel_callback = Option<unsafe extern "C" fn(user: *mut c_void, theta: f64, mueller: *mut [f64; 16]) -> i32>;
pub type nicol_file_kind = u32;

#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_file_options {
    pub struct_size: u32,
    pub order: u32,
    pub width: u32,
    pub height: u32,
    pub edge: u32,
    pub flags: u32,
    pub scale: f64,
    pub rotation: [f64; 9],
    pub wavelengths: nicol_spectrum,
    pub reserved: u32,
}
impl Default for nicol_file_options {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made.order = 4294967295;
        made.scale = 1.0;
        made.rotation = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_file_options>() == 176);
    assert!(offset_of!(nicol_file_options, struct_size) == 0);
    assert!(offset_of!(nicol_file_options, order) == 4);
    assert!(offset_of!(nicol_file_options, width) == 8);
    assert!(offset_of!(nicol_file_options, height) == 12);
    assert!(offset_of!(nicol_file_options, edge) == 16);
    assert!(offset_of!(nicol_file_options, flags) == 20);
    assert!(offset_of!(nicol_file_options, scale) == 24);
    assert!(offset_of!(nicol_file_options, rotation) == 32);
    assert!(offset_of!(nicol_file_options, wavelengths) == 104);
    assert!(offset_of!(nicol_file_options, reserved) == 172);
};

/// What a light is, by channel; means and parts are over the sphere by solid angle, of the image that would
/// be written.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_light_report {
    pub struct_size: u32,
    pub kind: nicol_file_kind,
    pub channels: u32,
    pub order: u32,
    pub width: u32,
    pub height: u32,
    pub polarized: u32,
    pub circular: u32,
    pub wavelengths: [f64; 16],
    pub mean: [f64; 16],
    pub smallest: [f64; 16],
    pub largest: [f64; 16],
    pub direction: [f64; 48],
    pub mean_dolp: [f64; 16],
    pub largest_dolp: [f64; 16],
    pub largest_circular: [f64; 16],
    pub unphysical: [f64; 16],
    pub largest_excess: [f64; 16],
}
impl Default for nicol_light_report {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_light_report>() == 1568);
    assert!(offset_of!(nicol_light_report, struct_size) == 0);
    assert!(offset_of!(nicol_light_report, kind) == 4);
    assert!(offset_of!(nicol_light_report, channels) == 8);
    assert!(offset_of!(nicol_light_report, order) == 12);
    assert!(offset_of!(nicol_light_report, width) == 16);
    assert!(offset_of!(nicol_light_report, height) == 20);
    assert!(offset_of!(nicol_light_report, polarized) == 24);
    assert!(offset_of!(nicol_light_report, circular) == 28);
    assert!(offset_of!(nicol_light_report, wavelengths) == 32);
    assert!(offset_of!(nicol_light_report, mean) == 160);
    assert!(offset_of!(nicol_light_report, smallest) == 288);
    assert!(offset_of!(nicol_light_report, largest) == 416);
    assert!(offset_of!(nicol_light_report, direction) == 544);
    assert!(offset_of!(nicol_light_report, mean_dolp) == 928);
    assert!(offset_of!(nicol_light_report, largest_dolp) == 1056);
    assert!(offset_of!(nicol_light_report, largest_circular) == 1184);
    assert!(offset_of!(nicol_light_report, unphysical) == 1312);
    assert!(offset_of!(nicol_light_report, largest_excess) == 1440);
};

/// What a material is, by channel, as far as coefficients up to `order` describe it.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_material_report {
    pub struct_size: u32,
    pub kind: nicol_file_kind,
    pub channels: u32,
    pub order: u32,
    pub file_order: u32,
    pub stokes_columns: u32,
    pub measured_wavelengths: u32,
    pub reserved: u32,
    pub measured_range: [f64; 2],
    pub wavelengths: [f64; 16],
    pub albedo: [f64; 16],
    pub largest_albedo: [f64; 16],
    pub norms: [f64; 144],
    pub asymmetry: [f64; 16],
    pub unphysical: [f64; 16],
    pub excess: [f64; 16],
}
impl Default for nicol_material_report {
    fn default() -> Self {
        // Zeros and null pointers are values of every field.
        let mut made: Self = unsafe { std::mem::zeroed() };
        made.struct_size = size_of::<Self>() as u32;
        made
    }
}
const _: () = {
    assert!(size_of::<nicol_material_report>() == 1968);
    assert!(offset_of!(nicol_material_report, struct_size) == 0);
    assert!(offset_of!(nicol_material_report, kind) == 4);
    assert!(offset_of!(nicol_material_report, channels) == 8);
    assert!(offset_of!(nicol_material_report, order) == 12);
    assert!(offset_of!(nicol_material_report, file_order) == 16);
    assert!(offset_of!(nicol_material_report, stokes_columns) == 20);
    assert!(offset_of!(nicol_material_report, measured_wavelengths) == 24);
    assert!(offset_of!(nicol_material_report, reserved) == 28);
    assert!(offset_of!(nicol_material_report, measured_range) == 32);
    assert!(offset_of!(nicol_material_report, wavelengths) == 48);
    assert!(offset_of!(nicol_material_report, albedo) == 176);
    assert!(offset_of!(nicol_material_report, largest_albedo) == 304);
    assert!(offset_of!(nicol_material_report, norms) == 432);
    assert!(offset_of!(nicol_material_report, asymmetry) == 1584);
    assert!(offset_of!(nicol_material_report, unphysical) == 1712);
    assert!(offset_of!(nicol_material_report, excess) == 1840);
};

extern "C" {
    /// Of the library that runs: major * 10000 + minor * 100 + patch.
    pub fn nicol_version() -> u32;
    /// "0.1.0"; lives as long as the library.
    pub fn nicol_version_string() -> *const c_char;
    /// Properties of this build as "key=value" (source, compiler, backends, methods, max_order, ...), index 0, 1,
    /// ...; NULL past the last one. Lives as long as the library.
    pub fn nicol_build_info(index: u32) -> *const c_char;
    /// The message of the last failed call on this thread: one line that names the file, line, field or argument
    /// and what is expected. Never NULL; "" before the first failure. Valid until this thread's next failed call.
    pub fn nicol_last_error() -> *const c_char;
    /// "out of memory" and the like for a code; lives as long as the library.
    pub fn nicol_result_name(result: nicol_result) -> *const c_char;
    /// The number of devices for nicol_context_options.device: those that EGL lists, in its order, which is
    /// neither CUDA's nor the kernel's. 0 if there is no EGL. The list may change when devices or drivers are
    /// added or removed.
    pub fn nicol_device_count(count: *mut u32) -> nicol_result;
    /// device from 1 to nicol_device_count's. No context is made, so that making one may still fail.
    pub fn nicol_device_get_info(device: u32, info: *mut nicol_device_info) -> nicol_result;
    /// options may be NULL: all defaults. NICOL_ERROR_NO_BACKEND if no such OpenGL context can be made.
    pub fn nicol_context_create(options: *const nicol_context_options, context: *mut nicol_context) -> nicol_result;
    pub fn nicol_context_retain(context: nicol_context) -> nicol_result;
    pub fn nicol_context_release(context: nicol_context) -> nicol_result;
    /// What was opened, and the limits that hold in it.
    pub fn nicol_context_get_info(context: nicol_context, info: *mut nicol_context_info) -> nicol_result;
    /// By the path:
    ///   NAME.exr      OpenEXR, equirectangular as nicol_image: R, G, B or Y are unpolarized light; S0.<colour> to
    ///                 S3.<colour> are polarized, in nicol_image's frames; spectral files (S0.550,000000nm and so on)
    ///                 have a channel a wavelength.
    ///   NAME_s0.exr   to NAME_s3.exr, any of them, or NAME alone: a cube map as a cross of 4 x 3 faces, a file for
    ///                 each Stokes component, as the Python package polarsh has them.
    ///   NAME.hdr      Radiance HDR; or NAME.png, .jpg, .bmp, .tga, whose colours are decoded from sRGB to 0 to 1: unpolarized
    ///                 light, equirectangular.
    ///   NAME.npz      PSH coefficients as polarsh writes them (SHVec).
    /// options may be NULL: all defaults.
    pub fn nicol_environment_load(context: nicol_context, path: *const c_char, options: *const nicol_environment_load_options, environment: *mut nicol_environment) -> nicol_result;
    /// From memory.
    pub fn nicol_environment_create_image(context: nicol_context, image: *const nicol_image, environment: *mut nicol_environment) -> nicol_result;
    /// Unpolarized and the same from all directions; radiance NULL or not given: 1 in one channel; finite, not
    /// negative.
    pub fn nicol_environment_create_constant(context: nicol_context, radiance: *const nicol_spectrum, environment: *mut nicol_environment) -> nicol_result;
    /// A clear sky, without its sun.
    pub fn nicol_environment_create_sky(context: nicol_context, sky: *const nicol_sky, environment: *mut nicol_environment) -> nicol_result;
    /// Light given by PSH coefficients over PROPAGATION directions in the world's axes, [channel][l*l + l + m][4]
    /// as nicol_psh.h says; order up to NICOL_PSH_MAX_ORDER (4096), channels 1 to NICOL_MAX_CHANNELS, count =
    /// channels * 4 (order+1)^2. p = 1, 2 below l = 2 must be 0. The light is band-limited: it may ring, with s0
    /// below 0 and more polarization than light.
    pub fn nicol_environment_create_psh(context: nicol_context, order: u32, channels: u32, coefficients: *const f64, count: u64, environment: *mut nicol_environment) -> nicol_result;
    /// Properties of the light.
    pub fn nicol_environment_get_info(environment: nicol_environment, info: *mut nicol_environment_info) -> nicol_result;
    pub fn nicol_environment_retain(environment: nicol_environment) -> nicol_result;
    pub fn nicol_environment_release(environment: nicol_environment) -> nicol_result;
    /// Copies the pixels. options may be NULL: all defaults.
    pub fn nicol_texture_create_image(context: nicol_context, image: *const nicol_texture_image, options: *const nicol_texture_options, texture: *mut nicol_texture) -> nicol_result;
    /// PNG, JPEG, BMP, TGA, Radiance HDR, or OpenEXR with R G B or Y; with A as coverage. options may be NULL: all
    /// defaults.
    pub fn nicol_texture_load(context: nicol_context, path: *const c_char, options: *const nicol_texture_options, texture: *mut nicol_texture) -> nicol_result;
    /// Mitsuba 3's checkerboard of colours: four squares a unit of u and v, color0 at u = v = 0. Colours of 1 or 3
    /// values; NULL or not given: 0.4 and 0.2. to_uv as of nicol_texture_options, NULL: identity.
    pub fn nicol_texture_create_checkerboard(context: nicol_context, color0: *const nicol_spectrum, color1: *const nicol_spectrum, to_uv: *const [f64; 9], texture: *mut nicol_texture) -> nicol_result;
    /// The colours of the mesh's vertices, interpolated.
    pub fn nicol_texture_create_vertex_colors(context: nicol_context, texture: *mut nicol_texture) -> nicol_result;
    /// The colours of the mesh's triangles. A material takes these or those of vertices, not both.
    pub fn nicol_texture_create_face_colors(context: nicol_context, texture: *mut nicol_texture) -> nicol_result;
    pub fn nicol_texture_retain(texture: nicol_texture) -> nicol_result;
    pub fn nicol_texture_release(texture: nicol_texture) -> nicol_result;
    /// NICOL_ERROR_INVALID_ARGUMENT names the field that is out of range.
    pub fn nicol_material_create_pplastic(context: nicol_context, parameters: *const nicol_pplastic, material: *mut nicol_material) -> nicol_result;
    /// Likewise.
    pub fn nicol_material_create_plastic(context: nicol_context, parameters: *const nicol_plastic, material: *mut nicol_material) -> nicol_result;
    /// Likewise; NICOL_ERROR_UNSUPPORTED for a tint of a mesh's colours.
    pub fn nicol_material_create_principled(context: nicol_context, parameters: *const nicol_principled, material: *mut nicol_material) -> nicol_result;
    /// Lambertian and depolarizing; reflectance NULL or not given: 0.5. Front side only.
    pub fn nicol_material_create_diffuse(context: nicol_context, reflectance: *const nicol_spectrum, material: *mut nicol_material) -> nicol_result;
    /// Likewise; a metal that is not known is refused with the names of those that are.
    pub fn nicol_material_create_conductor(context: nicol_context, parameters: *const nicol_conductor, material: *mut nicol_material) -> nicol_result;
    /// Mitsuba 3's measured_polarized: a .pbsdf file, as the KAIST data set has them. It is streamed: about 102 MB
    /// stay in memory for each channel at the data set's resolution, half of that where symmetrized. options may
    /// be NULL: all defaults. Front side only.
    pub fn nicol_material_load_measured(context: nicol_context, path: *const c_char, options: *const nicol_measured, material: *mut nicol_material) -> nicol_result;
    /// A PSH coefficient matrix a channel, cosine included, of an isotropic material: the .npz files of the Python
    /// package polarsh (SHMat in the layout ISOBI2). Light of orders above the matrix's is not reflected. options
    /// may be NULL: all defaults. Front side only.
    pub fn nicol_material_load_psh(context: nicol_context, path: *const c_char, options: *const nicol_psh_matrix, material: *mut nicol_material) -> nicol_result;
    /// The back of a surface reflects as its front. `front` may be released afterwards.
    pub fn nicol_material_create_twosided(context: nicol_context, front: nicol_material, material: *mut nicol_material) -> nicol_result;
    /// A material times a texture: a diffuse one of reflectance 1 then has the texture's colours. The handles
    /// given may be released afterwards, here and below.
    pub fn nicol_material_create_scaled(context: nicol_context, base: nicol_material, scale: nicol_texture, material: *mut nicol_material) -> nicol_result;
    /// first (1 - t) + second t, t the weight's first channel, moved to 0 to 1: Mitsuba 3's blendbsdf. Both must
    /// be two-sided, or neither.
    pub fn nicol_material_create_blend(context: nicol_context, first: nicol_material, second: nicol_material, weight: nicol_texture, material: *mut nicol_material) -> nicol_result;
    /// Shading normals 2 t - 1 in the frame of the surface, x along growing u: Mitsuba 3's normalmap. The texture
    /// is raw. y completes a right-handed frame; with mirrored_y 1 it points to where v falls, which differs where
    /// texture coordinates are mirrored, as in glTF.
    pub fn nicol_material_create_normal_map(context: nicol_context, base: nicol_material, normals: nicol_texture, mirrored_y: u32, material: *mut nicol_material) -> nicol_result;
    /// Shading normals of a surface that is displaced along its normal by scale times the texture's first channel,
    /// in the scene's units: Mitsuba 3's bumpmap.
    pub fn nicol_material_create_bump_map(context: nicol_context, base: nicol_material, heights: nicol_texture, scale: f64, material: *mut nicol_material) -> nicol_result;
    /// Cut out where the texture's coverage, or of fewer than four channels its first one, is below 0.5: Mitsuba
    /// 3's mask of opacities 0 and 1.
    pub fn nicol_material_create_mask(context: nicol_context, base: nicol_material, opacity: nicol_texture, material: *mut nicol_material) -> nicol_result;
    /// The function must be isotropic, mirror symmetric about every plane through the normal, and finite. It is
    /// tested at some directions and refused with NICOL_ERROR_INVALID_ARGUMENT otherwise. Front side only.
    pub fn nicol_material_create_callback(context: nicol_context, parameters: *const nicol_callback_material, material: *mut nicol_material) -> nicol_result;
    pub fn nicol_material_retain(material: nicol_material) -> nicol_result;
    pub fn nicol_material_release(material: nicol_material) -> nicol_result;
    /// OBJ, PLY, OFF, STL or the first mesh of Mitsuba's .serialized, by the file's suffix. Polygons may be
    /// concave. Triangles without area, vertices of no face and what is not followed (materials) are left out; one
    /// line of the log counts them. Texture coordinates and colours of vertices and faces are kept; v of OBJ,
    /// which points up there, becomes 1 - v. NICOL_ERROR_INVALID_FILE names the line, vertex or face.
    pub fn nicol_mesh_load(context: nicol_context, path: *const c_char, mesh: *mut nicol_mesh) -> nicol_result;
    /// Copies the arrays. A render adds vertices where shadows need them, see refine_tolerance.
    pub fn nicol_mesh_create(context: nicol_context, data: *const nicol_mesh_data, mesh: *mut nicol_mesh) -> nicol_result;
    /// The unit sphere, finely enough divided for per-vertex shading. Here and below texture coordinates are those
    /// of Mitsuba 3's shapes.
    pub fn nicol_mesh_create_sphere(context: nicol_context, mesh: *mut nicol_mesh) -> nicol_result;
    /// [-1, 1]^2 in the plane z = 0, facing +z.
    pub fn nicol_mesh_create_rectangle(context: nicol_context, mesh: *mut nicol_mesh) -> nicol_result;
    /// [-1, 1]^3.
    pub fn nicol_mesh_create_cube(context: nicol_context, mesh: *mut nicol_mesh) -> nicol_result;
    /// Radius 1 in the plane z = 0, facing +z: 128 sectors of 16 rings.
    pub fn nicol_mesh_create_disk(context: nicol_context, mesh: *mut nicol_mesh) -> nicol_result;
    /// Of this radius around the line from p0 to p1, in the scene's units, without its ends: 180 sides. The front
    /// is outside. radius is above 0, p0 and p1 must differ.
    pub fn nicol_mesh_create_cylinder(context: nicol_context, p0: *const [f64; 3], p1: *const [f64; 3], radius: f64, mesh: *mut nicol_mesh) -> nicol_result;
    /// Of its vertices and triangles.
    pub fn nicol_mesh_get_size(mesh: nicol_mesh, vertices: *mut u32, triangles: *mut u32) -> nicol_result;
    pub fn nicol_mesh_retain(mesh: nicol_mesh) -> nicol_result;
    pub fn nicol_mesh_release(mesh: nicol_mesh) -> nicol_result;
    /// A camera at `origin` that looks at `target`; sets to_world alone. `up` must not lie along the view.
    pub fn nicol_camera_look_at(camera: *mut nicol_camera, origin: *const [f64; 3], target: *const [f64; 3], up: *const [f64; 3]) -> nicol_result;
    /// Empty and dark.
    pub fn nicol_scene_create(context: nicol_context, scene: *mut nicol_scene) -> nicol_result;
    /// A Mitsuba 3 XML file, or glTF 2.0 where the name ends in .gltf or .glb (the subsets that
    /// samples/render/README.md lists); definitions are "name=value" strings that override <default>s of the XML.
    /// glTF has no environment, and may have lights. Lights of a file that polarization elements of it cover have
    /// the state and the brightness of their light behind these.
    pub fn nicol_scene_load(context: nicol_context, path: *const c_char, definitions: *const *const c_char, definition_count: u32, scene: *mut nicol_scene) -> nicol_result;
    /// id may be NULL; ids count up from 0, past those of removed instances too. A mesh must have the texture
    /// coordinates and colours that its material needs, here and in nicol_scene_set_material. Materials and
    /// environment must have one colour channel or the same number of them, here and in
    /// nicol_scene_set_environment.
    pub fn nicol_scene_add_instance(scene: nicol_scene, instance: *const nicol_instance, id: *mut u32) -> nicol_result;
    /// id as nicol_scene_add_instance gave it; to_world as nicol_instance's. The next render bakes again the
    /// vertices that the instance may shadow, before or now; a scene that rotates and moves as a whole is only
    /// relit.
    pub fn nicol_scene_set_transform(scene: nicol_scene, id: u32, to_world: *const [f64; 16]) -> nicol_result;
    /// The next render projects the material, if it is new to the scene, and shades its instance.
    pub fn nicol_scene_set_material(scene: nicol_scene, id: u32, material: nicol_material) -> nicol_result;
    /// Its id is not used again; the others keep theirs.
    pub fn nicol_scene_remove_instance(scene: nicol_scene, id: u32) -> nicol_result;
    /// The parts of an instance: mesh and material as handles to release. Each of the three may be NULL.
    pub fn nicol_scene_get_instance(scene: nicol_scene, id: u32, mesh: *mut nicol_mesh, material: *mut nicol_material, to_world: *mut [f64; 16]) -> nicol_result;
    pub fn nicol_scene_get_instance_count(scene: nicol_scene, instances: *mut u32) -> nicol_result;
    /// The ids of all instances, ascending; count: of the instances.
    pub fn nicol_scene_get_instance_ids(scene: nicol_scene, ids: *mut u32, count: u64) -> nicol_result;
    /// environment NULL: darkness. to_world rotates it (NULL: identity; must be a proper rotation), scale
    /// multiplies (1 leaves it; 0: darkness; finite, not negative).
    pub fn nicol_scene_set_environment(scene: nicol_scene, environment: nicol_environment, to_world: *const [f64; 16], scale: f64) -> nicol_result;
    /// The arguments of nicol_scene_set_environment: the environment, as a handle to release, its rotation and
    /// scale. to_world and scale may be NULL. In darkness, also that of a file's scale of 0, *environment is NULL,
    /// to_world the identity and scale 1.
    pub fn nicol_scene_get_environment(scene: nicol_scene, environment: *mut nicol_environment, to_world: *mut [f64; 16], scale: *mut f64) -> nicol_result;
    /// hide 1: no light goes straight to the camera from the environment, which leaves black (alpha 0), or from
    /// instances that emit, which show what they reflect alone; both light the scene as before. 0: they are seen,
    /// unless the scene's file has hide_emitters.
    pub fn nicol_scene_hide_emitters(scene: nicol_scene, hide: u32) -> nicol_result;
    /// Adds a light, with an id of its own: lights are counted from 0, apart from instances. id may be NULL. A
    /// light must have one colour channel or as many as the scene; so must what an instance emits. The handle of
    /// the texture may be released afterwards. NICOL_ERROR_INVALID_ARGUMENT names the field that is out of range,
    /// here and below.
    pub fn nicol_scene_add_light(scene: nicol_scene, light: *const nicol_light, id: *mut u32) -> nicol_result;
    /// All of the light of this id. The next render bakes nothing.
    pub fn nicol_scene_set_light(scene: nicol_scene, id: u32, light: *const nicol_light) -> nicol_result;
    /// Its id is not used again; the others keep theirs.
    pub fn nicol_scene_remove_light(scene: nicol_scene, id: u32) -> nicol_result;
    /// The light as it was given; its texture, as a handle to release, in *texture (NULL: it has none) and not in
    /// light->texture. texture may be NULL.
    pub fn nicol_scene_get_light(scene: nicol_scene, id: u32, light: *mut nicol_light, texture: *mut nicol_texture) -> nicol_result;
    pub fn nicol_scene_get_light_count(scene: nicol_scene, lights: *mut u32) -> nicol_result;
    /// The ids of all lights, ascending; count: of the lights.
    pub fn nicol_scene_get_light_ids(scene: nicol_scene, ids: *mut u32, count: u64) -> nicol_result;
    /// Makes an instance emit light, emission NULL: stop it. id is the instance's. A texture needs texture
    /// coordinates of the mesh.
    pub fn nicol_scene_set_emission(scene: nicol_scene, id: u32, emission: *const nicol_emission) -> nicol_result;
    /// What an instance emits, its texture as of nicol_scene_get_light. Of one that emits no light the radiance
    /// is 0.
    pub fn nicol_scene_get_emission(scene: nicol_scene, id: u32, emission: *mut nicol_emission, texture: *mut nicol_texture) -> nicol_result;
    /// Adds an element, with an id of its own: elements are counted from 0, apart from instances and lights. id
    /// may be NULL. NICOL_ERROR_INVALID_ARGUMENT names the field that is out of range.
    pub fn nicol_scene_add_polarization_element(scene: nicol_scene, element: *const nicol_polarization_element, id: *mut u32) -> nicol_result;
    /// All of the element of this id.
    pub fn nicol_scene_set_polarization_element(scene: nicol_scene, id: u32, element: *const nicol_polarization_element) -> nicol_result;
    /// Its id is not used again; the others keep theirs.
    pub fn nicol_scene_remove_polarization_element(scene: nicol_scene, id: u32) -> nicol_result;
    /// The element as it was given.
    pub fn nicol_scene_get_polarization_element(scene: nicol_scene, id: u32, element: *mut nicol_polarization_element) -> nicol_result;
    pub fn nicol_scene_get_polarization_element_count(scene: nicol_scene, elements: *mut u32) -> nicol_result;
    /// The ids of all elements, ascending; count: of the elements.
    pub fn nicol_scene_get_polarization_element_ids(scene: nicol_scene, ids: *mut u32, count: u64) -> nicol_result;
    /// The camera and film size of a loaded file, and the AOVs that its integrators ask for, a sum of
    /// NICOL_AOV_... for nicol_render_options; NICOL_ERROR_UNSUPPORTED for a scene that was not loaded.
    pub fn nicol_scene_get_camera(scene: nicol_scene, camera: *mut nicol_camera) -> nicol_result;
    pub fn nicol_scene_get_film_size(scene: nicol_scene, width: *mut u32, height: *mut u32) -> nicol_result;
    pub fn nicol_scene_get_aovs(scene: nicol_scene, aovs: *mut u32) -> nicol_result;
    /// The files that nicol_scene_load has read, each once: the scene file, those that it includes (of glTF, its
    /// buffers), then light, materials and meshes. With equal digests the scene is the same. None for a scene that
    /// was not loaded.
    pub fn nicol_scene_get_file_count(scene: nicol_scene, count: *mut u32) -> nicol_result;
    /// index from 0; beyond the last, NICOL_ERROR_INVALID_ARGUMENT
    pub fn nicol_scene_get_file(scene: nicol_scene, index: u32, file: *mut nicol_scene_file) -> nicol_result;
    /// Colour channels of its images: those of everything in it, 1 (all grey) or more, and 1 if the film of a
    /// loaded file is luminance.
    pub fn nicol_scene_get_channels(scene: nicol_scene, channels: *mut u32) -> nicol_result;
    pub fn nicol_scene_retain(scene: nicol_scene) -> nicol_result;
    pub fn nicol_scene_release(scene: nicol_scene) -> nicol_result;
    /// width, height: 1 to NICOL_MAX_SIZE (the driver may allow less), at most 2^26 pixels. channels: as the
    /// scene's, or 1 for the luminance of a scene of three: 0.2126 R + 0.7152 G + 0.0722 B of each Stokes
    /// component.
    pub fn nicol_framebuffer_create(context: nicol_context, width: u32, height: u32, channels: u32, framebuffer: *mut nicol_framebuffer) -> nicol_result;
    /// As it was created.
    pub fn nicol_framebuffer_get_size(framebuffer: nicol_framebuffer, width: *mut u32, height: *mut u32, channels: *mut u32) -> nicol_result;
    pub fn nicol_framebuffer_retain(framebuffer: nicol_framebuffer) -> nicol_result;
    pub fn nicol_framebuffer_release(framebuffer: nicol_framebuffer) -> nicol_result;
    /// options may be NULL: all defaults. Results that a change of the scene, the camera or the options does not
    /// affect are kept from the scene's last render; if nothing changed, nothing runs. On failure or cancellation
    /// the framebuffer keeps its content and statistics. NICOL_ERROR_INVALID_ARGUMENT for options and cameras out
    /// of range and channels that do not fit, NICOL_ERROR_UNSUPPORTED for an unknown method, for compute shaders
    /// if the driver lacks features, and, where a material varies by a texture, for the dense method and for
    /// shading at vertices, NICOL_ERROR_CANCELLED, NICOL_ERROR_OUT_OF_MEMORY.
    pub fn nicol_render(scene: nicol_scene, camera: *const nicol_camera, options: *const nicol_render_options, framebuffer: nicol_framebuffer) -> nicol_result;
    /// nicol_render as a job. Copies the scene's state: later changes affect later renders only. The framebuffer
    /// keeps its content until the job has run. Scene, framebuffer and all they need are kept alive; the caller
    /// may release them, and the job too, which runs all the same. The progress callback runs on the context's
    /// thread, and progress_user must live until the job is done. Invalid arguments are refused at once where
    /// possible; other errors are the job's result. NICOL_ERROR_BUSY if NICOL_MAX_JOBS are queued. A process that
    /// exits cancels its jobs.
    pub fn nicol_render_async(scene: nicol_scene, camera: *const nicol_camera, options: *const nicol_render_options, framebuffer: nicol_framebuffer, job: *mut nicol_job) -> nicol_result;
    /// The job's progress; never waits for it.
    pub fn nicol_job_poll(job: nicol_job, status: *mut nicol_job_status) -> nicol_result;
    /// Waits until the job is done, at most this long (0: not at all), and returns its result; after a failure
    /// nicol_last_error() has its message. NICOL_ERROR_TIMEOUT if it is not done by then, NICOL_ERROR_NOT_CURRENT
    /// where the job needs a host's OpenGL context that is not current on the calling thread.
    /// NICOL_ERROR_INVALID_ARGUMENT inside a callback of the context, which would be a deadlock.
    pub fn nicol_job_wait(job: nicol_job, timeout_ms: u32) -> nicol_result;
    /// Cancels a queued job at once, and a running one where it would next call a progress callback; its result is
    /// NICOL_ERROR_CANCELLED. No effect on a job that is done or almost done. Does not wait.
    pub fn nicol_job_cancel(job: nicol_job) -> nicol_result;
    pub fn nicol_job_retain(job: nicol_job) -> nicol_result;
    pub fn nicol_job_release(job: nicol_job) -> nicol_result;
    /// All zeros before the first render.
    pub fn nicol_framebuffer_get_statistics(framebuffer: nicol_framebuffer, statistics: *mut nicol_statistics) -> nicol_result;
    /// Copies one plane of one colour channel, first row at the top. row_stride in bytes, 0: tightly packed;
    /// byte_size is what pixels has room for. NICOL_ERROR_INVALID_ARGUMENT for a plane that is not there and for
    /// NICOL_PLANE_INSTANCE, which holds no floats.
    pub fn nicol_framebuffer_read(framebuffer: nicol_framebuffer, plane: nicol_plane, channel: u32, pixels: *mut f32, row_stride: u64, byte_size: u64) -> nicol_result;
    /// Copies a plane in the format and with the channels of `to`; bytes between rows are not written. A call that
    /// fails writes nothing.
    pub fn nicol_framebuffer_read_plane(framebuffer: nicol_framebuffer, to: *const nicol_plane_buffer) -> nicol_result;
    /// Channels of 32-bit floats, named by the number of colour channels:
    ///   3             R G B (which are s0) and S0.R S0.G S0.B to S3.R S3.G S3.B, as Mitsuba 3's stokes integrator
    ///   1             Y (which is s0) and S0.Y to S3.Y
    ///   2, 4 to 16    S0.0 S0.1 ... to S3.0 S3.1 ...
    /// and of the last render's AOVs Z (depth), N.X N.Y N.Z, P.X P.Y P.Z, id (32-bit unsigned), A (alpha; R G B still
    /// have the environment) and, of each Stokes channel, variance.S0.R ... variance.S3.B.
    pub fn nicol_framebuffer_write_exr(framebuffer: nicol_framebuffer, path: *const c_char) -> nicol_result;
    /// 8-bit RGB. S0 and POLARIZER need a framebuffer of 1 or 3 channels; the others show the mean of the
    /// channels.
    pub fn nicol_framebuffer_write_png(framebuffer: nicol_framebuffer, observation: *const nicol_observation, path: *const c_char) -> nicol_result;
    /// A context inside the one that is current: OpenGL 4.5 or newer, of the core or the compatibility profile.
    /// options as of nicol_context_create, backend and device 0. NICOL_ERROR_NOT_CURRENT if is_current returns 0,
    /// NICOL_ERROR_NO_BACKEND where there is no such OpenGL.
    pub fn nicol_context_create_host(host: *const nicol_host, options: *const nicol_context_options, context: *mut nicol_context) -> nicol_result;
    /// The texture of a colour channel: a texel is the Stokes vector (s0, s1, s2, s3), row 0 is the image's TOP.
    /// The name is valid, and stays the same, until the framebuffer is released; the content is that of the last
    /// render. It may be sampled, and its filters and wrap modes changed, but not its swizzle; it must neither be
    /// written nor deleted.
    /// NICOL_ERROR_UNSUPPORTED for a framebuffer whose context is not a host's, as for the functions below.
    pub fn nicol_framebuffer_get_texture(framebuffer: nicol_framebuffer, channel: u32, texture: *mut nicol_gl_texture) -> nicol_result;
    /// Copies the Stokes vectors of a channel. Nothing is read back.
    pub fn nicol_framebuffer_draw_stokes(framebuffer: nicol_framebuffer, channel: u32, target: *const nicol_texture_target) -> nicol_result;
    /// The image that nicol_framebuffer_write_png would write, as red, green, blue and alpha 1. s1 to s3 need a
    /// scale above 0 here, since nothing is read back.
    pub fn nicol_framebuffer_draw_observation(framebuffer: nicol_framebuffer, observation: *const nicol_observation, target: *const nicol_texture_target) -> nicol_result;
    /// Coefficients of light, one vector a channel, in the world's axes; NICOL_ERROR_INVALID_ARGUMENT unless count
    /// is channels * 4 (order+1)^2. An image counts as the bilinear function between its pixels. As an
    /// environment, it must be physical: polarization up to s0.
    pub fn nicol_psh_project_image(image: *const nicol_image, order: u32, coefficients: *mut f64, count: u64) -> nicol_result;
    pub fn nicol_psh_project_environment(environment: nicol_environment, order: u32, coefficients: *mut f64, count: u64) -> nicol_result;
    /// A file as nicol_environment_load reads it. channels may be NULL; coefficients NULL with count 0
    /// gets the number of channels alone.
    pub fn nicol_psh_project_file(path: *const c_char, order: u32, channels: *mut u32, coefficients: *mut f64, count: u64) -> nicol_result;
    /// NICOL_ERROR_INVALID_ARGUMENT where the sampling is too coarse for the order.
    pub fn nicol_psh_transform_create(sampling: *const nicol_psh_sampling, transform: *mut nicol_psh_transform) -> nicol_result;
    pub fn nicol_psh_transform_retain(transform: nicol_psh_transform) -> nicol_result;
    pub fn nicol_psh_transform_release(transform: nicol_psh_transform) -> nicol_result;
    /// Of its grid.
    pub fn nicol_psh_transform_get_size(transform: nicol_psh_transform, rows: *mut u32, columns: *mut u32) -> nicol_result;
    /// theta of each row, and the weights of the integral over cos theta, which sum to 2; count = rows.
    pub fn nicol_psh_transform_get_rows(transform: nicol_psh_transform, theta: *mut f64, weight: *mut f64, count: u64) -> nicol_result;
    /// Inner products with the basis (Eq. 32) by the rows' weights.
    pub fn nicol_psh_analyze(transform: nicol_psh_transform, vectors: u64, samples: *const f64, sample_count: u64, coefficients: *mut f64, coefficient_count: u64) -> nicol_result;
    /// The field of the coefficients (Eq. 30) at the samples.
    pub fn nicol_psh_synthesize(transform: nicol_psh_transform, vectors: u64, coefficients: *const f64, coefficient_count: u64, samples: *mut f64, sample_count: u64) -> nicol_result;
    /// Stokes vectors [vector][direction][4] at directions [direction][3] of any length but 0.
    pub fn nicol_psh_evaluate(order: u32, vectors: u64, coefficients: *const f64, coefficient_count: u64, directions: *const f64, direction_count: u64, stokes: *mut f64, stokes_count: u64) -> nicol_result;
    /// The rotated fields: (R f)(w) = R f(R^-1 w) (Eqs. 25, 36). The rotation must be
    /// orthonormal to 1e-5 and right-handed. out may be in.
    pub fn nicol_psh_rotate(order: u32, vectors: u64, r#in: *const f64, in_count: u64, rotation: *const [f64; 9], out: *mut f64, out_count: u64) -> nicol_result;
    /// The fields' mirror images in the plane z = 0 (Eq. 214, with its conjugation). out may be in.
    pub fn nicol_psh_reflect(order: u32, vectors: u64, r#in: *const f64, in_count: u64, out: *mut f64, out_count: u64) -> nicol_result;
    /// A scalar field ((scalar_order+1)^2 coefficients over real harmonics, such as visibility) times each field,
    /// cut above order_out: exact, through a grid, in O(order^3). out may be in where the orders agree.
    pub fn nicol_psh_multiply(scalar_order: u32, scalar: *const f64, scalar_count: u64, order: u32, vectors: u64, r#in: *const f64, in_count: u64, order_out: u32, out: *mut f64, out_count: u64) -> nicol_result;
    /// The same product as a matrix (Eq. 54, by the triple products of Eqs. 215 and 216).
    pub fn nicol_psh_shadow_matrix(scalar_order: u32, scalar: *const f64, scalar_count: u64, order_out: u32, order_in: u32, matrix: *mut f64, matrix_count: u64) -> nicol_result;
    /// The operator "integrate the field times the light over the incoming directions" as a matrix (Eqs. 39, 40),
    /// by quadrature.
    pub fn nicol_psh_project_matrix(field: *const nicol_psh_mueller_field, matrix: *mut f64, matrix_count: u64) -> nicol_result;
    /// out = matrix * in, vector by vector (Eq. 41).
    pub fn nicol_psh_apply_matrix(order_out: u32, order_in: u32, matrix: *const f64, matrix_count: u64, vectors: u64, r#in: *const f64, in_count: u64, out: *mut f64, out_count: u64) -> nicol_result;
    /// The matrix of `second` after `first`.
    pub fn nicol_psh_compose_matrix(order_out: u32, order_between: u32, order_in: u32, second: *const f64, second_count: u64, first: *const f64, first_count: u64, matrix: *mut f64, matrix_count: u64) -> nicol_result;
    /// Bands by quadrature on this many Gauss-Legendre rows, 0: 2 order + 2, at most 16384 (Eq. 68).
    pub fn nicol_psh_project_kernel(callback: nicol_psh_kernel_callback, user: *mut c_void, order: u32, rows: u32, bands: *mut f64, band_count: u64) -> nicol_result;
    /// The inverse: Mueller matrices [angle][16] at angles in 0 to pi.
    pub fn nicol_psh_kernel_at(order: u32, bands: *const f64, band_count: u64, theta: *const f64, theta_count: u64, mueller: *mut f64, mueller_count: u64) -> nicol_result;
    /// The convolution of each field (Eq. 69). out may be in.
    pub fn nicol_psh_convolve(order: u32, bands: *const f64, band_count: u64, vectors: u64, r#in: *const f64, in_count: u64, out: *mut f64, out_count: u64) -> nicol_result;
    /// The convolution as a matrix, and the kernel nearest to a matrix in the Frobenius norm (supplement E.9);
    /// both sides of the matrix have this order.
    pub fn nicol_psh_kernel_matrix(order: u32, bands: *const f64, band_count: u64, matrix: *mut f64, matrix_count: u64) -> nicol_result;
    pub fn nicol_psh_nearest_kernel(order: u32, matrix: *const f64, matrix_count: u64, bands: *mut f64, band_count: u64) -> nicol_result;
    /// By suffix and headers alone: NICOL_ERROR_UNSUPPORTED for a suffix or an archive of another kind, and
    /// the file may yet prove damaged.
    pub fn nicol_file_identify(path: *const c_char, kind: *mut nicol_file_kind) -> nicol_result;
    /// options may be NULL. energy, which may be NULL with count 0, has room for count doubles and gets
    /// [channel][l][p], 4 (order + 1) a channel: squares of the coefficients summed over m. Scale and rotation
    /// change the report as they would an output; what concerns images to write must be 0; the order limits the
    /// energies of an image, and all of coefficients. An image that violates Eq. 70 is described, though it is
    /// refused as a light.
    pub fn nicol_file_describe_light(path: *const c_char, options: *const nicol_file_options, report: *mut nicol_light_report, energy: *mut f64, count: u64) -> nicol_result;
    /// energy: [channel][l], order + 1 a channel: squares of the matrix' entries between orders of which the
    /// larger is l.
    pub fn nicol_file_describe_material(path: *const c_char, options: *const nicol_file_options, report: *mut nicol_material_report, energy: *mut f64, count: u64) -> nicol_result;
    /// Reads `in` and writes `out` in the kind that its name says: .exr, _s0.exr (all four files), .npz or a cache
    /// folder. Light becomes light and a material a material. options may be NULL.
    pub fn nicol_file_convert(r#in: *const c_char, options: *const nicol_file_options, out: *const c_char) -> nicol_result;
    /// The same from objects; options without wavelengths.
    pub fn nicol_environment_write(environment: nicol_environment, options: *const nicol_file_options, path: *const c_char) -> nicol_result;
    pub fn nicol_material_write(material: nicol_material, options: *const nicol_file_options, path: *const c_char) -> nicol_result;
    /// Coefficients of 1 to NICOL_MAX_CHANNELS vectors as a LIGHT_PSH file.
    pub fn nicol_psh_write_file(path: *const c_char, order: u32, vectors: u64, coefficients: *const f64, count: u64) -> nicol_result;
}
