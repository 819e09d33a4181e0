# SPDX-License-Identifier: MIT
"""The subcommand distance."""
import math

import command
from command import TestCase, golden, parse, run
from motions import off, squares


class Distance(TestCase):
    def sphere(self):
        return self.generate("icosphere", "--frequency", 16)

    def test_paths_have_the_length_of_the_distance_and_are_drawn(self):
        sides = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
        cube = self.write("cube.off", off( # the unit cube, sides cut along diagonals
            [(i & 1, i >> 1 & 1, i >> 2) for i in range(8)],
            [half for a, b, c, d in sides for half in ((a, b, c), (a, c, d))]))
        answer = self.ask("distance", cube, "--from", 0, "--to", 7, 0, "-o", "paths.vtu")
        far, own = answer["paths"]
        self.assertEqual([far["to"], far["from"], own["to"], own["from"]], [7, 0, 0, 0])
        self.assertAlmostEqual(far["length"], 5 ** 0.5, 14)
        points = far["points"]
        self.assertEqual([points[0], points[-1]], [[1, 1, 1], [0, 0, 0]])
        self.assertAlmostEqual(sum(math.dist(p, q) for p, q in zip(points, points[1:])), 5 ** 0.5, 14)
        self.assertEqual([own["length"], own["points"]], [0, []])
        self.assertNotIn("paths", self.ask("distance", cube, "--from", 0))
        told = self.succeed("distance", cube, "--from", 0, "--to", 7, "-o", "paths.html").out
        self.assertIn("path from vertex 0 to 7", told)
        self.assertIn("flow0", self.read("paths.html"))
        self.assertSays(self.fail_with(2, "distance", cube, "--from", 0, "--to", 7, "--method", "heat"),
                        "--to", "heat")
        self.assertSays(self.fail_with(2, "distance", cube, "--from", 0, "--to", 8), "--to", "8")

    def test_isolines_are_as_far_as_they_say_and_not_linear(self):
        grid = self.generate("grid", "--nx", 2, "--ny", 2, extension="nsc")
        self.succeed("distance", grid, "--from", 0, "--isolines", 4, "-o", "lines.obj")
        points = [[float(word) for word in line.split()[1:]]
                  for line in self.read("lines.obj").splitlines() if line[0] == "v"]
        off = max(abs(5 * math.hypot(*p) / 2 ** 0.5 - round(5 * math.hypot(*p) / 2 ** 0.5))
                  for p in points)
        self.assertLess(off, 0.02) # linear between vertices: 0.5
        line = ("poisson", self.write("line.nsc", "1 1 3 2\n0\n1\n2\n0 1\n1 2\n"), "--rhs", 0,
                "--boundary", "x", "--isolines", 3, "-o")
        self.assertSays(self.fail_with(2, *line, "points.obj"), "points.obj", "curve", ".vtu")
        self.succeed(*line, "points.vtu")

    def test_across_a_sphere_is_half_its_circumference(self):
        for method in ("exact", "heat"):
            for option in ([], ["--delaunay"]):
                answer = self.ask("distance", self.sphere(), "--from", 0, "--method", method,
                                  *option)
                self.assertAlmostEqual(answer["max"], math.pi, delta=0.03)
                self.assertAlmostEqual(answer["mean"], math.pi / 2, delta=0.02)
                self.assertEqual(answer["from"], [0])
                self.assertEqual(answer["method"], method)

    def test_is_exact_unless_heat_is_asked_for(self):
        torus = self.generate("torus", "--major", 20, "--minor", 12)
        exact = self.ask("distance", torus, "--from", 0)
        smoothed = self.ask("distance", torus, "--from", 0, "--method", "heat")
        self.assertGreater(abs(smoothed["mean"] - exact["mean"]), 1e-3 * exact["mean"])
        self.assertIn("exact up to rounding", self.succeed("distance", torus, "--from", 0).out)
        self.assertIn("smoothed by the heat method",
                      self.succeed("distance", torus, "--from", 0, "--method", "heat").out)
        for options in (["--time-scale", 2], ["--engine", "eigen.ldlt"]):
            self.assertSays(self.fail_with(2, "distance", torus, "--from", 0, *options),
                            "--time-scale", "--engine", "--method heat")
            self.ask("distance", torus, "--from", 0, "--method", "heat", *options)

    def test_a_source_counts_once(self):
        grid = self.generate("grid", "--nx", 2, "--ny", 2)
        for more in (("--from", 0, 0), ("--from", 0, "--from-where", "x+y<.1")):
            self.assertEqual(self.ask("distance", grid, *more)["from"], [0])

    def test_counts_what_fell_below_0(self):
        # rows of triangles whose every second vertex is moved along the row, far from Delaunay
        ribbon = self.write("ribbon.off", off(*squares(24, 24, lambda i, j: (
            (i + 0.3 * math.sin(12.9898 * i + 78.233 * j)) / 24, 0.05 * j / 24, 0))))
        answer = self.succeed("distance", ribbon, "--from", 38, "--method", "heat", "--json")
        raised = parse(answer.out)["raised"]
        self.assertGreater(raised, 0)
        told = [text for text in parse(answer.out)["warnings"]
                if command.says(text, raised, "distances", 0, "--delaunay")]
        self.assertEqual(len(told), 1, answer.err)
        self.assertIn(f"polydec: warning: {told[0]}\n", answer.err)
        flipped = self.ask("distance", ribbon, "--delaunay", "--from", 38, "--method", "heat")
        self.assertEqual(flipped["raised"], 0)

    def test_negative_duals_are_told(self):
        """Two rows of triangles, the upper one moved far along: distances are too short there."""
        def ask(shift, *more):
            sheared = off(*squares(8, 1, lambda i, j: (i + j * shift, 0.5 * j, 0)))
            return self.ask("distance", self.write("sheared.off", sheared), "--from", 0, *more)

        exact = math.hypot(11, 0.5)
        for flips in ([], ["--delaunay"]):
            told = ask(3, *flips) # no stars, so nothing is said of them
            self.assertAlmostEqual(told["max"], exact, delta=1e-13)
            self.assertEqual(told["warnings"], [])
        self.assertAlmostEqual(ask(3, "--delaunay")["mean"], ask(3)["mean"], delta=1e-13)
        self.assertEqual(ask(0, "--method", "heat")["warnings"], [])
        short = ask(3, "--method", "heat")
        self.assertLess(short["max"], 0.7 * exact)
        (warning,) = short["warnings"]
        self.assertSays(warning, 8, "1-cells", "negative dual", "distances", "--delaunay")
        self.assertNotIn("star", warning)
        mended = ask(3, "--delaunay=split-boundary", "--method", "heat")
        self.assertAlmostEqual(mended["max"], exact, delta=0.1 * exact)
        self.assertEqual(mended["warnings"], [])

    def test_is_told_in_words_and_drawn(self):
        told = self.succeed("distance", self.sphere(), "--from", 0, "-o", "distance.vtu", "--timing")
        self.assertIn("farthest: vertex ", told.out)
        self.assertIn('Name="distance"', self.read("distance.vtu"))

    def test_surfaces_may_branch(self):
        self.assertGreater(self.ask("distance", golden("branching.off"), "--from", 0)["max"], 0)

    def test_from_the_boundary_and_from_places_and_groups_is_from_their_vertices(self):
        grid = self.generate("grid", "--nx", 8, "--ny", 8)
        with open(grid) as file:
            points = [[float(x) for x in line.split()] for line in file.readlines()[2:83]]

        def ask(*sources):
            answer = self.ask("distance", grid, *sources)
            return answer["from"], answer["max"], answer["mean"]

        def numbers(holds):
            return [9 * i + j for i in range(9) for j in range(9) if holds(i, j)]

        for asked, holds in (
                (("--from", "boundary"), lambda i, j: 0 in (i, j) or 8 in (i, j)),
                (("--from-where", "x < .01"), lambda i, j: points[9 * i + j][0] < .01),
                (("--from-where", "x < .01", "--from", 40),
                 lambda i, j: points[9 * i + j][0] < .01 or 9 * i + j == 40)):
            chosen = numbers(holds)
            self.assertEqual(sorted(ask(*asked)[0]), chosen)
            self.assertEqual(ask(*asked)[1:], ask("--from", *chosen)[1:])
        self.assertAlmostEqual(ask("--from", "boundary")[1], .5, delta=1e-15)
        self.assertSays(self.fail_with(2, "distance", grid, "--from-where", "x > 2"),
                        "--from-where", "81 vertices")
        self.assertSays(self.fail_with(2, "distance", grid, "--from-on", "wall"), "group", "wall")
        self.assertSays(self.fail_with(2, "distance", golden("uv8.off"), "--from", "boundary"),
                        "no boundary", "vertices")

    def test_says_what_it_cannot_do(self):
        for path, vertex, words in (
                (golden("kuhn3.nsc"), 0, (golden("kuhn3.nsc"), "dimension 3", "surface")),
                (golden("uv8.off"), 99999, ("--from 99999: ", "vertex"))):
            self.assertSays(self.fail_with(2, "distance", path, "--from", vertex), *words)
        self.assertEqual(run("distance", golden("uv8.off")).code, 1)
