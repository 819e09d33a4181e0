# SPDX-License-Identifier: MIT
"""The pictures of splitting, of merging downwards, of the maps and of joining, for doc_pictures.py."""
from doc_drawing import BLACK, BLUE, GREY, LIGHT_BLUE, LIGHT_ORANGE, ORANGE, RED, Picture, solid


def splitting():
    """Diagonals of one quad, of two that share two edges, and of a cube."""
    picture = Picture(760, 230)
    quad = [(0, 0), (1, -0.45), (2, 0), (1, 0.45)]
    for i, (label, a, b, color) in enumerate((("from the first corner", 0, 2, RED),
                                              ("Delaunay", 1, 3, BLUE))):
        picture.frame(20, 165 - 95 * i, 80)
        picture.polygon(quad, LIGHT_BLUE if i else LIGHT_ORANGE, BLACK, 2)
        picture.path([quad[a], quad[b]], color, 2.5)
        picture.dot(quad[0], radius=4.5)
        picture.text((2, 0), label, color, anchor="start", shift=(12, 5))
    top, left, bottom, right, inner = (0, 1), (-1, 0), (0, -1), (1.2, 0), (0.3, 0)
    picture.frame(440, 110, 78)
    picture.polygon([top, left, bottom, inner], LIGHT_BLUE, BLACK, 2)
    picture.polygon([top, inner, bottom, right], LIGHT_ORANGE, BLACK, 2)
    picture.path([left, inner], BLUE, 2.5)
    picture.path([inner, right], BLUE, 2.5)
    picture.text((0.1, -1), "two quads share two edges", size=13, shift=(0, 32))
    corners = [(x, y, z) for x in range(2) for y in range(2) for z in range(2)]
    picture.frame(580, 150, 105)
    for p in corners:
        for q in corners:
            steps = [b - a for a, b in zip(p, q)]
            if p == q or min(steps) < 0:
                continue
            picture.path([solid(p), solid(q)], {1: BLACK, 2: BLUE, 3: RED}[sum(steps)], 2)
    picture.dot(solid(corners[0]), radius=5)
    picture.text(solid(corners[0]), "0", anchor="end", shift=(-9, 5))
    picture.text((0.68, 0), "cones from the smallest vertex", size=12, shift=(-10, 60))
    return picture.svg("A quad with the diagonal from its first corner and with that of Delaunay; "
                       "two quads that share two edges; a cube split from its smallest vertex")


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


def before_and_after(picture, x, before, after, label):
    """Triangles, each with its color, and dots that stand out, left and right of an arrow."""
    for left, (triangles, dots) in ((x, before), (x + 160, after)):
        picture.frame(left, 150, 110)
        for fill, corners in triangles:
            picture.polygon(corners, fill, BLACK, 1.4)
        for p in {p for _, corners in triangles for p in corners}:
            picture.dot(p, RED if p in dots else BLACK, 4.5 if p in dots else 2.5)
    picture.frame(x, 150, 110)
    picture.arrow((1.13, 0.5), (1.35, 0.5))
    picture.text((1.23, 0), label, shift=(0, 36), size=14)


def joining():
    picture = Picture(960, 210)
    a, b, c, d, top, middle = (0, 0), (1, 0), (1, 1), (0, 1), (0.5, 1), (0.5, 0.5)
    gap = 0.07
    left = [(LIGHT_BLUE, (a, middle, d)), (LIGHT_BLUE, (a, (0.5, 0), middle)),
            (LIGHT_BLUE, (d, middle, top))]
    right = [(LIGHT_ORANGE, (b, c, middle)), (LIGHT_ORANGE, ((0.5, 0), b, middle)),
             (LIGHT_ORANGE, (middle, c, top))]
    seam = [(0.5, 0), middle, top]
    apart = [(fill, tuple((p[0] + gap if p[0] >= 0.5 else p[0], p[1]) for p in corners))
             for fill, corners in right]
    doubled = seam + [(p[0] + gap, p[1]) for p in seam]
    before_and_after(picture, 25, (left + apart, doubled), (left + right, seam),
                     "--weld (drawn apart)")

    small = [(LIGHT_ORANGE, each) for each in (
        (middle, (0.5, 0), (1, 0.5)), ((0.5, 0), b, (1, 0.5)), (top, middle, c),
        (middle, (1, 0.5), c))]
    large = [(LIGHT_BLUE, ((0, 0.5), (0.5, 0), top))]
    split = [(LIGHT_BLUE, ((0, 0.5), (0.5, 0), middle)), (LIGHT_BLUE, ((0, 0.5), middle, top))]
    before_and_after(picture, 345, (large + small, [middle]), (split + small, [middle]),
                     "--join-hanging: cells")

    crossed = [("none", each) for each in ((a, b, c), (a, c, d), (a, b, d), (b, c, d))]
    parts = [(LIGHT_BLUE if i % 2 else LIGHT_ORANGE, each) for i, each in enumerate(
        ((a, b, middle), (b, c, middle), (c, d, middle), (d, a, middle)))]
    before_and_after(picture, 665, (crossed, []), (parts, [middle]),
                     "--join-hanging: facets of two sides")
    picture.frame(665, 150, 110)
    picture.path([a, c], BLUE)
    picture.path([b, d], RED)
    return picture.svg("A seam is welded, a cell is split at a hanging node, and facets of two "
                       "sides are divided where their edges cross")
