"""Every function of the header is used by a friendly layer, or bindings/raw_only.txt says why not.

    coverage.py python|rust|fortran

The list has lines "language function reason". A function that is both used and listed is an error too.
"""

import io
import pathlib
import re
import sys
import tokenize

ROOT = pathlib.Path(__file__).resolve().parents[2]
BINDINGS = ROOT / "bindings"
NAME = re.compile(r"\bbempd_\w+")


def functions_of_the_header() -> set[str]:
    text = (ROOT / "include/bempd.h").read_text(encoding="utf-8")
    return set(re.findall(r"^BEMPD_API [^(;]*?\b(bempd_\w+)\(", text, re.MULTILINE))


def names_in_python(text: str) -> set[str]:
    """Names, and strings that are one name and nothing else; neither comments nor documentation."""
    result = set()
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.NAME:
            result.add(token.string)
        elif token.type == tokenize.STRING:
            result.add(token.string.strip("\"'"))
    return result


def names_in_rust(text: str) -> set[str]:
    return set(NAME.findall(re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.DOTALL)))


def names_in_fortran(text: str) -> set[str]:
    """Calls only: type names and imports share the prefix."""
    statements = re.sub(r"'[^'\n]*'|\"[^\"\n]*\"|![^\n]*", "", text)
    return set(re.findall(r"\b(bempd_\w+)\(", statements))


LAYERS = {
    "python": (lambda: [path for path in (BINDINGS / "python/bempd").glob("*.py") if path.name != "_cdef.py"],
               names_in_python),
    "rust": (lambda: (BINDINGS / "rust/bempd/src").rglob("*.rs"), names_in_rust),
    "fortran": (lambda: [path for path in (BINDINGS / "fortran").glob("bempd*.f90") if path.name != "bempd_c.f90"],
                names_in_fortran),
}


def raw_only(layer: str) -> tuple[set[str], list[str]]:
    """Functions that a layer leaves out on purpose, and what is wrong with the list."""
    names, faults = set(), []
    path = BINDINGS / "raw_only.txt"
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines() if path.exists() else [], start=1):
        if not line.strip() or line.startswith("#"):
            continue
        words = line.split(maxsplit=2)
        if len(words) < 3 or words[0] not in LAYERS:
            faults.append(f"bindings/raw_only.txt:{number}: needs: language function reason")
        elif words[0] == layer:
            names.add(words[1])
    return names, faults


def main() -> int:
    layer = sys.argv[1]
    sources, names_in = LAYERS[layer]
    used = set().union(*(names_in(path.read_text(encoding="utf-8")) for path in sources()))
    functions = functions_of_the_header()
    listed, faults = raw_only(layer)
    faults += [f"the {layer} layer neither uses {name} nor lists it in bindings/raw_only.txt"
               for name in sorted(functions - used - listed)]
    faults += [f"the {layer} layer uses {name}, which bindings/raw_only.txt lists" for name in sorted(listed & used)]
    faults += [f"bindings/raw_only.txt: there is no function {name}" for name in sorted(listed - functions)]
    print("\n".join(faults) or f"{layer}: {len(functions & used)} of {len(functions)} functions used, "
                               f"{len(listed)} left out on purpose")
    return 1 if faults or not functions else 0


if __name__ == "__main__":
    sys.exit(main())
