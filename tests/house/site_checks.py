# SPDX-License-Identifier: MIT
"""Builds the site of the documentation with warnings as errors, and checks it: every relative link
and anchor leads somewhere, every public name has an entry, the search finds words of pages, C++ and
Python, and no page loads anything from other machines.

Usage: site_checks.py ROOT PYTHON_FOLDER [HEADERS]... (files that list headers).
Exit code: 0 whole, 1 not, 77 without Sphinx, doxygen or MathJax.
"""
import importlib.util
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

import sources

WORDS = {"circumspher": "README", "cospher": "docs/cospherical", "codifferenti": "docs/operators",
         "geodes": "docs/geodesics", "checkpoint": "docs/in_time", "hodgestar": "cpp/",
         "read_mesh": "cpp/", "mergedcel": "cpp/", "shape_spectrum": "python",
         "goldberg": "python"}


class Page(HTMLParser):
    """Anchors of a page, what it links to and what it loads."""

    def __init__(self, text):
        super().__init__()
        self.anchors, self.links, self.loads = {""}, [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.anchors |= {attributes[key] for key in ("id", "name") if attributes.get(key)}
        if tag == "a" and attributes.get("href"):
            self.links.append(attributes["href"])
        if attributes.get("src"):
            self.loads.append(attributes["src"])
        if tag == "link" and attributes.get("href"):
            self.loads.append(attributes["href"])


def outside(address):
    return address.startswith("//") or urlsplit(address).scheme in ("http", "https")


def lost_links(html):
    """Links and files that are not there, and files that a browser would load from elsewhere."""
    pages = {path.resolve(): Page(path.read_text()) for path in html.rglob("*.html")}
    complaints = []
    for path, page in pages.items():
        name = path.relative_to(html)
        complaints += [f"{name}: loads {address}" for address in page.loads if outside(address)]
        for address in page.links + page.loads:
            parts = urlsplit(address)
            if parts.scheme or address.startswith("//"):
                continue
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            if not target.is_file():
                complaints.append(f"{name}: {address} is not there")
            elif target in pages and unquote(parts.fragment) not in pages[target].anchors:
                complaints.append(f"{name}: {address} has no such anchor")
    for sheet in html.rglob("*.css"):
        complaints += [f"{sheet.relative_to(html)}: loads {address}" for address in
                       re.findall(r"url\(['\"]?([^'\")]+)", sheet.read_text()) if outside(address)]
    return complaints


def missing_entries(html, names, headers):
    python = Page((html / "python.html").read_text()).anchors
    complaints = [f"python.html: no entry for {name}" for name in names
                  if f"polydec.{name}" not in python and f"module-polydec.{name}" not in python]
    pages = "".join(path.read_text() for path in (html / "cpp").glob("*.html"))
    return complaints + [f"cpp: no entry for {header}" for header in headers
                         if f">{header}<" not in pages]


def unknown_words(html):
    """Words that the search does not find on the page where they belong."""
    text = (html / "searchindex.js").read_text()
    index = json.loads(text[text.index("(") + 1:text.rindex(")")])
    complaints = []
    for word, page in WORDS.items():
        found = []
        for terms in (index["terms"], index["titleterms"]):
            numbers = terms.get(word, [])
            found += [numbers] if isinstance(numbers, int) else numbers
        if not any(index["docnames"][i].startswith(page) for i in found):
            complaints.append(f"searchindex.js: {word} is not found on {page}")
    return complaints


def main(root, python, listings):
    absent = [name for name in ("sphinx", "myst_parser", "sphinx_rtd_theme", "numpy")
              if not importlib.util.find_spec(name)]
    absent += [] if shutil.which("doxygen") else ["doxygen"]
    absent += [] if Path("/usr/share/javascript/mathjax").is_dir() else ["MathJax"]
    if absent or not (Path(python) / "polydec/__init__.py").is_file():
        print(f"Skipped: the site needs {', '.join(absent) or 'the package polydec'}.")
        return 77
    headers = sorted(set().union(*(sources.public_headers(root, listing) for listing in listings)))
    environment = os.environ | {"PYTHONPATH": python, "PYTHON": sys.executable,
                                "PYTHONDONTWRITEBYTECODE": "1"}
    names = subprocess.run([sys.executable, "-c", "import polydec; print(*polydec.__all__)"],
                           env=environment, check=True, capture_output=True, text=True).stdout
    with tempfile.TemporaryDirectory() as folder:
        built = subprocess.run(["sh", Path(root) / "scripts/site.sh", folder], env=environment)
        if built.returncode:
            return 1
        html = (Path(folder) / "html").resolve()
        return sources.report(lost_links(html) + missing_entries(html, names.split(), headers)
                              + unknown_words(html), "The site is whole.")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], sys.argv[2], sys.argv[3:]))
