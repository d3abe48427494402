"""Wrong answers that independent tests of cracks once found, each with the tests that fail where it comes back. Prints the table; fails
where a row has no test, or a test that is named does not exist or is not built.

    wrong_answers.py ROOT [--quiet]
"""

from __future__ import annotations

import pathlib
import re
import sys

# Number of the finding: what was wrong, and the tests, as FILE:NAME of a case in it. Files lie anywhere below tests/. Missing numbers
# are findings about loads of lattice cracks, which docs/limits.md has.
WRONG: dict[int, tuple[str, list[str]]] = {
    1: ("nothing broke in lattices while the load factor fell",
        ["test_falling_loads.py:test_a_strip_pulled_by_a_falling_load_factor_separates_where_it_does_by_a_rising_one",
         "test_falling_loads.py:test_with_loads_and_load_factors_negated_all_events_are_the_same"]),
    2: ("bempd_tip() looked for tips among broken bonds",
        ["test_reported_growth.py:test_tips_of_lines_are_where_the_crack_has_come_to",
         "test_reported_growth.py:test_a_crack_that_begins_has_tips_a_path_and_a_length",
         "test_births_at_edges.py:test_a_crack_that_begins_at_a_hole_has_one_tip"]),
    3: ("critical_load_factor was that of growth straight on",
        ["test_reported_growth.py:test_elements_grow_where_their_tips_tell",
         "test_reported_growth.py:test_steps_grow_elements_where_their_tips_tell",
         "test_reported_growth.py:test_lines_grow_where_their_tips_tell",
         "test_reported_growth.py:test_at_rest_tips_tell_their_growth_with_faces_as_they_will_be",
         "test_reported_growth.py:test_a_critical_stretch_is_a_toughness_too"]),
    4: ("steps did not grow cracks in BEM regions",
        ["driven_cracks_test.cpp:beside_a_lattice", "cut_regions_test.cpp:a_plate_is_torn_in_two"]),
    5: ("load-displacement curves missed their peak",
        ["test_before_events.py:test_the_load_curve_has_its_peak",
         "test_before_events.py:test_the_peak_is_the_largest_force_before_an_event"]),
    6: ("tips without rings told factors of 0", ["lattice_tips.c:short_cracks_have_no_contours"]),
    7: ("stress at corners counted half an area", ["regions_tip_fit_test.cpp:corners_count_by_their_share_of_a_cell"]),
    8: ("growth that cuts a region in two was refused",
        ["cut_regions_test.cpp:a_plate_is_torn_in_two", "test_torn_plates.py:test_a_plate_is_torn_in_two",
         "crack_tips.c:cracks_grow_until_they_cut_the_plate"]),
    9: ("documents told the square of the strength without a crack",
        ["strength_test.cpp:of_a_plate_without_a_crack", "strength_test.cpp:at_other_ratios_of_poisson",
         "claims.json:strength"]),
    10: ("lengths of elements chosen by the host switched off the refinement at a mouth",
         ["crack_meshes_test.cpp:short_cracks_from_an_edge_whose_elements_are_chosen"]),
    11: ("a line kept the law of the region in which it began",
         ["test_line_order.py:test_a_line_takes_the_toughness_of_the_region_that_it_has_come_to"]),
    12: ("plates under dead loads that balance were never separated",
         ["test_balanced_loads.py:test_a_plate_that_is_torn_in_two_is_separated",
          "test_torn_plates.py:test_a_plate_that_dead_loads_pull_is_torn_in_two",
          "resting_tips_test.cpp:plate_under_dead_loads_that_balance_comes_apart"]),
    16: ("which of two equal tips grows was left to rounding, and tips within 1 % grew together",
         ["crack_order_test.cpp:ties_go_by_crack_and_end_whatever_rounding_says",
          "driven_cracks_test.cpp:the_longest_goes_first_and_of_ties_the_first_added",
          "test_line_order.py:test_of_equal_cracks_the_one_that_was_added_first_grows_and_the_tie_is_counted",
          "resting_tips_test.cpp:history_tells_ties"]),
    17: ("runs of crack elements ended in an error, and released energy was of first order in the step",
         ["cut_regions_test.cpp:a_plate_is_torn_in_two", "driven_cracks_test.cpp:release_their_fracture_energy_at_long_steps"]),
    18: ("a line ran along the border of its lattice",
         ["test_stopped_cracks.py:test_a_line_stops_at_the_border_of_its_lattice",
          "crossed_borders_test.cpp:from_a_lattice_into_elements"]),
    20: ("other units or a turn of the body let the other of two equal tips grow",
         ["test_line_order.py:test_of_two_ends_the_start_grows_first_however_the_body_is_turned", "same_cracks.py:tied"]),
    21: ("energies balanced less well than documents told", ["energy_balance.py:main", "claims.json:energy_balance"]),
    22: ("which of several overloaded cracks grows was the order in which they were added",
         ["test_line_order.py:test_the_most_overloaded_tip_grows_first_whatever_the_order_in_which_cracks_were_added",
          "crack_order_test.cpp:overloaded_tips_come_first_the_most_overloaded_one_before_all"]),
    23: ("windows and whole bodies broke other bonds after the load fell",
         ["test_falling_loads.py:test_after_the_load_fell_windows_break_the_bonds_of_the_whole_body",
          "test_falling_loads.py:test_a_load_that_goes_through_zero_and_back_without_a_break_leaves_the_same_state"]),
    24: ("programs that rest at zero were unsolvable, and refused growth changed results",
         ["test_loads_at_rest.py:test_a_program_rests_at_zero", "test_loads_at_rest.py:test_a_program_reports_what_its_ways_report",
          "driven_cracks_test.cpp:refused_growth_changes_nothing"]),
    25: ("steps of lines divided by zero",
         ["test_floating_point_traps.py:test_random_scenes_raise_no_floating_point_exception",
          "test_floating_point_traps.py:test_tips_that_nothing_loads_raise_no_floating_point_exception"]),
    26: ("rounding chose among places that tie",
         ["test_line_order.py:test_places_where_cracks_begin_tie_too", "same_cracks.py:tied"]),
    27: ("narrow gaps and strong grading took memory and time without a word",
         ["crack_gaps_test.cpp:long_elements_in_a_gap_change_no_intensity",
          "crack_meshes_test.cpp:a_gap_that_takes_many_elements_is_told",
          "crack_meshes_test.cpp:a_gap_that_takes_more_memory_than_there_is_is_refused",
          "misuse_meshes.c:graded_elements_are_not_too_short", "crack_pressure_test.cpp:in_crossing_cracks_may_vanish"]),
}
NAMED = r"(?:TEST(?:_F|_P)?\(\w+, {0}\)|\bdef {0}\(|\bvoid {0}\(|\"{0}\":)"


