# SPDX-License-Identifier: MIT
"""Conditions by groups of the file, and Robin's."""
import collections
import itertools

from command import TestCase, golden
from motions import cubes, medit, squares

LEFT, RIGHT, BOTTOM, TOP = 11, 12, 13, 14
PLACES = {LEFT: "x<1e-9", RIGHT: "x>1-1e-9", BOTTOM: "y<1e-9", TOP: "y>1-1e-9"}


def square_cells(n):
    """Points, edges of the sides with their tags, and triangles of n x n squares."""
    points, triangles = squares(n, n, lambda i, j: (i / n, j / n))
    sides = {LEFT: lambda i: (0, i), RIGHT: lambda i: (n, i), BOTTOM: lambda i: (i, 0), TOP: lambda i: (i, n)}
    number = {(i, j): i * (n + 1) + j for i in range(n + 1) for j in range(n + 1)}
    return points, [(number[at(i)], number[at(i + 1)], tag) for i in range(n)
                    for tag, at in sides.items()], triangles


def square(n):
    points, edges, triangles = square_cells(n)
    return medit(points, Edges=edges, Triangles=[(*triangle, 1) for triangle in triangles])


NAMES = {LEFT: "left wall", RIGHT: "outlet", BOTTOM: "7", TOP: "top"}


def named_square(n):
    """The same as a file of Gmsh with the names of its sides."""
    points, edges, triangles = square_cells(n)
    elements = [f"{i} 1 2 {tag} {tag} {a + 1} {b + 1}" for i, (a, b, tag) in enumerate(edges, 1)]
    elements += [f"{i} 2 2 1 1 {a + 1} {b + 1} {c + 1}"
                 for i, (a, b, c) in enumerate(triangles, len(edges) + 1)]
    return "\n".join([
        "$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(NAMES) + 1), '2 1 "plate"',
        *(f'1 {tag} "{name}"' for tag, name in NAMES.items()), "$EndPhysicalNames",
        "$Nodes", str(len(points)), *(f"{i} {x} {y} 0" for i, (x, y) in enumerate(points, 1)), "$EndNodes",
        "$Elements", str(len(elements)), *elements, "$EndElements", ""])


