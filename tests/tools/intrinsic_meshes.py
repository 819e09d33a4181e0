# SPDX-License-Identifier: MIT
"""Intrinsic flips on surfaces as they are found: no negative dual inside, none at all where
boundary edges may be split, and spectra that were refused before."""
import collections
import functools
import math
import os
import re
import unittest
import xml.etree.ElementTree

import command
from command import TestCase, golden, says
from golden_numbers import Matrix
from intrinsic_laws import area_of, flip_flaws, positive_entries, spectrum_flaws, split_flaws
from polyhedra import area_vector, array_of, read_alone

FOLDERS = ("surface", "cad", "poly", "planar", "table2")
FLIPS, SPLITS = "--delaunay", "--delaunay=split-boundary"

BRANCHING = {"beetle.obj", "truck.obj", "conrod.stl", "bun_zipper_res3.ply"}
# cells without area, which only flips can do with
FLAT_CELLS = {"112932.stl", "bathtub_0154.ply", "block.obj", "ogre.obj"}

SECONDS = 200 # for the largest
COUNT = 6
ALL_FORMS = [(side, degree) for side in ("primal", "dual") for degree in range(3)]
ONE_FORMS_FIRST = sorted(ALL_FORMS, key=lambda forms: forms[1] != 1)
LEAST_SPECTRA = 17
TRIANGLES_FOR_SPECTRA = 8000
TRIANGLES_FOR_LAPLACIANS = 1600
TRIANGLES_WITHOUT_FLIPS = 60000

POSITIVE = ("positive", "--delaunay=split-boundary")
SPURIOUS = ("eigenvalues", "negative", "spurious")


def surfaces(flat_cells=True):
    """Files that can be glued, where they are."""
    left_out = BRANCHING if flat_cells else BRANCHING | FLAT_CELLS
    return [path for path in command.data_files(*FOLDERS)
            if os.path.basename(path) not in left_out]


def real(name):
    """The file of that name where the real meshes are, or None."""
    return next((path for path in surfaces() if path.endswith("/" + name)), None)


@functools.cache
def info_of(path, *options):
    """What `info` says, asked for once."""
    outcome = command.run("info", path, "--json", *options, seconds=SECONDS)
    if outcome.code:
        raise AssertionError(f"{path} {options}\n{outcome.err}")
    return command.parse(outcome.out)


def is_small(path, triangles):
    return info_of(path, FLIPS)["cells"]["input"][2] <= triangles


class EveryFile(TestCase):
    def test_flips_leave_no_negative_dual_inside_and_splits_none_at_all(self):
        for path in surfaces():
            with self.subTest(os.path.basename(path)):
                flipped, split = (info_of(path, option) for option in (FLIPS, SPLITS))
                self.assertEqual(flip_flaws(flipped), [])
                self.assertEqual(split_flaws(split), [])
                if not flipped["intrinsic"]["negative_boundary"]:
                    self.assertGreater(flipped["stars"][0]["min"], 0)
                self.assertEqual(flipped["intrinsic"]["splits"], 0)
                self.assertEqual(split["cells"]["input"], flipped["cells"]["input"])

    def test_flips_and_splits_keep_area_and_topology(self):
        for path in surfaces(flat_cells=False):
            if not is_small(path, TRIANGLES_WITHOUT_FLIPS):
                continue
            with self.subTest(os.path.basename(path)):
                plain = info_of(path)
                for info in (info_of(path, FLIPS), info_of(path, SPLITS)):
                    self.assertEqual(info["betti"]["merged"], plain["betti"]["input"])
                    self.assertEqual(info["components"], plain["components"])
                    self.assertEqual(info["boundary_components"], plain["boundary_components"])
                    # needles get a little length, and area with it
                    exact = info["intrinsic"]["added_length"] == 0
                    self.assertAlmostEqual(info["volume"] / plain["volume"], 1,
                                           delta=1e-11 if exact else 2e-3)

    def test_without_flips_the_same_laws_fail(self):
        bob = real("bob_small.ply")
        if bob:
            done = dict.fromkeys(("negative", "negative_boundary"), 0)
            self.assertNotEqual(flip_flaws({**info_of(bob), "intrinsic": done}), [])

    def test_without_splits_the_boundary_may_stay_negative(self):
        negative = {os.path.basename(path) for path in surfaces()
                    if split_flaws(info_of(path, FLIPS))}
        if surfaces():
            self.assertLessEqual({"mountain.obj", "bun_zipper.ply"}, negative)

    def test_three_triangles_at_an_edge_are_refused_by_its_vertices(self):
        files = [path for path in command.data_files(*FOLDERS)
                 if os.path.basename(path) in BRANCHING]
        for path in [golden("branching.off"), *files]:
            for option in (FLIPS, SPLITS):
                with self.subTest(os.path.basename(path), option=option):
                    message = self.fail_with(2, "info", path, "--json", option)
                    self.assertSays(message, f"{path}: ", "triangles", "edge", "vertex")
                    self.assertRegex(message, r" \d+ triangles .* vertex \d+ \w+ \d+: ")

    def test_broken_files_end_in_an_error_or_obey_the_laws(self):
        for path in command.data_files("bad"):
            for option, flaws in ((FLIPS, flip_flaws), (SPLITS, split_flaws)):
                with self.subTest(os.path.basename(path), option=option):
                    outcome = command.run("info", path, "--json", option, limit=True)
                    if outcome.code:
                        self.assertIn(outcome.code, (2, 4))
                        self.check_error(outcome, outcome.code)
                    else:
                        self.assertEqual(flaws(command.parse(outcome.out)), [])

    def test_cells_without_area_are_refused_without_flips_alone(self):
        for path in set(surfaces()) - set(surfaces(flat_cells=False)):
            with self.subTest(os.path.basename(path)):
                self.assertSays(self.fail_with(2, "info", path), path, "no area")
                info = info_of(path, FLIPS)
                self.assertGreater(info["intrinsic"]["added_length"], 0)
                self.assertSays(" ".join(info["warnings"]), "triangle", "no area")


