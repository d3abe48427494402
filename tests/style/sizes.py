"""No source file over 300 lines, no function over 50: what is longer holds more than one idea.

    sizes.py ROOT

Reads the sources under ROOT/src as the formatter leaves them: a function begins on a line that is indented no deeper than a
member of a class in a namespace, and ends at the closing brace with the same indent."""

from __future__ import annotations

import pathlib
import re
import sys

MOST_LINES, MOST_LINES_OF_A_FUNCTION = 300, 50
NOT_A_FUNCTION = re.compile(r"^\s*(namespace|class|struct|enum|union|extern|if|for|while|switch|else|do|try|\}|//|#)")

# What may be longer, and why.
EXCEPTIONS: dict[str, str] = {}


def functions(lines: list[str]) -> list[tuple[int, int]]:
    """First and last line (from 1) of every function."""
    found = []
    start = 0
    while start < len(lines):
        line = lines[start]
        indent = len(line) - len(line.lstrip())
        end = start
        if line.strip() and indent <= 4 and not NOT_A_FUNCTION.match(line) and "(" in line:
            # The declaration may run over several lines.
            opening = start
            while opening < len(lines) and not lines[opening].rstrip().endswith(("{", ";", "}")):
                opening += 1
            if opening < len(lines) and lines[opening].rstrip().endswith("{") and "= {" not in lines[opening]:
                end = next((k for k in range(opening + 1, len(lines)) if re.match(rf"^ {{{indent}}}\}}", lines[k])), opening)
                found.append((start + 1, end + 1))
        start = end + 1
    return found


def main() -> int:
    root = pathlib.Path(sys.argv[1])
    complaints = []
    for path in sorted(p for ending in ("*.cpp", "*.hpp") for p in (root / "src").rglob(ending)):
        name = path.relative_to(root).as_posix()
        lines = path.read_text().splitlines()
        if len(lines) > MOST_LINES and name not in EXCEPTIONS:
            complaints.append(f"{name}: {len(lines)} lines")
        for first, last in functions(lines):
            if last - first + 1 > MOST_LINES_OF_A_FUNCTION and f"{name}:{lines[first - 1].strip()}" not in EXCEPTIONS:
                complaints.append(f"{name}:{first}: {last - first + 1} lines in '{lines[first - 1].strip()}'")
    print("\n".join(complaints) or "no file and no function is too long")
    return 1 if complaints else 0


sys.exit(main())
