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

    def test_across_a_sphere_is_half_its_circumference(self):
        for option in ([], ["--delaunay"]):
            answer = parse(run("distance", self.sphere(), "--from", 0, "--json", *option).out)
            self.assertAlmostEqual(answer["max"], math.pi, delta=0.03)
            self.assertAlmostEqual(answer["mean"], math.pi / 2, delta=0.02)
            self.assertEqual(answer["from"], [0])

    def test_from_more_vertices_is_no_longer_than_from_one(self):
        sphere = self.sphere()
        one = parse(run("distance", sphere, "--from", 0, "--json").out)
        two = parse(run("distance", sphere, "--from", 0, one["farthest"], "--json").out)
        self.assertLess(two["max"], 0.55 * one["max"])

    def test_is_told_in_words_and_drawn(self):
        picture = os.path.join(self.folder, "distance.vtu")
        told = run("distance", self.sphere(), "--from", 0, "-o", picture, "--timing")
        self.assertEqual(told.code, 0)
        self.assertIn("farthest: vertex ", told.out)
        with open(picture) as file:
            self.assertIn('Name="distance"', file.read())

    def test_says_what_it_cannot_do(self):
        for path, vertex, text in (
                (golden("kuhn3.nsc"), 0, "has cells of dimension 3: distances are found on surfaces"),
                (golden("uv8.off"), 99999, "--from 99999: no triangle has such a vertex"),
                (golden("branching.off"), 0, "3 triangles meet at the edge from vertex ")):
            answer = run("distance", path, "--from", vertex)
            self.assertEqual(answer.code, 2)
            self.assertIn(text, answer.err)
        self.assertEqual(run("distance", golden("uv8.off")).code, 1)


if __name__ == "__main__":
    command.main()
