"""Every relative link in the pages of the repository leads to something that is there: files, pictures, headings. Sentences of
pages for users are short (sentences.py).

    links.py ROOT
"""

from __future__ import annotations

import pathlib
import re
import sys

import sentences

SKIPPED = {"build", "out", "target", ".git", "node_modules"}
CODE = re.compile(r"^(```|~~~).*?^\1|`[^`\n]+`", re.DOTALL | re.MULTILINE)
LINK = re.compile(r"\]\(\s*([^)\s]+)(?:\s+\"[^\"]*\")?\s*\)|(?:src|href)=\"([^\"]+)\"")


def anchors(text: str) -> set[str]:
    """Headings as forges and MyST name them."""
    found: set[str] = set()
    for title in re.findall(r"^#{1,6} +(.*?)\s*$", re.sub(r"^```.*?^```", "", text, flags=re.DOTALL | re.MULTILINE),
                            re.MULTILINE):
        plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", title).replace("`", "").lower()
        found.add(re.sub(r"[^\w\- ]", "", plain).replace(" ", "-"))
    return found | set(re.findall(r"^\(([\w-]+)\)=$", text, re.MULTILINE))


def faults(page: pathlib.Path, root: pathlib.Path) -> list[str]:
    text = page.read_text(encoding="utf-8")
    found = []
    for match in LINK.finditer(CODE.sub("", text)):
        target = match[1] or match[2]
        if re.match(r"[a-z][a-z+.-]*:", target):
            continue
        path, _, anchor = target.partition("#")
        linked = (page.parent / path).resolve() if path else page
        if not linked.exists():
            found.append(f"{page.relative_to(root)}: {target} leads to nothing")
        elif anchor and linked.suffix == ".md" and anchor not in anchors(linked.read_text(encoding="utf-8")):
            found.append(f"{page.relative_to(root)}: {target}: there is no such heading")
    return found


def main() -> int:
    root = pathlib.Path(sys.argv[1]).resolve()
    pages = [page for page in sorted(root.rglob("*.md"))
             if not any(part in SKIPPED or part.startswith("build") for part in page.relative_to(root).parts)]
    found = [fault for page in pages for fault in faults(page, root)]
    print("\n".join(found) or f"all links of {len(pages)} pages lead somewhere")
    return int(bool(found) or not pages) | sentences.main()


if __name__ == "__main__":
    sys.exit(main())
