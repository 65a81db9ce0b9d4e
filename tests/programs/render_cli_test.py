# SPDX-License-Identifier: MIT
# Tests of nicol-render from the outside: its output, and exit code 2 with one clear line for every bad input.
import json
import os
import struct
import subprocess
import unittest

from images import exr_channels, exr_size, read_png
from program_test import PROGRAM, ProgramTest

EMITTER = '<emitter type="constant"><rgb name="radiance" value="1,0.5,0.25"/></emitter>'
SHAPE = '<shape type="rectangle"><bsdf type="pplastic"><float name="alpha" value="0.3"/></bsdf></shape>'


def scene(emitter=EMITTER, shape=SHAPE, width="$res", height="16"):
    return f"""<scene version="3.0.0">
  <default name="res" value="24"/>
  <sensor type="perspective">
    <float name="fov" value="40"/>
    <transform name="to_world"><lookat origin="1,0.5,4" target="0,0,0" up="0,1,0"/></transform>
    <film type="hdrfilm"><integer name="width" value="{width}"/><integer name="height" value="{height}"/></film>
  </sensor>
  {emitter}
  {shape}
</scene>
"""


def exr(width, height, value=1.0):
    """Returns an uncompressed OpenEXR file of 32-bit floats with the channels B, G, R."""

    def attribute(name, kind, data):
        return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(data)) + data

    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    channels = b"".join(n + b"\0" + struct.pack("<iBxxxii", 2, 0, 1, 1) for n in (b"B", b"G", b"R")) + b"\0"
    head = struct.pack("<ii", 20000630, 2)
    head += attribute("channels", "chlist", channels)
    head += attribute("compression", "compression", b"\0")
    head += attribute("dataWindow", "box2i", window)
    head += attribute("displayWindow", "box2i", window)
    head += attribute("lineOrder", "lineOrder", b"\0")
    head += attribute("pixelAspectRatio", "float", struct.pack("<f", 1))
    head += attribute("screenWindowCenter", "v2f", struct.pack("<ff", 0, 0))
    head += attribute("screenWindowWidth", "float", struct.pack("<f", 1)) + b"\0"
    line_size = 3 * 4 * width
    offsets, lines, position = b"", b"", len(head) + 8 * height
    for y in range(height):
        offsets += struct.pack("<q", position)
        lines += struct.pack("<ii", y, line_size) + struct.pack("<f", value if y == height // 2 else 1) * (3 * width)
        position += 8 + line_size
    return head + offsets + lines


class RenderTest(ProgramTest):
    def setUp(self):
        super().setUp()
        os.mkdir(self.path("out"))
        self.write("good.xml", scene())

    def image_size(self):
        return exr_size(self.files()[self.path("out", "a.exr")])

    def image_channels(self):
        return set(exr_channels(self.files()[self.path("out", "a.exr")]))

    def statistics(self):
        with open(self.path("out/s.json"), encoding="utf-8") as file:
            return json.load(file)

    def image_and_statistics(self, scene_file, *arguments):
        self.assert_succeeds(scene_file, "-o", "out/a.exr", "--stats", "out/s.json", *arguments)
        return self.files()[self.path("out", "a.exr")], self.statistics()

    def write_ring(self, brightness):
        """Writes a scene of a smooth metal ball under a ring of light. Its highlight has high orders."""
        self.write("ring.exr", exr(16, 8, brightness))
        emitter = '<emitter type="envmap"><string name="filename" value="ring.exr"/></emitter>'
        ball = '<shape type="sphere"><bsdf type="roughconductor"><string name="material" value="Al"/></bsdf></shape>'
        self.write("ring.xml", scene(emitter=emitter, shape=ball))

    def error_lines(self, stderr):
        return [line for line in stderr.splitlines() if ": notice: " not in line]


class Success(RenderTest):
    def test_image(self):
        run = self.assert_succeeds("good.xml", "-o", "out/a.exr")
        self.assertEqual(run.stderr, "")
        self.assertEqual(self.image_size(), (24, 16))
        wanted = set("RGB") | {f"S{p}.{c}" for p in range(4) for c in "RGB"}
        self.assertEqual(self.image_channels(), wanted)
        self.assertEqual(os.listdir(self.path("out")), ["a.exr"])

    def test_definitions_and_size(self):
        for arguments, size in (
            (["-D", "res=40"], (40, 16)),
            (["-Dres=41"], (41, 16)),
            (["--define=res=42"], (42, 16)),
            (["--size", "31x17"], (31, 17)),
            (["-D", "res=40", "--size=31x17"], (31, 17)),
        ):
            self.assert_succeeds("good.xml", "-o", "out/a.exr", *arguments)
            self.assertEqual(self.image_size(), size, arguments)

    def test_environment(self):
        self.write("light.exr", exr(16, 8, 3))
        lit = '<emitter type="envmap"><string name="filename" value="light.exr"/></emitter>'
        for name, emitter in (("lit", lit), ("dark", ""), ("bright", EMITTER)):
            self.write(name + ".xml", scene(emitter=emitter))
        wanted = self.image_and_statistics("lit.xml")[0]
        for name in ("dark", "bright"):
            self.assertNotEqual(self.image_and_statistics(name + ".xml")[0], wanted)
            self.assertEqual(self.image_and_statistics(name + ".xml", "--environment", "light.exr")[0], wanted)

    def test_view_and_light_of_gltf(self):
        self.write("light.exr", exr(16, 8, 3))
        assets = os.path.join(os.path.dirname(__file__), "..", "..", "samples", "assets")
        given = (os.path.join(assets, "solids.gltf"), "-o", "out/a.exr", "--environment", "light.exr", "--size", "24x16",
                 "--order-low", "4", "--pixel-samples", "1", "--images", "out")

        def picture(*more):
            self.assert_succeeds(*given, *more)
            files = self.files()
            return files[self.path("out/a.exr")], files[self.path("out/s0.png")]

        plain = picture()
        self.assertEqual(picture("--rotate-environment", "0"), plain)
        turned = picture("--rotate-environment", "90")
        self.assertNotEqual(turned[0], plain[0])
        self.assertNotEqual(picture("--rotate-environment", "-90")[0], turned[0])
        brighter = picture("--exposure", "1.5")
        self.assertEqual(brighter[0], plain[0])
        self.assertNotEqual(brighter[1], plain[1])
        seen = {picture("--look-at", view)[0] for view in ("0,1,5,0,0,0", "0,1,5,0,0,0,20", "0,6,0,0,0,0", "0,-6,0,0,0,0")}
        self.assertEqual(len(seen), 4)
        for view, said in (("0,1,5", "has 3 numbers"), ("0,1,5,0,0,a", "is not a number"), ("1,1,1,1,1,1", "target")):
            self.assert_fails(["--look-at" if view[-1] != "1" else "", said], *given, "--look-at", view)
        self.assert_fails(["--rotate-environment", "is not a number"], *given, "--rotate-environment", "east")

    def test_gltf(self):
        self.write("light.exr", exr(16, 8, 3))
        assets = os.path.join(os.path.dirname(__file__), "..", "..", "samples", "assets")
        solids = os.path.join(assets, "solids.gltf")
        run = self.assert_succeeds(solids, "--environment", "light.exr", "-o", "out/a.exr", "--order-low", "4")
        self.assertEqual(self.image_size(), (768, 512))
        self.assertEqual(run.stderr, "")
        run = self.assert_succeeds(solids, "-o", "out/a.exr", "--order-low", "4")
        self.assertEqual(run.stderr.count("notice: "), 1, run.stderr)
        self.assertIn("solids.gltf: no emitter lights the scene", run.stderr)
        run = self.assert_succeeds(os.path.join(assets, "textured.gltf"), "--environment", "light.exr", "-o", "out/a.exr",
                                   "--size", "96x64", "--order-low", "4")
        self.assertEqual(run.stderr, "")

    def test_shutter(self):
        numbers = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0) + struct.pack("<8f", 0, 2, -0.5, 0, 0, 0.5, 0.5, 0)
        self.write("a.bin", numbers)
        views = [(0, 36), (36, 8), (44, 24)]
        self.write("a.gltf", json.dumps({
            "asset": {"version": "2.0"},
            "buffers": [{"uri": "a.bin", "byteLength": len(numbers)}],
            "bufferViews": [{"buffer": 0, "byteOffset": at, "byteLength": size} for at, size in views],
            "accessors": [
                {"bufferView": view, "type": kind, "componentType": 5126, "count": count}
                for view, kind, count in ((0, "VEC3", 3), (1, "SCALAR", 2), (2, "VEC3", 2))
            ],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
            "nodes": [{"mesh": 0}, {"mesh": 0, "translation": [0, 0, -1], "scale": [4, 4, 1]}],
            "animations": [{
                "name": "slide",
                "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}],
                "samplers": [{"input": 1, "output": 2}],
            }],
        }))  # fmt: skip
        self.write("light.exr", exr(16, 8, 3))
        given = ("a.gltf", "-o", "out/a.exr", "--environment", "light.exr", "--size", "24x16", "--order-low", "4",
                 "--look-at", "0.5,0.5,4,0.5,0.5,0")  # fmt: skip

        def picture(*more):
            self.assert_succeeds(*given, *more)
            with open(self.path("out/a.exr"), "rb") as file:
                return file.read()

        still = picture("--time", "1")
        self.assertEqual(picture("--shutter", "1,1,1"), still)
        self.assertEqual(picture("--shutter", "1,1,3", "--animation", "slide"), still)
        self.assertEqual(picture("--shutter", "0,2,1"), still)  # the time in the middle
        self.assertNotEqual(picture("--shutter", "0,2,4"), still)
        for said, more in (
            ("'1' is not OPEN,CLOSE", ["--shutter", "1"]),
            ("closes before it opens", ["--shutter", "2,1"]),
            ("COUNT", ["--shutter", "0,1,0"]),
            ("COUNT", ["--shutter", "0,1,2.5"]),
            ("is not a number", ["--shutter", "0,one"]),
            ("--shutter and a time", ["--shutter", "0,1", "--time", "0"]),
        ):
            self.assert_fails([said], *given, *more)
        self.assert_fails(["no animation"], *given, "--shutter", "0,1", "--animation", "walk")

    def test_mosaic(self):
        self.write("sensor.json", '{"preset": "imx250myr", "seed": 5}')
        files = []
        for name, options in (
            ("a", ["--sensor", "sensor.json"]),
            ("b", ["--sensor", "sensor.json", "--frame", "0"]),
            ("c", ["--sensor", "sensor.json", "--frame", "1"]),
            ("d", ["--sensor", "out/a.png"]),
            ("e", []),
        ):
            output = ["-o", "out/a.exr", "--mosaic", f"out/{name}.png"]
            self.assert_succeeds("good.xml", "--seed", "0", *output, *options)
            with open(self.path("out", name + ".png"), "rb") as file:
                files.append(file.read())
        a, b, c, d, e = files
        self.assertEqual(struct.unpack(">IIBB", a[16:26]), (24, 16, 16, 0))  # 16 bits, grey
        self.assertIn(b"Nicol:Mosaic\0polarized_bayer", a)
        self.assertIn(b"Nicol:Bits\x0012", a)
        self.assertIn(b"Nicol:Mosaic\0polarized 90 45 / 135 0", e)
        self.assertEqual(a, b)
        self.assertEqual(a, d)
        self.assertNotEqual(a, c)

    def test_polarizer_images(self):
        self.assert_succeeds("good.xml", "-o", "out/a.exr", "--images", "out/angles", "--polarizers", "0,45,-22.5")
        images = [name for name in sorted(os.listdir(self.path("out/angles"))) if name.startswith("polarizer")]
        self.assertEqual(images, ["polarizer_-22.5.png", "polarizer_0.png", "polarizer_45.png"])
        self.assert_fails(["--polarizers", "--images"], "good.xml", "-o", "out/a.exr", "--polarizers", "0")
        self.assert_fails(["--polarizers", "'x'"], "good.xml", "-o", "out/b.exr", "--images", "out/b", "--polarizers", "x")

    def test_images_and_statistics(self):
        self.assert_succeeds("good.xml", "-o", "out/a.exr", "--images", "out/deep/er", "--stats", "out/s.json")
        images = sorted(os.listdir(self.path("out/deep/er")))
        self.assertEqual(images, ["aolp.png", "dolp.png", "s0.png", "s1.png", "s2.png", "s3.png"])
        for name in images:
            with open(self.path("out/deep/er", name), "rb") as file:
                head = file.read(24)
            self.assertEqual(head[:8], b"\x89PNG\r\n\x1a\n")
            self.assertEqual(struct.unpack(">II", head[16:]), (24, 16))
        stats = self.statistics()
        self.assertIn(stats["backend"], ("egl", "osmesa"))
        self.assertTrue(stats["renderer"])
        self.assertEqual((stats["width"], stats["height"], stats["channels"]), (24, 16, 3))
        self.assertGreater(stats["vertices"], 3)
        self.assertEqual(
            set(stats["milliseconds"]),
            {"project", "bake", "bake_trace", "relight", "bounce", "shade", "light", "trace", "draw", "observe"},
        )
        # A flat square does not shadow itself, for which the bake traces no rays.
        self.assertEqual(stats["rays"], stats["rays"] | {"camera": 0, "shadow": 0, "light": 0, "light_skipped": 0, "smooth": 0})
        self.assertEqual(stats["rays"]["bake"], 0)
        self.assertGreater(stats["rays"]["bake_skipped"], 0)
        self.assertEqual(stats["skipped"]["unoccluded"], stats["vertices"])
        self.assertGreater(stats["bytes"]["visibility"], 0)
        self.assertEqual(stats["unphysical"], 0)
        self.assertGreater(stats["milliseconds"]["observe"], 0)
        self.assertEqual(set(stats["skipped"]), {"vertices", "unoccluded", "unbaked", "light_columns", "response_rows", "channels_shared"})
        self.assertGreater(stats["bytes"]["texture"], 24 * 16 * 16)
        self.assertEqual(sorted(os.listdir(self.path("out"))), ["a.exr", "deep", "s.json"])

    def test_lights(self):
        table = "400:0, 500:8, 600:15.6, 700:18.4"
        self.write("lit.xml", scene(emitter=f'''<emitter type="point"><spectrum name="intensity" value="{table}"/></emitter>
            <emitter type="directional"><vector name="direction" value="0 0 -1"/><float name="dolp" value="1"/></emitter>'''))
        run = self.assert_succeeds("lit.xml", "-o", "out/a.exr", "--split-lights", "0", "--light-samples=4")
        self.assertEqual(run.stderr, "")

    def test_orders(self):
        for low in ("0", "4", "12", "32"):
            self.assertEqual(self.image_and_statistics("good.xml", "--order-low", low)[1]["order"], int(low))
        self.assert_succeeds("good.xml", "-o", "out/a.exr", "--order-low", "4", "--order-high", "4")

    def test_reference(self):
        reference = ["good.xml", "--method", "reference", "--samples", "8"]
        first, stats = self.image_and_statistics(*reference)
        self.assertEqual(stats["rays"]["camera"], 24 * 16 * 8)
        self.assertGreater(stats["rays"]["shadow"], 0)
        self.assertGreater(stats["milliseconds"]["trace"], 0)
        self.assertEqual(stats["triangles"], 2)
        self.assertEqual(self.image_and_statistics(*reference, "--seed", "0")[0], first)
        self.assertNotEqual(self.image_and_statistics(*reference, "--seed", "18446744073709551615")[0], first)
        self.assertNotEqual(self.image_and_statistics("good.xml", "--method=reference", "--samples=16")[0], first)
        self.assertNotEqual(self.image_and_statistics("good.xml")[0], first)

    def test_max_depth(self):
        corner = SHAPE + SHAPE.replace("<bsdf", '<transform name="to_world"><rotate y="1" angle="90"/></transform><bsdf')
        integrator = '<integrator type="path"><integer name="max_depth" value="3"/></integrator>'
        self.write("corner.xml", scene(integrator + EMITTER, corner))
        reference = ["corner.xml", "--method=reference", "--samples=8"]
        image = {depth: self.image_and_statistics(*reference, f"--max-depth={depth}")[0] for depth in (1, 2, 3, -1)}
        self.assertEqual(len(set(image.values())), 4)
        self.assertEqual(self.image_and_statistics(*reference)[0], image[3])
        self.assertEqual(self.image_and_statistics(*reference, "--max-depth", "-1")[0], image[-1])
        # Without an integrator in the scene, and without shadows, light is direct.
        self.write("corner.xml", scene(EMITTER, corner))
        self.assertEqual(self.image_and_statistics(*reference)[0], image[2])
        self.write("corner.xml", scene(integrator + EMITTER, corner))
        self.assert_succeeds(*reference, "-o", "out/a.exr", "--no-shadows")
        # The factored method follows the scene too; the dense method reflects light once, whatever the scene asks for.
        factored = {depth: self.image_and_statistics("corner.xml", f"--max-depth={depth}")[0] for depth in (2, 3)}
        self.assertNotEqual(factored[2], factored[3])
        image, statistics = self.image_and_statistics("corner.xml")
        self.assertEqual(image, factored[3])
        self.assertEqual(statistics["bounces"]["rounds"], 1)
        self.assertGreater(statistics["bounces"]["light"], 0)
        self.assert_succeeds("corner.xml", "-o", "out/a.exr", "--no-shadows")
        self.assert_succeeds("corner.xml", "-o", "out/a.exr", "--method=dense")

    def test_cache(self):
        def tables():
            names = os.listdir(self.path("tables")) if os.path.isdir(self.path("tables")) else []
            # Linked programs are ignored, because the driver decides whether to keep them.
            return sorted(name for name in names if not name.endswith(".program"))

        self.assert_succeeds("good.xml", "-o", "out/a.exr", NICOL_CACHE="")
        self.assert_succeeds("good.xml", "-o", "out/b.exr", "--cache", "tables")
        made = tables()
        self.assertEqual(sorted(name.rsplit(".", 1)[1] for name in made), ["response", "visibility"])
        run = self.assert_succeeds("good.xml", "-o", "out/c.exr", NICOL_CACHE=self.path("tables"))
        self.assertEqual(run.stderr, "")
        self.assertEqual(tables(), made)
        whole = {name: self.files()[self.path("tables", name)] for name in made}
        for name, output in zip(made, ("d", "e")):
            with open(self.path("tables", name), "r+b") as file:
                file.truncate(100)
            run = self.assert_succeeds("good.xml", "-o", f"out/{output}.exr", "--cache", "tables")
            self.assertEqual(run.stderr.count("notice: "), 1, run.stderr)
            self.assertIn(name, run.stderr)
            self.assertEqual(self.files()[self.path("tables", name)], whole[name])
        files = self.files()
        for name in "bcde":
            self.assertEqual(files[self.path("out", name + ".exr")], files[self.path("out", "a.exr")], name)
        # Without either, the folder is the user's. Mesa's own cache would complain where it finds no folder.
        no_variable = {"NICOL_CACHE": None, "MESA_SHADER_CACHE_DISABLE": "true", "HOME": self.path("home")}
        for folder, root in (("own/nicol", self.path("own")), ("home/.cache/nicol", None)):
            run = self.assert_succeeds("good.xml", "-o", "out/e.exr", **no_variable, XDG_CACHE_HOME=root)
            self.assertEqual(run.stderr, "")
            kept = [name for name in os.listdir(self.path(folder)) if not name.endswith(".program")]
            self.assertEqual(sorted(kept), made)
        self.write("no_folder", "x")
        run = self.assert_succeeds("good.xml", "-o", "out/e.exr", **no_variable, XDG_CACHE_HOME=self.path("no_folder"))
        self.assertEqual(run.stderr, "")
        # A cache path that is no folder also causes a notice.
        self.write("file", "x")
        run = self.assert_succeeds("good.xml", "-o", "out/d.exr", "--cache", "file/deep")
        self.assertIn("notice: ", run.stderr)

    def test_methods_and_shadows(self):
        # The scene is a square standing on another one, under light with every order.
        squares = "".join(
            f'<shape type="rectangle"><transform name="to_world">{turn}</transform></shape>'
            for turn in ("<rotate x='1' angle='-90'/>", "")
        )
        sky = (
            '<emitter type="sky"><float name="turbidity" value="2"/>'
            '<vector name="sun_direction" x="0.5" y="0.5" z="-0.6"/></emitter>'
        )
        self.write("sky.xml", scene(emitter=sky, shape=squares))

        def image(*arguments):
            plain = ["--order-low", "4", "--shade-at", "vertices", "--refine-tolerance", "0"]
            return self.image_and_statistics("sky.xml", *plain, *arguments)

        shadowed, stats = image("--cache", "kept")
        self.assertEqual(stats["order"], 9)
        self.assertLess(stats["skipped"]["unoccluded"], stats["vertices"])
        # About half of the 2048 directions lie above a vertex.
        rays = stats["rays"]["bake"] + stats["rays"]["bake_skipped"]
        self.assertAlmostEqual(rays / stats["vertices"] / 2048, 0.5, delta=0.05)
        again, stats = image("--cache", "kept")
        self.assertEqual(again, shadowed)
        self.assertEqual(stats["rays"]["bake"], 0)
        self.assertEqual(stats["milliseconds"]["bake_trace"], 0)
        images = [shadowed]
        for arguments in (
            ["--method", "dense"],
            ["--high-orders", "convolution"],
            ["--high-orders=none"],
            ["--no-shadows"],
            ["--bake-directions", "256"],
            ["--dering", "0.01"],
        ):
            images.append(image(*arguments)[0])
        self.assertEqual(len(set(images)), len(images))
        self.assertEqual(image("--high-orders", "split")[0], shadowed)
        _, stats = image("--high-orders", "none", "--no-shadows")
        self.assertEqual(stats["order"], 4)
        self.assertEqual(stats["rays"]["bake"], 0)
        self.assertEqual(stats["bytes"]["visibility"], 0)

    def test_tolerance_and_components(self):
        orders = []
        for tolerance in ("0.5", "0.0001"):
            stats = self.image_and_statistics("good.xml", "--tolerance", tolerance)[1]
            self.assertLessEqual(stats["predicted_error"], float(tolerance))
            orders.append(stats["order"])
        self.assertLessEqual(orders[0], orders[1])
        s0, whole = (self.image_and_statistics("good.xml", "--components", name)[0] for name in ("s0", "all"))
        self.assertNotEqual(s0, whole)

    def test_a_tolerance_that_no_orders_reach_is_noticed(self):
        self.write_ring(100)
        for tolerance, told in (("0.0001", True), ("0.9", False)):
            run = self.assert_succeeds("ring.xml", "-o", "out/a.exr", "--tolerance", tolerance, "--bsdf-samples", "0")
            self.assertEqual("no orders reach it" in run.stderr, told, run.stderr)

    def test_planes(self):
        self.assert_succeeds("good.xml", "-o", "out/a.exr")
        bare = self.image_channels()
        normals = {"N.X", "N.Y", "N.Z"}
        for names, more in (
            ("depth", {"Z"}),
            ("ids,normals", {"id"} | normals),
            ("alpha", {"A"}),
            ("depth,normals,positions,ids,alpha", {"Z", "id", "A", "P.X", "P.Y", "P.Z"} | normals),
        ):
            for method in ("factored", "reference"):
                self.assert_succeeds("good.xml", "-o", "out/a.exr", "--aovs", names, "--method", method, "--samples=1")
                self.assertEqual(self.image_channels(), bare | more)
        self.assert_succeeds("good.xml", "-o", "out/a.exr", "--aovs=variance", "--method=reference", "--samples=2")
        self.assertEqual(self.image_channels(), bare | {"variance." + name for name in bare if name[0] == "S"})
        asks = '<integrator type="aov"><string name="aovs" value="d:depth, n:sh_normal"/></integrator>'
        self.write("aovs.xml", scene(emitter=asks + EMITTER))
        self.assert_succeeds("aovs.xml", "-o", "out/a.exr", "--aovs=alpha")
        self.assertEqual(self.image_channels(), bare | {"Z", "A"} | normals)

    def test_devices(self):
        listed = self.assert_succeeds("--list-devices").stdout.splitlines()
        for number, line in enumerate(listed, 1):
            self.assertRegex(line, f"^{number}: .")
        for number, line in enumerate(listed, 1):
            if line.endswith(", runs on the CPU"):
                self.assert_succeeds("good.xml", "-o", "out/a.exr", f"--device={number}")
        if listed:
            self.assert_fails(["device"], "good.xml", "-o", "out/b.exr", f"--device={len(listed) + 1}")

    def test_executor(self):
        images = {}
        for name in ("cpu", "compute", "automatic"):
            image, stats = self.image_and_statistics("good.xml", "--executor", name)
            if name == "automatic":
                name = "cpu" if stats["software"] else "compute"
            self.assertEqual(stats["executor"], name)
            self.assertEqual(images.setdefault(name, image), image)
        self.assertIn(self.image_and_statistics("good.xml")[0], images.values())

    def test_shade_at(self):
        self.write_ring(100)
        image, stats = self.image_and_statistics("ring.xml", "--shade-at", "pixels")
        self.assertGreater(stats["pixels_shaded"], 0)
        self.assertEqual(stats["executor"], "cpu" if stats["software"] else "compute")
        vertices, stats = self.image_and_statistics("ring.xml", "--shade-at", "vertices")
        self.assertEqual(stats["pixels_shaded"], 0)
        self.assertNotEqual(image, vertices)
        self.assertIn(self.image_and_statistics("ring.xml")[0], (image, vertices))

    def test_physical(self):
        # A bright ring's lowest orders are negative between the ring and its poles, and a metal shows these values.
        self.write_ring(1000)
        orders = ["ring.xml", "--order-low", "4", "--shade-at", "vertices"]
        self.assertGreater(self.image_and_statistics(*orders)[1]["unphysical"], 0)
        self.assertEqual(self.image_and_statistics(*orders, "--no-physical")[1]["unphysical"], 0)

    def test_ignored_integrator_is_noticed(self):
        self.write("notice.xml", scene(emitter='<integrator type="stokes"/>' + EMITTER))
        run = self.assert_succeeds("notice.xml", "-o", "out/a.exr")
        self.assertIn("notice: ", run.stderr)
        self.assertIn("stokes", run.stderr)

    def test_replaces_in_one_step(self):
        # A second name of the old file shows whether the program wrote into it.
        self.write("out/a.exr", b"old")
        os.link(self.path("out/a.exr"), self.path("old.exr"))
        self.assert_succeeds("good.xml", "-o", "out/a.exr")
        self.assertEqual(self.image_size(), (24, 16))
        self.assertEqual(self.files()[self.path("old.exr")], b"old")

    def test_links_pipes_and_standard_output(self):
        """Output through any name has equal bytes, and links, devices and modes stay."""
        self.assert_succeeds("good.xml", "-o", "a.exr")
        with open(self.path("a.exr"), "rb") as file:
            expected = file.read()
        self.write("out/target.exr", "old")
        os.chmod(self.path("out/target.exr"), 0o600)
        os.symlink("out/target.exr", self.path("link.exr"))
        os.symlink("s.json", self.path("link.json"))
        os.symlink("/dev/null", self.path("null.exr"))
        for name in ("link.exr", "null.exr"):
            self.assert_succeeds("good.xml", "-o", name, "--stats", "link.json")
            self.assertTrue(os.path.islink(self.path(name)))
        self.assertTrue(os.path.islink(self.path("link.json")))
        with open(self.path("s.json"), encoding="utf-8") as file:
            self.assertEqual(json.load(file)["width"], 24)
        with open(self.path("out/target.exr"), "rb") as file:
            self.assertEqual(file.read(), expected)
        self.assertEqual(os.stat(self.path("out/target.exr")).st_mode & 0o777, 0o600)
        self.assertEqual(os.listdir(self.path("out")), ["target.exr"])
        # The test uses its own link, so that a defect cannot destroy /dev/stdout.
        os.symlink("/proc/self/fd/1", self.path("stdout"))
        for output in ("-", "stdout"):
            command = [PROGRAM, "good.xml", "-o", output]
            piped = subprocess.run(command, cwd=self.folder, capture_output=True, timeout=120)
            self.assertEqual((piped.returncode, piped.stdout), (0, expected), piped.stderr)
            with open(self.path("out.exr"), "wb") as file:
                file.write(b"before")
                file.flush()
                self.assertEqual(subprocess.run(command, cwd=self.folder, stdout=file, timeout=120).returncode, 0)
            with open(self.path("out.exr"), "rb") as file:
                self.assertEqual(file.read(), b"before" + expected)
        self.assertTrue(os.path.islink(self.path("stdout")))
        os.remove(self.path("stdout"))  # assert_fails() would read this link
        stats = self.assert_succeeds("good.xml", "-o", "a.exr", "--stats", "-").stdout
        self.assertEqual(json.loads(stats)["width"], 24)
        self.assert_fails(["--stats", "standard output"], "good.xml", "-o", "-", "--stats", "-")

    def test_help_and_version(self):
        self.assertIn("--order-low", self.assert_succeeds("--help").stdout)
        self.assertRegex(self.assert_succeeds("--version").stdout, r"^nicol-render \d+\.\d+\.\d+\n")


