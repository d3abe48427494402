"""What the header must say so that bindings can be written from it; see also the header's own comment."""

import re

from .header import Declaration, Enumeration, Function, Header, Refusal, Structure, Variable

_NUMBERS = {"double", "int32_t", "int64_t"}
_BYTES = {"char", "uint8_t"}
_DIRECTIONS = {"in", "out", "in,out"}


def check(header: Header) -> list[Refusal]:
    """All that is wrong with a header, in the order of its lines."""
    known = {one.name for one in header.declarations}
    result: list[Refusal] = []
    for one in header.declarations:
        if not one.comment or not one.comment.brief:
            result.append(Refusal(one.line, f"{one.name} has no comment above it that starts with @brief"))
            continue
        if not one.comment.since:
            result.append(Refusal(one.line, f"the comment of {one.name} lacks @since"))
        if isinstance(one, Function):
            result += _check_function(one, known)
        elif isinstance(one, Structure):
            for member in one.members or []:
                result += _check_type(one, member, known)
                if not member.comment:
                    result.append(Refusal(member.line, f"member {member.name} of {one.name} has no comment"))
    return sorted(result + _check_names(header), key=lambda refusal: refusal.line)


def _check_function(function: Function, known: set[str]) -> list[Refusal]:
    result = []
    for argument in function.arguments:
        result += _check_type(function, argument, known) or _check_words(function, argument)
    names = {argument.name for argument in function.arguments}
    for name in function.comment.parameters:
        if name not in names:
            result.append(Refusal(function.line, f"the comment of {function.name} describes '{name}', which is not one "
                                                 "of its arguments"))
    returned = function.returns
    text = returned.name == "char" and returned.pointers == 1 and returned.const
    if not text and (returned.pointers or returned.name not in known | _NUMBERS | {"void"}):
        result.append(Refusal(function.line, f"{function.name} must return a status, a number, nothing or a constant "
                                             "string"))
    if returned.name != "void" and not function.comment.returns:
        result.append(Refusal(function.line, f"the comment of {function.name} lacks @return"))
    return result


def _check_type(owner: Declaration, variable: Variable, known: set[str]) -> list[Refusal]:
    kind = variable.type
    allowed = known | _NUMBERS | (_BYTES | {"void"} if kind.pointers else set())
    if kind.name in allowed:
        return []
    shown = kind.name + "*" * kind.pointers
    return [Refusal(variable.line, f"'{variable.name}' of {owner.name} has type {shown}, which not every language has; "
                                   "use int32_t, int64_t or double, and char or uint8_t behind a pointer only")]


def _check_words(function: Function, argument: Variable) -> list[Refusal]:
    def refuse(sentence: str) -> list[Refusal]:
        return [Refusal(argument.line, f"argument '{argument.name}' of {function.name} {sentence}")]

    note = argument.note
    if note is None or note.direction not in _DIRECTIONS:
        return refuse("needs @param[in], @param[out] or @param[in,out]")
    if argument.type.pointers == 0:
        return [] if note.direction == "in" else refuse("is a value, so its @param must say [in]")
    if argument.type.pointers == 1 and argument.type.const and note.direction != "in":
        return refuse("points to constants, so its @param must say [in]")
    if _is_array(function, argument) and not note.shape:
        return refuse("is an array and its @param lacks the word shape with the extents, such as shape [count][2]")
    if _may_be_null(function, argument) and not note.nullable:
        return refuse("may be NULL and its @param does not say so")
    return []


def _is_array(function: Function, argument: Variable) -> bool:
    """Whether the types alone show an array: inputs by pointer, bytes, and what goes with a size; never a count."""
    kind = argument.type
    if argument.note.shape:
        return True
    if kind.name == "int64_t" or kind.name not in _NUMBERS | _BYTES:
        return False
    if kind.pointers == 2:
        return True
    if kind.name == "char":
        return not kind.const
    # A function with a count may give one id back; one with a capacity fills arrays.
    sizes = {"capacity"} if kind.name == "int32_t" else {"count", "capacity", "size"}
    sized = any(one.name in sizes and one.type.pointers == 0 for one in function.arguments)
    return kind.const or kind.name == "uint8_t" or sized


def _may_be_null(function: Function, argument: Variable) -> bool:
    """Whether NULL must be legal: what is freed, what the library only hands on, a buffer whose capacity may be 0."""
    if function.name.endswith("_free"):
        return True
    if argument.type.name == "void":
        return not function.callback
    return argument.type.name in _BYTES and not argument.type.const


def _check_names(header: Header) -> list[Refusal]:
    """Prefix, and names that only differ in case, which Fortran cannot tell apart."""
    result, seen = [], {}
    for one in header.declarations:
        names = [(one.name, one.line)]
        if isinstance(one, Enumeration):
            names += [(value.name, value.line) for value in one.values]
        for name, line in names:
            if not re.match(r"bempd_|BEMPD_", name):
                result.append(Refusal(line, f"{name} needs the prefix bempd_"))
            if name.lower() in seen:
                result.append(Refusal(line, f"{name} and {seen[name.lower()]} are the same name in Fortran"))
            seen[name.lower()] = name
    return result
