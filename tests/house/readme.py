# SPDX-License-Identifier: MIT
"""Checks that every C++ block of the README stands, line by line, in an example that is compiled.

Usage: readme.py ROOT. A complaint per block that does not. Exit code: 0 none, 1 some.
"""
import re
import sys
from pathlib import Path


def blocks(text):
    return re.findall(r"```cpp\n(.*?)```", text, re.DOTALL)


def main():
    root = Path(sys.argv[1])
    examples = [path.read_text() for path in sorted((root / "examples").glob("*.cpp"))]
    lost = [block for block in blocks((root / "README.md").read_text())
            if not any(block.strip() in example for example in examples)]
    for block in lost:
        print("README.md: this code is in no example:\n" + block)
    # the check must be able to fail
    assert blocks("```cpp\nint x;\n```") == ["int x;\n"]
    sys.exit(1 if lost else 0)


if __name__ == "__main__":
    main()
