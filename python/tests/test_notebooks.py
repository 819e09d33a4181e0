# SPDX-License-Identifier: MIT
"""The notebooks run from top to bottom, show pictures, and are kept without what they showed."""
import pathlib

import pytest

import polydec

nbformat = pytest.importorskip("nbformat", reason="no notebooks here (python3-nbclient)")
nbclient = pytest.importorskip("nbclient", reason="no notebooks here (python3-nbclient)")
pytest.importorskip("ipykernel", reason="no notebooks here (python3-ipykernel)")
pytest.importorskip("matplotlib", reason="no pictures here (python3-matplotlib)")
NOTEBOOKS = sorted((pathlib.Path(__file__).resolve().parents[1] / "notebooks").glob("*.ipynb"))


def executed(notebook, folder, monkeypatch):
    monkeypatch.setenv("PYTHONPATH", str(pathlib.Path(polydec.__file__).parents[1]))
    monkeypatch.setenv("PYDEVD_DISABLE_FILE_VALIDATION", "1") # which warns of nothing of ours
    nbclient.NotebookClient(notebook, timeout=300,
                            resources={"metadata": {"path": str(folder)}}).execute()
    return [output for cell in notebook.cells for output in cell.get("outputs", [])]


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebook(path, tmp_path, monkeypatch):
    notebook = nbformat.read(path, 4)
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert all(not cell.outputs and cell.execution_count is None for cell in code)
    assert len(notebook.cells) - len(code) >= 5 # what explains
    shown = executed(notebook, tmp_path, monkeypatch)
    pictures = [each for each in shown if "image/png" in each.get("data", {})]
    assert len(pictures) >= 2
    assert not [each for each in shown if each.get("name") == "stderr"]
    drawing = "\n".join(cell.source for cell in code)
    assert "xlabel" in drawing # and what the colors mean: by a color bar, that of plot (bar=) too, or a legend
    assert any(each in drawing for each in ("colorbar", "bar=\"", "legend"))


def test_there_are_five():
    assert len(NOTEBOOKS) == 5


def test_what_fails_is_told(tmp_path, monkeypatch):
    cell = nbformat.v4.new_code_cell("import polydec\npolydec.discretize(1)")
    with pytest.raises(nbclient.exceptions.CellExecutionError, match="InvalidInput"):
        executed(nbformat.v4.new_notebook(cells=[cell]), tmp_path, monkeypatch)
