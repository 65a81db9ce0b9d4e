# SPDX-License-Identifier: MIT
"""Scenes that Mitsuba 3 renders in the same run: every Stokes component, but for the noise of both programs.

usage: mitsuba_test.py ASSETS, the folder samples/assets"""

import pathlib
import struct
import sys
import tempfile
import unittest

try:
    import numpy
    import peer_mitsuba as peer
    import stokes_images
except ModuleNotFoundError as absent:
    print(f"skipped: {sys.executable} has no module {absent.name}; NICOL_PEER_PYTHON names an interpreter that has mitsuba and numpy")
    sys.exit(77)

import nicol

ASSETS = pathlib.Path(sys.argv.pop(1)).resolve()
SAMPLES = 1024

SCENE = """<scene version="3.0.0">
  <path value="{assets}"/>
  <integrator type="stokes"><integrator type="{integrator}"><integer name="max_depth" value="{depth}"/></integrator></integrator>
  <sensor type="perspective">
    <float name="fov" value="32"/>
    <transform name="to_world"><lookat origin="1,2,5" target="0,-0.2,0" up="0.2,1,0"/></transform>
    <film type="hdrfilm">
      <integer name="width" value="48"/><integer name="height" value="40"/><rfilter type="box"/>
    </film>
  </sensor>
  {lights}
  <shape type="sphere"><transform name="to_world"><rotate x="1" angle="-70"/><rotate y="1" angle="30"/></transform>{sphere}</shape>
  {floor}
</scene>
"""
FLOOR = """<shape type="rectangle">
    <transform name="to_world"><scale value="3"/><rotate x="1" angle="-90"/><translate y="-1"/></transform>{}</shape>"""


def plastic(inside=""):
    return f'<bsdf type="pplastic"><string name="distribution" value="ggx"/><float name="alpha" value="0.2"/>{inside}</bsdf>'


def metal(alpha):
    return f"""<bsdf type="roughconductor"><string name="distribution" value="ggx"/>
        <float name="alpha" value="{alpha}"/><float name="eta" value="1.3"/><float name="k" value="3.2"/></bsdf>"""


def brushed(bsdf, u, v):
    return bsdf.replace('<float name="alpha" value="0.2"/>', f'<float name="alpha_u" value="{u}"/><float name="alpha_v" value="{v}"/>')


def image(name, file, raw, scale):
    return f"""<texture name="{name}" type="bitmap"><string name="filename" value="{file}"/>
        <boolean name="raw" value="{raw}"/><transform name="to_uv"><scale x="{scale}" y="{scale}"/></transform></texture>"""


def checkerboard(name, color0, color1):
    return f"""<texture name="{name}" type="checkerboard"><float name="color0" value="{color0}"/>
        <float name="color1" value="{color1}"/><transform name="to_uv"><scale x="4" y="3"/></transform></texture>"""


def aimed(first=""):
    return f'<transform name="to_world">{first}<lookat origin="2.5,4,2" target="0,0,0" up="0,1,0.1"/></transform>'


def plate(bsdf, size, z, first=""):
    return f"""<shape type="rectangle">{aimed(f'<scale x="{size}" y="{size}"/>{first}<translate z="{z}"/>')}{bsdf}</shape>"""


AIMED = aimed()
POLARIZER = '<bsdf type="polarizer"><float name="theta" value="30"/></bsdf>'
RETARDER = '<bsdf type="retarder"><float name="theta" value="20"/><float name="delta" value="70"/></bsdf>'
CONSTANT = '<emitter type="constant"/>'
FOREST = """<emitter type="envmap"><string name="filename" value="forest_blurred.exr"/>
    <transform name="to_world"><rotate y="1" angle="70"/></transform></emitter>"""
