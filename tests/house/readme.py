# SPDX-License-Identifier: MIT
"""Checks that every C++ block of README.md and of the pages of docs/, and every block of these in Python
that is no dialog, stands, line by line and indented the same, in an example that is compiled or run
and that the page links to; so does all code in the right columns of docs/coming-from/ and, with blocks
of the command, in docs/answers/. That every page in docs/, its folders apart, shows a picture, that
what pages link to is there, and that docs/README.md links to every page beside it.

Usage: readme.py ROOT. A complaint for each, as file:line. Exit code: 0 none, 1 some.
"""
import re
import sys
from pathlib import Path


def blocks(text, language="cpp"):
    """The blocks of a language, each with the number of its first line."""
    return [(text.count("\n", 0, match.start(1)) + 1, match.group(1))
            for match in re.finditer(rf"^ *```{language}\n(.*?)^ *```", text,
                                     re.DOTALL | re.MULTILINE)]


def stands_in(block, source):
    """Whether whole lines of the source, one after the other, are those of the block."""
    return f"\n{block.rstrip()}\n" in f"\n{source}"


def targets(page):
    """The file names that a page links to, without their folders, and those of its pictures."""
    links = re.findall(r"(!?)\[[^]]*\]\(([^)#]+)[^)]*\)", page)
    return ({name.rsplit("/", 1)[-1] for picture, name in links if not picture},
            [name for picture, name in links if picture])


def lost(page, sources, language="cpp"):
    """The blocks of a page that stand in no source, given by name, to which it links."""
    linked, _ = targets(page)
    return [(line, block) for line, block in blocks(page, language)
            if not block.startswith(">>>") and not any(name in linked and stands_in(block, source)
                       for name, source in sources.items())]


def lost_on_the_right(page, sources):
    """The code in the last column of tables that stands in no source to which the page links."""
    linked, _ = targets(page)
    text = "\n".join(source for name, source in sources.items() if name in linked)
    rows = [(number, line) for number, line in enumerate(page.splitlines(), 1)
            if line.startswith("|")]
    return [(number, code) for number, line in rows
            for code in re.findall("`([^`]+)`", line.rstrip(" |").rsplit("|", 1)[1])
            if not re.search(rf"(?<!\w){re.escape(code)}(?!\w)", text)]


def missing_pictures(page, folder):
    """What is wrong with the pictures of a page in this folder."""
    _, pictures = targets(page)
    if not pictures:
        return ["the page has no picture"]
    return [f"{name} is not there" for name in pictures if not (folder / name).is_file()]


def dead_links(page, folder):
    """The files that a page in this folder links to and that are not there."""
    links = re.findall(r"\]\((?!https?:)([^)#\s]+)[^)]*\)", re.sub("`[^`]*`", "", page))
    return [name for name in links if not (folder / name).exists()]


def check_itself():
    """The check must be able to fail."""
    code = "Text\n```cpp\n    int x;\n    int y;\n```\n"
    page = code + "Code: [a.cpp](../examples/a.cpp). ![Picture](images/none.svg)\n"
    assert blocks(page) == [(3, "    int x;\n    int y;\n")]
    good = "{\n    int x;\n    int y;\n}\n"
    assert not lost(page, {"a.cpp": good})
    assert lost(page, {"b.cpp": good}) and lost(code, {"a.cpp": good})
    for source in ["{\nint x;\nint y;\n}\n", "    int x;\n\n    int y;\n", "    int x;\n",
                   "    int x;\n    int y;  // more\n"]:
        assert lost(page, {"a.cpp": source}), source
    python = "```python\nx = 1\n```\n```python\n>>> 1\n1\n```\n[a.py](a.py)"
    assert not lost(python, {"a.py": "x = 1\ny = 2\n"}, "python")
    assert lost(python, {"a.py": "x = 2\n"}, "python") == [(2, "x = 1\n")]
    table = "| there | here |\n|---|---|\n| `f` | `a(1)` or `b` |\n[a.py](a.py)"
    assert not lost_on_the_right(table, {"a.py": "x = a(1)\nc.b\n"})
    assert lost_on_the_right(table, {"a.py": "xa(1)\nb\n"}) == [(3, "a(1)")]
    assert lost_on_the_right(table, {"b.py": "x = a(1)\nb\n"}) == [(3, "a(1)"), (3, "b")]
    here = Path(__file__).parent
    assert missing_pictures(page, here) == ["images/none.svg is not there"]
    assert missing_pictures(code, here) == ["the page has no picture"]
    assert dead_links("[a](no.md#b) [c](readme.py#d) [e](https://f)", here) == ["no.md"]
    assert not missing_pictures(f"![Itself]({Path(__file__).name})", here)


def of_answers(root):
    """Complaints about docs/answers, whose code lies in one folder: (page, line, block)."""
    folder = root / "examples"
    sources = {path.name: path.read_text() for path in
               [*folder.glob("*.cpp"), *(folder / "answers").iterdir()] if path.is_file()}
    for path in sorted((root / "docs" / "answers").glob("*.md")):
        page = path.read_text()
        for language in ("cpp", "python", "sh"):
            for line, block in lost(page, sources, language):
                yield path.relative_to(root), line, block
        words = re.sub(r"^```.*?^```", "", page, flags=re.DOTALL | re.MULTILINE)
        for name in re.findall(r"\]\(([^)#:]+)[^)]*\)", words):
            if not (path.parent / name).exists():
                yield path.relative_to(root), 1, f"{name} is not there"


def main():
    root = Path(sys.argv[1])
    sources = {path.name: path.read_text() for ending in ("cpp", "py")
               for path in sorted((root / "examples").rglob(f"*.{ending}"))}
    found = False
    docs = root / "docs"
    for path in [root / "README.md", *sorted(docs.rglob("*.md"))]:
        page, name = path.read_text(), path.relative_to(root)
        of_python = lost(page, sources, "python") if path.parent != root else []
        right = lost_on_the_right(page, sources) if path.parent.name == "coming-from" else []
        for line, block in lost(page, sources) + of_python + right:
            print(f"{name}:{line}: this code is in no example that the page links to:\n{block}")
            found = True
        for link in dead_links(page, path.parent):
            print(f"{name}:1: the page links to {link}, which is not there")
            found = True
        if path.parent in (root, docs) and path.name != "decisions.md":
            for complaint in missing_pictures(page, path.parent):
                print(f"{name}:1: {complaint}")
                found = True
    listed, _ = targets((docs / "README.md").read_text())
    for path in sorted(docs.glob("*.md")):
        if path.name not in listed:
            print(f"docs/README.md:1: the page does not link to {path.name}")
            found = True
    for name, line, block in of_answers(root):
        print(f"{name}:{line}: this code is in no example that the page links to:\n{block}")
        found = True
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    check_itself()
    main()