class Laplacians(TestCase):
    def laplacian(self, path, *more):
        self.succeed("operators", path, "--out", "out", *more)
        return Matrix(self.path("out/laplacian_primal_0.mtx"))

    def test_the_laplacian_of_0_forms_has_no_positive_entry_off_its_diagonal(self):
        for path in surfaces():
            if is_small(path, TRIANGLES_FOR_LAPLACIANS):
                with self.subTest(os.path.basename(path)):
                    self.assertEqual(positive_entries(self.laplacian(path, SPLITS)), [])

    def test_without_flips_it_has(self):
        bob = real("bob_small.ply")
        if bob:
            self.assertNotEqual(positive_entries(self.laplacian(bob)), [])
            self.assertEqual(positive_entries(self.laplacian(bob, FLIPS)), [])


class Spectra(TestCase):
    """Laplace-de Rham operators of all degrees on both sides."""

    def spectrum(self, path, side, degree, count, *more):
        return command.run("spectrum", path, "--star", "circumcentric", "--side", side, "--degree",
                           degree, "--count", count, "--json", *more, folder=self.folder,
                           seconds=SECONDS)

    def is_refused(self, path, side, degree):
        """Whether it is, or has negative eigenvalues; the text says what helps."""
        outcome = self.spectrum(path, side, degree, COUNT)
        if outcome.code:
            message = self.check_error(outcome, 2)
            ways = [("no area",)] if os.path.basename(path) in FLAT_CELLS else [POSITIVE, ("zero",)]
            self.assertTrue(any(says(message, path, *words) for words in ways), message)
        elif says(outcome.err, *SPURIOUS):
            self.assertSays(outcome.err, *SPURIOUS, "--delaunay")
            self.assertLess(command.parse(outcome.out)["eigenvalues"][0], 0)
        return bool(outcome.code) or says(outcome.err, *SPURIOUS)

    def check(self, path, side, degree):
        betti = info_of(path, SPLITS)["betti"]["input"][degree if side == "primal" else 2 - degree]
        with self.subTest(os.path.basename(path), side=side, degree=degree):
            outcome = self.spectrum(path, side, degree, COUNT + betti, SPLITS)
            self.assertEqual(outcome.code, 0, outcome.err)
            self.assertEqual(spectrum_flaws(command.parse(outcome.out), betti), [])

    def test_spectra_that_were_refused_are_certified_after_splits(self):
        helped = 0
        for path in surfaces():
            # one of the six is enough, and 1-forms are refused soonest
            if is_small(path, TRIANGLES_FOR_SPECTRA) and any(
                    self.is_refused(path, *forms) for forms in ONE_FORMS_FIRST):
                helped += os.path.basename(path) not in FLAT_CELLS
                for forms in ALL_FORMS:
                    self.check(path, *forms)
        if surfaces():
            self.assertGreaterEqual(helped, LEAST_SPECTRA)

    def test_of_a_surface_with_negative_vertices_and_edges_none_is_right_before(self):
        bob = real("bob_small.ply")
        for forms in ALL_FORMS if bob else ():
            self.assertTrue(self.is_refused(bob, *forms))

    def test_where_nothing_was_refused_flips_change_no_eigenvalue(self):
        grid = real("square_hole.off")
        for forms in ALL_FORMS if grid else ():
            self.assertFalse(self.is_refused(grid, *forms))
            before, after = (command.parse(self.spectrum(grid, *forms, COUNT, *more).out)
                             for more in ((), (FLIPS,)))
            self.assertLess(max(abs(a - b) for a, b in zip(
                before["eigenvalues"], after["eigenvalues"], strict=True)), 1e-9)


