# SPDX-License-Identifier: MIT
"""The examples in Python run, say what those in C++ are tested to say, and print their numbers."""
import os
import pathlib
import re

import pytest

import polydec
from conftest import python, run

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = sorted((ROOT / "examples" / "python").glob("*.py"))
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
COMPILED = pathlib.Path(os.environ.get("POLYDEC_EXAMPLES",
                                       pathlib.Path(polydec.__file__).parents[2] / "examples"))


def expectations(folder="examples"):
    """Of each example the regular expression that CMake tests it by."""
    text = (ROOT / folder / "CMakeLists.txt").read_text()
    return {name: regex.replace("\\\\", "\\")
            for name, regex in re.findall(r'polydec_\w+\((\w+) "(.*)"\)', text)}


def same(ours, theirs):
    """Whether two outputs have the same words, and numbers that differ by rounding alone."""
    if NUMBER.sub("#", ours).split() != NUMBER.sub("#", theirs).split():
        return False
    pairs = zip(map(float, NUMBER.findall(ours)), map(float, NUMBER.findall(theirs)))
    return all(abs(a - b) <= 2e-5 * max(abs(a), abs(b)) + 1e-11 for a, b in pairs)


def test_every_example_is_there_twice():
    assert {path.stem for path in EXAMPLES} == set(expectations())


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_example(path, tmp_path):
    said = python("-B", path, cwd=tmp_path).stdout
    if path.stem != "09_your_own_solver":
        assert re.search(expectations()[path.stem], said, re.DOTALL), said
    assert "they agree to 1e-9: yes" in said or path.stem != "09_your_own_solver"
    theirs = COMPILED / path.stem
    if theirs.is_file() and path.stem != "09_your_own_solver": # whose sweeps only C++ counts
        expected = run(theirs, cwd=tmp_path).stdout
        assert same(said, expected), said + expected


def test_other_numbers_are_told():
    assert same("a 1.00001 b -2", "a  1.00000 b -2") and same("x 1e-16", "x 0")
    assert not same("a 1.001", "a 1.000") and not same("a 1", "b 1") and not same("a 1", "a 1 2")
