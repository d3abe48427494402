"""Joins the summaries of the paper's six examples into one Markdown table, or checks that a document shows it.

usage: /usr/bin/python3 examples/paper_tables.py [OUT]
       /usr/bin/python3 examples/paper_tables.py [OUT] --check docs/paper.md

OUT/<example>/summary.csv is written by the example; OUT is "out" without it. Rows are those for which the paper or a
reference has a number. The last three columns are seconds, which the check leaves out.
"""

import argparse
import csv
import difflib
import itertools
import pathlib

EXAMPLES = ("tension", "shear", "stretching", "centre_crack", "mixed_mode_crack", "two_edge_cracks")
HEADER = ("example", "case", "quantity", "paper", "scheme paper", "scheme symmetric", "reference",
          "error of the paper [%]", "error of scheme paper [%]", "error of scheme symmetric [%]",
          "seconds of the paper", "seconds of scheme paper", "seconds of scheme symmetric")
SECONDS_COLUMNS = 3


def read_summaries(out):
    """(example, case, quantity) -> scheme -> row, in the order of the examples."""
    joined = {}
    for example in EXAMPLES:
        with open(out / example / "summary.csv", newline="", encoding="utf-8") as file:
            for row in csv.DictReader(file):
                if row["reference"] or row["paper"] or row["paper_error_percent"]:
                    key = (example, row["case"], f"{row['quantity']} [{row['unit']}]")
                    joined.setdefault(key, {})[row["scheme"]] = row
    return joined


def shown(text, digits):
    """The number with few digits, or an empty cell; what is rounding alone is only said to be small."""
    if not text:
        return ""
    number = float(text)
    return "< 1e-8" if 0 < abs(number) < 1e-8 else f"{number:.{digits}g}"


def cell_of(rows, scheme, column, digits):
    return shown(rows[scheme][column], digits) if scheme in rows else ""


def first_of(rows, column, digits):
    """What the paper or a reference says is the same in the rows of both schemes, or given for one of them only."""
    values = dict.fromkeys(cell_of(rows, scheme, column, digits) for scheme in ("symmetric", "paper"))
    return " / ".join(value for value in values if value)


def references(rows):
    text = first_of(rows, "reference", 6)
    sources = dict.fromkeys(row["source"] for row in rows.values() if row["source"])
    return f"{text} ({', '.join(sources)})" if text else ""


def table_rows(joined):
    for (example, case, quantity), rows in joined.items():
        yield (example, case, quantity, first_of(rows, "paper", 6), cell_of(rows, "paper", "value", 5),
               cell_of(rows, "symmetric", "value", 5), references(rows), first_of(rows, "paper_error_percent", 3),
               cell_of(rows, "paper", "error_percent", 3), cell_of(rows, "symmetric", "error_percent", 3),
               first_of(rows, "paper_seconds", 3), cell_of(rows, "paper", "seconds", 2),
               cell_of(rows, "symmetric", "seconds", 2))


def markdown(rows):
    lines = [HEADER, ("---",) * len(HEADER), *rows]
    return "\n".join("| " + " | ".join(cells) + " |" for cells in lines)


def rows_of_document(document):
    """Cells of the table that starts with this script's header."""
    lines = document.read_text(encoding="utf-8").splitlines()
    start = "| " + " | ".join(HEADER) + " |"
    if start not in lines:
        raise SystemExit(f"{document} has no table with the header of this script")
    table = itertools.takewhile(lambda line: line.startswith("|"), lines[lines.index(start) + 2 :])
    return [tuple(cell.strip() for cell in line[1:-1].split("|")) for line in table]


def check(document, rows):
    stated, produced = ([tuple(row)[:-SECONDS_COLUMNS] for row in table] for table in (rows_of_document(document), rows))
    if stated != produced:
        differences = difflib.unified_diff(*([" | ".join(row) for row in table] for table in (stated, produced)),
                                           str(document), "the examples", n=0, lineterm="")
        raise SystemExit("\n".join(differences))
    print(f"{document} shows the {len(produced)} rows that the examples produce")


parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("out", nargs="?", default="out", type=pathlib.Path, help="folder with the examples' results")
parser.add_argument("--check", type=pathlib.Path, metavar="DOCUMENT", help="compare with the table in this document")
options = parser.parse_args()
rows = list(table_rows(read_summaries(options.out)))
if options.check:
    check(options.check, rows)
else:
    print(markdown(rows))
