# SPDX-License-Identifier: MIT
"""The equations of docs/equations.md: every one in C++ and in Python, in 5 to 15 lines, with the same
numbers, which are those that the page shows."""
import re

import pytest

from conftest import python, run
from test_examples import COMPILED, ROOT, expectations, same

FOLDER = ROOT / "examples" / "python" / "equations"
EQUATIONS = sorted(FOLDER.glob("*.py"))
EXPECTED = expectations("examples/equations")
PAGE = (ROOT / "docs" / "equations.md").read_text()


def code_of_cpp(text):
    """Lines that say something: not those of comments, includes, the frame of main, or blank."""
    lines = re.sub(r"//.*", "", text).splitlines()
    frame = re.compile(r"(#include .*|int main\(\) \{|\})?\s*$")
    return [line for line in lines if not frame.match(line)]


def code_of_python(text):
    """Likewise, without imports and docstrings."""
    lines = re.sub(r'"""(.|\n)*?"""|#.*', "", text).splitlines()
    return [line for line in lines if line.strip() and not re.match(r"(import|from) ", line)]


def shown(name, lines):
    """What the page says that is printed: the indented lines before it links to the code."""
    indented = [line[4:] for line in PAGE.split(f"[{name}.cpp]")[0].splitlines()
                if line.startswith("    ")]
    return "\n".join(indented[-lines:])


def test_there_are_fifteen_in_both_languages():
    names = {path.stem for path in EQUATIONS}
    assert len(names) >= 15 and names == set(EXPECTED)
    assert names == {path.stem for path in (ROOT / "examples" / "equations").glob("*.cpp")}


@pytest.mark.parametrize("name", [path.stem for path in EQUATIONS])
def test_equations_are_short(name):
    cpp = code_of_cpp((ROOT / "examples" / "equations" / f"{name}.cpp").read_text())
    python = code_of_python((FOLDER / f"{name}.py").read_text())
    assert 5 <= len(cpp) <= 15 and 5 <= len(python) <= 15, (len(cpp), len(python))


def test_lines_are_counted():
    assert len(code_of_cpp("// a\n#include <b>\n\nint main() {\n    c;\n    d; // e\n}\n")) == 2
    assert len(code_of_python('# a\n"""b\nc"""\nimport d\n\ne\nf # g\n')) == 2


@pytest.mark.parametrize("path", EQUATIONS, ids=lambda path: path.stem)
def test_equation(path, tmp_path):
    said = python("-B", path, cwd=tmp_path).stdout
    assert re.search(EXPECTED[path.stem], said, re.DOTALL), said
    assert same(said, shown(path.stem, len(said.splitlines()))), said
    theirs = COMPILED / "equations" / path.stem
    if theirs.is_file():
        (tmp_path / "cpp").mkdir()
        expected = run(theirs, cwd=tmp_path / "cpp").stdout
        assert same(said, expected), said + expected
