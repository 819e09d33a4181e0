# SPDX-License-Identifier: MIT
"""What the package says of types is true, and suffices for strict checking of who uses it."""
import ast
import os
import pathlib
import re
import subprocess
import sys

import pytest

import polydec
from polydec import _core

pytest.importorskip("mypy", reason="no mypy here (python3-mypy)")
ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "python" / "polydec"
STUB = PACKAGE / "_core.pyi"


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    """Runs Python in a folder of its own, where mypy keeps what it knows."""
    folder = tmp_path_factory.mktemp("mypy")

    def runs(*arguments, path=PACKAGE.parent):
        home = pathlib.Path(polydec.__file__).parents[1]
        return subprocess.run(
            [sys.executable, *map(str, arguments)], cwd=folder, text=True, capture_output=True,
            env={**os.environ, "MYPYPATH": str(path), "PYTHONPATH": str(home)}, timeout=200).stdout

    return runs


def stub_errors(run, **where):
    text = run("-c", "import sys; from mypy.stubtest import main; sys.exit(main())",
               "polydec._core", "--concise", "--mypy-config-file", ROOT / "pyproject.toml", **where)
    # pybind11's own metaclass makes classes, which is nothing to those who use them
    return [line for line in text.splitlines() if not line.endswith("metaclass differs")
            and not line.startswith("Found")]


def test_the_stub_names_what_there_is(run):
    assert not stub_errors(run)


def test_what_the_stub_lacks_or_invents_is_told(run, tmp_path):
    twin = tmp_path / "polydec"
    twin.mkdir()
    for source in [*PACKAGE.glob("*.py"), PACKAGE / "py.typed"]:
        (twin / source.name).symlink_to(source)
    (twin / "_core.pyi").write_text(STUB.read_text().replace("def hexagons", "def heptagons"))
    told = "\n".join(stub_errors(run, path=tmp_path))
    assert "heptagons" in told and "hexagons" in told


def declared():
    """Names of functions and methods in the stub, with the number of arguments of each overload."""
    for node in ast.parse(STUB.read_text()).body:
        where = node.body if isinstance(node, ast.ClassDef) else [node]
        for each in where:
            is_property = any(getattr(mark, "id", "") == "property"
                              for mark in getattr(each, "decorator_list", []))
            if isinstance(each, ast.FunctionDef) and not is_property and not each.args.vararg:
                owner = getattr(_core, node.name) if node is not each else _core
                yield owner, each.name, len(each.args.args)


def test_functions_take_as_many_arguments_as_the_stub_says():
    checked = 0
    for owner, name, arguments in declared():
        text = getattr(owner, name).__doc__
        counts = {len(re.findall(r"(?:self|arg\d+): ", line)) for line in text.splitlines()
                  if f"{name}(" in line}
        assert arguments in counts, f"{name}: {arguments} in the stub, {counts} in the module"
        checked += 1
    assert checked > 90


def test_package_and_examples_pass_strictly(run):
    folder = ROOT / "examples" / "python"
    examples = [*folder.glob("*.py"), *(folder / "equations").glob("*.py")]
    text = run("-m", "mypy", "--config-file", ROOT / "pyproject.toml", PACKAGE, *examples)
    assert text.startswith("Success")


def test_wrong_use_is_told(run, tmp_path):
    wrong = tmp_path / "wrong.py"
    wrong.write_text("import polydec\n"
                     "c = polydec.discretize(polydec.meshes.grid(2, 2))\n"
                     "c.volumes('1')\n"
                     "x: str = polydec.spectrum(c, count=3).eigenvalues\n")
    text = run("-m", "mypy", "--config-file", ROOT / "pyproject.toml", wrong)
    assert "wrong.py:3:" in text and "wrong.py:4:" in text
