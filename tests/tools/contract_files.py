# SPDX-License-Identifier: MIT
"""What programs may rely on in the files that are written and read."""
import xml.etree.ElementTree

from command import TestCase, golden


class Files(TestCase):
    def arrays(self, name):
        """Name of every array of the one piece of a .vtu file, by what it belongs to."""
        piece = xml.etree.ElementTree.parse(self.path(name)).getroot().find(".//Piece")
        cells, points = (int(piece.get(key)) for key in ("NumberOfCells", "NumberOfPoints"))
        return cells, points, {
            part.tag: [array.get("Name") for array in part.findall("DataArray")]
            for part in piece}

    def test_merged_cells_as_vtu(self):
        for name, cells, points in (("uv8.off", 64, 58), ("kuhn3.nsc", 8, 27)):
            self.succeed("merge", golden(name), "-o", "a.vtu")
            self.assertEqual(self.arrays("a.vtu")[:2], (cells, points))

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

    def test_solutions_and_modes_as_vtu(self):
        mesh = golden("grid4.nsc")
        self.succeed("poisson", mesh, "--side", "primal", "--rhs", "1", "-o", "p.vtu")
        self.assertIn("u", self.arrays("p.vtu")[2]["PointData"])
        self.succeed("poisson", mesh, "--side", "dual", "--rhs", "1", "-o", "d.vtu")
        self.assertIn("u", self.arrays("d.vtu")[2]["CellData"])
        for side, degree in (("primal", 0), ("primal", 1), ("dual", 0), ("dual", 1), ("dual", 2)):
            self.succeed("spectrum", mesh, "--side", side, "--degree", degree, "--count", 2, "-o",
                         "m.vtu")
            self.assertGreater(self.arrays("m.vtu")[0], 0)

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
