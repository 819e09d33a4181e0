# SPDX-License-Identifier: MIT
"""Broken meshes: each ends soon, in little memory, with the code and the message that is here."""
import os
import time

import command
from command import TestCase

SQUARE = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
TETRAHEDRON = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
FACES = "3 0 2 1\n3 0 1 3\n3 1 2 3\n"
FILES = {
    "hand_duplicate_face.off": f"OFF\n4 3 0\n{SQUARE}3 0 1 2\n3 0 2 3\n3 0 1 2\n",
    "hand_empty.off": "",
    "hand_flat_tet.mesh": "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n"
                          "1 1 0 0\n0 1 0 0\nTetrahedra\n1\n1 2 3 4 0\nEnd\n",
    "hand_huge_count.off": "OFF\n4000000000 4000000000 0\n0 0 0\n",
    "hand_inconsistent_orientation.off": f"OFF\n4 2 0\n{SQUARE}3 0 1 2\n3 0 3 2\n",
    "hand_index_out_of_range.off": f"OFF\n4 2 0\n{SQUARE}3 0 1 2\n3 0 2 4\n",
    "hand_inverted_tet.mesh": "MeshVersionFormatted 2\nDimension 3\nVertices\n5\n0 0 0 0\n"
                              "1 0 0 0\n0 1 0 0\n0 0 1 0\n1 1 1 0\nTetrahedra\n2\n1 2 3 4 0\n"
                              "3 2 4 5 0\nEnd\n",
    "hand_nan.off": "OFF\n4 2 0\n0 0 0\n1 0 0\nnan 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n",
    "hand_negative_counts.off": "OFF\n-4 -2 0\n",
    "hand_negative_index.off": f"OFF\n4 2 0\n{SQUARE}3 0 1 2\n3 0 2 -1\n",
    "hand_no_faces.off": f"OFF\n4 0 0\n{SQUARE}",
    "hand_nonmanifold_edge.off": "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n3 0 1 2\n"
                                 "3 1 0 3\n3 0 1 4\n",
    "hand_repeated_index.off": f"OFF\n4 2 0\n{SQUARE}3 0 1 2\n3 0 2 2\n",
    "hand_truncated.off": f"OFF\n4 4 0\n{TETRAHEDRON}{FACES}",
    "hand_truncated_midline.off": f"OFF\n4 4 0\n{TETRAHEDRON}{FACES}3 0 ",
    "hand_zero_area.off": "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 0 0\n3 0 1 2\n3 0 2 3\n",
    "tiny_triangle.off": "OFF\n3 1 0\n0 0 0\n1e-200 0 0\n0 1e-200 0\n3 0 1 2\n",
    "binary.off": "OFF BINARY\n\1\2\3",
}

