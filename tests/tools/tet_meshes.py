# SPDX-License-Identifier: MIT
"""Tetrahedra through every command: those of others, lattices, turned and flat ones. Each command
obeys the laws of its numbers or ends with an error that says where and what to do."""
import itertools
import math
import os
import re
import unittest
from pathlib import Path

import command
from command import TestCase, golden
from mesh_laws import (differences, inclusion_flaws, kernel_flaws, mesh_files, partition_flaws,
                       topology_flaws)
from motions import Mesh

SECONDS = 300
COUNT = 4
LINEAR = "1+2*x-3*y+z/2"
STAR = ("--star", "circumcentric")  # the one that is refused

# Where meshes of others are not Delaunay: degrees of primal forms whose mass is not positive, and
# whether primal n-forms get spurious negative eigenvalues.
NOT_DELAUNAY = {
    "beam-tet.vtk": ((), False),
    "icos.1.ele": ((), False),
    "icos.1.node": ((), False),
    "2d_square_pi_x_pi.msh": ((), False),
    "cube.1.ele": ((1, 2), True),
    "cube.1.node": ((1, 2), True),
    "test_mesh_3d.msh": ((1, 2), True),
    "hand.mesh": ((0, 1, 2), True),
    "octopus-low.mesh": ((0, 1, 2), True),
}
# Meshes with duals of no length at all: unmerged, their dual Poisson problem has no meaning.
COSPHERICAL = {"beam-tet.vtk", "hand.mesh", "test_mesh_3d.msh"}

# What is said of each, by its places, numbers and a few words.
FILE = r"polydec: [^:]+: "
MASS = re.compile(FILE + r".*\bmass of (primal|dual) (\d)-forms .*\b(\d+) of (\d+) (\d)-cells "
                  r".*\b(negative|zero) volume \(cells? \d[^)]*\).*\n.*--star automatic.*")
NO_INVERSE = re.compile(FILE + r".*\bstar of degree (\d) .*\bzero\b.* (\d+) \1-cells? .*\bvolume "
                        r"\(cells? \d[^)]*\)(\n.+)?")
NO_FLUX = re.compile(FILE + r".*\bfacet \d+ \(vertices \d+(, \d+)+\) .*\blength\b.*\bflux\b.*")
SPURIOUS = re.compile(r"polydec: warning: (\d+) .*\beigenvalues .*\bspurious\b\D* (\d+) cells? .*"
                      r"\bnegative dual\b.*\n")


