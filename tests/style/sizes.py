"""No source file over 300 lines, no function over 50, no class over 40 methods or 300 lines: what is longer holds more than one
idea.

    sizes.py ROOT             fails for what is longer
    sizes.py ROOT --classes   prints methods and lines of the classes over half of these limits, the largest first
    sizes.py ROOT --folders   prints the lines of each folder of src, and how many classes are over the limits

Reads the sources under ROOT/src as the formatter leaves them: a function begins on a line that is indented no deeper than a
member of a class in a namespace, and ends at the closing brace with the same indent. Methods of a class are those that it
declares, without deleted and defaulted ones; its lines are those of its declaration and of its definitions elsewhere in the
layer. Classes that are larger today are listed with what they may have; these numbers may only fall."""

from __future__ import annotations

import pathlib
import re
import sys

MOST_LINES, MOST_LINES_OF_A_FUNCTION = 300, 50
MOST_METHODS, MOST_LINES_OF_A_CLASS = 40, 300
NOT_A_FUNCTION = re.compile(r"^\s*(namespace|class|struct|enum|union|extern|if|for|while|switch|else|do|try|\}|//|#)")

# What may be longer, and why.
EXCEPTIONS: dict[str, str] = {}

# Classes that hold more than one idea: methods and lines that they may have. Numbers may only fall; a class that is no longer
# too large leaves the list.
LARGE_CLASSES: dict[str, tuple[int, int]] = {}


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


COMMENT = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', re.DOTALL)
CLASS = re.compile(r"\b(?:class|struct) (\w+)(?: final)?(?: : [^;{()]*)? \{")
DEFINITION = re.compile(r"^[^\s#/].*?\b(\w+)(?:::\w+)?::~?\w+(?:[^\w:(][^(]*)?\(")


def blanked(text: str) -> str:
    """The text with comments, strings and characters blanked, lines kept."""
    return COMMENT.sub(lambda match: re.sub(r"[^\n]", " ", match.group()), text)


def statements(body: str) -> list[str]:
    """Members of a class: up to a semicolon or a closing brace at the level of the class, with what is in braces left out."""
    found, current, depth = [], "", 0
    for letter in body:
        if letter == "{":
            current += "{" if depth == 0 else ""
            depth += 1
        elif letter == "}":
            depth -= 1
            if depth == 0 and re.search(r"\)[^;]*\{$", current):  # the body of a function
                found.append(current)
                current = ""
        elif depth == 0 and letter == ";":
            found.append(current)
            current = ""
        elif depth == 0:
            current += letter
    return found


def is_method(statement: str) -> bool:
    text = re.sub(r"\b(public|protected|private):", "", statement).strip()
    text = re.sub(r"^template <[^;{]*?>\s*(requires [^;{]*?\n)?", "", text)
    if re.match(r"(using|friend|static_assert|typedef|enum|class|struct|union)\b", text):
        return False
    if re.search(r"= (delete|default)$", text):
        return False
    if "operator" in text:
        return True
    while re.search(r"<[^<>]*>", text):
        text = re.sub(r"<[^<>]*>", "", text)
    return bool(re.match(r"[^={]*?\w\(", text, re.DOTALL))


def classes(root: pathlib.Path) -> dict[str, tuple[int, int]]:
    """Methods and lines of every class, by layer and name."""
    methods: dict[str, int] = {}
    lines: dict[str, int] = {}
    sources = sorted(p for ending in ("*.hpp", "*.cpp") for p in (root / "src").rglob(ending))
    texts = {path: blanked(path.read_text()) for path in sources}
    for path, text in texts.items():
        layer = path.relative_to(root / "src").parts[0]
        for match in CLASS.finditer(text):
            end, depth = match.end(), 1
            while depth > 0:
                depth += {"{": 1, "}": -1}.get(text[end], 0)
                end += 1
            name = f"{layer}/{match.group(1)}"
            methods[name] = max(methods.get(name, 0), sum(map(is_method, statements(text[match.end():end - 1]))))
            lines[name] = max(lines.get(name, 0), text.count("\n", match.start(), end) + 1)
    for path, text in texts.items():
        layer = path.relative_to(root / "src").parts[0]
        code = text.splitlines()
        for first, last in functions(code):
            match = DEFINITION.match(" ".join(code[first - 1:first + 3]))
            if match and f"{layer}/{match.group(1)}" in lines:
                lines[f"{layer}/{match.group(1)}"] += last - first + 1
    return {name: (methods[name], lines[name]) for name in methods}


def large_classes(found: dict[str, tuple[int, int]]) -> list[str]:
    complaints = []
    for name, (methods, lines) in sorted(found.items()):
        is_large = methods > MOST_METHODS or lines > MOST_LINES_OF_A_CLASS
        most_methods, most_lines = LARGE_CLASSES.get(name, (MOST_METHODS, MOST_LINES_OF_A_CLASS))
        if methods > most_methods or lines > most_lines:
            complaints.append(f"class {name}: {methods} methods of at most {most_methods}, {lines} lines of {most_lines}")
        if name in LARGE_CLASSES and not is_large:
            complaints.append(f"class {name} is no longer large: take it off the list")
    complaints += [f"class {name} of the list is not there" for name in LARGE_CLASSES if name not in found]
    return complaints


def print_folders(root: pathlib.Path, found: dict[str, tuple[int, int]]) -> None:
    lines: dict[str, int] = {}
    for path in sorted(p for ending in ("*.cpp", "*.hpp") for p in (root / "src").rglob(ending)):
        parts = path.relative_to(root / "src").parts
        folder = parts[0] if len(parts) > 1 else "(src itself)"
        lines[folder] = lines.get(folder, 0) + path.read_text().count("\n")
    for folder, count in lines.items():
        print(f"{folder:15} {count:6} lines")
    methods = sum(most > MOST_METHODS for most, _ in found.values())
    long = sum(most > MOST_LINES_OF_A_CLASS for _, most in found.values())
    print(f"{'all':15} {sum(lines.values()):6} lines; {methods} classes of more than {MOST_METHODS} methods, {long} of more than "
          f"{MOST_LINES_OF_A_CLASS} lines")


def main() -> int:
    root = pathlib.Path(sys.argv[1])
    found = classes(root)
    if "--folders" in sys.argv:
        print_folders(root, found)
        return 0
    if "--classes" in sys.argv:
        for name, (methods, lines) in sorted(found.items(), key=lambda item: -max(item[1][0] / MOST_METHODS, item[1][1] / MOST_LINES_OF_A_CLASS)):
            if methods > MOST_METHODS / 2 or lines > MOST_LINES_OF_A_CLASS / 2:
                print(f"{name:40} {methods:4} methods {lines:5} lines")
        return 0
    complaints = large_classes(found)
    for path in sorted(p for ending in ("*.cpp", "*.hpp") for p in (root / "src").rglob(ending)):
        name = path.relative_to(root).as_posix()
        lines = path.read_text().splitlines()
        if len(lines) > MOST_LINES and name not in EXCEPTIONS:
            complaints.append(f"{name}: {len(lines)} lines")
        for first, last in functions(lines):
            if last - first + 1 > MOST_LINES_OF_A_FUNCTION and f"{name}:{lines[first - 1].strip()}" not in EXCEPTIONS:
                complaints.append(f"{name}:{first}: {last - first + 1} lines in '{lines[first - 1].strip()}'")
    print("\n".join(complaints) or "no file, no function and no class is too long")
    return 1 if complaints else 0


sys.exit(main())