class CommandLine(RenderTest):
    def test_arguments(self):
        self.assert_each_fails(((["no scene"], ""), (["no output"], "good.xml"), (["-o"], "good.xml -o")))
        table = (
            (["two scenes"], "other.xml"),
            (["--frobnicate"], "--frobnicate"),
            (["-D", "res"], "-D res"),
            (["unknown_name"], "-D unknown_name=1"),
            (['no parameter "$time"'], "--time 1"),
            (["--backend", "metal"], "--backend metal"),
            (["--environment", "the path is empty"], "--environment="),
            (["none.exr"], "--environment none.exr"),
            (["--method", "'sparse'"], "--method sparse"),
            (["--executor", "'gpu'", "automatic, cpu, compute"], "--executor gpu"),
            (["--shade-at", "'edges'", "automatic, vertices, pixels"], "--shade-at edges"),
            (["--quality", "'best'", "realtime, preview, final"], "--quality best"),
            (["--high-orders", "'some'"], "--high-orders some"),
            (["--no-shadows=1"], "--no-shadows=1"),
            (["--bake-directions", "255"], "--bake-directions 255"),
            (["--bake-directions", "65537"], "--bake-directions 65537"),
            (["--dering", "'-1'"], "--dering -1"),
            (["--dering", "'nan'"], "--dering nan"),
            (["--tolerance", "'-0.1'"], "--tolerance -0.1"),
            (["--tolerance"], "--tolerance 0.1 --order-low 4"),
            (["--components", "'s4'", "s0, linear, all"], "--components s4"),
            (["--aovs", "'edges'", "depth, normals, positions, ids, alpha, variance"], "--aovs depth,edges"),
            (["variance", "reference"], "--aovs variance"),
            (["variance", "samples is 1"], "--aovs variance --method reference --samples 1"),
            (["--aovs", "''"], "--aovs depth,"),
            (["--device", "0"], "--device 0"),
            (["--device", "1025"], "--device 1025"),
            (["device"], "--device 1 --backend osmesa"),
            (["--no-physical=1"], "--no-physical=1"),
            (["33"], "--order-low 33"),
            (["4000000000"], "--order-low 4000000000"),
            (["4"], "--order-low 8 --order-high 4"),
            (["--order-high", "-1"], "--order-high -1"),
            (["--order-low", "four"], "--order-low four"),
            (["--split-lights", "65", "0 to 64"], "--split-lights 65"),
            (["--split-lights", "'-1'"], "--split-lights -1"),
            (["--light-samples", "0", "1 to 1024"], "--light-samples 0"),
            (["--light-samples", "1025"], "--light-samples 1025"),
            (["--max-depth", "0", "-1"], "--max-depth 0"),
            (["--max-depth", "-2"], "--max-depth=-2"),
            (["--max-depth", "'deep'"], "--max-depth deep"),
            (["max_depth is 3", "dense", "reference"], "--max-depth 3 --method dense"),
            (["max_depth is 1", "reference"], "--max-depth 1"),
            (["max_depth to 2"], "--max-depth 3 --no-shadows"),
            (["max_depth to 2"], "--max-depth 3 --no-shadows --method reference"),
            (["--samples", "'many'"], "--samples many"),
            (["--samples", "0"], "--samples 0"),
            (["--samples", "1048577"], "--method reference --samples 1048577"),
            (["--seed", "18446744073709551616"], "--seed 18446744073709551616"),
            (["--cache"], "--cache="),
            (["--size", "24"], "--size 24"),
            (["--size", "'a'"], "--size axb"),
            (["--size"], "--size 24x16x3"),
            (["--size"], "--size 99999999999x16"),
            (["0"], "--size 24x0"),
            (["100000"], "--size 100000x16"),
            (["4294967295"], "--size 4294967295x4294967295"),
        )
        self.assert_each_fails(table, "good.xml", "-o", "out/a.exr")