# What is wrong, and what is done about it. Warnings go with code 0.
ANSWERS = {
    "binary.off": (2, (
        "polydec: binary.off:1: the file is a binary OFF; expected text; convert "
        "it to text or PLY\n")),
    "degenerate_mesh.obj": (2, (
        "polydec: degenerate_mesh.obj: no cells of positive volume are left\n"
        "left out 1 cell without area: 0 (2 1 0)\n")),
    "hand_duplicate_face.off": (0, (
        "polydec: warning: left out 1 cell on the vertices of an earlier one: 2 "
        "(0 1 2)\n")),
    "hand_empty.off": (2, (
        "polydec: hand_empty.off:1: the file ends here; expected the keyword "
        "OFF; export it again, it seems cut off\n")),
    "hand_flat_tet.mesh": (2, (
        "polydec: hand_flat_tet.mesh: no cells of positive volume are left\n"
        "left out 1 cell without volume: 0 (0 1 2 3)\n")),
    "hand_huge_count.off": (2, (
        "polydec: hand_huge_count.off:2: 4000000000 vertices are promised, but "
        "20 bytes follow; expected at least 6 bytes for each; correct the "
        "number, or export again if the file was cut off\n")),
    "hand_inconsistent_orientation.off": (0, (
        "polydec: warning: 1 of 2 cells was turned to be oriented like its "
        "neighbors\n")),
    "hand_index_out_of_range.off": (2, (
        "polydec: hand_index_out_of_range.off:8: vertex number 4 is out of "
        "range; expected 0 to 3; correct the index or add the vertex\n")),
    "hand_inverted_tet.mesh": (0, (
        "polydec: warning: 1 of 2 cells was turned to be oriented like its "
        "neighbors\n")),
    "hand_nan.off": (2, (
        "polydec: hand_nan.off:5: vertex 2 (counted from 0) has a coordinate "
        "that is NaN, infinite or beyond the doubles; expected finite numbers; "
        "repair or remove the vertex\n")),
    "hand_negative_counts.off": (2, (
        "polydec: hand_negative_counts.off:2: -4 vertices are promised; expected "
        "a number that is not negative; correct it\n")),
    "hand_negative_index.off": (2, (
        "polydec: hand_negative_index.off:8: vertex number -1 is out of range; "
        "expected 0 to 3; correct the index or add the vertex\n")),
    "hand_no_faces.off": (2, (
        "polydec: hand_no_faces.off: the file holds 4 vertices but no cells; "
        "expected at least one cell; export it with its cells\n")),
    "hand_nonmanifold_edge.off": (0, (
        "polydec: warning: not a manifold: 1 facet with three or more cells\n")),
    "hand_repeated_index.off": (0, (
        "polydec: warning: left out 1 cell with a repeated corner: 1 (0 2 2)\n"
        "polydec: warning: 1 vertex belongs to no cell, left out of all counts: "
        "3\n")),
    "hand_truncated.off": (2, (
        "polydec: hand_truncated.off:10: the file ends after 3 of 4 faces; "
        "expected the others; export it again, it seems cut off\n")),
    "hand_truncated_midline.off": (2, (
        "polydec: hand_truncated_midline.off:10: 3 corners of a face are "
        "promised, but 3 bytes follow; expected at least 2 bytes for each; "
        "correct the number, or export again if the file was cut off\n")),
    "hand_zero_area.off": (0, (
        "polydec: warning: left out 1 cell without area: 1 (0 2 3)\n"
        "polydec: warning: 1 vertex belongs to no cell, left out of all counts: "
        "3\n")),
    "inf_nan.obj": (2, (
        "polydec: inf_nan.obj:1: vertex 0 (counted from 0) has a coordinate that "
        "is NaN, infinite or beyond the doubles; expected finite numbers; repair "
        "or remove the vertex\n")),
    "invalid_assimp.off": (2, (
        "polydec: invalid_assimp.off:3: '0.1' is not a whole number; expected "
        "the number of edges; correct the line or export the file again\n")),
    "malformed_assimp.obj": (2, (
        "polydec: malformed_assimp.obj:28: vertex number 0 is out of range; "
        "expected 1 to 8; correct the index or add the vertex\n")),
    "moebius.obj": (0, (
        "polydec: warning: 224 polygons with more than three corners split into "
        "triangles, the first is face 0\n"
        "polydec: warning: the mesh is non-orientable: its cells keep the "
        "orientation of the input, and operators on dual 0-forms see jumps of "
        "sign\n")),
    "non_manif_hole.ply": (0, ""),
    "notenoughindices.obj": (0, (
        "polydec: warning: 1 face with fewer than three corners left out, the "
        "first is face 0\n")),
    "oblong-shuffled.off": (0, (
        "polydec: warning: 397 of 840 cells were turned to be oriented like "
        "their neighbors\n")),
    "soup.stl": (0, ""),
    "tiny_triangle.off": (0, (
        "polydec: warning: the lengths of the mesh are far from 1: it is measured "
        "in units of 2^-666 = 3.27e-201\n"
        "polydec: warning: volumes that are no numbers of double precision in the "
        "units of the file are left out\n")),
}


class BadMeshes(TestCase):
    def answer(self, path):
        started = time.monotonic()
        outcome = command.run("info", os.path.basename(path), "--json", limit=True, seconds=120,
                              folder=os.path.dirname(path))
        self.assertLess(time.monotonic() - started, 5)
        if outcome.code == 0:
            command.parse(outcome.out)
        else:
            self.check_error(outcome, outcome.code)
        return outcome.code, outcome.err

    def check(self, path):
        name = os.path.basename(path)
        with self.subTest(name):
            self.assertEqual(self.answer(path), ANSWERS[name])

    def test_those_made_by_hand(self):
        for name, text in FILES.items():
            self.check(self.write(name, text))

    def test_those_of_others(self):
        for path in command.data_files("bad"):
            self.check(path)

    def test_every_cut_of_a_file_is_refused_or_read(self):
        text = "".join(f"{x}\n" for x in ("2 2 4 2", "0 0", "1 0", "1 1", "0 1", "0 1 2", "0 2 3"))
        for length in range(len(text) - 1):
            code, message = self.answer(self.write("cut.nsc", text[:length]))
            self.assertEqual(code, 2, (text[:length], message))


if __name__ == "__main__":
    command.main()
