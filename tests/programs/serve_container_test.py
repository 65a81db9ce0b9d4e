# SPDX-License-Identifier: MIT
"""Checks what samples/serve/Containerfile names: packages, files, components and options. No builder is needed.

usage: serve_container_test.py NICOL_SERVE CONTAINERFILE CPACK_CONFIG CMAKE
"""

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile


def instructions(text):
    """Returns the pairs of keyword and rest, with continued lines joined and comments left out."""
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    joined = re.sub(r"\\\n\s*", "", "\n".join(lines))
    return [tuple(line.split(None, 1)) for line in joined.splitlines() if line.strip()]


def rests(parts, keyword):
    return [rest for name, rest in parts if name == keyword]


def installed_packages(parts):
    """Returns the names that apt-get installs; paths are packages of the build stage."""
    words = [
        word
        for rest in rests(parts, "RUN")
        for call in re.findall(r"apt-get install ([^&]*)", rest)
        for word in call.split()
    ]
    return [word for word in words if not word.startswith(("-", "/"))]


def check_build_stage(root, parts, cpack_config):
    for rest in rests(parts, "COPY"):
        for source in rest.split()[:-1]:
            assert os.path.exists(os.path.join(root, source)), f"COPY names {source}"
    with open(cpack_config, encoding="utf-8") as file:
        known = re.search(r'CPACK_COMPONENTS_ALL "([^"]*)"', file.read()).group(1).split(";")
    wanted = re.search(r"CPACK_COMPONENTS_ALL=([^\"]*)\"", " ".join(rests(parts, "RUN"))).group(1).split(";")
    assert set(wanted) <= set(known), f"components {wanted} of {known}"


def check_program(parts, program, cpack_config, cmake):
    entry, defaults = (json.loads(rests(parts, keyword)[-1]) for keyword in ("ENTRYPOINT", "CMD"))
    with tempfile.TemporaryDirectory() as folder:
        install = [cmake, "--install", os.path.dirname(cpack_config), "--component", "serve", "--prefix", folder + "/usr"]
        subprocess.run(install, check=True, stdout=subprocess.DEVNULL)
        assert os.access(folder + entry[0], os.X_OK), f"ENTRYPOINT names {entry[0]}"
    text = subprocess.run([program, "--help"], check=True, capture_output=True, text=True).stdout
    for option in [word for word in entry + defaults if word.startswith("--")]:
        assert re.search(rf"^ +{option} ", text, re.M), f"{option} is no option of nicol-serve"
    port = entry[entry.index("--listen") + 1].split(":")[1]
    assert rests(parts, "EXPOSE") == [port], f"EXPOSE is not --listen's port {port}"
    (health,) = rests(parts, "HEALTHCHECK")
    assert f"http://127.0.0.1:{port}/ready" in health
    assert "curl" in installed_packages(parts)


def main():
    program, containerfile, cpack_config, cmake = sys.argv[1:]
    with open(containerfile, encoding="utf-8") as file:
        text = file.read()
    parts = instructions(text)
    assert "build --format docker " in text, "HEALTHCHECK is ignored in the default format"
    root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(containerfile))))
    check_build_stage(root, parts, cpack_config)
    check_program(parts, program, cpack_config, cmake)
    assert rests(parts, "USER"), "the service would run as root"
    if shutil.which("apt-cache") is None:
        return
    for package in installed_packages(parts):
        known = subprocess.run(["apt-cache", "show", package], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
        assert known.returncode == 0, f"there is no package {package}"


main()