DIRECTIONAL = f'<emitter type="directional"><float name="irradiance" value="3"/>{AIMED}</emitter>'
POINT = '<emitter type="point"><point name="position" value="2.5,4,2"/><float name="intensity" value="60"/></emitter>'
SPOT = f'<emitter type="spot"><float name="intensity" value="60"/><float name="cutoff_angle" value="15"/>{AIMED}</emitter>'
LAMP = f'<shape type="rectangle">{AIMED}<emitter type="area"><float name="radiance" value="10"/></emitter></shape>'
# The plate is far enough from the lamp that Mitsuba's shadow rays hit it.
CIRCULAR_LAMP = plate('<emitter type="area"><float name="radiance" value="10"/></emitter>', 2, 0) + plate('<bsdf type="circular"/>', 2.3, 0.05)
PLATED_SPOT = SPOT + plate(POLARIZER, 0.5, 1, '<rotate y="1" angle="25"/>')
PLATED_SUN = DIRECTIONAL + plate(POLARIZER, 2, -10) + plate(RETARDER, 2, -9)
MEASURED = '<bsdf type="measured_polarized"><string name="filename" value="{folder}/measured.pbsdf"/><float name="wavelength" value="550"/></bsdf>'


def write_measured(path):
    """Writes a glossy Mueller matrix that varies with each of the three angles, as a .pbsdf file of one wavelength."""
    theta_h, theta_d, phi_d = (numpy.linspace(begin, end, n, dtype="f4") for begin, end, n in ((0, numpy.pi / 2, 46), (0, numpy.pi / 2, 31), (-numpy.pi, numpy.pi, 61)))
    phi, d, h = numpy.meshgrid(phi_d, theta_d, theta_h, indexing="ij")
    lobe = 0.1 + numpy.exp(-((h / 0.3) ** 2))
    mueller = numpy.zeros((*h.shape, 1, 4, 4), "f4")
    mueller[..., 0, 0, 0] = lobe
    mueller[..., 0, 0, 1] = mueller[..., 0, 1, 0] = 0.5 * lobe * numpy.sin(d) ** 2
    mueller[..., 0, 2, 0] = 0.2 * lobe * numpy.sin(d) * numpy.sin(phi)
    mueller[..., 0, 3, 0] = 0.1 * lobe * numpy.sin(h) * numpy.cos(phi)
    fields = {"M": mueller, "phi_d": phi_d[None], "theta_d": theta_d[None], "theta_h": theta_h[None], "wvls": numpy.array([550], "u2")}
    kinds = {"f4": 10, "u2": 3}
    heads = lambda offsets: b"".join(  # noqa: E731
        struct.pack(f"<H{len(name)}sHBQ{field.ndim}Q", len(name), name.encode(), field.ndim, kinds[field.dtype.str[1:]], offset, *field.shape)
        for (name, field), offset in zip(fields.items(), offsets)
    )
    magic = b"tensor_file\0" + struct.pack("<BBI", 1, 0, len(fields))
    sizes = [field.nbytes for field in fields.values()]
    begin = len(magic) + len(heads([0] * len(fields)))
    path.write_bytes(magic + heads([begin + sum(sizes[:i]) for i in range(len(sizes))]) + b"".join(f.tobytes() for f in fields.values()))


