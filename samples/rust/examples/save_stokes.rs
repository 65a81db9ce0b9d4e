// SPDX-License-Identifier: MIT
//! Renders a scene and saves the Stokes vectors of its green channel for numpy.
//! usage: save_stokes SCENE.xml OUT.npy [name=value...]
use nicol::{abi, Context, Framebuffer, Scene};
use std::{env, error::Error, fs::File, io::Write};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [scene_file, output, definitions @ ..] = arguments.as_slice() else {
        return Err("usage: save_stokes SCENE.xml OUT.npy [name=value...]".into());
    };

    let context = Context::new()?;
    let scene = Scene::load(&context, scene_file, definitions)?;
    let ((width, height), channels) = (scene.film_size()?, scene.channels()?);
    let framebuffer = Framebuffer::new(&context, width, height, channels)?;
    let options = abi::nicol_render_options { order_low: 4, ..Default::default() };
    scene.render(&scene.camera()?, &options, &framebuffer)?;
    let stokes = framebuffer.plane(abi::NICOL_PLANE_STOKES, 1.min(channels - 1))?;

    let head = format!("{{'descr': '<f4', 'fortran_order': False, 'shape': ({height}, {width}, 4), }}");
    let mut file = File::create(output)?;
    file.write_all(b"\x93NUMPY\x01\x00\x76\x00")?;
    writeln!(file, "{head:117}")?;
    file.write_all(&stokes.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>())?;

    let mean =
        |p: usize| stokes.iter().skip(p).step_by(4).map(|x| f64::from(*x)).sum::<f64>() * 4.0 / stokes.len() as f64;
    let vertices = framebuffer.statistics()?.vertices;
    let (s0, s1, s2) = (mean(0), mean(1), mean(2));
    println!("{width} x {height}, {vertices} vertices, mean s0 {s0:.4}, s1 {s1:+.4}, s2 {s2:+.4}");
    Ok(())
}
