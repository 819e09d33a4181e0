# SPDX-License-Identifier: MIT
"""Flat tetrahedra: cubes out of what TetGen makes of the points of a grid, and what is refused."""
import os
import random
import shutil
import subprocess
import unittest

import command
from command import TestCase
from mesh_laws import mesh_files
from tet_meshes import Tetrahedra

JITTERS = (0, 1e-12, 1e-8, 1e-5)


@unittest.skipUnless(shutil.which("tetgen"), "the tetrahedra are TetGen's")
class GridPoints(TestCase):
    def tetrahedra(self, n, jitter):
        """The Delaunay tetrahedra of n^3 points, those inside moved by up to half of the jitter."""
        place = random.Random(20)
        rows = []
        for i in range(n**3):
            grid = (i // n**2, i // n % n, i % n)
            moved = [c + (jitter * (place.random() - 0.5) if 0 < c < n - 1 else 0) for c in grid]
            rows.append(f"{i} {moved[0]!r} {moved[1]!r} {moved[2]!r}\n")
        self.write("points.node", f"{n**3} 3 0 0\n" + "".join(rows))
        subprocess.run(["tetgen", "-Q", "points.node"], cwd=self.folder, check=True,
                       stdout=subprocess.DEVNULL, timeout=60)
        return "points.1.ele"

    def test_become_cubes_with_their_stars_and_eigenvalues(self):
        exact = [(1 / 8, 1), (1 / 4, 1), (1 / 2, 1), (1, 1)]
        for n in (4, 6):
            m = n - 1
            cubes = [n**3, 3 * n**2 * m, 3 * n * m**2, m**3]
            for jitter in JITTERS:
                with self.subTest(n=n, jitter=jitter):
                    mesh = self.tetrahedra(n, jitter)
                    info = self.ask("info", mesh)
                    self.assertGreater(info["cells"]["input"][3], 5 * m**3) # five are enough
                    self.assertEqual(info["cells"]["merged"], cubes)
                    for star, ends in zip(info["stars"], exact):
                        found = (star["min"], star["max"])
                        self.assertLess(max(abs(a - b) for a, b in zip(found, ends)),
                                        5 * jitter + 1e-12)
                    values = self.ask("spectrum", mesh, "--side", "dual", "--degree", 0,
                                      "--count", 2, "--natural")["eigenvalues"]
                    self.assertLess(abs(values[0]), 1e-12)

    def test_do_not_where_the_jitter_is_above_the_tolerance(self):
        mesh = self.tetrahedra(4, 1e-2)
        self.assertGreater(self.ask("info", mesh)["cells"]["merged"][3], 27)


class Flat(Tetrahedra):
    """A flat cell between others is refused by its number and vertices, until it has volume or lies
    on their sphere."""
    CELLS = [[0, 1, 2, 4], [0, 2, 3, 4], [0, 1, 2, 3], [1, 0, 3, 5], [2, 1, 3, 5]]
    MESSAGE = ("cell 2 (vertices 0 1 2 3) has no volume, and without it its neighbors "
               "would come apart.\nIts vertices lie in one plane: move one of them, or exchange "
               "the cell and its neighbors for others.")

    def make(self, height):
        return self.with_corner([-.3, 1, height])

    def with_corner(self, corner):
        points = [[0, 0, 0], [1, 0, 0], [1, 1, 0], corner, [.5, .5, 1], [.5, .5, -1]]
        return mesh_files(points, self.CELLS)

    def test_a_flat_cell_on_the_sphere_of_its_neighbors_is_a_piece_of_theirs(self):
        self.write("a.nsc", self.with_corner([0, 1, 0])["a.nsc"])
        info = self.ask("info", "a.nsc")
        self.assertEqual((info["cells"]["input"][3], info["cells"]["merged"][3]), (5, 2))
        self.assertAlmostEqual(info["volume"], 2 / 3, delta=1e-14)
        self.assertEqual(self.fail_with(2, "info", "a.nsc", "--no-merge"),
                         f"polydec: a.nsc: {self.MESSAGE}")

    def test_flat_cells_are_refused_in_every_format_by_every_command(self):
        for name, text in self.make(0).items():
            self.write(name, text)
        for name in ("a.nsc", "a.mesh", "a.msh", "a.vtk", "a.node", "a.ele"):
            for arguments in (("info", name), ("info", name, "--no-merge"),
                              ("merge", name, "-o", "b.vtu"),
                              ("poisson", name, "--side", "dual", "--rhs", 1),
                              ("spectrum", name, "--side", "primal", "--degree", 0, "--count", 1),
                              ("operators", name, "--out", "operators")):
                with self.subTest(arguments):
                    self.assertEqual(self.fail_with(2, *arguments),
                                     f"polydec: {name}: {self.MESSAGE}")
        self.assertNotIn("b.vtu", os.listdir(self.folder))
        self.assertNotIn("operators", os.listdir(self.folder))

    def test_cells_that_are_almost_flat_are_none(self):
        for height in (1e-2, 1e-4, 1e-8):
            self.write("a.nsc", self.with_corner([0, 1, height])["a.nsc"])
            info = self.check_info("a.nsc")
            self.assertAlmostEqual(info["volume"], 2 / 3 + height / 3, delta=1e-13)
            self.assertLess(self.error_of_linear("a.nsc", "primal"), 1e-12)


if __name__ == "__main__":
    command.main()
