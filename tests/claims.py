#!/usr/bin/env python3
"""Numbers that the documents claim: tests/claims.json says which test holds each of them, and to which bound.

    tests/claims.py --check              fails with the difference when the tables of the pages are not those of the claims,
                                         when a sentence does not state its number, or when no test reads a bound
    tests/claims.py --write              writes the tables into the pages
    tests/claims.py --summaries OUT EXAMPLE...
                                         holds the numbers in OUT/<example>/summary.csv to their bounds, without those of
                                         the scheme that --without-scheme names

A claim has `claimed`, as the documents print it, and one of
    bound    the value must not be larger; at most twice what is claimed
    within   the value must not be farther from what is claimed
    exactly  the text must be what is claimed
C++ tests read bounds as claims::<name> from the header that tests/claims.cmake makes, Python tests from the file. A claim
with `summary` is a cell, or several that each must hold, of an example's summary.
"""

import argparse
import csv
import difflib
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PLACE = re.compile(r"\{(\w+)\}")
LARGEST_FACTOR = 2


class Claims:
    """What tests/claims.json says; `root` is the folder of the repository."""

    def __init__(self, root):
        self.root = root
        content = json.loads((root / "tests/claims.json").read_text(encoding="utf-8"))
        self.claims, self.tables, self.sentences = content["claims"], content["tables"], content["sentences"]

    def fill(self, text):
        return PLACE.sub(lambda place: self.claims[place[1]]["claimed"], text)

    def table(self, table):
        def line(cells):
            return "|" + "".join(f" {cell} |" if cell else " |" for cell in map(self.fill, cells)) + "\n"

        return line(table["columns"]) + "|---" * len(table["columns"]) + "|\n" + "".join(map(line, table["rows"]))

    def page(self, file):
        """A page with the first table under each heading replaced by that of the claims."""
        text = (self.root / file).read_text(encoding="utf-8")
        for table in (table for table in self.tables if table["file"] == file):
            pattern = rf"(^{re.escape(table['heading'])}\n(?:(?!\||#).*\n)*)((?:\|.*\n)+)"
            text, count = re.subn(pattern, lambda match, new=self.table(table): match[1] + new, text, flags=re.MULTILINE)
            if count != 1:
                raise SystemExit(f"{file} needs one heading '{table['heading']}' with a table under it; it has {count}")
        return text

    def pages(self):
        """Every page that has a table, by its path, as the claims have it."""
        return {file: self.page(file) for file in dict.fromkeys(table["file"] for table in self.tables)}


def words(text):
    """Text of a document or comment on one line, without the stars of a comment."""
    return " ".join(re.sub(r"^\s*\*(?=\s)", "", text, flags=re.MULTILINE).split())


def wrong_bounds(claims):
    for name, claim in claims.claims.items():
        if sum(key in claim for key in ("bound", "within", "exactly")) != 1:
            yield f"{name}: give one of bound, within and exactly"
        elif "bound" in claim and not 0 < claim["bound"] <= LARGEST_FACTOR * float(claim["claimed"]) * (1 + 1e-12):
            yield f"{name}: the bound {claim['bound']:g} is not within {LARGEST_FACTOR} times the claimed {claim['claimed']}"


def unstated(claims):
    texts = [cell for table in claims.tables for row in table["rows"] for cell in row]
    texts += [sentence["text"] for sentence in claims.sentences]
    places = {name for text in texts for name in PLACE.findall(text)}
    yield from (f"{name}: no table and no sentence states it" for name in claims.claims.keys() - places)
    yield from (f"{name}: a table or a sentence names it, but it is no claim" for name in places - claims.claims.keys())


def wrong_sentences(claims):
    for sentence in claims.sentences:
        document = words((claims.root / sentence["file"]).read_text(encoding="utf-8"))
        if claims.fill(sentence["text"]) not in document:
            yield f"{sentence['file']} does not say: {claims.fill(sentence['text'])}"


def unheld(claims):
    """Claims whose bound no test reads. Those of summaries are read by this script, texts by the tests of the examples."""
    sources = {path.stem: path.read_text(encoding="utf-8")
               for pattern in ("physics/**/*_test.cpp", "claims/*.py") for path in (claims.root / "tests").glob(pattern)}
    for name, claim in claims.claims.items():
        if "summary" in claim or "exactly" in claim:
            continue
        source = sources.get(claim["test"].removeprefix("claims."), "")
        if not re.search(rf"\bclaims::{name}\b|\"{name}\"", source):
            yield f"{name}: {claim['test']} does not read its bound"


def check(claims):
    complaints = [*wrong_bounds(claims), *unstated(claims)]
    if not complaints:
        complaints = [*wrong_sentences(claims), *unheld(claims)]
        for file, wanted in claims.pages().items():
            present = (claims.root / file).read_text(encoding="utf-8")
            complaints += difflib.unified_diff(present.splitlines(), wanted.splitlines(), file, f"{file} of the claims", lineterm="")
            if present != wanted:
                complaints.append("run tests/claims.py --write and commit what it writes")
    if complaints:
        raise SystemExit("\n".join(complaints))
    print(f"{len(claims.claims)} claims are stated and held by tests")


def held(claim, value):
    if "bound" in claim:
        return value <= claim["bound"]
    return abs(value - float(claim["claimed"])) <= claim["within"]


def cells(out, summary):
    """What the summary of an example has for the cases of a claim."""
    with open(out / summary["example"] / "summary.csv", newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            if row["case"] in summary["cases"] and all(row[key] == summary[key] for key in ("scheme", "quantity")):
                yield abs(float(row[summary["column"]]))


def check_summaries(claims, out, examples, left_out):
    failed = False
    for name, claim in claims.claims.items():
        summary = claim.get("summary")
        if not summary or summary["example"] not in examples or summary["scheme"] == left_out:
            continue
        values = list(cells(out, summary))
        good = len(values) == len(summary["cases"]) and all(held(claim, value) for value in values)
        limit = f"<= {claim['bound']:g}" if "bound" in claim else f"{claim['claimed']} within {claim['within']:g}"
        print(f"{'ok    ' if good else 'FAILED'} {name}: {claim['quantity']}: {values}, claimed {claim['claimed']}, must be {limit}")
        failed = failed or not good
    return failed


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    action = parser.add_mutually_exclusive_group(required=True)
    action.add_argument("--check", action="store_true", help="write nothing; fail when something would change")
    action.add_argument("--write", action="store_true", help="write the tables into the pages")
    action.add_argument("--summaries", nargs="+", metavar="OUT EXAMPLE", help="hold what examples wrote to its bounds")
    parser.add_argument("--without-scheme", metavar="NAME", help="a scheme that the library was built without")
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="another root of the documents and tests")
    options = parser.parse_args()
    claims = Claims(options.root)
    if options.summaries:
        sys.exit(check_summaries(claims, pathlib.Path(options.summaries[0]), options.summaries[1:],
                                 options.without_scheme))
    if options.write:
        for file, text in claims.pages().items():
            (claims.root / file).write_text(text, encoding="utf-8")
    else:
        check(claims)


if __name__ == "__main__":
    main()
