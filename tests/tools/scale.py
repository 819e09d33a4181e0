# SPDX-License-Identifier: MIT
"""Meshes of every size: numbers come in the units of the file, or it is said that they are none."""
import itertools
import math
import os
import random
from fractions import Fraction

import command
from command import TestCase, parse
from motions import Mesh, cubes

# powers of two change no digit; the first and the last two need other units inside
EXACT = [2.0**-500, 2.0**-332, 2.0**-26, 2.0**26, 2.0**332, 2.0**500]
ROUND = [1e-150, 1e-100, 1e-8, 1e8, 1e100, 1e150]


def shaken_cubes(n, side, amount):
    """n-cubes of size 1 / side, with inner points moved by an amount."""
    shake = random.Random(n)
    corners, cells = cubes(n, side)
    return [[x / side + (shake.uniform(-amount, amount) if all(0 < y < side for y in corner) else 0)
             for x in corner] for corner in corners], cells


def text_of(points, cells, size):
    return Mesh(points, cells).times(size).text()


def lengths_of(points, cells, size):
    edges = sorted({tuple(sorted(edge)) for cell in cells
                    for edge in itertools.combinations(cell, 2)})
    n = len(cells[0]) - 1
    lines = [f"{n} {len(points)} {len(cells)} {len(edges)}"]
    lines += [" ".join(map(str, cell)) for cell in cells]
    lines += [f"{a} {b} {math.dist(points[a], points[b]) * size!r}" for a, b in edges]
    return "\n".join(lines) + "\n"


# how many cubes to a side in each dimension, so that there is an inner vertex where that is cheap
SIDES = {1: 7, 2: 4, 3: 3, 4: 2, 5: 1}


