"""Copies what the site shows into a tree of its own: pages, pictures and sources that pages link to, at their places in
the repository, so that the links which work on a forge work on the site.

    stage.py ROOT TARGET
"""

from __future__ import annotations

import pathlib
import re
import shutil
import sys

from PIL import Image

LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s#]+)(#[^)\s]*)?\)")
PAGES = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", "docs/*.md", "docs/research/*.md", "examples/*/README.md",
         "benchmarks/*/README.md", "bindings/*/README.md", "packaging/README.md"]
BUILDS = ["docs/site", "bindings/python/bempd", "CMakeLists.txt"]
MATHJAX = pathlib.Path("/usr/share/javascript/mathjax")
MATHJAX_PARTS = ["MathJax.js", "config/TeX-MML-AM_CHTML.js", "config/TeX-AMS_CHTML.js", "extensions", "jax/input/TeX",
                 "jax/element", "jax/output/CommonHTML", "fonts/HTML-CSS/TeX/woff"]


def links(page: pathlib.Path) -> list[str]:
    """Targets of relative links, outside code."""
    text = re.sub(r"^```.*?^```", "", page.read_text(encoding="utf-8"), flags=re.DOTALL | re.MULTILINE)
    return [target for target, _ in LINK.findall(text) if not re.match(r"[a-z]+:", target)]


def copy(source: pathlib.Path, target: pathlib.Path) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    if source.is_dir():
        shutil.copytree(source, target, dirs_exist_ok=True, ignore=shutil.ignore_patterns("__pycache__", "*.so*"))
    else:
        shutil.copy2(source, target)


CHAPTERS = {
    "Learn": ["docs/first_path", "docs/tutorial", "docs/cookbook", "docs/cracks", "docs/mixed_cracks", "docs/fatigue", "docs/import",
              "docs/converge", "docs/coupling", "docs/checkpoints", "docs/ensembles", "docs/parallel_hosts", "docs/paraview", "docs/theory"],
    "Look up": ["README", "docs/troubleshooting", "docs/limits", "docs/glossary", "docs/units", "docs/options", "docs/linking"],
    "Languages": ["docs/languages", "docs/reference/index", "docs/python_reference", "docs/cpp", "bindings/python/README",
                  "bindings/fortran/README", "bindings/rust/README"],
    "Examples": ["examples/*/README"],
    "What is measured": ["docs/measured", "docs/accuracy", "docs/verification", "docs/directions", "docs/materials",
                         "docs/outlines", "docs/bodies", "docs/separation", "docs/paper"],
    "The project": ["CHANGELOG", "docs/citing", "CONTRIBUTING", "docs/architecture", "docs/scaling", "docs/reliability",
                    "packaging/README", "benchmarks/*/README", "docs/research/README"],
}
# Pages that only the site has; a comment in docs/languages.md stands for them.
REFERENCE = """## Reference

| language | reference |
|---|---|
| C | [every function of `bempd.h`, by topic](reference/index.rst), with its calls in Fortran, Python and Rust |
| Fortran | [the same pages](reference/index.rst), [the module](../bindings/fortran/README.md) |
| Python | [every class and method](python_reference.md) |
| Rust | <a href="../rust/bempd/index.html">the crate</a>, <a href="../rust/bempd_sys/index.html">the raw calls</a> |
| C++ | [`bempd.hpp`](cpp.md) |
"""
# Parts of wide pictures that the gallery shows: left, upper, right and lower bound as shares of width and height.
PARTS = {"centre_crack.png": (0.43, 0, 1, 1), "mixed_mode_crack.png": (0.43, 0, 1, 1)}
THUMBNAIL = (640, 352)  # pixels: twice the place of a picture in the gallery, for fine screens
PYTHON = """# Python reference

All of it can be imported from `bempd` itself, but for the pictures, which are in `bempd.plot`, and readers of drawings, which are in `bempd.outline`.

```{eval-rst}
.. automodule:: bempd.model

.. automodule:: bempd.state

.. automodule:: bempd.options

.. automodule:: bempd.callbacks

.. automodule:: bempd.reports

.. automodule:: bempd.errors

.. automodule:: bempd.convergence

.. automodule:: bempd.outline

.. automodule:: bempd.tables

.. automodule:: bempd.plot
```
"""


