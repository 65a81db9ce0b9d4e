# SPDX-License-Identifier: MIT
"""Every promise of capi/reference/promises.md names a test that exists. Usage: promises_test.py [ROOT]"""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
page = (root / "capi/reference/promises.md").read_text(encoding="utf-8")
rows = [line for line in page.splitlines() if line.startswith("| ") and not line.startswith("| promise |")]
missing = [f"no test is named: {row}" for row in rows if "`tests/" not in row]
for name, case in re.findall(r'`(tests/[^`]+)` "([^"]+)"', page):
    file = root / name
    if not file.is_file() or case not in file.read_text(encoding="utf-8"):
        missing.append(f'{name} has no "{case}"')
if not rows:
    missing.append("the page has no promises")
print("\n".join(missing) or f"{len(rows)} promises have their tests")
sys.exit(bool(missing))
