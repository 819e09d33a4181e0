# SPDX-License-Identifier: MIT
"""Flat tetrahedra: cubes and prisms out of what TetGen makes of points and parts, and what is
refused."""
import collections
import itertools
import math
import os
import random
import shutil
import unittest
import xml.etree.ElementTree

import command
from command import TestCase
from mesh_laws import mesh_files
from motions import Mesh
from tet_meshes import Tetrahedra

JITTERS = (0, 1e-12, 1e-8, 1e-5)


def rows_of(points):
    return f"{len(points)} 3 0 0\n" + "".join(f"{i} {x!r} {y!r} {z!r}\n"
                                              for i, (x, y, z) in enumerate(points))


class OfTetGen(TestCase):
    def tetrahedra(self, name, text, switches):
        self.write(name, text)
        done = command.run_program(["tetgen", switches, name], cwd=self.folder)
        self.assertEqual(done.code, 0, done.out + done.err)
        return name.rsplit(".", 1)[0] + ".1.ele"


@unittest.skipUnless(shutil.which("tetgen"), "the tetrahedra are TetGen's")
class GridPoints(OfTetGen):
    def of_grid(self, n, jitter, everywhere=False):
        """The Delaunay tetrahedra of n^3 points, those inside moved by up to half of the jitter; or
        all points, and flat cells cover the hull."""
        place = random.Random(20)
        points = [[c + (jitter * (place.random() - 0.5) if everywhere or 0 < c < n - 1 else 0)
                   for c in grid] for grid in itertools.product(range(n), repeat=3)]
        return self.tetrahedra("points.node", rows_of(points), "-Q")

    def check_cubes(self, n, info, jitter):
        m = n - 1
        self.assertGreater(info["cells"]["input"][3], 5 * m**3) # five are enough
        self.assertEqual(info["cells"]["merged"], [n**3, 3 * n**2 * m, 3 * n * m**2, m**3])
        for k, star in enumerate(info["stars"]):
            self.assertLess(abs(star["min"] - 2.0**(k - 3)), 5 * jitter + 1e-12)
            self.assertLess(abs(star["max"] - 1), 5 * jitter + 1e-12)

    def test_become_cubes_with_their_stars_and_eigenvalues(self):
        for n in (4, 6):
            for jitter in JITTERS:
                with self.subTest(n=n, jitter=jitter):
                    mesh = self.of_grid(n, jitter)
                    self.check_cubes(n, self.ask("info", mesh), jitter)
                    values = self.ask("spectrum", mesh, "--side", "dual", "--degree", 0,
                                      "--count", 2, "--natural")["eigenvalues"]
                    self.assertLess(abs(values[0]), 1e-12)

    def test_become_cubes_without_the_flat_cells_of_the_hull(self):
        for n in (4, 6):
            for jitter in JITTERS:
                with self.subTest(n=n, jitter=jitter):
                    mesh = self.of_grid(n, jitter, everywhere=True)
                    info = self.ask("info", mesh, "--peel")
                    self.check_cubes(n, info, jitter)
                    self.assertAlmostEqual(info["volume"] / (n - 1)**3, 1, delta=5 * jitter + 1e-12)
                    if jitter > 0:
                        self.assertRegex(info["warnings"][0], r"^peeled \d+ flat cells\b")
                        self.assertSays(self.fail_with(2, "info", mesh), mesh, "cell", "no volume")

    def test_of_other_lattices_become_their_cells(self):
        # octahedra are cut, and the quadrilaterals of two tetrahedra that are on one sphere
        for name, cells, without_dual in (("fcc", [63, 264, 328, 126], 96),
                                          ("bcc", [35, 130, 168, 72], 0)):
            points = Mesh.read(self.generate(name, "--cells", 2, extension="nsc")).points
            for jitter, everywhere in itertools.product(JITTERS, (False, True)):
                with self.subTest(name, jitter=jitter, everywhere=everywhere):
                    place = random.Random(3)
                    moved = [[c + (jitter / 4 * (place.random() - .5) if everywhere or 0 < c < 1
                                   else 0) for c in point] for point in points]
                    mesh = self.tetrahedra("points.node", rows_of(moved), "-Q")
                    info = self.ask("info", mesh, "--peel")
                    self.assertEqual(info["cells"]["merged"], cells)
                    self.assertEqual(info["facets"]["boundary_degenerate"], without_dual)

    def test_on_a_sphere_become_one_cell(self):
        for count, jitter, seed in itertools.product((20, 40), (0, 1e-12, 1e-8), range(3)):
            with self.subTest(count=count, jitter=jitter, seed=seed):
                place = random.Random(seed)
                points = [[place.gauss(0, 1) for _ in range(3)] for _ in range(count)]
                points = [[c / math.hypot(*p) + jitter * (place.random() - .5) for c in p]
                          for p in points]
                mesh = self.tetrahedra("points.node", rows_of(points), "-Q")
                self.assertEqual(self.ask("info", mesh)["vertices_per_cell"], {str(count): 1})


