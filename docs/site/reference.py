"""Writes the reference pages: every function of the header with its comment, and how Fortran, Python and Rust spell it.

    reference.py ROOT TARGET

The header's sections become pages. A layer's spelling is found by what calls the C function in it, so that it cannot
differ from the code."""

from __future__ import annotations

import ast
import pathlib
import re
import sys
import textwrap

ROOT = pathlib.Path(sys.argv[1]).resolve()
sys.path.insert(0, str(ROOT / "bindings"))

from generator.comments import Comment  # noqa: E402
from generator.header import Declaration, Enumeration, Function, Structure, read_header  # noqa: E402

SECTION = re.compile(r"^/\* -{3,} (?P<title>[^-].*?) \*/$", re.MULTILINE)
CODE = re.compile(r"\b(bempd_\w+\(\)|BEMPD_[A-Z]\w*|[a-z_]+\.[a-z_]+(?= =|\b))")


# --------------------------------------------------------------------------- How other languages spell it

def fortran_spellings() -> dict[str, list[str]]:
    """Calls by C function: the interfaces of bempd.f90, and the bodies that call the function."""
    folder = ROOT / "bindings/fortran"
    text = (folder / "bempd.f90").read_text(encoding="utf-8")
    interfaces = {}
    for match in re.finditer(r"module (subroutine|function) (\w+)\((.*?)\)(?: result\((\w+)\))?\n(.*?)end \1 \2", text,
                             re.DOTALL):
        kind, name, arguments, result, body = match.groups()
        names = [one.strip() for one in re.sub(r"&\s*\n", "", arguments).split(",")]
        optional = {one.strip() for line in body.splitlines() if "optional" in line
                    for one in re.sub(r"\(.*?\)", "", line.split("::")[1]).split(",")}
        method = names[:1] == ["self"]
        shown = ", ".join(f"[{one}]" if one in optional else one for one in names[1 if method else 0:])
        spelled = {"set_option_number": "set_option", "set_option_text": "set_option", "get_option_number": "get_option",
                   "get_option_text": "get_option", "free_state": "free"}.get(name, name)
        owner = "state" if method and "class(bempd_state)" in body.split("self")[0] else "model"
        call = f"{owner}%{spelled}({shown})" if method else f"{spelled}({shown})"
        interfaces[name] = f"call {call}" if kind == "subroutine" else f"{result or name} = {call}"
    found: dict[str, list[str]] = {}
    for path in folder.glob("bempd_*.f90"):
        if path.name == "bempd_c.f90":
            continue
        for match in re.finditer(r"module procedure (\w+)\n(.*?)end procedure \1", path.read_text(encoding="utf-8"),
                                 re.DOTALL):
            if match[1] in interfaces:
                for function in set(re.findall(r"\b(bempd_\w+)\(", match[2])):
                    found.setdefault(function, []).append(interfaces[match[1]])
    return found


def signature(function: ast.FunctionDef) -> str:
    """Arguments as they are written, without types and without `self`."""
    given = function.args
    plain = [one.arg for one in given.posonlyargs + given.args]
    defaults = [None] * (len(plain) - len(given.defaults)) + list(given.defaults)
    shown = [name if value is None else f"{name}={ast.unparse(value)}" for name, value in zip(plain, defaults)
             if name not in ("self", "cls")]
    if given.kwonlyargs:
        shown.append("*")
        shown += [one.arg if value is None else f"{one.arg}={ast.unparse(value)}"
                  for one, value in zip(given.kwonlyargs, given.kw_defaults)]
    return f"({', '.join(shown)})"


def python_spellings() -> dict[str, list[str]]:
    """Public methods and properties by the C functions that their bodies name."""
    owners = {"State": "state", "Options": "model.options"}
    found: dict[str, list[str]] = {}
    for path in sorted((ROOT / "bindings/python/bempd").glob("*.py")):
        if path.name == "_cdef.py":
            continue
        tree = ast.parse(path.read_text(encoding="utf-8"))
        for owner in [tree, *(node for node in tree.body if isinstance(node, ast.ClassDef))]:
            for node in owner.body:
                if not isinstance(node, ast.FunctionDef) or node.name.startswith("_"):
                    continue
                decorators = {ast.unparse(one) for one in node.decorator_list}
                name = getattr(owner, "name", "")
                before = "bempd" if not name else owners.get(name, "bempd." + name if "classmethod" in decorators
                                                             else "model")
                shown = node.name if "property" in decorators else node.name + signature(node)
                named = [part.value if isinstance(part, ast.Constant) else getattr(part, "attr", None)
                         for part in ast.walk(node)]
                for function in [*named, f"bempd_{node.name}", f"bempd_get_{node.name}"]:
                    if isinstance(function, str) and re.fullmatch(r"bempd_\w+", function):
                        calls = found.setdefault(function, [])
                        if f"{before}.{shown}" not in calls:
                            calls.append(f"{before}.{shown}")
    return found


