#!/usr/bin/env python3
"""Writes docs/options.md from what the library says of its options.

    docs/options.py            writes the page
    docs/options.py --check    fails with the difference when it is not what would be written

The library is found as the Python package finds it (BEMPD_LIBRARY)."""

from __future__ import annotations

import difflib
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "bindings/python"))

import bempd.options  # noqa: E402

PAGE = ROOT / "docs/options.md"
HEAD = """# Options

Every knob of the library by its name, as the library itself lists them. This page is written by `docs/options.py`; a test
fails when it is not what the library says.

| language | set | ask |
|---|---|---|
| C | `bempd_set_option(model, "crack.tie_share", 0.01)`, `bempd_set_option_text(model, "crack.rule", "bond")` | `bempd_get_option()`, `bempd_option_describe()` |
| Fortran | `call model%set_option("crack.tie_share", .01_dp)`, `call model%set_option("crack.rule", "bond")` | `call model%get_option(...)`, `call bempd_get_options(options)` |
| Python | `model.options["crack.rule"] = "bond"`, `bempd.Model(options={"crack.rule": "bond"})` | `model.options["crack.rule"]`, `model.options.describe("crack.rule")` |
| Rust | `model.set_option("crack.tie_share", 0.01)?`, `model.set_option_text("crack.rule", "bond")?` | `model.option(...)`, `bempd::options()` |

An unknown name is an error that lists the near ones, a name of an earlier version one that says what to use instead. What a prepared model has built already keeps the old value.
"""


def number(value: float) -> str:
    return f"{value:g}" if abs(value) < 1e300 else "no limit"


def row(option: bempd.options.OptionInfo) -> str:
    if option.choices:
        legal, default = ", ".join(f"`{word}`" for word in option.choices), f"`{option.default}`"
    elif isinstance(option.default, str):
        legal, default = "any text", "empty"
    else:
        whole = "whole, " if option.whole_number else ""
        legal, default = f"{whole}{number(option.minimum)} .. {number(option.maximum)}", number(option.default)
        if option.unit != "-":
            legal += f" {option.unit}"
    summary = option.summary.replace("|", "\\\\|")
    for word in [*(option.choices or []), "0"]:
        summary = re.sub(rf"(?<=[.] ){re.escape(word)}: ", f"`{word}`: ", summary)
    return f"| `{option.name}` | {default} | {legal} | {summary} |"


def page() -> str:
    bempd.options.in_python = lambda text: text  # summaries with the names of C, as this page is for all languages
    groups: dict[str, list[str]] = {}
    titles = {"pd": "Peridynamic regions", "bem": "Boundary elements", "stepping": "Stepping", "crack": "Growth of cracks",
              "snapshots": "Snapshots", "tips": "Crack tips", "memory": "Memory", "linalg": "Sparse systems", "paper": "Scheme paper"}
    for option in bempd.describe_options().values():
        family = option.name.split(".")[0] if "." in option.name else ""
        groups.setdefault(titles.get(family, family.capitalize() if family else "General"), []).append(row(option))
    text = HEAD
    # The library's own order is that of its files, which is not the same in every build.
    order = ["General", *titles.values()]
    for title, rows in sorted(groups.items(), key=lambda group: (order.index(group[0]) if group[0] in order else len(order), group[0])):
        text += f"\n## {title}\n\n| name | default | legal | what it does |\n|---|---|---|---|\n" + "\n".join(sorted(rows)) + "\n"
    return text


def main() -> int:
    wanted = page()
    if "--check" not in sys.argv:
        PAGE.write_text(wanted, encoding="utf-8")
        return 0
    present = PAGE.read_text(encoding="utf-8") if PAGE.exists() else ""
    sys.stderr.writelines(difflib.unified_diff(present.splitlines(keepends=True), wanted.splitlines(keepends=True),
                                               "docs/options.md", "docs/options.md from the library"))
    if present != wanted:
        print("run docs/options.py and commit what it writes", file=sys.stderr)
    return int(present != wanted)


if __name__ == "__main__":
    sys.exit(main())