class Tetrahedra(TestCase):
    def numbers(self, name):
        """The values of a Matrix Market array."""
        return [float(line) for line in self.read(name).splitlines()
                if not line.startswith("%") and " " not in line]

    def check_info(self, mesh, *more):
        info = self.ask("info", mesh, *more, seconds=SECONDS)
        self.assertEqual(topology_flaws(info), [])
        self.assertTrue(info["orientable"])
        self.assertGreater(info["volume"], 0)
        return info

    def check_merging(self, mesh, info):
        """Cells and vertices stay; formats of surfaces are refused to solids, and leave nothing."""
        n = info["dimension"]
        out = self.succeed("merge", mesh, "-o", "a.vtu", seconds=SECONDS).out
        cells = info["cells"]
        self.assertEqual(out, f"a.vtu: {cells['input'][n]} cells of dimension {n} merged into "
                              f"{cells['merged'][n]}\n")
        for name in ("a.nsc", "a.mesh", "a.off", "a.obj", "a.ply"):
            if n == 2 and name[2:] in ("off", "obj", "ply"):
                self.succeed("merge", mesh, "-o", name)
                again = self.ask("info", name)
                self.assertEqual(again["cells"]["merged"], cells["merged"])
                self.assertAlmostEqual(again["volume"], info["volume"], delta=1e-12)
            else:
                message = self.fail_with(2, "merge", mesh, "-o", name, seconds=SECONDS)
                self.assertRegex(message, name + ".*use .*" + (".vtu" if n == 3 else ".off"))
                self.assertNotIn(name, os.listdir(self.folder))
        if n == 3 and cells["merged"] == cells["input"]:
            self.assertEqual(self.ask("info", "a.vtu", seconds=SECONDS)["cells"], cells)
        elif n == 3 and b'Name="faces"' in (Path(self.folder) / "a.vtu").read_bytes():
            self.assertRegex(self.fail_with(2, "info", "a.vtu"),
                             r"^polydec: a\.vtu:\d+: cell \d+ .*polyhedron\b.*expected")
        elif n == 3: # hexahedra are split, and merge again
            again = self.ask("info", "a.vtu", seconds=SECONDS)
            self.assertEqual(again["cells"]["merged"], cells["merged"])
            self.assertAlmostEqual(again["volume"], info["volume"], delta=1e-12 * info["volume"])

    def check_sums(self, mesh, info, *more):
        self.succeed("operators", mesh, "--out", "operators", *more, seconds=SECONDS)
        n = info["dimension"]
        self.volumes, self.duals = ([self.numbers(f"operators/{name}_{k}.mtx")
                                     for k in range(n + 1)] for name in ("volume", "dual_volume"))
        self.assertEqual([len(values) for values in self.volumes], info["cells"]["merged"])
        self.assertEqual(partition_flaws(n, self.volumes, self.duals, info["volume"]), [])

    def error_of_linear(self, mesh, side, *more):
        """Largest error where the solution is linear, over what it ranges."""
        answer = self.ask("poisson", mesh, "--side", side, "--rhs", 0, "--boundary", LINEAR,
                          "--exact", LINEAR, *more, seconds=SECONDS)
        self.assertLess(answer["residual"], 1e-10)
        return answer["error"]["max"] / (answer["max"] - answer["min"])

    def check_poisson(self, mesh, relative=1e-12):
        for side in ("primal", "dual"):
            self.assertLess(self.error_of_linear(mesh, side), relative)
            answer = self.ask("poisson", mesh, "--side", side, "--rhs", "x", "--natural",
                              seconds=SECONDS)
            self.assertLess(answer["residual"], 1e-9)
            self.assertLess(answer["min"], 0)
            self.assertGreater(answer["max"], 0)

    def spectrum(self, mesh, side, degree):
        return command.run("spectrum", mesh, *STAR, "--side", side, "--degree", degree, "--count",
                           COUNT, "--json", folder=self.folder, seconds=SECONDS)

    def check_spectra(self, mesh, info):
        """{degree of primal forms: eigenvalues, None where refused}; the dual side says the same,
        or more where it does without the duals of boundary facets."""
        result = {}
        n = info["dimension"]
        for k in range(n + 1):
            outcome = self.spectrum(mesh, "primal", k)
            other = self.spectrum(mesh, "dual", n - k)
            if outcome.code != other.code:
                self.assertGreater(info["facets"]["boundary_degenerate"], 0)
                self.assertEqual((outcome.code, other.code), (2, 0))
            for one, side, degree in ((outcome, "primal", k), (other, "dual", n - k)):
                with self.subTest(side=side, degree=degree):
                    values = self.check_spectrum(one, info, k, side, degree)
                    if side == "primal":
                        result[k] = values
        if result[0] and result[1]:
            self.assertEqual(inclusion_flaws(result[0], result[1]), [])
        return result

    def check_spectrum(self, outcome, info, k, side, degree):
        n, star = info["dimension"], info["stars"][k]
        # such forms do without the duals of boundary facets, so they are fewer than the cells
        fewer = (side == "dual" or k == n) and info["facets"]["boundary_degenerate"] > 0
        if fewer and outcome.code == 0:
            return self.check_answer(command.parse(outcome.out))
        if star["negative"] or star["zero"]:
            self.check_refusal_of_mass(outcome, info, k, side, degree, fewer)
            return None
        if k == n and info["stars"][n - 1]["zero"]:
            message = self.check_error(outcome, 2)
            found = NO_INVERSE.fullmatch(message)
            self.assertIsNotNone(found, message)
            self.assertEqual([int(x) for x in found.group(1, 2)],
                             [n - 1, info["stars"][n - 1]["zero"]])
            return None
        self.assertEqual(outcome.code, 0, outcome.err)
        values = self.check_answer(command.parse(outcome.out))
        self.check_signs(outcome.err, values, info, k)
        return values

    def check_answer(self, answer):
        """The eigenvalues of a complete answer."""
        values = answer["eigenvalues"]
        self.assertEqual((len(values), values), (COUNT, sorted(values)))
        self.assertIs(answer["certificate"]["complete"], True)
        self.assertLess(max(answer["residuals"]), 1e-8 * max(map(abs, values)))
        return values

    def check_signs(self, warnings, values, info, k):
        """Negative duals next to the n-forms make negative eigenvalues, at most as many, and a
        warning; otherwise there are as many zeros as the Betti number says and none is
        negative."""
        negative = info["stars"][k - 1]["negative"] if k == info["dimension"] else 0
        found = SPURIOUS.search(warnings)
        if not negative:
            self.assertIsNone(found, warnings)
            self.assertGreater(values[0], -1e-9 * values[-1])
            self.assertEqual(kernel_flaws(values, info["betti"]["merged"][k]), [])
            return
        below = sum(value < 0 for value in values)
        self.assertLessEqual(below, negative)
        self.assertIsNotNone(found, warnings)
        self.assertEqual([int(x) for x in found.groups()], [below, negative])

    def check_refusal_of_mass(self, outcome, info, k, side, degree, fewer):
        message, star = self.check_error(outcome, 2), info["stars"][k]
        found = MASS.fullmatch(message)
        self.assertIsNotNone(found, message)
        kind = "negative" if star["negative"] else "zero"
        numbers = (star[kind], info["cells"]["merged"][k])
        told = tuple(map(int, found.group(3, 4)))
        self.assertEqual(found.group(1, 2, 5, 6), (side, str(degree), str(k), kind))
        self.assertTrue(told <= numbers if fewer else told == numbers, (told, numbers))