class Scale(TestCase):
    def mesh(self, n, size, write=text_of, suffix="nsc", amount=.03):
        return self.write(f"{n}_{size!r}.{suffix}", write(*shaken_cubes(n, SIDES[n], amount), size))

    def answer(self, *arguments, code=0):
        outcome = command.run(*arguments, "--json", folder=self.folder)
        self.assertEqual(outcome.code, code, outcome.err)
        self.assertNotIn("nan", outcome.out)
        return parse(outcome.out) if code == 0 else outcome.err

    def check(self, found, expected, digits=1e-9):
        """Equal as numbers, None where the one expected is none of double precision."""
        if expected is None or not 2.3e-308 <= abs(expected) <= 1.7e308:
            self.assertIsNone(found)
        else:
            self.assertAlmostEqual(found / expected, 1, delta=digits)

    def power(self, value, size, power):
        """value * size^power; None if that is none of double precision."""
        try:
            return float(Fraction(value) * Fraction(size)**power)
        except OverflowError:
            return None

    def test_stars_and_volumes(self):
        for n in SIDES:
            unit = self.answer("info", self.mesh(n, 1.0))
            for size in EXACT + ROUND:
                found = self.answer("info", self.mesh(n, size))
                self.assertEqual(found["cells"], unit["cells"])
                self.assertEqual(found["betti"], unit["betti"])
                self.check(found["volume"], self.power(unit["volume"], size, n))
                for k, (star, original) in enumerate(zip(found["stars"], unit["stars"])):
                    self.assertEqual(star["negative"], original["negative"])
                    self.check(star["max"], self.power(original["max"], size, n - 2 * k))
                lost = [w for w in found["warnings"]
                        if command.says(w, "volumes", "double precision")]
                self.assertEqual(bool(lost), found["volume"] is None or
                                 any(star["max"] is None for star in found["stars"]))

    def test_spectra(self):
        for n in SIDES:
            for side, degree in (("primal", 0), ("dual", 0), ("primal", 1)):
                if (n, side) == (5, "dual"):
                    continue  # there is one merged cell
                options = ["--side", side, "--degree", degree, "--count", 3]
                unit = self.answer("spectrum", self.mesh(n, 1.0, amount=0), *options)["eigenvalues"]
                for size in EXACT[::2] + ROUND[::3]:
                    mesh = self.mesh(n, size, amount=0)
                    found = self.answer("spectrum", mesh, *options)["eigenvalues"]
                    for value, original in zip(found, unit):
                        if abs(original) > 1e-6 * abs(unit[-1]):
                            self.check(value, self.power(original, size, -2))
                        else:
                            self.assertLess(abs(value) * size * size, 1e-6 * max(unit))

    def test_poisson_problems(self):
        for n in SIDES:
            for side in ("primal", "dual"):
                unit = self.answer("poisson", self.mesh(n, 1.0), "--side", side, "--rhs", "1")
                for size in EXACT + ROUND:
                    mesh = self.mesh(n, size)
                    found = self.answer("poisson", mesh, "--side", side, "--rhs", "1")
                    if unit["max"] > 0:
                        self.check(found["max"], unit["max"] * size * size)
                    linear = self.answer("poisson", mesh, "--side", side, "--rhs", "0",
                                         "--boundary", "x", "--exact", "x")
                    self.assertLess(linear["error"]["max"], 1e-9 * size)

    def test_fluxes_and_conditions_are_at_places_of_the_file(self):
        for size in EXACT + ROUND:
            found = self.answer("poisson", self.mesh(2, size), "--side", "primal", "--rhs", "0",
                                "--boundary", "x", "--flux", f"(x>{size}*.99)-(x<{size}*.01)",
                                "--essential-where", f"x<{size}*.01", "--exact", "x")
            self.assertLess(found["error"]["max"], 1e-9 * size)

    def test_flips_and_splits(self):
        for option in ("--delaunay", "--delaunay=split-boundary"):
            unit = self.answer("info", self.mesh(2, 1.0), option)
            solution = self.answer("poisson", self.mesh(2, 1.0), option, "--side", "primal",
                                   "--rhs", "1")
            for size in EXACT + ROUND:
                for mesh in (self.mesh(2, size), self.mesh(2, size, lengths_of, "nsl")):
                    found = self.answer("info", mesh, option)
                    self.assertEqual(found["cells"], unit["cells"])
                    self.check(found["volume"], size * size)
                    found = self.answer("poisson", mesh, option, "--side", "primal", "--rhs", "1")
                    self.check(found["max"], solution["max"] * size * size)

    def test_distances(self):
        unit = self.answer("distance", self.mesh(2, 1.0), "--from", 0)
        for size in EXACT + ROUND:
            found = self.answer("distance", self.mesh(2, size), "--from", 0)
            self.check(found["max"], unit["max"] * size)
            self.check(found["mean"], unit["mean"] * size)

    def test_points_are_written_as_they_were_read(self):
        for size in EXACT + ROUND:
            mesh = self.mesh(2, size)
            points = [[float(x) for x in line.split()] for line in self.read(mesh).split("\n")[1:26]]
            for option in ([], ["--delaunay"]):
                out = self.path("out.off")
                self.assertEqual(command.run("merge", mesh, *option, "-o", out).code, 0)
                written = [line.split() for line in self.read(out).split("\n")[2:27]]
                self.assertEqual([[float(x) for x in row[:2]] for row in written], points)

    def test_operators_are_those_of_the_file_or_refused_by_name(self):
        unit, other = self.path("unit"), self.path("other")
        self.succeed("operators", self.mesh(2, 1.0), "--out", unit)
        for size in EXACT:
            self.succeed("operators", self.mesh(2, size), "--out", other)
            for name, power in (("star_0", 2), ("star_1", 0), ("star_2", -2), ("volume_1", 1),
                                ("dual_volume_0", 2), ("laplacian_primal_0", -2), ("d_0", 0)):
                before, after = (
                    [float(line.split()[-1]) for line in
                     self.read(os.path.join(folder, name + ".mtx")).split("\n")[2:-1]]
                    for folder in (unit, other))
                largest = max(map(abs, before))
                for a, b in zip(before, after):
                    if abs(a) > 1e-12 * largest:
                        self.check(b, self.power(a, size, power), 1e-12)
        refused = command.run("operators", self.mesh(3, 1e150), "--out", other)
        self.assertEqual(refused.code, 2)
        self.assertSays(refused.err.splitlines()[-1], "polydec: star_0.mtx: ", "double precision")

    def test_one_flat_triangle_is_bounded_or_refused_alike_by_all_commands(self):
        for height in (0.0, 1e-18, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3):
            for size in (1.0, 1e-150, 1e150):
                mesh = self.write("flat.nsc", text_of([[0, 0], [1, 0], [.5, height]], [[0, 1, 2]],
                                                      size))
                info, poisson = (
                    command.run(*arguments, "--delaunay=split-boundary", "--json",
                                folder=self.folder)
                    for arguments in (("info", mesh),
                                      ("poisson", mesh, "--side", "primal", "--rhs", "1")))
                self.assertEqual(info.code, poisson.code, info.err + poisson.err)
                self.assertIn(info.code, (0, 2, 3))
                if info.code == 0:
                    self.assertLess(parse(info.out)["cells"]["merged"][2], 2000)
                else:
                    self.assertEqual(info.err, poisson.err)
