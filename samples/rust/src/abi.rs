// SPDX-License-Identifier: MIT
//! Nicol 0.1.0 for Rust. Made of the C headers by samples/bindings/generate.py: change those, not this file.
#![allow(non_camel_case_types)]
use std::ffi::{c_char, c_void};
use std::mem::{offset_of, size_of, MaybeUninit};

macro_rules! defaults {
    ($name:ident, $init:ident) => {
        impl Default for $name {
            fn default() -> Self {
                let mut made = MaybeUninit::zeroed();
                // Fails only in a child of fork(), where every call fails; zeros are values of every field.
                unsafe {
                    $init(made.as_mut_ptr(), size_of::<Self>() as u32);
                    made.assume_init()
                }
            }
        }
    };
}

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
pub const NICOL_INSTANCE_CASTS_NO_SHADOWS: u32 = 1;
pub const NICOL_INSTANCE_RECEIVES_NO_SHADOWS: u32 = 2;
pub const NICOL_INSTANCE_INVISIBLE: u32 = 4;
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
pub const NICOL_OPTIMISATION_RAYS: u32 = 128;
pub const NICOL_OPTIMISATION_DIM_LIGHTS: u32 = 256;
pub const NICOL_OPTIMISATION_ALL: u32 = 511;
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
pub const NICOL_FILTER_BOX: u32 = 0;
pub const NICOL_FILTER_GAUSSIAN: u32 = 1;
pub const NICOL_FILTER_TENT: u32 = 2;
pub const NICOL_FILTER_MITCHELL: u32 = 3;
pub const NICOL_FILTER_CATMULLROM: u32 = 4;
pub const NICOL_FILTER_LANCZOS: u32 = 5;
pub const NICOL_DIRECTIONS_AUTOMATIC: u32 = 0;
pub const NICOL_DEPTH_UNLIMITED: i32 = -1;
pub const NICOL_SPLIT_AUTOMATIC: i32 = -1;
pub const NICOL_MAX_SPLIT_LIGHTS: u32 = 64;
pub const NICOL_QUALITY_REALTIME: u32 = 0;
pub const NICOL_QUALITY_PREVIEW: u32 = 1;
pub const NICOL_QUALITY_FINAL: u32 = 2;
pub const NICOL_MAX_VIEWS: u32 = 1024;
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
pub const NICOL_PLANE_POLARIZER: u32 = 13;
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
pub const NICOL_MOSAIC_PLAIN: u32 = 0;
pub const NICOL_MOSAIC_POLARIZED: u32 = 1;
pub const NICOL_MOSAIC_POLARIZED_BAYER: u32 = 2;
pub const NICOL_SENSOR_PRESET_IMX250MZR: u32 = 0;
pub const NICOL_SENSOR_PRESET_IMX250MYR: u32 = 1;
pub const NICOL_DEMOSAIC_BILINEAR: u32 = 0;
pub const NICOL_DEMOSAIC_BLOCKS: u32 = 1;
pub const NICOL_DEMOSAIC_GRADIENT: u32 = 2;
pub const NICOL_HOST_SETS_STATE: u32 = 1;
pub const NICOL_HOST_VALIDATE: u32 = 2;
pub const NICOL_ENCODING_LINEAR: u32 = 0;
pub const NICOL_ENCODING_SRGB: u32 = 1;
pub const NICOL_DEPTH_MAPPING_PERSPECTIVE: u32 = 0;
pub const NICOL_DEPTH_MAPPING_PERSPECTIVE_REVERSED: u32 = 1;
pub const NICOL_DEPTH_MAPPING_ORTHOGRAPHIC: u32 = 2;
pub const NICOL_DEPTH_MAPPING_ORTHOGRAPHIC_REVERSED: u32 = 3;
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

/// Receives a message of the log. message is one line that lives as long as the call. code is NICOL_OK, or the
/// result that a call would have returned for the problem that Nicol worked around. The callback must not call
/// Nicol with objects of the context.
pub type nicol_log_callback = Option<unsafe extern "C" fn(user: *mut c_void, severity: u32, code: nicol_result, message: *const c_char)>;

/// Receives a failure: the result code, the message of nicol_last_error(), and the function's name, such as
/// "nicol_render"; the strings live as long as the call. The callback runs on the thread of the failed call,
/// before the call returns. A job that fails reports from its own thread, as "nicol_render_async". The
/// callback must not call Nicol.
pub type nicol_error_callback = Option<unsafe extern "C" fn(user: *mut c_void, code: nicol_result, message: *const c_char, function: *const c_char)>;

/// Receives the progress of a call about ten times a second, on the calling thread; fraction runs from 0 to 1.
/// Returns 1 to continue, or 0 to cancel: the call then returns NICOL_ERROR_CANCELLED. The callback must not
/// call Nicol with objects of the same context.
pub type nicol_progress_callback = Option<unsafe extern "C" fn(user: *mut c_void, verb: *const c_char, fraction: f64) -> i32>;

#[repr(C)]
pub struct nicol_context_impl {
    _private: [u8; 0],
}
/// OpenGL context on its own thread, or a host's
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
/// polarimetric BRDF (pBRDF); immutable
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
/// instances, light and polarization elements
pub type nicol_scene = *mut nicol_scene_impl;

#[repr(C)]
pub struct nicol_framebuffer_impl {
    _private: [u8; 0],
}
/// Stokes image of the last render into it
pub type nicol_framebuffer = *mut nicol_framebuffer_impl;

/// Values per colour channel. count 0: not given, so that the default of the field or argument applies; 1: one
/// value for every channel; else the scene's number of channels.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_spectrum {
    pub count: u32,
    pub values: [f32; 16],
}
defaults!(nicol_spectrum, nicol_spectrum_init);
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
    pub pci_address: *const c_char,
}
defaults!(nicol_device_info, nicol_device_info_init);
const _: () = {
    assert!(size_of::<nicol_device_info>() == 40);
    assert!(offset_of!(nicol_device_info, struct_size) == 0);
    assert!(offset_of!(nicol_device_info, software) == 4);
    assert!(offset_of!(nicol_device_info, name) == 8);
    assert!(offset_of!(nicol_device_info, vendor) == 16);
    assert!(offset_of!(nicol_device_info, file) == 24);
    assert!(offset_of!(nicol_device_info, pci_address) == 32);
};

/// Part of the library's parallel loops, for a host's task system.
pub type nicol_task = Option<unsafe extern "C" fn(data: *mut c_void)>;

/// Begins `count` calls of task(data) on any threads of the host, and returns at once with a value that
/// nicol_finish_tasks takes. Calls return when the loops that they help with have ended, and at once if they
/// come later. The function is called on the thread that renders or loads.
pub type nicol_start_tasks = Option<unsafe extern "C" fn(user: *mut c_void, count: u32, task: nicol_task, data: *mut c_void) -> *mut c_void>;

/// Returns when all calls of one nicol_start_tasks have returned.
pub type nicol_finish_tasks = Option<unsafe extern "C" fn(user: *mut c_void, started: *mut c_void)>;

/// Receives the bytes of large blocks of memory: a positive number before they are taken, a negative one after
/// they were given back. Returns 1, or 0 to refuse a positive number: the call then fails with
/// NICOL_ERROR_OUT_OF_MEMORY, or its job, and gives back what it took. Other objects stay as they were. The
/// callback is called on any thread, on several at once, and must not call Nicol.
pub type nicol_memory_callback = Option<unsafe extern "C" fn(user: *mut c_void, bytes: i64) -> i32>;

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
    pub error: nicol_error_callback,
    pub error_user: *mut c_void,
    pub start_tasks: nicol_start_tasks,
    pub finish_tasks: nicol_finish_tasks,
    pub tasks_user: *mut c_void,
    pub memory: nicol_memory_callback,
    pub memory_user: *mut c_void,
}
defaults!(nicol_context_options, nicol_context_options_init);
const _: () = {
    assert!(size_of::<nicol_context_options>() == 152);
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
    assert!(offset_of!(nicol_context_options, error) == 96);
    assert!(offset_of!(nicol_context_options, error_user) == 104);
    assert!(offset_of!(nicol_context_options, start_tasks) == 112);
    assert!(offset_of!(nicol_context_options, finish_tasks) == 120);
    assert!(offset_of!(nicol_context_options, tasks_user) == 128);
    assert!(offset_of!(nicol_context_options, memory) == 136);
    assert!(offset_of!(nicol_context_options, memory_user) == 144);
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
    pub device_uuid: *const c_char,
    pub driver_uuid: *const c_char,
    pub device_bytes: u64,
}
defaults!(nicol_context_info, nicol_context_info_init);
const _: () = {
    assert!(size_of::<nicol_context_info>() == 112);
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
    assert!(offset_of!(nicol_context_info, device_uuid) == 88);
    assert!(offset_of!(nicol_context_info, driver_uuid) == 96);
    assert!(offset_of!(nicol_context_info, device_bytes) == 104);
};

/// Content of a file that a resolver returns.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_file_content {
    pub struct_size: u32,
    pub reserved: u32,
    pub bytes: *const c_void,
    pub byte_size: u64,
}
defaults!(nicol_file_content, nicol_file_content_init);
const _: () = {
    assert!(size_of::<nicol_file_content>() == 24);
    assert!(offset_of!(nicol_file_content, struct_size) == 0);
    assert!(offset_of!(nicol_file_content, reserved) == 4);
    assert!(offset_of!(nicol_file_content, bytes) == 8);
    assert!(offset_of!(nicol_file_content, byte_size) == 16);
};

/// Finds a file that a file in memory names. Sets bytes and byte_size of content, which has its defaults, and
/// returns 1; or returns 0 if there is no such file. The name is joined to the folder of the naming file,
/// without "." and "folder/..": "maps/wood.png" in "rooms/hall.xml" is "rooms/maps/wood.png". The name may
/// begin with "/" or "..". The callback is called once per name, on the calling thread, and must not call
/// Nicol with objects of the same context.
pub type nicol_resolve_callback = Option<unsafe extern "C" fn(user: *mut c_void, name: *const c_char, content: *mut nicol_file_content) -> i32>;

/// A file in memory. The ..._load_memory functions read it as the ..._load functions read a file, within the
/// same limits, and with the same result. They read nothing from the file system. If the resolver does not
/// have a file, they return NICOL_ERROR_FILE_NOT_FOUND, and the message has the file's name.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_memory_file {
    pub struct_size: u32,
    pub reserved: u32,
    pub name: *const c_char,
    pub bytes: *const c_void,
    pub byte_size: u64,
    pub resolve: nicol_resolve_callback,
    pub resolve_user: *mut c_void,
}
defaults!(nicol_memory_file, nicol_memory_file_init);
const _: () = {
    assert!(size_of::<nicol_memory_file>() == 48);
    assert!(offset_of!(nicol_memory_file, struct_size) == 0);
    assert!(offset_of!(nicol_memory_file, reserved) == 4);
    assert!(offset_of!(nicol_memory_file, name) == 8);
    assert!(offset_of!(nicol_memory_file, bytes) == 16);
    assert!(offset_of!(nicol_memory_file, byte_size) == 24);
    assert!(offset_of!(nicol_memory_file, resolve) == 32);
    assert!(offset_of!(nicol_memory_file, resolve_user) == 40);
};

/// Receives the next bytes of a file that is written to memory, on the calling thread. bytes are valid until
/// the callback returns. Returns 1 to continue, or 0 to end the writing call, which then returns
/// NICOL_ERROR_WRITE_FAILED. The callback must not call Nicol with objects of the same context.
pub type nicol_sink_callback = Option<unsafe extern "C" fn(user: *mut c_void, bytes: *const c_void, byte_size: u64) -> i32>;

pub type nicol_release_callback = Option<unsafe extern "C" fn(user: *mut c_void)>;

/// Equirectangular image over the directions that light comes FROM, in Mitsuba 3's layout: column u = atan2(x,
/// -z) / 2 pi (pixel-centred), row v = acos(y) / pi (row 0 is the pole itself, the last row the other
/// pole).
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
defaults!(nicol_image, nicol_image_init);
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

/// Clear sky without the sun's own disc. At the angle g from the sun, the degree of linear polarization is
/// dop_max sin^2 g / (1 + cos^2 g), the electric field is along sun x view, and s3 is 0.
///
/// Turbidity 0: light is scattered once, with radiance * 3/4 (1 + cos^2 g) over the whole sphere, below the
/// horizon too.
///
/// Turbidity 1.7 (very clear) to 10 (hazy): brightness and, in three channels, colour follow Perez's formula,
/// scaled so that the mean luminance over the upper half is 1, times radiance. Below the horizon is an
/// unpolarized, uniform ground that reflects ground_albedo of each channel's irradiance. The sun must not be
/// below the horizon.
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
defaults!(nicol_sky, nicol_sky_init);
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
defaults!(nicol_environment_load_options, nicol_environment_load_options_init);
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
defaults!(nicol_environment_info, nicol_environment_info_init);
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
defaults!(nicol_texture_image, nicol_texture_image_init);
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
defaults!(nicol_texture_options, nicol_texture_options_init);
const _: () = {
    assert!(size_of::<nicol_texture_options>() == 88);
    assert!(offset_of!(nicol_texture_options, struct_size) == 0);
    assert!(offset_of!(nicol_texture_options, filter) == 4);
    assert!(offset_of!(nicol_texture_options, wrap) == 8);
    assert!(offset_of!(nicol_texture_options, raw) == 12);
    assert!(offset_of!(nicol_texture_options, to_uv) == 16);
};
pub type nicol_distribution = u32;

