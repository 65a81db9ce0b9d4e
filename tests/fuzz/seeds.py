# SPDX-License-Identifier: MIT
"""Writes small valid inputs for each fuzzer, a folder each. Usage: seeds.py FOLDER"""

import base64
import io
import json
import pathlib
import struct
import sys
import zipfile
import zlib

OBJ = """# comment
mtllib none.mtl
o thing
v 0 0 0
v 1 0 0
v 1 1 0.5
v 0 1 1e-1
vt 0 0
vn 0 0 1
vn 0 1 0
usemtl grey
f 1 2 3
f 1//1 3//2 4//1
f -4/1/1 \\
  -3/1/2 -2/1/1 -1/1/2
"""

PLY_HEADER = """ply
format {format} 1.0
comment none
element vertex 4
property {number} x
property {number} y
property {number} z
property {number} nx
property {number} ny
property {number} nz
property uchar red
element face 2
property list uchar int vertex_indices
property list uchar float texcoord
end_header
"""
PLY_VERTICES = [(0, 0, 0, 0, 0, 1, 9), (1, 0, 0, 0, 0, 1, 9), (1, 1, 0, 0, 0, 1, 9), (0, 1, 0, 0, 0, 1, 9)]


def ply_text():
    lines = [" ".join(map(str, v)) for v in PLY_VERTICES] + ["3 0 1 2 0", "4 0 1 2 3 2 0.5 0.5"]
    return PLY_HEADER.format(format="ascii", number="float") + "\n".join(lines) + "\n"


def ply_binary(order, number, code):
    name = {"<": "binary_little_endian", ">": "binary_big_endian"}[order]
    body = b"".join(struct.pack(order + 6 * code + "B", *v) for v in PLY_VERTICES)
    body += struct.pack(order + "B3iB", 3, 0, 1, 2, 0) + struct.pack(order + "B4iB2f", 4, 0, 1, 2, 3, 2, 0.5, 0.5)
    return PLY_HEADER.format(format=name, number=number).encode() + body


OFF = "OFF\n# comment\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0.5\n3 0 1 2 255 0 0\n4 0 1 2 3\n"
NOFF = "CNOFF\n3 1 0\n0 0 0 0 0 1 1 1 1 1\n1 0 0 0 0 1 1 1 1 1\n0 1 0 0 0 1 1 1 1 1\n3 0 1 2\n"

STL = """solid name
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 1 0
endloop
endfacet
facet normal nan nan nan
outer loop
vertex 1 0 0
vertex 1 1 2.5e-1
vertex 0 1 0
endloop
endfacet
endsolid name
"""


def stl_binary():
    facets = [(0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0), (0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 0)]
    return bytes(80) + struct.pack("<I", 2) + b"".join(struct.pack("<12fH", *f, 0) for f in facets)


def serialized(version, code, level):
    """Returns a file of two meshes, each a triangle with normals, texture coordinates and colours."""
    flags = {"f": 0x1000, "d": 0x2000}[code] | 1 | 2 | 8
    numbers = [0, 0, 1, 1, 0, 1, 0, 1, 1] + 3 * [0, 0, 1] + [0, 0, 1, 0, 0, 1] + [1, 0, 0, 0, 1, 0, 0, 0, 1]
    content = struct.pack("<I", flags) + (b"name\0" if version == 4 else b"") + struct.pack("<2Q", 3, 1)
    content += struct.pack(f"<{len(numbers)}{code}3I", *numbers, 0, 1, 2)
    mesh = struct.pack("<2H", 0x041C, version) + zlib.compress(content, level)
    return 2 * mesh + struct.pack({3: "<3I", 4: "<2QI"}[version], 0, len(mesh), 2)


