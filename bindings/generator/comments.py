"""The comments of a C header: where they stand and what their Doxygen words say."""

import re
import textwrap
from dataclasses import dataclass, field

_COMMENT = re.compile(r"/\*\*(?P<behind><)?(?P<text>.*?)\*/", re.DOTALL)
_WORD = re.compile(r"@(brief|param|return|since)\b")
_PARAMETER = re.compile(r"(?:\[(?P<direction>[a-z,]+)\])?\s*(?P<name>\w+)\s*(?P<text>.*)", re.DOTALL)
_SHAPE = re.compile(r"\bshape ((?:\[[^\]]+\])+)")


@dataclass
class Parameter:
    """What a comment says of one argument."""

    direction: str
    text: str

    @property
    def shape(self) -> list[str]:
        """The extents that follow the word "shape"; only "..." when it depends on something which shape it is."""
        found = _SHAPE.search(self.text)
        if not found:
            return []
        others = _SHAPE.pattern.replace("shape ", "")
        if re.search(r", " + others.removeprefix(r"\b"), self.text[found.end():]):
            return ["..."]
        return re.findall(r"\[([^\]]+)\]", found.group(1))

    @property
    def nullable(self) -> bool:
        return re.search(r"\bNULL\b", self.text) is not None


@dataclass
class Comment:
    """A comment taken to pieces; `first` and `last` are its lines in the header."""

    first: int
    last: int
    behind: bool
    brief: str = ""
    details: list[str] = field(default_factory=list)
    parameters: dict[str, Parameter] = field(default_factory=dict)
    returns: str = ""
    since: str = ""

    def lines(self, width: int) -> list[str]:
        """The comment in plain words, wrapped; an empty line between paragraphs and before the facts."""
        facts = [f"{name} [{one.direction}]: {one.text}" for name, one in self.parameters.items()]
        facts += [f"{word}: {text}" for word, text in (("return", self.returns), ("since", self.since)) if text]
        result: list[str] = []
        for paragraph in (self.brief, *self.details):
            result += ["", *_wrap(paragraph, width)] if result else _wrap(paragraph, width)
        if facts and result:
            result.append("")
        for fact in facts:
            result += _wrap(fact, width, "  ")
        return result


def read_comments(text: str) -> list[Comment]:
    """All documentation comments of a header, in order, without the one that describes the file."""
    result = []
    for match in _COMMENT.finditer(text):
        first = text.count("\n", 0, match.start()) + 1
        comment = Comment(first, first + match.group().count("\n"), match.group("behind") is not None)
        plain = "\n".join(re.sub(r"^\s*\*? ?", "", line) for line in match.group("text").split("\n"))
        if "@file" not in plain:
            _take_to_pieces(plain.strip(), comment)
            result.append(comment)
    return result


def _wrap(text: str, width: int, indent: str = "") -> list[str]:
    return textwrap.wrap(text, width, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False)


def _one_line(text: str) -> str:
    return " ".join(text.split())


def _take_to_pieces(plain: str, comment: Comment) -> None:
    pieces = _WORD.split(plain)
    _describe(pieces[0], comment)
    for word, text in zip(pieces[1::2], pieces[2::2]):
        if word == "brief":
            _describe(text, comment)
        elif word == "since":
            version, _, rest = text.strip().partition("\n")
            comment.since = _one_line(version)
            _describe(rest, comment)
        elif word == "return":
            comment.returns = _one_line(text)
        else:
            parameter = _PARAMETER.match(text)
            if parameter:
                comment.parameters[parameter["name"]] = Parameter(parameter["direction"] or "",
                                                                  _one_line(parameter["text"]))


def _describe(text: str, comment: Comment) -> None:
    paragraphs = [_one_line(one) for one in re.split(r"\n\s*\n", text) if one.strip()]
    if paragraphs and not comment.brief:
        comment.brief = paragraphs.pop(0)
    comment.details += paragraphs
