# SPDX-License-Identifier: MIT
"""Time at equal error: how long Mitsuba 3 takes for an image as close to the truth as Nicol's.

usage: mitsuba_contest.py [SCENE...] [--size N] [--samples N] [--truth N] [--max-depth N] [--verify SECONDS], each scene the first word of one's name below.
NICOL_TEST_DATA, with the folders polarsh and mitsuba, adds the statue."""

import argparse
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time

import nicol
import numpy
import peer_mitsuba as peer
import stokes_images

os.environ["NICOL_CACHE"] = ""  # times are without what earlier runs kept

ASSETS = pathlib.Path(__file__).resolve().parent.parent / "assets"
DATA = pathlib.Path(os.environ.get("NICOL_TEST_DATA", "nowhere"))

# The last folder is the first to be searched: its images of luminance go before those of the assets.
SCENE = """<scene version="3.0.0">
  <path value="{assets}"/><path value="{data}/polarsh"/><path value="{folder}"/>
  <integrator type="stokes"><integrator type="path"><integer name="max_depth" value="{max_depth}"/></integrator></integrator>
  <sensor type="perspective"><float name="fov" value="42"/>
    <transform name="to_world"><lookat {camera} up="0,1,0"/></transform>
    <film type="hdrfilm"><integer name="width" value="{size}"/><integer name="height" value="{size}"/><string name="pixel_format" value="luminance"/><rfilter type="box"/></film>
  </sensor>
  {contents}
</scene>
"""


def plastic(alpha, diffuse):
    return f"""<bsdf type="pplastic"><string name="distribution" value="ggx"/><float name="alpha" value="{alpha}"/>{diffuse}</bsdf>"""


def grey(value):
    return f'<float name="diffuse_reflectance" value="{value}"/>'


def tiles(scale):
    return f"""<texture name="diffuse_reflectance" type="bitmap"><string name="filename" value="tiles_roughness.png"/>
        <boolean name="raw" value="true"/><transform name="to_uv"><scale x="{scale}" y="{scale}"/></transform></texture>"""


def envmap(file):
    return f'<emitter type="envmap"><string name="filename" value="{file}"/></emitter>'


def mesh(kind, file, bsdf):
    return f'<shape type="{kind}"><string name="filename" value="{file}"/>{bsdf}</shape>'


def shape(kind, to_world, inside):
    return f'<shape type="{kind}"><transform name="to_world">{to_world}</transform>{inside}</shape>'


def lamp(origin):
    return shape("rectangle", f'<scale value="0.6"/><lookat origin="{origin}" target="0,0,0" up="0,1,0.1"/>',
                 '<emitter type="area"><float name="radiance" value="12"/></emitter>')  # fmt: skip


METAL = """<bsdf type="roughconductor"><string name="distribution" value="ggx"/><float name="alpha" value="0.25"/>
    <float name="eta" value="1.3"/><float name="k" value="3.2"/></bsdf>"""
# Environment images. Mitsuba and Nicol render their luminance, because Mitsuba's mode has one channel.
ENVIRONMENTS = (ASSETS / "forest.exr", DATA / "mitsuba" / "venice.exr")
# Scenes by name: (camera, contents, RenderOptions that suit the scene better than the defaults).
SCENES = {
    "snail in a forest": (
        'origin="-1.9,1.9,4.7" target="-0.05,0.95,0"',
        envmap("forest.exr") + mesh("ply", "snail.ply", plastic(0.2, grey(0.1))) + mesh("ply", "plinth.ply", plastic(0.3, grey(0.05))),
        {},
    ),
    "textured box with lamps": (
        'origin="1.2,1.2,5.5" target="-0.3,-0.1,0"',
        lamp("2.5,3.5,2.5")
        + lamp("-1.5,3,3.5")
        + '<emitter type="point"><point name="position" x="1" y="2.5" z="2"/><float name="intensity" value="8"/></emitter>'
        + shape("rectangle", '<scale value="3"/><rotate x="1" angle="-90"/><translate y="-1"/>', plastic(0.3, tiles(3)))
        + shape("rectangle", '<scale value="3"/><translate z="-2.5"/>', plastic(0.4, tiles(2)))
        + shape("cube", '<scale value="0.7"/><rotate y="1" angle="30"/><translate x="-1.3" y="-0.3"/>', plastic(0.2, tiles(1)))
        + shape("sphere", '<scale value="0.7"/><translate x="0.9" y="-0.3" z="0.6"/>', METAL),
        {"pixel_samples": 8},
    ),
    "statue of 19,944 vertices": (
        'origin="2.8,1.6,6.6" target="0,0.1,0"',
        envmap("venice.exr") + mesh("obj", "buddha.obj", plastic(0.3, grey(0.4))) + mesh("obj", "plane.obj", plastic(0.5, grey(0.4))),
        {"order_low": 4, "bake_directions": 512, "shade_at": nicol.SHADE_AT_VERTICES},
    ),
}