def exr(channels, width, height, value=0.5, tile=0):
    """Returns an uncompressed float image in scan lines, or in one tile of size `tile`."""
    attribute = lambda name, kind, data: name + b"\0" + kind + b"\0" + struct.pack("<I", len(data)) + data
    names = sorted(channels)
    listed = b"".join(n.encode() + b"\0" + struct.pack("<IB3xii", 2, 0, 1, 1) for n in names) + b"\0"
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    head = struct.pack("<II", 20000630, 2 | (0x200 if tile else 0))
    head += attribute(b"channels", b"chlist", listed) + attribute(b"compression", b"compression", b"\0")
    head += attribute(b"dataWindow", b"box2i", window) + attribute(b"displayWindow", b"box2i", window)
    head += attribute(b"lineOrder", b"lineOrder", b"\0")
    head += attribute(b"pixelAspectRatio", b"float", struct.pack("<f", 1))
    head += attribute(b"screenWindowCenter", b"v2f", struct.pack("<2f", 0, 0))
    head += attribute(b"screenWindowWidth", b"float", struct.pack("<f", 1))
    if tile:
        head += attribute(b"tiles", b"tiledesc", struct.pack("<IIB", tile, tile, 0))
    head += b"\0"
    line = struct.pack(f"<{width}f", *([value] * width)) * len(names)
    if tile:
        chunks = [struct.pack("<5i", 0, 0, 0, 0, len(line) * height) + line * height]
    else:
        chunks = [struct.pack("<ii", y, len(line)) + line for y in range(height)]
    offsets, at = b"", len(head) + 8 * len(chunks)
    for chunk in chunks:
        offsets += struct.pack("<Q", at)
        at += len(chunk)
    return head + offsets + b"".join(chunks)


STOKES = [f"S{p}.{c}" for p in range(4) for c in "RGB"]
SPECTRAL = [f"S{p}.{nm},000000nm" for p in range(4) for nm in (450, 550)]


def npy(kind, shape, values):
    text = f"{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}\n".encode()
    return b"\x93NUMPY\1\0" + struct.pack("<H", len(text)) + text + values


def npz(members, method):
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", method) as archive:
        for name, content in members.items():
            archive.writestr(zipfile.ZipInfo(name + ".npy"), content, method)
    return out.getvalue()


LIGHT = npy("<f8", (1, 4, 4), struct.pack("<16d", 1, 0, 0, 0, *([0.1, 0, 0, 0.05] * 3)))
GREY_LIGHT = npy("<f4", (1, 4), struct.pack("<4f", 1, 0.5, 0.25, 0))
# A material of orders 0 and 1 has 2 (4 * 4 - 3 * 2 + 2) / ... = 2 * (16 - 6 + 2) / 3 = 8 rows of 4 x 4.
MATERIAL = npy("<f8", (1, 8, 4, 4), struct.pack("<128d", *([0.25] + 127 * [0.0])))
TEXTS = {"cod_type": npy("<U6", (), "POLAR4".encode("utf-32-le")), "sh_type": npy("|S4", (), b"REAL")}


def pbsdf(shape, wavelengths, angles=True, step=0.5):
    """Returns a table of `shape` (phi_d, theta_d, theta_h)."""
    phi, d, h = shape
    row = lambda n, to: struct.pack(f"<{n}f", *[to * i / max(n - 1, 1) for i in range(n)])
    count = phi * d * h * len(wavelengths)
    fields = [("phi_d", (1, phi), 10, row(phi, 6.2831)), ("theta_d", (1, d), 10, row(d, 1.5707)),
              ("theta_h", (1, h), 10, row(h, 1.5707)),
              ("wvls", (1, len(wavelengths)), 3, struct.pack(f"<{len(wavelengths)}H", *wavelengths)),
              ("M", (phi, d, h, len(wavelengths), 4, 4), 10, struct.pack("<16f", step, *([0.0] * 15)) * count)]
    if not angles:
        fields = [(n, (0, s[1]), t, b"") if len(s) == 2 and t == 10 else (n, s, t, b) for n, s, t, b in fields]
    at = 12 + 2 + 4 + sum(2 + len(n) + 2 + 1 + 8 + 8 * len(s) for n, s, _, _ in fields)
    head, data = b"tensor_file\0\1\0" + struct.pack("<I", len(fields)), b""
    for name, s, kind, content in fields:
        head += struct.pack("<H", len(name)) + name.encode() + struct.pack("<HBQ", len(s), kind, at + len(data))
        head += struct.pack(f"<{len(s)}Q", *s)
        data += content
    return head + data


