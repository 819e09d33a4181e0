# SPDX-License-Identifier: MIT
"""Checks that every C++ block of README.md and of docs/*.md stands, line by line and indented the
same, in an example that is compiled.

Usage: readme.py ROOT. A complaint per block that does not, as file:line. Exit code: 0 none, 1 some.
"""
import re
import sys
from pathlib import Path


def blocks(text):
    """The C++ blocks, each with the number of its first line."""
    return [(text.count("\n", 0, match.start(1)) + 1, match.group(1))
            for match in re.finditer(r"^ *```cpp\n(.*?)^ *```", text, re.DOTALL | re.MULTILINE)]


def stands_in(block, source):
    """Whether whole lines of the source, one after the other, are those of the block."""
    return f"\n{block.rstrip()}\n" in f"\n{source}"


def lost(page, sources):
    """The blocks of a page that stand in no source."""
    return [(line, block) for line, block in blocks(page)
            if not any(stands_in(block, source) for source in sources)]


def check_itself():
    """The check must be able to fail."""
    page = "Text\n```cpp\n    int x;\n    int y;\n```\n"
    assert blocks(page) == [(3, "    int x;\n    int y;\n")]
    assert not lost(page, ["{\n    int x;\n    int y;\n}\n"])
    for source in ["{\nint x;\nint y;\n}\n", "    int x;\n\n    int y;\n", "    int x;\n",
                   "    int x;\n    int y;  // more\n"]:
        assert lost(page, [source]), source


def main():
    root = Path(sys.argv[1])
    sources = [path.read_text() for path in sorted((root / "examples").rglob("*.cpp"))]
    found = False
    for path in [root / "README.md", *sorted((root / "docs").glob("*.md"))]:
        for line, block in lost(path.read_text(), sources):
            print(f"{path.relative_to(root)}:{line}: this code is in no example:\n{block}")
            found = True
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    check_itself()
    main()
