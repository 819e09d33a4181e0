# SPDX-License-Identifier: MIT
"""The pictures of cells, their duals and their merging, for doc_pictures.py."""
import math

from doc_drawing import (BLACK, BLUE, FAN, GREY, LIGHT_BLUE, LIGHT_GREY, LIGHT_ORANGE, ORANGE,
                         RED, Picture, circumcenter, mean, minus, plus, polar)


def chain_of_two_triangles():
    picture = Picture(640, 230)
    corners = [(0, 0), (1, 0), (0, 1), (1, 1)]
    edges = [(0, 1), (0, 2), (1, 2), (1, 3), (2, 3)]
    rim = {(0, 1): 1, (0, 2): -1, (1, 3): 1, (2, 3): -1}
    for x, only_rim in ((60, False), (390, True)):
        picture.frame(x, 190, 150)
        for triangle in ((0, 1, 2), (1, 3, 2)):
            points = [corners[i] for i in triangle]
            picture.polygon(points, LIGHT_BLUE)
            center = mean(*points)
            if not only_rim:
                turn = [plus(center, polar(0.12, a)) for a in range(-60, 215, 5)]
                picture.path(turn, BLUE)
                picture.arrow(turn[-2], plus(turn[-1], minus(turn[-1], turn[-2])), BLUE)
        for a, b in edges:
            if not only_rim:
                picture.orient(corners[a], corners[b])
            elif (a, b) in rim:
                picture.orient(corners[a], corners[b], RED, 3)
                away = minus(mean(corners[a], corners[b]), (0.5, 0.5))
                picture.text(plus(mean(corners[a], corners[b]), away, 0.22),
                             f"{rim[a, b]:+d}".replace("-", "\u2212"), RED, shift=(0, 5))
            else:
                picture.path([corners[a], corners[b]], GREY, 1.5, dash="4 4")
                picture.text(mean(corners[a], corners[b]), "0", GREY, shift=(10, 0))
        for i, p in enumerate(corners):
            picture.dot(p)
            picture.text(p, str(i), shift=(-14 if p[0] == 0 else 14, 5))
    picture.frame(0, 230, 1)
    picture.text((288, 115), "boundary", RED, 15)
    picture.arrow((250, 100), (326, 100), RED)
    return picture.svg("Two oriented triangles and the boundary of their sum")


def dual_cell():
    picture = Picture(760, 300)
    picture.frame(160, 155, 118)
    origin = (0, 0)
    centers = [circumcenter(origin, FAN[i], FAN[(i + 1) % 6]) for i in range(6)]
    picture.polygon(centers, LIGHT_BLUE)
    for i in range(6):
        picture.path([origin, FAN[i]], BLACK, 1.5)
        picture.path([FAN[i], FAN[(i + 1) % 6]], BLACK, 1.5)
        picture.path([centers[i - 1], centers[i]], BLUE, 3)
    for c in centers:
        picture.dot(c, BLUE, 3.5)
    picture.dot(origin)
    for p in FAN:
        picture.dot(p, radius=3)
    picture.text(origin, "v", shift=(-3, -13), style="italic")
    picture.text((0, -1), "*v blue area, *e blue sides", BLUE, shift=(0, 24))

    for x, apex, label in ((370, (1.0, 1.15), "h(s,t) > 0"), (580, (0.85, 0.5), "h(s,t) < 0")):
        picture.frame(x, 200, 85)
        a, b = (0, 0), (1.75, 0)
        center, middle = circumcenter(a, b, apex), mean(a, b)
        picture.polygon([a, b, apex], LIGHT_GREY, BLACK, 1.5)
        picture.path([a, b], BLACK, 3)
        color = BLUE if center[1] > 0 else RED
        picture.arrow(middle, center, color, 2.5)
        picture.dot(center, color, 3.5)
        picture.text(b, "s", shift=(10, 5), style="italic")
        picture.text(apex, "t", shift=(0, -8), style="italic")
        picture.text(center, "c(t)", color, 13, "start", (8, 4))
        picture.text(middle, "c(s)", BLACK, 13, "end", (-6, -6 if center[1] < 0 else 17))
        picture.dot(middle, BLACK, 3)
        picture.text((0.87, 1.75), label, color, 15)
    return picture.svg("The circumcentric dual cell of a vertex, and the signed distance of "
                       "circumcenters")