def volume(values, encoding=1, channels=1):
    """Returns a grid of 3 x 2 x 2 values."""
    return b"VOL\3" + struct.pack("<5i6f", encoding, 3, 2, 2, channels, *6 * [0.0]) + struct.pack("<12f", *values)


SCENE = """<?xml version="1.0"?>
<scene version="3.0.0">
  <default name="w" value="8"/>
  <integrator type="stokes"><integrator type="path"/></integrator>
  <sensor type="perspective">
    <float name="fov" value="40"/><string name="fov_axis" value="smaller"/>
    <transform name="to_world"><lookat origin="0, 1, 3" target="0 0 0" up="0 1 0"/></transform>
    <film type="hdrfilm"><integer name="width" value="$w"/><integer name="height" value="6"/></film>
    <sampler type="independent"/>
  </sensor>
  <emitter type="constant"><rgb name="radiance" value="#ffeedd"/></emitter>
  <bsdf type="twosided" id="b"><bsdf type="pplastic"><float name="alpha" value="0.2"/></bsdf></bsdf>
  <shape type="shapegroup" id="g"><shape type="rectangle"><ref id="b"/></shape></shape>
  <shape type="instance"><ref id="g"/>
    <transform name="to_world"><rotate x="1" angle="30"/><scale value="2"/><translate y="1"/></transform></shape>
</scene>
"""
SKY = """<scene version="3.0.0"><path value="."/><alias id="m" as="n"/>
<bsdf type="roughconductor" id="m"><string name="material" value="Au"/><string name="distribution" value="ggx"/></bsdf>
<bsdf type="conductor" id="c"><spectrum name="eta" value="400:1, 700:2"/><rgb name="k" value="1 2 3"/></bsdf>
<sensor type="orthographic"><film type="hdrfilm"><string name="pixel_format" value="luminance"/></film></sensor>
<emitter type="sky"><vector name="sun_direction" x="1" y="2" z="3"/><float name="dop_max" value=".5"/></emitter>
<shape type="rectangle"><ref id="n"/><boolean name="flip_normals" value="true"/>
<transform name="to_world"><matrix value="1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"/></transform></shape>
<shape type="obj"><string name="filename" value="a.obj"/><ref id="c"/></shape>
</scene>
"""



TEXTURES = """<scene version="3.0.0"><sensor type="orthographic"/>
<texture type="checkerboard" id="t"><float name="color0" value=".2"/><float name="color1" value=".8"/>
<transform name="to_uv"><scale x="4" y="3"/></transform></texture>
<shape type="rectangle"><bsdf type="twosided"><bsdf type="normalmap">
<texture type="rawconstant"><vector name="value" x=".5" y=".5" z="1"/></texture>
<bsdf type="blendbsdf"><ref name="weight" id="t"/>
<bsdf type="pplastic"><ref name="alpha" id="t"/><ref name="diffuse_reflectance" id="t"/></bsdf>
<bsdf type="mask"><float name="opacity" value="1"/><bsdf type="conductor"/></bsdf></bsdf></bsdf></bsdf></shape>
<shape type="rectangle"><bsdf type="bumpmap"><float name="scale" value="2"/><ref id="t"/><bsdf type="diffuse">
<texture name="reflectance" type="bitmap"><string name="filename" value="a.png"/><boolean name="raw" value="true"/>
<string name="wrap_mode" value="mirror"/><string name="filter_type" value="nearest"/></texture></bsdf></bsdf></shape>
</scene>
"""