class Pictures(TestCase):
    FILES = ("bob_small.ply", "20mm-xyz-cube.stl")

    def check_arrays(self, path, k, names):
        """Finite numbers on the input's points (k = 0), edges or triangles."""
        grid, info = read_alone(self.path("a.vtu")), self.ask("info", path)
        root = xml.etree.ElementTree.parse(self.path("a.vtu"))
        self.assertEqual(grid.points, self.input.points)
        wanted = self.input.cells if k != 1 else None
        self.assertEqual(len(grid.cells), info["cells"]["input"][k or 2])
        if wanted:
            self.assertEqual(sorted(sorted(c[0]) for c in grid.cells),
                             sorted(sorted(c[0]) for c in wanted))
        arrays = root.findall(f".//{'CellData' if k else 'PointData'}/DataArray")
        self.assertEqual([array.get("Name") for array in arrays], names)
        for array in arrays:
            values = array_of(array)
            self.assertEqual(len(values), info["cells"]["input"][k])
            self.assertTrue(all(map(math.isfinite, values)))
            self.assertGreater(max(map(abs, values)), 0)

    def files(self):
        for path in filter(None, map(real, self.FILES)):
            self.succeed("merge", path, "--no-merge", "-o", "input.vtu")
            self.input = read_alone(self.path("input.vtu"))
            yield path

    def test_modes_and_solutions_are_drawn_on_the_triangles_of_the_input(self):
        for path in self.files():
            for side in ("primal", "dual"):
                for degree in range(3):
                    with self.subTest(os.path.basename(path), side=side, degree=degree):
                        self.succeed("spectrum", path, FLIPS, "--side", side, "--degree", degree,
                                     "--count", 3, "-o", "a.vtu")
                        self.check_arrays(path, degree if side == "primal" else 2 - degree,
                                          ["mode_0", "mode_1", "mode_2"])
                self.succeed("poisson", path, FLIPS, "--side", side, "--rhs", "x", "-o", "a.vtu")
                self.check_arrays(path, 0 if side == "primal" else 2, ["u"])

    def test_the_pieces_of_the_merged_cells_cover_the_surface(self):
        for path in self.files():
            info = info_of(path, FLIPS)
            for name in ("a.obj", "a.vtu"):
                with self.subTest(os.path.basename(path), file=name):
                    self.succeed("merge", path, FLIPS, "-o", name)
                    area = (self.ask("info", name)["volume"] if name == "a.obj" else
                            area_of(read_alone(self.path(name))))
                    self.assertAlmostEqual(area / info["volume"], 1, delta=1e-9)

    def test_each_piece_tells_its_cell_and_its_triangle(self):
        for path in self.files():
            info = self.ask("info", path, FLIPS)
            self.succeed("merge", path, FLIPS, "-o", "a.vtu")
            root, areas = xml.etree.ElementTree.parse(self.path("a.vtu")), {}
            pieces = [math.hypot(*area_vector(grid.points, faces[0]))
                      for grid in [read_alone(self.path("a.vtu"))] for faces in grid.cells]
            for name, k in (("cell", "merged"), ("triangle", "input")):
                array = root.find(f".//CellData/DataArray[@Name='{name}']")
                areas[name] = collections.defaultdict(float)
                for owner, area in zip(array_of(array), pieces, strict=True):
                    areas[name][owner] += area
                self.assertEqual(set(areas[name]), set(range(info["cells"][k][2])))
            self.succeed("operators", path, FLIPS, "--out", "out")
            for cell, area in enumerate(Matrix(self.path("out/volume_2.mtx")).values()):
                self.assertAlmostEqual(areas["cell"][cell], area, delta=1e-9 * info["volume"])