def rust_functions(path: pathlib.Path) -> list[tuple[str, str, str]]:
    """(name, signature, body) of the functions of a file."""
    text = re.sub(r"//[^\n]*", "", path.read_text(encoding="utf-8"))
    found = []
    for match in re.finditer(r"\n    (pub(?:\(crate\))? )?fn (\w+)(?:<[^>]*>)?(\([^{]*?)\{\n(.*?)\n    \}", text, re.DOTALL):
        public, name, shown, body = match.groups()
        found.append((name, f"{public or ''}fn {name}{' '.join(shown.split())}", body))
    return found


def rust_spellings() -> dict[str, list[str]]:
    """Public methods by the C functions that they call, through the private layer below them."""
    folder = ROOT / "bindings/rust/bempd/src"
    raw: dict[str, set[str]] = {}
    for path in (folder / "raw").glob("*.rs"):
        for name, _, body in rust_functions(path):
            raw.setdefault(name, set()).update(re.findall(r"\b(bempd_\w+)\b", body))
    found: dict[str, list[str]] = {}
    for path in sorted(folder.glob("*.rs")):
        for name, shown, body in rust_functions(path):
            if not shown.startswith("pub fn"):
                continue
            called = set(re.findall(r"\b(bempd_\w+)\b", body)) | {f"bempd_{name}", f"bempd_get_{name}"}
            for inner in re.findall(r"\.(\w+)\(", body):
                called |= raw.get(inner, set()) if inner == name or len(raw.get(inner, ())) == 1 else set()
            for function in called:
                text = shown.removeprefix("pub ").replace("( ", "(").replace(", )", ")")
                if text not in found.setdefault(function, []):
                    found[function].append(text)
    return found


# What is an object's life or a mapping there, and no call by that name.
OTHERWISE = {
    "Python": {"bempd_model_create": ["model = bempd.Model()"], "bempd_model_free": ["model.close()", "with bempd.Model() as model:"],
               "bempd_option_describe": ["model.options.describe(name)"], "bempd_set_option": ["model.options[name] = value"],
               "bempd_set_option_text": ["model.options[name] = word"], "bempd_get_option": ["model.options[name]"],
               "bempd_get_option_text": ["model.options[name]"]},
    "Rust": {"bempd_model_create": ["Model::new() -> Result<Model>"], "bempd_option_describe": ["options() -> Result<Vec<OptionInfo>>"],
             "bempd_option_count": ["options() -> Result<Vec<OptionInfo>>"], "bempd_version_string": ["version() -> &'static str"],
             "bempd_build_info": ["build_info() -> &'static str"], "bempd_get_singularity": ["fn singularities(&mut self) -> Result<Vec<Singularity>>"],
             "bempd_extension": ["fn extensions(&self) -> Result<Vec<Extension>>"], "bempd_state_to_bytes": ["fn to_bytes(&self) -> Result<Vec<u8>>"],
             "bempd_state_from_bytes": ["State::from_bytes(bytes: &[u8]) -> Result<State>"]},
}


# --------------------------------------------------------------------------- Pages

def marked(text: str) -> str:
    """Plain words of a comment as reST, with names of the interface as links."""
    text = text.replace("\\", "\\\\").replace("*", "\\*").replace("|", "\\|")
    text = re.sub(r"`(\w+)`", r"``\1``", text)
    text = re.sub(r"(?<![\w`:])(bempd_\w+)\(\)", r":c:func:`\1`", text)
    text = re.sub(r"(?<![\w`:])(bempd_\w+)\b(?!`)(?!\()", r":c:type:`\1`", text)
    text = re.sub(r"(?<![\w`:])(BEMPD_[A-Z][A-Z_0-9]*)\b(?!`)", r":c:enumerator:`\1`", text)
    return re.sub(r"(\w)_(?=[\s,.;:)]|$)", r"\1\\_", text)


def indented(lines: list[str], by: int = 3) -> list[str]:
    return [" " * by + line if line else "" for line in lines]


def words(comment: Comment | None) -> list[str]:
    if comment is None:
        return []
    lines: list[str] = []
    for paragraph in (comment.brief, *comment.details):
        lines += [marked(paragraph), ""]
    return lines


def c_text(function: Function) -> str:
    text = re.sub(r"^extern ", "", function.text).rstrip(";")
    return re.sub(r"\s+", " ", text)