def contents(target: pathlib.Path) -> str:
    """What stands beside every page, by chapter; on a forge the pages' own links do that."""
    listed = {name for names in CHAPTERS.values() for name in names} | {"docs/index"}
    others = sorted(name for page in target.glob("docs/*.md") if (name := f"docs/{page.stem}") not in listed)
    titles = {"README": "Read me", "docs/languages": "Languages and reference", "docs/reference/index": "Reference: C, Fortran, Rust",
              "docs/cracks": "Cracks", "docs/mixed_cracks": "Cracks across regions", "docs/fatigue": "Fatigue", "docs/import": "Drawings and meshes",
              "docs/converge": "Convergence", "docs/coupling": "Coupling", "docs/measured": "What is measured"}
    text = ""
    for title, names in CHAPTERS.items():
        names = names + others if title == "What is measured" else names
        pages = [page for name in names for page in (sorted(str(found.relative_to(target))[:-3]
                 for found in target.glob(name + ".md")) if "*" in name else [name])]
        entries = (f"{titles[page]} </{page}>" if page in titles else f"/{page}" for page in pages)
        text += f"\n```{{toctree}}\n:hidden:\n:caption: {title}\n\n" + "\n".join(entries) + "\n```\n"
    return text


def shrink_gallery(target: pathlib.Path) -> None:
    """Gives the gallery pictures of the size at which it shows them."""
    index = target / "docs/index.md"
    text = index.read_text(encoding="utf-8")
    start, end = text.index("## Gallery"), text.index("## Pages")
    gallery = text[start:end]
    folder = target / "docs/thumbnails"
    folder.mkdir()
    for name in set(re.findall(r"!\[[^\]]*\]\(([\w.]+)\)", gallery)):
        with Image.open(target / "docs" / name) as picture:
            small = Image.new("RGBA", picture.size, "white")
            small.alpha_composite(picture.convert("RGBA"))
            shares = zip(PARTS.get(name, (0, 0, 1, 1)), 2 * picture.size)
            small = small.crop(tuple(round(share * pixels) for share, pixels in shares))
            small.thumbnail(THUMBNAIL, Image.LANCZOS)
            small.convert("RGB").quantize(128).save(folder / name, optimize=True)
    index.write_text(text[:start] + re.sub(r"(!\[[^\]]*\]\()([\w.]+\))", r"\1thumbnails/\2", gallery) + text[end:], encoding="utf-8")


def program_tabs(target: pathlib.Path) -> None:
    """Gives the page of languages the first program once, with a tab for each language. On a forge each has its section."""
    page, programs = target / "docs/languages.md", target / "examples/first_crack"
    text = page.read_text(encoding="utf-8")
    files = {"Python": "main.py", "C": "main.c", "Fortran": "main.f90", "Rust": "main.rs"}
    marks = [f'<input type="radio" name="language" id="tab-{name}"{" checked" if name == "Python" else ""}>'
             f'<label for="tab-{name}">{name}</label>' for name in files]
    panels = [f'```{{raw}} html\n<div class="panel">\n```\n\n```{name.lower()}\n{(programs / file).read_text(encoding="utf-8")}```\n\n'
              "```{raw} html\n</div>\n```\n" for name, file in files.items()]
    tabs = "\n".join(["```{raw} html", '<div class="tabs">', *marks, "```", "", *panels, "```{raw} html", "</div>", "```", ""])
    page.write_text(text[:text.index("## Fortran")] + "## The first program\n\n" + tabs, encoding="utf-8")


def give_title(page: pathlib.Path) -> None:
    """READMEs of examples begin with the sentence that lists show; a page needs a title."""
    text = page.read_text(encoding="utf-8")
    if not text.startswith("# "):
        page.write_text(f"# {page.parent.name.replace('_', ' ').capitalize()}\n\n{text}", encoding="utf-8")


def stage(root: pathlib.Path, target: pathlib.Path) -> None:
    shutil.rmtree(target, ignore_errors=True)
    pages = sorted({page for pattern in PAGES for page in root.glob(pattern)})
    for page in pages:
        copy(page, target / page.relative_to(root))
        for link in links(page):
            linked = (page.parent / link).resolve()
            if linked.is_file() and linked.suffix != ".md":
                copy(linked, target / linked.relative_to(root))
    for name in BUILDS:
        copy(root / name, target / name)
    for page in pages:
        give_title(target / page.relative_to(root))
    (target / "docs/python_reference.md").write_text(PYTHON, encoding="utf-8")
    shrink_gallery(target)
    for file in root.glob("examples/first_crack/main.*"):
        copy(file, target / file.relative_to(root))
    program_tabs(target)
    languages = target / "docs/languages.md"
    languages.write_text(languages.read_text(encoding="utf-8").replace("<!-- reference -->\n", REFERENCE), encoding="utf-8")
    with open(target / "docs/index.md", "a", encoding="utf-8") as index:
        index.write(contents(target))
    shutil.move(target / "docs/site/conf.py", target / "conf.py")
    for part in MATHJAX_PARTS:
        if (MATHJAX / part).exists():
            copy(MATHJAX / part, target / "docs/site/static/mathjax" / part)


if __name__ == "__main__":
    stage(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve())
