# SPDX-License-Identifier: MIT
"""The command on meshes that are glued to themselves: problems without walls, and their pictures."""
import math
import os

from command import TestCase

TORUS = ("--periodic", "1,0", "--periodic", "0,1")


class Glued(TestCase):
    def setUp(self):
        super().setUp()
        self.square = self.generate("grid", "--nx", 16, "--ny", 16)
        # the factor by which a wave of one period is slower on 16 cells
        self.slower = (math.sin(math.pi / 16) / (math.pi / 16)) ** 2

    def test_poisson_finds_the_wave(self):
        for side in ("primal", "dual"):
            answer = self.ask("poisson", self.square, "--side", side, "--rhs", "sin(2*pi*x)",
                              "--exact", "sin(2*pi*x)/(4*pi^2)", *TORUS, "-o", "u.vtu")
            largest = 1 / (4 * math.pi ** 2 * self.slower)
            if side == "dual":  # centers are half a cell off the crest
                largest *= math.cos(math.pi / 16)
            self.assertAlmostEqual(answer["max"], largest, delta=1e-9)
            self.assertLess(answer["error"]["max"], 0.014 / (4 * math.pi ** 2))

    def test_conductivity_is_taken_where_cells_lie(self):
        answer = self.ask("poisson", self.square, "--side", "primal", "--rhs",
                          "4*pi^2*sin(2*pi*x)", "--conductivity", "2+0*x", *TORUS)
        self.assertAlmostEqual(answer["max"], 1 / (2 * self.slower), delta=1e-9)

    def test_heat_decays_as_the_wave(self):
        for side in ("primal", "dual"):
            until = 0.02
            answer = self.ask("heat", self.square, "--side", side, "--initial", "sin(2*pi*x)",
                              "--until", until, *TORUS)
            rate = math.log(answer["relative_norm"]) / -until
            self.assertAlmostEqual(rate, 4 * math.pi ** 2 * self.slower, delta=0.3)
            self.assertAlmostEqual(rate, 4 * math.pi ** 2, delta=0.02 * 4 * math.pi ** 2)

    def test_a_wind_stays(self):
        answer = self.ask("flow", self.square, "--velocity", "1;.5;0", "--viscosity", 0.01,
                          "--until", 0.2, *TORUS)
        self.assertAlmostEqual(answer["relative_energy"], 1, delta=1e-9)
        self.assertAlmostEqual(answer["energy"], 1.25 / 2, delta=1e-9)

    def test_waves_come_back(self):
        for degree, form in ((0, "sin(2*pi*x)"), (1, "0;sin(2*pi*x);0")):
            period = 1 / math.sqrt(self.slower)
            answer = self.ask("wave", self.square, "--side", "primal", "--degree", degree,
                              "--initial", form, "--until", period, *TORUS, "-o", "w.pvd")
            self.assertAlmostEqual(answer["max"], 1 if degree == 0 else 1 / 16, delta=1e-4)
            self.assertAlmostEqual(answer["relative_energy"], 1, delta=1e-9)
            self.assertTrue(os.path.exists(self.path("w.pvd")))

    def test_pictures_show_the_box(self):
        for out in ("m.vtu", "m.html"):
            for side, degree in (("primal", 0), ("primal", 1), ("dual", 0)):
                self.succeed("spectrum", self.square, "--side", side, "--degree", degree,
                             "--count", 3, *TORUS, "-o", out)
        points = self.ask("info", "m.vtu")["cells"]["input"][0]
        self.assertEqual(points, 17 * 17)
        for what in (("view",), ("draw", "--duals", "--numbers", "--width", 1200)):
            self.succeed(what[0], self.square, *what[1:], *TORUS)
        self.succeed("merge", self.square, *TORUS, "-o", "m.obj")
        self.succeed("poisson", self.square, "--side", "primal", "--rhs", "sin(2*pi*x)", *TORUS,
                     "--isolines", 5, "-o", "lines.obj")

    def test_ribbons_have_walls(self):
        answer = self.ask("poisson", self.square, "--side", "dual", "--rhs", 0, "--boundary",
                          "cos(2*pi*x)*cosh(2*pi*(y-.5))", "--periodic", "1,0", "--exact",
                          "cos(2*pi*x)*cosh(2*pi*(y-.5))")
        self.assertLess(answer["error"]["max"], 0.02 * answer["max"])
        self.assertGreater(answer["max"], 5)

    def test_functions_on_a_klein_bottle(self):
        answer = self.ask("poisson", self.square, "--side", "primal", "--rhs", "cos(2*pi*y)",
                          "--glue", "x+1; 1-y", "--periodic", "0,1", "-o", "u.html")
        self.assertAlmostEqual(answer["max"], 1 / (4 * math.pi ** 2 * self.slower), delta=1e-9)

    def test_flow_around_the_tip_of_a_cone_is_shown_at_cells(self):
        cone = self.write("cone.off", "OFF\n45 64 0\n" + "".join(
            f"{x / 4 - 1} {y / 4} 0\n" for y in range(5) for x in range(9)) + "".join(
                f"3 {v} {v + 1} {v + 10}\n3 {v} {v + 10} {v + 9}\n"
                for v in range(36) if v % 9 < 8))
        for out in ("f.pvd", "f.html"):
            answer = self.ask("flow", cone, "--glue=-x; -y", "--vorticity", "x*x+y*y", "--until", .1,
                              "-o", out)
            self.assertAlmostEqual(answer["relative_energy"], 1, delta=1e-9)
        with open(self.path("f/f_0000.vtu"), "rb") as step:
            text = step.read()
        self.assertLess(text.index(b"<CellData"), text.index(b'"velocity"'))

    def test_after_flips_there_are_lengths_alone(self):
        kept = self.ask("info", self.square, "--delaunay", *TORUS)
        self.assertEqual((kept["ambient_dimension"], kept["warnings"]), (3, []))
        with open(self.square, encoding="ascii") as file:
            moved = file.read().replace("\n0.5 0.5 0\n", "\n0.53 0.53 0\n")
        square = self.write("moved.off", moved)
        refused = self.fail_with(2, "poisson", square, "--side", "primal", "--rhs", "sin(2*pi*x)",
                              "--delaunay", *TORUS)
        self.assertSays(refused, "lengths", "needs points")
        answer = self.ask("info", square, "--delaunay", *TORUS)
        self.assertIsNone(answer["ambient_dimension"])
        self.assertTrue(any("no positions" in text for text in answer["warnings"]))
