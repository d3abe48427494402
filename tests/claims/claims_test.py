"""tests/claims.py notices documents that say something else, bounds that are too wide, claims that nothing holds, and
examples that got worse."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[1] / "claims.py"
SUMMARY = {"example": "bar", "cases": ["1", "2"], "scheme": "symmetric", "quantity": "error", "column": "value"}
CLAIMS = {
    "claims": {
        "patch": {"claimed": "4e-13", "bound": 8e-13, "test": "patch_test", "quantity": "error"},
        "events": {"claimed": "818", "within": 0, "test": "patch_test", "quantity": "events"},
        "bar": {"claimed": "1e-3", "bound": 2e-3, "test": "example.bar", "quantity": "error", "summary": SUMMARY},
        "line": {"claimed": "in two", "exactly": True, "test": "example.bar", "quantity": "what it prints"},
    },
    "tables": [{"file": "page.md", "heading": "## Measured", "columns": ["claim", "value"],
                "rows": [["patch, {events} events", "{patch}"], ["", "{bar}"]]}],
    "sentences": [{"file": "header.h", "text": "prints `{line}` and ends"}],
}
PAGE = """# Title

## Measured

A sentence.

| claim | value |
|---|---|
| patch, 818 events | 4e-13 |
| | 1e-3 |

## Other

| another | table |
|---|---|
"""
HEADER = "/** It prints\n *  `in two` and ends. */\n"
TEST = "EXPECT_LE(error, claims::patch); EXPECT_TRUE(claims::events.holds(events));"


class Claims(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        (self.root / "tests/physics").mkdir(parents=True)
        self.out = self.root / "out"
        (self.out / "bar").mkdir(parents=True)
        self.write("page.md", PAGE)
        self.write("header.h", HEADER)
        self.write("tests/physics/patch_test.cpp", TEST)
        self.write("tests/claims.json", json.dumps(CLAIMS))

    def write(self, path, text):
        (self.root / path).write_text(text, encoding="utf-8")

    def run_script(self, *arguments):
        done = subprocess.run([sys.executable, SCRIPT, "--root", self.root, *arguments], capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr

    def assert_refused(self, sentence, *arguments):
        code, said = self.run_script(*(arguments or ["--check"]))
        self.assertNotEqual(code, 0, said)
        self.assertIn(sentence, said)

    def changed(self, name, **values):
        claims = {**CLAIMS["claims"], name: {**CLAIMS["claims"][name], **values}}
        self.write("tests/claims.json", json.dumps({**CLAIMS, "claims": claims}))

    def test_accepts_documents_that_say_what_is_claimed(self):
        self.assertEqual(self.run_script("--check")[0], 0, self.run_script("--check")[1])

    def test_refuses_another_number_in_a_table_and_writes_the_right_one(self):
        self.write("page.md", PAGE.replace("4e-13", "1e-13"))
        self.assert_refused("+| patch, 818 events | 4e-13 |")
        self.run_script("--write")
        self.assertEqual((self.root / "page.md").read_text(encoding="utf-8"), PAGE)

    def test_refuses_a_document_without_the_table(self):
        self.write("page.md", "# Title\n\n## Measured\n\nA sentence.\n")
        self.assert_refused("a table under it")

    def test_refuses_another_number_in_a_sentence(self):
        self.write("header.h", HEADER.replace("in two", "in three"))
        self.assert_refused("header.h does not say: prints `in two` and ends")

    def test_refuses_a_bound_of_more_than_twice_the_claim(self):
        self.changed("patch", bound=9e-13)
        self.assert_refused("patch: the bound 9e-13")

    def test_refuses_a_claim_that_no_test_reads(self):
        self.write("tests/physics/patch_test.cpp", TEST.replace("claims::patch)", "1e-10)"))
        self.assert_refused("patch: patch_test does not read its bound")

    def test_refuses_a_claim_that_no_document_states_and_a_place_without_a_claim(self):
        claims = {name: claim for name, claim in CLAIMS["claims"].items() if name != "line"}
        claims["unsaid"] = CLAIMS["claims"]["patch"]
        self.write("tests/claims.json", json.dumps({**CLAIMS, "claims": claims}))
        self.assert_refused("unsaid: no table and no sentence states it")
        self.assert_refused("line: a table or a sentence names it, but it is no claim")

    def summary(self, *values):
        rows = "".join(f"bar,{case},symmetric,error,{value}\n" for case, value in enumerate(values, 1))
        self.write("out/bar/summary.csv", "example,case,scheme,quantity,value\n" + rows)

    def test_holds_summaries_of_examples_to_their_bounds(self):
        self.summary("1e-4", "-1.9e-3")
        self.assertEqual(self.run_script("--summaries", self.out, "bar")[0], 0)
        self.summary("1e-4", "-2.1e-3")
        self.assert_refused("FAILED bar", "--summaries", self.out, "bar")

    def test_a_missing_case_or_no_number_is_a_failure(self):
        self.summary("1e-4")
        self.assert_refused("FAILED bar", "--summaries", self.out, "bar")
        self.summary("1e-4", "nan")
        self.assert_refused("FAILED bar", "--summaries", self.out, "bar")


unittest.main()
