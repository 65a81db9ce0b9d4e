# SPDX-License-Identifier: MIT
"""Random scenes by default against rays, and rays against Mitsuba 3: errors of s0 and of s1, s2 relative to the root mean square
of s0, without noise, and beyond two standard errors of the noise that is left. Errors are those of means over blocks of pixels;
"pixels" are those of each pixel, where the few samples of an outline or a small highlight count most. "Inside" is what the predicted
error promises: the error of one image with the noise of its own samples, over pixels that show one surface evenly, relative to all
surfaces. It leaves out the background and lamps, which are exact, and pixels with an edge of an object, a shadow or a texture, which
few samples show jagged.
Predictions are held against it only in scenes where the noise of the rays leaves it known.

usage: random_scenes.py ASSETS [--count N] [--first SEED] [--without KIND ...] [--mitsuba] [--keep FOLDER]
ASSETS: the folder samples/assets. --mitsuba compares rays with Mitsuba instead. --keep writes the ten worst scenes."""

import argparse
import pathlib
import sys
import tempfile
import typing

try:
    import numpy
    import stokes_images
except ModuleNotFoundError as absent:
    print(f"skipped: {sys.executable} has no module {absent.name}")
    sys.exit(77)

import nicol
import random_scene

RAYS = {"method": nicol.METHOD_REFERENCE, "samples": 64}
DEFAULT = {"pixel_samples": 8}
# Largest errors of s0, the 90th percentile and the worst scene: of scenes of direct light, and of those where light bounces.
BY_DEFAULT = ((0.016, 0.038), (0.017, 0.036))
# Width and height of a block, in pixels.
BLOCK = 4
# Number of places along each side of a pixel where its objects and their s0 are asked for.
PLACES = 4
# Largest standard deviation of s0 between the places of a pixel without edges, over the mean.
LARGEST_VARIATION = 0.1
# Smallest number of pixels, and smallest error, that a prediction is held against. The noise of rays hides smaller errors.
LEAST_PIXELS = 100
LEAST_RATED = 0.003
MITSUBA = ((0.01, 0.03), (0.01, 0.03))


class Errors(typing.NamedTuple):
    """Errors of one scene: s0 and the larger of s1 and s2 over blocks, s0 over pixels, s0 of one image inside surfaces, the predicted
    one, and whether `inside` is known. A number that was not measured is not a number."""

    s0: float
    polarized: float
    pixels: float = numpy.nan
    inside: float = numpy.nan
    predicted: float = numpy.nan
    known: bool = False


def nicol_images(context, scene_file, seeds, options, definitions=()):
    """Renders with each seed, to the depth of the scene's integrator. definitions: "name=value" for the scene's parameters. The context keeps the tables of materials. Returns the images
    and the predicted error of the last one."""
    with nicol.Scene.load(context, str(scene_file), definitions) as scene:
        with nicol.Framebuffer.create(context, *scene.get_film_size(), scene.get_channels()) as framebuffer:
            images = []
            for seed in seeds:
                chosen = nicol.RenderOptions(seed=seed, max_depth=scene.get_max_depth(), **options)
                nicol.render(scene, scene.get_camera(), chosen, framebuffer)
                images.append(stokes_images.nicol_stokes(framebuffer))
            return images, framebuffer.get_statistics().predicted_error


def inside(context, scene_file):
    """Returns the pixels that show surfaces without own light, and those in which all places show the same one without an edge."""
    text = scene_file.read_text()
    surfaces = text.count("<shape") - text.count('type="area"')  # lamps come last
    with nicol.Scene.load(context, str(scene_file)) as scene:
        width, height = scene.get_film_size()
        with nicol.Framebuffer.create(context, PLACES * width, PLACES * height, scene.get_channels()) as framebuffer:
            halves = []
            for seed in (5, 6):
                fast = nicol.RenderOptions(order_low=3, order_high=3, bsdf_samples=0, seed=seed, aovs=nicol.AOV_INSTANCE)
                nicol.render(scene, scene.get_camera(), fast, framebuffer)
                halves.append(stokes_images.nicol_stokes(framebuffer)[..., 0])
            one, varies = even_pixels(framebuffer.plane(nicol.PLANE_INSTANCE), *halves)
            shown = (framebuffer.plane(nicol.PLANE_INSTANCE) < surfaces).reshape(height, PLACES, width, PLACES).all((1, 3))
            return shown, (one < surfaces) & (varies <= LARGEST_VARIATION)


def even_pixels(shown, *halves):
    """Returns the object of each pixel that shows one alone, otherwise the largest number, and the standard deviation of s0 there over
    its mean. A pixel's places are its own and those next to it, because an edge may pass between them. halves: two images of other
    seeds, whose noise is not that of the light."""
    window = (PLACES + 2, PLACES + 2)
    around = [
        numpy.lib.stride_tricks.sliding_window_view(numpy.pad(image, 1, mode="edge"), window)[::PLACES, ::PLACES]
        for image in (shown, *halves)
    ]
    objects, x, y = (image.reshape(*image.shape[:2], -1) for image in around)
    one = (objects == objects[..., :1]).all(-1)
    mean = (x.mean(-1) + y.mean(-1)) / 2
    squares = (x * y).mean(-1) - x.mean(-1) * y.mean(-1)
    varies = numpy.divide(numpy.sqrt(numpy.maximum(squares, 0)), mean, out=numpy.zeros(mean.shape), where=mean > 0)
    return numpy.where(one, objects[..., 0], nicol.NO_INSTANCE), varies