LIGHTS = """<scene version="3.0.0"><sensor type="orthographic"/>
<emitter type="directional"><vector name="direction" x="1" y="-1"/><float name="angular_radius" value=".3"/>
<spectrum name="irradiance" value="400:0, 700:9"/><float name="dolp" value=".6"/><float name="docp" value="-.8"/></emitter>
<emitter type="point"><point name="position" value="1 2 3"/><vector name="polarization_axis" y="1"/></emitter>
<emitter type="spot"><float name="cutoff_angle" value="30"/><texture name="texture" type="checkerboard"/></emitter>
<emitter type="projector"><float name="fov" value="40"/><string name="fov_axis" value="y"/><float name="scale" value="2"/></emitter>
<shape type="rectangle"><emitter type="area"><rgb name="radiance" value="1 2 300"/><boolean name="two_sided" value="true"/>
<float name="aolp" value="45"/></emitter></shape>
<shape type="disk"><emitter type="area"><texture name="radiance" type="checkerboard"/></emitter></shape>
<shape type="rectangle"><bsdf type="polarizer"><float name="theta" value="30"/></bsdf><transform name="to_world"><translate z=".01"/></transform></shape>
<shape type="rectangle"><bsdf type="retarder"><float name="delta" value="60"/></bsdf><transform name="to_world"><translate z=".02"/></transform></shape>
<shape type="cylinder"><point name="p0" x="1"/><point name="p1" z="2"/><float name="radius" value=".5"/></shape></scene>
"""


def gltf(binary):
    """Returns two nodes with one mesh of two primitives, interleaved and sparse data, a camera and materials with
    textures."""
    data = struct.pack("<24f", *[0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1, 1, 1, 0, 0, 0, 1])
    data += struct.pack("<6H4x", 0, 1, 2, 2, 1, 3) + struct.pack("<3f", 1, 1, 2)
    view = lambda offset, length, stride=0: {"buffer": 0, "byteOffset": offset, "byteLength": length,
                                             **({"byteStride": stride} if stride else {})}
    accessor = lambda kind, shape, count, view, **more: {"bufferView": view, "componentType": kind, "type": shape,
                                                         "count": count, **more}
    sparse = {"count": 1, "indices": {"bufferView": 1, "byteOffset": 10, "componentType": 5123},
              "values": {"bufferView": 2}}
    texture = lambda index, **more: {"index": index, **more}
    transform = {"KHR_texture_transform": {"offset": [0, 1], "rotation": 1.5, "scale": [2, 3], "texCoord": 0}}
    uri = {} if binary else {"uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}
    document = {
        "asset": {"version": "2.0"}, "extensionsRequired": ["KHR_materials_pbrSpecularGlossiness"], "scene": 0, "scenes": [{"nodes": [0, 2]}],
        "buffers": [{"byteLength": len(data), **uri}],
        "bufferViews": [view(0, 96, 24), view(96, 12), view(112, 12)],
        "accessors": [accessor(5126, "VEC3", 4, 0), accessor(5126, "VEC3", 4, 0, byteOffset=12),
                      accessor(5123, "SCALAR", 6, 1), accessor(5126, "VEC3", 4, 0, sparse=sparse),
                      accessor(5126, "VEC2", 4, 0)],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}, "indices": 2, "material": 0},
                                   {"attributes": {"POSITION": 0, "TEXCOORD_0": 4, "COLOR_0": 1}, "material": 2},
                                   {"attributes": {"POSITION": 3}, "mode": 5, "material": 1},
                                   {"attributes": {"POSITION": 0, "TEXCOORD_0": 4}, "material": 3},
                                   {"attributes": {"POSITION": 0, "NORMAL": 1},
                                    "extensions": {"KHR_materials_variants": {"mappings": [{"material": 4, "variants": [1, 0]}]}}}]}],
        "nodes": [{"mesh": 0, "children": [1], "translation": [1, 2, 3], "rotation": [0, 0, 0, 1]},
                  {"mesh": 0, "scale": [1, 2, -1], "extensions": {"KHR_lights_punctual": {"light": 0}}}, {"camera": 0, "matrix": [1, 0, 0, 0] + [0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 9, 1]}],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "spot", "intensity": 3, "color": [1, 0.5, 0], "range": 9,
                                                           "spot": {"innerConeAngle": 0.2, "outerConeAngle": 0.5}}]}},
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.7, "aspectRatio": 1.5, "znear": 0.1}}],
        "materials": [{"pbrMetallicRoughness": {"metallicFactor": 0, "baseColorFactor": [1, 0.5, 0, 1]},
                       "extensions": {"KHR_materials_ior": {"ior": 1.4}}}, {"doubleSided": True},
                      {"pbrMetallicRoughness": {"baseColorTexture": texture(0, extensions=transform),
                                                "metallicRoughnessTexture": texture(1, texCoord=0)},
                       "normalTexture": texture(2, scale=0.5), "alphaMode": "MASK", "alphaCutoff": 0.25},
                      {"extensions": {"KHR_materials_pbrSpecularGlossiness": {
                          "diffuseFactor": [1, 0.5, 0, 1], "diffuseTexture": texture(0, extensions=transform), "specularFactor": [1, 0.5, 0],
                          "specularGlossinessTexture": texture(1), "glossinessFactor": 0.5}}},
                      {"extensions": {"KHR_materials_unlit": {}}, "pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0, 1]}}],
        "textures": [{"source": 0, "sampler": 0}, {"source": 1}, {"source": 2}],
        "images": [{"uri": "a%20b.png"}, {"bufferView": 1, "mimeType": "image/png"},
                   {"uri": "data:image/png;base64,iVBORw0KGgo="}],
        "samplers": [{"wrapS": 33648, "wrapT": 33071, "magFilter": 9728, "minFilter": 9987}],
    }
    text = json.dumps(document).encode()
    if not binary:
        return text
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN") + data
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


TARGETS = [
    "/scenes/a/image.png?size=64x32&observer=dolp",
    "/scenes/a/image.exr?observer=polarizer&polarizer=30&exposure=1.5",
    "/scenes/a/image.png?observer=s2&scale=0.5&azimuth=-30&elevation=20&distance=2&target=0,1%2C2",
    "/scenes/a/stokes.f32?matrix=1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1&fov=30&light=400&light_tilt=-20",
    "/scenes/a/stokes.exr?order_low=2&order_high=9",
    "/scenes/a/image.png?tolerance=0.01&expires=99999999999&sig=" + "0" * 64,
]


def png(bits, kind, rows, width=2, palette=b""):
    def chunk(name, content):
        return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))

    header = struct.pack(">IIBBBBB", width, len(rows), bits, kind, 0, 0, 0)
    packed = zlib.compress(b"".join(b"\0" + row for row in rows))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + (chunk(b"PLTE", palette) if palette else b"")
            + chunk(b"IDAT", packed) + chunk(b"IEND", b""))


