# SPDX-License-Identifier: MIT
"""What programs may rely on in the files that are written and read."""
import os
import re

from command import TestCase, golden


class Files(TestCase):
    def test_a_merged_file_has_as_many_faces_as_there_are_merged_cells(self):
        self.succeed("merge", golden("grid4.nsc"), "-o", "a.off")
        with open(self.path("a.off"), encoding="ascii") as file:
            lines = file.read().splitlines()
        self.assertEqual(lines[1].split()[:2], ["25", "16"])
        self.assertTrue(all(line.split()[0] == "4" for line in lines[27:]), lines[27:])

    def test_merged_cells_as_polygons_read_back_as_the_same(self):
        before = self.ask("info", golden("torus8x6.off"))
        for extension in ("off", "obj", "ply"):
            self.succeed("merge", golden("torus8x6.off"), "-o", f"a.{extension}")
            after = self.ask("info", f"a.{extension}")
            self.assertEqual(after["cells"], before["cells"])
            self.assertAlmostEqual(after["volume"], before["volume"], delta=1e-12)

    def test_values_from_files_are_those_of_expressions(self):
        mesh = golden("grid4.nsc")
        vertices = [(i / 4, j / 4) for i in range(5) for j in range(5)]
        self.write("f.txt", " ".join(repr(2 * x + y) for x, y in vertices))
        self.write("g.txt", "\n".join(repr(x * y) for x, y in vertices))
        common = ("poisson", mesh, "--side", "primal")
        told = self.ask(*common, "--rhs", "f.txt", "--boundary", "g.txt")
        meant = self.ask(*common, "--rhs", "2*x+y", "--boundary", "x*y")
        for key in ("min", "max"):
            self.assertAlmostEqual(told[key], meant[key], delta=1e-14)
        self.assertNotEqual(meant["max"], meant["min"])

    def test_files_of_values_that_do_not_fit_are_refused(self):
        self.write("few.txt", "1 2 3")
        self.write("bad.txt", "1 nan 3")
        common = ("poisson", golden("grid4.nsc"), "--side", "dual", "--rhs")
        self.assertSays(self.fail_with(2, *common, "few.txt"), "polydec: few.txt: ", "3 numbers",
                        "expected 16")
        self.assertSays(self.fail_with(2, *common, "bad.txt"), "polydec: bad.txt: ", "entry 1",
                        "number", "expected")

    def test_merging_is_told_how(self):
        mesh = golden("uv8.off")
        merged = self.ask("info", mesh)["cells"]["merged"]
        self.assertEqual(self.ask("info", mesh, "--angle-tolerance", "1e-6")["cells"]["merged"],
                         merged)
        plain = self.ask("info", mesh, "--no-merge")
        self.assertEqual(plain["cells"]["merged"], plain["cells"]["input"])
        self.assertNotEqual(merged, plain["cells"]["input"])
        wide = self.ask("info", mesh, "--tolerance", "0")
        self.assertEqual(len(wide["cells"]["merged"]), 3)

    def test_laplacians_that_would_divide_by_zero_are_left_out_with_a_warning(self):
        self.assertEqual(self.succeed("operators", golden("grid4.nsc"), "--out", "grid4").err, "")
        for k in range(3):
            self.assertTrue(os.path.exists(self.path(f"grid4/laplacian_dual_{k}.mtx")))
        told = self.succeed("operators", golden("fcc1.nsc"), "--out", "fcc1").err
        present = {file for file in os.listdir(self.path("fcc1")) if file.startswith("laplacian")}
        self.assertEqual(present, {"laplacian_primal_0.mtx", "laplacian_dual_3.mtx"})
        pattern = (r"polydec: warning: laplacian_primal_(\d).mtx \w+ laplacian_dual_(\d).mtx .*"
                   r"star of degree \d .*zero.* \d+ \d-cells .*volume \(cells \d+, .*\)")
        warnings = [re.fullmatch(pattern, line) for line in told.splitlines()]
        self.assertTrue(all(warnings), told)
        self.assertEqual([found.groups() for found in warnings],
                         [("1", "2"), ("2", "1"), ("3", "0")])
        told = self.ask("info", golden("fcc1.nsc"))["laplacians"]
        self.assertEqual([each["matrix"] for each in told], ["yes", "no", "no", "no"])
