# SPDX-License-Identifier: MIT
"""The script that runs other codes: scipy's matrix is polydec's, and another one is told apart."""
import importlib.util
import pathlib
import subprocess
import sys

import numpy as np
from scipy.sparse import csr_matrix

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "benchmarks" / "other_codes.py"


def test_scipy_makes_the_same_matrix():
    answer = subprocess.run([sys.executable, "-B", SCRIPT, "--triangles", "500", "--only", "scipy",
                             "--only", "pydec", "--rounds", "1"], capture_output=True, text=True,
                            check=True)
    assert "500 triangles" in answer.stdout
    row = next(line for line in answer.stdout.splitlines() if line.startswith("| scipy"))
    assert "the same to" in row
    if not importlib.util.find_spec("pydec"):
        assert answer.stderr == "pydec is left out: pip install pydec\n"


def test_another_matrix_is_told_apart():
    spec = importlib.util.spec_from_file_location("other_codes", SCRIPT)
    code = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(code)
    right = csr_matrix(np.array([[2.0, -1.0], [-1.0, 2.0]]))
    assert code.difference(right, right) == 0
    assert code.difference(1.001 * right, right) > code.TOLERANCE
    assert code.difference(right[:1], right) == float("inf")
    result = {"seconds": [1.0], "bytes": 1.0}
    text = code.table({"polydec": {**result, "difference": 0.0},
                       "scipy": {**result, "difference": 1e-3}}, {"polydec": "", "scipy": ""})
    assert "DIFFERS by 1e-03" in text
