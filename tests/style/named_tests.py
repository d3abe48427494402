"""Every test that a document names exists: named_tests.py SOURCE BUILD DOCUMENT...

A document is a CSV file. Names stand in backticks in its last column: as ctest knows them (`capi.files`), or as googletest does (a suite,
or `Suite.test`)."""

from __future__ import annotations

import csv
import json
import pathlib
import re
import subprocess
import sys

CASE = re.compile(r"^(?:TYPED_)?TEST(?:_F|_P)?\((\w+), (\w+)\)", re.MULTILINE)
NAME = re.compile(r"`([A-Za-z_][\w.]*)`")


def known_tests(source: pathlib.Path, build: pathlib.Path) -> set[str]:
    listed = json.loads(subprocess.run(["ctest", "--show-only=json-v1"], cwd=build, check=True, capture_output=True,
                                       text=True).stdout)
    known = {test["name"] for test in listed["tests"]}
    for file in (source / "tests").rglob("*.cpp"):
        for suite, case in CASE.findall(file.read_text(encoding="utf-8")):
            known |= {suite, f"{suite}.{case}"}
    return known


def named_tests(document: pathlib.Path) -> set[str]:
    names: set[str] = set()
    with open(document, newline="", encoding="utf-8") as file:
        for row in csv.reader(file):
            names |= set(NAME.findall(row[-1]))
    return names


def main() -> int:
    source, build = map(pathlib.Path, sys.argv[1:3])
    known = known_tests(source, build)
    failed = False
    for document in map(pathlib.Path, sys.argv[3:]):
        named = named_tests(document)
        for name in sorted(named - known):
            print(f"{document}: there is no test {name}")
            failed = True
        print(f"{document.name}: {len(named)} tests named")
        failed = failed or not named
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
