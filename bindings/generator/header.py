"""A C header as declarations with their comments: preprocessed by the C compiler, parsed by pycparser."""

import os
import re
import subprocess
from dataclasses import dataclass, field

from pycparser import c_ast, c_generator, c_parser

from .comments import Comment, Parameter, read_comments

# The system's headers are not read: these are the names of theirs that a declaration may use, and some that rules.py
# refuses with a better sentence than the parser's.
_TYPES = "".join(f"typedef int {name};\n" for name in (
    "int8_t", "int16_t", "int32_t", "int64_t", "uint8_t", "uint16_t", "uint32_t", "uint64_t", "size_t", "ptrdiff_t",
    "bool"))


class Refusal(Exception):
    """Something that the header must not contain, with the line that contains it."""

    def __init__(self, line: int, sentence: str):
        super().__init__(sentence)
        self.line = line
        self.sentence = sentence


@dataclass
class Type:
    """`const double**` is name "double", pointers 2, const True (of what the last pointer points to)."""

    name: str
    pointers: int = 0
    const: bool = False


@dataclass
class Variable:
    """An argument of a function or a member of a struct."""

    name: str
    type: Type
    line: int
    note: Parameter | None = None
    comment: Comment | None = None


@dataclass
class Declaration:
    """Anything with a name; `line` is where it begins or where its name stands, `text` its C source."""

    name: str
    line: int
    text: str
    comment: Comment | None = field(default=None, kw_only=True)


@dataclass
class Function(Declaration):
    """A function, or the type of a callback."""

    returns: Type
    arguments: list[Variable]
    callback: bool


@dataclass
class Structure(Declaration):
    """A struct; `members` is None when only its name is known."""

    members: list[Variable] | None


@dataclass
class Constant:
    name: str
    value: int
    line: int
    comment: Comment | None = None


@dataclass
class Enumeration(Declaration):
    values: list[Constant]


@dataclass
class Header:
    path: str
    declarations: list[Declaration]

    def of(self, kind: type) -> list:
        return [one for one in self.declarations if isinstance(one, kind)]


def read_header(path: str, shown_path: str) -> Header:
    with open(path, encoding="utf-8") as file:
        text = file.read()
    tree = _parse(text, shown_path)
    declarations = [_declaration(node) for node in tree.ext if node.coord.file == shown_path]
    _attach(read_comments(text), declarations)
    return Header(shown_path, declarations)


def _parse(text: str, shown_path: str) -> c_ast.FileAST:
    without_includes = re.sub(r"^[ \t]*#[ \t]*include\b.*$", "", text, flags=re.MULTILINE)
    source = f'{_TYPES}# 1 "{shown_path}"\n{without_includes}'
    command = [os.environ.get("CC", "cc"), "-E", "-x", "c", "-std=c99", "-D__attribute__(x)=", "-"]
    run = subprocess.run(command, input=source, capture_output=True, text=True, check=False)
    if run.returncode != 0:
        line = re.search(rf"^{re.escape(shown_path)}:(\d+):(?:\d+:)? (?:fatal )?error: (.*)$", run.stderr, re.MULTILINE)
        raise Refusal(int(line[1]) if line else 1, line[2] if line else run.stderr.strip())
    try:
        return c_parser.CParser().parse(run.stdout, "<stdin>")
    except c_parser.ParseError as error:
        place = re.match(r"(?P<file>.*?):(?P<line>\d+):(?:\d+:)? (?P<what>.*)", str(error))
        raise Refusal(int(place["line"]) if place else 1,
                      f"this is not a C declaration ({place['what'] if place else error})") from error


def _declaration(node: c_ast.Node) -> Declaration:
    text = c_generator.CGenerator().visit(node) + ";"
    line = node.coord.line
    if isinstance(node, c_ast.Typedef):
        if isinstance(node.type, c_ast.PtrDecl) and isinstance(node.type.type, c_ast.FuncDecl):
            return _function(node.name, node.type.type, line, text, callback=True)
        inner = getattr(node.type, "type", None)
        if isinstance(inner, (c_ast.Struct, c_ast.Enum)):
            if inner.name != node.name:
                raise Refusal(inner.coord.line, f"the {_kind(inner)} of type {node.name} must have the same name; "
                                                f"it has {inner.name or 'none'}")
            return _aggregate(inner, text)
    elif isinstance(node, c_ast.Decl):
        if isinstance(node.type, c_ast.FuncDecl):
            return _function(node.name, node.type, line, text, callback=False)
        if isinstance(node.type, (c_ast.Struct, c_ast.Enum)):
            raise Refusal(line, f"{_kind(node.type)} {node.type.name or 'without a name'} must be declared by a "
                                "typedef of the same name")
    raise Refusal(line, "only functions and typedefs of structs, enums and function pointers have a binding")


def _kind(node: c_ast.Node) -> str:
    return "enum" if isinstance(node, c_ast.Enum) else "struct"


def _aggregate(node: c_ast.Node, text: str) -> Declaration:
    line = node.coord.line
    if isinstance(node, c_ast.Enum):
        if node.values is None:
            raise Refusal(line, f"enum {node.name} has no values")
        return Enumeration(node.name, line, text, [_constant(one) for one in node.values.enumerators])
    if node.decls is None:
        return Structure(node.name, line, text, None)
    return Structure(node.name, line, text, [_variable(one) for one in node.decls])


def _constant(node: c_ast.Enumerator) -> Constant:
    value, sign = node.value, 1
    if isinstance(value, c_ast.UnaryOp) and value.op == "-":
        value, sign = value.expr, -1
    if not isinstance(value, c_ast.Constant):
        raise Refusal(node.coord.line, f"enum value {node.name} needs an explicit number")
    return Constant(node.name, sign * int(value.value, 0), node.coord.line)


def _function(name: str, node: c_ast.FuncDecl, line: int, text: str, callback: bool) -> Function:
    parameters = node.args.params if node.args else []
    if len(parameters) == 1 and isinstance(parameters[0], c_ast.Typename):  # (void)
        parameters = []
    for one in parameters:
        if not isinstance(one, c_ast.Decl) or not one.name:
            raise Refusal(one.coord.line if one.coord else line, f"every argument of {name} needs a name")
    return Function(name, line, text, _type(node.type), [_variable(one) for one in parameters], callback)


def _variable(node: c_ast.Decl) -> Variable:
    return Variable(node.name, _type(node.type), node.coord.line)


def _type(node: c_ast.Node) -> Type:
    pointers = 0
    while isinstance(node, c_ast.PtrDecl):
        pointers, node = pointers + 1, node.type
    if not isinstance(node, c_ast.TypeDecl) or not isinstance(node.type, c_ast.IdentifierType):
        raise Refusal(node.coord.line, "only numbers, named types and pointers to them have a binding; an array is a "
                                       "pointer and a count")
    return Type(" ".join(node.type.names), pointers, "const" in node.quals)


def _attach(comments: list[Comment], declarations: list[Declaration]) -> None:
    """A comment belongs to what begins after it; one that begins with `/**<` to what stands before it on its line."""
    places: list = []
    for one in declarations:
        places.append(one)
        places += getattr(one, "members", None) or getattr(one, "values", [])
    places.sort(key=lambda place: place.line)
    previous = 0
    for place in places:
        for comment in comments:
            if comment.behind and comment.first == place.line or \
                    not comment.behind and previous <= comment.first and comment.last <= place.line:
                place.comment = comment
        previous = place.line
    for function in declarations:
        if isinstance(function, Function) and function.comment:
            for argument in function.arguments:
                argument.note = function.comment.parameters.get(argument.name)
