// SPDX-License-Identifier: MIT
//! Nicol for Rust: handles that release themselves and results as `Result`, for what most programs need. The whole C
//! interface is in [`abi`].
#[rustfmt::skip] // as it was made
pub mod abi;

use abi::*;
use std::ffi::{CStr, CString};
use std::ptr::{null, null_mut};

/// Failure of a call.
#[derive(Debug, Clone)]
pub struct Error {
    /// One of `NICOL_ERROR_...`.
    pub code: nicol_result,
    pub message: String,
}

impl std::fmt::Display for Error {
    fn fmt(&self, out: &mut std::fmt::Formatter) -> std::fmt::Result {
        out.write_str(&self.message)
    }
}

impl std::error::Error for Error {}

pub type Result<T> = std::result::Result<T, Error>;

pub fn check(code: nicol_result) -> Result<()> {
    if code == NICOL_OK {
        return Ok(());
    }
    let message = unsafe { CStr::from_ptr(nicol_last_error()) };
    Err(Error { code, message: message.to_string_lossy().into_owned() })
}

fn refuse<T>(message: &str) -> Result<T> {
    Err(Error { code: NICOL_ERROR_INVALID_ARGUMENT, message: message.to_string() })
}

fn text(value: &str) -> Result<CString> {
    CString::new(value).or_else(|_| refuse("the text has a zero in it"))
}

macro_rules! handle {
    ($(#[$doc:meta])* $name:ident, $raw:ident, $retain:ident, $release:ident) => {
        $(#[$doc])*
        pub struct $name($raw);

        // Any function may be called from any thread.
        unsafe impl Send for $name {}
        unsafe impl Sync for $name {}

        impl $name {
            /// Takes the reference that `create` gives.
            pub fn made(create: impl FnOnce(*mut $raw) -> nicol_result) -> Result<Self> {
                let mut raw = null_mut();
                check(create(&mut raw))?;
                Ok(Self(raw))
            }

            /// For the functions of [`abi`]; valid as long as `self` is.
            pub fn raw(&self) -> $raw {
                self.0
            }
        }

        impl Clone for $name {
            fn clone(&self) -> Self {
                unsafe { $retain(self.0) };
                Self(self.0)
            }
        }

        impl Drop for $name {
            fn drop(&mut self) {
                unsafe { $release(self.0) };
            }
        }
    };
}

handle!(/// An OpenGL context on a thread of its own.
    Context, nicol_context, nicol_context_retain, nicol_context_release);
handle!(/// Light from infinitely far.
    Environment, nicol_environment, nicol_environment_retain, nicol_environment_release);
handle!(/// Values that vary over a surface.
    Texture, nicol_texture, nicol_texture_retain, nicol_texture_release);
handle!(/// A polarimetric BRDF.
    Material, nicol_material, nicol_material_retain, nicol_material_release);
handle!(/// Triangles.
    Mesh, nicol_mesh, nicol_mesh_retain, nicol_mesh_release);
handle!(/// Instances and one environment.
    Scene, nicol_scene, nicol_scene_retain, nicol_scene_release);
handle!(/// The Stokes image of the last render into it.
    Framebuffer, nicol_framebuffer, nicol_framebuffer_retain, nicol_framebuffer_release);

impl Context {
    /// With all defaults.
    pub fn new() -> Result<Self> {
        Self::made(|out| unsafe { nicol_context_create(null(), out) })
    }
}

impl Scene {
    /// A Mitsuba 3 XML file; definitions are `name=value`.
    pub fn load(context: &Context, path: &str, definitions: &[impl AsRef<str>]) -> Result<Self> {
        let path = text(path)?;
        let owned = definitions.iter().map(|d| text(d.as_ref())).collect::<Result<Vec<_>>>()?;
        let pointers: Vec<_> = owned.iter().map(|d| d.as_ptr()).collect();
        Self::made(|out| unsafe {
            nicol_scene_load(context.raw(), path.as_ptr(), pointers.as_ptr(), pointers.len() as u32, out)
        })
    }

    pub fn camera(&self) -> Result<nicol_camera> {
        let mut camera = nicol_camera::default();
        check(unsafe { nicol_scene_get_camera(self.raw(), &mut camera) })?;
        Ok(camera)
    }

    /// (width, height)
    pub fn film_size(&self) -> Result<(u32, u32)> {
        let (mut width, mut height) = (0, 0);
        check(unsafe { nicol_scene_get_film_size(self.raw(), &mut width, &mut height) })?;
        Ok((width, height))
    }

    pub fn channels(&self) -> Result<u32> {
        let mut channels = 0;
        check(unsafe { nicol_scene_get_channels(self.raw(), &mut channels) })?;
        Ok(channels)
    }

    /// Without a progress callback; `abi::nicol_render` takes one.
    pub fn render(&self, camera: &nicol_camera, options: &nicol_render_options, target: &Framebuffer) -> Result<()> {
        if options.progress.is_some() || options.struct_size as usize != std::mem::size_of_val(options) {
            return refuse("options must have their own struct_size and no progress callback");
        }
        if camera.struct_size as usize != std::mem::size_of_val(camera) {
            return refuse("camera.struct_size is not that of the struct");
        }
        check(unsafe { nicol_render(self.raw(), camera, options, target.raw()) })
    }
}

impl Framebuffer {
    pub fn new(context: &Context, width: u32, height: u32, channels: u32) -> Result<Self> {
        Self::made(|out| unsafe { nicol_framebuffer_create(context.raw(), width, height, channels, out) })
    }

    /// (width, height, channels)
    pub fn size(&self) -> Result<(u32, u32, u32)> {
        let (mut width, mut height, mut channels) = (0, 0, 0);
        check(unsafe { nicol_framebuffer_get_size(self.raw(), &mut width, &mut height, &mut channels) })?;
        Ok((width, height, channels))
    }

    /// One plane of one channel, row by row from the top; `NICOL_PLANE_STOKES` has four floats a pixel.
    pub fn plane(&self, plane: nicol_plane, channel: u32) -> Result<Vec<f32>> {
        let (width, height, _) = self.size()?;
        let floats = if plane == NICOL_PLANE_STOKES { 4 } else { 1 };
        let mut pixels = vec![0.0_f32; width as usize * height as usize * floats];
        let bytes = std::mem::size_of_val(pixels.as_slice()) as u64;
        check(unsafe { nicol_framebuffer_read(self.raw(), plane, channel, pixels.as_mut_ptr(), 0, bytes) })?;
        Ok(pixels)
    }

    pub fn statistics(&self) -> Result<nicol_statistics> {
        let mut statistics = nicol_statistics::default();
        check(unsafe { nicol_framebuffer_get_statistics(self.raw(), &mut statistics) })?;
        Ok(statistics)
    }
}
