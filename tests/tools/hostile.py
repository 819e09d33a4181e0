# SPDX-License-Identifier: MIT
"""Meshes and moments that no run asks for: what it makes of them is right, or refused in words."""
import itertools
import os
import signal

from command import TestCase, wait_until
from motions import cubes, nsc

OBTUSE = ("OFF\n4 4 0\n0 0 0\n4 0 0\n2 .6 .2\n2 .3 -.5\n" # a tetrahedron's surface
          "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n")


class Stars(TestCase):
    def test_heat_that_stars_asked_for_make_grow_is_refused(self):
        self.write("t.off", OBTUSE)
        heat = ("heat", "t.off", "--side", "dual", "--initial", "x<1.5", "--until", 200,
                "--time-step", .5)
        self.assertSays(self.fail_with(3, *heat, "--star", "circumcentric"), "t.off", "increases their norm",
                        "negative", "--star automatic")
        self.assertLess(self.ask(*heat)["relative_norm"], 1)
        spectrum = ("spectrum", "t.off", "--side", "dual", "--degree", 0, "--count", 3)
        told = self.ask(*spectrum, "--star", "circumcentric")
        self.assertSays(told["warnings"][0], "1 of the eigenvalues", "negative", "spurious")
        warning, = self.ask(*spectrum)["warnings"]
        self.assertSays(warning, "1 dual edge", "hybrid", "--delaunay")


class Symmetries(TestCase):
    """The same mesh reflected, with axes exchanged, larger, or with a coordinate more."""

    def versions(self, points):
        for axes in itertools.permutations(range(len(points[0]))):
            yield [[point[axis] for axis in axes] for point in points]
        yield [[-point[0], *point[1:]] for point in points]
        yield [[2.0**30 * c for c in point] for point in points]
        yield [[*point, 0.0] for point in points]

    def cells_of(self, points, cells):
        self.write("m.nsc", nsc(points, cells))
        found = self.ask("info", "m.nsc")
        return found["cells"]["merged"], [text for text in found["warnings"] if "turned" not in text
                                          and "units of" not in text]

    def test_solids_that_are_almost_cubes_have_the_same_cells(self):
        """At jitters about the tolerance, where some cells merge and some do not."""
        counts = set()
        for n, seed in itertools.product((3, 4), range(6)):
            with self.subTest(n=n, seed=seed):
                corners, cells = cubes(n)
                points = [[c + 3e-5 * ((7 * seed + 5 * i + 3 * axis) % 11 - 5)
                           for axis, c in enumerate(corner)] for i, corner in enumerate(corners)]
                found = [self.cells_of(version, cells) for version in self.versions(points)]
                self.assertEqual(found, len(found) * [found[0]])
                counts.add(found[0][0][-1])
        self.assertGreater(len(counts), 1)

    def test_what_lies_over_others_is_told_of_in_the_same_words(self):
        """Triangles upon each other that share an edge, and that share a vertex."""
        points = [[0.0, 0.0], [1.0, 0.0], [.5, 1.0], [.4, .6], [-1.0, -.2], [1.2, -1.0]]
        for cells, is_told in (([(0, 1, 2), (0, 1, 3)], True), ([(0, 1, 2), (0, 3, 4)], False)):
            found = [self.cells_of(version, cells) for version in self.versions(points)]
            self.assertEqual(found, len(found) * [found[0]])
            self.assertEqual(any("folded" in text for text in found[0][1]), is_told)


class Moments(TestCase):
    def test_pages_stay_as_they_were_where_a_run_is_ended(self):
        self.succeed("generate", "grid", "--nx", 30, "--ny", 30, "-o", "g.off")
        for name, more in (("heat", ("--side", "primal")), ("wave", ())):
            for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
                with self.subTest(name, signal=number):
                    self.write("o.html", "old")
                    with self.start(name, "g.off", "--initial", "x", "--until", 1e3, "--time-step", 1e-5,
                                    "--frames", 1000000, *more, "-o", "o.html", "--checkpoint", "c.checkpoint") as run:
                        wait_until(lambda: run.poll() is not None or
                                   os.path.exists(self.path("c.checkpoint")), "a checkpoint")
                        run.send_signal(number)
                        self.assertEqual(run.finish(20).code, -number)
                    self.assertEqual(self.read("o.html"), "old")
                    os.remove(self.path("c.checkpoint"))
                    self.assertEqual(sorted(os.listdir(self.folder)), ["g.off", "o.html"])

    def test_checkpoints_know_the_materials_of_light(self):
        self.succeed("generate", "kuhn", "--cells", 2, "2", 2, "-o", "k.nsc")
        light = ("maxwell", "k.nsc", "--initial", "0;0;x*y", "--until", 1, "--checkpoint",
                 "c.checkpoint")
        self.succeed(*light)
        self.succeed(*light, "--resume")
        for materials in (("--permittivity", 4), ("--permeability", 4),
                          ("--permittivity", 4, "--permeability", 9)):
            with self.subTest(materials):
                self.assertSays(self.fail_with(2, *light, "--resume", *materials), "c.checkpoint",
                                "another")
