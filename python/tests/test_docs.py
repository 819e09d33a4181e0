# SPDX-License-Identifier: MIT
"""Every block of the page on Python runs, and says what it says there."""
import doctest
import pathlib

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


@pytest.mark.parametrize("page", ["docs/python.md"])
def test_blocks_of_the_page(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path) # for the files that it writes
    found = doctest.testfile(str(ROOT / page), module_relative=False)
    assert found.attempted > 30 and found.failed == 0


def test_a_wrong_block_is_told():
    wrong = doctest.DocTestParser().get_doctest(">>> 1 + 1\n3\n", {}, "wrong", None, 0)
    assert doctest.DocTestRunner(verbose=False).run(wrong, out=lambda text: None).failed == 1


def test_blocks_of_the_readme_run():
    blocks = [part.split("```")[0] for part in
              (ROOT / "README.md").read_text().split("```python\n")[1:]]
    assert blocks
    for block in blocks:
        names = {}
        exec(block, names)
        assert names["modes"].certificate.complete
