# SPDX-License-Identifier: MIT
"""Builds the site of the documentation with warnings as errors, and checks it: every relative link
and anchor leads somewhere, every public name has an entry with text, notebooks and the gallery show
their pictures, no page loads anything from other machines; and in a browser what site_browser.py
names.

Usage: site_checks.py ROOT PYTHON_FOLDER [HEADERS]... (files that list headers).
Exit code: 0 whole, 1 not, 77 without Sphinx, doxygen, MathJax or a browser.
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

import site_browser
import sources

EDIT = "https://forge.example/edit/"
# Public names, and what each class has of its own: its members and annotated fields.
NAMES = """
import json, polydec, polydec.meshes as meshes
def own(thing):
    fields = {**vars(thing), **vars(thing).get("__annotations__", {})} if isinstance(thing, type) else {}
    return sorted(name for name in fields if not name.startswith("_"))
found = {f"polydec.{name}": own(getattr(polydec, name)) for name in polydec.__all__ if name != "meshes"}
print(json.dumps(found | {f"polydec.meshes.{name}": [] for name in meshes.__all__
                          if name not in polydec.__all__}))
"""


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


class Entries(HTMLParser):
    """The text of each entry of an interface by its anchor, without the entries within."""

    def __init__(self, text):
        super().__init__()
        self.texts, self.around = {}, []  # the lists around: anchors and whether their text began
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        entry = self.around[-1] if self.around else None
        if tag == "dl":
            is_entry = re.match(r"(py|cpp) ", attributes.get("class") or "")
            self.around.append([[], False] if is_entry else None)
        elif tag == "dt" and entry:
            if entry[1]:
                entry = self.around[-1] = [[], False]
            if "id" in attributes:
                entry[0].append(attributes["id"])
                self.texts[attributes["id"]] = ""
        elif tag == "dd" and entry:
            entry[1] = True

    def handle_endtag(self, tag):
        if tag == "dl":
            self.around.pop()

    def handle_data(self, data):
        anchors, has_begun = next((each for each in reversed(self.around) if each), ([], False))
        for anchor in anchors if has_begun else []:
            self.texts[anchor] += data


def missing_entries(html, names, headers):
    """Public names and headers without an entry, entries without text, fields that none explains."""
    texts, complaints = Entries((html / "python.html").read_text()).texts, []
    for name, fields in names.items():
        if not texts.get(name, "").strip():
            complaints.append(f"python.html: no text for {name}")
        complaints += [f"python.html: no text for {name}.{field}" for field in fields
                       if not texts.get(f"{name}.{field}", "").strip()
                       and not re.search(rf"\b{field}\b", texts.get(name, ""))]
    sections = {}
    for path in (html / "cpp").glob("*.html"):
        for section in path.read_text().split("<h2>")[1:]:
            words = [re.sub("<[^>]*>", "", part)
                     for part in re.findall(r"<p>(.*?)</p>", section, re.DOTALL)]
            sections[section[:section.index("<")]] = [
                part for part in words if part.strip() and not part.startswith("#include")]
    return complaints + [f"cpp: no text for {header}" for header in headers
                         if not sections.get(header)]


def missing_parts(html, root):
    """Pages without the pictures, the version or the links that they must have."""
    complaints, project = [], (root / "CMakeLists.txt").read_text()
    version = re.search(r"project\(polydec VERSION ([0-9.]+)", project).group(1)
    for path in sorted(html.rglob("*.html")):
        name, text = path.relative_to(html).as_posix(), path.read_text()
        if name.startswith("_static"):
            continue
        if f'<div class="version">\n                {version}' not in text:
            complaints.append(f"{name}: no version {version}")
        if ">Cite</a>" not in text and name not in ("search.html", "genindex.html"):
            complaints.append(f"{name}: no link to cite")
        if name.startswith("docs/") and EDIT + name.replace(".html", ".md") not in text:
            complaints.append(f"{name}: no link to edit")
        wanted = 2 if name.endswith(".ipynb.html") else 0
        if name == "docs/gallery.html":
            wanted = (root / "docs/gallery.md").read_text().count("![")
        if text.count("/_images/") < wanted:
            complaints.append(f"{name}: {text.count('/_images/')} pictures instead of {wanted}")
    notebooks = {path.name for path in (root / "python/notebooks").glob("*.ipynb")}
    return complaints + [f"python/notebooks/{name}.html is not there" for name in sorted(notebooks)
                         if not (html / "python/notebooks" / f"{name}.html").is_file()]


def complaints_about(html, root, names, headers):
    return (lost_links(html) + missing_entries(html, names, headers) + missing_parts(html, root)
            + site_browser.complaints_about(html))


def main(root, python, listings):
    absent = [name for name in ("sphinx", "myst_parser", "sphinx_rtd_theme", "numpy", "nbclient",
                                "ipykernel", "matplotlib") if not importlib.util.find_spec(name)]
    absent += [] if shutil.which("doxygen") else ["doxygen"]
    absent += [] if Path("/usr/share/javascript/mathjax").is_dir() else ["MathJax"]
    absent += [site_browser.MISSING] if site_browser.MISSING else []
    if absent or not (Path(python) / "polydec/__init__.py").is_file():
        print(f"Skipped: the site needs {', '.join(absent) or 'the package polydec'}.")
        return 77
    headers = sorted(set().union(*(sources.public_headers(root, listing) for listing in listings)))
    environment = os.environ | {"PYTHONPATH": python, "PYTHON": sys.executable,
                                "PYTHONDONTWRITEBYTECODE": "1", "POLYDEC_EDIT_ADDRESS": EDIT}
    names = subprocess.run([sys.executable, "-c", NAMES], env=environment, check=True,
                           capture_output=True, text=True).stdout
    with tempfile.TemporaryDirectory() as folder:
        built = subprocess.run(["sh", Path(root) / "scripts/site.sh", folder], env=environment)
        if built.returncode:
            return 1
        html = (Path(folder) / "html").resolve()
        return sources.report(complaints_about(html, Path(root), json.loads(names), headers),
                              "The site is whole.")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], sys.argv[2], sys.argv[3:]))
