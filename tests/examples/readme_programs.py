"""README.md and docs/languages.md show a first program in every language: each must be the file of examples/first_crack, must
run as it is printed, and all must print the line that tests/claims.json has. So must the smallest programs of
examples/crack_life.

    readme_programs.py SOURCE_FOLDER WORK_FOLDER LIBRARY C_COMPILER [--fortran COMPILER MODULES LIBRARY] [--rust CARGO]
"""

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

FILES = {"c": "main.c", "fortran": "main.f90", "python": "main.py", "rust": "main.rs"}
PAGES = {"c": "README.md", "python": "README.md", "fortran": "docs/languages.md", "rust": "docs/languages.md"}
RUST_PACKAGE = """[package]
name = "first"
version = "0.0.0"
edition = "2021"

[dependencies]
bempd = {{ path = "{crates}/bempd" }}

[workspace]
"""


def output_of(command, **environment):
    done = subprocess.run(command, env={**os.environ, **environment}, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{command} failed ({done.returncode}):\n{done.stdout}{done.stderr}")
    return done.stdout


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("source", type=Path)
    parser.add_argument("work", type=Path)
    parser.add_argument("library", type=Path)
    parser.add_argument("compiler")
    parser.add_argument("--fortran", nargs=3)
    parser.add_argument("--rust")
    arguments = parser.parse_args()
    source, work = arguments.source, arguments.work

    smallest = {language: (source / "examples/crack_life" / file.replace("main", "smallest")).read_text() for language, file in FILES.items()}
    programs = {}
    for language, file in FILES.items():
        page = (source / PAGES[language]).read_text()
        blocks = re.findall(rf"^```{language}\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
        shown = (source / "examples/first_crack" / file).read_text()
        if shown not in blocks:
            sys.exit(f"{PAGES[language]} does not show examples/first_crack/{file} as it is in a block of ```{language}")
        programs[language] = blocks[blocks.index(shown)]

    run(programs, "first_program", work / "first", arguments)
    run(smallest, "crack_life_program", work / "crack_life", arguments)


def run(programs, claim, work, arguments):
    """Runs one program in every language; all must print the line of a claim."""
    source, libraries = arguments.source, arguments.library.parent
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    for language, program in programs.items():
        (work / FILES[language]).write_text(program)
    link = [f"-L{libraries}", "-lbempd", f"-Wl,-rpath,{libraries}"]
    said = {}

    output_of([arguments.compiler, work / "main.c", f"-I{source}/include", *link, "-o", work / "in_c"])
    said["c"] = output_of([work / "in_c"])
    try:
        import cffi  # noqa: F401
    except ImportError:
        print("python left out: it has no cffi")
    else:
        said["python"] = output_of([sys.executable, work / "main.py"], BEMPD_LIBRARY=str(arguments.library),
                                   PYTHONPATH=str(source / "bindings/python"), PYTHONDONTWRITEBYTECODE="1")
    if arguments.fortran:
        compiler, modules, fortran_library = arguments.fortran
        output_of([compiler, work / "main.f90", f"-I{modules}", fortran_library, *link, "-o", work / "in_fortran"])
        said["fortran"] = output_of([work / "in_fortran"])
    if arguments.rust:
        (work / "src").mkdir()
        (work / "main.rs").rename(work / "src/main.rs")
        (work / "Cargo.toml").write_text(RUST_PACKAGE.format(crates=source / "bindings/rust"))
        said["rust"] = output_of([arguments.rust, "run", "--quiet", "--offline", f"--manifest-path={work}/Cargo.toml"],
                                 CARGO_TARGET_DIR=str(work.parent / "target"), BEMPD_LIB_DIR=str(libraries), LD_LIBRARY_PATH=str(libraries))

    for language, line in said.items():
        print(f"{language:8} {line}", end="")
    claimed = json.loads((arguments.source / "tests/claims.json").read_text())["claims"][claim]["claimed"]
    if set(said.values()) != {claimed + "\n"}:
        sys.exit(f"every program must print what is claimed:\n         {claimed}")


main()
