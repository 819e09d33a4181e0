# SPDX-License-Identifier: MIT
"""Writes the pages that Sphinx reads: docs/, the sources that these link to, executed notebooks, and
both interfaces.

Usage: pages.py FOLDER (empty or absent). Pages keep their places, so links between them hold.
"""
import re
import shutil
import sys
from pathlib import Path

import cpp_pages
import notebooks

ROOT = Path(__file__).resolve().parents[2]
# What MathJax needs to typeset TeX with its own fonts: a fortieth of the whole.
MATHJAX = Path("/usr/share/javascript/mathjax")
MATHJAX_PARTS = ["MathJax.js", "config/TeX-AMS_CHTML.js", "extensions", "jax/element",
                 "jax/input/TeX", "jax/output/CommonHTML", "fonts/HTML-CSS/TeX/woff"]
LANGUAGE = {".cpp": "cpp", ".py": "python", ".sh": "sh", ".h": "cpp"}
LINK = re.compile(r"(?<!!)(\[[^]]*\])\(([^)#\s]+)(#[^)]*)?\)")
INDEX = """---
nosearch: true
---
{start}

```{{toctree}}
:hidden:
:maxdepth: 2
Start <README>
All pages <docs/README>
Forty answers <docs/answers/README>
```
```{{toctree}}
:hidden:
:caption: Pages
:maxdepth: 1
{pages}
```
```{{toctree}}
:hidden:
:caption: Coming from
:maxdepth: 1
{coming}
```
```{{toctree}}
:hidden:
:caption: Notebooks
:maxdepth: 1
{notebooks}
```
```{{toctree}}
:hidden:
:caption: Interfaces
:maxdepth: 2
python
cpp/index
```
```{{toctree}}
:hidden:
:caption: Project
:maxdepth: 1
cite
CHANGELOG
CONTRIBUTING
```
"""


def source_page(path):
    """A page with a file or the list of a folder."""
    relative = path.relative_to(ROOT).as_posix()
    if path.is_dir():
        names = sorted(entry.name for entry in path.iterdir() if entry.suffix in LANGUAGE)
        return f"# {relative}\n\n" + "\n".join(f"* [{name}]({path.name}/{name})" for name in names)
    return f"# {relative}\n\n````{LANGUAGE.get(path.suffix, 'none')}\n{path.read_text()}\n````\n"


def search_words():
    """The words of search_words.txt for each page."""
    lines = (ROOT / "docs/site/search_words.txt").read_text().splitlines()
    return dict(line.split(": ", 1) for line in lines if not line.startswith("#"))


def indexed(place, text):
    """The text of a page, found by its words."""
    words = search_words().get(place)
    return f"```{{index}} {words}\n```\n\n{text}" if words else text


def copied(path, out, done):
    """Copies a page, or writes one for a source, and all that it links to."""
    if path in done:
        return
    done.add(path)
    place = path.relative_to(ROOT).as_posix()
    if path.suffix == ".ipynb":
        text = notebooks.page(path, (out / place).parent, out.parent / "static/notebooks")
    else:
        text = path.read_text() if path.suffix == ".md" else source_page(path)

    def link(match):
        words, target, anchor = match.groups()
        if re.match(r"[a-z]+:", target):
            return match.group()
        other = (path.parent / target).resolve()
        if not other.exists():
            return match.group()
        copied(other, out, done)
        # Of a source, only the page is there.
        target = target.rstrip("/") + ("" if other.suffix == ".md" else ".md")
        return f"{words}({target}{anchor or ''})"

    text = indexed(place.removesuffix(".md"), LINK.sub(link, text))
    head = ""
    if path.suffix == ".ipynb":
        place += ".md"
    elif path.suffix != ".md":
        head, place = "---\norphan: true\n---\n", place + ".md"
    elif place.startswith(("docs/decisions/", "docs/decisions.md")):
        head = "---\norphan: true\nnosearch: true\n---\n"
    elif path.parent != ROOT and not place.startswith("docs/"):
        head = "---\norphan: true\n---\n"
    (out / place).parent.mkdir(parents=True, exist_ok=True)
    (out / place).write_text(head + text)


def python_page(names, module):
    """Every public name, types first."""
    def entries(some, kind):
        return "\n".join(f".. auto{kind}:: polydec.{name}" for name in some)
    types = [name for name in names if isinstance(getattr(module, name), type)]
    functions = [name for name in names if name not in types and callable(getattr(module, name))]
    errors = [name for name in types if issubclass(getattr(module, name), BaseException)]
    classes = [name for name in types if name not in errors]
    return "\n\n".join((
        "Python\n======", ".. py:currentmodule:: polydec",
        f".. py:data:: __version__\n\n   The version, ``{module.__version__}``.",
        "Functions\n---------", entries(functions, "function"),
        "Classes\n-------", entries(classes, "class"),
        "Errors\n------", entries(errors, "exception"),
        "polydec.meshes\n--------------", ".. automodule:: polydec.meshes\n"
        "   :exclude-members: " + ", ".join(names))) + "\n"


def copy_mathjax(out):
    for part in MATHJAX_PARTS:
        (out / part).parent.mkdir(parents=True, exist_ok=True)
        copy = shutil.copytree if (MATHJAX / part).is_dir() else shutil.copyfile
        copy(MATHJAX / part, out / part)


def main(out):
    copy_mathjax(out.parent / "static/mathjax")
    done = set()
    for page in [ROOT / "README.md", ROOT / "CHANGELOG.md", ROOT / "CONTRIBUTING.md",
                 *sorted((ROOT / "docs").glob("*.md")), *sorted((ROOT / "docs").glob("*/*.md"))]:
        copied(page, out, done)
    shutil.copytree(ROOT / "docs/images", out / "docs/images")
    (out / "cite.md").write_text(indexed(
        "cite", "# How to cite\n\n```yaml\n" + (ROOT / "CITATION.cff").read_text() + "```\n"))
    cpp_pages.write(ROOT, out / "cpp", out.parent / "doxygen")
    import polydec
    (out / "python.rst").write_text(python_page(polydec.__all__, polydec))
    listed = [f"docs/{path.stem}" for path in sorted((ROOT / "docs").glob("*.md"))
              if path.stem != "README"]
    coming = [f"docs/coming-from/{path.stem}"
              for path in sorted((ROOT / "docs/coming-from").glob("*.md"))]
    lessons = [f"python/notebooks/{path.name}"
               for path in sorted((ROOT / "python/notebooks").glob("*.ipynb"))]
    answers = "\n".join(sorted(path.stem for path in (ROOT / "docs/answers").glob("*.md")
                               if path.stem != "README"))
    with (out / "docs/answers/README.md").open("a") as page:
        page.write(f"\n```{{toctree}}\n:hidden:\n{answers}\n```\n")
    (out / "index.md").write_text(INDEX.format(
        start=(out / "README.md").read_text(), pages="\n".join(listed), coming="\n".join(coming),
        notebooks="\n".join(lessons)))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(Path(sys.argv[1]).resolve())
