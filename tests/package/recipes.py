"""The recipes in packaging/ can be parsed, and agree with CMake: version, options, needs; what no test ran on says so.

    recipes.py ROOT
"""

import ast
import json
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
packaging = root / "packaging"
listfile = (root / "CMakeLists.txt").read_text(encoding="utf-8")
VERSION = re.search(r"project\(bempd VERSION (\S+)", listfile)[1]
CMAKE = re.search(r"cmake_minimum_required\(VERSION (\S+)\)", listfile)[1]
EIGEN = re.search(r"find_package\(Eigen3 (\S+)", (root / "src/CMakeLists.txt").read_text())[1]
KNOWN = set(re.findall(r"^\s*(?:option|set)\((BEMPD_\w+)", listfile + (root / "bindings/CMakeLists.txt").read_text(), re.MULTILINE))
CHOICES = re.search(r"BEMPD_LINALG PROPERTY STRINGS ([\w ]+)\)", listfile)[1].split()
# What every recipe has to decide, because the default of a top-level build is another one or changes what is linked.
DECIDED = {"BEMPD_LINALG", "BEMPD_SCHEME_PAPER", "BEMPD_BUILD_TESTS", "BEMPD_BUILD_EXAMPLES", "BEMPD_BUILD_BENCHMARKS",
           "BEMPD_BUILD_FORTRAN", "BEMPD_INSTALL"}
PYTHON = (root / "bindings/python/pyproject.toml").read_text()
faults = []


def expect(holds, *words):
    if not holds:
        faults.append(" ".join(map(str, words)))


def same_options(recipe, text):
    """Options of CMake that a recipe names."""
    named = set(re.findall(r"(?:-D|\b)(BEMPD_[A-Z_]+)\b", text)) - {"BEMPD_LIBRARY"}
    expect(named <= KNOWN, recipe, "names options that CMake does not have:", *sorted(named - KNOWN))
    expect(DECIDED <= named, recipe, "does not decide", *sorted(DECIDED - named))


def conda():
    text = (packaging / "conda-forge/meta.yaml").read_text(encoding="utf-8")
    scripts = "".join((packaging / "conda-forge" / name).read_text() for name in ("build_library.sh", "build_python.sh"))
    same_options("conda-forge", scripts)
    expect(re.search(r'set version = "(.*)"', text)[1] == VERSION, "conda-forge: the version is not", VERSION)
    expect(f"cmake >={CMAKE}" in text and f"eigen >={EIGEN}" in text, "conda-forge: needs cmake", CMAKE, "and eigen", EIGEN)
    for package in re.findall(r'"(\w+>=[\d.]+)"', re.search(r"^dependencies = (.*)$", PYTHON, re.MULTILINE)[1]):
        expect(package.replace(">=", " >=") in text, "conda-forge: the Python package needs", package)
    expect("skip: true  # [not linux]" in text, "conda-forge: builds where the library cannot be linked")
    config = (packaging / "conda-forge/conda_build_config.yaml").read_text()
    expect(re.findall(r"^  - (\w+)$", config, re.MULTILINE) == CHOICES, "conda-forge: linalg is not one of", *CHOICES)
    try:
        import jinja2
        import yaml
    except ImportError:
        print("conda-forge: not parsed as YAML, as python3-yaml or python3-jinja2 is not there")
        return
    for linalg in CHOICES:
        # Lines with another choice behind them are left out, as conda does.
        chosen = "\n".join(line for line in text.splitlines() if not (found := re.search(r'# \[linalg == "(\w+)"\]', line))
                           or found[1] == linalg)
        rendered = jinja2.Template(chosen).render(compiler=lambda kind: f"{kind}-compiler", linalg=linalg,
                                                  pin_subpackage=lambda name, **how: f"{name} {VERSION}")
        recipe = yaml.safe_load(rendered)
        expect(recipe["package"]["version"] == VERSION, "conda-forge: the parsed version is", recipe["package"]["version"])
        library, python = recipe["outputs"]
        expect((packaging / "conda-forge" / library["script"]).is_file() and (packaging / "conda-forge" / python["script"]).is_file(),
               "conda-forge: a script is missing")
        sparse = any(need.startswith("suitesparse") for need in library["requirements"]["host"])
        expect(sparse == (linalg == "suitesparse") and sparse == ("GPL" in recipe["about"]["license"]),
               "conda-forge:", linalg, "with", library["requirements"]["host"], recipe["about"]["license"])


