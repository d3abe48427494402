"""Joins the summaries of the paper's six examples into one Markdown table, or checks that a stored table has the same rows.

usage: /usr/bin/python3 examples/paper_tables.py [OUT]
       /usr/bin/python3 examples/paper_tables.py [OUT] --check TABLE, or --write TABLE: docs/research/tables/paper_all_cases.csv

OUT/<example>/summary.csv is written by the example; OUT is "out" without it. Rows that say how a run went are left out:
rounding changes them. The last three columns are seconds, which the check leaves out, like a scheme that
did not run.
"""

import argparse
import csv
import difflib
import pathlib

EXAMPLES = ("tension", "shear", "stretching", "centre_crack", "mixed_mode_crack", "two_edge_cracks")
HEADER = ("example", "case", "quantity", "paper", "scheme paper", "scheme symmetric", "reference",
          "error of the paper [%]", "error of scheme paper [%]", "error of scheme symmetric [%]",
          "seconds of the paper", "seconds of scheme paper", "seconds of scheme symmetric")
SCHEME_COLUMNS = {"paper": (4, 8), "symmetric": (5, 9)}  # value and error
REFERENCE_COLUMN = 6
SECONDS_COLUMNS = 3
LEFT_OUT = ("bonds cut by the crack", "bonds broken", "events", "energy balance error", "residual",
            "largest error of u1 over the pull", "seconds_total", "seconds_one_elastic_solve",
            "seconds_total / seconds_one_elastic_solve")


def read_summaries(out):
    """(example, case, quantity) -> scheme -> row, in the order of the examples."""
    joined = {}
    for example in EXAMPLES:
        with open(out / example / "summary.csv", newline="", encoding="utf-8") as file:
            for row in csv.DictReader(file):
                if row["quantity"] not in LEFT_OUT:
                    key = (example, row["case"], f"{row['quantity']} [{row['unit']}]")
                    joined.setdefault(key, {})[row["scheme"]] = row
    return joined


def shown(text, digits):
    """The number with few digits, or an empty cell; what is rounding alone is only said to be small."""
    if not text:
        return ""
    number = float(text)
    return "< 1e-8" if abs(number) < 1e-8 else f"{number:.{digits}g}"


def cell_of(rows, scheme, column, digits):
    return shown(rows[scheme][column], digits) if scheme in rows else ""


def stated(rows, column):
    """What the paper says, in its own digits; it stands in the rows of both schemes."""
    return next((row[column] for row in rows.values() if row[column]), "")


def references(rows):
    """The reference, or those of scheme paper and scheme symmetric where a prototype has both."""
    values = dict.fromkeys(cell_of(rows, scheme, "reference", 6) for scheme in ("paper", "symmetric"))
    text = " / ".join(value for value in values if value)
    sources = dict.fromkeys(row["source"] for row in rows.values() if row["source"])
    return f"{text} ({', '.join(sources)})" if text else ""


def table_rows(joined):
    for (example, case, quantity), rows in joined.items():
        yield (example, case, quantity, stated(rows, "paper"), cell_of(rows, "paper", "value", 5),
               cell_of(rows, "symmetric", "value", 5), references(rows), stated(rows, "paper_error_percent"),
               cell_of(rows, "paper", "error_percent", 3), cell_of(rows, "symmetric", "error_percent", 3),
               stated(rows, "paper_seconds"), cell_of(rows, "paper", "seconds", 2),
               cell_of(rows, "symmetric", "seconds", 2))


def markdown(rows):
    lines = [HEADER, ("---",) * len(HEADER), *rows]
    return "\n".join("| " + " | ".join(cells) + " |" for cells in lines)


def rows_of_document(document):
    """Cells of the stored table, which has this script's header."""
    with open(document, newline="", encoding="utf-8") as file:
        header, *table = map(tuple, csv.reader(file))
    if header != HEADER:
        raise SystemExit(f"{document} has not the header of this script")
    return table


def comparable(row, schemes):
    """The row without seconds and without what only schemes that did not run say; None if nothing is left."""
    cells = list(row)[:-SECONDS_COLUMNS]
    for scheme, columns in SCHEME_COLUMNS.items():
        if scheme not in schemes[row[0]]:
            for column in columns:
                cells[column] = ""
    if len(schemes[row[0]]) < len(SCHEME_COLUMNS):
        cells[REFERENCE_COLUMN] = ""  # it may join those of both schemes
    return tuple(cells) if any(cells[columns[0]] for columns in SCHEME_COLUMNS.values()) else None


def check(document, rows, schemes):
    shows, produced = ([comparable(row, schemes) for row in table] for table in (rows_of_document(document), rows))
    shows, produced = (list(filter(None, table)) for table in (shows, produced))
    if shows != produced:
        differences = difflib.unified_diff(*([" | ".join(row) for row in table] for table in (shows, produced)),
                                           str(document), "the examples", n=0, lineterm="")
        raise SystemExit("\n".join(differences))
    print(f"{document} shows the {len(produced)} rows that the examples produced")


parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("out", nargs="?", default="out", type=pathlib.Path, help="folder with the examples' results")
parser.add_argument("--check", type=pathlib.Path, metavar="TABLE", help="compare with this table, a CSV file")
parser.add_argument("--write", type=pathlib.Path, metavar="TABLE", help="write this table, a CSV file")
options = parser.parse_args()
summaries = read_summaries(options.out)
rows = list(table_rows(summaries))
if options.check:
    ran = {example: set() for example in EXAMPLES}
    for (example, _, _), by_scheme in summaries.items():
        ran[example] |= by_scheme.keys()
    check(options.check, rows, ran)
elif options.write:
    with open(options.write, "w", newline="", encoding="utf-8") as file:
        csv.writer(file, lineterminator="\n").writerows([HEADER, *rows])
else:
    print(markdown(rows))