def tests_below(root: pathlib.Path) -> dict[str, pathlib.Path]:
    return {file.name: file for kind in ("cpp", "c", "py", "json") for file in (root / "tests").rglob(f"*.{kind}")}


def fault(files: dict[str, pathlib.Path], programs: str, test: str) -> str:
    """What is wrong with the name of a test; empty if nothing."""
    name, _, case = test.partition(":")
    if name not in files:
        return f"there is no file {name} below tests"
    if not re.search(NAMED.format(re.escape(case)), files[name].read_text(encoding="utf-8")):
        return f"{name} has no test {case}"
    # Python's tests of the bindings are found by pytest, and the JSON file is read by a test of its own.
    listed = name.startswith("test_") or name.endswith(".json") or re.search(rf"\b{re.escape(pathlib.Path(name).stem)}\b", programs)
    return "" if listed else f"no CMake file of the tests lists {name}"


def main() -> int:
    root, quiet = pathlib.Path(sys.argv[1]).resolve(), "--quiet" in sys.argv
    files = tests_below(root)
    programs = "\n".join(file.read_text(encoding="utf-8") for pattern in ("*.cmake", "CMakeLists.txt")
                         for file in (root / "tests").rglob(pattern))
    wrong = [f"finding {number} has no test" for number, (_, tests) in WRONG.items() if not tests]
    wrong += [f"finding {number}: {found}" for number, (_, tests) in WRONG.items() for test in tests
              if (found := fault(files, programs, test))]
    if not quiet:
        print("finding | what was wrong | tests\n---|---|---")
        for number, (what, tests) in WRONG.items():
            print(f"{number} | {what} | {', '.join(tests)}")
    print("\n".join(wrong), end="\n" if wrong else "", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
