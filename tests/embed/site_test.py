# SPDX-License-Identifier: MIT
"""The documentation site builds without warnings, its links end somewhere, and its programs run.

usage: site_test.py CMAKE BUILD_TREE SOURCE_TREE CXX_COMPILER
"""

import html.parser
import os
import re
import subprocess
import sys
import tempfile
import unittest
import urllib.parse

CMAKE, BUILD, SOURCE, COMPILER = sys.argv[1:5]
del sys.argv[1:]
SITE = os.path.join(BUILD, "site")
PAGES = os.path.join(SOURCE, "samples", "site")


class Page(html.parser.HTMLParser):
    def __init__(self, path):
        super().__init__()
        self.links, self.names = [], set()
        with open(path, encoding="utf-8") as file:
            self.feed(file.read())

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("href", "src") and value:
                self.links.append(value)
            if name in ("id", "name") and value:
                self.names.add(value)


class SiteTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        built = subprocess.run([CMAKE, "--build", BUILD, "--target", "site"], capture_output=True, text=True)
        if built.returncode:
            raise AssertionError(built.stdout[-4000:] + built.stderr[-4000:])

    def test_links(self):
        pages, broken = {}, []

        def page(path):
            if path not in pages:
                pages[path] = Page(path)
            return pages[path]

        count = 0
        for folder, folders, files in os.walk(SITE):
            if folder == SITE:
                folders.remove("c")  # Doxygen's pages, whose own links it checks
            for name in (name for name in files if name.endswith(".html")):
                path = os.path.join(folder, name)
                for link in page(path).links:
                    scheme, _, target, _, anchor = urllib.parse.urlsplit(link)
                    if scheme:
                        continue
                    count += 1
                    end = os.path.normpath(os.path.join(folder, urllib.parse.unquote(target))) if target else path
                    if not os.path.exists(end):
                        broken.append(f"{path}: {link}: no such file")
                    elif anchor and end.endswith(".html") and urllib.parse.unquote(anchor) not in page(end).names:
                        broken.append(f"{path}: {link}: no such place")
        self.assertEqual(broken, [])
        self.assertGreater(count, 1000)

    def test_parts(self):
        for path in ("index.html", "c/index.html", "samples/render/README.html", "samples/site/theory.html", "capi/reference/conventions.html"):
            self.assertTrue(os.path.exists(os.path.join(SITE, path)), path)
        pictures = [link for link in Page(os.path.join(SITE, "c", "index.html")).links if link.endswith((".svg", ".png"))]
        self.assertGreater(len(pictures), 10)
        for link in pictures:
            self.assertTrue(os.path.exists(os.path.join(SITE, "c", link)), link)
        with open(os.path.join(SITE, "samples/site/python.html"), encoding="utf-8") as file:
            self.assertIn('id="nicol.RenderOptions"', file.read())

    def test_start_pages_fit_a_screen(self):
        for name in os.listdir(os.path.join(PAGES, "start")):
            with open(os.path.join(PAGES, "start", name), encoding="utf-8") as file:
                self.assertLess(len(file.readlines()), 50, name)

    def test_drawings_are_those_of_the_script(self):
        reference = os.path.join(SOURCE, "capi", "reference")
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, os.path.join(reference, "drawings.py"), folder], check=True)
            kept = os.path.join(reference, "drawings")
            self.assertEqual(sorted(os.listdir(folder)), sorted(os.listdir(kept)))
            for name in os.listdir(folder):
                with open(os.path.join(folder, name)) as made, open(os.path.join(kept, name)) as there:
                    self.assertEqual(made.read(), there.read(), name)

    def test_programs_run(self):
        with open(os.path.join(PAGES, "guide", "real_time.md"), encoding="utf-8") as file:
            frames = re.search(r"^```python\n(.*?)^```$", file.read(), re.MULTILINE | re.DOTALL).group(1)
        environment = {**os.environ, "PYTHONPATH": os.path.join(SOURCE, "samples", "python")}
        run = lambda *command: subprocess.run(command, cwd=folder, env=environment, check=True)  # noqa: E731
        with tempfile.TemporaryDirectory() as folder:
            os.symlink(os.path.join(SOURCE, "samples"), os.path.join(folder, "samples"))
            library = os.path.join(BUILD, "lib")
            program = os.path.join(folder, "first_cpp")
            run(COMPILER, "-std=c++20", f"-I{SOURCE}/include", os.path.join(PAGES, "start", "first.cpp"), "-o", program,
                f"-L{library}", "-lnicol", f"-Wl,-rpath,{library}")  # fmt: skip
            run(program)
            self.assertGreater(os.path.getsize(os.path.join(folder, "first_cpp.exr")), 100000)
            run("/usr/bin/python3", "-c", frames.replace("range(100)", "range(2)"))


if __name__ == "__main__":
    unittest.main()
