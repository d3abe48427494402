"""Every function of the header is called by a fuzz target, or has a reason here why not: fuzzed.py SOURCE."""

from __future__ import annotations

import pathlib
import re
import sys

# function: reason
LEFT_OUT: dict[str, str] = {
    "bempd_set_sparse_solver": "the library trusts the host's solver with numbers; capi.sparse_solver tests its errors",
}

DECLARED = re.compile(r"BEMPD_API[\w\s*]*?\b(bempd_\w+)\(")
# Calls stand by themselves, or as the first argument of FUZZ_CALL; comments and strings do not count.
CALLED = re.compile(r"(?:FUZZ_CALL\(\s*(bempd_\w+)\s*,|\b(bempd_\w+)\()")
SILENT = re.compile(r"//[^\n]*|\"(?:\\.|[^\"\\\n])*\"")


def main() -> int:
    source = pathlib.Path(sys.argv[1])
    declared = set(DECLARED.findall((source / "include/bempd.h").read_text(encoding="utf-8")))
    called: set[str] = set()
    for file in (source / "tests/fuzz").glob("*.?pp"):
        for names in CALLED.findall(SILENT.sub("", file.read_text(encoding="utf-8"))):
            called |= {name for name in names if name}
    missing = sorted(declared - called - LEFT_OUT.keys())
    needless = sorted(name for name in LEFT_OUT if name not in declared or name in called)
    for name in missing:
        print(f"{name} is called by no fuzz target; let one of tests/fuzz do it, or say in {sys.argv[0]} why none does")
    for name in needless:
        print(f"{name} has a reason to be left out, and is called or not there")
    print(f"{len(declared)} functions, {len(declared & called)} of them called, {len(LEFT_OUT)} left out")
    return 1 if missing or needless or not declared else 0


if __name__ == "__main__":
    sys.exit(main())
