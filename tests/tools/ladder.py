# SPDX-License-Identifier: MIT
"""Families of meshes that are hostile to algorithms: processor seconds grow as the cells do."""
import itertools
import math
import os
import random
import resource

from command import TestCase
from motions import nsc, off, squares

GROWTH = 2.5   # at most, where the number of cells is doubled
LASTING = 0.3  # seconds, below which the start of the program counts
SMALLEST, LARGEST = 20000, 640000  # cells
INFO = ("info",)
VIEW = ("view", "-o", "a.html")
MERGE = ("merge", "-o", "a.vtu")
PRIMAL, DUAL = (("poisson", "--side", side, "--rhs", 1) for side in ("primal", "dual"))


def on_circle(n, digits=17):
    angles = [2 * math.pi * i / n for i in range(n)]
    return [(round(math.cos(a), digits), round(math.sin(a), digits)) for a in angles]


def fan(n):
    points = [(0, 0, 0)] + [(x * (1 + .3 * (i % 3)), y * (1 + .3 * (i % 3)), 0)
                            for i, (x, y) in enumerate(on_circle(n))]
    return off(points, [(0, 1 + i, 1 + (i + 1) % n) for i in range(n)])


def around_edge(n, digits=17):
    return nsc([(0, 0, -1), (0, 0, 1)] + [(x, y, 0) for x, y in on_circle(n, digits)],
               [(0, 1, 2 + i, 2 + (i + 1) % n) for i in range(n)])


