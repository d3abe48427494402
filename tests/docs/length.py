"""Length of what the project says of itself: words of README.md and of every page under docs, research notes too, as `wc -w`
counts them, with programs, numbers and tables. What a program writes is left out: the page of options, and tables between
<!-- name --> and <!-- end -->, which benchmarks measure. Prints the words of each page; fails above the bounds.

    length.py ROOT [--quiet]
"""

from __future__ import annotations

import pathlib
import re
import sys

MOST_WORDS = 26870
MOST_README_BYTES = 7000
WRITTEN_BY_THE_LIBRARY = "docs/options.md"
MEASURED = re.compile(r"<!-- (?!end)[^>]*-->\n\|.*?<!-- end[^>]*-->", re.DOTALL)


def main() -> int:
    root, quiet = pathlib.Path(sys.argv[1]).resolve(), "--quiet" in sys.argv
    pages = [root / "README.md", *sorted((root / "docs").rglob("*.md"))]
    texts = {str(page.relative_to(root)): page.read_text(encoding="utf-8") for page in pages}
    counts = {name: 0 if name == WRITTEN_BY_THE_LIBRARY else len(MEASURED.sub("", text).split()) for name, text in texts.items()}
    if not quiet:
        print("\n".join(f"{count:6} {name}" for name, count in sorted(counts.items(), key=lambda item: -item[1])))
    total, size = sum(counts.values()), (root / "README.md").stat().st_size
    whole = sum(len(text.split()) for text in texts.values())
    print(f"{total} words on {len(pages)} pages, at most {MOST_WORDS}; {whole - total} more are written by programs; "
          f"README.md has {size} bytes, at most {MOST_README_BYTES}")
    return int(total > MOST_WORDS or size > MOST_README_BYTES or len(pages) < 10)


if __name__ == "__main__":
    sys.exit(main())
