"""The list of functions by topic at the top of bempd.h has every function of the header once, and nothing else.

    header_index.py ROOT
"""

from __future__ import annotations

import pathlib
import re
import sys


def main() -> int:
    text = (pathlib.Path(sys.argv[1]) / "include/bempd.h").read_text(encoding="utf-8")
    index = re.search(r"/\* Functions by topic\.\n(.*?)\*/", text, re.DOTALL)
    listed = re.findall(r"^ \*   (bempd_\w+)", index.group(1), re.MULTILINE) if index else []
    declared = re.findall(r"^BEMPD_API[^;]*?(bempd_\w+)\(", text, re.MULTILINE)
    faults = [f"{name} is not in the list" for name in declared if name not in listed]
    faults += [f"{name} is in the list and not in the header" for name in listed if name not in declared]
    faults += [f"{name} is listed twice" for name in set(listed) if listed.count(name) > 1]
    print("\n".join(faults) or f"{len(declared)} functions by topic")
    return int(bool(faults) or not declared)


if __name__ == "__main__":
    sys.exit(main())