# 8 x 8 pixels of (200, 100, 50).
JPEG = base64.b64decode(
    "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDAAIBAQEBAQIBAQECAgICAgQDAgICAgUEBAMEBgUGBgYFBgYGBwkIBgcJBwYGCAsICQoK"
    "CgoKBggLDAsKDAkKCgr/2wBDAQICAgICAgUDAwUKBwYHCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoK"
    "CgoKCgoKCgr/wAARCAAIAAgDAREAAhEBAxEB/8QAFAABAAAAAAAAAAAAAAAAAAAABf/EABQQAQAAAAAAAAAAAAAAAAAAAAD/xAAU"
    "AQEAAAAAAAAAAAAAAAAAAAAI/8QAFBEBAAAAAAAAAAAAAAAAAAAAAP/aAAwDAQACEQMRAD8APFc2H//Z"
)
BMP = b"BM" + struct.pack("<IIIIiiHH24x", 62, 0, 54, 40, 2, 1, 1, 24) + b"\0\0\xff\0\x33\0\0\0"
TGA = struct.pack("<BBB5xHHHHBB", 0, 0, 2, 0, 0, 2, 1, 24, 0) + b"\0\0\xff\0\x33\0"
TGA_RUNS = struct.pack("<BBB5xHHHHBB", 0, 0, 10, 0, 0, 2, 1, 24, 0) + b"\x81\0\0\xff"
HDR = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n\x80\x40\0\x85\x80\x80\x80\x80"
HDR_RUNS = b"#?RGBE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 8\n\2\2\0\x08" + 4 * b"\x88\x80"


