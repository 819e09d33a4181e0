# SPDX-License-Identifier: MIT
"""The subcommand distance."""
import math
import os

import command
from command import TestCase, golden, parse, run


class Distance(TestCase):
    def sphere(self):
        path = os.path.join(self.folder, "sphere.off")
        run("generate", "icosphere", "--frequency", 16, "-o", path)
        return path

    def test_paths_have_the_length_of_the_distance_and_are_drawn(self):
        cube = os.path.join(self.folder, "cube.off")
        with open(cube, "w") as file: # the unit cube, sides cut along diagonals
            file.write("OFF\n8 12 0\n" + "".join(f"{i & 1} {i >> 1 & 1} {i >> 2}\n" for i in range(8)))
            for a, b, c, d in ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2),
                               (1, 3, 7, 5)):
                file.write(f"3 {a} {b} {c}\n3 {a} {c} {d}\n")
        picture, page = os.path.join(self.folder, "paths.vtu"), os.path.join(self.folder, "paths.html")
        answer = self.ask("distance", cube, "--from", 0, "--to", 7, 0, "-o", picture)
        far, own = answer["paths"]
        self.assertEqual([far["to"], far["from"], own["to"], own["from"]], [7, 0, 0, 0])
        self.assertAlmostEqual(far["length"], 5 ** 0.5, 14)
        points = far["points"]
        self.assertEqual([points[0], points[-1]], [[1, 1, 1], [0, 0, 0]])
        self.assertAlmostEqual(sum(math.dist(p, q) for p, q in zip(points, points[1:])), 5 ** 0.5, 14)
        self.assertEqual([own["length"], own["points"]], [0, []])
        self.assertNotIn("paths", self.ask("distance", cube, "--from", 0))
        told = self.succeed("distance", cube, "--from", 0, "--to", 7, "-o", page).out
        self.assertIn("path from vertex 0 to 7", told)
        with open(page) as file:
            self.assertIn("flow0", file.read())
        self.assertSays(self.fail_with(2, "distance", cube, "--from", 0, "--to", 7, "--method", "heat"),
                        "--to", "heat")
        self.assertSays(self.fail_with(2, "distance", cube, "--from", 0, "--to", 8), "--to", "8")

    def test_isolines_are_as_far_as_they_say_and_not_linear(self):
        grid = os.path.join(self.folder, "grid.nsc")
        run("generate", "grid", "--nx", 2, "--ny", 2, "-o", grid)
        lines = os.path.join(self.folder, "lines.obj")
        self.succeed("distance", grid, "--from", 0, "--isolines", 4, "-o", lines)
        with open(lines) as file:
            points = [[float(word) for word in line.split()[1:]] for line in file if line[0] == "v"]
        off = max(abs(5 * math.hypot(*p) / 2 ** 0.5 - round(5 * math.hypot(*p) / 2 ** 0.5))
                  for p in points)
        self.assertLess(off, 0.02) # linear between vertices: 0.5

    def test_across_a_sphere_is_half_its_circumference(self):
        for method in ("exact", "heat"):
            for option in ([], ["--delaunay"]):
                answer = parse(run("distance", self.sphere(), "--from", 0, "--json", "--method",
                                   method, *option).out)
                self.assertAlmostEqual(answer["max"], math.pi, delta=0.03)
                self.assertAlmostEqual(answer["mean"], math.pi / 2, delta=0.02)
                self.assertEqual(answer["from"], [0])
                self.assertEqual(answer["method"], method)

    def test_is_exact_unless_heat_is_asked_for(self):
        torus = os.path.join(self.folder, "torus.off")
        self.succeed("generate", "torus", "--major", 20, "--minor", 12, "-o", torus)
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

    def test_from_more_vertices_is_no_longer_than_from_one(self):
        sphere = self.sphere()
        one = parse(run("distance", sphere, "--from", 0, "--json").out)
        two = parse(run("distance", sphere, "--from", 0, one["farthest"], "--json").out)
        self.assertLess(two["max"], 0.55 * one["max"])

    def test_counts_what_fell_below_0(self):
        ribbon = os.path.join(self.folder, "ribbon.off")
        with open(ribbon, "w") as file:
            # rows of triangles whose every second vertex is moved along the row, far from Delaunay
            columns, rows = 24, 24
            file.write(f"OFF\n{(columns + 1) * (rows + 1)} {2 * columns * rows} 0\n")
            for i in range(columns + 1):
                for j in range(rows + 1):
                    shift = 0.3 * math.sin(12.9898 * i + 78.233 * j)
                    file.write(f"{(i + shift) / columns} {0.05 * j / rows} 0\n")
            for i in range(columns):
                for j in range(rows):
                    a, b = i * (rows + 1) + j, (i + 1) * (rows + 1) + j
                    file.write(f"3 {a} {b} {b + 1}\n3 {a} {b + 1} {a + 1}\n")
        answer = run("distance", ribbon, "--from", 38, "--method", "heat", "--json")
        raised = parse(answer.out)["raised"]
        self.assertGreater(raised, 0)
        told = [text for text in parse(answer.out)["warnings"]
                if command.says(text, raised, "distances", 0, "--delaunay")]
        self.assertEqual(len(told), 1, answer.err)
        self.assertIn(f"polydec: warning: {told[0]}\n", answer.err)
        flipped = parse(run("distance", ribbon, "--delaunay", "--from", 38, "--method", "heat",
                            "--json").out)
        self.assertEqual(flipped["raised"], 0)

    def test_negative_duals_are_told(self):
        """Two rows of triangles, the upper one moved far along: distances are too short there."""
        sheared = os.path.join(self.folder, "sheared.off")

        def ask(shift, *more):
            with open(sheared, "w") as file:
                file.write("OFF\n18 16 0\n")
                for j in range(2):
                    for i in range(9):
                        file.write(f"{i + j * shift} {0.5 * j} 0\n")
                for i in range(8):
                    file.write(f"3 {i} {i + 1} {i + 10}\n3 {i} {i + 10} {i + 9}\n")
            return parse(run("distance", sheared, "--from", 0, "--json", *more).out)

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
        mended = ask(3, "--delaunay=split-boundary", "--method", "heat")
        self.assertAlmostEqual(mended["max"], exact, delta=0.1 * exact)
        self.assertEqual(mended["warnings"], [])

    def test_is_told_in_words_and_drawn(self):
        picture = os.path.join(self.folder, "distance.vtu")
        told = run("distance", self.sphere(), "--from", 0, "-o", picture, "--timing")
        self.assertEqual(told.code, 0)
        self.assertIn("farthest: vertex ", told.out)
        with open(picture) as file:
            self.assertIn('Name="distance"', file.read())

    def test_surfaces_may_branch(self):
        answer = run("distance", golden("branching.off"), "--from", 0, "--json")
        self.assertEqual(answer.code, 0)
        self.assertGreater(parse(answer.out)["max"], 0)

    def test_from_the_boundary_and_from_places_and_groups_is_from_their_vertices(self):
        grid = os.path.join(self.folder, "grid.off")
        self.succeed("generate", "grid", "--nx", 8, "--ny", 8, "-o", grid)
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


if __name__ == "__main__":
    command.main()
