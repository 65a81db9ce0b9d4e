// SPDX-License-Identifier: MIT
//! Finds libnicol: in the folder that NICOL_LIB_DIR names, by pkg-config, or in the linker's search path.
use std::process::Command;

fn main() {
    println!("cargo:rerun-if-env-changed=NICOL_LIB_DIR");
    let by_pkg_config = || {
        let output = Command::new("pkg-config").args(["--variable=libdir", "nicol"]).output().ok()?;
        output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_string())
    };
    if let Some(folder) = std::env::var("NICOL_LIB_DIR").ok().or_else(by_pkg_config) {
        println!("cargo:rustc-link-search=native={folder}");
        println!("cargo:rustc-link-arg=-Wl,-rpath,{folder}");
    }
    println!("cargo:rustc-link-lib=dylib=nicol");
}