class Framed(RenderTest):
    def test_all_of_the_scene_is_in_the_image_and_touches_its_edges(self):
        self.write("lamp.xml", """<scene version="3.0.0">
            <sensor type="perspective"><transform name="to_world"><lookat origin="40,9,30" target="1,0,0" up="0,1,0"/></transform></sensor>
            <shape type="sphere"><emitter type="area"><rgb name="radiance" value="1,1,1"/></emitter></shape></scene>""")
        self.assert_succeeds("lamp.xml", "-o", "out/lamp.exr", "--frame-all", "--size", "60x40", "--pixel-samples", "1", "--images", "out")
        with open(self.path("out/s0.png"), "rb") as file:
            width, height, pixels = read_png(file.read())
        lit = {(i // 3 % width, i // 3 // width) for i, code in enumerate(pixels) if code > 0}
        rows, columns = {y for _, y in lit}, {x for x, _ in lit}
        # The box about the sphere touches the upper and lower edges, the sphere itself nearly.
        self.assertGreater(len(rows), 28)
        self.assertTrue(0 < min(columns) and max(columns) < width - 1)
        self.assertLess(abs(min(columns) + max(columns) - width + 1), 4)


class BadOutput(RenderTest):
    def test_name_of_another_kind(self):
        self.assert_fails(["photo.jpg", "must end in .exr"], "good.xml", "-o", "photo.jpg")
        self.assertFalse(os.path.exists(self.path("photo.jpg")))

    def test_folder_missing_or_no_folder(self):
        self.write("file", "x")
        self.assert_each_fails([([output], output) for output in ("nowhere/a.exr", "file/a.exr", "out")], "good.xml", "-o")
        self.assertTrue(os.path.isdir(self.path("out")))

    def test_folder_not_writable(self):
        if os.geteuid() == 0:
            self.skipTest("root may write anywhere")
        os.chmod(self.path("out"), 0o500)
        self.assert_fails(["out/a.exr"], "good.xml", "-o", "out/a.exr")

    def test_disk_full(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("no /dev/full")
        os.symlink("/dev/full", self.path("out/full.json"))
        run = self.run_program("good.xml", "-o", "out/a.exr", "--stats", "out/full.json")
        self.assertEqual(run.returncode, 2)
        self.assertIn("full.json", run.stderr)
        self.assertEqual(sorted(os.listdir(self.path("out"))), ["a.exr", "full.json"])

    def test_mosaic(self):
        self.write("bad.json", '{"full_well": 0}')
        write = ["good.xml", "-o", "out/a.exr", "--sensor", "bad.json"]
        self.assert_fails(["--sensor", "--mosaic"], *write)
        self.assert_fails(["bad.json", "full_well", "0"], *write, "--mosaic", "out/a.png")
        self.assert_fails(["--frame", "x"], *write, "--frame", "x")

    def test_images_and_statistics(self):
        self.write("file", "x")
        self.assert_succeeds("good.xml", "-o", "out/a.exr")
        self.assert_fails(["--images", "file"], "good.xml", "-o", "out/a.exr", "--images", "file")
        self.assert_fails(["nowhere"], "good.xml", "-o", "out/a.exr", "--stats", "nowhere/s.json")
        self.assertEqual(os.listdir(self.path("out")), ["a.exr"])


class BadFiles(RenderTest):
    """Each kind of bad file appears once, because the tests of the readers cover the details."""

    ENVIRONMENT = scene(emitter='<emitter type="envmap"><string name="filename" value="light.exr"/></emitter>')
    MESH = scene(shape='<shape type="obj"><string name="filename" value="mesh.obj"/></shape>')

    def test_scene(self):
        self.assert_fails(["nowhere.xml"], "nowhere.xml", "-o", "out/a.exr")
        for words, text in (
            (["bad.xml"], scene()[:-20]),
            (["bad.xml", "sunny", "supported"], scene(shape=SHAPE.replace("pplastic", "sunny"))),
            (["bad.xml", "unset"], scene(width="$unset")),
            (["light.exr"], self.ENVIRONMENT),
            (["mesh.obj"], self.MESH),
        ):
            with self.subTest(words=words, text=text[:40]):
                self.write("bad.xml", text)
                self.assert_fails(words, "bad.xml", "-o", "out/a.exr")

    def test_files_of_a_scene(self):
        image, mesh = exr(16, 8), b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
        for text, name, good in ((self.ENVIRONMENT, "light.exr", image), (self.MESH, "mesh.obj", mesh)):
            self.write("bad.xml", text)
            self.write(name, good)
            self.assert_succeeds("bad.xml", "-o", "out/a.exr")
            self.write(name, good[: len(good) // 2])
            self.assert_fails([name], "bad.xml", "-o", "out/a.exr")


class NoBackend(RenderTest):
    def test_egl_without_a_driver(self):
        nothing = {"__EGL_VENDOR_LIBRARY_DIRS": self.path("out"), "__EGL_VENDOR_LIBRARY_FILENAMES": ""}
        self.assert_fails(["EGL"], "good.xml", "-o", "out/a.exr", NICOL_BACKEND="egl", **nothing)
        self.assert_fails(["EGL"], "good.xml", "-o", "out/a.exr", "--backend", "egl", **nothing)

    def test_no_libraries(self):
        os.mkdir(self.path("lib"))
        for name in ("libEGL.so.1", "libEGL.so", "libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"):
            self.write(os.path.join("lib", name), "")  # the loader finds these empty files first
        nothing = {"LD_LIBRARY_PATH": self.path("lib")}
        self.assert_fails(["libEGL", "libOSMesa"], "good.xml", "-o", "out/a.exr", **nothing)
        self.assert_fails(["libEGL"], "good.xml", "-o", "out/a.exr", "--backend", "egl", **nothing)
        self.assert_fails(["libOSMesa"], "good.xml", "-o", "out/a.exr", "--backend", "osmesa", **nothing)

    def test_unknown_name(self):
        self.assert_fails(["NICOL_BACKEND", "metal"], "good.xml", "-o", "out/a.exr", NICOL_BACKEND="metal")


if __name__ == "__main__":
    unittest.main()
