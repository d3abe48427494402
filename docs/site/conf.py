"""Sphinx configuration of the site; docs/build.sh runs it on a copy of the tree (stage.py)."""

import pathlib
import re

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

# Formulas are drawn without the network: Debian's MathJax, which the build copies.
mathjax_path = "mathjax/tex-chtml.js"

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
