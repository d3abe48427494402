"""No two types of one namespace have the same name in different files of src/.

    type_names.py ROOT

The linker takes one of two destructors of the same name for both types. Names in unnamed namespaces are a file's own."""

from __future__ import annotations

import pathlib
import re
import sys

OPENS = re.compile(r"namespace ([\w:]*) ?\{$")
TYPE = re.compile(r"(?:template <.*> )?(?:class|struct|union|enum|enum class) (\w+)(?: final)?(?: : [^;]*)? ?\{")


def types_in(text: str) -> list[str]:
    """Types that are defined at the level of a namespace that has a name, with the namespace."""
    spaces: list[str] = []
    found = []
    for line in text.splitlines():
        opens, defined = OPENS.match(line), TYPE.match(line)
        if opens:
            spaces.append(opens.group(1))
        elif line.startswith("}  // namespace"):
            spaces.pop()
        elif defined and all(spaces):
            found.append("::".join([*spaces, defined.group(1)]))
    return found


def main() -> int:
    source = pathlib.Path(sys.argv[1]) / "src"
    files: dict[str, list[str]] = {}
    for path in sorted(p for ending in ("*.cpp", "*.hpp") for p in source.rglob(ending)):
        for name in types_in(path.read_text(encoding="utf-8")):
            files.setdefault(name, []).append(path.relative_to(source).as_posix())
    faults = [f"{name} is defined in {' and '.join(where)}" for name, where in files.items() if len(where) > 1]
    print("\n".join(faults) or f"{len(files)} types, each name for one")
    return int(bool(faults) or not files)


if __name__ == "__main__":
    sys.exit(main())
