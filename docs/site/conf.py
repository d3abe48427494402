"""Sphinx configuration of the site; docs/build.sh runs it on a copy of the tree (stage.py)."""

import pathlib
import re

# A line that only a module may have; Debian's furo.js begins with it.
IMPORT = re.compile(r'^import (\w+) from "\./([\w.-]+)";\n', re.MULTILINE)

HERE = pathlib.Path(__file__).resolve().parent

project = "bempd"
author = "the authors of bempd"
copyright = author  # noqa: A001 (the name is Sphinx's)
version = release = re.search(r"project\(bempd\s+VERSION (\S+)", (HERE / "CMakeLists.txt").read_text()).group(1)

extensions = ["myst_parser", "sphinx_copybutton", "sphinx.ext.autodoc", "sphinx.ext.mathjax"]
master_doc = "docs/index"
exclude_patterns = ["docs/site"]
primary_domain = "c"
highlight_language = "none"

myst_enable_extensions = ["dollarmath", "colon_fence", "deflist"]
myst_heading_anchors = 4
suppress_warnings = ["myst.header"]  # READMEs of examples begin with a sentence

autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_default_options = {"members": True, "inherited-members": True, "show-inheritance": False}

add_module_names = False


def as_rest(paragraph: list[str]) -> list[str]:
    """A paragraph of a docstring, which is plain text: code and columns as they stand, the rest with its signs kept."""
    if paragraph[0].lstrip().startswith(">>>"):
        return paragraph
    if any(re.search(r"\S {2,}\S", line) or line.startswith("    ") for line in paragraph):
        return ["::", "", *("    " + line for line in paragraph)]
    text = "\n".join(paragraph)
    parts = re.split(r"(`[^`]+`)", text)
    kept = [f"``{part[1:-1]}``" if part.startswith("`") and part.endswith("`") and len(part) > 2
            else re.sub(r"([*|]|_(?=\W|$)|`)", r"\\\1", part) for part in parts]
    return "".join(kept).split("\n")


def docstring(app, what, name, thing, options, lines):
    """Docstrings are written to be read in a terminal."""
    result, paragraph = [], []
    for line in [*lines, ""]:
        if line.strip():
            paragraph.append(line)
        elif paragraph:
            result += [*as_rest(paragraph), ""]
            paragraph = []
    lines[:] = result


def join_theme_script(app, exception):
    """Debian ships the theme's script unbundled: as a module, without the theme button and the marks of the contents in a plain
    <script>. A module is not loaded from a file of a disk either, so script and import become one plain script."""
    script = pathlib.Path(app.outdir) / "_static/scripts/furo.js"
    if exception or not script.exists():
        return
    text = script.read_text(encoding="utf-8")
    imported = [(script.parent / name).read_text(encoding="utf-8") for _, name in IMPORT.findall(text)]
    if imported:
        joined = "".join(f"{one}\n" for one in imported) + "(() => {\n" + IMPORT.sub("", text) + "})();\n"
        script.write_text(joined, encoding="utf-8")


def setup(app):
    app.connect("autodoc-process-docstring", docstring)
    app.connect("build-finished", join_theme_script)


# Formulas are drawn without the network, by Debian's MathJax 2, which stage.py copies.
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_CHTML"
mathjax2_config = {"messageStyle": "none", "showMathMenu": False}
myst_update_mathjax = False  # what it writes is for version 3

html_theme = "furo"
html_title = f"bempd {release}"
html_static_path = ["docs/site/static"]
html_css_files = ["bempd.css"]
html_copy_source = False
html_show_sphinx = False
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#1f4e79", "color-brand-content": "#1f4e79"},
    "dark_css_variables": {"color-brand-primary": "#8ab8e0", "color-brand-content": "#8ab8e0"},
}
