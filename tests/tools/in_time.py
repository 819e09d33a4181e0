# SPDX-License-Identifier: MIT
"""The subcommands heat and wave: decay, swing, series, and runs that are killed and resumed."""
import math
import os
import signal
import subprocess

import command
from command import TestCase, golden
from kills import kills, resumed_series
from motions import Mesh


class InTime(TestCase):
    def test_heat_on_a_sphere_decays_as_harmonics_do(self):
        for side in ("primal", "dual"):
            sphere = self.generate("icosphere", "--frequency", 24)
            errors = []
            for step in (0.02, 0.01):
                answer = self.ask("heat", sphere, "--side", side, "--initial", "z", "--until", 0.5,
                                  "--time-step", step, "--integrator", "implicit-midpoint")
                self.assertEqual(answer["steps"], round(0.5 / step))
                errors.append(abs(answer["relative_norm"] / math.exp(-2 * 0.5) - 1))
            self.assertLess(errors[-1], 0.01)
            rough = self.ask("heat", sphere, "--side", side, "--initial", "z", "--until", 0.5,
                             "--time-step", 0.02)["relative_norm"]
            self.assertGreater(abs(rough / math.exp(-1) - 1), errors[0])

    def test_conditions_decide_what_is_left(self):
        grid = golden("grid4.nsc")
        kept = self.ask("heat", grid, "--side", "primal", "--initial", "1", "--until", 0.5)
        self.assertAlmostEqual(kept["relative_norm"], 1, delta=1e-12)
        lost = self.ask("heat", grid, "--side", "primal", "--initial", "1", "--until", 0.5,
                        "--essential-where", "1")
        self.assertLess(lost["relative_norm"], 1e-3)
        self.assertIn("Dirichlet", lost["conditions"])
        built_in = self.ask("heat", grid, "--side", "dual", "--initial", "1", "--until", 0.5)
        self.assertLess(built_in["relative_norm"], 1e-3)

    def test_heat_takes_sources_and_boundary_values_in_time(self):
        """u = (1 + t) (1 + x + 2 y) is a solution that linear functions hold exactly."""
        grid = golden("grid4.nsc")
        u = "(1+x+2*y)"
        where = {"primal": ("--essential-where", "1"), "dual": ()}
        for side, conditions in where.items():
            answer = self.ask("heat", grid, "--side", side, "--initial", u, "--source", u,
                              "--boundary-values", f"(1+t)*{u}", "--until", 1,
                              "--tolerance-in-time", 1e-7, *conditions)
            self.assertAlmostEqual(answer["relative_norm"], 2, delta=1e-6)
            self.assertEqual(answer["integrator"], "runge-kutta")
            without = self.ask("heat", grid, "--side", side, "--initial", u, "--source", u,
                               "--until", 1, *(conditions or ("--essential-where", "1")))
            self.assertLess(without["relative_norm"], 0.5)

    def test_heat_takes_a_flux_in_time(self):
        """(1 + t) (1 + x + 2 y) again, with Robin's condition or without."""
        grid = golden("grid4.nsc")
        u, slope = "(1+x+2*y)", "((x>.99)-(x<.01)+2*(y>.99)-2*(y<.01))"
        for side in ("primal", "dual"):
            for robin, data in (((), f"(1+t)*{slope}"),
                                (("--robin", 0.5), f"(1+t)*({slope}+.5*{u})")):
                line = ("heat", grid, "--side", side, "--initial", u, "--source", u, "--until", 1,
                        "--tolerance-in-time", 1e-7, *(robin or ("--natural",)))
                answer = self.ask(*line, "--flux", data)
                at_corners = 2e-3 if robin and side == "primal" else 1e-5 # values beside, not there
                self.assertAlmostEqual(answer["relative_norm"], 2, delta=at_corners)
                self.assertNotAlmostEqual(self.ask(*line)["relative_norm"], 2, delta=1e-2)

    def test_what_begins_with_nothing_has_no_part_of_it(self):
        grid = golden("grid4.nsc")
        line = ("heat", grid, "--side", "primal", "--initial", "0", "--source", "1", "--until", 1)
        self.assertIsNone(self.ask(*line)["relative_norm"])
        self.assertIn("L2 norm 1\n", self.succeed(*line).out)
        driven = ("maxwell", grid, "--degree", 0, "--current", "1", "--until", 1)
        self.assertIsNone(self.ask(*driven)["relative_energy"])
        still = ("flow", grid, "--viscosity", 1, "--no-slip-where", "1", "--boundary-velocity",
                 "(y>.99)*1; 0", "--until", 0.1)
        self.assertIsNone(self.ask(*still)["relative_energy"])
        self.assertNotIn("beginning", self.succeed(*still).out)

    def test_a_tolerance_in_time_is_kept(self):
        sphere = self.generate("icosphere", "--frequency", 8)
        ends = [self.ask("heat", sphere, "--side", "primal", "--initial", "z", "--until", 1,
                         "--source", "sin(9*t)*z", "--frames", 3, "--tolerance-in-time", tolerance)
                for tolerance in (1e-2, 1e-5, 1e-8)]
        errors = [abs(end["relative_norm"] - ends[2]["relative_norm"]) for end in ends]
        self.assertLess(errors[0], 1e-2)
        self.assertLess(errors[1], 1e-5)
        self.assertGreater(ends[2]["integrator_steps"], ends[0]["integrator_steps"])
        fixed = self.ask("heat", sphere, "--side", "primal", "--initial", "z", "--until", 1,
                         "--source", "sin(9*t)*z", "--frames", 3, "--time-step", 0.05)
        self.assertEqual(fixed["integrator_steps"], 21)

    def test_a_source_that_starts_from_0_is_followed_in_any_unit(self):
        square = self.generate("grid", "--nx", 8, "--ny", 8)
        shares = [self.ask("heat", square, "--side", "primal", "--initial", 0, "--source",
                           f"{size}*exp(-((t-.27)/.02)^2)*(t>.2)*(t<.34)", "--until", 1, "--frames",
                           20)["max"] / size for size in (1, 1e-6, 1e-9)]
        for share in shares:
            self.assertAlmostEqual(share / (math.sqrt(math.pi) / 50), 1, delta=1e-4)
            self.assertAlmostEqual(share / shares[0], 1, delta=1e-9)

    def test_what_a_source_goes_without_is_told(self):
        grid = golden("grid4.nsc")
        heat = ("heat", grid, "--side", "primal", "--initial", "1", "--until", 1)
        self.assertSays(self.fail_with(2, *heat, "--tolerance-in-time", 1e-4, "--integrator",
                                       "backward-euler"), "--tolerance-in-time", "backward-euler")
        self.assertSays(self.fail_with(1, *heat, "--tolerance-in-time", 1e-4, "--integrator",
                                       "runge-kutta", "--time-step", .05), "--time-step", "excludes",
                        "--tolerance-in-time")
        self.assertSays(self.fail_with(2, *heat, "--boundary-values", "t"),
                        "--boundary-values", "essential", "--essential-where")
        self.assertSays(self.fail_with(2, *heat, "--integrator", "foo"), "integrator", "`foo`")
        self.assertSays(self.fail_with(2, *heat, "--integrator", "cvode", "--time-step", .1),
                        "cvode", "omit --time-step")
        self.assertIn("Unexpected token", self.fail_with(1, *heat, "--source", "q"))

    def test_a_long_frame_is_ended_on_its_way(self):
        """The tolerance asks for more steps to the first frame than anybody waits for."""
        sphere = self.generate("icosphere", "--frequency", 30)
        with self.start("heat", sphere, "--side", "primal", "--initial", "z", "--source",
                        "sin(1e5*t)*z", "--until", 9, "--frames", 1, "--tolerance-in-time", 1e-13,
                        "--checkpoint", "long.checkpoint") as run:
            with self.assertRaises(subprocess.TimeoutExpired):
                run.wait(timeout=2)
            run.send_signal(signal.SIGINT)
            self.assertEqual(run.finish().code, -signal.SIGINT)
        self.assertTrue(os.path.exists(self.path("long.checkpoint"))) # of the beginning

    def test_a_run_that_is_resumed_counts_the_steps_since_then(self):
        line = ("heat", golden("grid4.nsc"), "--side", "primal", "--initial", "x", "--source", "t",
                "--until", 1, "--checkpoint", "a.checkpoint", "--resume")
        self.assertNotIn("since then", self.succeed(*line).out)
        self.assertSays(self.succeed(*line).out, "resumed after step", "0 steps since then")

    def test_waves_swing_back_and_keep_their_energy(self):
        square = self.generate("grid", "--nx", 32, "--ny", 32)
        line = ("wave", square, "--initial", "sin(pi*x)*sin(pi*y)", "--until")
        half = math.sqrt(2) / 2
        for more in (("--side", "dual"), ("--side", "primal", "--essential-where", 1)):
            for time_, factor in ((half, -1), (2 * half, 1)):
                answer = self.ask(*line, time_, *more)
                self.assertEqual(answer["side"], more[1])
                largest = max(answer["min"], answer["max"], key=abs)
                self.assertAlmostEqual(largest, factor, delta=0.01)
                self.assertAlmostEqual(answer["relative_energy"], 1, delta=1e-11)
                self.assertLess(answer["time_step"], answer["stable_step"])
        free = self.ask(*line, half, "--side", "dual", "--natural")
        self.assertGreater(abs(free["min"] + 1), 0.1)
        self.assertSays(self.fail_with(2, "wave", square, "--initial", "x", "--until", 1,
                                       "--time-step", 2 * answer["stable_step"]), "step", "above 0",
                        "below")

    def test_values_of_extreme_size_have_norms_and_do_not_grow(self):
        mesh = golden("grid4.nsc")
        heat = ("heat", mesh, "--side", "primal", "--until", 0.1)
        one = self.ask(*heat, "--initial", "x")["relative_norm"]
        for size in ("1e-200", "1e200"):
            self.assertAlmostEqual(self.ask(*heat, "--initial", f"{size}*x")["relative_norm"], one,
                                   delta=1e-9)
            told = self.succeed(*heat, "--initial", f"{size}*x").out
            norm = float(told.rpartition("L2 norm ")[2].partition(",")[0])
            self.assertAlmostEqual(norm / float(size) / one / math.sqrt(1 / 3), 1, delta=0.1)
        self.write("large.nsc", Mesh.read(mesh).times(1e80).text())
        forms = ("--side", "primal", "--degree", 1, "--initial", "-y; x")
        self.assertAlmostEqual(
            self.ask("heat", "large.nsc", *forms, "--until", "1e159")["relative_norm"],
            self.ask("heat", mesh, *forms, "--until", 0.1)["relative_norm"], delta=1e-9)
        wave = ("wave", mesh, "--until", 0.5)
        for size in ("1e-200", "1e200"):
            answer = self.ask(*wave, "--initial", f"{size}*x")
            self.assertAlmostEqual(answer["relative_energy"], 1, delta=1e-9)
            self.assertIsNone(answer["energy"]) # whose square no double can hold

    def test_steps_by_a_tolerance_are_the_same_in_every_unit(self):
        forms = {0: "sin(3*{x})", 1: "sin(3*{x})/{s}; {x}*y/{s}/{s}", 2: "sin(3*{x})/{s}/{s}"}
        counts = {}
        for exponent in (0, 10, -20, 100, -100):
            size = 2.0 ** exponent
            self.write("scaled.nsc", Mesh.read(golden("grid4.nsc")).times(size).text())
            slopes = ("--natural", "--flux", f"1e3*x/({size!r})/({size!r})")
            for side, degree, start, more in (
                    ("primal", 0, 1, ()), ("primal", 1, 1, ()), ("primal", 2, 1, ()),
                    ("dual", 1, 1, ()), ("primal", 0, 0, slopes), ("dual", 0, 0, slopes)):
                form = forms[degree].format(x=f"x/({size!r})", s=f"({size!r})") if start else "0"
                answer = self.ask("heat", "scaled.nsc", "--side", side, "--degree", degree,
                                  "--initial", form, "--until", 0.1 * size ** 2,
                                  "--tolerance-in-time", 1e-4, *more)
                counts.setdefault((side, degree, start), set()).add(
                    (answer["integrator_steps"], answer["integrator_rejected"]))
        for kind, numbers in counts.items():
            self.assertEqual(len(numbers), 1, (kind, numbers))

    def test_a_series_has_every_frame(self):
        for name, more in (("heat", ("--side", "dual")), ("wave", ())):
            answer = self.ask(name, golden("uv8.off"), "--initial", "z", "--until", 1, "--frames", 7,
                              "-o", "s.pvd", *more)
            times, files = self.steps_of("s.pvd")
            self.assertEqual(len(times), answer["frames"])
            self.assertEqual(times[0], 0)
            self.assertAlmostEqual(times[-1], 1, delta=1e-12)
            self.assertEqual(files, [f"s/s_{i:04}.vtu" for i in range(len(files))])
            self.succeed(name, golden("uv8.off"), "--initial", "z", "--until", 1, "-o", "s.html",
                         *more)
            self.succeed("view", "s.pvd", "-o", "t.html")

    def test_forms_of_other_degrees_come_from_files(self):
        edges = self.ask("info", golden("uv8.off"))["cells"]["merged"][1]
        self.write("form.txt", "\n".join(str(math.sin(i)) for i in range(edges)))
        for name, more in (("heat", ("--side", "primal")), ("wave", ())):
            answer = self.ask(name, golden("uv8.off"), "--degree", 1, "--initial", "form.txt",
                              "--until", 0.5, *more)
            self.assertEqual(answer["degree"], 1)
            self.assertSays(self.fail_with(
                2, name, golden("uv8.off"), "--degree", 1, "--initial", "x", "--until", 1, *more),
                "--initial", "1-form", "3 coordinates", 3)
            self.ask(name, golden("uv8.off"), "--degree", 1, "--initial", "-y; x; 0", "--until", 1,
                     *more)
            self.assertSays(self.fail_with(
                2, name, golden("uv8.off"), "--degree", 0, "--initial", "form.txt", "--until", 1,
                *more), "form.txt", edges, "expected")

    def test_checkpoints_know_every_option_and_what_files_hold(self):
        """Whatever is changed of what makes the numbers, a run does not go on."""
        self.succeed("generate", "grid", "--nx", 4, "--ny", 4, "-o", "g.off")
        ones = "1\n" * 25
        self.write("one.txt", ones)
        base = {"--side": "primal", "--initial": "x", "--until": 1, "--time-step": 0.05,
                "--frames": 4, "--source": "one.txt", "--essential-where": "x<0.001",
                "--boundary-values": "one.txt"}

        def heat(changed=(), *more):
            options = {**base, **dict(changed)}
            return ("heat", "g.off", *[word for pair in options.items() for word in pair],
                    "--checkpoint", "a.checkpoint", *more)

        self.succeed(*heat())
        self.succeed(*heat((), "--resume", "--timing"))
        others = {"--initial": "y", "--until": 2, "--time-step": 0.04, "--frames": 5,
                  "--source": 2, "--essential-where": "x>0.999", "--boundary-values": 2}
        for option, value in others.items():
            with self.subTest(option):
                told = self.fail_with(2, *heat({option: value}, "--resume"))
                self.assertSays(told, "a.checkpoint", "another")
        for more in (("--star", "galerkin"), ("--no-merge",), ("--engine", "eigen.ldlt"),
                     ("--flux", 1), ("--robin", 2), ("--tolerance-in-time", 1e-3)):
            with self.subTest(more):
                self.assertNotEqual(
                    command.run(*heat((), *more, "--resume"), folder=self.folder).code, 0)
        self.write("one.txt", "1\n" * 24 + "2\n")
        self.fail_with(2, *heat((), "--resume"))
        self.write("same.txt", ones)
        self.succeed(*heat({"--source": "same.txt", "--boundary-values": "same.txt"}, "--resume",
                           "--tolerance", 1e-3)) # by which the same cells are joined

    def test_series_know_their_run(self):
        heat = ("heat", golden("uv8.off"), "--side", "primal", "--until", 1, "-o", "a.pvd")
        self.succeed(*heat, "--initial", "z", "--checkpoint", "a.checkpoint")
        self.succeed(*heat, "--initial", "x")
        self.assertSays(self.fail_with(2, *heat, "--initial", "z", "--checkpoint", "a.checkpoint",
                                       "--resume"), "a.pvd", "another run")

    def test_what_cannot_be_done_is_refused(self):
        heat = ("heat", golden("uv8.off"), "--side", "primal", "--initial", "z", "--until", 1)
        self.succeed(*heat, "--checkpoint", "a.checkpoint")
        self.assertSays(self.fail_with(2, *heat, "--time-step", 0.001, "--checkpoint",
                                       "a.checkpoint", "--resume"), "a.checkpoint", "another")
        self.write("b.checkpoint", "polydec checkpoint 1\n")
        self.assertSays(self.fail_with(2, *heat, "--checkpoint", "b.checkpoint", "--resume"),
                        "b.checkpoint", "cut off")
        self.assertSays(self.fail_with(2, *heat, "--checkpoint", "a.checkpoint", "--resume", "-o",
                                       "a.html"), "cannot resume", "a.html: ", "all frames")
        self.fail_with(2, *heat, "-o", "a.vtu")
        self.fail_with(2, *heat, "--checkpoint", "a.txt")
        self.fail_with(2, *heat[:-1], 1e12, "--time-step", 1e-3)
        for wrong in (0, -1, "nan"):
            for line in (heat[:-1], ("wave", *heat[1:2], "--initial", "z", "--until"),
                         ("maxwell", *heat[1:2], "--until"), ("flow", *heat[1:2], "--until")):
                self.assertIn("--until", self.fail_with(1, *line, wrong))
        self.fail_with(1, *heat, "--resume")

    def test_a_norm_that_is_no_number_is_told_apart_from_one_out_of_range(self):
        """A triangle with two negative duals, whose values are all given, beside a hexagon."""
        around = [(math.cos(k * math.pi / 3), math.sin(k * math.pi / 3)) for k in range(6)]
        points = [(0, 0), *around, (100, 9), (0, 10), (-100, 9)]
        cells = [*((0, k + 1, (k + 1) % 6 + 1) for k in range(6)), (7, 8, 9)]
        self.write("apart.nsc", f"2 2 {len(points)} {len(cells)}\n" +
                   "".join("%r %r\n" % each for each in points) +
                   "".join("%d %d %d\n" % each for each in cells))
        heat = ("heat", "apart.nsc", "--side", "primal", "--star", "circumcentric", "--initial", "x",
                "--essential-where", 1, "--boundary-values", "x", "--until", .1, "--time-step", .05)
        self.assertSays(self.fail_with(2, *heat), "squared norm", "0-cells", "negative duals")

    def test_a_long_run_says_in_a_file_too_what_it_will_do(self):
        sphere = self.generate("icosphere", "--frequency", 20)
        begin, end = "polydec: {}: ", "; about [0-9,]+ (min|h|days|years){}, .*B of memory; {} .*"
        for name, more, steps, pace, option in (
                ("wave", ("--initial", "z"), "[0-9,]+ steps of .*stability", "", "--time-step"),
                ("heat", ("--side", "primal", "--initial", "z", "--source", "sin(1e5*t)*z"),
                 "adaptive steps, limited by the error", " at the pace so far",
                 "--tolerance-in-time")):
            with open(self.path("said.txt"), "w", encoding="ascii") as said, \
                    self.start(name, sphere, *more, "--until", 1e6, stderr=said) as run:
                command.wait_until(lambda: "\n" in self.read("said.txt"), "a sentence of a run")
                self.assertIsNone(run.poll())
            self.assertRegex(self.read("said.txt"), "^" + begin.format(name) + steps + ".*" +
                             end.format(pace, option) + "\n$")
            self.assertEqual(self.succeed(name, sphere, *more, "--until", 1e-3).err, "")

    def test_killed_runs_go_on_to_the_same_bits(self):
        sphere = self.generate("icosphere", "--frequency", 20)
        for name, more in (("heat", ("--side", "dual", "--until", 0.1, "--frames", 40)),
                           ("heat", ("--source", "sin(9*t)*z", "--until", 2, "--frames", 40)),
                           ("wave", ("--until", 1, "--frames", 40))):
            resumed_series(self, (name, sphere, "--initial", "exp(-9*(x-1)^2)", *more),
                           kills(10) // 2)
