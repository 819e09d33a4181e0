# SPDX-License-Identifier: MIT
"""Meshes as they are found: every command ends well or with a clear error, in reasonable time."""
import os
import xml.etree.ElementTree

import command
from command import TestCase

SECONDS = 300
TRIANGLES_FOR_SPECTRA = 20000

# cells without area that cannot be left out: their removal would open the surface
REFUSED = {"112932.stl", "bathtub_0154.ply", "block.obj", "ogre.obj"}
# triangles 1e-7 times as high as long, whose eigenvalues hide all others
NEEDLES = {"Generic_Twin_7081.1.t0_right.obj"}
# merged cells: eight boxes in a row, a mesh without slivers, and one with a pair of tetrahedra on one
# sphere by an independent program
SOLIDS = {"beam-tet.vtk": [36, 68, 41, 8], "icos.1.ele": [13, 42, 50, 20],
          "octopus-low.mesh": [452, 2040, 2728, 1139]}


class RealMeshes(TestCase):
    def test_solids_have_known_cells(self):
        for path in command.data_files("tet"):
            if os.path.basename(path) in SOLIDS:
                self.assertEqual(self.ask("info", path)["cells"]["merged"],
                                 SOLIDS[os.path.basename(path)])

    def test_surfaces(self):
        for path in command.data_files("surface", "cad", "poly", "table2"):
            with self.subTest(os.path.basename(path)):
                self.check_surface(path)

    def check_surface(self, path):
        outcome = command.run("info", path, "--json", seconds=SECONDS)
        if os.path.basename(path) in REFUSED:
            self.check_error(outcome, 2)
            return
        self.assertEqual(outcome.code, 0, outcome.err)
        info = command.parse(outcome.out)
        self.assertEqual(info["betti"]["input"], info["betti"]["merged"])
        self.assertEqual(info["euler"]["input"], info["euler"]["merged"])
        if info["cells"]["input"][2] > TRIANGLES_FOR_SPECTRA:
            return
        self.succeed("merge", path, "-o", "a.vtu", seconds=SECONDS)
        piece = xml.etree.ElementTree.parse(self.path("a.vtu")).getroot().find(".//Piece")
        self.assertEqual(int(piece.get("NumberOfCells")), info["cells"]["merged"][2])
        for side in ("primal", "dual"):
            if os.path.basename(path) not in NEEDLES:
                self.check_spectrum(path, side, info)

    def check_spectrum(self, path, side, info):
        outcome = command.run("spectrum", path, "--side", side, "--degree", 0, "--count", 10,
                              "--json", seconds=SECONDS)
        if side == "dual" and "three or more cells" in info["laplacians"][-1].get("dual_reason", ""):
            self.assertSays(self.check_error(outcome, 2), "cells meet at facet", "primal")
            return
        self.assertEqual(outcome.code, 0, outcome.err)
        answer = command.parse(outcome.out)
        self.assertEqual(len(answer["eigenvalues"]), 10)
        self.assertIs(answer["certificate"]["complete"], True)
        self.assertTrue(all(value >= -radius for value, radius in
                            zip(answer["eigenvalues"], answer["radii"])))
