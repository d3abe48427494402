"""Length of what the project says of itself: words of README.md and of every page under docs, research notes too. Code, formulas,
numbers and the page of options, which the library writes, do not count. Prints the words of each page; fails above the bounds.

    length.py ROOT [--quiet]
"""

from __future__ import annotations

import pathlib
import re
import sys

import sentences

MOST_WORDS = 25000
MOST_README_BYTES = 7000
WRITTEN_BY_THE_LIBRARY = "docs/options.md"


def words(text: str) -> int:
    """Words that a reader reads: `code`, a formula in a line and a link are what they show."""
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", sentences.CODE.sub("", text))
    return sum(any(sign.isalpha() for sign in word) for word in text.split())


def main() -> int:
    root, quiet = pathlib.Path(sys.argv[1]).resolve(), "--quiet" in sys.argv
    pages = [page for page in [root / "README.md", *sorted((root / "docs").rglob("*.md"))]
             if str(page.relative_to(root)) != WRITTEN_BY_THE_LIBRARY]
    counts = {str(page.relative_to(root)): words(page.read_text(encoding="utf-8")) for page in pages}
    if not quiet:
        print("\n".join(f"{count:6} {name}" for name, count in sorted(counts.items(), key=lambda item: -item[1])))
    total, size = sum(counts.values()), (root / "README.md").stat().st_size
    print(f"{total} words on {len(pages)} pages, at most {MOST_WORDS}; README.md has {size} bytes, at most {MOST_README_BYTES}")
    return int(total > MOST_WORDS or size > MOST_README_BYTES or len(pages) < 10)


if __name__ == "__main__":
    sys.exit(main())
