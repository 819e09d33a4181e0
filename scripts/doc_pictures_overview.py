# SPDX-License-Identifier: MIT
"""The pictures of pages about the whole, and of docs/geodesics.md, for doc_pictures.py."""
import math
import re
from pathlib import Path

from doc_drawing import (BLACK, BLUE, GREY, LIGHT_BLUE, LIGHT_GREY, LIGHT_ORANGE, ORANGE, RED,
                         Picture, plus, polar)


def operators():
    """Forms of a surface on both sides, and what leads from one to the other."""
    picture = Picture(760, 300)
    places = ["vertices", "edges", "cells"]
    width, height, step = 150, 54, 260
    for k in range(3):
        x = 45 + step * k
        for y, fill, side, degree, cells in ((200, LIGHT_BLUE, "primal", k, places[k]),
                                             (50, LIGHT_ORANGE, "dual", 2 - k,
                                              "duals of " + places[k])):
            picture.polygon([(x, y), (x + width, y), (x + width, y + height), (x, y + height)],
                            fill, BLACK)
            picture.text((x + width / 2, y + 32), f"{side} {degree}-forms", size=15)
            picture.text((x + width / 2, y + 12), f"on {cells}", GREY, 12)
        picture.arrow((x + 60, 195), (x + 60, 109))
        picture.text((x + 60, 152), "star", anchor="end", shift=(-8, 5))
        picture.arrow((x + 90, 109), (x + 90, 195), BLUE)
        picture.text((x + 90, 152), "inverse", BLUE, anchor="start", shift=(8, 5))
        if k < 2:
            right, left = x + step, x + width
            picture.arrow((left + 5, 238), (right - 5, 238))
            picture.text(((left + right) / 2, 238), "d", shift=(0, -6))
            picture.arrow((right - 5, 216), (left + 5, 216), ORANGE)
            picture.text(((left + right) / 2, 216), "codifferential", ORANGE, 13, shift=(0, 18))
            picture.arrow((right - 5, 88), (left + 5, 88))
            picture.text(((left + right) / 2, 88), "dual d", shift=(0, -6))
            picture.arrow((left + 5, 66), (right - 5, 66), ORANGE)
            picture.text(((left + right) / 2, 66), "codifferential", ORANGE, 13, shift=(0, 18))
    picture.text((380, 18), "n = 2.  Laplacian: d codifferential + codifferential d, in every box",
                 GREY, 13)
    return picture.svg("Primal and dual forms on a surface, with the derivative, the star, its "
                       "inverse and the codifferential between them")


def arcs_of_torus(picture, radius):
    """The points of the square torus at a distance from its corners, within the square."""
    for center, start in (((0, 0), 0), ((1, 0), 90), ((1, 1), 180), ((0, 1), 270)):
        points = [plus(center, polar(radius, start + 90 * i / 720)) for i in range(721)]
        inside = [p for p in points if abs(p[0] - center[0]) <= 0.5 and
                  abs(p[1] - center[1]) <= 0.5]
        picture.path(inside[::12] + inside[-1:], BLUE, 1.5)