class Others(Tetrahedra):
    """Meshes of others, where they are."""

    def test_every_file(self):
        for path in command.data_files("tet", "planar"):
            with self.subTest(os.path.basename(path)):
                self.check_file(path)

    def check_file(self, path):
        info = self.check_info(path)
        refused, spurious = NOT_DELAUNAY[os.path.basename(path)]
        n = info["dimension"]
        self.assertEqual(tuple(k for k in range(n) if info["stars"][k]["negative"]), refused)
        self.assertEqual(info["stars"][n - 1]["negative"] > 0, spurious)
        self.check_merging(path, info)
        spectra = self.check_spectra(path, info)
        self.assertEqual(tuple(k for k in spectra if spectra[k] is None), refused)
        self.check_any(path, info)
        self.check_linear(path)
        exactly = ("--tolerance", "1e-10")
        self.check_sums(path, self.check_info(path, *exactly), *exactly)
        unmerged = self.check_info(path, "--no-merge")
        self.assertEqual((unmerged["cells"]["merged"], unmerged["betti"]),
                         (info["cells"]["input"], info["betti"]))
        self.assertAlmostEqual(unmerged["volume"] / info["volume"], 1, delta=1e-14)

    def check_any(self, path, info):
        """Without --star every mesh has spectra of every degree, whose zeros are counted by its
        Betti numbers."""
        if info["cells"]["merged"][1] > 5000:
            return
        for k, betti in enumerate(info["betti"]["merged"]):
            found = self.ask("spectrum", path, "--side", "primal", "--degree", k, "--count",
                             betti + 2, seconds=SECONDS)
            self.assertTrue(found["certificate"]["complete"])
            zeros = sum(abs(value) <= radius
                        for value, radius in zip(found["eigenvalues"], found["radii"]))
            self.assertEqual(zeros, betti)
            self.assertGreaterEqual(min(map(float.__add__, found["eigenvalues"], found["radii"])),
                                    0)

    def check_linear(self, path):
        """Exact to rounding where cells are merged that lie on one sphere up to rounding; stars
        that range over nine orders cost some digits. The default tolerance moves centers by up to
        1e-4 of the cells' size, and values with them."""
        self.assertLess(self.error_of_linear(path, "primal"), 1e-11)
        self.assertLess(self.error_of_linear(path, "dual", "--tolerance", "1e-10"), 1e-11)
        self.assertLess(self.error_of_linear(path, "dual"), 1e-4)
        if os.path.basename(path) not in COSPHERICAL:
            self.assertLess(self.error_of_linear(path, "dual", "--no-merge"), 1e-11)
            return
        message = self.fail_with(2, "poisson", path, "--side", "dual", "--rhs", 1, "--no-merge",
                                 "--json", *STAR, seconds=SECONDS)
        self.assertRegex(message, "^" + NO_FLUX.pattern + "$")


