# SPDX-License-Identifier: MIT
"""The subcommand flow: what it keeps, conditions, series, and runs that are killed and resumed."""
import math

from command import TestCase, golden
from kills import kills, resumed_series
from motions import Mesh


class Flow(TestCase):
    def test_vortices_without_viscosity_keep_their_energy(self):
        for kind, arguments in (("icosphere", ("--frequency", 8)),
                                ("torus", ("--major", 24, "--minor", 12))):
            mesh = self.generate(kind, *arguments)
            answer = self.ask("flow", mesh, "--vorticity", "exp(-9*((x-1)^2+y^2))", "--until", 2)
            self.assertAlmostEqual(answer["relative_energy"], 1, delta=1e-11)
            self.assertLess(abs(answer["circulation"]), 1e-12)
            self.assertLess(answer["divergence"], 1e-13)
            other = self.ask("flow", mesh, "--vorticity", "exp(-9*((x-1)^2+y^2))", "--until", 2,
                             "--viscosity", 0.01)
            self.assertLess(other["relative_energy"], 0.99)

    def test_a_vortex_between_walls_decays_as_it_should(self):
        square = self.generate("grid", "--nx", 24, "--ny", 24)
        for scheme in ("midpoint", "imex"):
            answer = self.ask("flow", square, "--vorticity", "sin(pi*x)*sin(pi*y)", "--viscosity",
                              0.01, "--until", 2, "--scheme", scheme)
            exact = math.exp(-2 * 2 * math.pi ** 2 * 0.01 * 2)
            self.assertAlmostEqual(answer["relative_energy"] / exact, 1, delta=0.01)
            self.assertIn("96 with free slip", answer["conditions"])
        stuck = self.ask("flow", square, "--vorticity", "sin(pi*x)*sin(pi*y)", "--viscosity", 0.01,
                         "--until", 2, "--no-slip-where", "1")
        self.assertLess(stuck["relative_energy"], 0.9 * exact)

    def test_a_lid_drives_a_cavity_and_a_fan_a_channel(self):
        square = self.generate("grid", "--nx", 12, "--ny", 12)
        cavity = self.ask("flow", square, "--viscosity", 0.01, "--no-slip-where", "1",
                          "--boundary-velocity", "(y>.999)*1; 0; 0", "--until", 4, "--scheme", "imex")
        self.assertGreater(cavity["energy"], 0.01)
        channel = self.ask("flow", square, "--boundary-velocity", "1; 0; 0", "--open-where", "x>.999",
                           "--until", 1, "--scheme", "imex")
        self.assertAlmostEqual(channel["energy"], 0.5, delta=1e-9)
        self.assertIn("12 open", channel["conditions"])
        self.assertSays(self.fail_with(2, "flow", square, "--boundary-velocity", "x; 0; 0",
                                       "--until", 1),
                        f"{square}: ", "net outflow", "boundary", "expected 0", "open facet")

    def test_conditions_and_velocities_that_apply_nowhere_are_refused(self):
        square = self.generate("grid", "--nx", 6, "--ny", 6)
        line = ("flow", square, "--velocity", "y; 1-x; 0", "--until", .1)
        inside = "(x>.2)*(x<.8)*(y>.2)*(y<.8)"
        for option in ("--no-slip-where", "--open-where"):
            for where in ("x>5", inside):
                self.assertSays(self.fail_with(2, *line, option, where), option, "none of the 24")
        for more in (("--open-where", 1), ()): # the first has no wall, the second has only slip
            self.assertSays(self.fail_with(2, *line, "--boundary-velocity", "(y>.999)*1; 0; 0", *more),
                            "--boundary-velocity", "none of the 24")

    def test_a_velocity_that_no_wall_lets_through_leaves_the_fluid_at_rest(self):
        square = self.generate("grid", "--nx", 12, "--ny", 12)
        answer = self.ask("flow", square, "--velocity", "1; 0; 0", "--until", 1)
        self.assertEqual((answer["energy"], answer["divergence"], answer["max_vorticity"]), (0, 0, 0))
        self.assertSays(answer["warnings"][-1], "velocity", "at rest", "--boundary-velocity",
                        "--open-where")
        moving = self.ask("flow", square, "--velocity", "1; 0; 0", "--open-where", "x<.001 || x>.999",
                          "--until", .1)
        self.assertAlmostEqual(moving["energy"], 0.5, delta=1e-9)
        self.assertEqual(moving["warnings"], [])

    def test_what_does_not_move_the_fluid_is_told(self):
        sphere, square = self.generate("goldberg", "--frequency", 4), self.generate("grid", "--nx", 6,
                                                                                     "--ny", 6)
        turned = ("--boundary-velocity", "(y>.999)*1; 0; 0", "--no-slip-where", 1)
        for mesh, line in ((sphere, ("--vorticity", 1)), (square, ("--vorticity", "(x<.01)*1")),
                           (square, ("--velocity", "0; 0; 1")), (square, turned),
                           (square, ("--boundary-velocity", "0; 0; 1", "--no-slip-where", 1,
                                     "--viscosity", .01))):
            answer = self.ask("flow", mesh, *line, "--until", 0.1)
            self.assertEqual(answer["energy"], 0)
            self.assertSays(answer["warnings"][-1], "velocity", "vorticity", "at rest")
        for mesh, line in ((sphere, ("--vorticity", 0)), (sphere, ("--vorticity", "z")),
                           (square, (*turned, "--viscosity", .001))):
            self.assertEqual(self.ask("flow", mesh, *line, "--until", 0.1)["warnings"], [])

    def test_friction_that_midpoints_do_not_follow_is_told(self):
        mesh = self.generate("well-centered")
        for viscosity in (10, 1e3, 1e6):
            line = ("flow", mesh, "--vorticity", 1, "--viscosity", viscosity, "--until", 1)
            self.assertSays(self.ask(*line)["warnings"][-1], "friction", "midpoint", "--scheme imex")
            damped = self.ask(*line, "--scheme", "imex")
            self.assertEqual(damped["warnings"], [])
            self.assertLess(damped["relative_energy"], 1e-9)

    def test_velocities_make_flows_in_solids_and_with_harmonic_parts(self):
        cube = golden("kuhn3.nsc")
        answer = self.ask("flow", cube, "--velocity", "y-.5; .5-x; 0", "--until", 0.5)
        self.assertAlmostEqual(answer["relative_energy"], 1, delta=1e-11)
        self.assertGreater(answer["energy"], 0)
        torus = self.generate("torus", "--major", 48, "--minor", 24)
        around = self.ask("flow", torus, "--velocity", "-y/(x^2+y^2); x/(x^2+y^2); 0", "--until", 1)
        self.assertLess(around["max_vorticity"], 0.05)
        self.assertGreater(around["energy"], 1)
        self.assertSays(self.fail_with(2, "flow", torus, "--velocity", "1; 0", "--until", 1),
                        "--velocity", "expected 3")
        self.assertSays(self.fail_with(2, "flow", cube, "--vorticity", "x", "--until", 1),
                        "dimension 3", "expected", "surface")

    def test_units_of_length_change_no_number_but_lengths(self):
        one = self.ask("flow", golden("grid4.nsc"), "--velocity", "y; x*x", "--viscosity", 0.01,
                       "--until", 0.5)
        spin = self.ask("flow", golden("grid4.nsc"), "--vorticity", "1+x", "--until", 0.5)
        for scale in (1e-150, 1e-30, 1e20, 1e150):
            self.write("scaled.nsc", Mesh.read(golden("grid4.nsc")).times(scale).text())
            other = self.ask("flow", "scaled.nsc", "--velocity", f"y; x*x/{scale!r}",
                             "--viscosity", repr(0.01 * scale ** 2), "--until", 0.5)
            self.assertEqual(one["steps"], other["steps"])
            self.assertAlmostEqual(one["relative_energy"], other["relative_energy"], delta=1e-9)
            self.assertAlmostEqual(one["max_vorticity"], other["max_vorticity"], delta=1e-9)
            turned = self.ask("flow", "scaled.nsc", "--vorticity", f"1+x/{scale!r}", "--until", 0.5)
            for first, second in ((one, other), (spin, turned)):
                if 1e-70 < scale < 1e70:
                    self.assertAlmostEqual(second["energy"] / scale ** 4 / first["energy"], 1,
                                           delta=1e-9)
                else: # which no double can hold
                    self.assertIsNone(second["energy"])

    def test_series_and_pages_are_written(self):
        sphere = golden("uv8.off")
        answer = self.ask("flow", sphere, "--vorticity", "z", "--until", 1, "--frames", 5, "-o",
                          "s.pvd")
        self.assertEqual(len(self.steps_of("s.pvd")[1]), answer["frames"])
        self.succeed("flow", sphere, "--vorticity", "z", "--until", 1, "-o", "s.html")

    def test_killed_runs_go_on_to_the_same_bits(self):
        sphere = self.generate("icosphere", "--frequency", 12)
        line = ("flow", sphere, "--vorticity", "exp(-9*((x-1)^2+y^2))", "--until", 4, "--frames",
                20)
        resumed_series(self, line, kills(5))

    def test_what_vertices_have_of_vorticity_is_of_surfaces(self):
        line = ("flow", golden("kuhn3.nsc"), "--until", 1)
        for more in (("--vorticity", 1), ("--velocity", "1; 0; 0", "--rotation", 1)):
            self.assertSays(self.fail_with(2, *line, *more), "dimension 3", "surface")

    def test_another_flow_is_not_gone_on_with(self):
        line = ("flow", golden("uv8.off"), "--vorticity", "z", "--until", 1, "--checkpoint",
                "a.checkpoint")
        self.succeed(*line)
        for more in (("--viscosity", 0.1), ("--scheme", "imex"), ("--rotation", "z")):
            self.assertSays(self.fail_with(2, *line, *more, "--resume"), "a.checkpoint", "another")
