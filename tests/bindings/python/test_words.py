"""Sentences speak to Python users: no name of a C function, constant or type is left in them."""

import ast
import importlib
import pathlib
import re

import bempd
import pytest
from bempd import _words

ROOT = pathlib.Path(__file__).resolve().parents[3]


def functions_of(header):
    text = (ROOT / "include" / header).read_text("utf-8")
    return re.findall(r"^BEMPD_API [^(;]*?\b(bempd_\w+)\(", text, re.MULTILINE)


FUNCTIONS = functions_of("bempd.h")
C_NAME = re.compile(r"(?i)\bbempd_\w+")


def sentences():
    """Strings in the engine's sources that name something of the C interface, neighbouring literals joined."""
    for path in sorted((ROOT / "src").rglob("*.[ch]pp")):
        text = re.sub(r"^#.*$|//.*$", "", path.read_text("utf-8"), flags=re.MULTILINE)
        for literals in re.findall(r'"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*', text):
            sentence = "".join(re.findall(r'"((?:[^"\\\n]|\\.)*)"', literals))
            if C_NAME.search(sentence) and not re.fullmatch(r"BEMPD_(OK|ERROR_[A-Z]+|TEST_HOOKS)", sentence):
                yield sentence


def resolve(name):
    found = bempd
    if name.startswith("mpi."):  # a module that is imported apart, where there is mpi4py
        pytest.importorskip("mpi4py")
        importlib.import_module("bempd.mpi")
    for part in name.split("."):
        found = getattr(found, part)
    return found


@pytest.mark.parametrize("function", FUNCTIONS)
def test_every_function_of_the_header_has_a_name_here(function):
    if function not in ("bempd_last_error", "bempd_status_name", "bempd_state_free", "bempd_history"):
        resolve(_words.name_of(function))


def test_no_sentence_of_the_engine_names_c():
    found = list(sentences())
    assert len(found) > 10
    for sentence in found:
        for name in re.findall(r"\bbempd_\w+(?=\()", sentence):
            assert name in FUNCTIONS + functions_of("bempd_mpi.h"), sentence
        assert not C_NAME.search(_words.in_python(sentence)), sentence


def test_errors_log_and_options_speak_python():
    model = bempd.Model()
    with pytest.raises(bempd.OrderError, match=r"^save: there is no state yet; call Model.prepare\(\) or step first$"):
        model.save()
    glass = model.add_material(young_modulus=1, poisson_ratio=1 / 3)
    model.add_pd_region(glass, bempd.rectangle(0, 0, 4, 4), 1.0)
    with pytest.raises(bempd.UnsolvableError, match=r"^step: .*Model.fix_point\(\)"):
        model.step(1)
    with pytest.raises(bempd.ArgumentError, match="at most 31 bits"):
        model.fix_edge(2**31, 1)
    for info in bempd.describe_options().values():
        assert not C_NAME.search(info.summary)


def test_modules_import_each_other_in_no_circle():
    package = pathlib.Path(bempd.__file__).parent
    imports = {}
    for path in package.glob("*.py"):
        imports[path.stem] = set()
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.ImportFrom) and node.level == 1:
                imports[path.stem] |= {node.module} if node.module else {name.name for name in node.names}
    imports.pop("__init__")
    while imports:
        leaves = {name for name, needed in imports.items() if not needed & set(imports)}
        assert leaves, f"a circle among {sorted(imports)}"
        for name in leaves:
            del imports[name]