def pair_kinds():
    """Apex heights over and under the edge from (-1, 0) to (1, 0)."""
    picture = Picture(880, 320)
    kinds = [("well-centered", (0.15, 1.45), (-0.15, -1.3)),
             ("Delaunay", (0.1, 1.75), (-0.3, -0.8)), ("concyclic", None, None),
             ("non-Delaunay", (0.2, 0.75), (-0.2, -0.65))]
    left, right = (-1, 0), (1, 0)
    for i, (name, top, bottom) in enumerate(kinds):
        if top is None:  # two points of one circle through the ends of the edge
            center = (0, 0.3)
            radius = math.hypot(1, 0.3)
            top, bottom = plus(center, polar(radius, 75)), plus(center, polar(radius, 250))
        picture.frame(112 + 218 * i, 150, 64)
        upper, lower = circumcenter(left, right, top), circumcenter(left, bottom, right)
        length = upper[1] - lower[1]
        color = GREY if abs(length) < 1e-9 else BLUE if length > 0 else RED
        picture.polygon([left, bottom, right, top], LIGHT_GREY, BLACK, 1.5)
        if color == GREY:
            picture.circle(upper, math.dist(upper, left))
            picture.path([left, right], BLACK, 1.5, dash="5 4")
        else:
            picture.path([left, right], BLACK, 1.5)
            picture.arrow(lower, upper, color, 3.5)
        for c in {upper, lower}:
            picture.dot(c, color, 4)
        picture.text((0, 0), name, BLACK, 15, shift=(0, 128), weight="bold")
        star = f"{0 if color == GREY else length / 2:.2f}".replace("-", "\u2212")
        picture.text((0, 0), f"star\u2081 = {star}", color, 14, shift=(0, 149))
    return picture.svg("Four kinds of pairs of triangles, with the signed dual edge from the lower "
                       "circumcenter to the upper")


def merged_polygons():
    picture = Picture(760, 250)
    quad = [polar(1, a) for a in (35, 140, 215, 330)]
    hexagon = [polar(1, a) for a in (0, 55, 125, 180, 250, 300)]
    for x, corners, diagonals in ((140, quad, [(0, 2)]), (380, hexagon, [(0, 2), (2, 5), (2, 4)])):
        picture.frame(x, 120, 92)
        picture.polygon(corners, LIGHT_BLUE, BLACK, 2)
        picture.circle((0, 0), 1)
        for a, b in diagonals:
            picture.path([corners[a], corners[b]], RED, 2, dash="6 5")
        picture.dot((0, 0), BLUE)
        for p in corners:
            picture.dot(p, radius=3.5)
        count = len(corners) - 2
        picture.text((0, -1), f"{count} triangles, 1 cell", shift=(0, 30))
    # dual edges through the middle of a grid: those across diagonals have no length
    picture.frame(560, 185, 62)
    for i in range(3):
        picture.path([(i, 0), (i, 2)], BLACK, 2)
        picture.path([(0, i), (2, i)], BLACK, 2)
    for i in range(2):
        for j in range(2):
            picture.path([(i, j), (i + 1, j + 1)], RED, 2, dash="6 5")
    picture.path([(0.5, 0.5), (1.5, 0.5), (1.5, 1.5), (0.5, 1.5)], BLUE, 3, close=True)
    for c in ((0.5, 0.5), (1.5, 0.5), (1.5, 1.5), (0.5, 1.5)):
        picture.dot(c, BLUE)
    picture.text((1, 0), "8 triangles, 4 cells", shift=(0, 27))
    return picture.svg("Concyclic triangles and the merged cells: removed edges dashed, dual edges "
                       "blue")


