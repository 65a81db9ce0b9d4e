# SPDX-License-Identifier: MIT
"""Reads Blender's materials: Principled, Diffuse, Glass and Emission nodes with image textures.

A dielectric becomes Mitsuba's pplastic and a metal a roughconductor, because both polarize the light that they reflect.
"""

from __future__ import annotations

import math

import numpy

from .description import Material, Scene, Surface, Texture, Value
from .read_image import decoded, texture_of

_SMOOTHEST = 0.001  # smallest roughness of facets
# Sockets of the Principled node that have no counterpart, with the value at which they have no effect.
_WITHOUT_EFFECT = {
    "Subsurface Weight": 0, "Coat Weight": 0, "Sheen Weight": 0, "Anisotropic Rotation": 0,
    "Subsurface": 0, "Clearcoat": 0, "Sheen": 0,
}  # fmt: skip


def read_material(material, scene: Scene) -> Surface:
    """Returns the surface of a material of Blender, or that of an object without one."""
    if material is None:
        return Surface(_two_sided(Material("diffuse", {"reflectance": (0.8, 0.8, 0.8)})))
    if not material.use_nodes:
        color = tuple(material.diffuse_color[:3])
        return Surface(_two_sided(_blended(color, float(material.metallic), _alpha(float(material.roughness)), {})))
    return _MaterialReader(material, scene).run()


def _two_sided(material: Material) -> Material:
    return Material("twosided", parts=(material,))


def _alpha(roughness: Value) -> Value:
    """Returns the roughness of facets, which is the square of Blender's."""
    if isinstance(roughness, Texture):
        # Mipmaps average the squares.
        pixels = numpy.square(_linear(roughness)[..., :1])
        return Texture(pixels, True, roughness.filter, roughness.wrap, roughness.to_uv)
    return max(_SMOOTHEST, roughness**2)


def _linear(texture: Texture) -> numpy.ndarray:
    if texture.raw and texture.pixels.dtype == numpy.uint8:
        return texture.pixels.astype(numpy.float32) / 255
    return decoded(texture.pixels)


def _metal(base: Value, facets: dict[str, Value]) -> Material:
    """Returns a metal of index 1 - ik that reflects the base colour at normal incidence; for a texture, a mirror times it."""
    if isinstance(base, Texture):
        values: dict[str, Value] = {"eta": (0.0,) * 3, "k": (1.0,) * 3, "specular_reflectance": base}
    else:
        kept = [min(max(x, 0.0), 0.999) for x in base]
        values = {"eta": (1.0,) * 3, "k": tuple(2 * math.sqrt(x / (1 - x)) for x in kept)}
    return Material("roughconductor", {"distribution": "ggx", **values, **facets})


def _blended(base: Value, metallic: Value, alpha: Value, plastic: dict[str, Value], facets=None) -> Material:
    facets = {"alpha": alpha} if facets is None else facets
    dielectric = Material("pplastic", {"distribution": "ggx", "diffuse_reflectance": base, **plastic, **facets})
    if metallic == 0:
        return dielectric
    metal = _metal(base, facets)
    return metal if metallic == 1 else Material("blendbsdf", {"weight": metallic}, (dielectric, metal))


