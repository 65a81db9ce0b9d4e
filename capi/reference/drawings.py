#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws the frames of conventions.md as SVG. usage: drawings.py [FOLDER]

Each drawing computes its axes by the formula that the page gives, so that a drawing cannot disagree with its handedness.
x is red, y green, z blue, light amber. FOLDER is the folder `drawings` beside this file by default.
"""

import math
import os
import sys

RED, GREEN, BLUE, AMBER, GREY, BLACK = "#c0392b", "#1e8449", "#1f618d", "#d68910", "#99a3a4", "#212f3c"


def add(a, b, times=1.0):
    return tuple(p + times * q for p, q in zip(a, b))


def scaled(a, factor):
    return tuple(factor * p for p in a)


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def unit(a):
    return scaled(a, 1 / math.sqrt(dot(a, a)))


def frame(z, x):
    """Returns x, y, z with x made perpendicular to z, and y = z cross x."""
    z = unit(z)
    x = unit(add(x, z, -dot(x, z)))
    return x, cross(z, x), z


class Drawing:
    """An image, and the view of the points (x, y, z) that are drawn into it: parallel, y up, seen from `eye`."""

    def __init__(self, width, height, eye=(0.0, 0.0, 1.0)):
        self.width, self.height, self.parts = width, height, []
        self.look((0, 0), 1, eye)

    def look(self, middle, scale, eye=(0.0, 0.0, 1.0), up=(0.0, 1.0, 0.0)):
        """Sets where the origin is drawn, how many pixels a unit has, and from where it is seen."""
        self.middle, self.scale, self.eye = middle, scale, unit(eye)
        self.right = unit(cross(up, self.eye))
        self.up = cross(self.eye, self.right)

    def at(self, p):
        if len(p) == 2:
            p = (*p, 0.0)
        return self.middle[0] + self.scale * dot(p, self.right), self.middle[1] - self.scale * dot(p, self.up)

    def line(self, points, colour=BLACK, width=1.6, dash="", fill="none"):
        text = " ".join(f"{x:.1f},{y:.1f}" for x, y in map(self.at, points))
        dashes = f' stroke-dasharray="{dash}"' if dash else ""
        self.parts.append(f'<polyline points="{text}" fill="{fill}" stroke="{colour}" stroke-width="{width}"{dashes}/>')

    def arrow(self, start, end, colour=BLACK, label="", width=2.2):
        (x0, y0), (x1, y1) = self.at(start), self.at(end)
        length = math.hypot(x1 - x0, y1 - y0)
        if length < 6:  # towards or away from the viewer
            inside = f'<circle cx="{x0:.1f}" cy="{y0:.1f}" r="2" fill="{colour}"/>'
            self.parts.append(f'<circle cx="{x0:.1f}" cy="{y0:.1f}" r="6" fill="none" stroke="{colour}" stroke-width="1.6"/>{inside}')
            return self.text((x0 - 16, y0 + 16), label, colour)
        ux, uy = (x1 - x0) / length, (y1 - y0) / length
        self.parts.append(
            f'<line x1="{x0:.1f}" y1="{y0:.1f}" x2="{x1 - 9 * ux:.1f}" y2="{y1 - 9 * uy:.1f}" stroke="{colour}" stroke-width="{width}"/>'
        )
        self.head(x1, y1, ux, uy, colour)
        far = 11 + (3.2 * len(label) if abs(ux) > 0.5 else 0)
        self.text((x1 + far * ux, y1 + 13 * uy + 5), label, colour)

    def head(self, x, y, ux, uy, colour):
        bx, by = x - 9 * ux, y - 9 * uy
        corners = f"{x:.1f},{y:.1f} {bx - 4 * uy:.1f},{by + 4 * ux:.1f} {bx + 4 * uy:.1f},{by - 4 * ux:.1f}"
        self.parts.append(f'<polygon points="{corners}" fill="{colour}"/>')

    def axes(self, place, xyz, size=1.0, names=("x", "y", "z")):
        for axis, name, colour in zip(xyz, names, (RED, GREEN, BLUE)):
            if name:
                self.arrow(place, add(place, axis, size), colour, name)

    def text(self, at, words, colour=BLACK, anchor="middle", size=15):
        if words:
            self.parts.append(f'<text x="{at[0]:.1f}" y="{at[1]:.1f}" fill="{colour}" text-anchor="{anchor}" font-size="{size}">{words}</text>')

    def dot(self, p, colour=BLACK):
        x, y = self.at(p)
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.5" fill="{colour}"/>')

    def arc(self, middle, a, b, degrees, colour=BLACK, label="", start=0.0):
        """Draws an angle from the direction a towards b, which are unit and perpendicular, times their length."""
        turn = lambda t: add(add(middle, a, math.cos(t)), b, math.sin(t))  # noqa: E731
        angles = [math.radians(start + (degrees - start) * i / 24) for i in range(25)]
        self.line([turn(t) for t in angles[:-1]], colour, 1.4)
        (x0, y0), (x1, y1) = self.at(turn(angles[-3])), self.at(turn(angles[-1]))
        length = math.hypot(x1 - x0, y1 - y0)
        self.head(x1, y1, (x1 - x0) / length, (y1 - y0) / length, colour)
        x, y = self.at(add(middle, add(turn(angles[12]), middle, -1), 1.55))
        self.text((x, y + 5), label, colour)

    def sphere(self):
        """Draws the unit sphere with its equator, dashed behind."""
        circle = [math.radians(5 * i) for i in range(73)]
        self.line([add(scaled(self.right, math.cos(t)), self.up, math.sin(t)) for t in circle], GREY)
        self.great_circle((0, 1, 0), (0, 0, 1), GREY)

    def great_circle(self, normal, start, colour, width=1.2):
        x, y, _ = frame(normal, start)
        points = [add(scaled(x, math.cos(math.radians(3 * i))), y, math.sin(math.radians(3 * i))) for i in range(121)]
        for a, b in zip(points, points[1:]):
            behind = dot(add(a, b), self.eye) < 0
            self.line([a, b], colour, width * (0.5 if behind else 1), "2 3" if behind else "")

    def save(self, path):
        head = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {self.width} {self.height}" width="{self.width}" height="{self.height}" font-family="sans-serif">'
        body = "\n".join([head, f'<rect width="{self.width}" height="{self.height}" rx="8" fill="#fdfefe"/>', *self.parts, "</svg>\n"])
        with open(path, "w", encoding="utf-8") as file:
            file.write(body)


X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
ASIDE = (0.55, 0.45, 1.0)  # an eye to the right, above and in front


def spaces():
    d = Drawing(760, 210)
    for column, title in enumerate(("world: y up", "camera: +z forward", "surface: z is the normal", "image: row 0 at the top")):
        d.text((95 + 190 * column, 26), title)
    d.look((80, 150), 62, ASIDE)
    d.axes((0, 0, 0), (X, Y, Z))
    d.look((295, 150), 62, (-0.75, 0.35, -1.0))  # from behind: the camera looks away from us
    corners = [(s * 0.55, t * 0.42, 0.9) for s, t in ((1, 1), (-1, 1), (-1, -1), (1, -1), (1, 1))]
    d.line(corners, GREY)
    for corner in corners[:4]:
        d.line([(0, 0, 0), corner], GREY, 1)
    d.axes((0, 0, 0), (X, Y, Z), 0.9)
    d.look((475, 140), 62, (0.5, 0.7, 1.0))
    d.line([(s * 0.9, 0, t * 0.9) for s, t in ((1, 1), (-1, 1), (-1, -1), (1, -1), (1, 1))], GREY, fill="#eaeded")
    d.axes((0, 0, 0), frame(Y, X), 0.9)
    d.look((600, 165), 62)
    for row in range(5):
        d.line([(0, 0.45 * row), (2.25, 0.45 * row)], GREY, 1)
    for column in range(6):
        d.line([(0.45 * column, 0), (0.45 * column, 1.8)], GREY, 1)
    d.axes((0, 0, 0), (X, Y, Z), 1.6, ("x", "y", ""))
    d.text((635, 70), "row 0", size=12)
    return d


def stokes():
    d = Drawing(760, 300)
    d.text((150, 26), "light travels along z to the receiver")
    d.look((70, 150), 70, (-1.0, 0.4, 0.65))
    d.arrow((0, 0, -0.6), (0, 0, 3.0), AMBER, width=2.5)
    d.axes((0, 0, 0.9), (X, Y, Z))
    d.text((d.at((0, 0, 3.0))[0] + 8, d.at((0, 0, 3.0))[1] + 24), "receiver")
    states = (("s1 &gt; 0", 0), ("s1 &lt; 0", 90), ("s2 &gt; 0", 45), ("s2 &lt; 0", -45), ("s3 &gt; 0: right", "right"), ("s3 &lt; 0: left", "left"))
    d.text((545, 26), "what the receiver sees: x to the right, y up")
    for i, (name, state) in enumerate(states):
        d.look((385 + 150 * (i % 3), 100 + 130 * (i // 3)), 40)
        d.line([(-1.1, 0), (1.1, 0)], "#f5b7b1", 1)
        d.line([(0, -1.1), (0, 1.1)], "#abebc6", 1)
        if isinstance(state, str):
            # The electric vector of right circular light turns clockwise for the receiver.
            sign = -1.0 if state == "right" else 1.0
            d.arc((0, 0, 0), scaled(X, 0.8), scaled(Y, 0.8 * sign), 330, AMBER)
        else:
            e = (math.cos(math.radians(state)), math.sin(math.radians(state)), 0)
            d.arrow((0, 0, 0), e, AMBER), d.arrow((0, 0, 0), scaled(e, -1), AMBER)
        d.text((385 + 150 * (i % 3), 165 + 130 * (i // 3)), name)
    return d


def pixel():
    d = Drawing(620, 330)
    right, up = X, Y
    film = [(s, t, -1.6) for s, t in ((-1.25, -0.8), (1.25, -0.8), (1.25, 0.8), (-1.25, 0.8), (-1.25, -0.8))]
    d.look((235, 205), 108, (0.62, 0.3, 1.1))
    d.line(film, GREY, 1.4, fill="#f4f6f7")
    point = (1.05, 0.68, -1.6)
    direction = unit(point)
    x, y, z = frame(scaled(direction, -1), cross(up, scaled(direction, -1)))
    d.line([(0, 0, 0.9), add(point, (0, 0, 0))], AMBER, 2)
    d.dot((0, 0, 0.9))
    d.text((d.at((0, 0, 0.9))[0], d.at((0, 0, 0.9))[1] + 20), "camera")
    d.axes((-1.25, -0.8, -1.6), (right, up, Z), 0.5, ("right", "up", ""))
    d.axes(point, (x, y, z), 0.85, ("x = up × z", "y", "z"))
    p = unit(add(right, direction, -dot(right, direction)))
    d.line([point, add(point, p, 0.85)], BLACK, 1.4, "4 3")
    end = d.at(add(point, p, 0.85))
    d.text((end[0] + 4, end[1] + 16), "p")
    d.text((310, 312), "A pixel's frame. p is the image's right projected across the ray; from x to p is ψ.", size=13)
    return d


def environment():
    d = Drawing(760, 300)
    d.look((170, 150), 105, (0.5, 0.45, 1.0))
    d.sphere()
    t, azimuth = 0.9, 0.55  # angle from +y; azimuth from -z to +x
    w = (math.sin(t) * math.sin(azimuth * math.pi), math.cos(t), -math.sin(t) * math.cos(azimuth * math.pi))
    d.arrow(w, scaled(w, 0.12), AMBER, width=2.5)
    d.dot((0, 0, 0))
    d.text((170, 172), "centre", size=13)
    d.axes(w, frame(scaled(w, -1), (math.cos(azimuth * math.pi), 0, math.sin(azimuth * math.pi))), 0.5, ("x", "y", ""))
    for axis, name in ((X, "+x"), (Y, "+y"), (Z, "+z")):
        d.arrow(scaled(axis, 1.0), scaled(axis, 1.25), GREY, name)
    left, top, width, height = 370, 75, 360, 150
    d.look((left, top + height), 1)
    d.line([(0, 0), (width, 0), (width, height), (0, height), (0, 0)], GREY, fill="#f4f6f7")
    for u, name in ((0, "−z"), (0.25, "+x"), (0.5, "+z"), (0.75, "−x")):
        d.line([(u * width, 0), (u * width, height)], GREY, 1, "3 3")
        d.text((left + u * width, top + height + 20), f"{name}", size=13)
    d.text((left + width / 2, top - 34), "the image: u to the right, v down")
    d.text((left + width / 2, top - 10), "top row: +y", size=13)
    d.text((left + width / 2, top + height + 42), "bottom row: −y; u = atan2(x, −z) / 2π", size=13)
    place = (azimuth / 2 * width, (1 - t / math.pi) * height, 0)
    d.dot(place, AMBER)
    d.axes(place, (X, Y, Z), 42, ("x", "y", ""))
    return d


def light():
    d = Drawing(760, 260)
    d.look((100, 140), 70, (-0.9, 0.45, 0.8))
    d.line([(0.45 * math.cos(i * math.pi / 20), 0.45 * math.sin(i * math.pi / 20), 0) for i in range(41)], BLACK, 1.6, fill="#fcf3cf")
    d.arrow((0, 0, 0), (0, 0, 2.0), AMBER, "light, along +z")
    d.arrow((0, 0, 0), Y, GREY, "+y")
    d.arrow((0, 0, 0), X, RED, "axis")
    d.text((140, 26), "a light in its own axes")
    d.text((540, 26), "what a viewer sees who looks into the light")
    d.look((480, 190), 110)
    d.arrow((0, 0, 0), X, RED, "x")
    d.text((490, 240), "x is the part of the axis across z", size=13)
    d.arrow((0, 0, 0), Y, GREEN, "y")
    d.arrow((0, 0, 0.0), (0, 0, 1), BLUE, "z")
    e = (math.cos(0.8), math.sin(0.8), 0)
    d.arrow((0, 0, 0), e, AMBER, "E")
    d.arc((0, 0, 0), scaled(X, 0.45), scaled(Y, 0.45), math.degrees(0.8), BLACK, "AoLP")
    return d


def element():
    d = Drawing(760, 250)
    for column, (title, turned) in enumerate((("polarizer: absorbs along (sin θ, cos θ)", 25), ("retarder: fast axis (cos θ, sin θ)", 25))):
        d.look((170 + 390 * column, 145), 75, (0.65, 0.4, 1.0))
        d.text((190 + 380 * column, 26), title)
        d.line([(s, t, 0) for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1))], GREY, fill="#f4f6f7")
        t = math.radians(turned)
        axis = (math.sin(t), math.cos(t), 0) if column == 0 else (math.cos(t), math.sin(t), 0)
        step = (-axis[1], axis[0], 0)
        if column == 0:
            for k in range(-3, 4):
                place = scaled(step, 0.2 * k)
                d.line([add(place, axis, -0.8), add(place, axis, 0.8)], AMBER, 1.2)
        else:
            d.line([scaled(axis, -0.9), scaled(axis, 0.9)], AMBER, 2.5)
        d.axes((0, 0, 0), (X, Y, Z), 1.25)
    return d


def cube():
    d = Drawing(560, 420)
    faces = {(1, 0): ("Up", "+z"), (0, 1): ("Left", "−x"), (1, 1): ("Front", "+y"), (2, 1): ("Right", "+x"), (3, 1): ("Back", "−y"), (1, 2): ("Down", "−z")}
    side = 118
    for (column, row), (name, axis) in faces.items():
        left, top = 44 + side * column, 24 + side * row
        d.look((left, top + side), 1)
        d.line([(0, 0), (side, 0), (side, side), (0, side), (0, 0)], GREY, fill="#f4f6f7")
        d.text((left + side / 2, top + 26), f"{name}, {axis}", size=13)
        d.axes((34, 26, 0), (X, Y, Z), 40, ("x", "y", ""))
    d.text((280, 406), "Directions that light comes from. x is the image's right, as far as it is across the ray.", size=12)
    return d


def sphere_view(d, middle, scale):
    """Looks at a sphere whose z is up."""
    d.look(middle, scale, (0.35, 0.9, 0.45), up=Z)


def coefficients():
    d = Drawing(560, 330)
    sphere_view(d, (190, 165), 115)
    circle = [math.radians(5 * i) for i in range(73)]
    d.line([add(scaled(d.right, math.cos(t)), d.up, math.sin(t)) for t in circle], GREY)
    d.great_circle(Z, X, GREY)
    theta, phi = 0.85, 0.55
    r = (math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), math.cos(theta))
    d.great_circle(cross(Z, r), Z, GREY)
    along = (math.cos(theta) * math.cos(phi), math.cos(theta) * math.sin(phi), -math.sin(theta))
    d.arrow((0, 0, 0), scaled(Z, 1.3), GREY, "z")
    d.arrow((0, 0, 0), scaled(X, 1.3), GREY, "x")
    d.line([(0, 0, 0), r], AMBER, 2.5)
    d.axes(r, frame(r, along), 0.6, ("θ̂ = x", "φ̂ = y", "r̂ = z"))
    d.arc((0, 0, 0), scaled(Z, 0.45), scaled(unit((r[0], r[1], 0)), 0.45), math.degrees(theta), BLACK, "θ")
    for line, words in enumerate(("r̂ is the direction in", "which the light travels:", "light from straight above", "is at θ = π.", "At the poles φ = 0.")):
        d.text((345, 120 + 24 * line), words, anchor="start", size=14)
    return d


def mueller():
    d = Drawing(620, 310)
    d.look((290, 225), 120, (0.3, 0.5, 1.0))
    d.line([(s * 1.35, 0, t * 0.8) for s, t in ((1, 1), (-1, 1), (-1, -1), (1, -1), (1, 1))], GREY, fill="#eaeded")
    to_light, to_viewer = unit((-1.0, 1.0, 0.0)), unit((1.0, 0.75, 0.0))
    s = unit(cross(to_light, to_viewer))
    d.arrow((0, 0, 0), (0, 1.25, 0), GREY, "normal")
    d.arrow(scaled(to_light, 1.7), scaled(to_light, 0.08), AMBER, width=2.5)
    d.arrow(scaled(to_viewer, 0.08), scaled(to_viewer, 1.75), AMBER, width=2.5)
    for place, z in ((scaled(to_light, 1.15), scaled(to_light, -1)), (scaled(to_viewer, 0.95), to_viewer)):
        d.axes(place, frame(z, s), 0.55, ("x = s", "y", "z"))
    d.text((310, 296), "s = direction to the light × direction to the viewer, the x of both frames", size=13)
    return d


def kernel():
    d = Drawing(560, 310)
    sphere_view(d, (200, 160), 115)
    circle = [math.radians(5 * i) for i in range(73)]
    d.line([add(scaled(d.right, math.cos(t)), d.up, math.sin(t)) for t in circle], GREY)
    start, end = unit((0.75, 0.55, 0.1)), unit((-0.4, 0.55, 0.75))
    d.great_circle(cross(start, end), start, GREY)
    for place, name in ((start, "input"), (end, "output")):
        tangent = cross(unit(cross(start, end)), place)
        d.axes(place, frame(place, tangent), 0.5, ("x", "y", "z"))
        x, y = d.at(place)
        d.dot(place, AMBER)
        d.text((x + 4, y + 20), name, anchor="start", size=13)
    for line, words in enumerate(("x points along the great", "circle, from the input to", "the output, at both ends.")):
        d.text((370, 140 + 24 * line), words, anchor="start", size=14)
    return d


DRAWINGS = (spaces, stokes, pixel, environment, light, element, cube, coefficients, mueller, kernel)


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), "drawings")
    os.makedirs(folder, exist_ok=True)
    for draw in DRAWINGS:
        draw().save(os.path.join(folder, draw.__name__ + ".svg"))


if __name__ == "__main__":
    main()
