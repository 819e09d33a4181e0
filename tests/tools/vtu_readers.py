# SPDX-License-Identifier: MIT
"""The numbers in .vtu files as others read them: a small reader of our own, and meshio and VTK where
this Python or Debian's has them. All read the same, and it is what the command says."""
import json
import math
import os
import struct
import xml.etree.ElementTree

import command
from command import TestCase, golden
from polyhedra import Broken, array_of, find_python, require

MESHIO = """
import json, sys, meshio
def content(path):
    mesh = meshio.read(path)
    cells = {name: sum((block.tolist() for block in blocks), [])
             for name, blocks in mesh.cell_data.items()}
    return {"Points": {"Points": mesh.points.tolist()}, "CellData": cells,
            "PointData": {name: values.tolist() for name, values in mesh.point_data.items()},
            "FieldData": {name: values.tolist() for name, values in mesh.field_data.items()}}
json.dump([content(path) for path in sys.argv[1:]], sys.stdout)
"""
VTK = """
import json, sys, vtk
from vtk.util.numpy_support import vtk_to_numpy
def arrays(data):
    return {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i)).tolist()
            for i in range(data.GetNumberOfArrays())}
def content(path):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    sizes = vtk.vtkCellSizeFilter()
    sizes.SetInputData(grid)
    sizes.Update()
    sizes = arrays(sizes.GetOutput().GetCellData())
    return {"Points": {"Points": vtk_to_numpy(grid.GetPoints().GetData()).tolist()},
            "CellData": arrays(grid.GetCellData()), "PointData": arrays(grid.GetPointData()),
            "FieldData": arrays(grid.GetFieldData()),
            "sizes": [sizes[name] for name in ("Length", "Area", "Volume")]}
json.dump([content(path) for path in sys.argv[1:]], sys.stdout)
"""
OTHERS = {"meshio": MESHIO, "vtk": VTK}


def rows(values, width):
    return values if width == 1 else [values[i:i + width] for i in range(0, len(values), width)]


def read_alone(path):
    """{section: {name: numbers, or lists of three}}. Throws Broken."""
    found = {"Points": {}, "PointData": {}, "CellData": {}, "FieldData": {}}
    grid = xml.etree.ElementTree.parse(path).getroot().find("UnstructuredGrid")
    for part in (*grid, *grid.find("Piece")):
        for array in part.findall("DataArray") if part.tag in found else ():
            values = rows(array_of(array), int(array.get("NumberOfComponents", 1)))
            if part.tag == "FieldData":
                require(len(values) == int(array.get("NumberOfTuples")), "number of tuples")
            found[part.tag][array.get("Name")] = values
    return found


READERS = {name: interpreter for name in OTHERS if (interpreter := find_python(name))}


def read_with(name, paths):
    done = command.run_program([READERS[name], "-c", OTHERS[name], *paths])
    require(done.code == 0, done.err)
    return json.loads(done.out)


def as_float(number):
    return struct.unpack("f", struct.pack("f", number))[0]


def rounded(values):
    return [rounded(v) if isinstance(v, list) else as_float(v) for v in values]