# name: (bsdf of the sphere, bsdf of the floor or none, lights, Mitsuba's number of bounces[, Mitsuba's integrator:
# shadow rays of volpath pass plates])
CASES = {
    "plastic, constant": (plastic(), None, CONSTANT, 2),
    "plastic, environment": (plastic(), plastic(), FOREST, 2),
    "plastic, directional": (plastic(), plastic(), DIRECTIONAL, 2),
    "plastic, point": (plastic(), plastic(), POINT, 2),
    "plastic, spot": (plastic(), plastic(), SPOT, 2),
    "plastic, area": (plastic(), plastic(), LAMP, 2),
    "metal, environment": (metal(0.3), None, FOREST, 2),
    "brushed plastic, environment": (brushed(plastic(), 0.4, 0.1), None, FOREST, 2),
    "brushed plastic, point": (brushed(plastic(), 0.15, 0.6), None, POINT, 2),
    "narrow plastic, environment": (plastic().replace("0.2", "0.03"), plastic(), FOREST, 2),
    "metal, directional": (metal(0.2), metal(0.4), DIRECTIONAL, 2),
    "metal, circular lamp": (metal(0.4), None, CIRCULAR_LAMP, 3),
    "metal, spot behind a polarizer": (metal(0.2), metal(0.4), PLATED_SPOT, 2, "volpath"),
    "metal, directional behind a retarder": (metal(0.4), None, PLATED_SUN, 2, "volpath"),
    "measured, point": (MEASURED, MEASURED, POINT, 2),
    "checkerboard": (plastic(checkerboard("diffuse_reflectance", 0.7, 0.1)), plastic(checkerboard("diffuse_reflectance", 0.1, 0.6)), POINT, 2),
    "checkerboard of roughness": (metal(0.2).replace('<float name="alpha" value="0.2"/>', checkerboard("alpha", 0.15, 0.4)), None, DIRECTIONAL, 2),
    "image": (plastic(image("diffuse_reflectance", "tiles_roughness.png", "true", 2)), plastic(image("diffuse_reflectance", "tiles_roughness.png", "false", 1)), LAMP, 2),
}
# Options of each method, and the tolerated differences of s0, s1, s2, s3 relative to the root mean square of s0.
METHODS = {
    "reference": ({"method": nicol.METHOD_REFERENCE, "samples": 256}, 0.004, 0.001, 0.001, 0.001),
    "factored": ({"finer": 4}, 0.03, 0.005, 0.005, 0.005),
}


def wall(bsdf, angle, axis="y"):
    return f"""<shape type="rectangle"><transform name="to_world"><translate z="-1"/><scale value="2"/>
        <rotate {axis}="1" angle="{angle}"/><translate y="1"/></transform>{bsdf}</shape>"""


def corner(bsdf, other=None):
    """Returns a floor and two walls behind and beside the sphere."""
    return wall(bsdf, -90, "x") + wall(other or bsdf, 0) + wall(bsdf, 90)


def room(bsdf):
    """Returns a closed room around the sphere and the camera."""
    return f'<shape type="cube"><boolean name="flip_normals" value="true"/><transform name="to_world"><scale value="6"/><translate y="4.5"/></transform>{bsdf}</shape>'


ROUGH = '<bsdf type="roughplastic"><float name="alpha" value="0.3"/><float name="diffuse_reflectance" value="0.7"/></bsdf>'
MASKED = f'<bsdf type="mask"><float name="opacity" value="0.4"/>{metal(0.3)}</bsdf>'
LIT_ROOM = LAMP.replace('value="10"', 'value="30"')
SQUARES = plastic(checkerboard("diffuse_reflectance", 0.8, 0.2))
# Scenes of light that is reflected several times. name: (bsdf of the sphere, other shapes, lights[, Mitsuba's integrator: volpath
# does not count what passes a mask])
PATHS = {
    "corner of plastic, environment": (plastic(), corner(plastic()), FOREST),
    "corner of metal, point": (plastic(), corner(metal(0.4), metal(0.3)), POINT),
    "room of plastic, area": (metal(0.3), room(plastic()), LIT_ROOM),
    "room of rough plastic, spot and area": (metal(0.2), room(ROUGH), SPOT + LIT_ROOM),
    "corner of squares, constant": (metal(0.3), corner(SQUARES, metal(0.3)), CONSTANT),
    "measured corner, directional": (plastic(), corner(MEASURED, plastic()), DIRECTIONAL),
    "masked sphere in a corner, area": (MASKED, corner(plastic(), metal(0.3)), LAMP, "volpath"),
    "brushed corner, spot": (plastic(), corner(brushed(plastic(), 0.4, 0.15)), SPOT),
}
# Paths end at a depth in the same place whatever the surfaces are, so that one scene shows it at more depths, and one whose mask counts in
# neither program.
DEPTHS = (3, nicol.DEPTH_UNLIMITED)
MORE_DEPTHS = {case: (3, 6, nicol.DEPTH_UNLIMITED) for case in ("corner of metal, point", "masked sphere in a corner, area")}
# Tolerated differences of light that is reflected several times, over means of blocks of pixels.
PATH_LIMITS = numpy.array((0.01, 0.005, 0.005, 0.005))
BLOCK = 4
GLASS = '<bsdf type="dielectric"><float name="int_ior" value="1.5"/></bsdf>'
THIN_GLASS = '<bsdf type="thindielectric"><float name="int_ior" value="1.5"/></bsdf>'
# A cube beside the sphere shows total reflection.
BLOCK_OF_GLASS = f'''<shape type="cube"><transform name="to_world"><scale value="0.4"/><rotate y="1" angle="25"/><translate x="1.1" y="-0.5" z="0.9"/></transform>
    {GLASS}</shape>'''