class Lattices(Tetrahedra):
    """Meshes that need no folder: cubes, pyramids, octahedra."""

    def make(self, name, cells, extension="nsc"):
        return self.generate(name, "--cells", cells, extension=extension)

    def test_all_commands(self):
        # refused degrees of primal forms; bcc has negative duals, fcc zero ones at the boundary
        for name, refused in (("kuhn", []), ("bcc", [1, 2]), ("fcc", [1, 2])):
            with self.subTest(name):
                mesh = self.make(name, 3)
                info = self.check_info(mesh)
                self.assertAlmostEqual(info["volume"], 1, delta=1e-13)
                self.assertEqual(info["betti"]["input"], [1, 0, 0, 0])
                self.assertEqual((info["components"], info["boundary_components"]), (1, 1))
                self.check_merging(mesh, info)
                self.check_sums(mesh, info)
                self.check_poisson(mesh)
                spectra = self.check_spectra(mesh, info)
                self.assertEqual([k for k in spectra if spectra[k] is None], refused)

    def test_a_torus_has_a_harmonic_1_form(self):
        for name in ("solid_torus3.nsc", "split_cubes.nsc"):
            info = self.check_info(golden(name))
            self.check_spectra(golden(name), info)
            self.check_sums(golden(name), info)
            self.check_poisson(golden(name))
        self.assertEqual(self.ask("info", golden("solid_torus3.nsc"))["betti"]["merged"],
                         [1, 1, 0, 0])

    def test_eigenvalues_of_the_grid_of_cubes_are_known(self):
        """Products of cosines: (4/h^2) (sin^2(i pi h/2) + ..), and so for every primal degree."""
        N = 3
        info = self.check_info(self.make("kuhn", N))
        line = [4 * N**2 * math.sin(i * math.pi / (2 * N))**2 for i in range(N + 1)]
        values = sorted(map(math.fsum, itertools.product(line, repeat=3)))[:COUNT]
        found = self.check_spectra("kuhn.nsc", info)[0]
        self.assertLess(max(abs(a - b) for a, b in zip(found, values)), 1e-12 * values[-1])
        self.assertGreater(max(abs(a - b) for a, b in zip(found, values[1:])), 1)

    def test_both_formats_for_tetrahedra_hold_the_same(self):
        for name in ("kuhn", "bcc", "fcc"):
            first, second = (self.ask("info", self.make(name, 2, kind)) for kind in ("nsc", "mesh"))
            self.assertEqual(first, second)

    def test_unmerged_cubes_have_duals_of_no_length(self):
        mesh = self.make("kuhn", 2)
        message = self.fail_with(2, "poisson", mesh, "--side", "dual", "--rhs", 1, "--no-merge",
                                 *STAR)
        self.assertRegex(message, "^" + NO_FLUX.pattern + "$")