/// Thin film on a surface, such as an oxide, oil, soap or the coating of a lens. All reflections inside the
/// film interfere: their complex amplitudes are summed for s and p apart (Airy). A channel of red, green or
/// blue has the mean over its response to the spectrum, of the CIE 1931 observer under D65, clipped to what is
/// physically possible; a channel of one wavelength is exact.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_film {
    pub thickness: f32,
    pub eta: f32,
    pub k: f32,
    pub reserved: u32,
    pub wavelengths: nicol_spectrum,
}
defaults!(nicol_film, nicol_film_init);
const _: () = {
    assert!(size_of::<nicol_film>() == 84);
    assert!(offset_of!(nicol_film, thickness) == 0);
    assert!(offset_of!(nicol_film, eta) == 4);
    assert!(offset_of!(nicol_film, k) == 8);
    assert!(offset_of!(nicol_film, reserved) == 12);
    assert!(offset_of!(nicol_film, wavelengths) == 16);
};

/// Plastic as Mitsuba 3's pplastic: rough Fresnel reflection over a diffuse base, both polarizing. Only the
/// front side reflects.
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
    pub alpha_u: f32,
    pub alpha_v: f32,
    pub alpha_u_texture: nicol_texture,
    pub alpha_v_texture: nicol_texture,
    pub film: nicol_film,
    pub film_thickness_texture: nicol_texture,
    pub film_thickness_least: f64,
}
defaults!(nicol_pplastic, nicol_pplastic_init);
const _: () = {
    assert!(size_of::<nicol_pplastic>() == 312);
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
    assert!(offset_of!(nicol_pplastic, alpha_u) == 184);
    assert!(offset_of!(nicol_pplastic, alpha_v) == 188);
    assert!(offset_of!(nicol_pplastic, alpha_u_texture) == 192);
    assert!(offset_of!(nicol_pplastic, alpha_v_texture) == 200);
    assert!(offset_of!(nicol_pplastic, film) == 208);
    assert!(offset_of!(nicol_pplastic, film_thickness_texture) == 296);
    assert!(offset_of!(nicol_pplastic, film_thickness_least) == 304);
};

/// Plastic as Mitsuba 3's plastic and roughplastic: Fresnel reflection over a diffuse base, both depolarizing.
/// nicol_pplastic is the model that polarizes. Only the front side reflects.
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
defaults!(nicol_plastic, nicol_plastic_init);
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

/// Disney's material as Mitsuba 3's principled. What it reflects is unpolarized. Light that passes the surface
/// (spec_trans above 0) is followed as that of a rough nicol_dielectric. Only the front side reflects. Numbers
/// are 0 to 1, default 0, unless stated otherwise.
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
defaults!(nicol_principled, nicol_principled_init);
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

/// Metal as Mitsuba 3's conductor and roughconductor: single reflection off the facets of an opaque metal. The
/// complex index is eta - i k, relative to air. With k = 0 and the index of a dielectric as eta, the material
/// reflects like the surface of the dielectric, such as glass whose inside is not seen. Only the front side
/// reflects.
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
    pub film: nicol_film,
    pub film_thickness_texture: nicol_texture,
    pub film_thickness_least: f64,
}
defaults!(nicol_conductor, nicol_conductor_init);
const _: () = {
    assert!(size_of::<nicol_conductor>() == 440);
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
    assert!(offset_of!(nicol_conductor, film) == 336);
    assert!(offset_of!(nicol_conductor, film_thickness_texture) == 424);
    assert!(offset_of!(nicol_conductor, film_thickness_least) == 432);
};

/// Glass as Mitsuba 3's dielectric, roughdielectric and thindielectric: a boundary that reflects and transmits
/// light, polarized as Fresnel's formulas say. The factored method follows light through it by rays at pixels,
/// the reference method by its paths; max_depth of nicol_render_options limits how often. By the factored
/// method with a max_depth above 2, smooth glass and smooth metal bend the light of local lights to other
/// surfaces, as unpolarized light: 131,072 paths, found anew when local lights, bright parts of the
/// environment or surfaces change or turn, make caustics. Otherwise, and through rough glass, the light of
/// local lights passes straight on, dimmed in each channel as unpolarized light is; the light of the
/// environment passes straight on and is dimmed equally in all channels, by their mean. Metal of a roughness
/// below 0.25 shows the environment as glass bends it. The dense method and shading at vertices return
/// NICOL_ERROR_UNSUPPORTED. The surface of a body must be closed, its normals pointing outwards, and bodies
/// must not overlap.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_dielectric {
    pub struct_size: u32,
    pub thin: u32,
    pub int_ior: f32,
    pub ext_ior: f32,
    pub specular_reflectance: nicol_spectrum,
    pub specular_transmittance: nicol_spectrum,
    pub absorption: nicol_spectrum,
    pub alpha: f32,
    pub distribution: nicol_distribution,
    pub alpha_texture: nicol_texture,
    pub film: nicol_film,
}
defaults!(nicol_dielectric, nicol_dielectric_init);
const _: () = {
    assert!(size_of::<nicol_dielectric>() == 328);
    assert!(offset_of!(nicol_dielectric, struct_size) == 0);
    assert!(offset_of!(nicol_dielectric, thin) == 4);
    assert!(offset_of!(nicol_dielectric, int_ior) == 8);
    assert!(offset_of!(nicol_dielectric, ext_ior) == 12);
    assert!(offset_of!(nicol_dielectric, specular_reflectance) == 16);
    assert!(offset_of!(nicol_dielectric, specular_transmittance) == 84);
    assert!(offset_of!(nicol_dielectric, absorption) == 152);
    assert!(offset_of!(nicol_dielectric, alpha) == 220);
    assert!(offset_of!(nicol_dielectric, distribution) == 224);
    assert!(offset_of!(nicol_dielectric, alpha_texture) == 232);
    assert!(offset_of!(nicol_dielectric, film) == 240);
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
defaults!(nicol_measured, nicol_measured_init);
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
defaults!(nicol_psh_matrix, nicol_psh_matrix_init);
const _: () = {
    assert!(size_of::<nicol_psh_matrix>() == 76);
    assert!(offset_of!(nicol_psh_matrix, struct_size) == 0);
    assert!(offset_of!(nicol_psh_matrix, symmetrize) == 4);
    assert!(offset_of!(nicol_psh_matrix, scale) == 8);
};

/// Writes the Mueller matrix of one colour channel: 16 row-major doubles, 1/sr, without the cosine. The light
/// comes from the direction `towards_light` and goes into the direction `towards_viewer`: unit vectors with
/// z > 0 in the surface's frame, whose normal is z. Both Stokes frames have x along the s-axis towards_light x
/// towards_viewer, z along the propagation and y = z cross x, as Fresnel's matrices do. If the directions are
/// equal, x is any perpendicular direction, the same for both frames. Returns 1 to continue, or 0 to end the
/// call that needs the matrix with NICOL_ERROR_CANCELLED. nicol_material_create_callback and nicol_render call
/// the function, on several threads at once. The function must not call Nicol with objects of the material's
/// context.
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
defaults!(nicol_callback_material, nicol_callback_material_init);
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

/// Triangles in memory. All numbers must be finite and all indices valid. Triangles without area are left out,
/// and logged once.
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
    pub tangents: *const f32,
}
defaults!(nicol_mesh_data, nicol_mesh_data_init);
const _: () = {
    assert!(size_of::<nicol_mesh_data>() == 80);
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
    assert!(offset_of!(nicol_mesh_data, tangents) == 72);
};

/// Other places of a mesh's vertices, such as those of the next frame of an animated character.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_deformation {
    pub struct_size: u32,
    pub vertex_count: u32,
    pub positions: *const f32,
    pub normals: *const f32,
}
defaults!(nicol_deformation, nicol_deformation_init);
const _: () = {
    assert!(size_of::<nicol_deformation>() == 24);
    assert!(offset_of!(nicol_deformation, struct_size) == 0);
    assert!(offset_of!(nicol_deformation, vertex_count) == 4);
    assert!(offset_of!(nicol_deformation, positions) == 8);
    assert!(offset_of!(nicol_deformation, normals) == 16);
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
    pub pixel_aspect: f64,
}
defaults!(nicol_camera, nicol_camera_init);
const _: () = {
    assert!(size_of::<nicol_camera>() == 200);
    assert!(offset_of!(nicol_camera, struct_size) == 0);
    assert!(offset_of!(nicol_camera, projection) == 4);
    assert!(offset_of!(nicol_camera, to_world) == 8);
    assert!(offset_of!(nicol_camera, fov) == 136);
    assert!(offset_of!(nicol_camera, near_clip) == 144);
    assert!(offset_of!(nicol_camera, far_clip) == 152);
    assert!(offset_of!(nicol_camera, jitter) == 160);
    assert!(offset_of!(nicol_camera, shift) == 176);
    assert!(offset_of!(nicol_camera, pixel_aspect) == 192);
};

/// Polarization of the emission of a light, equal in all directions. The frame, as seen by a viewer who looks into the
/// light:
///
///  y|  / E-vector
///   | /    z  points towards the viewer, along the light
///   |/     x  is the part of axis perpendicular to z (for an axis along z: growing angle from the light's own +z)
///   +---x  y  = z cross x; the AoLP counts from x to y, counter-clockwise
///
/// A sheet polarizer before the light that absorbs along `axis` is dolp 1 and aolp pi / 2, seen from anywhere. A
/// quarter-wave plate behind this polarizer gives docp 1 or -1.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_polarization {
    pub dolp: f64,
    pub aolp: f64,
    pub docp: f64,
    pub axis: [f64; 3],
}
defaults!(nicol_polarization, nicol_polarization_init);
const _: () = {
    assert!(size_of::<nicol_polarization>() == 48);
    assert!(offset_of!(nicol_polarization, dolp) == 0);
    assert!(offset_of!(nicol_polarization, aolp) == 8);
    assert!(offset_of!(nicol_polarization, docp) == 16);
    assert!(offset_of!(nicol_polarization, axis) == 24);
};
pub type nicol_light_kind = u32;

/// Local light without a surface, beside the environment. In its own axes the light emits along +z, from the
/// origin unless it is directional. +y is up, and +x is to the left of a viewer who looks along +z, as for
/// cameras. Fields of other kinds have no effect.
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
defaults!(nicol_light, nicol_light_init);
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

/// Emission of an instance, in addition to its reflection.
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
defaults!(nicol_emission, nicol_emission_init);
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

/// Ideal, infinitely thin polarization element. The camera sees what is behind the element through its Mueller matrix.
/// Several elements along a ray act in their order. An element casts no shadow, and light passes it unchanged on its way
/// to surfaces. In its own axes an element lies in the plane z = 0 about the origin; light passes in both directions with
/// equal effect.
///
///   y
///   |  / axis   x  is where to_world takes the element's x, z its normal, and y = z cross x
///   | /) angle
///   +------x
///
/// Light at an angle to the normal is treated as in Mitsuba 3. A polarizer absorbs along the part of its absorbing axis
/// that is perpendicular to the ray. The retardance is multiplied by the cosine of the angle. The effective fast axis of
/// a retarder is the part of its fast axis that is perpendicular to the ray, whereas Mitsuba 3.9 rotates the fast axis
/// with the tilt.
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
    pub angle_texture: nicol_texture,
    pub retardance_texture: nicol_texture,
}
defaults!(nicol_polarization_element, nicol_polarization_element_init);
const _: () = {
    assert!(size_of::<nicol_polarization_element>() == 184);
    assert!(offset_of!(nicol_polarization_element, struct_size) == 0);
    assert!(offset_of!(nicol_polarization_element, kind) == 4);
    assert!(offset_of!(nicol_polarization_element, outline) == 8);
    assert!(offset_of!(nicol_polarization_element, reserved) == 12);
    assert!(offset_of!(nicol_polarization_element, to_world) == 16);
    assert!(offset_of!(nicol_polarization_element, angle) == 144);
    assert!(offset_of!(nicol_polarization_element, retardance) == 152);
    assert!(offset_of!(nicol_polarization_element, transmittance) == 160);
    assert!(offset_of!(nicol_polarization_element, angle_texture) == 168);
    assert!(offset_of!(nicol_polarization_element, retardance_texture) == 176);
};

#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_instance {
    pub struct_size: u32,
    pub flags: u32,
    pub mesh: nicol_mesh,
    pub material: nicol_material,
    pub to_world: [f64; 16],
}
defaults!(nicol_instance, nicol_instance_init);
const _: () = {
    assert!(size_of::<nicol_instance>() == 152);
    assert!(offset_of!(nicol_instance, struct_size) == 0);
    assert!(offset_of!(nicol_instance, flags) == 4);
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
defaults!(nicol_scene_file, nicol_scene_file_init);
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
pub type nicol_filter_kind = u32;

/// Reconstruction filter of an image. A pixel is the weighted mean of the samples of all pixels within the
/// filter's radius; no samples lie beyond the border of the image. The filter applies to each Stokes component
/// and not to AOVs, except that the reference method's alpha and variance are those of the weighted samples.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_filter {
    pub kind: nicol_filter_kind,
    pub reserved: u32,
    pub size: f64,
    pub b: f64,
    pub c: f64,
}
defaults!(nicol_filter, nicol_filter_init);
const _: () = {
    assert!(size_of::<nicol_filter>() == 32);
    assert!(offset_of!(nicol_filter, kind) == 0);
    assert!(offset_of!(nicol_filter, reserved) == 4);
    assert!(offset_of!(nicol_filter, size) == 8);
    assert!(offset_of!(nicol_filter, b) == 16);
    assert!(offset_of!(nicol_filter, c) == 24);
};