class Advice(TestCase):
    def test_info_advises_what_works(self):
        for path in surfaces(flat_cells=False):
            if not is_small(path, TRIANGLES_WITHOUT_FLIPS):
                continue
            with self.subTest(os.path.basename(path)):
                info = info_of(path)
                negative, zero = info["stars"][1]["negative"], info["stars"][1]["zero"]
                self.assertEqual(len(info["advice"]), 1 if negative + zero > 0 else 0)
                for text in info["advice"]:
                    match = re.fullmatch(r"(\d+) (negative )?dual edges?.*: add (--.*)", text)
                    self.assertIsNotNone(match, text)
                    self.assertEqual(int(match[1]), negative or zero)
                    self.assertEqual(bool(match[2]), negative > 0)
                    if match[3] == FLIPS:
                        self.assertEqual(info_of(path, FLIPS)["stars"][1]["negative"], 0)
                    better = info_of(path, *match[3].split())
                    self.assertEqual([star["negative"] + star["zero"] for star in better["stars"]],
                                     [0] * 3)
                    self.assertEqual(better["advice"], [])

    def test_the_table_says_so_too(self):
        bob = real("bob_small.ply")
        if bob:
            text = self.succeed("info", bob).out
            self.assertSays(text.splitlines()[-1], "94 negative dual edges", "--delaunay")

    def test_nothing_is_advised_where_nothing_helps(self):
        for name in ("branching.off", "kuhn3.nsc", "uv8.off"):
            self.assertEqual(self.ask("info", golden(name))["advice"], [])

    def test_solids_are_told_of_stars(self):
        advice, = self.ask("info", golden("bcc2.nsc"))["advice"]
        self.assertSays(advice, "24 negative dual edges", "--star automatic")


class Options(TestCase):
    COMMANDS = (("info",), ("merge", "-o", "a.vtu"), ("operators", "--out", "out"),
                ("spectrum", "--side", "primal", "--degree", 0, "--count", 1),
                ("poisson", "--side", "dual", "--rhs", 1))

    def test_cells_that_are_no_triangles_are_refused(self):
        for name, dimension in (("kuhn1d.nsc", 1), ("kuhn3.nsc", 3), ("kuhn4.nsc", 4)):
            for first, *rest in self.COMMANDS:
                with self.subTest(name, command=first):
                    self.assertSays(self.fail_with(2, first, golden(name), *rest, FLIPS),
                                    "--delaunay", golden(name), f"dimension {dimension}")
        self.assertEqual(os.listdir(self.folder), [])

    def test_only_two_words_follow_the_option(self):
        for first, *rest in self.COMMANDS:
            self.assertSays(
                self.fail_with(1, first, golden("uv8.off"), *rest, "--delaunay=nonsense"),
                "--delaunay: ", "flips", "split-boundary", "nonsense")

    def test_flips_go_by_lengths_and_not_by_angles(self):
        self.assertSays(self.fail_with(1, "info", golden("uv8.off"), FLIPS, "--angle-tolerance", 1),
                        "--angle-tolerance", "--delaunay")

    def test_the_long_form_says_the_same(self):
        mesh = golden("star_negative.nsc")
        self.assertEqual(self.ask("info", mesh, FLIPS), self.ask("info", mesh, FLIPS + "=flips"))


class Twins(unittest.TestCase):
    """Each law fails where it has to."""

    @staticmethod
    def info(negative=0, boundary=0, star=(1, 1, 1)):
        return {"betti": {"input": [1, 0], "merged": [1, 0]}, "euler": {"input": 1, "merged": 1},
                "cells": {"input": [4, 3], "merged": [3, 2]},
                "intrinsic": {"negative": negative, "negative_boundary": boundary},
                "stars": [{"min": x, "negative": int(x < 0), "zero": int(x == 0)} for x in star]}

    def test_flips(self):
        self.assertEqual(flip_flaws(self.info()), [])
        self.assertEqual(flip_flaws(self.info(boundary=1, star=(-1, -1, 1))), [])
        for broken in (self.info(negative=1), self.info(star=(1, -1, 1)),
                       self.info(star=(-1, 1, 1)), self.info(boundary=1)):
            self.assertEqual(len(flip_flaws(broken)), 1)

    def test_splits(self):
        self.assertEqual(split_flaws(self.info()), [])
        for star in ((0, 1, 1), (1, 0, 1), (1, 1, 0)):
            self.assertEqual(len(split_flaws(self.info(star=star))), 1)

    def test_spectra(self):
        def flaws(values, complete=True):
            return spectrum_flaws({"eigenvalues": values, "certificate": {"complete": complete}}, 1)
        self.assertEqual(flaws([-1e-12, 1, 2]), [])
        self.assertEqual(len(flaws([-1e-12, 1, 2], False)), 1)
        self.assertEqual(len(flaws([0, 0, 2])), 1)
        self.assertEqual(len(flaws([-3, 0, 2])), 1)