PANE = f'''<shape type="rectangle"><transform name="to_world"><scale value="0.8"/><rotate x="1" angle="-50"/><translate x="0.3" y="0.6" z="1.6"/></transform>
    {THIN_GLASS}</shape>'''
# Scenes of glass, each with its limits. Mitsuba's thindielectric depolarizes, so that s0 alone is compared, of light that arrives unpolarized.
S0_ALONE = numpy.array((0.01, numpy.inf, numpy.inf, numpy.inf))
GLASSES = {
    "glass on a floor, environment": (GLASS, FLOOR.format(plastic()) + BLOCK_OF_GLASS, FOREST, PATH_LIMITS),
    "glass on a floor, area": (GLASS, FLOOR.format(plastic()) + BLOCK_OF_GLASS, LAMP, PATH_LIMITS),
    "pane before a ball, environment": (ROUGH, FLOOR.format(ROUGH) + PANE, FOREST, S0_ALONE),
}
GLASS_DEPTH = 12


def map_of(name):
    return f'''<texture name="{name}" type="bitmap"><string name="filename" value="{{folder}}/{name}.exr"/><boolean name="raw" value="true"/>
        <string name="wrap_mode" value="clamp"/></texture>'''


def flat(bsdf, z, size, first=""):
    return f'''<shape type="rectangle"><transform name="to_world"><scale x="{size}" y="{0.8 * size}"/>{first}<translate z="{z}"/></transform>{bsdf}</shape>'''


# A lamp behind a polarizer, a stressed sheet and two analysers, one of which varies. The camera is far away, because Mitsuba turns the axes of
# tilted retarders.
STRESSED = f'''<scene version="3.0.0">
  <integrator type="stokes"><integrator type="path"><integer name="max_depth" value="9"/></integrator></integrator>
  <sensor type="perspective">
    <float name="fov" value="0.6"/>
    <transform name="to_world"><lookat origin="0,0,200" target="0,0,0" up="0,1,0"/></transform>
    <film type="hdrfilm"><integer name="width" value="48"/><integer name="height" value="40"/><rfilter type="box"/></film>
  </sensor>
  {flat('<emitter type="area"><float name="radiance" value="3"/></emitter>', -2, 4)}
  {flat('<bsdf type="polarizer"><float name="theta" value="10"/></bsdf>', -1, 5)}
  {flat(f'<bsdf type="retarder">{map_of("theta")}{map_of("delta")}</bsdf>', 0, 0.9, '<rotate z="1" angle="15"/>')}
  {flat('<bsdf type="polarizer"><float name="theta" value="70"/></bsdf>', 1, 0.8)}
  {flat(f'<bsdf type="polarizer">{map_of("theta")}</bsdf>', 0.5, 0.3, '<translate x="0.7" y="0.5"/>')}
</scene>
'''