class _MaterialReader:
    def __init__(self, material, scene: Scene) -> None:
        self.material, self.scene, self.where = material, scene, f"material {material.name}"

    def run(self) -> Surface:
        tree = self.material.node_tree
        output = tree.get_output_node("CYCLES") or tree.get_output_node("ALL")
        if output is None or not output.inputs["Surface"].is_linked:
            self._notice("has no surface, and is black")
            return Surface(_two_sided(Material("diffuse", {"reflectance": (0.0, 0.0, 0.0)})))
        for name in ("Volume", "Displacement"):
            if output.inputs[name].is_linked:
                self._notice(f"{name} is not followed")
        node = output.inputs["Surface"].links[0].from_node
        read = {"BSDF_PRINCIPLED": self._principled, "BSDF_DIFFUSE": self._diffuse, "BSDF_GLASS": self._glass,
                "EMISSION": self._emission}.get(node.type)  # fmt: skip
        if read is None:
            self._notice(f"the node {node.name} is not followed, the material is grey")
            return Surface(_two_sided(Material("diffuse", {"reflectance": (0.8, 0.8, 0.8)})))
        return read(node)

    def _notice(self, text: str) -> None:
        self.scene.notice(f"{self.where}: {text}")

    def _one_or_two_sided(self, material: Material) -> Material:
        return material if self.material.use_backface_culling else _two_sided(material)

    def _principled(self, node) -> Surface:
        for name, neutral in _WITHOUT_EFFECT.items():
            socket = node.inputs.get(name)
            if socket is not None and (socket.is_linked or socket.default_value != neutral):
                self._notice(f"{name} is not followed")
        base = self._color(node, "Base Color")
        alpha = _alpha(self._number(node, "Roughness"))
        emitted = self._radiance(node)
        transmission = self._constant(node, "Transmission Weight", "Transmission")
        if 0 < transmission < 1:
            self._notice(f"Transmission {transmission:g} is taken as {round(transmission)}")
        if transmission >= 0.5:
            return Surface(self._transmitting(node, base, alpha), emitted)
        made = self._one_or_two_sided(self._reflecting(node, base, alpha))
        return Surface(self._masked(node, self._with_normals(node, made)), emitted)

    def _reflecting(self, node, base: Value, alpha: Value) -> Material:
        level = self._constant(node, "Specular IOR Level", "Specular")
        if level > 0.5:
            self._notice("Specular IOR Level above 0.5 is taken as 0.5; IOR makes the reflection brighter")
        plastic: dict[str, Value] = {"int_ior": max(self._constant(node, "IOR"), 1.001)}
        if level < 0.5:
            plastic["specular_reflectance"] = (2 * level,) * 3
        anisotropic = self._constant(node, "Anisotropic")
        facets: dict[str, Value] = {"alpha": alpha, **self._film(node)}
        if anisotropic and isinstance(alpha, Texture):
            self._notice("Anisotropic beside a Roughness texture is not followed")
        elif anisotropic:
            aspect = math.sqrt(1 - 0.9 * anisotropic)
            del facets["alpha"]
            facets |= {"alpha_u": min(1.0, alpha / aspect), "alpha_v": max(_SMOOTHEST, alpha * aspect)}
            self._notice("Anisotropic follows the direction of U, whatever Tangent says")
        return _blended(base, self._number(node, "Metallic"), alpha, plastic, facets)

    def _film(self, node) -> dict[str, Value]:
        """Returns the thin film of a node of Blender 4.2 or later."""
        if self._socket(node, "Thin Film Thickness") is None:
            return {}
        thickness = self._constant(node, "Thin Film Thickness")
        return {"film_thickness": min(thickness, 10000.0), "film_eta": self._constant(node, "Thin Film IOR")} if thickness > 0 else {}

    def _transmitting(self, node, base: Value, alpha: Value) -> Material:
        if isinstance(base, Texture) or isinstance(alpha, Texture):
            self._notice("textures of glass are followed by their mean")
        color = tuple(_linear(base).mean((0, 1))) if isinstance(base, Texture) else base
        rough = float(alpha.pixels.mean()) if isinstance(alpha, Texture) else alpha
        values: dict[str, Value] = {
            "int_ior": self._constant(node, "IOR"), "specular_transmittance": tuple(math.sqrt(max(0.0, x)) for x in color),
            **self._film(node),
        }  # fmt: skip
        if rough < 0.01:
            return Material("dielectric", values)
        return Material("roughdielectric", {"distribution": "ggx", "alpha": rough, **values})

    def _diffuse(self, node) -> Surface:
        made = self._one_or_two_sided(Material("diffuse", {"reflectance": self._color(node, "Color")}))
        return Surface(self._with_normals(node, made))

    def _glass(self, node) -> Surface:
        return Surface(self._transmitting(node, self._color(node, "Color"), _alpha(self._number(node, "Roughness"))))

    def _emission(self, node) -> Surface:
        black = Material("diffuse", {"reflectance": (0.0, 0.0, 0.0)})
        return Surface(black, self._times(self._color(node, "Color"), self._constant(node, "Strength")))

    def _radiance(self, node) -> Value | None:
        strength = self._constant(node, "Emission Strength")
        color = self._color(node, "Emission Color", "Emission")
        if strength == 0 or (isinstance(color, tuple) and not any(color)):
            return None
        return self._times(color, strength)

    @staticmethod
    def _times(color: Value, factor: float) -> Value:
        if isinstance(color, Texture):
            pixels = _linear(color) * numpy.float32(factor)
            return Texture(pixels, True, color.filter, color.wrap, color.to_uv)
        return tuple(x * factor for x in color)

    def _with_normals(self, node, base: Material) -> Material:
        socket = node.inputs["Normal"]
        if not socket.is_linked:
            return base
        source = socket.links[0].from_node
        if source.type != "NORMAL_MAP" or source.space != "TANGENT":
            self._notice(f"the normals of the node {source.name} are not followed")
            return base
        if self._constant(source, "Strength") != 1:
            self._notice("the Strength of a Normal Map is taken as 1")
        normals = self._texture(source.inputs["Color"])
        if normals is None:
            return base
        normals.raw = True
        return Material("normalmap", {"normals": normals}, (base,))

    def _masked(self, node, base: Material) -> Material:
        opacity = self._number(node, "Alpha")
        if isinstance(opacity, Texture):
            return Material("mask", {"opacity": opacity}, (base,))
        if opacity < 1:
            self._notice(f"Alpha {opacity:g} is taken as 1; a texture cuts holes")
        return base

    def _socket(self, node, *names: str):
        return next((node.inputs[name] for name in names if name in node.inputs), None)

    def _constant(self, node, *names: str) -> float:
        """Returns the number of a socket whose textures are not followed."""
        socket = self._socket(node, *names)
        if socket.is_linked:
            self._notice(f"what is linked to {socket.name} is not followed, its value is taken")
        return float(socket.default_value)

    def _color(self, node, *names: str) -> Value:
        socket = self._socket(node, *names)
        if socket.is_linked:
            source = socket.links[0].from_node
            if source.type == "RGB":
                return tuple(source.outputs[0].default_value[:3])
            texture = self._texture(socket)
            if texture is not None:
                return texture
        return tuple(min(max(x, 0.0), 1e6) for x in socket.default_value[:3])

    def _number(self, node, name: str) -> float | Texture:
        socket = node.inputs[name]
        if socket.is_linked:
            source = socket.links[0].from_node
            if source.type == "VALUE":
                return float(source.outputs[0].default_value)
            texture = self._texture(socket, one=True)
            if texture is not None:
                return texture
        return float(socket.default_value)

    def _texture(self, socket, one: bool = False) -> Texture | None:
        """Returns the image that is linked to a socket, directly or by one channel of a Separate Color node."""
        link, channel = socket.links[0], None
        if link.from_node.type in ("SEPARATE_COLOR", "SEPRGB") and link.from_node.inputs[0].is_linked:
            channel = [output.identifier for output in link.from_node.outputs].index(link.from_socket.identifier)
            link = link.from_node.inputs[0].links[0]
        elif link.from_socket.name == "Alpha":
            channel = 3
        node = link.from_node
        if node.type != "TEX_IMAGE":
            self._notice(f"the node {node.name} before {socket.name} is not followed, the socket's value is taken")
            return None
        made = texture_of(node, channel, self.scene, f"{self.where}, {socket.name}")
        if made is not None and one and made.pixels.shape[2] == 3:
            # Blender takes the luminance of colours.
            weights = numpy.array([0.2126, 0.7152, 0.0722], numpy.float32)
            made.pixels, made.raw = (_linear(made) @ weights)[..., None], True
        return made
