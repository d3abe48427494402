"""Comments begin with their subject, so that each can be read without the line above it.

    words.py ROOT                  counts blocks by folder; fails on a block without its subject in a clean folder
    words.py ROOT --list [FOLDER]  prints every block that begins without its subject
    words.py ROOT --draw COUNT     prints COUNT blocks of src with what they belong to, drawn by a fixed seed, for a reader

A block is a run of lines that hold a comment only; comments behind code are not blocks, their line is their subject. In
the C header a block is the text of @brief, of each member and of each value as well.

A block is flagged when its first word cannot be a subject:
- prepositions ("Of an open face.", "With cracks."): the noun that they belong to is on some other line;
- pronouns and words that point back ("Those ahead.", "The same of one element.", "It", "Both"): the reader has to find
  what they stand for;
- words that continue a sentence ("Likewise", "So", "Else", "Also", "Which", "Then").
"If", "When" and "Once" are allowed: they begin whole sentences, whose subject follows. So are "Whether" (what a function or
a flag answers), "No", "Every" and "Only"."""

from __future__ import annotations

import collections
import dataclasses
import pathlib
import random
import re
import sys

FOLDERS = ("include", "src", "tests", "bindings", "examples", "benchmarks")

# Folders in which no block may begin without its subject.
CLEAN = FOLDERS

PREPOSITIONS = """About Above Across After Against Ahead Along Alongside Among Apart Around As Aside At Away Before Behind Below
    Beneath Beside Besides Between Beyond By Despite During Except For From In Inside Instead Into Like Near Of Off On Onto
    Opposite Out Outside Over Past Per Regardless Round Since Than Through Throughout To Together Toward Towards Under Until
    Unlike Up Upon Via With Within Without"""
POINTING_BACK = """All+of+them Both Former Her His It Its Latter Neither None Others Same Some+of+them Such That The+latter
    The+other+one The+other The+others The+rest The+same Their Them These They This Those Whose"""
CONTINUING = """Again Also Although And Another+one Because But Consequently Else Elsewhere Furthermore Hence Here However
    Likewise Moreover Nor Not Or Otherwise Similarly So Still Then There Therefore Though Thus Too What+is+left Whereas Where
    Which While Who Whom Yet"""
FLAGGED = re.compile("(" + "|".join(word.replace("+", r"\s+") for word in sorted(
    (PREPOSITIONS + " " + POINTING_BACK + " " + CONTINUING).split(), key=len, reverse=True)) + r")(?![\w'()\[\]/:=-])", re.IGNORECASE)

# Files that a program writes: their comments come from elsewhere.
GENERATED = ("bindings/python/bempd/_cdef.py", "bindings/fortran/bempd_c.f90", "bindings/rust/bempd-sys/src/bindings.rs")
MARKS = {".hpp": "//", ".cpp": "//", ".h": "//", ".c": "//", ".rs": "//", ".py": "#", ".f90": "!", ".sh": "#",
         ".cmake": "#", ".txt": "#"}


@dataclasses.dataclass
class Block:
    path: str
    line: int
    text: str
    code: str  # the first lines behind the block


def code_behind(lines: list[str], start: int) -> str:
    """What a block belongs to: lines up to the end of a signature, at most four."""
    taken: list[str] = []
    for line in lines[start:start + 4]:
        if not line.strip():
            break
        taken.append(line.rstrip())
        if line.rstrip().endswith(("{", "}", ";", ":")):
            break
    return "\n".join(taken)


