# SPDX-License-Identifier: MIT
"""nicol-host: inside an application the image follows Malus' law, and what the application draws stays as it is."""

import array
import math
import os
import shutil
import subprocess
import sys
import unittest

from program_test import ProgramTest

WIDTH, HEIGHT = 640, 360
LEFT, TOP, SIZE = 352, 52, 256  # position and size of the quad while it faces the viewer, in pixels

# Leak checks are off in sanitized builds, because libraries that SDL opens leak and are closed before they can be
# named.
os.environ.setdefault("ASAN_OPTIONS", "detect_leaks=0")


def srgb(value):
    value = min(max(value, 0.0), 1.0)
    return 12.92 * value if value <= 0.0031308 else 1.055 * value ** (1 / 2.4) - 0.055


def pixel(image, x, y):
    at = 3 * (y * WIDTH + x)
    return image[at : at + 3]


def without_quad(image):
    """Returns the image without the quad, which only the application draws."""
    rows = [bytearray(image[3 * WIDTH * y : 3 * WIDTH * (y + 1)]) for y in range(HEIGHT)]
    for row in rows[TOP : TOP + SIZE]:
        row[3 * LEFT : 3 * (LEFT + SIZE)] = bytes(3 * SIZE)
    return b"".join(rows)


def left_part(image):
    """Returns the part with the triangles. A rotated quad is larger on its near side but does not reach this part."""
    return b"".join(image[3 * WIDTH * y : 3 * (WIDTH * y + LEFT - 10)] for y in range(HEIGHT))


class HostTest(ProgramTest):
    @classmethod
    def setUpClass(cls):
        told, tell = os.pipe()
        cls.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(tell), "-screen", "0", "800x600x24", "-nolisten", "tcp"],
            pass_fds=[tell],
            stderr=subprocess.DEVNULL,
        )
        os.close(tell)
        with os.fdopen(told) as file:
            cls.display = ":" + file.readline().strip()  # printed once Xvfb listens

    @classmethod
    def tearDownClass(cls):
        cls.server.terminate()
        cls.server.wait()

    def run_program(self, *arguments, **environment):
        software = {"DISPLAY": self.display, "LIBGL_ALWAYS_SOFTWARE": "1", "SDL_VIDEODRIVER": "x11"}
        return super().run_program(*arguments, **software, **environment)

    def screenshot(self, *arguments):
        path = self.path("shot.ppm")
        self.assert_succeeds("--screenshot", path, *arguments)
        with open(path, "rb") as file:
            magic, size, most, pixels = file.read().split(b"\n", 3)
        self.assertEqual((magic, size, most), (b"P6", b"%d %d" % (WIDTH, HEIGHT), b"255"))
        self.assertEqual(len(pixels), 3 * WIDTH * HEIGHT)
        return pixels

    def test_the_quad_follows_malus_law_and_the_rest_stays(self):
        alone = self.screenshot("--frames", "1", "--without-nicol")
        self.assertEqual(len(set(alone[i : i + 3] for i in range(0, len(alone), 3))) > 1000, True)
        shown = []
        for angle in (0, 30, 90, -45):
            image = self.screenshot("--frames", "1", "--polarizer", str(angle), "--planes", self.path("planes"))
            self.assertEqual(without_quad(image), without_quad(alone))
            with open(self.path("planes"), "rb") as file:
                stokes = array.array("f", file.read())
            self.assertEqual(len(stokes), 3 * SIZE * SIZE * 4)
            c, s = math.cos(math.radians(2 * angle)), math.sin(math.radians(2 * angle))
            worst = 0
            for y in range(SIZE):
                for x in range(SIZE):
                    codes = pixel(image, LEFT + x, TOP + y)
                    for channel in range(3):
                        at = 4 * ((channel * SIZE + y) * SIZE + x)
                        passed = 0.5 * (stokes[at] + c * stokes[at + 1] + s * stokes[at + 2])
                        worst = max(worst, abs(codes[channel] - 255 * srgb(passed)))
            self.assertLess(worst, 0.6, f"codes off at {angle} degrees")
            shown.append(image)
        # Unpolarized light would satisfy the law even if the polarizer had no effect.
        darkest, brightest = (pixel(shown[i], LEFT + 200, TOP + 20)[0] for i in (0, 2))
        self.assertGreater(abs(brightest - darkest), 20)

    def test_the_quad_spins_and_the_application_goes_on(self):
        alone = self.screenshot("--frames", "16", "--without-nicol")
        spun = self.screenshot("--frames", "16")
        self.assertEqual(left_part(spun), left_part(alone))
        middle = TOP + SIZE // 2
        self.assertEqual(pixel(spun, LEFT + 4, middle), pixel(alone, LEFT + 4, middle))
        self.assertNotEqual(pixel(spun, LEFT + SIZE // 2, middle), pixel(alone, LEFT + SIZE // 2, middle))

    def test_the_ball_hides_the_backs_of_the_rings_and_their_fronts_hide_it(self):
        ball = self.screenshot("--frames", "1")
        rings = self.screenshot("--frames", "1", "--rings")
        middle = LEFT + SIZE // 2
        column = [pixel(rings, middle, y) != pixel(ball, middle, y) for y in range(TOP, TOP + SIZE)]
        fronts = [y for y in range(1, SIZE) if column[y] and not column[y - 1]]
        self.assertEqual(len(fronts), 2, "the column through the ball shows the front of each ring, and no back")
        gold, blue = (pixel(rings, middle, TOP + y + 3) for y in fronts)
        self.assertGreater(gold[0], gold[2])  # drawn before the ball
        self.assertGreater(blue[2], blue[0])  # drawn after it

    def test_an_image_that_does_not_move_gets_more_samples(self):
        shots = {}
        for frames in (3, 4, 9, 10):
            shots[frames] = self.screenshot("--frames", str(frames), "--pause", "3")
        self.assertEqual(left_part(shots[3]), left_part(shots[10]))
        self.assertNotEqual(shots[3], shots[4])
        self.assertNotEqual(shots[4], shots[9])
        self.assertEqual(shots[9], shots[10])  # 64 samples since frame 9

    def test_wrong_options_are_refused(self):
        table = (
            (["--fraems"], "--fraems 3"),
            (["--frames"], "--screenshot shot.ppm"),
            (["--frames"], "--frames 0"),
            (["--pause"], "--pause 1.5"),
            (["--polarizer", "up"], "--frames 1 --polarizer up"),
            (["--rings", "--without-nicol"], "--rings --without-nicol"),
            (["shot.ppm"], "--frames 1 --screenshot nowhere/shot.ppm"),
        )
        self.assert_each_fails(table)
        self.assertIn("--polarizer", self.assert_succeeds("--help").stdout)


if __name__ == "__main__":
    if shutil.which("Xvfb") is None:
        print("skipped: Xvfb is absent (Debian: xvfb)")
        sys.exit(77)
    unittest.main()
