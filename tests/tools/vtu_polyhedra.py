# SPDX-License-Identifier: MIT
"""Merged cells in .vtu files as others read them: a small reader of our own, and meshio where this
Python or Debian's has it. Each cell is closed, planar, turned outward and of the volume that the
library gives it."""
import collections
import math
import os
import sys
import xml.etree.ElementTree

import command
from command import TestCase, golden
from motions import Mesh, nsc
from polyhedra import (INTERPRETER, READERS, ROUNDING, Broken, Grid, area_vector, array_of, bend,
                       cell_of, count_faces, cross, differences, directed_edges, dot, flaws, minus,
                       read_alone, turned, unmatched_faces, vertices_of, volume, write_plain)

SOLIDS = ("bcc2.nsc", "fcc1.nsc", "kuhn3.nsc", "solid_torus3.nsc", "split_cubes.nsc")
SURFACES = ("grid4.nsc", "hex4.nsc", "ring6.nsc", "wellcentred4.nsc", "torus8x6.off", "uv8.off")


def tetrahedra_volume(points, simplices):
    return math.fsum(abs(dot(minus(points[b], points[a]), cross(minus(points[c], points[a]),
                                                                minus(points[d], points[a])))) / 6
                     for a, b, c, d in simplices)


class Solids(TestCase):
    def kinds(self, cells):
        return dict(collections.Counter(len(vertices_of(faces)) for faces in cells))

    def volumes_of_cells(self, mesh, *more):
        self.succeed("operators", mesh, "--out", "operators", *more)
        cells = self.read("operators/cells_3.txt").splitlines()
        values = [line for line in self.read("operators/volume_3.mtx").splitlines()
                  if not line.startswith("%")][1:]
        return {tuple(map(int, cell.split())): float(value)
                for cell, value in zip(cells, values, strict=True)}

    def check(self, mesh, *more):
        """Every law, by every reader."""
        info = self.ask("info", mesh, *more)
        wanted = self.volumes_of_cells(mesh, *more)
        self.succeed("merge", mesh, "-o", "a.vtu", *more)
        for reader in READERS:
            with self.subTest(os.path.basename(mesh), reader=reader.__name__):
                grid = reader(self.path("a.vtu"))
                self.assertEqual(self.kinds(grid.cells),
                                 {int(k): v for k, v in info["vertices_per_cell"].items()})
                self.assertEqual(len(grid.cells), info["cells"]["merged"][3])
                self.assertEqual(dict(collections.Counter(
                    flaw for faces in grid.cells for flaw in flaws(grid.points, faces))), {})
                self.assertEqual(unmatched_faces(grid.cells), [])
                self.assertEqual(count_faces(grid.cells), info["cells"]["merged"][2])
                self.assertEqual(differences(grid, wanted), [])
                total = math.fsum(volume(grid.points, faces) for faces in grid.cells)
                self.assertAlmostEqual(total, info["volume"], delta=ROUNDING * info["volume"])
        return grid

    def check_nsc(self, mesh, *more):
        grid = self.check(mesh, *more)
        given = Mesh.read(self.path(mesh))
        self.assertEqual(grid.points, list(map(tuple, given.points)))
        total = tetrahedra_volume(given.points, given.cells)
        self.assertAlmostEqual(math.fsum(volume(grid.points, faces) for faces in grid.cells), total,
                               delta=ROUNDING * total)

    def test_golden_solids(self):
        for name in SOLIDS:
            self.check_nsc(golden(name))

    def test_tetrahedra_that_nobody_merged(self):
        self.check_nsc(golden("bcc2.nsc"), "--no-merge")

    def test_cubes_pyramids_and_octahedra(self):
        # of the lattices: number of cells by number of points
        for name, cells, kinds in (("kuhn", 3, {8: 27}), ("bcc", 3, {4: 216, 5: 54}),
                                   ("fcc", 2, {4: 88, 5: 24, 6: 14})):
            self.check_nsc(self.generate(name, "--cells", cells, extension="nsc"))
            self.assertEqual(self.kinds(read_alone(self.path("a.vtu")).cells), kinds)

    def test_the_orientation_of_the_input_does_not_matter(self):
        mesh = Mesh.read(golden("kuhn3.nsc"))
        for turn in (lambda i: True, lambda i: i % 3 == 0):
            cells = [s[:2] + s[:1:-1] if turn(i) else s for i, s in enumerate(mesh.cells)]
            self.write("turned.nsc", nsc(mesh.points, cells))
            self.check_nsc("turned.nsc")

    def test_real_solids(self):
        for path in command.data_files("tet"):
            # .ele and .node name the same mesh
            if not path.endswith(".ele"):
                self.check(path, "--tolerance", "1e-12")

    def test_values_come_in_the_order_of_the_cells(self):
        mesh = golden("fcc1.nsc")
        for side, part, kind in (("dual", "CellData", "cells"), ("primal", "PointData", "points")):
            self.succeed("poisson", mesh, "--side", side, "--rhs", 0, "--boundary", "x", "-o",
                         "a.vtu")
            grid = read_alone(self.path("a.vtu"))
            array = xml.etree.ElementTree.parse(self.path("a.vtu")).find(f".//{part}/DataArray")
            values = array_of(array)
            self.assertEqual((array.get("Name"), len(values)), ("u", len(getattr(grid, kind))))
            if side == "primal":
                self.assertLess(max(abs(u - x) for u, (x, _, _) in zip(values, grid.points)), 1e-12)


