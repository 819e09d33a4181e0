# SPDX-License-Identifier: MIT
"""Broken meshes: each ends soon, in little memory, with the code and the words that are here."""
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

# What is wrong and what is done about it, by the words that each line says in this order. Warnings
# go with code 0.
ANSWERS = {
    "binary.off": (2, [("binary.off:1:", "binary", "expected", "text")]),
    "degenerate_mesh.obj": (2, [("degenerate_mesh.obj:", "no cells", "volume"),
                                ("1 cell", "area", "0 (2 1 0)")]),
    "hand_duplicate_face.off": (0, [("1 cell", "vertices", "2 (0 1 2)")]),
    "hand_empty.off": (2, [("hand_empty.off:1:", "ends", "expected", "OFF")]),
    "hand_flat_tet.mesh": (2, [("hand_flat_tet.mesh:", "no cells", "volume"),
                               ("1 cell", "volume", "0 (0 1 2 3)")]),
    "hand_huge_count.off": (2, [("hand_huge_count.off:2:", 4000000000, "vertices", 20, "bytes",
                                 "expected", 4)]),
    "hand_inconsistent_orientation.off": (0, [(1, 2, "cells", "orientation")]),
    "hand_index_out_of_range.off": (2, [("hand_index_out_of_range.off:8:", "vertex", 4, "expected",
                                         0, 3)]),
    "hand_inverted_tet.mesh": (0, [(1, 2, "cells", "orientation")]),
    "hand_nan.off": (2, [("hand_nan.off:5:", "vertex 2", "coordinate", "NaN", "expected",
                          "finite")]),
    "hand_negative_counts.off": (2, [("hand_negative_counts.off:2:", "-4", "vertices", "expected",
                                      "at least 0")]),
    "hand_negative_index.off": (2, [("hand_negative_index.off:8:", "vertex", "-1", "expected", 0,
                                     3)]),
    "hand_no_faces.off": (2, [("hand_no_faces.off:", "4 vertices", "cells", "expected")]),
    "hand_nonmanifold_edge.off": (0, [("manifold", "1 facet", "three")]),
    "hand_repeated_index.off": (0, [("1 cell", "repeated", "1 (0 2 2)"),
                                    ("1 vertex", "no cell", 3)]),
    "hand_truncated.off": (2, [("hand_truncated.off:10:", "ends", 3, 4, "faces", "expected")]),
    "hand_truncated_midline.off": (2, [("hand_truncated_midline.off:10:", "3 corners", "3 bytes",
                                        "expected", 2)]),
    "hand_zero_area.off": (0, [("1 cell", "area", "1 (0 2 3)"), ("1 vertex", "no cell", 3)]),
    "inf_nan.obj": (2, [("inf_nan.obj:1:", "vertex 0", "coordinate", "NaN", "expected", "finite")]),
    "invalid_assimp.off": (2, [("invalid_assimp.off:3:", "'0.1'", "expected", "edges")]),
    "malformed_assimp.obj": (2, [("malformed_assimp.obj:28:", "vertex", 0, "expected", 1, 8)]),
    "moebius.obj": (0, [("224 polygons", "triangles", "face 0"),
                        ("non-orientable", "orientation", "dual 0-forms")]),
    "non_manif_hole.ply": (0, []),
    "notenoughindices.obj": (0, [("1 face", "three corners", "face 0")]),
    "oblong-shuffled.off": (0, [(397, 840, "cells", "orientation"),
                                ("2 vertices", "coincide", "93, 95", "--weld")]),
    "soup.stl": (0, []),
    "tiny_triangle.off": (0, [("lengths", "units", "2^-666", "3.27e-201"), ("volumes", "units")]),
}


class BadMeshes(TestCase):
    def answer(self, path):
        started = time.monotonic()
        outcome = command.run("info", os.path.basename(path), "--json", limit=True,
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
            code, message = self.answer(path)
            lines = message.splitlines()
            self.assertEqual((code, len(lines)), (ANSWERS[name][0], len(ANSWERS[name][1])), message)
            for line, words in zip(lines, ANSWERS[name][1]):
                if code == 0:
                    self.assertTrue(line.startswith("polydec: warning: "), line)
                self.assertSays(line, *words)

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