/// Options of a render. The reference method uses only samples, seed, max_depth, shadows, aovs, filter,
/// progress and NICOL_OPTIMISATION_UNCHANGED; the other options are those of the factored and the dense
/// method.
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
    pub bsdf_samples: u32,
    pub max_depth: i32,
    pub fail_if_busy: u32,
    pub reserved: u32,
    pub bake_budget_ms: f64,
    pub filter: nicol_filter,
    pub time_budget_ms: f64,
}
defaults!(nicol_render_options, nicol_render_options_init);
const _: () = {
    assert!(size_of::<nicol_render_options>() == 192);
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
    assert!(offset_of!(nicol_render_options, bsdf_samples) == 128);
    assert!(offset_of!(nicol_render_options, max_depth) == 132);
    assert!(offset_of!(nicol_render_options, fail_if_busy) == 136);
    assert!(offset_of!(nicol_render_options, reserved) == 140);
    assert!(offset_of!(nicol_render_options, bake_budget_ms) == 144);
    assert!(offset_of!(nicol_render_options, filter) == 152);
    assert!(offset_of!(nicol_render_options, time_budget_ms) == 184);
};
pub type nicol_quality = u32;

#[repr(C)]
pub struct nicol_job_impl {
    _private: [u8; 0],
}
/// Asynchronous render. Jobs of one context run one after another, in the order of submission, on a thread of
/// the context. Only nicol_render and nicol_render_views of the same scene wait for a running job, unless
/// fail_if_busy is set. Other functions return while it runs: those that use OpenGL wait at most for the step
/// that the job gives to OpenGL, and those that use its framebuffer for the step that puts the image there. A
/// job may be used from any thread; nicol_job_poll and nicol_job_cancel may also be called from callbacks.
/// "Inside a host's OpenGL" says how jobs differ there.
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
defaults!(nicol_job_status, nicol_job_status_init);
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
    pub smooth_rays: u64,
    pub vertices_pending: u64,
    pub bounce_ms: f64,
    pub bounce_links: u64,
    pub bounce_rounds: u64,
    pub bounced_light: f64,
    pub bounced_left: f64,
    pub bake_rays_skipped: u64,
    pub vertices_unbaked: u64,
    pub given_up: u32,
    pub pixel_samples: u32,
    pub light_samples: u32,
    pub bsdf_samples: u32,
    pub order_tolerance: f64,
    pub light_rays_skipped: u64,
}
defaults!(nicol_statistics, nicol_statistics_init);
const _: () = {
    assert!(size_of::<nicol_statistics>() == 416);
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
    assert!(offset_of!(nicol_statistics, smooth_rays) == 312);
    assert!(offset_of!(nicol_statistics, vertices_pending) == 320);
    assert!(offset_of!(nicol_statistics, bounce_ms) == 328);
    assert!(offset_of!(nicol_statistics, bounce_links) == 336);
    assert!(offset_of!(nicol_statistics, bounce_rounds) == 344);
    assert!(offset_of!(nicol_statistics, bounced_light) == 352);
    assert!(offset_of!(nicol_statistics, bounced_left) == 360);
    assert!(offset_of!(nicol_statistics, bake_rays_skipped) == 368);
    assert!(offset_of!(nicol_statistics, vertices_unbaked) == 376);
    assert!(offset_of!(nicol_statistics, given_up) == 384);
    assert!(offset_of!(nicol_statistics, pixel_samples) == 388);
    assert!(offset_of!(nicol_statistics, light_samples) == 392);
    assert!(offset_of!(nicol_statistics, bsdf_samples) == 396);
    assert!(offset_of!(nicol_statistics, order_tolerance) == 400);
    assert!(offset_of!(nicol_statistics, light_rays_skipped) == 408);
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
    pub polarizer_angle: f64,
}
defaults!(nicol_plane_buffer, nicol_plane_buffer_init);
const _: () = {
    assert!(size_of::<nicol_plane_buffer>() == 48);
    assert!(offset_of!(nicol_plane_buffer, struct_size) == 0);
    assert!(offset_of!(nicol_plane_buffer, plane) == 4);
    assert!(offset_of!(nicol_plane_buffer, format) == 8);
    assert!(offset_of!(nicol_plane_buffer, channel) == 12);
    assert!(offset_of!(nicol_plane_buffer, pixels) == 16);
    assert!(offset_of!(nicol_plane_buffer, row_stride) == 24);
    assert!(offset_of!(nicol_plane_buffer, byte_size) == 32);
    assert!(offset_of!(nicol_plane_buffer, polarizer_angle) == 40);
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
defaults!(nicol_observation, nicol_observation_init);
const _: () = {
    assert!(size_of::<nicol_observation>() == 20);
    assert!(offset_of!(nicol_observation, struct_size) == 0);
    assert!(offset_of!(nicol_observation, kind) == 4);
    assert!(offset_of!(nicol_observation, exposure) == 8);
    assert!(offset_of!(nicol_observation, scale) == 12);
    assert!(offset_of!(nicol_observation, polarizer_angle) == 16);
};
pub type nicol_mosaic = u32;

/// Linear image sensor, by the figures of the standard EMVA 1288. A pixel collects
///     n = Poisson(quantum_efficiency * exposure * I + dark_current * exposure_time)
/// electrons, at most full_well, where I is s0 behind the optics and the pixel's polarizer, and gives the number
///     floor(gain * (n + read noise + offset) + black_level + 1/2), cut to 0 .. 2^bits - 1.
/// Noise belongs to the seed, the frame and the pixel. The polarizers' angles and transmittances, the offsets and the
/// sensitivities belong to the seed and the pixel, as does the crosstalk. All of them have the same bits on every machine and for any number
/// of threads, so that the same Stokes image gives the same bytes.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_sensor {
    pub struct_size: u32,
    pub mosaic: nicol_mosaic,
    pub bits: u32,
    pub shot_noise: u32,
    pub seed: u64,
    pub optics: [f64; 16],
    pub exposure: f64,
    pub exposure_time: f64,
    pub full_well: f64,
    pub gain: f64,
    pub black_level: f64,
    pub read_noise: f64,
    pub dark_current: f64,
    pub dsnu: f64,
    pub prnu: f64,
    pub extinction_ratio: f64,
    pub extinction_spread: f64,
    pub misalignment: f64,
    pub crosstalk: f64,
    pub crosstalk_spread: f64,
    pub blur: f64,
    pub vignetting: f64,
    pub quantum_efficiency: nicol_spectrum,
    pub reserved: u32,
}
defaults!(nicol_sensor, nicol_sensor_init);
const _: () = {
    assert!(size_of::<nicol_sensor>() == 352);
    assert!(offset_of!(nicol_sensor, struct_size) == 0);
    assert!(offset_of!(nicol_sensor, mosaic) == 4);
    assert!(offset_of!(nicol_sensor, bits) == 8);
    assert!(offset_of!(nicol_sensor, shot_noise) == 12);
    assert!(offset_of!(nicol_sensor, seed) == 16);
    assert!(offset_of!(nicol_sensor, optics) == 24);
    assert!(offset_of!(nicol_sensor, exposure) == 152);
    assert!(offset_of!(nicol_sensor, exposure_time) == 160);
    assert!(offset_of!(nicol_sensor, full_well) == 168);
    assert!(offset_of!(nicol_sensor, gain) == 176);
    assert!(offset_of!(nicol_sensor, black_level) == 184);
    assert!(offset_of!(nicol_sensor, read_noise) == 192);
    assert!(offset_of!(nicol_sensor, dark_current) == 200);
    assert!(offset_of!(nicol_sensor, dsnu) == 208);
    assert!(offset_of!(nicol_sensor, prnu) == 216);
    assert!(offset_of!(nicol_sensor, extinction_ratio) == 224);
    assert!(offset_of!(nicol_sensor, extinction_spread) == 232);
    assert!(offset_of!(nicol_sensor, misalignment) == 240);
    assert!(offset_of!(nicol_sensor, crosstalk) == 248);
    assert!(offset_of!(nicol_sensor, crosstalk_spread) == 256);
    assert!(offset_of!(nicol_sensor, blur) == 264);
    assert!(offset_of!(nicol_sensor, vignetting) == 272);
    assert!(offset_of!(nicol_sensor, quantum_efficiency) == 280);
    assert!(offset_of!(nicol_sensor, reserved) == 348);
};
pub type nicol_sensor_preset = u32;

/// Stokes image in the caller's memory, in the frame of rendered images: x right, y up.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_stokes_image {
    pub struct_size: u32,
    pub width: u32,
    pub height: u32,
    pub channels: u32,
    pub pixels: *mut c_void,
    pub row_stride: u64,
    pub byte_size: u64,
}
defaults!(nicol_stokes_image, nicol_stokes_image_init);
const _: () = {
    assert!(size_of::<nicol_stokes_image>() == 40);
    assert!(offset_of!(nicol_stokes_image, struct_size) == 0);
    assert!(offset_of!(nicol_stokes_image, width) == 4);
    assert!(offset_of!(nicol_stokes_image, height) == 8);
    assert!(offset_of!(nicol_stokes_image, channels) == 12);
    assert!(offset_of!(nicol_stokes_image, pixels) == 16);
    assert!(offset_of!(nicol_stokes_image, row_stride) == 24);
    assert!(offset_of!(nicol_stokes_image, byte_size) == 32);
};

/// Numbers of a sensor's pixels in the caller's memory.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_raw_image {
    pub struct_size: u32,
    pub width: u32,
    pub height: u32,
    pub reserved: u32,
    pub pixels: *mut c_void,
    pub row_stride: u64,
    pub byte_size: u64,
}
defaults!(nicol_raw_image, nicol_raw_image_init);
const _: () = {
    assert!(size_of::<nicol_raw_image>() == 40);
    assert!(offset_of!(nicol_raw_image, struct_size) == 0);
    assert!(offset_of!(nicol_raw_image, width) == 4);
    assert!(offset_of!(nicol_raw_image, height) == 8);
    assert!(offset_of!(nicol_raw_image, reserved) == 12);
    assert!(offset_of!(nicol_raw_image, pixels) == 16);
    assert!(offset_of!(nicol_raw_image, row_stride) == 24);
    assert!(offset_of!(nicol_raw_image, byte_size) == 32);
};
pub type nicol_demosaic = u32;

/// Room for gradients of a function f of a picture, which nicol_render_adjoint writes. NULL, the default: the
/// gradient is not wanted.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_gradient {
    pub struct_size: u32,
    pub reserved: u32,
    pub environment: *mut f64,
    pub environment_count: u64,
    pub lights: *mut f64,
    pub lights_count: u64,
    pub instances: *mut f64,
    pub instances_count: u64,
    pub texture: nicol_texture,
    pub texels: *mut f64,
    pub texels_count: u64,
}
defaults!(nicol_gradient, nicol_gradient_init);
const _: () = {
    assert!(size_of::<nicol_gradient>() == 80);
    assert!(offset_of!(nicol_gradient, struct_size) == 0);
    assert!(offset_of!(nicol_gradient, reserved) == 4);
    assert!(offset_of!(nicol_gradient, environment) == 8);
    assert!(offset_of!(nicol_gradient, environment_count) == 16);
    assert!(offset_of!(nicol_gradient, lights) == 24);
    assert!(offset_of!(nicol_gradient, lights_count) == 32);
    assert!(offset_of!(nicol_gradient, instances) == 40);
    assert!(offset_of!(nicol_gradient, instances_count) == 48);
    assert!(offset_of!(nicol_gradient, texture) == 56);
    assert!(offset_of!(nicol_gradient, texels) == 64);
    assert!(offset_of!(nicol_gradient, texels_count) == 72);
};

/// Returns the address of an OpenGL function by its name, as SDL_GL_GetProcAddress, eglGetProcAddress and
/// others do.
pub type nicol_get_proc_address_callback = Option<unsafe extern "C" fn(user: *mut c_void, name: *const c_char) -> *mut c_void>;

/// Returns 1 if the host's context is current on the calling thread, else 0.
pub type nicol_is_current_callback = Option<unsafe extern "C" fn(user: *mut c_void) -> i32>;

