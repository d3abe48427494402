#!/usr/bin/env python3
"""Writes the raw layer of the Python, Fortran and Rust bindings from include/bempd.h.

    bindings/generate.py            writes the files
    bindings/generate.py --check    fails with the difference when a file is not what would be written

Needs a C compiler, pycparser, bindgen and rustfmt. The written files are part of the source tree, so that building and
using the bindings needs none of these.
"""

import argparse
import difflib
import pathlib
import subprocess
import sys

from generator import fortran_layer, python_layer, rust_layer
from generator.header import Header, Refusal, read_header
from generator.rules import check

ROOT = pathlib.Path(__file__).resolve().parent.parent


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--check", action="store_true", help="write nothing; fail when a file would change")
    parser.add_argument("--header", type=pathlib.Path, default=ROOT / "include/bempd.h", help="another header")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT, help="another root of the written files")
    arguments = parser.parse_args()

    header = _read(arguments.header)
    if header is None:
        return 1
    try:
        outputs = _outputs(header, arguments.header)
    except (FileNotFoundError, subprocess.CalledProcessError) as error:
        print(error, file=sys.stderr)
        return 1
    differs = False
    for path, text in outputs.items():
        target = arguments.output / path
        if arguments.check:
            differs = _differs(target, path, text) or differs
        else:
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text, encoding="utf-8")
    if differs:
        print("run bindings/generate.py and commit what it writes", file=sys.stderr)
    return 1 if differs else 0


def _read(path: pathlib.Path) -> Header | None:
    """The header, or None after saying what is wrong with it."""
    shown = str(path.relative_to(ROOT)) if path.is_relative_to(ROOT) else str(path)
    try:
        header = read_header(str(path), shown)
        refusals = check(header)
    except Refusal as refusal:
        refusals = [refusal]
    for refusal in refusals:
        print(f"{shown}:{refusal.line}: {refusal.sentence}", file=sys.stderr)
    return None if refusals else header


def _outputs(header: Header, path: pathlib.Path) -> dict[str, str]:
    return {
        "bindings/python/bempd/_cdef.py": python_layer.write(header),
        "bindings/fortran/bempd_c.f90": fortran_layer.write(header),
        "bindings/rust/bempd-sys/src/bindings.rs": rust_layer.write(header, str(path)),
    }


def _differs(target: pathlib.Path, path: str, text: str) -> bool:
    """Whether a file is not what would be written; says where."""
    present = target.read_text(encoding="utf-8") if target.exists() else ""
    sys.stderr.writelines(difflib.unified_diff(present.splitlines(keepends=True), text.splitlines(keepends=True), path,
                                               f"{path} from the header"))
    return present != text


if __name__ == "__main__":
    sys.exit(main())