class Twins(TestCase):
    """Each law fails where it has to."""

    def setUp(self):
        super().setUp()
        self.succeed("merge", golden("kuhn3.nsc"), "-o", "a.vtu")
        grid = read_alone(self.path("a.vtu"))
        self.points = list(grid.points)
        # a cube whose faces are turned outward, whatever the command wrote
        self.cube = self.turn_outward(grid.cells[0])

    def turn_outward(self, faces):
        center = [math.fsum(x) / 8 for x in zip(*(self.points[p] for p in vertices_of(faces)))]
        return [face if dot(minus(self.points[face[0]], center),
                            area_vector(self.points, face)) > 0 else face[::-1] for face in faces]

    def seen(self, faces, points=None):
        """The flaws that every reader finds in a file with this one cell."""
        grid = Grid(points or self.points, [faces])
        write_plain(self.path("twin.vtu"), grid)
        grids = [reader(self.path("twin.vtu")) for reader in READERS]
        found = [flaws(one.points, one.cells[0]) for one in grids]
        self.assertTrue(all(one == found[0] for one in found), found)
        return found[0]

    def test_a_type_that_is_not_that_of_the_corners(self):
        self.assertEqual(cell_of(12, list(range(8)))[1], [4, 5, 6, 7])
        for kind, corners in ((12, 4), (10, 8), (7, 4), (9, 5), (5, 4)):
            with self.assertRaises(Broken):
                cell_of(kind, list(range(corners)))

    def test_the_cube_itself_is_fine(self):
        self.assertEqual(self.seen(self.cube), [])
        self.assertAlmostEqual(volume(self.points, self.cube), 1 / 8, delta=1e-15)

    def test_a_face_left_out(self):
        self.assertIn("an edge that is not in two faces", self.seen(self.cube[1:]))

    def test_a_face_twice(self):
        self.assertIn("an edge that is not in two faces", self.seen(self.cube + self.cube[:1]))

    def test_a_face_turned(self):
        self.assertEqual(self.seen([self.cube[0][::-1]] + self.cube[1:]),
                         ["two faces that run along an edge in the same direction"])

    def test_all_faces_turned(self):
        self.assertEqual(self.seen([face[::-1] for face in self.cube]),
                         ["the faces are turned inward"])

    def test_the_order_of_corners(self):
        a, b, c, d = self.cube[0]
        self.assertIn("an edge that is not in two faces", self.seen([[a, c, b, d]] + self.cube[1:]))

    def test_a_repeated_corner(self):
        a, b, c, _ = self.cube[0]
        self.assertEqual(self.seen([[a, b, c, c]] + self.cube[1:]),
                         ["a face with too few or repeated corners"])

    def test_two_cubes_in_one(self):
        shift = len(self.points)
        points = self.points + [(x + 2, y, z) for x, y, z in self.points]
        both = self.cube + [[p + shift for p in face] for face in self.cube]
        self.assertEqual(self.seen(both, points), ["not Euler's number of a sphere"])

    def test_a_corner_moved(self):
        points = list(self.points)
        corner = self.cube[0][0]
        points[corner] = tuple(x + 1e-9 for x in points[corner])
        self.assertEqual(self.seen(self.cube, points), ["a face that is not planar"])

    def test_volumes_that_differ(self):
        wanted = {vertices_of(self.cube): 1 / 8}
        grid = Grid(self.points, [self.cube])
        self.assertEqual(differences(grid, wanted), [])
        bigger = Grid([tuple(x * (1 + 1e-9) for x in p) for p in self.points], [self.cube])
        self.assertEqual(differences(bigger, wanted), list(wanted))
        self.assertEqual(differences(Grid(self.points, []), wanted), ["the cells"])

    def test_neighbors_that_run_alike(self):
        face = self.cube[0]
        self.assertEqual(unmatched_faces([[face], [face[::-1]]]), [])
        self.assertEqual(unmatched_faces([[face], [face[1:] + face[:1]]]), [turned(face)])

    def test_files_against_the_rules(self):
        write_plain(self.path("good.vtu"), Grid(self.points, [self.cube, self.cube]))
        text = self.read("good.vtu")
        read_alone(self.path("good.vtu"))
        for old, new, message in (
                (">31 62<", ">0 31<", "faceoffsets do not ascend"),
                (">31 62<", ">31 61<", "faceoffsets do not end with the array"),
                (">8 16<", ">8 15<", "offsets do not end with the array"),
                (">42 42<", ">42 12<", "polyhedra mixed with others"),
                (">6 4 ", ">5 4 ", "a polyhedron with more numbers than its faces take"),
                (">6 4 ", ">7 4 ", "a polyhedron with fewer faces than promised"),
                ('NumberOfCells="2"', 'NumberOfCells="3"', "numbers of points or cells")):
            self.assertIn(old, text)
            self.write("bad.vtu", text.replace(old, new))
            with self.assertRaisesRegex(Broken, message):
                read_alone(self.path("bad.vtu"))


