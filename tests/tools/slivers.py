# SPDX-License-Identifier: MIT
"""Cubes out of what TetGen makes of the points of a grid, slivers and all."""
import random
import shutil
import subprocess
import unittest

import command
from command import TestCase

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


if __name__ == "__main__":
    command.main()