class Conditions(TestCase):
    def setUp(self):
        super().setUp()
        self.square = self.write("square.mesh", square(8))

    def pairs(self, *tags):
        """The same facets by their groups and by their places."""
        return (("--essential-on", *tags),
                ("--essential-where", " + ".join(f"({PLACES[tag]})" for tag in tags)))

    def test_walls_and_open_ends_of_flows_by_groups(self):
        line = ("flow", self.write("square.msh", named_square(6)), "--viscosity", 0.05, "--velocity",
                "1; 0; 0", "--boundary-velocity", "(x<.01)*y*(1-y); 0; 0", "--until", 1, "--keep-groups")
        groups = self.ask(*line, "--no-slip-on", "left wall", "top", BOTTOM, "--open-on", "outlet")
        places = self.ask(*line, "--no-slip-where", f"({PLACES[LEFT]})+({PLACES[TOP]})+({PLACES[BOTTOM]})",
                          "--open-where", PLACES[RIGHT])
        self.assertEqual(groups, places)
        self.assertIn("6 open", groups["conditions"])
        self.assertNotEqual(self.ask(*line, "--no-slip-on", "top", "--open-on", "outlet"), places)
        self.assertSays(self.fail_with(2, *line, "--no-slip-on", "floor"), "group", "1-cells",
                        "floor")

    def test_that_match_no_facet_of_the_boundary_are_refused(self):
        lines = (("poisson", "--side", "primal", "--rhs", 1), ("poisson", "--side", "dual", "--rhs", 1),
                 ("spectrum", "--side", "primal", "--degree", 1),
                 ("heat", "--side", "dual", "--initial", 1, "--until", 1),
                 ("hodge", "--side", "primal", "--degree", 1, "--form", "x; y"))
        inside = square(8).replace(f"Edges\n32\n", "Edges\n33\n41 42 9\n")
        self.assertIn("41 42 9", inside)
        for name, *rest in lines:
            line = (name, self.write("inside.mesh", inside), *rest)
            for where in ("x > 2", "(x>.4)*(x<.6)*(y>.4)*(y<.6)"):
                self.assertSays(self.fail_with(2, *line, "--essential-where", where),
                                "--essential-where", "none", 32)
            self.assertSays(self.fail_with(2, *line, "--essential-on", 9, LEFT), "group 9", "none", 32)
            self.assertSays(self.fail_with(2, *line, "--essential-on", 77), 77)

    def test_values_at_vertices_inside_are_those_of_0_forms(self):
        """u = 1 at the center and 0 at the corners: by rows and columns of the stiffness."""
        corners = "(abs(x*(1-x))<1e-9)*(abs(y*(1-y))<1e-9)"
        center = "(abs(x-.5)<.01)*(abs(y-.5)<.01)"
        line = ("poisson", self.square, "--side", "primal", "--rhs", 0, "--fixed-where",
                f"{corners}+{center}", "--boundary", center)
        answer = self.ask(*line, "-o", "u.vtu")
        self.assertEqual((answer["min"], answer["max"]), (0, 1))
        self.assertSays(answer["conditions"], "no flow", "values given at 5 vertices")
        line = ("spectrum", self.square, "--fixed-where", center, "--count", 2)
        first, second = self.ask(*line, "--side", "primal", "--degree", 0)["eigenvalues"]
        self.assertTrue(.1 < first < second)
        for other in (("--side", "primal", "--degree", 1), ("--side", "dual", "--degree", 0)):
            self.assertSays(self.fail_with(2, *line, *other), "vertices", "primal 0-forms")
        self.assertSays(self.fail_with(2, "poisson", self.square, "--side", "primal", "--rhs", 1,
                                       "--fixed-where", "x>2"), "--fixed-where", "81 vertices")

    def test_files_of_vertices_have_a_number_for_each_vertex_of_the_mesh_file(self):
        """Whether cells use it or not."""
        self.generate("grid", "--nx", 4, "--ny", 4, extension="nsc")
        lines = self.read("grid.nsc").splitlines()
        points, cells = lines[1:26], [[int(v) + 1 for v in line.split()] for line in lines[26:]]
        mesh = self.write("more.nsc", "\n".join(
            ["2 2 26 32", "7 7", *points, *("%d %d %d" % tuple(cell) for cell in cells)]))
        xs = [7, *(float(point.split()[0]) for point in points)]
        run = ("--until", .01, "--frames", 1)
        for words, option, text, function, key in (
                (("poisson", "--rhs", 1), "--fixed-where", "x==.5", lambda x: x == .5, "max"),
                (("heat", "--initial", 1, *run), "--fixed-where", "x==.5", lambda x: x == .5,
                 "relative_norm"),
                (("distance",), "--from-where", "x==.5", lambda x: x == .5, "max"),
                (("flow", *run), "--vorticity", "x^2", lambda x: x * x, "energy"),
                (("flow", "--vorticity", "x^2", *run), "--rotation", "x^3", lambda x: x ** 3,
                 "energy")):
            self.write("f.txt", " ".join(repr(float(function(x))) for x in xs))
            line = (words[0], mesh, *words[1:], option)
            self.assertAlmostEqual(self.ask(*line, "f.txt")[key], self.ask(*line, text)[key],
                                   delta=1e-12)

    def test_groups_of_facets_are_those_at_their_places(self):
        asked = (
            ("poisson", "--rhs", "1+x", "--boundary", "y", "--side", "primal"),
            ("poisson", "--rhs", "1+x", "--boundary", "y", "--side", "dual"),
            ("heat", "--initial", "1+x*y", "--until", 0.1, "--side", "primal"),
            ("heat", "--initial", "y; x*x", "--degree", 1, "--until", 0.1, "--side", "dual"),
            ("hodge", "--form", "y; x*x", "--side", "primal"),
            ("maxwell", "--initial", "y; x*x", "--until", 1))
        for tags in ((LEFT,), (RIGHT, TOP), tuple(PLACES)):
            by_group, by_place = self.pairs(*tags)
            for name, *rest in asked:
                with self.subTest(command=name, tags=tags, rest=rest):
                    one = self.ask(name, self.square, *rest, *by_group)
                    other = self.ask(name, self.square, *rest, *by_place)
                    self.assertEqual(one, other)

    def test_another_group_has_another_solution(self):
        ask = ("poisson", self.square, "--rhs", "1+x", "--side", "primal")
        self.assertNotEqual(self.ask(*ask, "--essential-on", LEFT)["max"],
                            self.ask(*ask, "--essential-on", RIGHT)["max"])

    def test_groups_have_names(self):
        named = self.write("named.msh", named_square(8))
        for tags, names in (((LEFT,), ("left wall",)), ((LEFT, RIGHT), ("outlet", "left wall")),
                            ((BOTTOM,), ("7",)), ((TOP, LEFT), ("top", LEFT))):
            ask = ("--rhs", "1", "--side", "primal", "--essential-on")
            self.assertEqual(self.ask("poisson", named, *ask, *names), self.ask("poisson", named, *ask, *tags))
            self.assertEqual(self.ask("poisson", named, *ask, *names)["max"],
                             self.ask("poisson", self.square, *ask, *tags)["max"])
        for wrong in ("wall", "plate", "left"):
            self.assertSays(self.fail_with(2, "poisson", named, *ask, wrong), "group", "1-cells",
                            wrong, "left wall", "outlet", 7, "top")
        self.assertSays(self.fail_with(2, "poisson", self.square, *ask, "wall"), "name", "number")
        self.assertSays(self.fail_with(2, "info", self.write(
            "named.msh", named_square(2).replace('"plate"', "plate"))),
            f"{named}:6:", "name", "quotes")

    def test_groups_that_are_not_there_are_refused(self):
        self.assertSays(self.fail_with(
            2, "poisson", self.square, "--rhs", "1", "--side", "primal", "--essential-on", 7),
            "facet", "group 7", 11, 12, 13, 14)
        self.assertSays(self.fail_with(
            2, "poisson", golden("grid4.nsc"), "--rhs", "1", "--side", "primal", "--essential-on",
            7), "no facets", "groups")

    def test_data_that_apply_nowhere_are_refused(self):
        poisson = ("poisson", self.square, "--rhs", 1)
        heat = ("heat", self.square, "--initial", 1, "--until", .1)
        for name, where, *line in (
                ("--flux", "--essential-where", *poisson, "--flux", 7),
                ("--boundary", "--essential-where", *poisson, "--robin", 2, "--boundary", 7),
                ("--robin", "--essential-where", *poisson, "--essential-where", 1, "--robin", 1),
                ("--flux", "--essential-where", *heat, "--essential-where", 1, "--flux", 1),
                ("--flux", "--essential-where", *heat, "--side", "dual", "--flux", 1),
                ("--boundary-values", "--essential-where", *heat, "--natural", "--boundary-values", 1),
                ("--robin", "--essential-where", "spectrum", self.square, "--degree", 0,
                 "--essential-where", 1, "--robin", 1)):
            self.assertSays(self.fail_with(2, *line), name, "none", "facets", "expected", where)
        self.succeed(*poisson, "--fixed-where", "abs(x-.5)+abs(y-.5)<.1", "--boundary", 7)
        self.succeed("poisson", golden("uv8.off"), "--rhs", "z", "--flux", 7) # without a boundary

    def test_groups_that_merging_leaves_without_facets_are_told(self):
        """A cube of six tetrahedra, which merge: on each side a triangle is in group 5, the other in 6."""
        corners, solids = cubes(3)
        sides = collections.Counter(side for solid in solids
                                    for side in itertools.combinations(sorted(solid), 3))
        seen, facets = set(), []
        for side in sorted(side for side, count in sides.items() if count == 1):
            plane = next((axis, corners[side[0]][axis]) for axis in range(3)
                         if len({corners[v][axis] for v in side}) == 1)
            facets.append((*side, 6 if plane in seen else 5))
            seen.add(plane)
        mesh = self.write("cube.mesh", medit(corners, Triangles=facets, Tetrahedra=[(*solid, 1) for solid in solids]))
        ask = ("poisson", mesh, "--rhs", 1, "--side", "primal", "--essential-on", 5)
        self.assertSays(self.fail_with(2, *ask), "group 5", "merging", "--keep-groups", "--no-merge")
        self.succeed(*ask, "--no-merge")
        self.assertSays(self.fail_with(2, *ask[:-1], 7, "--no-merge"), "group 7", "5 (6 facets)")

    def test_robin_between_walls_of_given_values(self):
        """-u'' = 0, u(0) = 1, u'(1) + 3 u(1) = 0: u = 1 - 3 x / 4."""
        for side in ("primal", "dual"):
            answer = self.ask("poisson", self.square, "--rhs", "0", "--side", side, "--essential-on", LEFT,
                              "--boundary", "1", "--robin", 3, "--flux",
                              f"({PLACES[BOTTOM]})*3*(1-.75*x)+({PLACES[TOP]})*3*(1-.75*x)",
                              "--exact", "1-.75*x")
            self.assertLess(answer["error"]["l2"], 1e-12 if side == "dual" else 2e-3)
        answer = self.ask("heat", self.square, "--side", "primal", "--initial", "1-.75*x", "--until", .1,
                          "--robin", 3)
        self.assertLess(answer["max"], 0.95)
        self.assertNotEqual(answer["max"], self.ask("heat", self.square, "--side", "primal", "--initial",
                                                    "1-.75*x", "--until", .1, "--robin", 4)["max"])
        some = self.ask("spectrum", self.square, "--side", "dual", "--degree", 0, "--count", 3, "--robin", 3)
        self.assertTrue(some["certificate"]["complete"])
        self.assertGreater(some["eigenvalues"][0], 1)
        self.assertLess(some["eigenvalues"][0], 19) # of held values 2 pi^2
        for bad in (0, -1, "nan"):
            self.fail_with(1, "poisson", self.square, "--rhs", "0", "--side", "dual", "--robin", bad)
