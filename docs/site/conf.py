# SPDX-License-Identifier: MIT
"""Sphinx' settings for the site; scripts/site.sh writes the pages and calls Sphinx."""
import os
import re
import sys
from pathlib import Path

root = Path(os.environ["POLYDEC_SOURCES"])
sys.path.insert(0, str(root / "docs/site"))
import markup

project = "polydec"
author = copyright = "the polydec developers"
version = release = re.search(r"project\(polydec VERSION ([0-9.]+)",
                              (root / "CMakeLists.txt").read_text()).group(1)
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon",
              "sphinx.ext.mathjax"]
myst_heading_anchors = 4
myst_enable_extensions = ["dollarmath"]
root_doc = "index"
primary_domain = "cpp"
highlight_language = "none"
# Fields without a comment of their own are explained by the text of their class.
autodoc_default_options = {"members": True, "member-order": "bysource"}
autodoc_typehints = "none"
napoleon_use_ivar = True

html_theme = "sphinx_rtd_theme"
html_title = f"polydec {version}"
html_theme_options = {"display_version": True, "navigation_depth": 3}
html_show_sphinx = False
html_static_path = [str(root / "docs/site/static"), os.environ["POLYDEC_SITE"] + "/static"]
# Only pages with formulas load it.
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_CHTML"
mathjax2_config = {"tex2jax": {"processClass": "math"}}
myst_update_mathjax = False  # it writes for MathJax 3
html_css_files = ["site.css"]
html_search_scorer = str(root / "docs/site/scorer.js")
# The address of a forge's editor, such as https://forge.example/polydec/edit/main/, adds a link.
html_context = {"edit_address": os.environ.get("POLYDEC_EDIT_ADDRESS", "")}
templates_path = [str(root / "docs/site/templates")]


def docstring(app, what, name, thing, options, lines):
    lines[:] = markup.docstring("\n".join(lines)).splitlines() + [""]


def skip(app, what, name, thing, skipped, options):
    """Fields of named tuples, whose texts Python writes."""
    return True if (getattr(thing, "__doc__", "") or "").startswith("Alias for field") else None


def setup(app):
    app.connect("autodoc-process-docstring", docstring, priority=1)
    app.connect("autodoc-skip-member", skip)