def geodesics():
    """Lines of equal distance on a flat torus, and the frame of a vertex."""
    picture = Picture(760, 320)
    picture.frame(50, 270, 230)
    picture.polygon([(0, 0), (1, 0), (1, 1), (0, 1)], LIGHT_GREY)
    for i in range(1, 7):
        arcs_of_torus(picture, 0.1 * i)
    for a, b, color in (((0, 0), (1, 0), RED), ((0, 1), (1, 1), RED), ((0, 0), (0, 1), ORANGE),
                        ((1, 0), (1, 1), ORANGE)):
        picture.orient(a, b, color, 3)
    picture.path([(0, 0), (1, 1)], GREY, 1, dash="5 5")
    for corner in ((0, 0), (1, 0), (1, 1), (0, 1)):
        picture.dot(corner)
    picture.text((0.5, 0), "lines of equal distance from the one vertex", shift=(0, 36), size=13)

    angles = [44, 70, 52, 60, 66]  # of five triangles; 68 degrees lack to a full turn
    lengths = [1.0, 0.86, 1.0, 0.92, 1.05]
    for x, stretch, label in ((435, 1, "the triangles around a vertex"),
                              (635, 360 / sum(angles), "its frame: angles stretched")):
        picture.frame(x, 165, 80)
        ends = [0.0]
        for angle in angles:
            ends.append(ends[-1] + stretch * angle)
        for i in range(len(angles)):
            a, b = polar(lengths[i], ends[i]), polar(lengths[(i + 1) % 5], ends[i + 1])
            picture.polygon([(0, 0), a, b], LIGHT_BLUE, GREY, 1)
        for i in range(len(angles)):
            picture.path([(0, 0), polar(lengths[i], ends[i])], BLACK, 1.5)
        if stretch == 1:
            picture.path([(0, 0), polar(lengths[0], ends[-1])], BLACK, 1.5, dash="4 4")
            picture.text(polar(0.8, (ends[-1] + 360) / 2), "curvature", RED, 12, shift=(2, 4))
        picture.arrow((0, 0), polar(1.3, 0), RED, 2.5)
        picture.text(polar(1.3, 0), "0", RED, 13, shift=(10, 5))
        picture.dot((0, 0))
        picture.text((0, -1.3), label, shift=(0, 37), size=13)
    return picture.svg("Distance on a square whose opposite sides are glued; the triangles around "
                       "a vertex, and the polar coordinates of its tangent vectors")


def box(picture, corner, size, fill, words, below=""):
    (x, y), (width, height) = corner, size
    picture.polygon([(x, y), (x + width, y), (x + width, y + height), (x, y + height)], fill, BLACK)
    picture.text((x + width / 2, y + height / 2), words, size=15, shift=(0, -2 if below else 5))
    if below:
        picture.text((x + width / 2, y + height / 2), below, GREY, 12, shift=(0, 16))


def trust():
    """The gates between a file and an answer, and what each of them may end in."""
    picture = Picture(760, 210)
    gates = [("read", "bounded, whole"), ("measure", "positive volumes"),
             ("merge", "balls alone"), ("solve", "true residual"), ("certify", "count, radii"),
             ("tell", "whole or nothing")]
    width, step = 105, 124
    for i, (name, what) in enumerate(gates):
        x = 17 + step * i
        box(picture, (x, 120), (width, 60), LIGHT_BLUE, name, what)
        picture.arrow((x + width / 2, 115), (x + width / 2, 72), ORANGE)
        if i + 1 < len(gates):
            picture.arrow((x + width + 2, 150), (x + step - 2, 150))
    box(picture, (17, 25), (step * 5 + width, 44), LIGHT_ORANGE,
        "refused with a reason, or told with a warning: never silent")
    return picture.svg("Six gates between a file and an answer; each may refuse or warn")


def what_is_proved():
    """Widths of enclosures of first Dirichlet eigenvalues, as shape_spectrum gives them, by triangles:
    of 2 pi^2 on the unit square, and of 9.6397 on the L-shape, as it is or bisected for a width."""
    picture = Picture(760, 290)
    square = ((ORANGE, "level 1: order 2", ((128, 5.1e-2), (512, 1.28e-2), (2048, 3.21e-3))),
              (BLUE, "level 2: order 4", ((128, 5.41e-4), (512, 3.28e-5), (2048, 2.07e-6))))
    l_shape = ((ORANGE, "uniform", ((24, 9.3e-2), (96, 1.8e-2), (384, 6.1e-3), (1536, 2.3e-3),
                                    (6144, 9.2e-4))),
               (BLUE, "bisected", ((81, 1.9e-2), (113, 6.4e-3), (244, 1.4e-3), (317, 6.8e-4),
                                   (666, 1.6e-4), (989, 7.3e-5))))
    for left, title, lines in ((60, "the unit square", square),
                               (420, "the L-shape, level 2", l_shape)):
        picture.frame(left, 235, 1)
        for power in range(-6, 0):
            y = (power + 6) * 40
            picture.path([(0, y), (300, y)], LIGHT_GREY, 1)
            picture.text((0, y), f"1e{power}", GREY, 12, "end", (-8, 4))
        for color, name, widths in lines:
            points = [(math.log2(triangles / 16) * 25, (math.log10(width) + 6) * 40)
                      for triangles, width in widths]
            picture.path(points, color, 2.5)
            for point in points:
                picture.dot(point, color)
            picture.text(points[-1], name, color, 13, "start", (8, 4))
        for triangles in (32, 128, 512, 2048):
            picture.text((math.log2(triangles / 16) * 25, 0), str(triangles), GREY, 12, shift=(0, 18))
        picture.text((150, 0), f"triangles of {title}", GREY, 12, shift=(0, 36))
    return picture.svg("Widths of enclosures of first eigenvalues by triangles: of order 2 or 4 on the unit "
                       "square; on the L-shape bisection beats uniform meshes")


