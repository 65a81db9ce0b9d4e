# SPDX-License-Identifier: MIT
"""Random scenes in Mitsuba's format. A seed determines the scene: shapes with mirrored and sheared transforms, materials with
textures and maps, lights far and close, floors up to a million times as large as what stands on them, slits, boxes with a hole,
sizes of 1e-4 to 1e6 and offsets of up to a million sizes; mirrors and glass, and a quarter of the scenes with light that surfaces
reflect to each other. All colours are grey, because the peers compare luminances."""

import dataclasses

import numpy

SIZE = 96

SCENE = """<scene version="3.0.0">
  <path value="{assets}"/>
  <integrator type="stokes"><integrator type="volpath"><integer name="max_depth" value="{depth}"/></integrator></integrator>
  <sensor type="perspective">
    <float name="fov" value="40"/><float name="near_clip" value="{near!r}"/><float name="far_clip" value="{far!r}"/>
    <transform name="to_world"><lookat origin="{eye}" target="{target}" up="0.1,1,0.2"/></transform>
    <film type="hdrfilm">
      <integer name="width" value="{size}"/><integer name="height" value="{size}"/><rfilter type="box"/>
    </film>
  </sensor>
{objects}
</scene>
"""


def number(name, value):
    return f'<float name="{name}" value="{value:.9g}"/>'


def transform(*steps):
    return f'<transform name="to_world">{"".join(steps)}</transform>'


def scale(*by):
    x, y, z = by * 3 if len(by) == 1 else by
    return f'<scale x="{x:.9g}" y="{y:.9g}" z="{z:.9g}"/>'


def rotate(axis, degrees):
    x, y, z = axis
    return f'<rotate x="{x:.9g}" y="{y:.9g}" z="{z:.9g}" angle="{degrees:.9g}"/>'


def translate(by):
    x, y, z = by
    return f'<translate x="{float(x)!r}" y="{float(y)!r}" z="{float(z)!r}"/>'


@dataclasses.dataclass
class Part:
    """An object of the scene, and what it is."""

    text: str
    words: str


