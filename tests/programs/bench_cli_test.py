# SPDX-License-Identifier: MIT
"""nicol-bench: every sub-command runs on a small scene; errors fall with the order, and factored beats dense."""
import csv
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

BENCH = sys.argv[1]

# The scene is a ball over a floor under a sky, which has both shadows and polarization.
SCENE = """<scene version="3.0.0">
  <sensor type="perspective"><float name="fov" value="40"/>
    <transform name="to_world"><lookat origin="0,2,6" target="0,0,0" up="0,1,0"/></transform>
    <film type="hdrfilm"><integer name="width" value="64"/><integer name="height" value="64"/></film></sensor>
  <emitter type="sky"><vector name="sun_direction" x="0.6" y="0.5" z="0.6"/>
    <float name="turbidity" value="3"/></emitter>
  <shape type="obj"><string name="filename" value="ball.obj"/>
    <bsdf type="pplastic"><float name="alpha" value="0.2"/></bsdf></shape>
  <shape type="obj"><string name="filename" value="floor.obj"/>
    <bsdf type="pplastic"><float name="alpha" value="0.4"/></bsdf></shape>
</scene>
"""


def grid_obj(rows, columns, place):
    """Returns an OBJ mesh of rows x columns vertices at place(v, u), with v and u from 0 to 1."""
    lines = ["v %g %g %g" % place(r / (rows - 1), c / (columns - 1)) for r in range(rows) for c in range(columns)]
    for r in range(rows - 1):
        for c in range(columns - 1):
            a = r * columns + c + 1
            lines += [f"f {a} {a + columns} {a + columns + 1}", f"f {a} {a + columns + 1} {a + 1}"]
    return "\n".join(lines) + "\n"


def ball(v, u):
    # Seams and poles stay slightly open, so that every triangle has an area.
    theta, phi = math.pi * (0.01 + 0.98 * v), 2 * math.pi * u
    return math.sin(theta) * math.cos(phi), math.cos(theta), -math.sin(theta) * math.sin(phi)


def floor(v, u):
    return 4 * u - 2, -1, 4 * v - 2