def solid(p):
    """Where a point of space is seen."""
    x, y, z = p
    return (0.95 * x + 0.42 * y, 0.9 * z + 0.28 * y - 0.12 * x)


def kuhn_cubes():
    picture = Picture(900, 250)
    corners = [(x, y, z) for x in range(3) for y in range(2) for z in range(2)]

    def is_edge(p, q):
        steps = [b - a for a, b in zip(p, q)]
        return p != q and all(0 <= s <= 1 for s in steps) and sum(steps)

    stages = [("12 tetrahedra", 3), ("2 cells, 20 triangles", 2), ("2 cubes, 11 squares", 1)]
    for i, (label, longest) in enumerate(stages):
        picture.frame(35 + 300 * i, 160, 96)
        wall = [solid(p) for p in ((1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1))]
        picture.polygon(wall, LIGHT_BLUE)
        for p in corners:
            for q in corners:
                axes = is_edge(p, q)
                if not axes or axes > longest:
                    continue
                hidden = axes == 1 and p[1] == 1 and (p[2] == 0 or q[2] == 0) and p[0] < 2 or \
                    axes == 1 and p[2] == q[2] == 0 and p[1] < q[1] and p[0] < 2
                color = {1: GREY if hidden else BLACK, 2: ORANGE, 3: RED}[axes]
                picture.path([solid(p), solid(q)], color, 2 if axes == 1 else 1.6,
                             dash={1: "2 4" if hidden else "", 2: "", 3: "6 4"}[axes])
        for p in corners:
            picture.dot(solid(p), radius=2.5)
        picture.text((1.15, 0), label, shift=(0, 62))
        if i < 2:
            picture.arrow((2.5, 0.5), (2.9, 0.5))
            picture.text((2.7, 0.5), f"k = {3 - i}", size=13, shift=(0, -10))
    return picture.svg("Downward merging of two cubes of six tetrahedra each")


def maps():
    picture = Picture(760, 330)
    boxes = {"K": (20, 235), "P": (540, 235), "dK": (20, 55), "dP": (540, 55)}
    words = {"K": ("primal k-forms on K", "simplices"),
             "P": ("primal k-forms on P", "merged cells"),
             "dK": ("dual (n\u2212k)-forms on K", "duals of simplices"),
             "dP": ("dual (n\u2212k)-forms on P", "duals of merged cells")}
    for name, (x, y) in boxes.items():
        picture.polygon([(x, y), (x + 200, y), (x + 200, y + 54), (x, y + 54)],
                        LIGHT_BLUE if name in "KP" else LIGHT_ORANGE, BLACK)
        picture.text((x + 100, y + 32), words[name][0], size=15)
        picture.text((x + 100, y + 12), words[name][1], GREY, 12)
    rows = [(280, False, "dia\u2096   sum over pieces, cochain map", BLUE),
            (259, True, "S\u2096   lift, cochain map", BLUE),
            (238, True, "R\u2096   share by volume, no cochain map", ORANGE),
            (92, False, "R\u2096\u1d40   mean by volume", ORANGE),
            (71, True, "dia\u2096\u1d40   copies, cochain map", BLUE)]
    for y, back, label, color in rows:
        ends = [(225, y), (535, y)]
        picture.arrow(*(reversed(ends) if back else ends), color)
        picture.text((380, y), label, color, 13, shift=(0, -5))
    for x, label, anchor, shift in ((110, "star\u2096 of K", "start", 8),
                                    (640, "star\u2096 of P", "start", 8)):
        picture.arrow((x, 230), (x, 114))
        picture.text((x, 172), label, anchor=anchor, shift=(shift, 5))
    picture.arrow((630, 114), (630, 230), BLUE)
    picture.text((630, 172), "inverse", BLUE, anchor="end", shift=(-8, 5))
    picture.text((380, 20), "an operator O on P, wrapped for K: R O dia", GREY, 13)
    return picture.svg("The maps between forms on simplices and forms on merged cells")