class RandomScene:
    """text: the scene; words: what it has. without: "brushed" leaves out metals whose roughness depends on the direction, "narrow"
    the space between sheets and in boxes, "bounces" light that several surfaces reflect, and with
    it mirrors and glass, "far" offsets of more than a hundred sizes, which 32-bit positions do not hold. size: in place of the
    seed's, 0 for that; everything else stays the same."""

    def __init__(self, seed, assets, without=(), size=0.0):
        self.without = without
        self.random = numpy.random.default_rng(seed)
        self.size = 10 ** self.random.uniform(-4, 6) if self.chance(0.3) else 1.0
        self.size = size or self.size
        self.offset = numpy.zeros(3)
        if self.chance(0.3):
            self.offset = self.direction() * self.size * 10 ** self.random.uniform(1, 2 if "far" in without else 6)
        # Mirrors and glass need a depth that no path reaches, because the methods count it differently.
        self.depth = 2 if "bounces" in without else int(self.choice(2, 2, 2, 2, 2, 2, 3, 3, 12, 12))
        parts = self.surfaces() + self.lights()
        eye = self.direction() * self.random.uniform(4, 6)
        eye[1] = abs(eye[1]) + 0.4
        target = self.random.uniform(-0.2, 0.2, 3)
        self.text = SCENE.format(
            assets=assets,
            depth=self.depth,
            near=0.01 * self.size,
            far=1e5 * self.size,
            eye=self.coordinates(eye),
            target=self.coordinates(target),
            size=SIZE,
            objects="\n".join("  " + part.text for part in parts),
        )
        where = f"depth {self.depth}, size {self.size:.0e}, offset {numpy.linalg.norm(self.offset) / self.size:.0e}: "
        self.words = where + "; ".join(part.words for part in parts)

    def chance(self, probability):
        return self.random.random() < probability

    def choice(self, *options):
        return options[self.random.integers(len(options))]

    def direction(self):
        v = self.random.normal(size=3)
        return v / numpy.linalg.norm(v)

    def coordinates(self, point):
        return ",".join(repr(float(x)) for x in self.offset + self.size * numpy.asarray(point))

    def to_world(self, *steps):
        """Returns the transform by `steps`, and then to the scene's size and place."""
        return transform(*steps, scale(self.size), translate(self.offset))

    # Surfaces

    def surfaces(self):
        parts = []
        for i in range(self.random.integers(1, 4)):
            center = self.random.uniform(-0.8, 0.8, 3) * (1, 0.4, 1)
            parts.append(self.object(center, self.random.uniform(0.3, 0.8)))
        floor = self.choice("none", "floor", "floor", "large floor", "sheets", "box with a hole")
        if "narrow" in self.without and not floor.endswith("floor"):
            floor = "none"
        if floor.endswith("floor"):
            extent = 3 if floor == "floor" else 10 ** self.random.uniform(1, 6)
            parts.append(self.square(scale(extent, extent, 1), rotate((1, 0, 0), -90), rotate((0, 1, 0), 30), translate((0, -0.9, 0)), words=f"floor {extent:.1g}"))
        elif floor == "sheets":
            gap = self.random.uniform(0.3, 1)
            for y in (-gap / 2, gap / 2):
                parts.append(self.square(rotate((1, 0, 0), -90), translate((0, y, 0)), words=f"sheet, gap {gap:.1g}", sides=True))
        elif floor != "none":
            # Five walls that face inwards. Four strips around a hole are the sixth.
            walls = [((1, 0, 0), 90), ((1, 0, 0), -90), ((0, 1, 0), 90), ((0, 1, 0), -90), ((0, 1, 0), 0)]
            for axis, angle in walls:
                parts.append(self.square(translate((0, 0, -1)), rotate(axis, angle), scale(1.5), words="wall", sides=True))
            for angle in (0, 90, 180, 270):
                strip = (scale(0.65, 0.35, 1), translate((-0.35, 0.65, -1)), rotate((0, 0, 1), angle), rotate((0, 1, 0), 180))
                parts.append(self.square(*strip, scale(1.5), words="strip", sides=True))
        return parts

    def square(self, *steps, words, sides=False):
        material = self.material(textured=False, sides=sides)
        return Part(f'<shape type="rectangle">{self.to_world(*steps)}{material.text}</shape>', f"{words} of {material.words}")

    def object(self, center, radius):
        kind = self.choice("sphere", "sphere", "cube", "disk", "cylinder")
        steps = [rotate(self.direction(), self.random.uniform(0, 360)), translate(center)]
        words = kind
        if kind != "sphere" and self.chance(0.3):
            steps.insert(0, scale(-1, 1, 1))
            words += ", mirrored"
        if kind not in ("sphere", "cylinder") and self.chance(0.3):
            # A rotation between two unequal scales shears.
            steps = [scale(1, 0.7, 1.2), rotate(self.direction(), 50)] + steps
            words += ", sheared"
        steps.insert(0, scale(radius))
        if self.depth > 3 and self.chance(0.3):
            material = self.smooth(closed=kind in ("sphere", "cube"))
        else:
            material = self.material(textured=True, sides=kind in ("disk", "cylinder"))
        return Part(f'<shape type="{kind}">{self.to_world(*steps)}{material.text}</shape>', f"{words} of {material.words}")

    # Materials

    def material(self, textured, sides):
        part = self.plain(textured)
        if textured and self.chance(0.12):
            other = self.plain(False)
            weight = self.texture("weight", 0, 1)
            part = Part(f'<bsdf type="blendbsdf">{weight}{part.text}{other.text}</bsdf>', f"a blend of {part.words} and {other.words}")
        if textured and self.chance(0.12):
            map_of = self.image("normalmap", "tiles_normals.png", raw=True)
            part = Part(f'<bsdf type="normalmap">{map_of}{part.text}</bsdf>', f"{part.words} with a normal map")
        if sides or self.chance(0.2):
            part = Part(f'<bsdf type="twosided">{part.text}</bsdf>', f"two-sided {part.words}")
        return part

    def plain(self, textured):
        r = self.random
        kind = self.choice("diffuse", "pplastic", "plastic", "metal", "metal", "brushed metal", "principled")
        reflectance = self.texture("reflectance", 0.1, 0.8) if textured else number("reflectance", r.uniform(0.1, 0.8))
        diffuse = reflectance.replace('name="reflectance"', 'name="diffuse_reflectance"')
        alpha = 10 ** r.uniform(-1.3, -0.2)
        distribution = f'<string name="distribution" value="{self.choice("ggx", "beckmann")}"/>'
        if kind == "diffuse":
            return Part(f'<bsdf type="diffuse">{reflectance}</bsdf>', kind)
        if kind == "pplastic":
            facets = self.choice(number("alpha", alpha), number("alpha_u", alpha) + number("alpha_v", alpha**0.5))
            return Part(f'<bsdf type="pplastic">{distribution}{facets}{diffuse}</bsdf>', f"pplastic {alpha:.2f}{' brushed' if 'alpha_u' in facets else ''}")
        if kind == "plastic":
            return Part(f'<bsdf type="roughplastic">{distribution}{number("alpha", alpha)}{diffuse}</bsdf>', f"plastic {alpha:.2f}")
        if kind == "principled":
            numbers = "".join(number(name, r.uniform(0, 1)) for name in ("metallic", "specular", "clearcoat", "sheen"))
            color = reflectance.replace('name="reflectance"', 'name="base_color"')
            return Part(f'<bsdf type="principled">{number("roughness", alpha**0.5)}{numbers}{color}</bsdf>', f"principled {alpha**0.5:.2f}")
        index = number("eta", r.uniform(0.2, 2)) + number("k", r.uniform(2, 5))
        if kind == "metal" or "brushed" in self.without:
            return Part(f'<bsdf type="roughconductor">{distribution}{number("alpha", alpha)}{index}</bsdf>', f"metal {alpha:.2f}")
        other = alpha * r.uniform(1.5, 4) ** self.choice(-1, 1)
        other = min(max(other, 0.03), 0.9)
        return Part(
            f'<bsdf type="roughconductor">{distribution}{number("alpha_u", alpha)}{number("alpha_v", other)}{index}</bsdf>',
            f"brushed metal {alpha:.2f} {other:.2f}",
        )

    def smooth(self, closed):
        """Returns a mirror or glass. closed: whether the surface encloses a volume."""
        index = number("eta", self.random.uniform(0.2, 2)) + number("k", self.random.uniform(2, 5))
        mirror = Part(f'<bsdf type="twosided"><bsdf type="conductor">{index}</bsdf></bsdf>', "mirror")
        glass = number("int_ior", self.random.uniform(1.3, 1.7))
        kind = self.choice("dielectric", "thindielectric") if closed else "thindielectric"
        return self.choice(mirror, Part(f'<bsdf type="{kind}">{glass}</bsdf>', kind))

    def texture(self, name, least, most):
        value = number(name, self.random.uniform(least, most))
        low, high = self.random.uniform(least, most, 2)
        squares = self.random.integers(2, 7)
        board = f"""<texture name="{name}" type="checkerboard">{number("color0", low)}{number("color1", high)}
            <transform name="to_uv"><scale x="{squares}" y="{squares}"/></transform></texture>"""
        return self.choice(value, value, board, self.image(name, "tiles_roughness.png", raw=True))

    def image(self, name, file, raw):
        return f"""<texture name="{name}" type="bitmap"><string name="filename" value="{file}"/><boolean name="raw" value="{str(raw).lower()}"/>
            <transform name="to_uv"><scale x="2" y="2"/></transform></texture>"""

    # Lights

    def lights(self):
        distant = self.choice("none", "constant", "forest", "forest")
        parts = []
        if distant == "constant":
            parts.append(Part(f'<emitter type="constant">{number("radiance", 0.5)}</emitter>', "even sky"))
        elif distant == "forest":
            turn = transform(rotate((0, 1, 0), self.random.uniform(0, 360)))
            parts.append(Part(f'<emitter type="envmap"><string name="filename" value="forest_blurred.exr"/>{turn}</emitter>', "forest"))
        if not parts or self.chance(0.4):
            parts.append(self.local_light())
        return parts

    def local_light(self):
        kind = self.choice("point", "spot", "directional", "square", "square", "ball")
        place = self.direction()
        place[1] = abs(place[1]) + 0.2
        place *= self.random.uniform(1.8, 4)
        look = f'<lookat origin="{place[0]:.9g},{place[1]:.9g},{place[2]:.9g}" target="0,0,0" up="0.1,1,0.3"/>'
        intensity = number("intensity", 20 * self.size**2)
        if kind == "point":
            return Part(f'<emitter type="point"><point name="position" value="{self.coordinates(place)}"/>{intensity}</emitter>', kind)
        if kind == "spot":
            return Part(f'<emitter type="spot">{intensity}{number("cutoff_angle", 25)}{self.to_world(look)}</emitter>', kind)
        if kind == "directional":
            # Mitsuba multiplies the irradiance by the scale of the transform.
            return Part(f'<emitter type="directional">{number("irradiance", 2)}{transform(look)}</emitter>', kind)
        shape = "rectangle" if kind == "square" else "sphere"
        extent = self.random.uniform(0.1, 0.8)
        lamp = f'<emitter type="area">{number("radiance", 4 / extent**2)}</emitter>'
        return Part(f'<shape type="{shape}">{self.to_world(scale(extent), look)}{lamp}</shape>', f"{kind} light {extent:.1f}")