def timed(work, repetitions=1):
    """Returns (result, array of seconds and CPU seconds), the minimum of `repetitions` runs."""
    times = []
    for _ in range(repetitions):
        begin, cpu = time.perf_counter(), time.process_time()
        result = work()
        times.append((time.perf_counter() - begin, time.process_time() - cpu))
    return result, numpy.min(times, axis=0)


def rotation(degrees):
    """Returns a rotation about the vertical."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return numpy.array([[c, 0, s, 0], [0, 1, 0, 0], [-s, 0, c, 0], [0, 0, 0, 1]])


class Show:
    """A scene in Nicol whose camera and light rotate, each frame by other angles."""

    FRAMES = 8

    def __init__(self, context, scene_file, options):
        self.scene = nicol.Scene.load(context, str(scene_file))
        self.options = {"max_depth": self.scene.get_max_depth(), **options}
        self.camera = self.scene.get_camera()
        self.framebuffer = nicol.Framebuffer.create(context, *self.scene.get_film_size(), self.scene.get_channels())
        self.has_point = self.scene.get_light_count() > 0
        if self.has_point:
            ids = numpy.zeros(1, "u4")
            self.scene.get_light_ids(ids)
            self.point = int(ids[0])

    def render(self, aovs=0):
        nicol.render(self.scene, self.camera, nicol.RenderOptions(aovs=aovs, **self.options), self.framebuffer)

    def rotate(self):
        turn = lambda degrees, matrix: (rotation(degrees) @ numpy.array(matrix).reshape(4, 4)).ravel()  # noqa: E731
        self.camera.to_world = list(turn(0.37, self.camera.to_world))
        if self.has_point:
            light, _ = self.scene.get_light(self.point)
            light.to_world = list(turn(1.3, light.to_world))
            self.scene.set_light(self.point, light)
        else:
            environment, to_world, scale = self.scene.get_environment()
            self.scene.set_environment(environment, turn(1.3, to_world), scale)

    def frames(self):
        for _ in range(self.FRAMES):
            self.rotate()
            self.render()

    def inner(self):
        """Returns the pixels that show the same object as their eight neighbours."""
        self.render(nicol.AOV_INSTANCE)
        ids = self.framebuffer.plane(nicol.PLANE_INSTANCE)
        inner = ids != nicol.NO_INSTANCE
        for dy in (-1, 0, 1):
            for dx in (-1, 0, 1):
                inner &= numpy.roll(ids, (dy, dx), (0, 1)) == ids
        inner[[0, -1]] = inner[:, [0, -1]] = False
        return inner


def first_image(scene_file, options):
    """Makes the first image in memory from nothing, without a cache folder."""
    with nicol.Context.create() as context:
        show = Show(context, scene_file, options)
        show.render()
        show.framebuffer.plane()


def cold_times(scene_file, options):
    """Returns timed() of first_image() in a separate process."""
    command = [sys.executable, __file__, "--cold", str(scene_file), json.dumps(options)]
    runs = [subprocess.check_output(command) for _ in range(3)]
    return numpy.min([[float(word) for word in run.split()] for run in runs], axis=0)


def write_scene(folder, name, size, max_depth):
    """Writes one of SCENES, lit by luminance, into the folder and returns its path."""
    camera, contents, _ = SCENES[name]
    for environment in filter(pathlib.Path.exists, ENVIRONMENTS):
        peer.write_luminance(environment, pathlib.Path(folder, environment.name))
    scene_file = pathlib.Path(folder, "scene.xml")
    scene_file.write_text(SCENE.format(folder=folder, assets=ASSETS, data=DATA, camera=camera, size=size, max_depth=max_depth, contents=contents))
    return scene_file


def words(errors):
    return " ".join(f"{max(e, 0) ** 0.5:.5f}" for e in errors)


def contest(name, scene_file, options, arguments):
    with nicol.Context.create() as context:
        show = Show(context, scene_file, options)
        inner = show.inner()
        show.render()
        ours = stokes_images.nicol_stokes(show.framebuffer)[inner]
        warm = timed(show.frames, 5)[1] / show.FRAMES
    cold = cold_times(scene_file, options)

    scene, n = peer.mitsuba_scene(scene_file), arguments.samples
    image = lambda seed, samples=n: peer.mitsuba_image(scene, samples, seed)[inner]  # noqa: E731
    passes = arguments.truth
    truth = [sum(image(seed) for seed in range(first, first + passes)) / passes for first in (1, 1 + passes)]
    _, times = timed(lambda: image(0), 3)
    error = stokes_images.squared_error((ours, ours), truth)[0][:3]
    noise = passes * ((truth[0] - truth[1]) ** 2 / 2).mean(0)[:3] / (truth[0][:, 0] * truth[1][:, 0]).mean()
    print(f"\n{name}: {inner.mean():.0%} of {arguments.size} x {arguments.size} pixels lie inside surfaces")
    said = ", ".join(f"{name} {value}" for name, value in options.items()) or "default options"
    print(f"  Nicol, {said}: errors {words(error)}; a frame {1e3 * warm[0]:.1f} ms (CPU {1e3 * warm[1]:.1f} ms), the first image {cold[0]:.2f} s (CPU {cold[1]:.2f} s)")
    print(f"  Mitsuba, {n} samples a pixel: errors {words(noise)}; {times[0]:.2f} s (CPU {times[1]:.2f} s)")
    # The variance of independent samples is inversely proportional to their number.
    needed = {"s0, s1, s2 together": n * noise.sum() / error.sum(), **{f"s{i} alone": n * noise[i] / error[i] for i in range(3)}}
    for components, samples in needed.items():
        equal = samples / n * times
        print(f"  equal error of {components}: {samples:.0f} samples, {equal[0]:.1f} s; as long as {equal[0] / warm[0]:.0f} frames (by CPU time "
              f"{equal[1] / warm[1]:.0f}) or {equal[0] / cold[0]:.0f} first images ({equal[1] / cold[1]:.0f})", flush=True)  # fmt: skip
    samples = round(needed["s0, s1, s2 together"])
    if samples / n * times[0] < arguments.verify:
        passes = math.ceil(samples / n)
        seeds = range(1000, 1000 + passes)
        mean, taken = timed(lambda: sum(image(seed, samples // passes) for seed in seeds) / passes)
        print(f"  rendered: {samples // passes * passes} samples take {taken[0]:.1f} s; errors {words(stokes_images.squared_error((mean, mean), truth)[0][:3])}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", default=[name.split()[0] for name in SCENES], metavar="SCENE")
    parser.add_argument("--size", type=int, default=512, help="images of N x N")
    parser.add_argument("--samples", type=int, default=64, help="a pixel, of each of Mitsuba's images")
    parser.add_argument("--truth", type=int, default=16, help="images that make up each of the two that errors are taken against")
    parser.add_argument("--max-depth", type=int, default=2, help="2 is direct light alone")
    parser.add_argument("--verify", type=float, default=120, help="renders the image of equal error where Mitsuba needs less than these seconds")
    parser.add_argument("--cold", nargs=2, help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.cold:
        scene_file, options = arguments.cold
        print(*timed(lambda: first_image(scene_file, json.loads(options)))[1])
        return
    print(f"Mitsuba {peer.mitsuba.__version__}, {peer.choose_variant()}; Nicol {nicol.version_string()}; {len(os.sched_getaffinity(0))} cores. "
          f"Light of one channel to depth {arguments.max_depth}; errors are RMSE of s0, s1, s2 inside surfaces over the RMS of s0.")  # fmt: skip
    with tempfile.TemporaryDirectory() as folder:
        for name, (_, _, options) in SCENES.items():
            if name.split()[0] not in arguments.scenes:
                continue
            if "statue" in name and not (DATA / "polarsh").is_dir():
                print(f"\n{name}: left out, NICOL_TEST_DATA has no folder polarsh")
                continue
            contest(name, write_scene(folder, name, arguments.size, arguments.max_depth), options, arguments)


if __name__ == "__main__":
    main()