def function_lines(function: Function, spellings: dict[str, dict[str, list[str]]]) -> list[str]:
    inner = words(function.comment)
    if function.comment:
        for name, note in function.comment.parameters.items():
            inner.append(f":param {name}: *{note.direction}* {marked(note.text)}")
        if function.comment.returns:
            inner.append(f":return: {marked(function.comment.returns)}")
        inner.append("")
    for language, calls in spellings.items():
        for call in calls.get(function.name, []):
            inner.append(f"| {language}: ``{call}``")
    if function.comment and function.comment.since:
        inner += ["", f"*Since {function.comment.since}.*"]
    if function.callback:
        return [f".. c:type:: {function.name}", "", *indented([f"``{c_text(function)}``", "", *inner]), ""]
    return [f".. c:function:: {c_text(function)}", "", *indented(inner), ""]


def members(one: Declaration) -> list[str]:
    lines: list[str] = []
    if isinstance(one, Structure):
        for member in one.members or []:
            shown = f"{'const ' if member.type.const else ''}{member.type.name}{'*' * member.type.pointers} {member.name}"
            lines += [f".. c:member:: {shown}", "", *indented(words(member.comment)), ""]
    elif isinstance(one, Enumeration):
        for value in one.values:
            lines += [f".. c:enumerator:: {value.name} = {value.value}", "", *indented(words(value.comment)), ""]
    return lines


def declaration_lines(one: Declaration, spellings: dict[str, dict[str, list[str]]]) -> list[str]:
    if isinstance(one, Function):
        return function_lines(one, spellings)
    kind = "enum" if isinstance(one, Enumeration) else "struct"
    since = [f"*Since {one.comment.since}.*", ""] if one.comment and one.comment.since else []
    return [f".. c:{kind}:: {one.name}", "", *indented([*words(one.comment), *since, *members(one)]), ""]


def heading(text: str, mark: str) -> list[str]:
    return [text, mark * len(text), ""]


def introduction(text: str) -> list[str]:
    """The comment of the file."""
    plain = re.search(r"/\*\*(.*?)\*/", text, re.DOTALL)[1]
    plain = re.sub(r"^ \* ?", "", plain, flags=re.MULTILINE)
    plain = re.sub(r"@file \S+|@brief ", "", plain).strip()
    lines: list[str] = []
    for paragraph in re.split(r"\n\s*\n", plain):
        one = marked(" ".join(paragraph.split()))
        lines += [re.sub(r"^([A-Z][\w ]{2,20})\. ", r"**\1.** ", one), ""]
    return lines


def main(target: pathlib.Path) -> None:
    path = ROOT / "include/bempd.h"
    text = path.read_text(encoding="utf-8")
    header = read_header(str(path), "include/bempd.h")
    starts = [(text.count("\n", 0, match.start()) + 1, match["title"].strip("- ")) for match in SECTION.finditer(text)]
    spellings = {"Fortran": fortran_spellings(), "Python": python_spellings(), "Rust": rust_spellings()}
    for language, calls in OTHERWISE.items():
        for function, shown in calls.items():
            spellings[language].setdefault(function, shown)
    target.mkdir(parents=True, exist_ok=True)
    pages = []
    for (first, title), (last, _) in zip(starts, [*starts[1:], (10**9, "")]):
        own = [one for one in header.declarations if first <= one.line < last]
        name = re.sub(r"\W+", "_", title.lower())
        lines = heading(title, "=")
        for one in own:
            lines += declaration_lines(one, spellings)
        (target / f"{name}.rst").write_text("\n".join(lines), encoding="utf-8")
        pages.append(name)
    index = heading("The interface", "=") + introduction(text) + textwrap.dedent("""\
        Each function stands with its calls in Fortran (module ``bempd``), Python (package ``bempd``, ``model`` is a
        ``bempd.Model``) and Rust (crate ``bempd``). Arguments in brackets may be left out. Rust's own pages are in
        `rust/bempd <../../rust/bempd/index.html>`__, those of Python in :doc:`/docs/python_reference`.

        .. toctree::
           :maxdepth: 1

        """).splitlines() + indented(pages)
    (target / "index.rst").write_text("\n".join(index) + "\n", encoding="utf-8")
    functions = [one.name for one in header.of(Function) if not one.callback]
    for language, calls in spellings.items():
        missing = [name for name in functions if name not in calls and not name.endswith("_init")]
        print(f"{language}: {len(functions) - len(missing)} of {len(functions)} functions; "
              f"inside others or not there: {', '.join(missing)}")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[2]))
