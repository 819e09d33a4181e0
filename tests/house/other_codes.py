# SPDX-License-Identifier: MIT
"""Shows that benchmarks/other_codes.py judges rightly: what is written in numpy there agrees with the
operators of the command, a matrix that differs is told, a code that is not installed is left out.

Usage: other_codes.py POLYDEC. Leaves out what needs numpy and scipy where they are not installed.
"""
import contextlib
import importlib.util
import io
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))
import other_codes  # noqa: E402

POLYDEC = sys.argv.pop() if len(sys.argv) > 1 else "polydec"
MESHES = [["icosphere", "--frequency", "3"],  # closed
          ["moebius"],  # with a boundary, not orientable
          ["flange"]]  # of many right angles


def needs(*modules):
    lacking = [name for name in modules if not importlib.util.find_spec(name)]
    return unittest.skipIf(lacking, f"{sys.executable} has no {' and no '.join(lacking)}")


def polydec(*words):
    subprocess.run([POLYDEC, *map(str, words)], check=True, capture_output=True)


def points_and_triangles(path):
    """Of a file in OFF as polydec writes it."""
    import numpy as np
    words = path.read_text().split()
    n, m = int(words[1]), int(words[2])
    points = np.array(words[4:4 + 3 * n], dtype=float).reshape(n, 3)
    return points, np.array(words[4 + 3 * n:4 + 3 * n + 4 * m], dtype=int).reshape(m, 4)[:, 1:]


def of_the_command(path, folder):
    """The stiffness matrix, from d_0 and star_1 as the command writes them."""
    from scipy.io import mmread
    from scipy.sparse import diags
    polydec("operators", "--no-merge", path, "--out", folder)
    d = mmread(folder / "d_0.mtx").tocsr()
    return d.T @ diags(mmread(folder / "star_1.mtx").ravel()) @ d


class OtherCodes(unittest.TestCase):
    @needs("numpy", "scipy")
    def test_what_one_writes_in_numpy_is_what_the_command_writes(self):
        for mesh in MESHES:
            with self.subTest(mesh=mesh), tempfile.TemporaryDirectory() as folder:
                path = Path(folder) / "mesh.off"
                polydec("generate", *mesh, "-o", path)
                ours = of_the_command(path, Path(folder) / "operators")
                theirs = other_codes.scipy(*points_and_triangles(path))
                self.assertLess(other_codes.difference(theirs, ours), 1e-12)

                theirs[0, 0] *= 1 + 1e-6
                off = other_codes.difference(theirs, ours)
                self.assertRegex(other_codes.verdict(off), "^DIFFERS by [0-9]e-0[67]$")
                off = other_codes.difference(theirs[1:, 1:], ours)
                self.assertEqual(other_codes.verdict(off), "DIFFERS by inf")

    def test_a_matrix_that_is_no_number_differs(self):
        self.assertEqual(other_codes.verdict(float("nan")), "DIFFERS by nan")
        self.assertEqual(other_codes.verdict(1e-15), "the same to 1e-15")

    def test_a_code_that_is_not_installed_is_left_out_with_a_line(self):
        def no_such_code():
            pass
        code = other_codes.Code(no_such_code, "nothing", "cannot be had")
        with mock.patch.dict(other_codes.CODES, no_such_code=code):
            found, left_out = other_codes.chosen(["no_such_code"])
        self.assertNotIn("no_such_code", found)
        self.assertIn("no_such_code is not installed and left out: cannot be had", left_out)

    def test_a_code_that_fails_is_in_the_table(self):
        table = other_codes.table({"igl": {"failed": "ImportError: no name"}})
        self.assertIn("| failed: ImportError: no name |", table)

    @needs("numpy", "scipy", "polydec")
    def test_the_script_measures_polydec_and_scipy(self):
        words = ["other_codes.py", "--triangles", "80", "--rounds", "1", "--only", "scipy"]
        said = io.StringIO()
        with mock.patch.object(sys, "argv", words), contextlib.redirect_stdout(said):
            other_codes.main()
        lines = said.getvalue().splitlines()
        self.assertRegex(lines[0], "^80 triangles, one thread, ")
        self.assertRegex(lines[4], r"^\| polydec \| .* \| compared with \|")
        self.assertRegex(lines[5], r"^\| scipy \| .* \| the same to [0-9]e-1[5-9] \|")


if __name__ == "__main__":
    unittest.main(verbosity=2)
