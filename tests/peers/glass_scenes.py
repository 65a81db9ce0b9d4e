# SPDX-License-Identifier: MIT
"""Scenes of glass by default against Mitsuba 3: errors of s0, s1 and s2 over blocks of 4 x 4 pixels, relative to the root mean square
of s0, without noise. The exit status is 0 if all limits are kept.

usage: glass_scenes.py ASSETS MITSUBA_SCENES [--samples N]
ASSETS: the folder samples/assets. MITSUBA_SCENES: a folder with Mitsuba's own scenes, docs/scenes and common."""

import argparse
import pathlib
import sys
import tempfile

try:
    import numpy
    import peer_mitsuba as peer
    import stokes_images
except ModuleNotFoundError as absent:
    print(f"skipped: {sys.executable} has no module {absent.name}")
    sys.exit(77)

import nicol
import random_scenes

# Largest errors of s0, and of s1 and s2.
LIMITS = {"integrator_stokes_cbox": (0.05, 0.02), "glass ball and bunny on a floor": (0.04, 0.02)}

BUNNY = """<scene version="3.0.0"><path value="{assets}"/><path value="{common}"/>
<integrator type="stokes"><integrator type="path"><integer name="max_depth" value="12"/></integrator></integrator>
<sensor type="perspective"><float name="fov" value="36"/>
  <transform name="to_world"><lookat origin="1.2,1.6,5.5" target="0,0,0" up="0,1,0"/></transform>
  <film type="hdrfilm"><integer name="width" value="128"/><integer name="height" value="96"/><rfilter type="box"/></film></sensor>
<emitter type="envmap"><string name="filename" value="forest_blurred.exr"/></emitter>
<shape type="rectangle">
  <transform name="to_world"><rotate x="1" angle="-90"/><scale value="4"/><translate y="-1"/></transform>
  <bsdf type="pplastic"><float name="diffuse_reflectance" value="0.4"/><float name="alpha" value="0.2"/></bsdf></shape>
<shape type="sphere"><point name="center" x="0.9" y="-0.2" z="0.9"/><float name="radius" value="0.8"/>
  <bsdf type="dielectric"><float name="int_ior" value="1.5"/></bsdf></shape>
<shape type="ply"><string name="filename" value="meshes/bunny.ply"/>
  <transform name="to_world"><scale value="14"/><translate x="-0.2" y="-1.45" z="-0.3"/></transform>
  <bsdf type="pplastic"><float name="diffuse_reflectance" value="0.5"/><float name="alpha" value="0.15"/></bsdf></shape>
</scene>
"""


def errors(context, file, samples, **definitions):
    """Returns the errors of s0, and of s1 and s2, and their standard errors."""
    loaded = peer.mitsuba_scene(file, **definitions)
    truth = [peer.mitsuba_image(loaded, samples, seed) for seed in (1, 2)]
    given = [f"{name}={value}" for name, value in definitions.items()]
    ours, _ = random_scenes.nicol_images(context, file, (3, 4), random_scenes.DEFAULT, given)
    squares, deviations = stokes_images.squared_error(random_scenes.blocks(ours), random_scenes.blocks(truth))
    roots = numpy.sqrt(numpy.maximum(squares, 0))
    # The deviation of a root is that of its square over twice the root.
    return roots[0], roots[1:3].max(), deviations[0] / (2 * max(roots[0], 1e-9))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("assets", type=pathlib.Path)
    parser.add_argument("mitsuba_scenes", type=pathlib.Path)
    parser.add_argument("--samples", type=int, default=512, help="of Mitsuba, a pixel")
    asked = parser.parse_args()
    print(f"Mitsuba {peer.mitsuba.__version__}, {peer.choose_variant()}")
    kept = True
    with tempfile.TemporaryDirectory() as folder, nicol.Context.create() as context:
        bunny = pathlib.Path(folder) / "bunny.xml"
        common = (asked.mitsuba_scenes / "common").resolve()
        bunny.write_text(BUNNY.format(assets=asked.assets.resolve(), common=common))
        cbox = asked.mitsuba_scenes / "docs" / "scenes" / "integrator_stokes_cbox.xml"
        for (name, limits), (file, definitions) in zip(LIMITS.items(), ((cbox, {"res": 256}), (bunny, {})), strict=True):
            s0, polarized, deviation = errors(context, file, asked.samples, **definitions)
            print(f"{name}: s0 {s0:.4f} +- {deviation:.4f} (limit {limits[0]}), s1 and s2 {polarized:.4f} (limit {limits[1]})", flush=True)
            kept = kept and s0 - 2 * deviation <= limits[0] and polarized <= limits[1]
    sys.exit(0 if kept else 1)


if __name__ == "__main__":
    main()