def line_blocks(path: str, lines: list[str], mark: str) -> list[Block]:
    found: list[Block] = []
    start = 0
    while start < len(lines):
        if not lines[start].lstrip().startswith(mark) or lines[start].startswith("#!"):
            start += 1
            continue
        end = start
        while end < len(lines) and lines[end].lstrip().startswith(mark):
            end += 1
        text = "\n".join(re.sub(rf"^\s*{mark}[/!>]*\s?", "", line) for line in lines[start:end])
        indent = len(lines[start]) - len(lines[start].lstrip())
        goes_on = start > 0 and lines[start - 1][:indent].strip() and lines[start - 1][indent:].startswith(mark)
        if not goes_on and re.match(r"[A-Za-z]", text.strip()) and not re.match(r"(NOLINT|SPDX|clang-format|SAFETY)", text.strip()):
            found.append(Block(path, start + 1, text, code_behind(lines, end)))
        start = end
    return found


def starred_blocks(path: str, text: str) -> list[Block]:
    """Comments /* ... */ that begin on a line of their own, with @brief and @file taken off; and members /**< ... */."""
    found = []
    lines = text.splitlines()
    for match in re.finditer(r"/\*(.*?)\*/", text, re.DOTALL):
        line = text.count("\n", 0, match.start())
        behind_code = bool(text[text.rfind("\n", 0, match.start()) + 1:match.start()].strip())
        said = re.sub(r"^[ \t]*\*[ \t]?", "", match.group(1).lstrip("*!"), flags=re.MULTILINE)
        if behind_code and not said.startswith("<"):
            continue
        said = re.sub(r"^(\s*@(file|brief|defgroup \w+|name|addtogroup \w+)\b[^\S\n]*)+", "", said.lstrip("<")).strip()
        if re.match(r"[A-Za-z]", said) and not (behind_code and said[0].islower()):
            found.append(Block(path, line + 1, said, code_behind(lines, line + match.group().count("\n") + 1)))
    return found


def blocks(root: pathlib.Path) -> list[Block]:
    found = []
    for path in sorted(p for folder in FOLDERS for p in (root / folder).rglob("*") if p.suffix in MARKS and p.is_file()):
        name = path.relative_to(root).as_posix()
        if name in GENERATED or (path.suffix == ".txt" and path.name != "CMakeLists.txt") or "/target/" in name:
            continue
        text = path.read_text(encoding="utf-8")
        found += line_blocks(name, text.splitlines(), MARKS[path.suffix])
        if MARKS[path.suffix] == "//":
            found += starred_blocks(name, text)
    return found


def folder(path: str) -> str:
    parts = path.split("/")
    return "/".join(parts[:2]) if parts[0] == "src" and len(parts) > 2 else parts[0]


def within(path: str, folders: tuple[str, ...]) -> bool:
    return any(path == name or path.startswith(name + "/") for name in folders)


def draw(found: list[Block], count: int) -> None:
    of_src = [block for block in found if block.path.startswith("src/")]
    for number, block in enumerate(random.Random(30).sample(of_src, count), 1):
        print(f"{number}. {block.path}:{block.line}\n{block.text}\n  | " + block.code.replace("\n", "\n  | ") + "\n")


def main() -> int:
    found = blocks(pathlib.Path(sys.argv[1]))
    flagged = [block for block in found if FLAGGED.match(block.text)]
    if sys.argv[2:3] == ["--draw"]:
        draw(found, int(sys.argv[3]))
        return 0
    if sys.argv[2:3] == ["--list"]:
        for block in flagged:
            if within(block.path, tuple(sys.argv[3:]) or FOLDERS):
                print(f"{block.path}:{block.line}: {block.text.splitlines()[0]}")
        return 0
    counted = collections.Counter(folder(block.path) for block in found)
    bad = collections.Counter(folder(block.path) for block in flagged)
    for name in sorted(counted):
        print(f"{name:18} {counted[name]:5} blocks, {bad[name]:4} without their subject")
    print(f"{'all':18} {len(found):5} blocks, {len(flagged):4} without their subject")
    complaints = [block for block in flagged if within(block.path, CLEAN)]
    for block in complaints:
        print(f"{block.path}:{block.line}: a comment begins without its subject: {block.text.splitlines()[0]}")
    return 1 if complaints else 0


sys.exit(main())