def requests():
    yield from TARGETS
    yield f"GET {TARGETS[0]} HTTP/1.1\r\nHost: a\r\nIf-None-Match: \"x\"\r\n\r\nHEAD /scenes HTTP/1.1\r\n\r\n"
    yield "POST /health HTTP/1.1\r\nContent-Length: 3\r\n\r\nabcGET / HTTP/1.0\r\nConnection: close\r\n\r\n"
    yield "PUT /x HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n3;a=b\r\nabc\r\n0\r\nT: 1\r\n\r\n"
    part = '--b\r\nContent-Disposition: form-data; name="a"; filename="c/d.xml"\r\n\r\n<scene/>\r\n'
    yield "multipart/form-data; boundary=b\n" + part + part.replace("d.xml", "e") + "--b--\r\n"


SENSOR = """{"preset": "imx250myr", "seed": 3, "bits": 10, "quantum_efficiency": [0.5, 0.6, 0.4], "shot_noise": false,
"read_noise": 2, "crosstalk": 1e-2, "elements": [{"kind": "retarder", "angle": 45, "retardance": 90, "transmittance": 0.9},
{"extinction_ratio": 1000}]}"""


def mosaic():
    """Returns a PNG with a sensor in its text, behind the header of 33 bytes."""
    image, text = png(8, 0, [b"ab", b"cd"]), b"Nicol:Sensor\0" + SENSOR.encode()
    return image[:33] + struct.pack(">I", len(text)) + b"tEXt" + text + bytes(4) + image[33:]


SEEDS = {
    "obj": [OBJ],
    "ply": [ply_text(), ply_binary("<", "float", "f"), ply_binary(">", "double", "d")],
    "off": [OFF, NOFF],
    "stl": [STL, stl_binary()],
    "serialized": [serialized(3, "f", 0), serialized(4, "f", 9), serialized(4, "d", 9)],
    "exr": [exr("RGB", 4, 2), exr("Y", 3, 3, tile=4), exr(STOKES, 2, 2, 0.0), exr(SPECTRAL, 2, 2, 0.0)],
    "bitmap": [png(8, 2, [b"abcdef", b"ghijkl"]), png(16, 0, [b"abcd"]), png(8, 3, [b"\1\0"], palette=b"abcdef"),
               png(1, 0, [b"a"]), JPEG, BMP, TGA, TGA_RUNS, HDR, HDR_RUNS],
    "sensor": [SENSOR, '{"mosaic": "plain", "optics": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}', mosaic()],
    "npz": [npz({"coeff": LIGHT, **TEXTS}, zipfile.ZIP_STORED), npz({"coeff": LIGHT, **TEXTS}, zipfile.ZIP_DEFLATED),
            npz({"coeff": MATERIAL}, zipfile.ZIP_STORED)],
    "npy": [LIGHT, GREY_LIGHT, MATERIAL],
    "pbsdf": [pbsdf((3, 2, 2), [550]), pbsdf((4, 2, 3), [450, 550, 650]), pbsdf((2, 2, 2), [550], angles=False)],
    "sdf_grid": [volume([-1, -1, 0.5] * 4), volume([1, -1, 1, -1, 1, -1, 0, 1, -1, 1, -1, 1]), volume([-1] * 12, 2, 3)],
    "scene": [SCENE, SKY, TEXTURES, LIGHTS],
    "gltf": [gltf(False), gltf(True)],
    "http": list(requests()),
    # The first byte chooses the function, and zeros leave its arguments unchanged.
    "capi": [bytes([function]) + bytes(24) for function in range(80)],
}


def main():
    root = pathlib.Path(sys.argv[1])
    for name, inputs in SEEDS.items():
        folder = root / name
        folder.mkdir(parents=True, exist_ok=True)
        for i, content in enumerate(inputs):
            (folder / str(i)).write_bytes(content if isinstance(content, bytes) else content.encode())


if __name__ == "__main__":
    main()