class Orientation(Tetrahedra):
    """The order of a cell's corners does not matter, in any format, but is told."""

    def setUp(self):
        super().setUp()
        self.succeed("generate", "kuhn", "--cells", 2, "-o", "mesh.nsc")
        mesh = Mesh.of_text(self.read("mesh.nsc"))
        self.points, self.cells = mesh.points, mesh.cells

    def answers(self, name):
        results = [self.ask("info", name)]
        for side in ("primal", "dual"):
            answer = self.ask("poisson", name, "--rhs", "x*y", "--side", side)
            results.append({key: answer[key] for key in ("min", "max", "unknowns")})
        results.append(self.ask("spectrum", name, "--side", "primal", "--degree", 1, "--count",
                                COUNT)["eigenvalues"])
        return results

    def check(self, cells, warnings):
        wanted = self.answers("mesh.nsc")
        for name, text in mesh_files(self.points, cells).items():
            self.write(name, text)
        for name in ("a.nsc", "a.mesh", "a.msh", "a.vtk", "a.node", "a.ele"):
            with self.subTest(name):
                found = self.answers(name)
                told = found[0].pop("warnings")
                self.assertEqual(len(told), len(warnings), told)
                for text, words in zip(told, warnings):
                    self.assertSays(text, *words)
                self.assertEqual(differences(found[1:], wanted[1:]), [])
                self.assertEqual(differences({**found[0], "warnings": []}, wanted[0]), [])

    def test_some_cells_turned(self):
        cells = [[c[1], c[0], *c[2:]] if i % 5 == 0 else c for i, c in enumerate(self.cells)]
        self.check(cells, [(10, 48, "cells", "orientation")])

    def test_all_cells_turned(self):
        self.check([[c[1], c[0], *c[2:]] for c in self.cells], [])

    def test_a_flat_cell_that_is_too_much_is_left_out(self):
        self.check(self.cells + [[0, 1, 2, 3]], [("1 cell", "volume", "48 (0 1 2 3)")])

    def test_cells_twice_or_with_a_repeated_corner_are_left_out(self):
        a, b, c, _ = self.cells[7]
        self.check(self.cells + [self.cells[7][::-1], [a, b, c, c]],
                   [("1 cell", "repeated", f"49 ({a} {b} {c} {c})"),
                    ("1 cell", "vertices", f"48 ({' '.join(map(str, self.cells[7][::-1]))})")])


class Twins(unittest.TestCase):
    """Each law fails where it has to."""
    INFO = {"betti": {"input": [1, 0], "merged": [1, 0]}, "euler": {"input": 1, "merged": 1},
            "cells": {"input": [4, 3], "merged": [3, 2]}}

    def test_topology(self):
        self.assertEqual(topology_flaws(self.INFO), [])
        for key, value in (("betti", [1, 1]), ("cells", [3, 3]), ("euler", 0)):
            broken = {**self.INFO, key: {**self.INFO[key], "merged": value}}
            self.assertNotEqual(topology_flaws(broken), [])

    def test_kernels(self):
        self.assertEqual(kernel_flaws([1e-14, 2, 3], 1), [])
        self.assertNotEqual(kernel_flaws([1e-14, 1e-15, 3], 1), [])
        self.assertNotEqual(kernel_flaws([1e-6, 2, 3], 1), [])

    def test_inclusion(self):
        self.assertEqual(inclusion_flaws([0, 2, 3, 5], [2, 2.5, 3, 4]), [])
        self.assertEqual(inclusion_flaws([0, 2, 3 + 1e-6, 5], [2, 2.5, 3, 4]), [3 + 1e-6])

    def test_partition(self):
        # the triangle (0, 0), (4, 0), (1, 1) is obtuse: the dual of the long edge is negative
        volumes = [[1, 1, 1], [4, 2**.5, 10**.5], [2]]
        duals = [[1, .5, .5], [-1, 1.5 * 2**.5, .5 * 10**.5], [1]]
        self.assertEqual(partition_flaws(2, volumes, duals, 2), [])
        self.assertEqual(partition_flaws(2, volumes, [duals[0], [1, *duals[1][1:]], [1]], 2), [1])
        self.assertEqual(partition_flaws(2, volumes, [[1, 1, 1], duals[1], [1]], 2), [0])

    def test_differences(self):
        first = {"a": [1, {"b": 2.0}], "c": "x"}
        self.assertEqual(differences(first, {"a": [1, {"b": 2.0 + 1e-13}], "c": "x"}), [])
        self.assertEqual(differences(first, {"a": [1, {"b": 2.1}], "c": "x"}), ["/a/1/b"])
        self.assertEqual(differences(first, {"a": [1], "c": "x"}), ["/a"])