def run(*arguments, code=0):
    done = subprocess.run([BENCH, *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode == code, (arguments, done.returncode, done.stdout, done.stderr)
    return done.stdout if code == 0 else done.stderr


def table(folder, command, *arguments):
    """Returns the rows by name, and checks that CSV and JSON agree."""
    written = folder / f"{command}.json", folder / f"{command}.csv"
    printed = run(command, *arguments, "--json", written[0], "--csv", written[1])
    rows = json.loads(written[0].read_text())
    name = next(iter(rows[0]))
    with written[1].open(newline="") as file:
        assert [row[0] for row in csv.reader(file)][1:] == [row[name] for row in rows], command
    assert all(row[name] in printed for row in rows), command
    return {row.pop(name): row for row in rows}


def check_error(folder, scene):
    rows = table(folder, "error", scene, "--size", 32, "--samples", 256, "--orders", "2-5",
                 "--cache", folder / "cache")
    for suffix in ("", ", no shadows"):
        for component in ("s0", "s1", "s2"):
            errors = {name: row[component] for name, row in rows.items()}
            for order in (2, 3, 4, 5):
                factored, dense = (errors[f"{m} {order}{suffix}"] for m in ("factored", "dense"))
                assert factored <= dense, (suffix, component, order, factored, dense)
            low, high = (errors[f"factored {order}{suffix}"] for order in (2, 5))
            assert high < low, (suffix, component, low, high)
            assert high < 0.1, (suffix, component, high)
    assert rows["factored 2 + split to 32"]["s0"] < rows["factored 2"]["s0"]
    for name, row in rows.items():
        if name.startswith(("factored", "dense")):
            assert row["s0, 95 %"] <= row["s0, 99 %"] <= row["s0, largest"], (name, row)
            assert row["s0, largest"] > row["s0"], (name, row)
            assert 0 < row["AoLP, degrees"] < 45 and 0 < row["DoLP, by light"] < 1, (name, row)
    for suffix in ("", ", no shadows"):
        noise, estimate = (rows[name + suffix]["s0"] for name in ("reference, its noise", "reference, its noise by its variance"))
        assert 0 < 0.8 * noise < estimate < 2 * noise, (suffix, noise, estimate)


def check_converged(folder, scene):
    """Only truncation error is left without the reference's noise and with equal vertices. It falls with every order."""
    rows = table(folder, "error", scene, "--size", 32, "--samples", 4, "--orders", "2-4", "--converged", 8,
                 "--memory", 0, "--cache", folder / "cache")
    for suffix in ("", ", no shadows"):
        for component in ("cut s0", "cut s1", "cut s2"):
            cut = [rows[f"factored {order}{suffix}"][component] for order in (2, 3, 4)]
            assert all(b < a for a, b in zip(cut, cut[1:])), (suffix, component, cut)


def check_materials(folder, scene):
    os.environ.pop("NICOL_TEST_DATA", None)
    rows = table(folder, "materials", "--size", 12, "--samples", 256, "--orders", "2-9", "--cache", folder / "cache")
    assert len(rows) == 4 * 6, list(rows)
    # Rough metal is all highlight, so each added part of the light brings the image closer.
    gold = {name[16:]: row["s1"] for name, row in rows.items() if name.startswith("rough gold 0.2: ")}
    assert gold["0..2 + split to 9"] < gold["0..2 + convolution to 9"], gold
    assert gold["0..9"] < gold["0..3"] < gold["0..2"], gold


def check_coarse(folder, scene):
    rows = table(folder, "coarse", "--size", 24, "--samples", 16, "--orders", "3-9", "--cache", folder / "cache")
    for component in ("s0", "s2"):
        at = {where: rows[f"lamps, 1440 vertices, shaded at {where}"][component] for where in ("vertices", "pixels")}
        assert at["pixels"] < 0.75 * at["vertices"], (component, at)


def check_pareto(folder, scene):
    plot = folder / "plot.svg"
    rows = table(folder, "pareto", scene, "--size", 48, "--samples", 16, "--orders", "2-3", "--seconds", 0.001,
                 "--plot", plot, "--cache", folder / "cache")
    assert set(rows) == {f"{method} {order}{high}" for order in (2, 3)
                         for method, high in (("factored", ""), ("factored", " + split to 32"), ("dense", ""),
                                              ("dense", " + convolution to 9"))}, rows
    for row in rows.values():
        assert row["light rotating ms"] > 0 and row["camera only ms"] > 0, row
    drawing = xml.etree.ElementTree.parse(plot).getroot()
    points = [e for e in drawing.iter() if e.tag.endswith("circle")]
    assert len(points) == 6 * len(rows), len(points)
    for order in (2, 3):
        assert rows[f"dense {order}"]["MB"] > rows[f"factored {order}"]["MB"] > 0, rows
        assert rows[f"dense {order}"]["before the first ms"] > 0, rows
    peer = folder / "peer.csv"
    peer.write_text("another program\n4,100,0.1,0.02,0.02\n16,400,0.05,0.01,0.01\n")
    run("pareto", scene, "--size", 16, "--samples", 4, "--orders", "2-2", "--seconds", 0.001, "--plot", plot, "--peer", peer,
        "--cache", folder / "cache")
    drawing = xml.etree.ElementTree.parse(plot).getroot()
    assert sum(e.tag.endswith("circle") for e in drawing.iter()) == 4 + 2
    assert "another program" in plot.read_text()
    peer.write_text("another program\n4,100\n")
    assert "label,ms,s0,s1,s2" in run("pareto", scene, "--size", 16, "--samples", 4, "--orders", "1-1", "--seconds", 0.001,
                                      "--plot", plot, "--peer", peer, "--cache", folder / "cache", code=2)


def check_price(folder, scene):
    rows = table(folder, "price", scene, "--size", 32, "--seconds", 0.001, "--orders", "3-3", "--cache", folder / "cache")
    alone, surfaces, light = (rows[f"order 3, {name}"] for name in ("s0 alone", "polarized by surfaces", "polarized light"))
    assert alone["over s0"] == 1 and light["MB over s0"] > surfaces["MB over s0"] >= 1, rows


def check_budget(folder, scene):
    rows = table(folder, "budget", "--size", 16, "--only", "sun, 33", "--cache", folder / "cache")
    assert list(rows) == ["snail_sun, 33"] and all(0 <= row["frames within 1.2 times, %"] <= 100 for row in rows.values()), rows
    assert all(row["pixel samples"] >= 1 and row["order_low"] > 0 for row in rows.values()), rows


def check_times(folder, scene):
    rows = table(folder, "frame", scene, "--size", 32, "--seconds", 0.001, "--orders", "2-3",
                 "--cache", folder / "cache")
    assert rows["floor: one colour"]["ratio to floor"] == 1, rows
    full = rows["factored 2, polarized sky on plastic: light"]
    plain = rows["factored 2, unpolarized sky on diffuse surfaces: light"]
    assert full["kept MB"] > plain["kept MB"] > 0 and plain["relight ms"] > 0, rows
    assert "dense 2: camera" in rows and rows["factored 2: light"]["relight ms"] > 0, rows
    assert rows["dense 2: camera"]["kept MB"] > rows["factored 2: camera"]["kept MB"] > 0, rows

    pictures = table(folder, "dataset", scene, "--size", 16)
    assert len(pictures) == 6 and all(row["a minute"] > 0 and row["processor ms"] > 0 for row in pictures.values()), pictures

    gradients = table(folder, "adjoint", scene, "--size", 16)
    assert list(gradients) == ["2", "4", "6", "9"], gradients
    assert all(row["gradient / picture"] > 0 for row in gradients.values()), gradients

    bakes = table(folder, "bake", scene)
    assert list(bakes) == ["512", "2048", "8192"], bakes
    for row in bakes.values():
        assert 0 < row["unoccluded"] < row["vertices"] and row["million rays/s"] > 0, row

    scale = table(folder, "scale", "--size", 32, "--seconds", 0.001, "--orders", "2-4")
    assert len(scale) == 5 and all(row["relight ms"] > 0 for row in scale.values()), scale

    start = table(folder, "start", scene, "--size", 32, "--only", "cache folder")
    assert list(start) == ["empty cache folder", "warm cache folder"] and all(row["whole"] > 0 for row in start.values())
    assert list(table(folder, "start", "--only", "gold")) == ["rough gold"]


def check_arguments(folder, scene):
    assert "error" in run("--help")
    for command in ("error", "materials", "frame", "pareto", "bake", "scale", "start", "harmonics"):
        help_text = run(command, "--help")
        assert command in help_text and "--csv FILE" in help_text, help_text
    for arguments, word in ((("error", "--size", "4"), "--size"), (("error", "--orders", "5-4"), "--orders"),
                            (("error", "--converged", "33"), "--converged"),
                            (("bake", "--large"), "--large"), (("scale", scene), "scene.xml"),
                            (("frame", "--seconds"), "--seconds"), (("start", "--backend", "metal"), "--backend"),
                            (("bake", folder / "absent.xml"), "absent.xml"),
                            (("start", folder / "absent.xml"), "absent.xml")):
        message = run(*arguments, code=2)
        assert word in message and message.count("\n") == 1, message
    assert "usage" in run(code=2) and "usage" in run("bogus", code=2)
    assert "cannot be written" in run("frame", scene, "--size", "8", "--seconds", "0.001", "--orders", "1-1",
                                      "--cache", folder / "cache", "--csv", folder / "no" / "x", code=2)


with tempfile.TemporaryDirectory() as name:
    home = pathlib.Path(name)
    small = home / "scene.xml"
    small.write_text(SCENE)
    (home / "ball.obj").write_text(grid_obj(20, 30, ball))
    (home / "floor.obj").write_text(grid_obj(14, 14, floor))
    for check in (check_arguments, check_error, check_converged, check_materials, check_coarse, check_pareto, check_price, check_budget, check_times):
        check(home, small)