def error_of_one(ours, truth, shown, within):
    """Returns the root mean squared error of s0 of one image, of which there are several, with the image's noise, in the pixels `within`
    over those `shown`, and whether it is known: whether two standard errors of its square, from the noise of the rays, are less than
    half of the square."""
    a, b = (image[within][:, 0] for image in truth)
    squares = numpy.mean([(image[within][:, 0] - a) * (image[within][:, 0] - b) for image in ours], axis=0)
    square, deviation = squares.mean(), squares.std() / numpy.sqrt(squares.size)
    return numpy.sqrt(max(square, 0) / (truth[0] * truth[1])[shown][:, 0].mean()), 4 * deviation < square


def blocks(images):
    """Returns the means of images over blocks."""
    height, width = images[0].shape[:2]
    return [image.reshape(height // BLOCK, BLOCK, width // BLOCK, BLOCK, 4).mean((1, 3)) for image in images]


def errors(ours, truth):
    """Returns the root mean squared errors of s0, and of s1 and s2."""
    with numpy.errstate(invalid="ignore", divide="ignore"):
        squares, deviations = stokes_images.squared_error(ours, truth)
    # The quotient is undefined for pictures without light.
    roots = numpy.sqrt(numpy.maximum(numpy.nan_to_num(squares - 2 * deviations), 0))
    return roots[0], max(roots[1], roots[2])


class Nicol:
    """Default options against rays."""

    limits = BY_DEFAULT

    def compare(self, context, file, _):
        truth, _ = nicol_images(context, file, (1, 2), RAYS)
        ours, predicted = nicol_images(context, file, (3, 4), DEFAULT)
        shown, within = inside(context, file)
        of_inside, known = 0.0, False
        if within.sum() >= LEAST_PIXELS:
            of_inside, known = error_of_one(ours, truth, shown, within)
        return Errors(*errors(blocks(ours), blocks(truth)), errors(ours, truth)[0], of_inside, predicted, known)


class Mitsuba:
    """Rays against Mitsuba, whose scene has the size 1: its rays begin at least 9e-5 away from surfaces, and so within or behind what
    is small."""

    limits = MITSUBA

    def __init__(self):
        import peer_mitsuba

        self.peer = peer_mitsuba
        print(f"Mitsuba {self.peer.mitsuba.__version__}, {self.peer.choose_variant()}")

    def compare(self, context, file, of_unit_size):
        loaded = self.peer.mitsuba_scene(of_unit_size)
        truth = [self.peer.mitsuba_image(loaded, RAYS["samples"], seed) for seed in (1, 2)]
        return Errors(*errors(blocks(nicol_images(context, file, (1, 2), RAYS)[0]), blocks(truth)))


def print_percentiles(of_what, values):
    p90 = numpy.quantile(values, 0.9, method="lower")
    print(f"{of_what}: median {numpy.median(values):.4f}, 90th percentile {p90:.4f}, worst {numpy.max(values):.4f}")
    return p90, numpy.max(values)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("assets", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--without", nargs="*", default=(), choices=("brushed", "narrow", "bounces", "far"))
    parser.add_argument("--mitsuba", action="store_true")
    parser.add_argument("--keep", type=pathlib.Path)
    asked = parser.parse_args()
    peers = Mitsuba() if asked.mitsuba else Nicol()
    found = []
    with tempfile.TemporaryDirectory() as folder, nicol.Context.create() as context:
        file, of_unit_size = (pathlib.Path(folder) / name for name in ("scene.xml", "of_unit_size.xml"))
        for seed in range(asked.first, asked.first + asked.count):
            scene = random_scene.RandomScene(seed, asked.assets.resolve(), asked.without)
            file.write_text(scene.text)
            if asked.mitsuba:
                of_unit_size.write_text(random_scene.RandomScene(seed, asked.assets.resolve(), asked.without, 1.0).text)
            try:
                error = peers.compare(context, file, of_unit_size)
            except nicol.Error as refused:
                print(f"{seed}: refused: {refused}", flush=True)
                error = Errors(numpy.inf, numpy.inf)
            found.append((error, seed, scene))
            more = f", pixels {error.pixels:.4f}, inside {error.inside:.4f}, predicted {error.predicted:.4f}"
            more += "" if error.known else " (the noise of the rays hides the error)"
            print(f"{seed}: {error.s0:.4f} {error.polarized:.4f}{'' if numpy.isnan(error.pixels) else more}", flush=True)
    found.sort(key=lambda row: -row[0].s0)
    print("the worst:")
    for error, seed, scene in found[:10]:
        print(f"  {error.s0:.4f} {error.polarized:.4f} seed {seed}, {scene.words}")
        if asked.keep:
            asked.keep.mkdir(parents=True, exist_ok=True)
            (asked.keep / f"{seed}.xml").write_text(scene.text)
    kept = True
    for light, bounces, limits in (("direct", False, peers.limits[0]), ("bounced", True, peers.limits[1])):
        some = [error for error, _, scene in found if (scene.depth > 2) == bounces]
        if not some:
            continue
        p90, worst = print_percentiles(f"{len(some)} scenes of {light} light", [error.s0 for error in some])
        print_percentiles("  s1, s2", [error.polarized for error in some])
        if not numpy.isnan(some[0].pixels):
            print_percentiles("  pixels", [error.pixels for error in some])
            print_percentiles("  inside", [error.inside for error in some])
        rated = [error.predicted / error.inside for error in some if error.known and error.inside > LEAST_RATED]
        if rated:
            low, middle, high = numpy.quantile(rated, (0.1, 0.5, 0.9))
            print(f"  predicted over measured inside, {len(rated)} scenes, 10th, 50th and 90th percentile: {low:.2f}, {middle:.2f}, {high:.2f}")
        kept = kept and p90 <= limits[0] and worst <= limits[1]
    sys.exit(0 if kept else 1)


if __name__ == "__main__":
    main()