def write_maps(folder):
    """Writes degrees of a sheet's axis and of its retardance as EXR files."""
    y, x = numpy.mgrid[:20, :30]
    for name, degrees in {"theta": 50 * numpy.sin(x / 9) + 40 * numpy.cos(y / 6), "delta": 20 * numpy.hypot(x - 9, y - 12)}.items():
        peer.mitsuba.Bitmap(degrees.astype("f4")[..., None]).write(str(folder / f"{name}.exr"))


def write_text(folder, text):
    write_measured(folder / "measured.pbsdf")
    (folder / "scene.xml").write_text(text.replace("{folder}", str(folder)))
    return folder / "scene.xml"


def write_scene(folder, case):
    sphere, floor, lights, depth, integrator = (*CASES[case], "path")[:5]
    return write_text(folder, SCENE.format(assets=ASSETS, depth=depth, integrator=integrator, lights=lights, sphere=sphere, floor=FLOOR.format(floor) if floor else ""))


def write_paths(folder, case, depth):
    sphere, shapes, lights, integrator = (*PATHS[case], "path")[:4]
    return write_text(folder, SCENE.format(assets=ASSETS, depth=depth, integrator=integrator, lights=lights, sphere=sphere, floor=shapes))


def blocks(image):
    """Returns means over blocks of pixels, which have less noise."""
    height, width = image.shape[:2]
    return image.reshape(height // BLOCK, BLOCK, width // BLOCK, BLOCK, 4).mean((1, 3))


def mitsuba_images(scene_file):
    scene = peer.mitsuba_scene(scene_file)
    return [peer.mitsuba_image(scene, SAMPLES, seed) for seed in (1, 2)]


def rotated(image, degrees):
    """Returns the light in frames that are rotated about the view direction."""
    angle = 2 * numpy.radians(degrees)
    s0, s1, s2, s3 = numpy.moveaxis(image, -1, 0)
    c, s = numpy.cos(angle), numpy.sin(angle)
    return numpy.stack([s0, c * s1 + s * s2, c * s2 - s * s1, s3], -1)


# Typical mistakes of other programs, applied to images.
MISTAKES = {
    "s2 of the other sign": lambda image: image * (1, 1, -1, 1),
    "s3 of the other sign": lambda image: image * (1, 1, 1, -1),
    "x along the other axis": lambda image: rotated(image, 90),
    "frames rotated by 30 degrees": lambda image: rotated(image, 30),
}


class MitsubaTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def check_close(self, ours, truth, limits):
        """Checks that ours differs from truth by no more than the limits and noise."""
        error, deviation = stokes_images.squared_error(ours, truth)
        allowed = limits**2 + 4 * deviation
        print(" ", *(f"s{i} {max(e, 0) ** 0.5:.4f} of {a**0.5:.4f}" for i, (e, a) in enumerate(zip(error, allowed))), flush=True)
        self.assertTrue((error <= allowed).all(), f"squared errors {error}; allowed {allowed}")

    def check(self, ours, truth, limits):
        """Checks that ours is close to the truth, and that each mistake would be detected."""
        self.check_close(ours, truth, limits)
        for name, mistake in MISTAKES.items():
            if "s3" in name and not truth[0][..., 3].any():
                continue
            error, deviation = stokes_images.squared_error([mistake(image) for image in ours], truth)
            self.assertTrue((error > limits**2 + 4 * deviation).any(), f"{name} does not show: {error}")

    def test_images(self):
        for case in CASES:
            scene = write_scene(self.folder, case)
            truth = mitsuba_images(scene)
            for method, (options, *limits) in METHODS.items():
                with self.subTest(case=case, method=method):
                    print(f"{case}, {method}", end=":")
                    seeds = (1, 2) if method == "reference" else (1,)  # a picture without noise stands for both
                    ours = [stokes_images.nicol_image(scene, seed=seed, **options) for seed in seeds]
                    self.check([ours[0], ours[-1]], truth, numpy.array(limits))

    def test_paths(self):
        """The reference method follows light that surfaces reflect to each other."""
        options, *_ = METHODS["reference"]

        def ours(scene, depth):
            return [blocks(stokes_images.nicol_image(scene, seed=seed, max_depth=depth, **options)) for seed in (1, 2)]

        for case in PATHS:
            direct = ours(write_paths(self.folder, case, 2), 2)
            for depth in MORE_DEPTHS.get(case, DEPTHS):
                with self.subTest(case=case, depth=depth):
                    print(f"{case}, depth {depth}", end=":")
                    scene = write_paths(self.folder, case, depth)
                    truth = [blocks(image) for image in mitsuba_images(scene)]
                    self.check_close(ours(scene, depth), truth, PATH_LIMITS)
                    error, deviation = stokes_images.squared_error(direct, truth)
                    self.assertTrue((error > PATH_LIMITS**2 + 4 * deviation).any(), "direct light alone does")

    def test_glass(self):
        """The reference method follows light through glass. The dense method refuses it."""
        options = {"method": nicol.METHOD_REFERENCE, "samples": 1024, "max_depth": GLASS_DEPTH}
        for case, (sphere, floor, lights, limits) in GLASSES.items():
            with self.subTest(case=case):
                print(case, end=":")
                scene = write_text(self.folder, SCENE.format(assets=ASSETS, depth=GLASS_DEPTH, integrator="path", lights=lights, sphere=sphere, floor=floor))
                truth = [blocks(image) for image in mitsuba_images(scene)]
                ours = [blocks(stokes_images.nicol_image(scene, seed=seed, **options)) for seed in (1, 2)]
                self.check_close(ours, truth, limits)
                with self.assertRaisesRegex(nicol.Error, r"glass that light passes.*set method to factored or reference"):
                    stokes_images.nicol_image(scene, method=nicol.METHOD_DENSE)

    def test_stressed_sheet(self):
        """Textures of a retarder's axis and retardance, and of a polarizer's axis. Pixels show both sides of edges, hence the limits by default."""
        write_maps(self.folder)
        scene = write_text(self.folder, STRESSED)
        truth = mitsuba_images(scene)
        for name, options, limit in (("reference", METHODS["reference"][0], 0.004), ("factored", {"pixel_samples": 64}, 0.006)):
            with self.subTest(method=name):
                print("stressed sheet,", name, end=":")
                seeds = (1, 2) if name == "reference" else (1,)
                ours = [stokes_images.nicol_image(scene, seed=seed, **options) for seed in seeds]
                self.check([ours[0], ours[-1]], truth, numpy.full(4, limit))

    def test_angles(self):
        """The AoLP agrees modulo 180 degrees wherever light is polarized."""
        scene = write_scene(self.folder, "plastic, point")
        a, b = mitsuba_images(scene)
        truth = (a + b) / 2
        with nicol.Context.create() as context, nicol.Scene.load(context, str(scene)) as loaded:
            with nicol.Framebuffer.create(context, *loaded.get_film_size(), loaded.get_channels()) as framebuffer:
                nicol.render(loaded, loaded.get_camera(), nicol.RenderOptions(method=nicol.METHOD_REFERENCE), framebuffer)
                aolp = framebuffer.plane(nicol.PLANE_AOLP, 1).astype(float)
        self.assertLessEqual(abs(aolp).max(), numpy.float32(numpy.pi / 2))
        polarized = numpy.hypot(truth[..., 1], truth[..., 2]) > numpy.maximum(0.1 * truth[..., 0], 0.01 * truth[..., 0].max())
        difference = aolp - numpy.arctan2(truth[..., 2], truth[..., 1]) / 2
        difference = numpy.degrees(abs((difference + numpy.pi / 2) % numpy.pi - numpy.pi / 2))[polarized]
        self.assertGreater(difference.size, 200)
        self.assertLess(difference.mean(), 0.2)
        self.assertLess(numpy.quantile(difference, 0.99), 2)


if __name__ == "__main__":
    print(f"Mitsuba {peer.mitsuba.__version__}, {peer.choose_variant()}")
    unittest.main()