class Others(TestCase):
    def test_surfaces_are_polygons_that_run_alike(self):
        for name in SURFACES:
            info = self.ask("info", golden(name))
            self.succeed("merge", golden(name), "-o", "a.vtu")
            for reader in READERS:
                with self.subTest(name, reader=reader.__name__):
                    grid = reader(self.path("a.vtu"))
                    polygons = [face for face, in grid.cells]
                    runs = directed_edges(polygons)
                    self.assertEqual(set(runs.values()), {1})
                    self.assertEqual(len({frozenset(edge) for edge in runs}),
                                     info["cells"]["merged"][1])
                    self.assertEqual(collections.Counter(map(len, polygons)), {
                        int(k): v for k, v in info["vertices_per_cell"].items()})
                    self.assertLess(max(bend(grid.points, face) for face in polygons), ROUNDING)
                    area = math.fsum(math.hypot(*area_vector(grid.points, f)) for f in polygons)
                    self.assertAlmostEqual(area, info["volume"], delta=ROUNDING * area)

    def test_curves_are_lines(self):
        self.succeed("merge", golden("kuhn1d.nsc"), "-o", "a.vtu")
        for reader in READERS:
            grid = reader(self.path("a.vtu"))
            self.assertEqual(sorted(line for line, in grid.cells), [[i, i + 1] for i in range(5)])

    def test_cells_of_four_dimensions_are_refused(self):
        self.assertSays(self.fail_with(2, "merge", golden("kuhn4.nsc"), "-o", "a.vtu"),
                        "dimension 4", "operators")
        self.assertEqual(os.listdir(self.folder), [])


def setUpModule():
    if INTERPRETER is None:
        print("no meshio here (Debian: python3-meshio); the laws are checked with the reader of "
              "this test alone", file=sys.stderr)
