"""No sentence of what users read has more than 30 words: README.md, pages of docs, examples and bindings. docs/research
is left out. No line of code is wider than the site shows.

    sentences.py ROOT
"""

from __future__ import annotations

import pathlib
import re
import sys

MOST_WORDS = 30
MOST_COLUMNS = 88  # of code, which the site shows without scrolling
PLACES = ["README.md", "CONTRIBUTING.md", "docs/*.md", "examples/*/README.md", "bindings/*/README.md"]
CODED = ["docs/research/*.md", "benchmarks/*/README.md", "packaging/README.md"]  # whose lines of code are looked at too
CODE = re.compile(r"^(```|~~~).*?^\1|\$\$.*?\$\$|^    .*?$|<!--.*?-->", re.DOTALL | re.MULTILINE)
ENDS = re.compile(r"(?<=[.!?])[)\"*]*\s+(?=[\"'(*`\[$]*(?:[A-Z0-9`$]|bempd|code_aster|dolfinx))")


def words(sentence: str) -> int:
    """What a reader counts: `code`, a formula or a link is what it shows, a sign alone is nothing."""
    return sum(bool(re.search(r"\w", word)) for word in sentence.split())


def paragraphs(text: str) -> list[tuple[int, str]]:
    """Runs of lines with the number of the first one; items of lists and cells of tables stand alone."""
    found: list[tuple[int, str]] = []
    fresh = True
    for number, line in enumerate(text.splitlines(), 1):
        bare = line.strip()
        if not bare or bare.startswith("#") or set(bare) <= set("|-: "):
            fresh = True
        elif bare.startswith("|"):
            found += [(number, cell) for cell in bare.strip("|").split(" | ")]
            fresh = True
        elif line.startswith("    ") and fresh:
            continue  # code
        elif fresh or re.match(r"(?:[*-]|\d+\.|>)\s", bare):
            found.append((number, re.sub(r"^(?:[*-]|\d+\.|>)\s+", "", bare)))
            fresh = False
        else:
            found[-1] = (found[-1][0], f"{found[-1][1]} {bare.removeprefix('> ')}")
    return found


def long_sentences(text: str) -> list[tuple[int, int, str]]:
    """Line, words and text of every sentence that is too long."""
    text = CODE.sub(lambda match: "\n" * match[0].count("\n"), text)
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", text)
    found = []
    for number, paragraph in paragraphs(re.sub(r"`([^`\n]+)`", lambda match: "`" + match[1].replace(" ", "_"), text)):
        for sentence in ENDS.split(paragraph):
            if words(sentence) > MOST_WORDS:
                found.append((number, words(sentence), sentence.strip()))
    return found


def wide_code(text: str) -> list[tuple[int, int]]:
    """Line and length of every line of code that is too long; code that is set in by four columns loses them."""
    found, inside, before = [], False, ""
    for number, line in enumerate(text.splitlines(), 1):
        if line.lstrip().startswith("```"):
            inside = not inside
        columns = len(line) if inside else len(line) - 4 if line.startswith("    ") and not before else 0
        if columns > MOST_COLUMNS:
            found.append((number, columns))
        if inside or not line.startswith("    ") or before:
            before = line.strip()
    return found


def main() -> int:
    root = pathlib.Path(sys.argv[1]).resolve()
    pages = [page for place in PLACES for page in sorted(root.glob(place))]
    found = [f"{page.relative_to(root)}:{number}: {count} words: {sentence}" for page in pages
             for number, count, sentence in long_sentences(page.read_text(encoding="utf-8"))]
    coded = [page for place in [*PLACES, *CODED] for page in sorted(root.glob(place))]
    found += [f"{page.relative_to(root)}:{number}: code of {columns} columns" for page in coded
              for number, columns in wide_code(page.read_text(encoding="utf-8"))]
    print("\n".join(found) or f"no sentence of {len(pages)} pages has more than {MOST_WORDS} words")
    return int(bool(found) or len(pages) < 10)


if __name__ == "__main__":
    sys.exit(main())
