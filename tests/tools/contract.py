# SPDX-License-Identifier: MIT
"""What programs may rely on: exit codes, JSON, messages."""
import os
import signal
import subprocess
import time

import command
from command import TestCase, golden, run
from motions import nsc, off, squares

PLAIN = ("--star", "circumcentric")


class Json(TestCase):
    def test_info(self):
        answer = self.ask("info", golden("grid4.nsc"))
        self.assertLessEqual(
            {"dimension", "ambient_dimension", "cells", "euler", "betti", "components",
             "boundary_components", "orientable", "volume", "facets", "stars",
             "vertices_per_cell", "concyclic", "unjoined", "warnings"}, set(answer))
        self.assertEqual(answer["unjoined"], {"coincident": 0, "hanging": 0, "misfits": 0})
        for key in ("cells", "euler", "betti"):
            self.assertEqual(set(answer[key]), {"input", "merged"})
        self.assertEqual(set(answer["facets"]),
                         {"degenerate", "boundary_degenerate", "branching_degenerate"})
        self.assertEqual(len(answer["stars"]), 3)
        for star in answer["stars"]:
            self.assertEqual(set(star), {"min", "max", "min_abs", "negative", "zero", "diagonal",
                                         "condition"})
        self.assertEqual(answer["concyclic"], {"edges": 16, "faces": 32, "percent": 100})
        self.assertEqual((answer["dimension"], answer["orientable"], answer["volume"]),
                         (2, True, 1))

    def test_info_of_other_dimensions_has_no_concyclic_edges(self):
        for name in ("kuhn1d.nsc", "kuhn3.nsc", "kuhn4.nsc"):
            self.assertNotIn("concyclic", self.ask("info", golden(name)))

    def test_the_share_of_concyclic_triangles_is_of_those_that_flips_and_splits_have_made(self):
        self.write("sheared.off", off(*squares(8, 1, lambda i, j: (i + 3 * j, 0.5 * j, 0))))
        answer = self.ask("info", "sheared.off", "--delaunay=split-boundary")
        triangles = answer["intrinsic"]["cells"][2]
        self.assertGreater(triangles, answer["cells"]["input"][2])
        share = answer["concyclic"]
        self.assertGreater(share["faces"], 0)
        self.assertEqual(share["percent"], 100 * share["faces"] / triangles)

    def test_spectrum_tells_of_spurious_eigenvalues_beside_large_ones(self):
        """The small triangle has an eigenvalue of 1e13."""
        kite = "0 0 0\n1 -.2 0\n1 .25 0\n2 0 0\n"
        small = "5 5 0\n5.000001 5 0\n5.0000004 5.0000009 0\n"
        faces = "3 0 3 2\n3 0 1 3\n"
        self.write("kite.off", f"OFF\n4 2 0\n{kite}{faces}")
        self.write("both.off", f"OFF\n7 3 0\n{kite}{small}{faces}3 4 5 6\n")
        for name, count in (("kite.off", 2), ("both.off", 2), ("both.off", 3)):
            answer = self.ask("spectrum", name, *PLAIN, "--side", "dual", "--degree", 0, "--count",
                              count)
            self.assertLess(answer["eigenvalues"][0], -0.2)
            warning, = answer["warnings"]
            self.assertSays(warning, 1, "eigenvalues", "negative", "spurious", "1 cell",
                            "negative dual", "--delaunay")
        warning, = self.ask("poisson", "kite.off", *PLAIN, "--side", "dual", "--rhs",
                            "1")["warnings"]
        self.assertSays(warning, 1, "1-cells", "negative dual", "--side primal", "--delaunay")

    def test_spectrum(self):
        answer = self.ask("spectrum", golden("grid4.nsc"), "--side", "dual", "--degree", 1,
                          "--count", 7)
        self.assertLessEqual({"side", "degree", "eigenvalues", "residuals", "certificate",
                              "linear_solver", "eigen_solver", "seconds"}, set(answer))
        self.assertEqual((answer["side"], answer["degree"]), ("dual", 1))
        self.assertEqual(len(answer["eigenvalues"]), 7)
        self.assertEqual(len(answer["residuals"]), 7)
        self.assertEqual(answer["eigenvalues"], sorted(answer["eigenvalues"]))
        proof = answer["certificate"]
        self.assertEqual(set(proof),
                         {"shift", "below_shift", "returned_below_shift", "complete"})
        self.assertIs(proof["complete"], True)
        self.assertEqual(proof["below_shift"], proof["returned_below_shift"])
        self.assertGreater(proof["shift"], answer["eigenvalues"][-1])

    def test_spectra_and_poisson_say_which_condition_held_on_the_boundary(self):
        values = "values 0 on the boundary (Dirichlet)"
        flow = "no flow through the boundary (Neumann)"
        mixed = "values 0 on 4 of 16 boundary facets (Dirichlet), " \
            "no flow through 12 of 16 boundary facets (Neumann)"
        # exact: 0, 2 pi^2, pi^2 / 4
        asked = (([], None), (["--natural"], flow), (["--essential-where", "1"], values),
                 (["--essential-where", "x<0.001"], mixed))
        known = {flow: 0, values: 19.7, mixed: 2.47}
        for side, built_in in (("primal", flow), ("dual", values)):
            for options, words in asked:
                answer = self.ask("spectrum", golden("grid4.nsc"), "--side", side, "--degree", 0,
                                  "--count", 1, *options)
                self.assertEqual(answer["conditions"], words or built_in)
                self.assertAlmostEqual(answer["eigenvalues"][0], known[words or built_in],
                                       delta=0.06 * known[words or built_in] + 1e-9)
        for side in ("primal", "dual"):
            for options, words in asked[1:] + (([], values),):
                answer = self.ask("poisson", golden("grid4.nsc"), "--side", side, "--rhs=0",
                                  *options)
                self.assertEqual(answer["conditions"], words)
            given = self.ask("poisson", golden("grid4.nsc"), "--side", side, "--rhs=0",
                             "--boundary", "x", "--flux", "y", "--essential-where", "x<0.001")
            words = mixed.replace("values 0", "values given").replace("no flow", "flow given")
            self.assertEqual(given["conditions"], words)
        told = run("spectrum", golden("grid4.nsc"), "--side", "dual", "--degree", 0)
        self.assertIn("\n" + values + "\n", told.out)
        both = run("spectrum", golden("grid4.nsc"), "--side", "dual", "--degree", 0, "--natural",
                   "--essential-where", "1")
        self.assertEqual(both.code, 1)

    def test_a_count_that_cuts_a_cluster_is_certified_behind_it(self):
        # 9.37 comes twice
        answer = self.ask("spectrum", golden("grid4.nsc"), "--side", "primal", "--degree", 0,
                          "--count", 2)
        self.assertEqual(len(answer["eigenvalues"]), 2)
        self.assertEqual(answer["certificate"]["below_shift"], 3)

    def test_spectrum_without_proof(self):
        answer = self.ask("spectrum", golden("grid4.nsc"), "--side", "primal", "--degree", 0,
                          "--count", 2, "--no-certificate")
        self.assertIs(answer["certificate"]["complete"], False)

    def test_poisson(self):
        answer = self.ask("poisson", golden("hex4.nsc"), "--side", "dual", "--rhs=0",
                          "--boundary", "x-2*y", "--exact", "x-2*y")
        self.assertLessEqual({"side", "residual", "engine", "tried", "error"}, set(answer))
        self.assertLess(answer["residual"], 1e-10)
        self.assertLess(answer["error"]["max"], 1e-12)

    def test_mixed_boundary_data(self):
        for side in ("primal", "dual"):
            answer = self.ask("poisson", golden("grid4.nsc"), "--side", side, "--rhs", "0",
                              "--essential-where", "x < 0.001", "--boundary", "2*x+y", "--flux",
                              "2*(x>0.999) + (y>0.999) - (y<0.001)", "--exact", "2*x+y")
            self.assertEqual(answer["boundary"], "mixed")
            self.assertLess(answer["error"]["max"], 1e-12)

    def test_info_tells_kinds_of_pairs_and_which_operators_make_sense(self):
        answer = self.ask("info", golden("grid4.nsc"))
        self.assertEqual(answer["pairs"], {"well_centered": 24, "delaunay": 0, "non_delaunay": 0,
                                           "cospherical": 16})
        verdicts = {(row["operator"], row["degree"]): row for row in answer["operators"]}
        self.assertEqual(verdicts["star", 1]["input"], {"primal": "yes", "dual": "no"})
        self.assertEqual(verdicts["star", 2]["input"], {"primal": "restricted", "dual": "yes"})
        self.assertEqual(verdicts["star", 1]["merged"], {"primal": "yes", "dual": "yes"})
        self.assertEqual([star["condition"] for star in answer["stars"]], [4, 2, 1])
        self.assertIsNone(answer["input_stars"][1]["condition"])

    def test_backends(self):
        engines = {engine["name"]: engine for engine in self.ask("backends")["backends"]}
        self.assertLessEqual({"auto", "eigen.ldlt", "cholmod", "spectra"}, set(engines))
        for engine in engines.values():
            self.assertTrue(engine["available"] or engine["how_to_get"], engine)
            self.assertTrue(engine["license"], engine)
        self.assertIn("GPL", engines["cholmod"]["license"])

    def test_timing(self):
        arguments = {"info": (), "spectrum": ("--side", "primal", "--degree", 0, "--count", 2),
                     "poisson": ("--side", "primal", "--rhs", "1")}
        stages = {"read", "complex", "volumes", "merge", "stars", "operators", "solve", "bound",
                  "write"}
        for name, more in arguments.items():
            plain = self.ask(name, golden("uv8.off"), *more)
            timed = self.ask(name, golden("uv8.off"), *more, "--timing")
            self.assertEqual(set(timed) - set(plain), {"timing"})
            self.assertLessEqual({"read", "complex", "volumes", "merge"}, set(timed["timing"]))
            self.assertLessEqual(set(timed["timing"]) - {"topology"}, stages)
            self.assertTrue(all(seconds >= 0 for seconds in timed["timing"].values()))
        table = self.succeed("merge", golden("uv8.off"), "-o", "a.off", "--timing").out
        self.assertIn("\nseconds\n", table)

    def test_every_command_has_an_object_with_its_warnings(self):
        mesh = golden("branching.off")
        left_out = ("non-orientable", "not a manifold")
        for arguments, warned in (
                (("info", mesh), True), (("merge", mesh, "-o", "a.off"), True),
                (("operators", mesh, "--out", "out"), True),
                (("spectrum", mesh, "--side", "primal", "--degree", 0, "--count", 2), True),
                (("poisson", mesh, "--side", "primal", "--rhs", "1"), True),
                (("generate", "grid", "-o", "grid.off"), False),
                (("reproduce", "fig6"), False), (("reproduce", "--list"), False),
                (("backends",), False)):
            outcome = self.succeed(*arguments, "--json")
            warnings = command.parse(outcome.out)["warnings"]
            self.assertEqual(outcome.err,
                             "".join(f"polydec: warning: {text}\n" for text in warnings))
            self.assertEqual(any(word in text for text in warnings for word in left_out), warned,
                             arguments)

    def test_a_mean_that_was_removed_is_told_in_the_object(self):
        answer = self.ask("poisson", golden("uv8.off"), "--side", "primal", "--rhs", "1")
        warning, = answer["warnings"]
        self.assertSays(warning, "right-hand side", "1 component", "relative 1", "mean")
        self.assertEqual(self.ask("poisson", golden("uv8.off"), "--side", "primal", "--rhs",
                                  "z")["warnings"], [])

    def test_answers_of_commands_that_write(self):
        grid = self.ask("generate", "grid", "--nx", 3, "--ny", 2, "-o", "grid.off")
        self.assertEqual(grid, {"out": "grid.off", "points": 12, "simplices": 12, "dimension": 2,
                                "ambient_dimension": 2, "warnings": []})
        self.assertEqual(self.ask("merge", "grid.off", "-o", "merged.off"),
                         {"out": "merged.off", "dimension": 2, "cells": {"input": 12, "merged": 6},
                          "warnings": []})

    def test_without_json_there_is_a_text(self):
        for more in (("info",), ("spectrum", "--side", "primal", "--degree", 0, "--count", 2),
                     ("poisson", "--side", "primal", "--rhs", "1")):
            out = self.succeed(more[0], golden("uv8.off"), *more[1:]).out
            self.assertGreater(len(out.splitlines()), 2)