def spack():
    text = (packaging / "spack/package.py").read_text(encoding="utf-8")
    (recipe,) = [node for node in ast.parse(text).body if isinstance(node, ast.ClassDef)]
    expect(recipe.name == "Bempd" and recipe.bases[0].id == "CMakePackage", "spack: the class is", recipe.name)
    calls = [node.value for node in recipe.body if isinstance(node, ast.Expr) and isinstance(node.value, ast.Call)]
    first = {name: [call.args[0].value for call in calls if call.func.id == name] for name in ("version", "variant", "depends_on", "conflicts")}
    expect(first["version"] == [VERSION], "spack: the versions are", *first["version"])
    expect({f"cmake@{CMAKE}:", f"eigen@{EIGEN}:3"} <= set(first["depends_on"]), "spack: needs cmake", CMAKE, "and eigen", EIGEN)
    values = next(ast.literal_eval(word.value) for call in calls if call.func.id == "variant" and call.args[0].value == "linalg"
                  for word in call.keywords if word.arg == "values")
    expect(list(values) == CHOICES, "spack: linalg is one of", *values)
    for variant in re.findall(r'define_from_variant\("BEMPD_\w+", "(\w+)"\)', text):
        expect(variant in first["variant"], "spack: there is no variant", variant)
    expect({"platform=darwin", "platform=windows"} <= set(first["conflicts"]), "spack: builds where the library cannot be linked")
    same_options("spack", text)


def vcpkg():
    port = json.loads((packaging / "vcpkg/bempd/vcpkg.json").read_text(encoding="utf-8"))
    portfile = (packaging / "vcpkg/bempd/portfile.cmake").read_text(encoding="utf-8")
    expect(port["name"] == "bempd" and port["version"] == VERSION, "vcpkg: the version is", port["version"])
    expect(port["supports"] == "linux", "vcpkg: builds where the library cannot be linked")
    needs = {need["name"]: need.get("version>=", "") for need in port["dependencies"] if isinstance(need, dict)}
    expect(needs["eigen3"].startswith(EIGEN), "vcpkg: needs eigen", EIGEN)
    expect(port["default-features"] == [CHOICES[0]], "vcpkg: the default is", port["default-features"])
    for feature in re.findall(r'"(\w+)" IN_LIST FEATURES', portfile) + re.findall(r"FEATURES (\w+) BEMPD_", portfile):
        expect(feature in port["features"], "vcpkg: there is no feature", feature)
    expect(set(re.findall(r"set\(linalg (\w+)\)", portfile)) == set(CHOICES), "vcpkg: linalg is not one of", *CHOICES)
    expect(portfile.count("(") == portfile.count(")"), "vcpkg: brackets of portfile.cmake do not match")
    same_options("vcpkg", portfile)


def platforms():
    page = (packaging / "README.md").read_text(encoding="utf-8")
    expect(f"bempd@{VERSION}" in page, "packaging/README.md: the version is not", VERSION)
    rows = re.findall(r"^\| (.*) \| (.*) \|$", page[page.index("| platform |"):page.index("Debian packages")], re.MULTILINE)[1:]
    for platform, state in rows:
        tested = platform == "Debian 12, x86_64, GCC 12 and clang 14"
        expect(tested == (state == "tested") and (tested or state.startswith(("not tested", "not supported"))), platform, "says", state)
    for file in packaging.rglob("*"):
        if file.suffix in (".py", ".json", ".cmake", ".sh") or file.name == "meta.yaml":
            expect("not tested" in file.read_text(encoding="utf-8"), file.relative_to(root), "does not say that it was not tested")


def needs():
    """Versions that README.md and docs/linking.md ask for are those that the recipes and the Python package ask for."""
    readme = (root / "README.md").read_text(encoding="utf-8")
    linking = (root / "docs/linking.md").read_text(encoding="utf-8")
    conda = (packaging / "conda-forge/meta.yaml").read_text(encoding="utf-8")
    python = re.search(r'requires-python = ">=(\S+)"', PYTHON)[1]
    asked = {"CMake": CMAKE, "Eigen": EIGEN, "SuiteSparse": re.search(r"suitesparse >=(\S+)", conda)[1], "Python": python,
             **dict(re.findall(r'"(\w+)>=([\d.]+)"', re.search(r"^dependencies = (.*)$", PYTHON, re.MULTILINE)[1]))}
    for name, version in asked.items():
        expect(f"{name} {version}" in readme, f"README.md does not ask for {name} {version}")
        expect(version in linking, f"docs/linking.md does not name {version}, which {name} needs")
    spack_text = (packaging / "spack/package.py").read_text(encoding="utf-8")
    expect(f"suite-sparse@{asked['SuiteSparse']}:" in spack_text, "spack: needs SuiteSparse", asked["SuiteSparse"])
    expect(f"python >={python}" in conda, "conda-forge: needs Python", python)


for check in (conda, spack, vcpkg, platforms, needs):
    check()
print("\n".join(faults) or f"recipes agree with CMake: version {VERSION}, {len(DECIDED)} options")
sys.exit(bool(faults))