def needles(n):
    m = math.isqrt(n // 2)
    return off(*squares(m, m, lambda i, j: (i + .3 * j, j * 1e-4, 0)))


def on_sphere(n):
    """Tetrahedra from one point of a sphere to all triangles of others."""
    m = math.isqrt(n // 2)
    points, number = [], {}

    def at(i, j):
        key = (i, j % m) if 0 < i < m else (i, 0)
        if key not in number:
            number[key] = len(points)
            a, b = math.pi * i / m, 2 * math.pi * (j + .5 * i) / m
            points.append((math.sin(a) * math.cos(b), math.sin(a) * math.sin(b), math.cos(a)))
        return number[key]
    faces = []
    for i, j in itertools.product(range(m), range(m)):
        faces += [face for face in ((at(i, j), at(i + 1, j), at(i + 1, j + 1)),
                                    (at(i, j), at(i + 1, j + 1), at(i, j + 1)))
                  if len(set(face)) == 3]
    return nsc(points, [(0, *face) for face in faces if 0 not in face])


def components(n):
    return off([(i * 3 + d, e, 0) for i in range(n) for d, e in ((0, 0), (1, 0), (0, 1))],
               [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(n)])


def holes(n):
    m = math.isqrt(2 * n // 3)
    return off(*squares(m, m, lambda i, j: (i, j, 0), lambda i, j: i % 2 == 0 or j % 2 == 0))


def star(n):
    """One polygon, no corner of which sees all others."""
    return off([(x * (1 + .5 * (i % 2)), y * (1 + .5 * (i % 2)), 0)
                for i, (x, y) in enumerate(on_circle(n))], [range(n)])


def polygon(n):
    return off([(x, y, 0) for x, y in on_circle(n)], [range(n)])


def strip(n):
    return off(*squares(n // 2, 1, lambda i, j: (i, j * (1 + .2 * math.sin(i)), .1 * math.cos(i))))


def grid(n):
    m = math.isqrt(n // 2)
    return off(*squares(m, m, lambda i, j: (i, j, 0)))


def soup(n):
    """Every triangle with corners of its own, as STL has them."""
    m = math.isqrt(n // 2)
    points, faces = squares(m, m, lambda i, j: (i, j, .01 * i * i))
    corners = ["vertex %g %g %g\n" % point for point in points]
    return "solid soup\n" + "".join(
        "facet normal 0 0 0\nouter loop\n" + "".join(corners[v] for v in face) +
        "endloop\nendfacet\n" for face in faces) + "endsolid\n"


def folded(n):
    """A plane folded like a fan, layer upon layer."""
    m = math.isqrt(n // 2)
    return off(*squares(m, m, lambda i, j: (abs(i % 8 - 4), j, 0)))


def shaken(n):
    m, place = math.isqrt(n // 2), random.Random(5)
    return off(*squares(m, m, lambda i, j: (i + .4 * place.random(), j + .4 * place.random(), 0)))


# On one cell of p edges the automatic star may be Galerkin's, a full matrix of p rows: there it is
# circumcentric ones that solve Poisson problems.
CIRCUMCENTRIC = (*PRIMAL, "--star", "circumcentric")
FAMILIES = (
    (fan, "off", INFO, PRIMAL, DUAL),
    (around_edge, "nsc", INFO, PRIMAL, DUAL),
    (needles, "off", INFO, PRIMAL, DUAL),
    (on_sphere, "nsc", INFO, CIRCUMCENTRIC),
    (components, "off", INFO, PRIMAL, DUAL),
    (holes, "off", INFO, PRIMAL, DUAL),
    (polygon, "off", INFO, CIRCUMCENTRIC),
    (strip, "off", INFO, PRIMAL, DUAL),
    (grid, "off", INFO, MERGE, VIEW, PRIMAL, DUAL),
    (soup, "stl", INFO, PRIMAL),
    (folded, "off", INFO, PRIMAL),
    (shaken, "off", INFO, VIEW, PRIMAL, DUAL),
)


def processor_seconds(run):
    """Of the program that this waits for."""
    def used():
        all_of_them = resource.getrusage(resource.RUSAGE_CHILDREN)
        return all_of_them.ru_utime + all_of_them.ru_stime
    before = used()
    run()
    return used() - before


def worst_growth(seconds, n, runs=5):
    """Of seconds(n), from n to 2 n and from there to 4 n, the first n being one that takes long.
    Of each the least of several runs, or one where that will do: what else runs on the machine
    only adds to it."""
    while seconds(n) < LASTING and 4 * n < LARGEST:
        n *= 2
    least = [seconds(n), seconds(2 * n), seconds(4 * n)]
    for _ in range(runs - 1):
        if max(least[1] / least[0], least[2] / least[1]) < GROWTH:
            break
        least = [min(time, seconds(n << i)) for i, time in enumerate(least)]
    return max(least[1] / least[0], least[2] / least[1]), n, least


class Ladder(TestCase):
    def seconds(self, make, extension, line):
        def of(n):
            name = f"{make.__name__}{n}.{extension}"
            if not os.path.exists(self.path(name)):
                self.write(name, make(n))
            threads = {**os.environ, "OMP_NUM_THREADS": "1"}
            return processor_seconds(
                lambda: self.succeed(line[0], name, *line[1:], "--json", env=threads))
        return of

    def test_processor_seconds_grow_as_the_number_of_cells(self):
        for make, extension, *lines in FAMILIES:
            for line in lines:
                with self.subTest(make.__name__, line=" ".join(map(str, line))):
                    growth, n, least = worst_growth(self.seconds(make, extension, line), SMALLEST)
                    self.assertLess(growth, GROWTH, f"{n} {least}")
            for name in os.listdir(self.folder):
                os.remove(self.path(name))

    def test_a_polygon_that_is_no_fan_is_bounded(self):
        self.write("star.off", star(5000))
        self.assertLess(processor_seconds(lambda: self.succeed("info", "star.off")), 10)
        self.write("star.off", star(5001))
        self.assertSays(self.fail_with(2, "info", "star.off"), "star.off", "5001 corners", "5000")

    def test_what_grows_faster_is_seen(self):
        growth, _, least = worst_growth(lambda n: 1e-3 * n**1.5, 100)
        self.assertGreater(growth, GROWTH)
        self.assertEqual(len(least), 3)
        self.assertLess(worst_growth(lambda n: 1e-3 * n * math.log(n), 100)[0], GROWTH)
