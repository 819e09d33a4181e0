# SPDX-License-Identifier: MIT
"""The subcommand maxwell, and runs and spectra that are stopped and resumed."""
import math
import signal

from command import TestCase, golden
from kills import ended_runs, kills, resumed_series, timed

PULSE = ("--degree", 0, "--initial", "exp(-200*((x-.5)^2+(y-.5)^2))")


class Waves(TestCase):
    def test_of_cells_that_are_all_fixed_every_step_is_stable(self):
        self.succeed("generate", "kuhn", "--cells", 1, "-o", "cube.nsc")
        answer = self.ask("maxwell", "cube.nsc", "--initial", "y;x;0", "--until", 1)
        self.assertIsNone(answer["stable_step"])
        self.assertEqual((answer["max"], answer["energy"]), (0, 0))
        # of a size that energies have no double for
        lines = self.read("cube.nsc").split("\n")
        self.write("large.nsc", "\n".join(lines[:1] + [line.replace("1", "1e150")
                                                       for line in lines[1:9]] + lines[9:]))
        answer = self.ask("maxwell", "large.nsc", "--initial", "1;0;0", "--until", 1e150,
                          "--natural")
        self.assertIsNone(answer["energy"])
        self.assertGreater(answer["relative_energy"], 0)

    def test_a_layer_swallows_what_a_wall_throws_back(self):
        square = self.generate("grid", "--nx", 40, "--ny", 40)
        line = ("maxwell", square, *PULSE, "--until", 2)
        kept = self.ask(*line)
        self.assertAlmostEqual(kept["relative_energy"], 1, delta=1e-11)
        self.assertNotIn("layer", kept)
        layer = self.ask(*line, "--absorb", 0.25)
        self.assertEqual(layer["layer"], "stretched")
        self.assertLess(layer["relative_energy"], 1e-3)
        conducting = self.ask(*line, "--absorb", 0.25, "--layer", "conducting")
        self.assertEqual(conducting["layer"], "conducting")
        self.assertLess(conducting["relative_energy"], 1e-2)
        self.assertSays(self.fail_with(1, *line, "--layer", "conducting"), "--layer", "--absorb")
        self.assertSays(self.fail_with(1, *line, "--pulse", "sin(t)"), "--pulse", "--current")
        self.assertSays(self.fail_with(2, *line, "--absorb", 2), "layer", 2, "expected",
                        "above 0", "below 1")

    def test_conductors_and_materials(self):
        square = self.generate("grid", "--nx", 16, "--ny", 16)
        for side in ("primal", "dual"):
            line = ("maxwell", square, *PULSE, "--until", 1, "--side", side)
            empty = self.ask(*line)
            self.assertEqual(empty["side"], side)
            lossy = self.ask(*line, "--conductivity", 3)
            self.assertLess(lossy["relative_energy"], 0.2)
            for material in ("--permittivity", "--permeability"):
                dense = self.ask(*line, material, "4")
                self.assertAlmostEqual(dense["stable_step"], 2 * empty["stable_step"], delta=1e-6)
                self.assertSays(self.fail_with(2, *line, material, "-1"), material[2:], "-1",
                                "expected", "positive")
            # what conducts and is dense as well loses a quarter as fast
            slow = self.ask(*line[:-4], "--until", 4, *line[-2:], "--conductivity", 3,
                            "--permittivity", 4)
            even = self.ask(*line[:-4], "--until", 4, *line[-2:], "--conductivity", 0.75)
            self.assertAlmostEqual(math.log(slow["relative_energy"]),
                                   math.log(even["relative_energy"]), delta=0.3)

    def test_currents_drive_a_resonator(self):
        # from nothing, J = -sin(pi x) sin(pi y) cos(w t) with w the frequency makes E of the size t / 2
        square = self.generate("grid", "--nx", 32, "--ny", 32)
        frequency = math.sqrt(2) * math.pi
        end = 4 * math.pi / frequency
        line = ("maxwell", square, "--degree", 0, "--current", "-sin(pi*x)*sin(pi*y)", "--until",
                end)
        for side in ("dual", "primal"):
            answer = self.ask(*line, "--pulse", f"cos({frequency!r}*t)", "--side", side)
            self.assertAlmostEqual(answer["max"], end / 2, delta=0.02 * end)
            # in a material four times as dense, half as often and a quarter as much at a time
            dense = self.ask(*line, "--pulse", f"cos({frequency / 2!r}*t)", "--side", side,
                             "--permittivity", 4)
            self.assertAlmostEqual(dense["max"], end / 8, delta=0.02 * end)
        other = self.ask(*line, "--pulse", f"cos({2 * frequency!r}*t)")
        self.assertLess(other["max"], 0.2 * end)
        self.assertSays(self.fail_with(2, *line, "--pulse", "x*t"), "--pulse: ", "'x*t'", "x, y or z")

    def test_light_in_space(self):
        box = self.path("box.mesh")
        self.succeed("generate", "kuhn", "--cells", 6, "-o", box)
        field = ("--initial", "0; 0; sin(pi*x)*sin(pi*y)")
        for side, nearest in (("primal", 0.5), ("dual", 5 / 12)): # an edge to the middle
            answer = self.ask("maxwell", box, *field, "--until", math.sqrt(2) / 2, "--side", side)
            ends = answer["min"], answer["max"] # dual edges may point down
            peak = math.sin(math.pi * nearest) ** 2 / 6
            self.assertAlmostEqual(max(map(abs, ends)), peak, delta=0.03 * peak)
            self.assertLess(min(map(abs, ends)), 1e-9)
        self.assertIn("perfect conductor", self.succeed("maxwell", "--help").out)
        self.fail_with(1, "maxwell", box, "--until", 1)

    def test_stopped_runs_go_on_to_the_same_bits(self):
        square = self.generate("grid", "--nx", 60, "--ny", 60)
        line = ("maxwell", square, *PULSE, "--current", "x", "--pulse", "sin(9*t)", "--absorb",
                0.2, "--until", 40, "--frames", 4)
        between = False # not only after frames
        for attempt in range(20): # a busy machine may end a run before its first step
            answers = resumed_series(self, line, kills(6), (0.2 + attempt / 10, 0.9 + attempt / 10),
                                     signals=(signal.SIGINT, signal.SIGTERM, signal.SIGKILL))
            between = any(4 * each["resumed_at"] % each["steps"] != 0 for each in answers)
            if between:
                break
        self.assertTrue(between)

    def test_spectra_go_on_with_what_was_found(self):
        sphere = self.generate("icosphere", "--frequency", 16)
        line = ("spectrum", sphere, "--side", "primal", "--degree", 0, "--count", 150)
        whole, took = timed(self, *line)
        self.assertNotIn("resumed_with", whole)
        part = (*line, "--checkpoint", "part.checkpoint", "--resume")
        resumed = 0
        for answer in ended_runs(self, part, ("part.checkpoint",), kills(6),
                                 (0.3 * took, 1.5 * took), (signal.SIGINT, signal.SIGKILL)):
            resumed = max(resumed, answer["resumed_with"])
            self.assertTrue(answer["certificate"]["complete"])
            for one, other, radius in zip(answer["eigenvalues"], whole["eigenvalues"],
                                          map(sum, zip(answer["radii"], whole["radii"]))):
                self.assertLessEqual(abs(one - other), radius)
        self.assertGreater(resumed, 0)

    def test_wrong_checkpoints_of_spectra_are_refused(self):
        line = ("spectrum", golden("uv8.off"), "--side", "primal", "--count", 9)
        kept = ("--checkpoint", "a.checkpoint", "--resume")
        first = self.ask(*line, "--degree", 0, *kept)
        self.assertEqual(first["resumed_with"], 0)
        again = self.ask(*line[:-1], 12, "--degree", 0, *kept)
        self.assertGreaterEqual(again["resumed_with"], 9)
        self.assertTrue(again["certificate"]["complete"])
        for count in (12, 5): # which all are there
            words = (*line[:-1], count, "--degree", 0, *kept)
            less = self.ask(*words)
            self.assertEqual(less["linear_solver"], "none")
            self.assertTrue(less["certificate"]["complete"])
            for one, other in zip(less["eigenvalues"], again["eigenvalues"]):
                self.assertAlmostEqual(one, other, delta=1e-9)
            self.assertSays(self.succeed(*words).out, "checkpoint", "all vectors")
        for wrong in ((*line, "--degree", 1), ("spectrum", golden("grid4.nsc"), *line[2:],
                                               "--degree", 0)):
            self.assertSays(self.fail_with(2, *wrong, *kept), "a.checkpoint", "another")
        self.fail_with(1, *line, "--degree", 0, "--resume")
        self.fail_with(2, *line, "--degree", 0, "--checkpoint", "a.txt")