def endings():
    """What is left of a result for every way in which the command may end."""
    picture = Picture(760, 210)
    for y, fill, how, left in ((140, LIGHT_BLUE, "code 0", "the new result, whole"),
                               (80, LIGHT_ORANGE, "code 1 .. 4",
                                "the old result or the new, whole; a message"),
                               (20, LIGHT_GREY, "a signal", "the old result or the new, whole")):
        box(picture, (40, y), (160, 48), fill, how)
        picture.arrow((205, y + 24), (345, y + 24))
        box(picture, (350, y), (370, 48), fill, left)
    picture.text((275, 190), "every file is whole", GREY, 12)
    return picture.svg("Endings of the command and what each leaves behind")


def way_of_the_data():
    """The values between a mesh and its pictures, and the rooms that they live in."""
    picture = Picture(760, 240)
    steps = [("Mesh", "meshes/"), ("Passage", "dec/surfaces"), ("Pieces", "complex/"),
             ("Merging", "dec/merging"), ("CellVolumes", "dec/metric"),
             ("HodgeStars", "dec/forms"), ("operators", "dec/forms, fields"),
             ("solvers, pictures", "solvers/, io/")]
    width, height, step = 150, 66, 188
    corners = [(17 + step * (i if i < 4 else 7 - i), 150 if i < 4 else 24) for i in range(8)]
    for i, ((x, y), (name, room)) in enumerate(zip(corners, steps)):
        fill = LIGHT_BLUE if i < 4 else LIGHT_ORANGE if i < 7 else LIGHT_GREY
        box(picture, (x, y), (width, height), fill, name, room)
        if i < 3:
            picture.arrow((x + width + 3, y + height / 2), (x + step - 3, y + height / 2))
        elif i == 3:
            picture.arrow((x + width / 2, y - 3), (x + width / 2, 24 + height + 3))
        elif i < 7:
            picture.arrow((x - 3, y + height / 2), (x + width - step + 3, y + height / 2))
    return picture.svg("From a mesh by passage, pieces, merging, volumes and stars to operators, "
                       "solvers and pictures")


def widths():
    """The table of docs/what-is-proved.md: for each mesh a bar from the least to the greatest width of
    the first ten enclosures, and a dot for the greatest width after bisection."""
    page = (Path(__file__).resolve().parent.parent / "docs" / "what-is-proved.md").read_text()
    rows = []
    for cells in (line.split("|")[1:-1] for line in page.splitlines() if re.match(r"\| .* \.\. ", line)):
        least, most = (float(width) for width in cells[3].split(".."))
        rows.append((cells[0].strip(), least, most, float(cells[6]) if "e-" in cells[6] else None))
    rows.sort(key=lambda row: row[2])
    picture = Picture(760, 60 + 22 * len(rows))
    picture.frame(700, 30 + 22 * len(rows), 60)
    for power in range(-7, 1):
        picture.path([(power, 0), (power, 22 * len(rows) / 60)], LIGHT_GREY, 1)
        picture.text((power, 0), f"1e{power}" if power else "1", GREY, 12, shift=(0, 18))
    for i, (name, least, most, after) in enumerate(rows):
        y = 22 * (len(rows) - i - 0.5) / 60
        picture.text((-8, y), name, BLACK, 12, anchor="end", shift=(20, 4))
        picture.path([(max(-7.5, math.log10(width)), y) for width in (least, most)], BLUE, 6)
        if after is not None:
            picture.dot((math.log10(after), y), RED, 4)
    picture.text((-3.5, 22 * len(rows) / 60), "width of the first ten enclosures: as it is (blue), "
                 "greatest after bisection (red)", BLACK, 13, shift=(0, -10))
    return picture.svg("Widths of enclosures on real meshes, before and after bisection")
