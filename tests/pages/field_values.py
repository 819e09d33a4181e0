# SPDX-License-Identifier: MIT
"""Pages without a browser: their numbers are those of the files that the same commands write."""
import os
import xml.etree.ElementTree

from command import TestCase, golden
from page_file import PageFile
from polyhedra import array_of

# mesh, side, degree
SPECTRA = (("uv8.off", "primal", 0), ("uv8.off", "dual", 0), ("torus8x6.off", "primal", 1),
           ("torus8x6.off", "dual", 1), ("hex4.nsc", "primal", 2), ("kuhn3.nsc", "primal", 0),
           ("kuhn3.nsc", "dual", 0), ("fcc1.nsc", "primal", 1), ("bcc2.nsc", "primal", 2))


def vtu_arrays(path):
    """But for the vectors, which a page draws as arrows."""
    root = xml.etree.ElementTree.parse(path).getroot()
    return {array.get("Name"): array_of(array)
            for section in ("PointData", "CellData")
            for array in root.iterfind(f"UnstructuredGrid/Piece/{section}/DataArray")
            if array.get("NumberOfComponents") != "3"}


def largest_difference(first, second):
    """Beside the largest number; 1 where there are not as many."""
    if len(first) != len(second):
        return 1
    size = max(map(abs, second), default=0) or 1
    return max((abs(a - b) / size for a, b in zip(first, second)), default=0)


class Numbers(TestCase):
    def spectrum(self, mesh, side, degree, out):
        return ("spectrum", golden(mesh), "--side", side, "--degree", degree, "--count", 3, "-o", out)

    def test_fields_and_tables_are_those_of_other_outputs(self):
        for mesh, side, degree in SPECTRA:
            with self.subTest(mesh, side=side, degree=degree):
                answer = self.ask(*self.spectrum(mesh, side, degree, "a.vtu"))
                self.succeed(*self.spectrum(mesh, side, degree, "a.html"))
                page, arrays = PageFile(self.path("a.html")), vtu_arrays(self.path("a.vtu"))
                self.assertEqual(list(page.fields), list(arrays))
                for name, values in arrays.items():
                    self.assertLess(largest_difference(page.values(name), values), 1e-7)
                    altered = [*values[:-1], values[-1] + 1e-3 * max(map(abs, values))]
                    self.assertGreater(largest_difference(page.values(name), altered), 1e-7)
                for row, value in zip(page.table(), answer["eigenvalues"], strict=True):
                    self.assertAlmostEqual(float(row[1]) / (value or 1), 1, delta=1e-11)

    def test_points_and_cells_are_those_of_the_file(self):
        for mesh in ("uv8.off", "torus8x6.off", "hex4.nsc", "kuhn3.nsc", "fcc1.nsc"):
            with self.subTest(mesh):
                self.succeed("merge", golden(mesh), "-o", "a.vtu")
                self.succeed("view", golden(mesh), "-o", "a.html")
                page = PageFile(self.path("a.html"))
                root = xml.etree.ElementTree.parse(self.path("a.vtu")).getroot()
                wanted = array_of(root.find("UnstructuredGrid/Piece/Points/DataArray"))
                found = [x for point in page.points() for x in point]
                self.assertLess(largest_difference(found, wanted), 1e-7)
                info = self.ask("info", golden(mesh))
                self.assertEqual(page.header["cells"], info["cells"]["merged"][-1])
                volumes = page.values("area" if info["dimension"] == 2 else "volume")
                self.assertEqual(len(volumes), page.header["cells"])
                self.assertGreater(min(volumes), 0)

    def test_the_same_input_makes_the_same_bytes(self):
        pages = []
        for _ in range(2):
            self.succeed(*self.spectrum("uv8.off", "dual", 0, "a.html"))
            pages.append(self.read("a.html"))
            os.remove(self.path("a.html"))
        self.assertEqual(*pages)

    def test_every_command_says_what_made_its_page(self):
        self.write("a'b.off", self.read(golden("uv8.off")))
        self.succeed("distance", "a'b.off", "--from", 0, "-o", "a.html")
        self.assertIn("polydec distance 'a'\\''b.off' --from 0 -o a.html", PageFile(
            self.path("a.html")).text)
        self.succeed("info", golden("uv8.off"), "-o", "a.html")
        self.assertIn("Betti", PageFile(self.path("a.html")).text)

    def test_pages_of_dimension_four_are_refused(self):
        self.succeed("generate", "kuhn", "--dimension", 4, "--cells", 1, "-o", "a.nsc")
        self.assertSays(self.fail_with(2, "view", "a.nsc", "-o", "a.html"), "dimension 4")

    def test_other_files_are_not_bound(self):
        self.succeed("view", golden("uv8.off"), "-o", "a.html")
        self.write("b.html", "<html><title>b</title></html>")
        self.assertSays(self.fail_with(2, "view", "a.html", "b.html", "-o", "c.html"),
                        "b.html", "page")
        self.assertSays(self.fail_with(2, "view", "a.html", golden("uv8.off"), "-o", "c.html"),
                        "uv8.off", "pages")
        self.assertSays(self.fail_with(2, "view", "a.html", "a.html"), "pages", "output file", "-o")
        self.assertEqual(self.ask("view", "a.html", "a.html", "-o", "c.html")["pages"], 2)

    def test_a_million_triangles_with_three_fields_and_arrows_take_less_than_12_mb(self):
        self.succeed("generate", "uv-sphere", "--meridians", 1000, "--bands", 501, "-o", "a.off")
        fields = "".join(
            f'<DataArray type="Float64" Name="{name}" NumberOfComponents="{width}" format="ascii">'
            + " ".join(f"{(i * step) % 10007}" for i in range(500002 * width)) + "</DataArray>"
            for name, step, width in (("u", 7, 1), ("v", 131, 1), ("wind", 4099, 3)))
        self.succeed("merge", "a.off", "-o", "a.vtu")
        text = self.read("a.vtu")
        begin = text.find("<CellData")
        begin = begin if begin >= 0 else text.find("</Piece>")
        self.write("b.vtu", f"{text[:begin]}<PointData>{fields}</PointData>{text[begin:]}")
        self.assertLess(self.ask("view", "b.vtu", "-o", "b.html", seconds=200)["bytes"], 12e6)