class Numbers(TestCase):
    sizes = None  # of the cells of the last file, as VTK measures them

    def numbers(self, *names):
        """What all readers find in each file, who must agree. meshio puts values of polyhedra in
        the wrong place."""
        paths = [self.path(name) for name in names]
        own = [read_alone(path) for path in paths]
        has_faces = any('Name="faces"' in self.read(name) for name in names)
        for reader in READERS.keys() - ({"meshio"} if has_faces and own[0]["CellData"] else set()):
            for found, expected in zip(read_with(reader, paths), own):
                self.sizes = found.pop("sizes", self.sizes)
                self.assertEqual(found, expected, reader)
        return own

    def in_both(self, *arguments):
        """Float64 and, beside it, Float32: which is the first one rounded, but for the whole."""
        self.succeed(*arguments, "-o", "a.vtu")
        self.succeed(*arguments, "-o", "b.vtu", "--float32")
        found, floats = self.numbers("a.vtu", "b.vtu")
        for part in ("Points", "PointData", "CellData"):
            self.assertEqual(floats[part], {name: rounded(values)
                                            for name, values in found[part].items()})
        self.assertEqual(floats["FieldData"], found["FieldData"])
        self.assertLess(os.path.getsize(self.path("b.vtu")), os.path.getsize(self.path("a.vtu")))
        self.succeed(*arguments, "-o", "c.vtu")
        self.assertEqual(self.read("a.vtu"), self.read("c.vtu"))
        return found

    def test_spectra(self):
        for side, degree in (("primal", 0), ("primal", 1), ("dual", 2), ("dual", 1), ("dual", 0)):
            with self.subTest(side=side, degree=degree):
                arguments = ("spectrum", golden("grid4.nsc"), "--side", side, "--degree", degree,
                             "--count", 3)
                answer, found = self.ask(*arguments), self.in_both(*arguments)
                field = found["FieldData"]
                for key in ("eigenvalues", "radii", "residuals"):
                    self.assertEqual(field[key], answer[key])
                for key, value in answer["certificate"].items():
                    self.assertEqual(field[key], [value])
                self.assertEqual((field["degree"], field["is_dual"]), ([degree], [side == "dual"]))
                names = ["mode_0", "mode_1", "mode_2"]
                vectors = [name + "_vector" for name in names] if degree == 1 else []
                on_points = (side, degree) in (("primal", 0), ("dual", 2))
                self.assertEqual(list(found["PointData"]), names if on_points else vectors)
                self.assertEqual(list(found["CellData"]), [] if on_points else names)

    def test_solutions(self):
        for mesh in ("grid4.nsc", "kuhn3.nsc", "bcc2.nsc"):
            with self.subTest(mesh):
                arguments = ("poisson", golden(mesh), "--side", "dual", "--rhs", 0, "--boundary",
                             "x", "--exact", "x")
                answer, found = self.ask(*arguments), self.in_both(*arguments)
                self.assertEqual(found["FieldData"], {
                    "residual": [answer["residual"]], "error_max": [answer["error"]["max"]],
                    "error_l2": [answer["error"]["l2"]]})
                self.assertEqual(list(found["CellData"]), ["u"])

    def test_distances_and_merged_cells(self):
        found = self.in_both("distance", golden("uv8.off"), "--from", 3, 5)
        self.assertEqual(found["FieldData"], {"from": [3, 5]})
        self.assertEqual(found["PointData"]["distance"][3:6:2], [0, 0])
        for mesh in ("uv8.off", "kuhn3.nsc", "fcc1.nsc"):
            self.assertEqual(self.in_both("merge", golden(mesh))["FieldData"], {})

    def test_cells_have_the_size_that_they_had(self):
        for mesh, k in (("uv8.off", 1), ("kuhn3.nsc", 2), ("bcc2.nsc", 2), ("grid4.nsc", 1)):
            self.succeed("merge", golden(mesh), "-o", "a.vtu", *(["--no-merge"] * (mesh[0] == "b")))
            self.numbers("a.vtu")
            if "vtk" in READERS:
                self.assertAlmostEqual(sum(self.sizes[k]), self.ask("info", golden(mesh))["volume"],
                                       delta=1e-12)

    def test_series_hold_velocity_and_pressure_and_electric_and_magnetic_fields(self):
        """Several degrees in one file, with vectors at vertices."""
        self.succeed("generate", "kuhn", "--dimension", 3, "--cells", 3, "-o", "box.nsc")
        for mesh, flow in ((golden("uv8.off"), ("--vorticity", "z")),
                           ("box.nsc", ("--velocity", "sin(pi*x)*cos(pi*y); -cos(pi*x)*sin(pi*y); 0"))):
            answer = self.ask("flow", mesh, *flow, "--until", 0.1, "--frames", 2, "-o", "f.pvd")
            info = self.ask("info", mesh)
            for found in self.numbers(*(f"f/f_{step:04}.vtu" for step in range(3))):
                points, cells, whole = (found[f"{part}Data"] for part in ("Point", "Cell", "Field"))
                self.assertEqual(next(iter(points)), "velocity")
                self.assertEqual(len(points["velocity"]), len(found["Points"]["Points"]))
                self.assertGreater(max(map(math.hypot, *zip(*points["velocity"]))), 0.1)
                self.assertEqual(len(cells["pressure"]), info["cells"]["merged"][-1])
            if "vtk" in READERS and mesh == "box.nsc": # whose cells are cubes
                mean = sum(p * size for p, size in zip(cells["pressure"], self.sizes[2]))
                self.assertAlmostEqual(mean, 0, delta=1e-12)
                self.assertGreater(max(cells["pressure"]), 1e-3)
            vorticity = points["vorticity"] if "vorticity" in points else whole["vorticity"]
            self.assertEqual(len(vorticity), info["cells"]["merged"][info["dimension"] - 2])
            self.assertEqual((min(vorticity), max(vorticity)),
                             (answer["min_vorticity"], answer["max_vorticity"]))
        for side, degrees in (("primal", ("E", "B")), ("dual", ("B", "E"))):
            answer = self.ask("maxwell", "box.nsc", "--side", side, "--initial", "0; 0; x*(1-x)",
                              "--until", 1, "--frames", 2, "-o", "m.pvd")
            *_, last = self.numbers(*(f"m/m_{step:04}.vtu" for step in range(3)))
            whole, merged = last["FieldData"], self.ask("info", "box.nsc")["cells"]["merged"]
            self.assertEqual((min(whole["E"]), max(whole["E"])), (answer["min"], answer["max"]))
            self.assertEqual([len(whole[name]) for name in degrees], merged[1:3])
            for name in ("E", "B"):
                vectors = last["PointData"][f"{name}_vector"]
                self.assertGreater(max(map(math.hypot, *zip(*vectors))), 1e-3, name)

    def test_where_floats_are_not_written_they_are_not_asked_for(self):
        for out in ("a.html", "a.off"):
            message = self.fail_with(2, "merge", golden("grid4.nsc"), "-o", out, "--float32")
            self.assertSays(message, "polydec: ", "write", f"{out}: ", "--float32", ".vtu")
        self.assertSays(self.fail_with(1, "distance", golden("uv8.off"), "--from", 0, "--float32"),
                        "--float32", "--out")


class Twins(TestCase):
    """Every reader sees what is changed."""

    def test_another_number(self):
        self.succeed("poisson", golden("grid4.nsc"), "--side", "primal", "--rhs", 1, "-o", "a.vtu")
        before = read_alone(self.path("a.vtu"))
        text = self.read("a.vtu")
        place = text.index("\n", text.index('Name="u"')) + 40
        self.write("b.vtu", text[:place] + ("B" if text[place] == "A" else "A") + text[place + 1:])
        self.assertNotEqual(read_alone(self.path("b.vtu")), before)
        for reader in READERS:
            self.assertNotEqual(read_with(reader, [self.path("b.vtu")])[0]["PointData"],
                                before["PointData"], reader)

    def test_another_number_of_tuples(self):
        self.succeed("distance", golden("uv8.off"), "--from", 0, "-o", "a.vtu")
        self.write("b.vtu", self.read("a.vtu").replace('NumberOfTuples="1"', 'NumberOfTuples="2"'))
        with self.assertRaises(Broken):
            read_alone(self.path("b.vtu"))