#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_host {
    pub struct_size: u32,
    pub flags: u32,
    pub get_proc_address: nicol_get_proc_address_callback,
    pub is_current: nicol_is_current_callback,
    pub user: *mut c_void,
}
defaults!(nicol_host, nicol_host_init);
const _: () = {
    assert!(size_of::<nicol_host>() == 32);
    assert!(offset_of!(nicol_host, struct_size) == 0);
    assert!(offset_of!(nicol_host, flags) == 4);
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
defaults!(nicol_gl_texture, nicol_gl_texture_init);
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
pub type nicol_depth_mapping = u32;

/// Texture of the host's to draw into: level 0 of a GL_TEXTURE_2D of GL_RGBA8, GL_SRGB8_ALPHA8, GL_RGBA16F or
/// GL_RGBA32F, as large as the framebuffer.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct nicol_texture_target {
    pub struct_size: u32,
    pub texture: u32,
    pub bottom_up: u32,
    pub encoding: nicol_encoding,
    pub depth_texture: u32,
    pub depth_mapping: nicol_depth_mapping,
    pub depth_near: f32,
    pub depth_far: f32,
}
defaults!(nicol_texture_target, nicol_texture_target_init);
const _: () = {
    assert!(size_of::<nicol_texture_target>() == 32);
    assert!(offset_of!(nicol_texture_target, struct_size) == 0);
    assert!(offset_of!(nicol_texture_target, texture) == 4);
    assert!(offset_of!(nicol_texture_target, bottom_up) == 8);
    assert!(offset_of!(nicol_texture_target, encoding) == 12);
    assert!(offset_of!(nicol_texture_target, depth_texture) == 16);
    assert!(offset_of!(nicol_texture_target, depth_mapping) == 20);
    assert!(offset_of!(nicol_texture_target, depth_near) == 24);
    assert!(offset_of!(nicol_texture_target, depth_far) == 28);
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
defaults!(nicol_psh_sampling, nicol_psh_sampling_init);
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
/// Transform between samples [vector][row][column][4], north to south, and coefficients, in O(order^3). The
/// transform needs no context and holds its work space: no call allocates after creation. Calls on one
/// transform are serialised.
pub type nicol_psh_transform = *mut nicol_psh_transform_impl;

/// Writes the Mueller matrix from the theta-phi frame of the propagation direction `in` to that of `out`,
/// cosine factors included (Eq. 38). Returns 1 to continue, or 0 to stop with NICOL_ERROR_CANCELLED. The
/// function is called on the calling thread, and may call Nicol.
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
defaults!(nicol_psh_mueller_field, nicol_psh_mueller_field_init);
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

/// Writes the Mueller matrix at the angle theta between input and output direction. Both frames have x along
/// the great circle, from input to output (Eq. 62). Returns 1 to continue, or 0 to stop with
/// NICOL_ERROR_CANCELLED. The function is called on the calling thread, and may call Nicol.
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
defaults!(nicol_file_options, nicol_file_options_init);
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

/// Report of a light, by channel. Means and fractions are taken over the sphere, weighted by solid angle, for
/// the image that would be written.
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
defaults!(nicol_light_report, nicol_light_report_init);
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

/// Report of a material, by channel, as far as coefficients up to `order` describe the material.
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
defaults!(nicol_material_report, nicol_material_report_init);
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
    /// Returns the version of the running library: major * 10000 + minor * 100 + patch.
    pub fn nicol_version() -> u32;
    /// Returns the version of the running library as text, such as "0.1.0". The string lives as long as the
    /// library.
    pub fn nicol_version_string() -> *const c_char;
    /// Returns a property of this build as "key=value" (source, compiler, backends, methods, max_order, ...).
    /// index counts from 0; an index past the last property gives NULL. "files" lists the kinds of files that the
    /// build reads: exr, bitmaps, mesh_files and scene_files may be left out; calls for the others fail with
    /// NICOL_ERROR_UNSUPPORTED. The string lives as long as the library.
    pub fn nicol_build_info(index: u32) -> *const c_char;
    /// Returns the message of the last failed call on this thread: one line that names the file, line, field or
    /// argument and what is expected. The message is never NULL, and "" before the first failure. The string is
    /// valid until this thread's next failed call. Tasks that move between threads, as in Go and in asynchronous
    /// runtimes, may see another task's message: they keep their thread for both calls, or use the error callback
    /// of nicol_context_options.
    pub fn nicol_last_error() -> *const c_char;
    /// Returns a name such as "out of memory" for a result code. The string lives as long as the library.
    pub fn nicol_result_name(result: nicol_result) -> *const c_char;
    pub fn nicol_spectrum_init(descriptor: *mut nicol_spectrum, struct_size: u32) -> nicol_result;
    /// Gets the number of devices for nicol_context_options.device. The devices are those that EGL lists, in EGL's
    /// order, which is neither CUDA's nor the kernel's. Without EGL the number is 0. The list may change when
    /// devices or drivers are added or removed.
    pub fn nicol_device_count(count: *mut u32) -> nicol_result;
    pub fn nicol_device_info_init(descriptor: *mut nicol_device_info, struct_size: u32) -> nicol_result;
    /// Gets the properties of a device; device is 1 to the number of nicol_device_count. Creating a context on the
    /// device may still fail, because this function does not create one.
    pub fn nicol_device_get_info(device: u32, info: *mut nicol_device_info) -> nicol_result;
    pub fn nicol_context_options_init(descriptor: *mut nicol_context_options, struct_size: u32) -> nicol_result;
    pub fn nicol_context_info_init(descriptor: *mut nicol_context_info, struct_size: u32) -> nicol_result;
    /// Creates a context. options may be NULL: all defaults. Returns NICOL_ERROR_NO_BACKEND if no such OpenGL
    /// context can be created.
    pub fn nicol_context_create(options: *const nicol_context_options, context: *mut nicol_context) -> nicol_result;
    pub fn nicol_context_retain(context: nicol_context) -> nicol_result;
    pub fn nicol_context_release(context: nicol_context) -> nicol_result;
    /// Replaces the log callback of nicol_context_options; NULL: silent from now on. When the function returns, no
    /// thread is in the callback before, whose user data may then be released.
    pub fn nicol_context_set_log(context: nicol_context, log: nicol_log_callback, log_user: *mut c_void) -> nicol_result;
    /// Gets the properties of the OpenGL context, and the limits in effect.
    pub fn nicol_context_get_info(context: nicol_context, info: *mut nicol_context_info) -> nicol_result;
    pub fn nicol_file_content_init(descriptor: *mut nicol_file_content, struct_size: u32) -> nicol_result;
    pub fn nicol_memory_file_init(descriptor: *mut nicol_memory_file, struct_size: u32) -> nicol_result;
    pub fn nicol_image_init(descriptor: *mut nicol_image, struct_size: u32) -> nicol_result;
    pub fn nicol_sky_init(descriptor: *mut nicol_sky, struct_size: u32) -> nicol_result;
    pub fn nicol_environment_load_options_init(descriptor: *mut nicol_environment_load_options, struct_size: u32) -> nicol_result;
    /// Loads an environment from files in the format that the path names:
    ///   NAME.exr      OpenEXR, equirectangular as nicol_image: R, G, B or Y are unpolarized light; S0.<colour> to
    ///                 S3.<colour> are polarized light, in nicol_image's frames. Spectral files (S0.550,000000nm and so on)
    ///                 have one channel per wavelength.
    ///   NAME_s0.exr   to NAME_s3.exr, any of the four, or NAME alone: a cube map as a cross of 4 x 3 faces, one file per
    ///                 Stokes component, as the Python package polarsh writes them.
    ///   NAME.hdr      Radiance HDR, equirectangular, unpolarized light.
    ///   NAME.png      or NAME.jpg, .bmp, .tga: equirectangular, unpolarized light, decoded from sRGB to 0 to 1.
    ///   NAME.npz      PSH coefficients as polarsh writes them (SHVec).
    /// options may be NULL: all defaults.
    pub fn nicol_environment_load(context: nicol_context, path: *const c_char, options: *const nicol_environment_load_options, environment: *mut nicol_environment) -> nicol_result;
    /// Loads an environment from memory. The resolver returns the other files of a cube map.
    pub fn nicol_environment_load_memory(context: nicol_context, file: *const nicol_memory_file, options: *const nicol_environment_load_options, environment: *mut nicol_environment) -> nicol_result;
    /// Creates an environment from an image in memory.
    pub fn nicol_environment_create_image(context: nicol_context, image: *const nicol_image, environment: *mut nicol_environment) -> nicol_result;
    /// Creates an environment of unpolarized light that is equal from all directions. radiance is finite and not
    /// negative; NULL or not given: 1 in one channel.
    pub fn nicol_environment_create_constant(context: nicol_context, radiance: *const nicol_spectrum, environment: *mut nicol_environment) -> nicol_result;
    /// Creates a clear sky without the sun's own disc.
    pub fn nicol_environment_create_sky(context: nicol_context, sky: *const nicol_sky, environment: *mut nicol_environment) -> nicol_result;
    /// Creates an environment from PSH coefficients over PROPAGATION directions in the world's axes,
    /// [channel][l*l + l + m][4] as nicol_psh.h defines. order is up to NICOL_PSH_MAX_ORDER (4096), channels 1 to
    /// NICOL_MAX_CHANNELS, and count = channels * 4 (order+1)^2. Coefficients p = 1, 2 below l = 2 must be 0. The
    /// light is band-limited and may ring: s0 may be below 0, and the polarization above s0.
    pub fn nicol_environment_create_psh(context: nicol_context, order: u32, channels: u32, coefficients: *const f64, count: u64, environment: *mut nicol_environment) -> nicol_result;
    pub fn nicol_environment_info_init(descriptor: *mut nicol_environment_info, struct_size: u32) -> nicol_result;
    /// Gets the properties of the light.
    pub fn nicol_environment_get_info(environment: nicol_environment, info: *mut nicol_environment_info) -> nicol_result;
    pub fn nicol_environment_retain(environment: nicol_environment) -> nicol_result;
    pub fn nicol_environment_release(environment: nicol_environment) -> nicol_result;
    pub fn nicol_texture_image_init(descriptor: *mut nicol_texture_image, struct_size: u32) -> nicol_result;
    pub fn nicol_texture_options_init(descriptor: *mut nicol_texture_options, struct_size: u32) -> nicol_result;
    /// Creates a texture from an image in memory and copies the pixels. options may be NULL: all defaults.
    pub fn nicol_texture_create_image(context: nicol_context, image: *const nicol_texture_image, options: *const nicol_texture_options, texture: *mut nicol_texture) -> nicol_result;
    /// Loads a texture from a file of PNG, JPEG, BMP, TGA, Radiance HDR, or OpenEXR with R G B or Y; A is the
    /// coverage. options may be NULL: all defaults.
    pub fn nicol_texture_load(context: nicol_context, path: *const c_char, options: *const nicol_texture_options, texture: *mut nicol_texture) -> nicol_result;
    /// Loads a texture from memory.
    pub fn nicol_texture_load_memory(context: nicol_context, file: *const nicol_memory_file, options: *const nicol_texture_options, texture: *mut nicol_texture) -> nicol_result;
    /// Creates Mitsuba 3's checkerboard of colours: four squares per unit square of u and v, color0 at u = v = 0.
    /// Colours have 1 or 3 values; NULL or not given: 0.4 and 0.2. to_uv is that of nicol_texture_options; NULL:
    /// identity.
    pub fn nicol_texture_create_checkerboard(context: nicol_context, color0: *const nicol_spectrum, color1: *const nicol_spectrum, to_uv: *const [f64; 9], texture: *mut nicol_texture) -> nicol_result;
    /// Creates a texture of the colours of the mesh's vertices, interpolated.
    pub fn nicol_texture_create_vertex_colors(context: nicol_context, texture: *mut nicol_texture) -> nicol_result;
    /// Creates a texture of the colours of the mesh's triangles. A material may use colours of triangles or of
    /// vertices, not both.
    pub fn nicol_texture_create_face_colors(context: nicol_context, texture: *mut nicol_texture) -> nicol_result;
    pub fn nicol_texture_retain(texture: nicol_texture) -> nicol_result;
    pub fn nicol_texture_release(texture: nicol_texture) -> nicol_result;
    pub fn nicol_film_init(descriptor: *mut nicol_film, struct_size: u32) -> nicol_result;
    pub fn nicol_pplastic_init(descriptor: *mut nicol_pplastic, struct_size: u32) -> nicol_result;
    /// Creates a material from nicol_pplastic. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that is
    /// out of range.
    pub fn nicol_material_create_pplastic(context: nicol_context, parameters: *const nicol_pplastic, material: *mut nicol_material) -> nicol_result;
    pub fn nicol_plastic_init(descriptor: *mut nicol_plastic, struct_size: u32) -> nicol_result;
    /// Creates a material from nicol_plastic. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that is
    /// out of range.
    pub fn nicol_material_create_plastic(context: nicol_context, parameters: *const nicol_plastic, material: *mut nicol_material) -> nicol_result;
    pub fn nicol_principled_init(descriptor: *mut nicol_principled, struct_size: u32) -> nicol_result;
    /// Creates a material from nicol_principled. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that
    /// is out of range. Returns NICOL_ERROR_UNSUPPORTED for a tint of a mesh's colours.
    pub fn nicol_material_create_principled(context: nicol_context, parameters: *const nicol_principled, material: *mut nicol_material) -> nicol_result;
    /// Creates a Lambertian, depolarizing material. reflectance is 0 to 1; NULL or not given: 0.5. Only the front
    /// side reflects.
    pub fn nicol_material_create_diffuse(context: nicol_context, reflectance: *const nicol_spectrum, material: *mut nicol_material) -> nicol_result;
    pub fn nicol_conductor_init(descriptor: *mut nicol_conductor, struct_size: u32) -> nicol_result;
    /// Creates a material from nicol_conductor. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that
    /// is out of range or, for an unknown metal, the known metals.
    pub fn nicol_material_create_conductor(context: nicol_context, parameters: *const nicol_conductor, material: *mut nicol_material) -> nicol_result;
    pub fn nicol_dielectric_init(descriptor: *mut nicol_dielectric, struct_size: u32) -> nicol_result;
    /// Creates a material from nicol_dielectric. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that
    /// is out of range.
    pub fn nicol_material_create_dielectric(context: nicol_context, parameters: *const nicol_dielectric, material: *mut nicol_material) -> nicol_result;
    pub fn nicol_measured_init(descriptor: *mut nicol_measured, struct_size: u32) -> nicol_result;
    /// Loads a material as Mitsuba 3's measured_polarized from a .pbsdf file, such as the KAIST data set has. The
    /// file is streamed: about 102 MB per channel stay in memory at the data set's resolution, or half as much if
    /// symmetrized. options may be NULL: all defaults. Only the front side reflects.
    pub fn nicol_material_load_measured(context: nicol_context, path: *const c_char, options: *const nicol_measured, material: *mut nicol_material) -> nicol_result;
    /// Loads a measured material from memory.
    pub fn nicol_material_load_measured_memory(context: nicol_context, file: *const nicol_memory_file, options: *const nicol_measured, material: *mut nicol_material) -> nicol_result;
    pub fn nicol_psh_matrix_init(descriptor: *mut nicol_psh_matrix, struct_size: u32) -> nicol_result;
    /// Loads an isotropic material from one PSH coefficient matrix per channel, cosine included: the .npz files of
    /// the Python package polarsh (SHMat in the layout ISOBI2). The material does not reflect light of orders
    /// above the matrix's. options may be NULL: all defaults. Only the front side reflects.
    pub fn nicol_material_load_psh(context: nicol_context, path: *const c_char, options: *const nicol_psh_matrix, material: *mut nicol_material) -> nicol_result;
    /// Loads a material of PSH matrices from memory.
    pub fn nicol_material_load_psh_memory(context: nicol_context, file: *const nicol_memory_file, options: *const nicol_psh_matrix, material: *mut nicol_material) -> nicol_result;
    /// Creates a material whose back side reflects as its front side. `front` may be released afterwards.
    pub fn nicol_material_create_twosided(context: nicol_context, front: nicol_material, material: *mut nicol_material) -> nicol_result;
    /// Creates the product of a material and a texture: a diffuse material of reflectance 1 gets the texture's
    /// colours. The given handles may be released afterwards.
    pub fn nicol_material_create_scaled(context: nicol_context, base: nicol_material, scale: nicol_texture, material: *mut nicol_material) -> nicol_result;
    /// Creates the mixture first (1 - t) + second t, with t = the weight's first channel, clamped to 0 to 1
    /// (Mitsuba 3's blendbsdf). If one material is two-sided, the mixture is too, and the other material is black
    /// on the back. The given handles may be released afterwards.
    pub fn nicol_material_create_blend(context: nicol_context, first: nicol_material, second: nicol_material, weight: nicol_texture, material: *mut nicol_material) -> nicol_result;
    /// Creates a material with perturbed normals from a raw texture with values t: shading normals 2 t - 1 in the
    /// frame of the surface, with x along growing u (Mitsuba 3's normalmap). mirrored_y 0: y completes a
    /// right-handed frame; 1: y points to where v falls, as in glTF. The two values differ where texture
    /// coordinates are mirrored. The given handles may be released afterwards.
    pub fn nicol_material_create_normal_map(context: nicol_context, base: nicol_material, normals: nicol_texture, mirrored_y: u32, material: *mut nicol_material) -> nicol_result;
    /// Creates a material with perturbed normals from heights: shading normals of a surface that is displaced
    /// along its normal by scale times the texture's first channel, in the scene's units (Mitsuba 3's bumpmap).
    /// The given handles may be released afterwards.
    pub fn nicol_material_create_bump_map(context: nicol_context, base: nicol_material, heights: nicol_texture, scale: f64, material: *mut nicol_material) -> nicol_result;
    /// Creates a material whose anisotropic parts are rotated within the surface, as by glTF's
    /// KHR_materials_anisotropy. directions is a raw texture with values t, or NULL: the first two of 2 t - 1 are
    /// the direction in which u would grow, in the frame of x along growing u and y to where v falls. angle, in
    /// radians from x towards y, is added. The given handles may be released afterwards.
    pub fn nicol_material_create_rotated(context: nicol_context, base: nicol_material, directions: nicol_texture, angle: f64, material: *mut nicol_material) -> nicol_result;
    /// Creates a material with an alpha mask: the surface is cut out where the opacity is below 0.5 (Mitsuba 3's
    /// mask of opacities 0 and 1). The opacity is the texture's coverage or, with fewer than four channels, the
    /// first channel. The given handles may be released afterwards.
    pub fn nicol_material_create_mask(context: nicol_context, base: nicol_material, opacity: nicol_texture, material: *mut nicol_material) -> nicol_result;
    pub fn nicol_callback_material_init(descriptor: *mut nicol_callback_material, struct_size: u32) -> nicol_result;
    /// Creates a material from a function, which must be isotropic, mirror symmetric about every plane through the
    /// normal, and finite. Returns NICOL_ERROR_INVALID_ARGUMENT if a test at some directions shows that the
    /// function is not. Only the front side reflects.
    pub fn nicol_material_create_callback(context: nicol_context, parameters: *const nicol_callback_material, material: *mut nicol_material) -> nicol_result;
    pub fn nicol_material_retain(material: nicol_material) -> nicol_result;
    pub fn nicol_material_release(material: nicol_material) -> nicol_result;
    pub fn nicol_mesh_data_init(descriptor: *mut nicol_mesh_data, struct_size: u32) -> nicol_result;
    /// Loads a mesh from OBJ, PLY, OFF, STL or the first mesh of Mitsuba's .serialized, by the file's suffix.
    /// Polygons may be concave. Triangles without area, vertices without a face, and elements that the reader
    /// ignores (materials) are left out; one line of the log counts them. Texture coordinates and colours of
    /// vertices and faces are kept. v of OBJ, which points up, becomes 1 - v. The message of
    /// NICOL_ERROR_INVALID_FILE names the line, vertex or face.
    pub fn nicol_mesh_load(context: nicol_context, path: *const c_char, mesh: *mut nicol_mesh) -> nicol_result;
    /// Loads a mesh from memory.
    pub fn nicol_mesh_load_memory(context: nicol_context, file: *const nicol_memory_file, mesh: *mut nicol_mesh) -> nicol_result;
    /// Creates a mesh from arrays and copies the arrays. A render adds vertices where shadows need them, see
    /// refine_tolerance of nicol_render_options.
    pub fn nicol_mesh_create(context: nicol_context, data: *const nicol_mesh_data, mesh: *mut nicol_mesh) -> nicol_result;
    /// Creates the unit sphere, divided finely enough for per-vertex shading, with the texture coordinates of
    /// Mitsuba 3's sphere.
    pub fn nicol_mesh_create_sphere(context: nicol_context, mesh: *mut nicol_mesh) -> nicol_result;
    /// Creates the unit sphere with a chosen number of vertices: 10 segments^2 + 2. The sphere is an icosahedron
    /// whose edges are each cut into `segments` parts; segments is even, 2 to 512. nicol_mesh_create_sphere has 38
    /// segments.
    pub fn nicol_mesh_create_divided_sphere(context: nicol_context, segments: u32, mesh: *mut nicol_mesh) -> nicol_result;
    /// Creates the rectangle [-1, 1]^2 in the plane z = 0, facing +z, with the texture coordinates of Mitsuba 3's
    /// rectangle.
    pub fn nicol_mesh_create_rectangle(context: nicol_context, mesh: *mut nicol_mesh) -> nicol_result;
    /// Creates the cube [-1, 1]^3, with the texture coordinates of Mitsuba 3's cube.
    pub fn nicol_mesh_create_cube(context: nicol_context, mesh: *mut nicol_mesh) -> nicol_result;
    /// Creates the disk of radius 1 in the plane z = 0, facing +z: 180 sectors of 16 rings, with the texture
    /// coordinates of Mitsuba 3's disk.
    pub fn nicol_mesh_create_disk(context: nicol_context, mesh: *mut nicol_mesh) -> nicol_result;
    /// Creates the cylinder of this radius around the line from p0 to p1, in the scene's units, without its ends:
    /// 180 sides, with the texture coordinates of Mitsuba 3's cylinder. The front is outside. radius must be above
    /// 0, and p0 and p1 must differ.
    pub fn nicol_mesh_create_cylinder(context: nicol_context, p0: *const [f64; 3], p1: *const [f64; 3], radius: f64, mesh: *mut nicol_mesh) -> nicol_result;
    pub fn nicol_deformation_init(descriptor: *mut nicol_deformation, struct_size: u32) -> nicol_result;
    /// Creates a mesh with the triangles, texture coordinates and colours of `base`, without its tangents, and
    /// with other positions and normals, for nicol_scene_set_mesh. Triangles may lose their area, and stay. `base`
    /// may be released afterwards.
    pub fn nicol_mesh_create_deformed(context: nicol_context, base: nicol_mesh, deformation: *const nicol_deformation, mesh: *mut nicol_mesh) -> nicol_result;
    /// Gets the numbers of vertices and triangles of a mesh.
    pub fn nicol_mesh_get_size(mesh: nicol_mesh, vertices: *mut u32, triangles: *mut u32) -> nicol_result;
    /// Gets the box of the mesh in its own axes: the least and the largest coordinates.
    pub fn nicol_mesh_get_bounds(mesh: nicol_mesh, lower: *mut [f64; 3], upper: *mut [f64; 3]) -> nicol_result;
    pub fn nicol_mesh_retain(mesh: nicol_mesh) -> nicol_result;
    pub fn nicol_mesh_release(mesh: nicol_mesh) -> nicol_result;
    pub fn nicol_camera_init(descriptor: *mut nicol_camera, struct_size: u32) -> nicol_result;
    /// Sets to_world, and no other field, to that of a camera at `origin` that looks at `target`. `up` must not
    /// lie along the view.
    pub fn nicol_camera_look_at(camera: *mut nicol_camera, origin: *const [f64; 3], target: *const [f64; 3], up: *const [f64; 3]) -> nicol_result;
    /// Sets to_world, fov, shift, pixel_aspect and projection, and no other field, to those of a pinhole camera in
    /// OpenCV's convention: a point X of the world is at x = R X + t, with x[0] to the right, x[1] down and x[2]
    /// forward, and there at the pixel (fx x[0] / x[2] + cx, fy x[1] / x[2] + cy), where (0, 0) is the MIDDLE of
    /// the first pixel and K = [fx 0 cx; 0 fy cy; 0 0 1]. Matrices are row-major. Undistort images first: there is
    /// no lens distortion. (COLMAP has the same R and t, and 0.5 more in cx and cy.)
    pub fn nicol_camera_set_opencv(camera: *mut nicol_camera, K: *const [f64; 9], R: *const [f64; 9], t: *const [f64; 3], width: u32, height: u32) -> nicol_result;
    /// Gets the pinhole camera of a perspective camera, for an image of this size; jitter is left out.
    pub fn nicol_camera_get_opencv(camera: *const nicol_camera, width: u32, height: u32, K: *mut [f64; 9], R: *mut [f64; 9], t: *mut [f64; 3]) -> nicol_result;
    /// Moves the camera, without turning it, so that the box from `lower` to `upper` is in the image of this size
    /// and as large as it can be. near_clip and far_clip enclose the box; an orthographic camera gets another half
    /// extent. nicol_scene_get_bounds has the box of a scene.
    pub fn nicol_camera_frame(camera: *mut nicol_camera, lower: *const [f64; 3], upper: *const [f64; 3], width: u32, height: u32) -> nicol_result;
    pub fn nicol_polarization_init(descriptor: *mut nicol_polarization, struct_size: u32) -> nicol_result;
    pub fn nicol_light_init(descriptor: *mut nicol_light, struct_size: u32) -> nicol_result;
    /// Fills a light with the sun of a sky: a directional light that comes from sun_direction, with an
    /// angular_radius of 0.27 degrees. Its value is an irradiance in the units of the sky's radiance. The sun is a
    /// black body of 5778 K and 128 klx above the atmosphere, attenuated by the air, haze and ozone of the sky's
    /// turbidity (Preetham et al. 1999). A sky of turbidity 0 gets the sun of turbidity 1.7. A sun below the
    /// horizon has a value of 0.
    pub fn nicol_sky_get_sun(sky: *const nicol_sky, light: *mut nicol_light) -> nicol_result;
    pub fn nicol_emission_init(descriptor: *mut nicol_emission, struct_size: u32) -> nicol_result;
    pub fn nicol_polarization_element_init(descriptor: *mut nicol_polarization_element, struct_size: u32) -> nicol_result;
    pub fn nicol_instance_init(descriptor: *mut nicol_instance, struct_size: u32) -> nicol_result;
    /// Creates an empty, dark scene.
    pub fn nicol_scene_create(context: nicol_context, scene: *mut nicol_scene) -> nicol_result;
    /// Loads a scene from a Mitsuba 3 XML file, or from glTF 2.0 if the name ends in .gltf or .glb (the subsets
    /// that samples/render/README.md lists). definitions are "name=value" strings that override <default>s of the
    /// XML. Those of glTF are time=SECONDS, at which the file's animation is drawn, and animation=NAME, its name
    /// or number, the first by default. A glTF file has no environment, and may have lights. Lights that
    /// polarization elements of the file cover get the polarization state and the brightness that their light has
    /// behind the elements.
    pub fn nicol_scene_load(context: nicol_context, path: *const c_char, definitions: *const *const c_char, definition_count: u32, scene: *mut nicol_scene) -> nicol_result;
    /// Moves a scene that was loaded from a glTF file with animations to a time, in seconds. Instances, deformed
    /// meshes, lights and camera (nicol_scene_get_camera) become those that nicol_scene_load gives for the
    /// definition time. The animation is that of the scene's definition animation, or the first one. Meshes,
    /// transforms and places of lights that were set after loading are replaced; removed instances and lights stay
    /// removed. An instance that the animation scales to 0 is removed, and returns under another id. The next
    /// render bakes what has moved. Returns NICOL_ERROR_INVALID_ARGUMENT for a time that is not finite, and
    /// NICOL_ERROR_UNSUPPORTED for a scene without animations.
    pub fn nicol_scene_set_time(scene: nicol_scene, time: f64) -> nicol_result;
    /// Loads a scene from memory: XML, glTF as JSON, or GLB. The resolver returns the scene's other files.
    pub fn nicol_scene_load_memory(context: nicol_context, file: *const nicol_memory_file, definitions: *const *const c_char, definition_count: u32, scene: *mut nicol_scene) -> nicol_result;
    /// Adds an instance. id may be NULL; ids count up from 0, past those of removed instances too. The mesh must
    /// have the texture coordinates and colours that the material needs. Materials and environment of a scene must
    /// have one colour channel or the same number of channels.
    pub fn nicol_scene_add_instance(scene: nicol_scene, instance: *const nicol_instance, id: *mut u32) -> nicol_result;
    /// Sets the transform of an instance; to_world is that of nicol_instance. The next render bakes again the
    /// vertices that the instance may shadow, before or now. A scene that rotates and moves as a whole is only
    /// relit.
    pub fn nicol_scene_set_transform(scene: nicol_scene, id: u32, to_world: *const [f64; 16]) -> nicol_result;
    /// Sets the mesh of an instance, under the conditions of nicol_scene_add_instance. The next render bakes again
    /// the instance and the vertices that it may shadow, before or now. An instance whose meshes have the same
    /// triangles, such as those of nicol_mesh_create_deformed, keeps its former shadows until they are baked, see
    /// bake_budget_ms of nicol_render_options.
    pub fn nicol_scene_set_mesh(scene: nicol_scene, id: u32, mesh: nicol_mesh) -> nicol_result;
    /// Sets the material of an instance, under the conditions of nicol_scene_add_instance. The next render
    /// projects the material, if it is new to the scene, and shades the instance.
    pub fn nicol_scene_set_material(scene: nicol_scene, id: u32, material: nicol_material) -> nicol_result;
    /// Sets the flags of an instance, as in nicol_instance. The next render repeats the bake of the instance
    /// and of the vertices that it may shadow. Returns NICOL_ERROR_INVALID_ARGUMENT for unknown flags.
    pub fn nicol_scene_set_instance_flags(scene: nicol_scene, id: u32, flags: u32) -> nicol_result;
    /// Gets the flags of an instance.
    pub fn nicol_scene_get_instance_flags(scene: nicol_scene, id: u32, flags: *mut u32) -> nicol_result;
    /// Removes an instance. The id is not used again; other instances keep their ids.
    pub fn nicol_scene_remove_instance(scene: nicol_scene, id: u32) -> nicol_result;
    /// Gets the parts of an instance: mesh and material as handles to release, and the transform. Each of the
    /// three may be NULL.
    pub fn nicol_scene_get_instance(scene: nicol_scene, id: u32, mesh: *mut nicol_mesh, material: *mut nicol_material, to_world: *mut [f64; 16]) -> nicol_result;
    /// Gets the box of all instances in the world, without local lights, which have no surface. Returns
    /// NICOL_ERROR_INVALID_ARGUMENT for a scene without instances.
    pub fn nicol_scene_get_bounds(scene: nicol_scene, lower: *mut [f64; 3], upper: *mut [f64; 3]) -> nicol_result;
    /// Gets the number of instances.
    pub fn nicol_scene_get_instance_count(scene: nicol_scene, instances: *mut u32) -> nicol_result;
    /// Gets the ids of all instances, ascending. count must be the number of instances.
    pub fn nicol_scene_get_instance_ids(scene: nicol_scene, ids: *mut u32, count: u64) -> nicol_result;
    /// Sets the environment; NULL: darkness. to_world is a proper rotation of the environment; NULL: identity.
    /// scale is a factor on the radiance, finite and not negative; 1: no change; 0: darkness.
    pub fn nicol_scene_set_environment(scene: nicol_scene, environment: nicol_environment, to_world: *const [f64; 16], scale: f64) -> nicol_result;
    /// Gets the arguments of nicol_scene_set_environment: the environment, as a handle to release, its rotation
    /// and scale. to_world and scale may be NULL. In darkness, including a file's scale of 0, *environment is
    /// NULL, to_world the identity and scale 1.
    pub fn nicol_scene_get_environment(scene: nicol_scene, environment: *mut nicol_environment, to_world: *mut [f64; 16], scale: *mut f64) -> nicol_result;
    /// Sets whether emitters are hidden from the camera. hide 1: no light goes straight to the camera from the
    /// environment, which leaves black (alpha 0), or from instances that emit, which show only their reflection;
    /// both light the scene as before. hide 0: the camera sees emitters, unless the scene's file has
    /// hide_emitters.
    pub fn nicol_scene_hide_emitters(scene: nicol_scene, hide: u32) -> nicol_result;
    /// Adds a light. id may be NULL; ids of lights count up from 0, independently of instances. Lights, and the
    /// emission of instances, must have one colour channel or as many as the scene. The handle of the texture may
    /// be released afterwards. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that is out of
    /// range.
    pub fn nicol_scene_add_light(scene: nicol_scene, light: *const nicol_light, id: *mut u32) -> nicol_result;
    /// Replaces all fields of a light. The next render bakes nothing. The message of NICOL_ERROR_INVALID_ARGUMENT
    /// names the field that is out of range.
    pub fn nicol_scene_set_light(scene: nicol_scene, id: u32, light: *const nicol_light) -> nicol_result;
    /// Removes a light. The id is not used again; other lights keep their ids.
    pub fn nicol_scene_remove_light(scene: nicol_scene, id: u32) -> nicol_result;
    /// Gets a light as it was given. *texture, and not light->texture, is the light's texture as a handle to
    /// release, or NULL if the light has none. texture may be NULL.
    pub fn nicol_scene_get_light(scene: nicol_scene, id: u32, light: *mut nicol_light, texture: *mut nicol_texture) -> nicol_result;
    /// Gets the number of lights.
    pub fn nicol_scene_get_light_count(scene: nicol_scene, lights: *mut u32) -> nicol_result;
    /// Gets the ids of all lights, ascending. count must be the number of lights.
    pub fn nicol_scene_get_light_ids(scene: nicol_scene, ids: *mut u32, count: u64) -> nicol_result;
    /// Sets the emission of the instance `id`; NULL: the instance emits no light. A texture needs texture
    /// coordinates of the mesh. The message of NICOL_ERROR_INVALID_ARGUMENT names the field that is out of
    /// range.
    pub fn nicol_scene_set_emission(scene: nicol_scene, id: u32, emission: *const nicol_emission) -> nicol_result;
    /// Gets the emission of an instance, with its texture as nicol_scene_get_light does. The radiance is 0 for an
    /// instance that emits no light.
    pub fn nicol_scene_get_emission(scene: nicol_scene, id: u32, emission: *mut nicol_emission, texture: *mut nicol_texture) -> nicol_result;
    /// Adds a polarization element. id may be NULL; ids of elements count up from 0, independently of instances
    /// and lights. The handles of the textures may be released afterwards. The message of
    /// NICOL_ERROR_INVALID_ARGUMENT names the field that is out of range.
    pub fn nicol_scene_add_polarization_element(scene: nicol_scene, element: *const nicol_polarization_element, id: *mut u32) -> nicol_result;
    /// Replaces all fields of a polarization element. The message of NICOL_ERROR_INVALID_ARGUMENT names the field
    /// that is out of range.
    pub fn nicol_scene_set_polarization_element(scene: nicol_scene, id: u32, element: *const nicol_polarization_element) -> nicol_result;
    /// Removes a polarization element. The id is not used again; other elements keep their ids.
    pub fn nicol_scene_remove_polarization_element(scene: nicol_scene, id: u32) -> nicol_result;
    /// Gets a polarization element as it was given, but for its textures, which are NULL.
    pub fn nicol_scene_get_polarization_element(scene: nicol_scene, id: u32, element: *mut nicol_polarization_element) -> nicol_result;
    /// Gets the textures of a polarization element as handles to release; NULL for none. angle or retardance may
    /// be NULL.
    pub fn nicol_scene_get_polarization_element_textures(scene: nicol_scene, id: u32, angle: *mut nicol_texture, retardance: *mut nicol_texture) -> nicol_result;
    /// Gets the number of polarization elements.
    pub fn nicol_scene_get_polarization_element_count(scene: nicol_scene, elements: *mut u32) -> nicol_result;
    /// Gets the ids of all polarization elements, ascending. count must be the number of elements.
    pub fn nicol_scene_get_polarization_element_ids(scene: nicol_scene, ids: *mut u32, count: u64) -> nicol_result;
    /// Gets the camera of a loaded file. Returns NICOL_ERROR_UNSUPPORTED for a scene that was not loaded.
    pub fn nicol_scene_get_camera(scene: nicol_scene, camera: *mut nicol_camera) -> nicol_result;
    /// Gets the film size of a loaded file, in pixels. Returns NICOL_ERROR_UNSUPPORTED for a scene that was not
    /// loaded.
    pub fn nicol_scene_get_film_size(scene: nicol_scene, width: *mut u32, height: *mut u32) -> nicol_result;
    /// Gets the samples of a pixel that the sampler of a loaded file asks for, 0 if there is no sampler; for the
    /// pixel_samples of nicol_render_options. Returns NICOL_ERROR_UNSUPPORTED for a scene that was not loaded.
    pub fn nicol_scene_get_sample_count(scene: nicol_scene, samples: *mut u32) -> nicol_result;
    /// Gets the largest max_depth that the integrators of a loaded file ask for, for nicol_render_options: 1 or
    /// more, or NICOL_DEPTH_UNLIMITED, which is Mitsuba's default; 0 if there is no integrator. Returns
    /// NICOL_ERROR_UNSUPPORTED for a scene that was not loaded.
    pub fn nicol_scene_get_max_depth(scene: nicol_scene, max_depth: *mut i32) -> nicol_result;
    /// Gets the AOVs that the integrators of a loaded file ask for, a sum of NICOL_AOV_... for
    /// nicol_render_options. Returns NICOL_ERROR_UNSUPPORTED for a scene that was not loaded.
    pub fn nicol_scene_get_aovs(scene: nicol_scene, aovs: *mut u32) -> nicol_result;
    pub fn nicol_scene_file_init(descriptor: *mut nicol_scene_file, struct_size: u32) -> nicol_result;
    /// Gets the number of files that nicol_scene_load has read, or 0 for a scene that was not loaded. Each file
    /// counts once: the scene file, the files that it includes (the buffers of glTF), then light, materials and
    /// meshes. Scenes whose files have equal digests are equal.
    pub fn nicol_scene_get_file_count(scene: nicol_scene, count: *mut u32) -> nicol_result;
    /// Gets a file that nicol_scene_load has read; index counts from 0. Returns NICOL_ERROR_INVALID_ARGUMENT for
    /// an index beyond the last file.
    pub fn nicol_scene_get_file(scene: nicol_scene, index: u32, file: *mut nicol_scene_file) -> nicol_result;
    /// Gets the number of colour channels of the scene's images: the number of everything in the scene, 1 (all
    /// grey) or more, and 1 if the film of a loaded file is luminance.
    pub fn nicol_scene_get_channels(scene: nicol_scene, channels: *mut u32) -> nicol_result;
    pub fn nicol_scene_retain(scene: nicol_scene) -> nicol_result;
    pub fn nicol_scene_release(scene: nicol_scene) -> nicol_result;
    pub fn nicol_filter_init(descriptor: *mut nicol_filter, struct_size: u32) -> nicol_result;
    /// Gets the filter that the film of a loaded file asks for, for nicol_render_options: Gaussian, which is
    /// Mitsuba's default, if a Mitsuba file names none; box for glTF. Returns NICOL_ERROR_UNSUPPORTED for a scene
    /// that was not loaded.
    pub fn nicol_scene_get_filter(scene: nicol_scene, filter: *mut nicol_filter) -> nicol_result;
    pub fn nicol_render_options_init(descriptor: *mut nicol_render_options, struct_size: u32) -> nicol_result;
    /// Sets the options of the real-time methods that trade time for accuracy: tolerance, pixel_samples,
    /// bake_directions, refine_tolerance, light_samples and bsdf_samples. All other options stay. Options that are
    /// set afterwards win. Returns NICOL_ERROR_INVALID_ARGUMENT for another quality.
    pub fn nicol_render_options_set_quality(options: *mut nicol_render_options, quality: nicol_quality) -> nicol_result;
    /// Creates a framebuffer. width and height are 1 to NICOL_MAX_SIZE pixels (the driver may allow less), and at
    /// most 2^26 pixels in all. channels is the scene's number, or 1 for the luminance of a scene of three
    /// channels: 0.2126 R + 0.7152 G + 0.0722 B of each Stokes component.
    pub fn nicol_framebuffer_create(context: nicol_context, width: u32, height: u32, channels: u32, framebuffer: *mut nicol_framebuffer) -> nicol_result;
    /// Changes the size, within the limits of nicol_framebuffer_create, and keeps the handle and the channels. The
    /// content is lost and undefined until the next render, and textures get other names; nothing happens if the
    /// size is the same. A job or another render that was given the framebuffer before puts its image into the
    /// former content, which is lost.
    pub fn nicol_framebuffer_resize(framebuffer: nicol_framebuffer, width: u32, height: u32) -> nicol_result;
    /// Gets the width, height and channels of the framebuffer.
    pub fn nicol_framebuffer_get_size(framebuffer: nicol_framebuffer, width: *mut u32, height: *mut u32, channels: *mut u32) -> nicol_result;
    /// Replaces the image of a framebuffer by (1 - weight) times this image plus weight times the image of
    /// `other`, in each Stokes component. weight is 0 to 1. AOVs and statistics do not change. For motion blur,
    /// the mean of n pictures, blend picture k, counted from 1, with weight 1 / k. Returns
    /// NICOL_ERROR_INVALID_ARGUMENT if the framebuffers are the same one, or differ in size or channels.
    pub fn nicol_framebuffer_blend(framebuffer: nicol_framebuffer, other: nicol_framebuffer, weight: f64) -> nicol_result;
    pub fn nicol_framebuffer_retain(framebuffer: nicol_framebuffer) -> nicol_result;
    pub fn nicol_framebuffer_release(framebuffer: nicol_framebuffer) -> nicol_result;
    /// Renders a scene into a framebuffer. options may be NULL: all defaults. Results that a change of the scene,
    /// the camera or the options does not affect are kept from the scene's last render; if nothing changed,
    /// nothing runs. On failure or cancellation the framebuffer keeps its content and statistics. Returns
    /// NICOL_ERROR_INVALID_ARGUMENT for options and cameras out of range and for channels that do not fit. Returns
    /// NICOL_ERROR_UNSUPPORTED for an unknown method, for compute shaders if the driver lacks features, and, if a
    /// material varies by a texture, for the dense method and for shading at vertices. Returns
    /// NICOL_ERROR_CANCELLED if a callback returned 0, NICOL_ERROR_BUSY as fail_if_busy says, and
    /// NICOL_ERROR_OUT_OF_MEMORY also beyond the context's memory_limit.
    pub fn nicol_render(scene: nicol_scene, camera: *const nicol_camera, options: *const nicol_render_options, framebuffer: nicol_framebuffer) -> nicol_result;
    /// Renders several views of a scene, such as the faces of a cube or the cameras of a rig: the view of
    /// cameras[i] into framebuffers[i]. The images are those of nicol_render, called for one view after the other,
    /// but the views share one bake of what all of them need, and the light of each vertex. count is the number of
    /// views, 1 to NICOL_MAX_VIEWS. All cameras have the struct_size of cameras[0]. The framebuffers are different
    /// ones and may differ in size. options apply to each view, NULL: all defaults; bake_budget_ms is the time for
    /// all views together. The statistics of the first view that is drawn include the bake. Invalid arguments are
    /// refused before anything is rendered. After another failure or cancellation, the views before it have their
    /// images. Returns the results of nicol_render.
    pub fn nicol_render_views(scene: nicol_scene, cameras: *const nicol_camera, framebuffers: *const nicol_framebuffer, count: u32, options: *const nicol_render_options) -> nicol_result;
    /// Submits nicol_render as a job. The job copies the scene's state: later changes affect later renders only.
    /// The framebuffer keeps its content until the job puts its image there. Scene, framebuffer and all they need
    /// are kept alive. The caller may release them, and the job too, which runs all the same. The progress
    /// callback runs on the context's thread, and progress_user must live until the job is done. Invalid arguments
    /// are refused at once if possible; other errors are the job's result. Returns NICOL_ERROR_BUSY if
    /// NICOL_MAX_JOBS jobs are queued. A process that exits cancels its jobs.
    pub fn nicol_render_async(scene: nicol_scene, camera: *const nicol_camera, options: *const nicol_render_options, framebuffer: nicol_framebuffer, job: *mut nicol_job) -> nicol_result;
    pub fn nicol_job_status_init(descriptor: *mut nicol_job_status, struct_size: u32) -> nicol_result;
    /// Gets the job's progress, and never waits for the job.
    pub fn nicol_job_poll(job: nicol_job, status: *mut nicol_job_status) -> nicol_result;
    /// Waits until the job is done, at most timeout_ms milliseconds (0: not at all), and returns the job's result.
    /// After a failure of the job, nicol_last_error() has its message. Returns NICOL_ERROR_TIMEOUT if the job is
    /// not done in time, and NICOL_ERROR_NOT_CURRENT if the job needs a host's OpenGL context that is not current
    /// on the calling thread. Returns NICOL_ERROR_INVALID_ARGUMENT inside a callback of the context, because
    /// waiting there would be a deadlock.
    pub fn nicol_job_wait(job: nicol_job, timeout_ms: u32) -> nicol_result;
    /// Cancels a queued job at once, or a running job when it would next call a progress callback. The job's
    /// result is NICOL_ERROR_CANCELLED. A job that is done or almost done is not affected. The function does not
    /// wait.
    pub fn nicol_job_cancel(job: nicol_job) -> nicol_result;
    pub fn nicol_job_retain(job: nicol_job) -> nicol_result;
    pub fn nicol_job_release(job: nicol_job) -> nicol_result;
    pub fn nicol_statistics_init(descriptor: *mut nicol_statistics, struct_size: u32) -> nicol_result;
    /// Gets the statistics of the last render into a framebuffer: all zeros before the first render.
    pub fn nicol_framebuffer_get_statistics(framebuffer: nicol_framebuffer, statistics: *mut nicol_statistics) -> nicol_result;
    /// Copies one plane of one colour channel, first row at the top. row_stride is in bytes; 0: tightly packed.
    /// byte_size is the room at pixels, in bytes. Returns NICOL_ERROR_INVALID_ARGUMENT for a plane that does not
    /// exist, and for NICOL_PLANE_INSTANCE, which holds no floats.
    pub fn nicol_framebuffer_read(framebuffer: nicol_framebuffer, plane: nicol_plane, channel: u32, pixels: *mut f32, row_stride: u64, byte_size: u64) -> nicol_result;
    pub fn nicol_plane_buffer_init(descriptor: *mut nicol_plane_buffer, struct_size: u32) -> nicol_result;
    /// Copies a plane in the format and with the channels of `to`. Bytes between rows are not written. A call that
    /// fails writes nothing.
    pub fn nicol_framebuffer_read_plane(framebuffer: nicol_framebuffer, to: *const nicol_plane_buffer) -> nicol_result;
    /// Writes an OpenEXR file of 32-bit floats, whose channels are named by the number of colour channels:
    ///   3             R G B (which are s0) and S0.R S0.G S0.B to S3.R S3.G S3.B, as Mitsuba 3's stokes integrator
    ///   1             Y (which is s0) and S0.Y to S3.Y
    ///   2, 4 to 16    S0.0 S0.1 ... to S3.0 S3.1 ...
    /// A path that ends as the names of another kind of image do, such as .png, is refused.
    /// AOVs of the last render are Z (depth), N.X N.Y N.Z, P.X P.Y P.Z, id (32-bit unsigned), A (alpha; R G B still have the
    /// environment) and, for each Stokes channel, variance.S0.R ... variance.S3.B.
    pub fn nicol_framebuffer_write_exr(framebuffer: nicol_framebuffer, path: *const c_char) -> nicol_result;
    /// Passes the bytes of the file that nicol_framebuffer_write_exr writes to a sink. The sink is called after
    /// all bytes are made; user is its first argument.
    pub fn nicol_framebuffer_encode_exr(framebuffer: nicol_framebuffer, sink: nicol_sink_callback, user: *mut c_void) -> nicol_result;
    pub fn nicol_observation_init(descriptor: *mut nicol_observation, struct_size: u32) -> nicol_result;
    /// Writes a PNG file of 8-bit RGB; a path that ends as the names of another kind of image do, such as .jpg, is
    /// refused. S0 and POLARIZER need a framebuffer of 1 or 3 channels; the other kinds
    /// show the mean of the channels.
    pub fn nicol_framebuffer_write_png(framebuffer: nicol_framebuffer, observation: *const nicol_observation, path: *const c_char) -> nicol_result;
    /// Passes the bytes of the file that nicol_framebuffer_write_png writes to a sink. The sink is called after
    /// all bytes are made; user is its first argument.
    pub fn nicol_framebuffer_encode_png(framebuffer: nicol_framebuffer, observation: *const nicol_observation, sink: nicol_sink_callback, user: *mut c_void) -> nicol_result;
    pub fn nicol_sensor_init(descriptor: *mut nicol_sensor, struct_size: u32) -> nicol_result;
    /// Sets the fields of a preset.
    pub fn nicol_sensor_set_preset(sensor: *mut nicol_sensor, preset: nicol_sensor_preset) -> nicol_result;
    /// Sets the fields that a JSON file names, or those of a mosaic that nicol_sensor_write_png wrote. The file is
    /// an object with the names of the fields, and "preset" ("imx250mzr", "imx250myr") and "elements", a list of
    /// objects with "kind" ("polarizer", "retarder", "right_circular", "left_circular"), "angle", "retardance",
    /// "transmittance" and "extinction_ratio", in the order of the light.
    pub fn nicol_sensor_load(sensor: *mut nicol_sensor, path: *const c_char) -> nicol_result;
    /// Sets the fields that a file in memory names, as nicol_sensor_load does.
    pub fn nicol_sensor_load_memory(sensor: *mut nicol_sensor, file: *const nicol_memory_file) -> nicol_result;
    /// Multiplies the sensor's optics by the matrix of an element that faces the camera, between the optics and
    /// the sensor; angles are counter-clockwise from image right. The element's to_world must be the identity, and
    /// its outline has no effect, and it must have no textures. extinction_ratio: transmittance along over across
    /// a polarizer's axis, at least 1; 0: an ideal polarizer.
    pub fn nicol_sensor_add_element(sensor: *mut nicol_sensor, element: *const nicol_polarization_element, extinction_ratio: f64) -> nicol_result;
    pub fn nicol_stokes_image_init(descriptor: *mut nicol_stokes_image, struct_size: u32) -> nicol_result;
    pub fn nicol_raw_image_init(descriptor: *mut nicol_raw_image, struct_size: u32) -> nicol_result;
    /// Exposes the sensor to light, and writes the numbers to `to`, which has the light's size. Frames with other
    /// numbers have other noise. Light that is not finite is refused.
    pub fn nicol_sensor_expose(sensor: *const nicol_sensor, light: *const nicol_stokes_image, frame: u64, to: *const nicol_raw_image) -> nicol_result;
    /// Exposes the sensor to the last image of a framebuffer.
    pub fn nicol_framebuffer_expose(framebuffer: nicol_framebuffer, sensor: *const nicol_sensor, frame: u64, to: *const nicol_raw_image) -> nicol_result;
    /// Writes numbers as a grey PNG: 8 bits, or 16 bits if the sensor has more than 8. The file names the mosaic,
    /// the bits and the sensor in the text chunks Nicol:Mosaic, Nicol:Bits and Nicol:Sensor.
    pub fn nicol_sensor_write_png(sensor: *const nicol_sensor, raw: *const nicol_raw_image, path: *const c_char) -> nicol_result;
    /// Computes the light on the sensor, behind its optics, from numbers of its pixels, by the sensor's exposure,
    /// quantum efficiency, gain, levels and extinction ratio. The pixels' own errors and crosstalk are not undone.
    /// `to` has 3 channels with colour filters, else 1, and s3 = 0; NICOL_MOSAIC_PLAIN gives s0 alone.
    pub fn nicol_sensor_demosaic(sensor: *const nicol_sensor, raw: *const nicol_raw_image, method: nicol_demosaic, to: *const nicol_stokes_image) -> nicol_result;
    pub fn nicol_gradient_init(descriptor: *mut nicol_gradient, struct_size: u32) -> nicol_result;
    /// Computes gradients of a function f of the image that nicol_render makes with this camera and these options. The image is
    /// linear in its light: image = A light. The gradient by the light is the transpose of A times the gradient by the image. For
    /// f = |image - measured|^2 / 2, `picture` is image - measured, and conjugate gradients recover the light.
    ///   picture       Derivatives of f by the Stokes vectors of the pixels, in all channels of the scene. Its size is the image's.
    ///   Cost          About that of an image whose light has changed, and by texels three to five times as much: with 512 x 512
    ///                 pixels, an image took 86 ms, gradients by instances 151, by the environment 108 and by texels 245 ms.
    ///                 Nothing is drawn into a framebuffer.
    ///   Bake          Gradients need all Stokes components. Callers that alternate between images and gradients should disable
    ///                 NICOL_OPTIMISATION_LIGHT_COMPONENTS for both, because the bake then serves both.
    ///   Options       method factored; executor automatic or cpu; physical 0; order_low and order_high given and equal, or
    ///                 high_orders none; shade_at pixels, or automatic if that shades pixels; pixel_samples 0, 1, 4 or 8; filter
    ///                 box; max_depth 0 or 2, or more for the gradient by the environment alone; both time budgets 0; split_lights
    ///                 0 and bsdf_samples 0 if the image would otherwise have extracted lights or samples of the environment.
    ///   Scene         No mirrors, no smooth glass, and with a max_depth above 2 no narrow metal; no polarization elements. The
    ///                 gradient by the environment needs hidden emitters, that by instances no emissive surfaces, and those by
    ///                 lights, by instances and by texels no local light of the value 0.
    /// Returns NICOL_ERROR_UNSUPPORTED for other options and scenes, with a message that says what to change.
    /// Returns NICOL_ERROR_INVALID_ARGUMENT for sizes that do not fit, for numbers that are not finite, for a local light of the
    /// value 0, and if the gradient by the environment is wanted without an environment, or by a texture that no instance's material
    /// reflects by; else the results of nicol_render. A call that fails writes nothing.
    pub fn nicol_render_adjoint(scene: nicol_scene, camera: *const nicol_camera, options: *const nicol_render_options, picture: *const nicol_stokes_image, gradient: *const nicol_gradient) -> nicol_result;
    pub fn nicol_host_init(descriptor: *mut nicol_host, struct_size: u32) -> nicol_result;
    /// Creates a context inside the OpenGL context that is current: OpenGL 4.5 or newer, of the core or the
    /// compatibility profile. options are those of nicol_context_create, with backend and device 0. Returns
    /// NICOL_ERROR_NOT_CURRENT if is_current returns 0, and NICOL_ERROR_NO_BACKEND if there is no such
    /// OpenGL.
    pub fn nicol_context_create_host(host: *const nicol_host, options: *const nicol_context_options, context: *mut nicol_context) -> nicol_result;
    /// Creates a framebuffer whose images are textures of the host's, one for each channel: level 0 of a
    /// GL_TEXTURE_2D of GL_RGBA32F, allocated by glTexStorage2D or glTextureStorage2D, all of one size. A texel is
    /// the Stokes vector, and row 0 the image's TOP. The textures must live until the framebuffer is released;
    /// Nicol never deletes them. The host may sample them between renders, and must not write them while the
    /// framebuffer lives. nicol_framebuffer_resize fails with NICOL_ERROR_UNSUPPORTED. Returns
    /// NICOL_ERROR_INVALID_ARGUMENT that names a texture which cannot be used, and NICOL_ERROR_UNSUPPORTED for a
    /// context that is not a host's.
    pub fn nicol_framebuffer_create_textures(context: nicol_context, textures: *const u32, channels: u32, framebuffer: *mut nicol_framebuffer) -> nicol_result;
    pub fn nicol_gl_texture_init(descriptor: *mut nicol_gl_texture, struct_size: u32) -> nicol_result;
    /// Gets the texture of a colour channel: a texel is the Stokes vector (s0, s1, s2, s3), and row 0 is the
    /// image's TOP. The name is valid, and stays the same, until the framebuffer is released or resized; the
    /// content is that of the last render. The host may sample the texture and change its filters and wrap modes,
    /// but not its swizzle, and must neither write nor delete the texture. Returns NICOL_ERROR_UNSUPPORTED for a
    /// framebuffer whose context is not a host's.
    pub fn nicol_framebuffer_get_texture(framebuffer: nicol_framebuffer, channel: u32, texture: *mut nicol_gl_texture) -> nicol_result;
    pub fn nicol_texture_target_init(descriptor: *mut nicol_texture_target, struct_size: u32) -> nicol_result;
    /// Copies a plane of one channel into a texture; nothing is read back. A texel gets the numbers that
    /// nicol_framebuffer_read copies, in red, green, blue and alpha; components that the plane does not have are
    /// 0, and alpha 1. The texture may also be of GL_R16F or GL_R32F for one component, and is of GL_R32UI for
    /// NICOL_PLANE_INSTANCE. Returns NICOL_ERROR_INVALID_ARGUMENT for NICOL_PLANE_VARIANCE, which is not on the
    /// device, and for NICOL_PLANE_POLARIZER, which nicol_framebuffer_draw_observation draws, and
    /// NICOL_ERROR_UNSUPPORTED for a framebuffer whose context is not a host's.
    pub fn nicol_framebuffer_draw_plane(framebuffer: nicol_framebuffer, plane: nicol_plane, channel: u32, target: *const nicol_texture_target) -> nicol_result;
    /// Draws the plane NICOL_PLANE_STOKES.
    pub fn nicol_framebuffer_draw_stokes(framebuffer: nicol_framebuffer, channel: u32, target: *const nicol_texture_target) -> nicol_result;
    /// Draws the image of nicol_framebuffer_write_png into a texture, as red, green, blue and alpha 1. s1 to s3
    /// need a scale above 0, because nothing is read back. Returns NICOL_ERROR_UNSUPPORTED for a framebuffer whose
    /// context is not a host's.
    pub fn nicol_framebuffer_draw_observation(framebuffer: nicol_framebuffer, observation: *const nicol_observation, target: *const nicol_texture_target) -> nicol_result;
    /// Projects an image to coefficients, one vector per channel, in the world's axes. The image is the bilinear
    /// function between its pixels and, as an environment, must be physically realizable: polarization up to s0.
    /// Returns NICOL_ERROR_INVALID_ARGUMENT unless count is channels * 4 (order+1)^2.
    pub fn nicol_psh_project_image(image: *const nicol_image, order: u32, coefficients: *mut f64, count: u64) -> nicol_result;
    /// Projects an environment to coefficients, one vector per channel, in the world's axes. Returns
    /// NICOL_ERROR_INVALID_ARGUMENT unless count is channels * 4 (order+1)^2.
    pub fn nicol_psh_project_environment(environment: nicol_environment, order: u32, coefficients: *mut f64, count: u64) -> nicol_result;
    /// Projects a file that nicol_environment_load can read to coefficients, one vector per channel, in the
    /// world's axes. channels may be NULL; coefficients NULL with count 0 gets only the number of channels.
    /// Otherwise returns NICOL_ERROR_INVALID_ARGUMENT unless count is channels * 4 (order+1)^2.
    pub fn nicol_psh_project_file(path: *const c_char, order: u32, channels: *mut u32, coefficients: *mut f64, count: u64) -> nicol_result;
    pub fn nicol_psh_sampling_init(descriptor: *mut nicol_psh_sampling, struct_size: u32) -> nicol_result;
    /// Creates a transform. Returns NICOL_ERROR_INVALID_ARGUMENT if the sampling is too coarse for the
    /// order.
    pub fn nicol_psh_transform_create(sampling: *const nicol_psh_sampling, transform: *mut nicol_psh_transform) -> nicol_result;
    pub fn nicol_psh_transform_retain(transform: nicol_psh_transform) -> nicol_result;
    pub fn nicol_psh_transform_release(transform: nicol_psh_transform) -> nicol_result;
    /// Gets the numbers of rows and columns of the transform's grid.
    pub fn nicol_psh_transform_get_size(transform: nicol_psh_transform, rows: *mut u32, columns: *mut u32) -> nicol_result;
    /// Gets theta of each row, and the rows' weights for the integral over cos theta, which sum to 2;
    /// count = rows.
    pub fn nicol_psh_transform_get_rows(transform: nicol_psh_transform, theta: *mut f64, weight: *mut f64, count: u64) -> nicol_result;
    /// Computes coefficients from samples: inner products with the basis (Eq. 32) by the rows' weights.
    pub fn nicol_psh_analyze(transform: nicol_psh_transform, vectors: u64, samples: *const f64, sample_count: u64, coefficients: *mut f64, coefficient_count: u64) -> nicol_result;
    /// Computes samples from coefficients: the field of the coefficients (Eq. 30) at the grid.
    pub fn nicol_psh_synthesize(transform: nicol_psh_transform, vectors: u64, coefficients: *const f64, coefficient_count: u64, samples: *mut f64, sample_count: u64) -> nicol_result;
    /// Computes Stokes vectors [vector][direction][4] at directions [direction][3] of any length but 0.
    pub fn nicol_psh_evaluate(order: u32, vectors: u64, coefficients: *const f64, coefficient_count: u64, directions: *const f64, direction_count: u64, stokes: *mut f64, stokes_count: u64) -> nicol_result;
    /// Rotates fields: (R f)(w) = R f(R^-1 w) (Eqs. 25, 36). The rotation must be orthonormal to 1e-5 and
    /// right-handed. out may be in.
    pub fn nicol_psh_rotate(order: u32, vectors: u64, r#in: *const f64, in_count: u64, rotation: *const [f64; 9], out: *mut f64, out_count: u64) -> nicol_result;
    /// Mirrors fields in the plane z = 0 (Eq. 214, with its conjugation). out may be in.
    pub fn nicol_psh_reflect(order: u32, vectors: u64, r#in: *const f64, in_count: u64, out: *mut f64, out_count: u64) -> nicol_result;
    /// Multiplies each field by a scalar field, (scalar_order+1)^2 coefficients over real harmonics, such as
    /// visibility, and cuts the product above order_out. The product is exact, through a grid, in O(order^3). out
    /// may be in if the orders agree.
    pub fn nicol_psh_multiply(scalar_order: u32, scalar: *const f64, scalar_count: u64, order: u32, vectors: u64, r#in: *const f64, in_count: u64, order_out: u32, out: *mut f64, out_count: u64) -> nicol_result;
    /// Computes the matrix of nicol_psh_multiply for a scalar field (Eq. 54, by the triple products of Eqs. 215
    /// and 216).
    pub fn nicol_psh_shadow_matrix(scalar_order: u32, scalar: *const f64, scalar_count: u64, order_out: u32, order_in: u32, matrix: *mut f64, matrix_count: u64) -> nicol_result;
    pub fn nicol_psh_mueller_field_init(descriptor: *mut nicol_psh_mueller_field, struct_size: u32) -> nicol_result;
    /// Computes the matrix of the operator "integrate the field times the light over the incoming directions"
    /// (Eqs. 39, 40), by quadrature.
    pub fn nicol_psh_project_matrix(field: *const nicol_psh_mueller_field, matrix: *mut f64, matrix_count: u64) -> nicol_result;
    /// Computes out = matrix * in, vector by vector (Eq. 41).
    pub fn nicol_psh_apply_matrix(order_out: u32, order_in: u32, matrix: *const f64, matrix_count: u64, vectors: u64, r#in: *const f64, in_count: u64, out: *mut f64, out_count: u64) -> nicol_result;
    /// Computes the matrix of `second` after `first`.
    pub fn nicol_psh_compose_matrix(order_out: u32, order_between: u32, order_in: u32, second: *const f64, second_count: u64, first: *const f64, first_count: u64, matrix: *mut f64, matrix_count: u64) -> nicol_result;
    /// Computes the bands of a kernel by quadrature (Eq. 68). rows is the number of Gauss-Legendre rows, at most
    /// 16384; 0: 2 order + 2.
    pub fn nicol_psh_project_kernel(callback: nicol_psh_kernel_callback, user: *mut c_void, order: u32, rows: u32, bands: *mut f64, band_count: u64) -> nicol_result;
    /// Computes Mueller matrices [angle][16] of a kernel at angles in 0 to pi, the inverse of
    /// nicol_psh_project_kernel.
    pub fn nicol_psh_kernel_at(order: u32, bands: *const f64, band_count: u64, theta: *const f64, theta_count: u64, mueller: *mut f64, mueller_count: u64) -> nicol_result;
    /// Convolves each field with a kernel (Eq. 69). out may be in.
    pub fn nicol_psh_convolve(order: u32, bands: *const f64, band_count: u64, vectors: u64, r#in: *const f64, in_count: u64, out: *mut f64, out_count: u64) -> nicol_result;
    /// Computes the matrix of a convolution (supplement E.9); both sides of the matrix have this order.
    pub fn nicol_psh_kernel_matrix(order: u32, bands: *const f64, band_count: u64, matrix: *mut f64, matrix_count: u64) -> nicol_result;
    /// Computes the kernel nearest to a matrix in the Frobenius norm (supplement E.9); both sides of the matrix
    /// have this order.
    pub fn nicol_psh_nearest_kernel(order: u32, matrix: *const f64, matrix_count: u64, bands: *mut f64, band_count: u64) -> nicol_result;
    pub fn nicol_file_options_init(descriptor: *mut nicol_file_options, struct_size: u32) -> nicol_result;
    pub fn nicol_light_report_init(descriptor: *mut nicol_light_report, struct_size: u32) -> nicol_result;
    pub fn nicol_material_report_init(descriptor: *mut nicol_material_report, struct_size: u32) -> nicol_result;
    /// Gets the kind of a file from its suffix and headers alone; the file may yet prove damaged. Returns
    /// NICOL_ERROR_UNSUPPORTED for another suffix or an archive of another kind.
    pub fn nicol_file_identify(path: *const c_char, kind: *mut nicol_file_kind) -> nicol_result;
    /// Gets the report of a light, and its energies [channel][l][p], 4 (order + 1) per channel: squares of the
    /// coefficients, summed over m. energy has room for count doubles, and may be NULL with count 0. options may
    /// be NULL. Scale and rotation change the report as they would change an output. Options of images to write
    /// must be 0. The order limits the energies of an image, and everything for coefficients. An image that
    /// violates Eq. 70 is described, although it is refused as a light.
    pub fn nicol_file_describe_light(path: *const c_char, options: *const nicol_file_options, report: *mut nicol_light_report, energy: *mut f64, count: u64) -> nicol_result;
    /// Gets the report of a material, and its energies [channel][l], order + 1 per channel: squares of the matrix'
    /// entries between two orders, the larger of which is l. options are those of nicol_file_describe_light.
    pub fn nicol_file_describe_material(path: *const c_char, options: *const nicol_file_options, report: *mut nicol_material_report, energy: *mut f64, count: u64) -> nicol_result;
    /// Reads the file `in` and writes `out` in the kind that the name of `out` says: .exr, _s0.exr (all four
    /// files), .npz or a cache folder. Light becomes light, and a material becomes a material. options may be
    /// NULL.
    pub fn nicol_file_convert(r#in: *const c_char, options: *const nicol_file_options, out: *const c_char) -> nicol_result;
    /// Writes an environment to a file in the kind that the path says, as nicol_file_convert does. options may be
    /// NULL, and must have no wavelengths.
    pub fn nicol_environment_write(environment: nicol_environment, options: *const nicol_file_options, path: *const c_char) -> nicol_result;
    /// Writes a material to a file in the kind that the path says, as nicol_file_convert does. options may be
    /// NULL, and must have no wavelengths.
    pub fn nicol_material_write(material: nicol_material, options: *const nicol_file_options, path: *const c_char) -> nicol_result;
    /// Reads a mosaic from a grey image of 8 or 16 bits, as of a polarization camera or nicol_sensor_write_png,
    /// and writes the Stokes image of nicol_sensor_demosaic to an OpenEXR file.
    pub fn nicol_file_demosaic(r#in: *const c_char, sensor: *const nicol_sensor, method: nicol_demosaic, out: *const c_char) -> nicol_result;
    /// Reads pictures of one view behind a polarizer at 0, 45, 90 and 135 degrees counter-clockwise from image
    /// right, and writes the Stokes image in front of it to an OpenEXR file, with s3 = 0. EXR files give s0. Other
    /// images give their numbers as linear light in 0 to 1, without a curve.
    pub fn nicol_file_combine_angles(at_0: *const c_char, at_45: *const c_char, at_90: *const c_char, at_135: *const c_char, out: *const c_char) -> nicol_result;
    /// Writes coefficients of 1 to NICOL_MAX_CHANNELS vectors to a file of the kind NICOL_FILE_LIGHT_PSH.
    pub fn nicol_psh_write_file(path: *const c_char, order: u32, vectors: u64, coefficients: *const f64, count: u64) -> nicol_result;
}