class Usage(TestCase):
    def test_wrong_usage_is_code_1(self):
        mesh = golden("grid4.nsc")
        for arguments, words in (
                (("frobnicate",), ("'frobnicate'",)),
                (("info", "--foo"), ("'--foo'",)),
                (("info", mesh, "--tolerance", "-1"),
                 ("--tolerance: ", "expected", "number", 0, "'-1'")),
                (("info", mesh, "--no-merge", "--angle-tolerance", "1e-3"),
                 ("--angle-tolerance", "--no-merge")),
                (("generate", "sponge", "-o", "a.off"), ("'sponge'",)),
                (("spectrum", mesh, "--side", "both", "--degree", "0"),
                 ("--side: ", "primal", "dual", "'both'")),
                (("poisson", mesh, "--side", "dual", "--rhs", "1", "--natural", "--boundary", "x"),
                 ("--boundary", "--natural")),
                (("poisson", mesh, "--side", "dual", "--rhs", "x+"),
                 ("--rhs: ", "'x+'", "expression", "end", "position 3"))):
            self.assertSays(self.fail_with(1, *arguments), *words)

    def test_bad_input_is_code_2(self):
        flat, solid = golden("grid4.nsc"), golden("kuhn3.nsc")
        for arguments, words in (
                (("info", solid, "--angle-tolerance", "1e-3"),
                 ("--angle-tolerance", solid, "dimension 3", "--tolerance")),
                (("draw", golden("uv8.off"), "--eye", 0, 0, 0), ("'eye'", "zero")),
                (("merge", solid, "-o", "a.off"), ("a.off: ", "dimension 3", ".vtu")),
                (("spectrum", flat, "--side", "primal", "--degree", 0, "--count", 26),
                 (f"{flat}: ", "26 eigenvalues", "primal 0-forms", 25, "0-cells", 1, 25)),
                (("spectrum", golden("kuhn4.nsc"), "--side", "dual", "--degree", 0, "--count", 1,
                  "-o", "a.vtu"),
                 ("dimension 4", "4 coordinates", ".vtu", 3, "-o")),
                (("poisson", flat, "--side", "primal", "--rhs", "1/x"),
                 ("--rhs: ", "'1/x'", "inf", "(0, 0)")),
                (("generate", "grid", "--nx", "0", "-o", "a.off"),
                 ("grid: ", "nx = 0", "1 .. 2147483647"))):
            self.assertSays(self.fail_with(2, *arguments), *words)
        self.assertEqual(os.listdir(self.folder), [])

    def test_a_system_that_no_engine_solves_is_code_3(self):
        mesh = self.almost_squares(30, 3e-12)
        message = self.fail_with(3, "poisson", mesh, *PLAIN, "--side", "dual", "--rhs", "1",
                                 "--no-merge", "--json")
        self.assertSays(message, "no engine")

    def almost_squares(self, N, defect):
        """A grid of split squares, one corner of each moved off the circle through the others:
        unmerged, half the duals are almost zero."""
        return self.write("squares.nsc", nsc(*squares(N, N, lambda i, j: (
            i / N + (defect if i % 2 == j % 2 == 0 else 0), j / N))))

    def test_files_that_cannot_be_read_are_code_4(self):
        self.assertSays(self.fail_with(4, "info", "no.off"), "read", "no.off: ", "No such file")
        os.mkdir(self.path("folder.off"))
        self.fail_with(4, "info", "folder.off")

    def test_files_that_cannot_be_written_are_code_4_and_leave_nothing(self):
        for arguments in (("generate", "grid", "-o", "no/a.off"),
                          ("operators", golden("grid4.nsc"), "--out", "/proc/operators")):
            self.fail_with(4, *arguments)
            self.assertEqual(os.listdir(self.folder), [], arguments)

    def interrupt(self, seconds, *arguments):
        """Starts the command and interrupts it after a while; its exit code."""
        with self.start(*arguments, stderr=subprocess.DEVNULL) as process:
            time.sleep(seconds)
            process.send_signal(signal.SIGINT)
            started = time.monotonic()
            code = process.finish(20).code
        self.assertLess(time.monotonic() - started, 5)
        return code

    def test_an_interrupt_leaves_no_unfinished_file(self):
        self.succeed("generate", "kuhn", "--dimension", "3", "--cells", "24", "-o", "big.nsc")
        code = self.interrupt(0.5, "spectrum", "big.nsc", "--side", "primal", "--degree", "1",
                              "--count", "200", "-o", "modes.vtu")
        self.assertEqual(code, -signal.SIGINT)
        self.assertEqual(os.listdir(self.folder), ["big.nsc"])

    def test_an_interrupt_while_writing_leaves_whole_files_only(self):
        self.succeed("generate", "grid", "-o", "grid.nsc", "--nx", "60", "--ny", "60")
        self.succeed("operators", "grid.nsc", "--out", "whole")
        whole = set(os.listdir(self.path("whole")))
        for i in range(8):
            self.interrupt(0.05 + 0.03 * i, "operators", "grid.nsc", "--out", f"out{i}")
            folder = self.path(f"out{i}")
            if not os.path.isdir(folder):
                continue
            self.assertLessEqual(set(os.listdir(folder)), whole)
            for name in os.listdir(folder):
                self.assertEqual(self.read(f"out{i}/{name}"), self.read(f"whole/{name}"))
