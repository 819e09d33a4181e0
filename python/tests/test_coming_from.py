# SPDX-License-Identifier: MIT
"""The right columns of docs/coming-from/ run, and give these numbers; tests/house/readme.py checks that
the pages show nothing else."""
import pathlib
import runpy

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = ROOT / "examples" / "python" / "coming_from"
PRINTED = {
    "combinatorialspaces": "left of z 0.368, coexact part of a turn 1.000",
    "fenics": "eigenvalue 19.72, of the cavity 18.75, heat left 0.671",
    "libigl": "farthest 3.134, by heat 3.124, u from 0.0 to 1.0",
    "pydec": "9 squares, Betti numbers [1, 0, 0], first eigenvalue 9.000",
}


def test_all_of_them_are_tested():
    assert {path.stem for path in FOLDER.glob("*.py")} == set(PRINTED)
    pages = {path.stem.replace("-", "_") for path in (ROOT / "docs" / "coming-from").glob("*.md")}
    assert pages == {*PRINTED, "geometry_central"}


@pytest.mark.parametrize("name", PRINTED)
def test_the_right_column_runs(name, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    runpy.run_path(str(FOLDER / f"{name}.py"))
    assert PRINTED[name] in capsys.readouterr().out
