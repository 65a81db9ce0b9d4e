// SPDX-License-Identifier: MIT
//! Errors, lifetimes and pixels through the crate and through `abi`.
use nicol::{abi::*, check, Context, Environment, Framebuffer, Material, Mesh, Scene};
use std::ptr::{null, null_mut};

fn grey(value: f32) -> nicol_spectrum {
    let mut spectrum = nicol_spectrum { count: 1, ..Default::default() };
    spectrum.values[0] = value;
    spectrum
}

/// A grey sphere in even light: every pixel of it has their product.
fn sphere(context: &Context) -> nicol::Result<Scene> {
    let mesh = Mesh::made(|out| unsafe { nicol_mesh_create_sphere(context.raw(), out) })?;
    let material = Material::made(|out| unsafe { nicol_material_create_diffuse(context.raw(), &grey(0.25), out) })?;
    let light = Environment::made(|out| unsafe { nicol_environment_create_constant(context.raw(), &grey(2.0), out) })?;
    let scene = Scene::made(|out| unsafe { nicol_scene_create(context.raw(), out) })?;
    let instance = nicol_instance { mesh: mesh.raw(), material: material.raw(), ..Default::default() };
    check(unsafe { nicol_scene_add_instance(scene.raw(), &instance, null_mut()) })?;
    check(unsafe { nicol_scene_set_environment(scene.raw(), light.raw(), null(), 1.0) })?;
    Ok(scene)
}

#[test]
fn pixels() -> nicol::Result<()> {
    assert_eq!(unsafe { nicol_version() }, NICOL_VERSION);
    let scene;
    let framebuffer;
    {
        let context = Context::new()?.clone();
        scene = sphere(&context)?;
        framebuffer = Framebuffer::new(&context, 32, 24, scene.channels()?)?;
    }
    let mut camera = nicol_camera { fov: 40.0, ..Default::default() };
    check(unsafe { nicol_camera_look_at(&mut camera, &[0.0, 0.0, 4.0], &[0.0; 3], &[0.0, 1.0, 0.0]) })?;
    let options = nicol_render_options { order_low: 4, ..Default::default() };
    scene.render(&camera, &options, &framebuffer)?;
    let stokes = framebuffer.plane(NICOL_PLANE_STOKES, 0)?;
    assert_eq!(stokes.len(), 32 * 24 * 4);
    assert!((stokes[4 * (12 * 32 + 16)] - 0.5).abs() < 1e-4);
    assert_eq!(stokes[0], 2.0);
    assert!(framebuffer.statistics()?.vertices > 0);

    let wrong = nicol_render_options { struct_size: 4000, ..options };
    assert!(scene.render(&camera, &wrong, &framebuffer).is_err());
    let error = framebuffer.plane(NICOL_PLANE_S0, 1).unwrap_err();
    assert_eq!(error.code, NICOL_ERROR_INVALID_ARGUMENT);
    assert!(error.to_string().contains("channel"), "{error}");
    Ok(())
}

#[test]
fn errors() -> nicol::Result<()> {
    let context = Context::new()?;
    let error = Scene::load(&context, "nowhere.xml", &[] as &[&str]).err().expect("a missing file");
    assert_eq!(error.code, NICOL_ERROR_FILE_NOT_FOUND);
    assert!(error.to_string().contains("nowhere.xml"), "{error}");
    assert!(Scene::load(&context, "a\0b", &[] as &[&str]).is_err());
    Ok(())
}
