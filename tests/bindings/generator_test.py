"""bindings/generate.py refuses headers from which no binding could be written, and writes the same text every time."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
GENERATE = ROOT / "bindings/generate.py"

GOOD = """\
/** @file good.h
 *  @brief A header that obeys the rules. */
#include <stdint.h>
/** @brief Outcome. @since 0.1 */
typedef enum bempd_status { BEMPD_OK = 0, BEMPD_ERROR = -1 } bempd_status;

/** @brief A model. @since 0.1 */
typedef struct bempd_model bempd_model;

/** @brief Sizes. @since 0.1 */
typedef struct bempd_sizes {
  int64_t nodes; /**< nodes */
} bempd_sizes;

/** @brief Told of progress. @param[in] done share [-] @param[in] user the pointer given with it
 *  @return 0 to go on @since 0.1 */
typedef int32_t (*bempd_progress)(double done, void* user);

/** @brief Copy values. @param[in] model the model @param[in] points shape [count][2]
 *  @param[in] count number of points
 *  @param[out] values shape [count] @param[out] id its id; may be NULL @return status @since 0.1 */
bempd_status bempd_copy(const bempd_model* model, const double* points, int64_t count,
                        double* values, int32_t* id);

/** @brief Free it. @param[in] model may be NULL @since 0.1 */
void bempd_model_free(bempd_model* model);
"""

# What is changed in the good header, the line that must be named, and words of the sentence.
BAD = {
    "missing_since": ("@brief A model. @since 0.1", "@brief A model.", 8, "lacks @since"),
    "missing_comment": ("/** @brief A model. @since 0.1 */", "", 8, "has no comment"),
    "missing_member_comment": (" /**< nodes */", "", 12, "member nodes"),
    "missing_direction": ("@param[in] model the model", "@param model the model", 22, "'model'"),
    "missing_param": ("@param[in] count number of points", "", 22, "'count' of bempd_copy needs @param"),
    "param_of_nothing": ("@param[in] count number of points",
                         "@param[in] count number of points @param[in] size bytes", 22, "describes 'size'"),
    "output_of_constants": ("@param[in] points", "@param[out] points", 22, "must say [in]"),
    "missing_input_shape": ("points shape [count][2]", "points the points", 22, "lacks the word shape"),
    "missing_output_shape": ("values shape [count]", "values the values", 23, "lacks the word shape"),
    "missing_null": ("model may be NULL", "model the model", 26, "may be NULL"),
    "missing_return": ("@return status", "", 22, "lacks @return"),
    "unnamed_enum": ("enum bempd_status {", "enum {", 5, "must have the same name"),
    "enum_without_typedef": ("/** @brief A model.", "enum bempd_more { BEMPD_MORE = 1 }; /** @brief A model.", 7,
                             "typedef"),
    "implicit_value": ("BEMPD_OK = 0", "BEMPD_OK", 5, "explicit number"),
    "unsigned_argument": ("int64_t count,", "unsigned count,", 22, "type unsigned"),
    "long_member": ("int64_t nodes;", "long nodes;", 12, "type long"),
    "bool_argument": ("double* values, int32_t* id", "double* values, bool* id", 23, "type bool"),
    "size_t_argument": ("int64_t count,", "size_t count,", 22, "type size_t"),
    "byte_by_value": ("int64_t count,", "uint8_t count,", 22, "type uint8_t"),
    "array_member": ("int64_t nodes;", "int64_t nodes[2];", 12, "a pointer and a count"),
    "same_name_in_fortran": ("BEMPD_ERROR = -1", "BEMPD_MODEL = -1", 8, "same name in Fortran"),
    "other_prefix": ("BEMPD_ERROR = -1", "ERROR = -1", 5, "prefix"),
    "not_c": ("int64_t count,", "int64_t, count,", 22, ""),
    "preprocessor_error": ("#include <stdint.h>", "#if 1 +", 3, ""),
    "variable": ("/** @brief A model.", "int32_t bempd_more; /** @brief A model.", 7, "only functions and typedefs"),
}


def generate(*arguments: str, **environment: str) -> subprocess.CompletedProcess:
    return subprocess.run([sys.executable, str(GENERATE), *arguments], capture_output=True, text=True, check=False,
                          env={**os.environ, **environment})


class Refusals(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.header = pathlib.Path(self.folder.name) / "bad.h"

    def run_on(self, text: str) -> subprocess.CompletedProcess:
        self.header.write_text(text, encoding="utf-8")
        return generate("--header", str(self.header), "--output", self.folder.name)

    def test_good_header_is_accepted(self):
        run = self.run_on(GOOD)
        self.assertEqual(run.returncode, 0, run.stderr)

    def test_each_breach_is_refused_at_its_line(self):
        for name, (old, new, line, words) in BAD.items():
            with self.subTest(name):
                self.assertEqual(GOOD.count(old), 1)
                run = self.run_on(GOOD.replace(old, new))
                self.assertEqual(run.returncode, 1)
                self.assertTrue(run.stderr.startswith(f"{self.header}:{line}: "), run.stderr)
                self.assertIn(words, run.stderr)
                self.assertEqual(list(pathlib.Path(self.folder.name).iterdir()), [self.header])

    def test_all_breaches_are_named_at_once(self):
        run = self.run_on(GOOD.replace("@since 0.1", ""))
        self.assertEqual(run.stderr.count("lacks @since"), 6)


class Outputs(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def write(self, **environment: str) -> dict[str, str]:
        run = generate("--output", self.folder.name, **environment)
        self.assertEqual(run.returncode, 0, run.stderr)
        root = pathlib.Path(self.folder.name)
        return {str(path.relative_to(root)): path.read_text(encoding="utf-8")
                for path in root.rglob("*") if path.is_file()}

    def test_text_depends_on_nothing_but_the_header(self):
        first = self.write(PYTHONHASHSEED="1", LC_ALL="C")
        self.assertEqual(first, self.write(PYTHONHASHSEED="2", LC_ALL="C.UTF-8"))

    def test_lines_are_within_limits_and_files_say_what_they_are(self):
        limits = {".py": 120, ".f90": 132, ".rs": 120}
        for path, text in self.write().items():
            with self.subTest(path):
                self.assertLessEqual(max(map(len, text.split("\n"))), limits[pathlib.Path(path).suffix])
                self.assertIn("Generated by bindings/generate.py from include/bempd.h; do not edit.", text)

    def test_every_function_of_the_header_is_in_every_output(self):
        source = (ROOT / "include/bempd.h").read_text(encoding="utf-8")
        names = [line.split("(")[0].split()[-1].lstrip("*") for line in source.split("\n")
                 if line.startswith("BEMPD_API ")]
        self.assertGreater(len(names), 60)
        for path, text in self.write().items():
            for name in names:
                self.assertRegex(text, rf"\b{name}\(", path)

    def test_check_shows_the_difference(self):
        self.write()
        self.assertEqual(generate("--check", "--output", self.folder.name).returncode, 0)
        path = pathlib.Path(self.folder.name) / "bindings/fortran/bempd_c.f90"
        path.write_text(path.read_text(encoding="utf-8").replace("BEMPD_OK = 0", "BEMPD_OK = 1"), encoding="utf-8")
        run = generate("--check", "--output", self.folder.name)
        self.assertEqual(run.returncode, 1)
        self.assertIn("-  integer(c_int), parameter :: BEMPD_OK = 1", run.stderr)
        self.assertIn("+  integer(c_int), parameter :: BEMPD_OK = 0", run.stderr)


if __name__ == "__main__":
    unittest.main()
