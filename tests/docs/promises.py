"""Which test holds each formula of docs/theory.md, and which tests call each function of the header. Prints both tables; fails
where a formula has no test, a test that is named does not exist, or no test of the C interface calls a function.

    promises.py ROOT [--quiet]
"""

from __future__ import annotations

import pathlib
import re
import sys

# Beginnings of displayed formulas, as docs/theory.md writes them: what they say, and the tests that fail when it is not so, as
# FILE or FILE:NAME of a case in it.
FORMULAS = {
    r"u(x) = \int_\Gamma U": ("Somigliana's identity", ["bem_interior_test:linear_field_is_exact_everywhere"]),
    r"V t = B u": ("symmetric Galerkin stiffness", ["bem_operator_test", "bem_patch_test"]),
    r"K_I^2 + K_{II}^2 = E' G": ("Irwin's relation", ["crack_factors_test"]),
    r"\theta = 2 \arctan": ("direction of the largest hoop stress", ["crack_kinks_test", "crack_growth_law_test"]),
    r"2 R\left(": ("energy of growth on the path of equilibrium", ["driven_cracks_test:release_their_fracture_energy_at_long_steps"]),
    r"f_{ij} = k_{ij}": ("force of a bond", ["coupling_terms_test", "pd_fields_test"]),
    r"c(\xi) = c_0": ("micromodulus", ["pd_lattice_test:BondKernel, has_the_elastic_constant"]),
    r"\sum_j k_{ij}": ("bonds that are exact for constant strain", ["pd_network_test", "pd_patch_test"]),
    r"s_c = \sqrt": ("critical stretch", ["pd_lattice_test:the_fracture_energy_that_it_says", "strength_test"]),
    r"\sigma_c = \sqrt": ("strength of a body without a crack", ["strength_test"]),
    r"K \leftarrow K - k": ("change of the matrix and energy of a break",
                            ["fracture_trial_energy_test:is_the_difference_of_the_energies",
                             "coupling_test:condensed_solution_equals_the_full_one_also_after_breaks"]),
}


def formulas(root: pathlib.Path) -> list[str]:
    return re.findall(r"^\$\$ (.*?) \$\$$", (root / "docs/theory.md").read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)


def has_test(root: pathlib.Path, test: str) -> bool:
    name, _, case = test.partition(":")
    files = [file for folder in ("unit", "physics") for file in (root / "tests" / folder).glob(f"{name}.cpp")]
    return bool(files) and case in files[0].read_text(encoding="utf-8")


def functions(root: pathlib.Path) -> list[str]:
    return re.findall(r"^BEMPD_API [^;(]*?\b(bempd_\w+)\(", (root / "include/bempd.h").read_text(encoding="utf-8"), re.MULTILINE)


def main() -> int:
    root, quiet = pathlib.Path(sys.argv[1]).resolve(), "--quiet" in sys.argv
    wrong, lines = [], ["formula of docs/theory.md | test", "---|---"]
    written = formulas(root)
    for formula in written:
        known = [key for key in FORMULAS if formula.startswith(key)]
        if not known:
            wrong.append(f"docs/theory.md: no test is named for the formula {formula[:60]}")
            continue
        what, tests = FORMULAS[known[0]]
        lines.append(f"{what} | {', '.join(tests)}")
        wrong += [f"there is no test {test}, named for {what}" for test in tests if not has_test(root, test)]
    wrong += [f"docs/theory.md has no formula that begins with {key}" for key in FORMULAS
              if not any(formula.startswith(key) for formula in written)]
    lines += ["", "function of include/bempd.h | tests of the C interface that call it", "---|---"]
    texts = {file.stem: file.read_text(encoding="utf-8") for file in sorted((root / "tests/capi").glob("*.[ch]"))}
    for function in functions(root):
        calls = [name for name, text in texts.items() if re.search(rf"\b{function}\(", text)]
        lines.append(f"{function} | {', '.join(calls)}")
        if not calls:
            wrong.append(f"no test in tests/capi calls {function}()")
    if not quiet:
        print("\n".join(lines))
    print("\n".join(wrong) or f"{len(written)} formulas and {len(functions(root))} functions have their tests")
    return int(bool(wrong))


if __name__ == "__main__":
    sys.exit(main())