def honeycomb(columns, rows):
    """Corners of regular hexagons of edge 1, and the hexagons."""
    numbers, polygons = {}, []
    for i, j in itertools.product(range(columns), range(rows)):
        middle = (1.5 * i, math.sqrt(3) * (j + i % 2 / 2))
        corners = [(middle[0] + math.cos(k * math.pi / 3), middle[1] + math.sin(k * math.pi / 3))
                   for k in range(6)]
        polygons.append([numbers.setdefault((round(x, 6), round(y, 6)), (len(numbers), x, y))[0]
                         for x, y in corners])
    return [(x, y) for _, x, y in numbers.values()], polygons


def flange(sides):
    """Two rings of trapezoids around a hole."""
    angles = [2 * math.pi * i / sides for i in range(sides)]
    corners = [(r * math.cos(a), r * math.sin(a)) for r in (1, 1.6, 2.2) for a in angles]
    return corners, [[r * sides + i, (r + 1) * sides + i, (r + 1) * sides + (i + 1) % sides,
                      r * sides + (i + 1) % sides] for r in range(2) for i in range(sides)]


def angle(n):
    """The unit squares of an L."""
    corners = list(itertools.product(range(n + 1), repeat=2))
    return corners, [[x * (n + 1) + y, (x + 1) * (n + 1) + y, (x + 1) * (n + 1) + y + 1,
                      x * (n + 1) + y + 1] for x, y in itertools.product(range(n), repeat=2)
                     if x < n // 2 or y < n // 2]


class Part:
    """Layers of prisms over polygons whose corners lie on circles: over polygon i layers[i] of
    them, between the heights; askew in space, and every point moved by up to half of the jitter."""

    def __init__(self, plan, layers, heights, jitter=0.0):
        corners, polygons = plan
        place, numbers, self.points = random.Random(7), {}, []
        faces, edges = collections.Counter(), set()

        def at(v, level):
            if (v, level) not in numbers:
                numbers[v, level] = len(self.points)
                (x, y), z = corners[v], heights[level]
                x, y = math.cos(.3) * x - math.sin(.3) * y, math.sin(.3) * x + math.cos(.3) * y
                y, z = math.cos(.7) * y - math.sin(.7) * z, math.sin(.7) * y + math.cos(.7) * z
                self.points.append([c + jitter * (place.random() - .5) for c in (x, y, z)])
            return numbers[v, level]

        def add(face):
            start = face.index(min(face))
            turned = face[start:] + face[:start]
            faces[tuple(turned if turned[1] < turned[-1] else turned[:1] + turned[:0:-1])] += 1
            edges.update(frozenset(edge) for edge in zip(face, face[1:] + face[:1]))

        for polygon, count in zip(polygons, layers):
            for level in range(count):
                add([at(v, level) for v in polygon])
                add([at(v, level + 1) for v in polygon])
                for v, w in zip(polygon, polygon[1:] + polygon[:1]):
                    add([at(v, level), at(w, level), at(w, level + 1), at(v, level + 1)])
        self.boundary = [face for face, count in faces.items() if count == 1]
        self.cells = [len(self.points), len(edges), len(faces), sum(layers)]

    def text(self):
        facets = (f"1\n{len(face)} {' '.join(map(str, face))}\n" for face in self.boundary)
        return rows_of(self.points) + f"{len(self.boundary)} 0\n" + "".join(facets) + "0\n0\n"


@unittest.skipUnless(shutil.which("tetgen"), "the tetrahedra are TetGen's")
class Parts(OfTetGen):
    """CAD parts of prisms in layers; TetGen adds no points (Y) and leaves Delaunay what is so (O0)."""

    def check(self, part, corners, jitter=0.0, linear=1e-11):
        mesh = self.tetrahedra("part.poly", part.text(), "-pYO0Q")
        info = self.ask("info", mesh, "--peel")
        self.assertEqual(info["cells"]["merged"], part.cells)
        self.assertEqual(info["vertices_per_cell"], {str(corners): part.cells[3]})
        self.assertEqual(info["advice"], [])
        self.succeed("merge", mesh, "--peel", "-o", "part.vtu")
        piece = xml.etree.ElementTree.parse(self.path("part.vtu")).getroot().find(".//Piece")
        self.assertEqual(int(piece.get("NumberOfCells")), part.cells[3])
        found = self.ask("poisson", mesh, "--peel", "--side", "dual", "--rhs", 0, "--boundary",
                         "1+x-2*y+z", "--exact", "1+x-2*y+z")
        self.assertLess(found["error"]["max"], 5 * jitter + linear)

    def test_become_boxes_of_a_stepped_angle(self):
        plan = angle(4)
        steps = [3 if max(plan[0][polygon[0]]) < 2 else 2 for polygon in plan[1]]
        self.check(Part(plan, steps, [0, .5, 1.2, 1.5]), 8)

    def test_become_blocks_of_a_flange(self):
        self.check(Part(flange(12), [3] * 12 + [1] * 12, [0, .3, .7, 1]), 8)

    def test_become_prisms_of_a_honeycomb(self):
        plan = honeycomb(3, 3)
        for jitter in (0, 1e-12, 1e-8, 1e-5):
            with self.subTest(jitter=jitter):
                self.check(Part(plan, [2] * 9, [0, .8, 1.5], jitter), 12, jitter)

    def test_become_prisms_of_thin_layers(self):
        plan = honeycomb(3, 3)
        for heights in ([0, .02, 1, 1.01], [0, 1e-3, 2e-3]):
            self.check(Part(plan, [len(heights) - 1] * 9, heights), 12)


class Flat(Tetrahedra):
    """A flat cell between others is refused by its number and vertices, until it has volume or lies
    on their sphere."""
    CELLS = [[0, 1, 2, 4], [0, 2, 3, 4], [0, 1, 2, 3], [1, 0, 3, 5], [2, 1, 3, 5]]
    REFUSAL = ("cell 2 (vertices 0 1 2 3)", "no volume", "neighbors", "plane", "--peel")

    def make(self, height):
        return self.with_corner([-.3, 1, height])

    def with_corner(self, corner):
        points = [[0, 0, 0], [1, 0, 0], [1, 1, 0], corner, [.5, .5, 1], [.5, .5, -1]]
        return mesh_files(points, self.CELLS)

    def test_a_flat_cell_on_the_sphere_of_its_neighbors_is_a_piece_of_theirs(self):
        self.write("a.nsc", self.with_corner([0, 1, 0])["a.nsc"])
        info = self.ask("info", "a.nsc")
        self.assertEqual((info["cells"]["input"][3], info["cells"]["merged"][3]), (5, 2))
        self.assertAlmostEqual(info["volume"], 2 / 3, delta=1e-14)
        self.assertSays(self.fail_with(2, "info", "a.nsc", "--no-merge"), "polydec: a.nsc: ",
                        *self.REFUSAL)

    def test_flat_cells_are_refused_in_every_format_by_every_command(self):
        for name, text in self.make(0).items():
            self.write(name, text)
        for name in ("a.nsc", "a.mesh", "a.msh", "a.vtk", "a.node", "a.ele"):
            for arguments in (("info", name), ("info", name, "--no-merge"),
                              ("merge", name, "-o", "b.vtu"),
                              ("poisson", name, "--side", "dual", "--rhs", 1),
                              ("spectrum", name, "--side", "primal", "--degree", 0, "--count", 1),
                              ("operators", name, "--out", "operators")):
                with self.subTest(arguments):
                    self.assertSays(self.fail_with(2, *arguments), f"polydec: {name}: ",
                                    *self.REFUSAL)
        self.assertNotIn("b.vtu", os.listdir(self.folder))
        self.assertNotIn("operators", os.listdir(self.folder))

    def test_cells_that_are_almost_flat_are_none(self):
        for height in (1e-2, 1e-4, 1e-8):
            self.write("a.nsc", self.with_corner([0, 1, height])["a.nsc"])
            info = self.check_info("a.nsc")
            self.assertAlmostEqual(info["volume"], 2 / 3 + height / 3, delta=1e-13)
            self.assertLess(self.error_of_linear("a.nsc", "primal"), 1e-12)
