# SPDX-License-Identifier: MIT
"""The pictures of docs/cospherical.md that show what cannot be seen from outside of a solid, for
doc_pictures.py: what two cubes share, and cells of four dimensions. The other ones are written by
examples/snippets/cospherical.cpp and the examples 11 to 14.
"""
import itertools

from doc_drawing import (BLACK, BLUE, GREY, LIGHT_BLUE, LIGHT_GREY, RED, Picture, plus, polar,
                         solid)


def cube(picture, left, fills=("#FFFFFF", "#FFFFFF", "#FFFFFF")):
    """The unit cube from x = left on; its front, right and upper side are seen."""
    sides = [[(0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)],
             [(1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1)],
             [(0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]]
    for side, fill in zip(sides, fills):
        picture.polygon([solid((x + left, y, z)) for x, y, z in side], fill, BLACK, 1.6)


def shared_square():
    picture = Picture(860, 225)
    steps = [("cells merged, faces not", True), ("faces merged too", False)]
    for i, (label, split) in enumerate(steps):
        picture.frame(40 + 430 * i, 140, 95)
        cube(picture, 0, (LIGHT_GREY, LIGHT_BLUE, LIGHT_GREY))
        square = [solid(p) for p in ((1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1))]
        if split:
            for corners in (((0, 0, 0), (1, 0, 1)), ((0, 0, 1), (1, 1, 1))):
                picture.path([solid(p) for p in corners], GREY, 1.4, dash="5 4")
            picture.path([square[0], square[2]], RED, 3)
        # the second cube, pulled away; its left side, behind it, is where the square was
        far = 1.75
        cube(picture, far, (LIGHT_GREY, LIGHT_GREY, LIGHT_GREY))
        if split:
            for corners in (((0, 0, 0), (1, 0, 1)), ((0, 0, 1), (1, 1, 1)), ((1, 0, 0), (1, 1, 1))):
                picture.path([solid((p[0] + far, p[1], p[2])) for p in corners], GREY, 1.4,
                             dash="5 4")
        # dual edges leave the middle of the square, or of both its triangles
        a, b = solid((0.5, 0.5, 0.5)), solid((far + 0.5, 0.5, 0.5))
        shift = 0.035 if split else 0
        for way in ((1, -1) if split else (1,)):
            picture.path([plus(p, (0, way * shift)) for p in (a, b)], BLUE, 3)
        for p in (a, b):
            picture.dot(p, BLUE, 4.5)
        picture.text((1.55, 0), label, shift=(0, 62), size=15)
        picture.text((1.55, 0), "2 triangles, 2 equal duals; between them area 0" if split else
                     "1 square, 1 dual", BLUE, 13, shift=(0, 80))
    return picture.svg("The square that two merged cubes share: the diagonal between its two "
                       "triangles has a dual that goes from center to center and back")


def tesseract(picture):
    """A cube in a cube, corner to corner."""
    def at(p):
        x, y, z = ((0.45 if p[3] else 1) * (2 * c - 1) for c in p[:3])
        return (0.92 * x + 0.6 * y, 0.88 * z + 0.36 * y - 0.16 * x)

    corners = list(itertools.product((0, 1), repeat=4))
    for p, q in itertools.combinations(corners, 2):
        axes = [i for i in range(4) if p[i] != q[i]]
        if len(axes) == 1:
            inner = p[3] and q[3]
            color, width = (GREY, 1.2) if axes[0] == 3 else (BLUE if inner else BLACK, 2)
            picture.path([at(p), at(q)], color, width)
    path = [(0, 0, 0, 0), (1, 0, 0, 0), (1, 1, 0, 0), (1, 1, 1, 0), (1, 1, 1, 1)]
    picture.path([at(p) for p in path], RED, 3.5)
    picture.path([at(path[0]), at(path[-1])], RED, 2, dash="6 5")
    for p in corners:
        picture.dot(at(p), radius=3)


def sixteen_cell(picture):
    """Eight corners around a circle; those that are opposite to each other have no edge."""
    corners = [polar(1.25, 22.5 + 45 * i) for i in range(8)]
    for i, j in itertools.combinations(range(8), 2):
        if j - i != 4:
            near = min(j - i, 8 - j + i) == 1
            picture.path([corners[i], corners[j]], BLACK if near else GREY, 2 if near else 1.2)
    picture.path([corners[1], corners[5]], RED, 2.5, dash="6 5")
    for p in corners:
        picture.dot(p, radius=3.5)


def four_dimensions():
    picture = Picture(760, 300)
    picture.frame(190, 130, 72)
    tesseract(picture)
    picture.frame(560, 125, 86)
    sixteen_cell(picture)
    picture.frame(0, 300, 1)
    for x, text, more in ((190, "a tesseract: 24 simplices, 1 cell",
                           "red: the edges of one simplex, and its longest"),
                          (560, "a 16-cell: 8 simplices, 1 cell",
                           "red: the diagonal around which it is split")):
        picture.text((x, 30), text, size=15)
        picture.text((x, 12), more, GREY, 13)
    return picture.svg("A tesseract and a 16-cell, the cospherical cells of four dimensions")
