#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws pictures of docs/ as SVG: every coordinate is computed, circumcenters too. Those of cells and
their duals are drawn by polydec itself, in examples/snippets/drawings.cpp.

Usage: doc_pictures.py [FOLDER]; by default docs/images beside the folder of this script.
"""
import sys
from pathlib import Path

import doc_pictures_cells as cells
import doc_pictures_overview as overview
import doc_pictures_solids as solids
from doc_drawing import (BLACK, BLUE, FAN, GREY, LIGHT_BLUE, LIGHT_GREY, LIGHT_ORANGE, RED,
                         Picture, circumcenter, cross, mean, minus, plus, polar, unit)


def whitney_and_integrals():
    picture = Picture(760, 260)
    triangle = [(0, 0), (1.9, 0.1), (0.75, 1.75)]
    picture.frame(30, 220, 112)
    edge = [triangle[0], triangle[1]]
    picture.polygon(triangle, LIGHT_GREY, BLACK, 1.5)
    picture.orient(*edge, RED, 3)
    for t in (0.1, 0.37, 0.63, 0.9):
        p = plus(edge[0], minus(edge[1], edge[0]), t)
        picture.arrow(p, plus(p, (0.16, 0.1 + 0.26 * t)), BLUE)
    picture.text(mean(*edge), "w(e) = integral of w along e", RED, 13, shift=(0, 22))

    center = circumcenter(*triangle)
    other = (2.35, 1.75)
    second = circumcenter(triangle[1], other, triangle[2])
    picture.frame(270, 220, 90)
    picture.polygon([*triangle[:2], other, triangle[2]], LIGHT_GREY, BLACK, 1.5)
    picture.path(triangle[1:], BLACK, 2.5)
    picture.arrow(center, second, RED, 3)
    for p in (center, second):
        picture.dot(p, RED)
    picture.text((1.2, 0), "w(*e): along the dual edge", RED, 13, shift=(0, 22))

    picture.frame(530, 220, 112)
    picture.polygon(triangle, LIGHT_GREY, BLACK, 1.5)
    picture.path(edge, RED, 3)
    double = cross(minus(triangle[1], triangle[0]), minus(triangle[2], triangle[0]))

    def gradient(i):
        side = minus(triangle[(i + 2) % 3], triangle[(i + 1) % 3])
        return (-side[1] / double, side[0] / double)

    for i in range(1, 8):
        for j in range(1, 8 - i):
            b = (1 - (i + j) / 8, i / 8, j / 8)
            p = mean(*[(3 * b[k] * q[0], 3 * b[k] * q[1]) for k, q in enumerate(triangle)])
            w = plus(tuple(b[0] * x for x in gradient(1)), gradient(0), -b[1])
            picture.arrow(p, plus(p, w, 0.3), BLUE, 1.5, head=6)
    picture.text(mean(*edge), "the Whitney form of one edge", RED, 13, shift=(0, 22))
    return picture.svg("The integral of a form along an edge, along a dual edge, and the Whitney "
                       "form of an edge")


def wedge():
    picture = Picture(760, 270)
    picture.frame(40, 210, 105)
    triangle = [(0, 0), (1.9, 0.1), (0.8, 1.6)]
    picture.polygon(triangle, LIGHT_GREY, BLACK, 1.5)
    for i, p in enumerate(triangle):
        ends = [triangle[(i + k) % 3] for k in (1, 2)]
        for q, color in zip(ends, (BLUE, RED)):
            start = plus(p, unit(minus(mean(*triangle), p)), 0.16)
            picture.arrow(start, plus(start, unit(minus(q, p)), 0.42), color)
        picture.dot(p)
    picture.text((0.95, 0), "at each corner: a times b \u2212 b times a", shift=(0, 25), size=13)
    picture.text((0.95, 0), "sum / 6", shift=(0, 43), size=13)
    picture.text((0.55, 0.38), "a", BLUE, shift=(2, 14))
    picture.text((0.1, 0.55), "b", RED, shift=(12, 0))

    pentagon = [polar(1, a) for a in (90, 168, 230, 300, 20)]
    for x, filled in ((420, False), (640, True)):
        picture.frame(x, 120, 88)
        picture.polygon(pentagon, LIGHT_BLUE)
        for i, p in enumerate(pentagon):
            picture.orient(p, pentagon[(i + 1) % 5], BLACK)
            picture.text(plus(mean(p, pentagon[(i + 1) % 5]),
                              unit(mean(p, pentagon[(i + 1) % 5])), 0.17), f"a{i}", size=13,
                         shift=(0, 5))
        for a, b in ((1, 3), (1, 4)):
            if filled:
                picture.orient(pentagon[a], pentagon[b], BLUE)
            else:
                picture.path([pentagon[a], pentagon[b]], GREY, 1.5, dash="5 4")
        picture.text((0, -1), "lifted: Stokes in each triangle" if filled else "values on the rim",
                     BLUE if filled else BLACK, 13, shift=(0, 40))
    picture.frame(0, 270, 1)
    picture.arrow((512, 150), (552, 150), BLUE)
    picture.text((532, 160), "S", BLUE)
    return picture.svg("The wedge of two 1-forms on a triangle, and the lift on a merged pentagon")


def upwind():
    picture = Picture(640, 270)
    wind = (0.62, 0.2)
    for x, all_of_them in ((150, True), (470, False)):
        picture.frame(x, 130, 100)
        for i in range(6):
            a, b = FAN[i], FAN[(i + 1) % 6]
            back = (-wind[0], -wind[1])
            hit = cross(a, back) >= 0 and cross(back, b) >= 0
            picture.polygon([(0, 0), a, b], LIGHT_BLUE if all_of_them or hit else "#FFFFFF", BLACK,
                            1.5)
        picture.arrow((0, 0), wind, RED, 3.5)
        if not all_of_them:
            picture.path([(0, 0), (-wind[0], -wind[1])], RED, 2, dash="5 4")
        picture.dot((0, 0))
        picture.text(wind, "X", RED, shift=(10, -4), style="italic")
        picture.text((0, -1), "centered: all, by volume" if all_of_them else
                     "upwind: the one that \u2212X points into", shift=(0, 33))
    return picture.svg("From which triangles the interior product takes a form")


def flats():
    picture = Picture(800, 500)
    v, w, left, right = (0, -0.8), (0, 0.8), (-1.15, 0.15), (1.25, -0.1)
    a, b = circumcenter(v, w, left), circumcenter(v, right, w)
    at_vertices = {v: (0.3, 0.22), w: (0.42, 0.1), left: (0.25, 0.2), right: (0.4, 0.05)}
    at_cells = {a: (0.28, 0.18), b: (0.42, 0.1)}
    kites = [[v, mean(v, left), a, (0, 0), b, mean(v, right)],
             [w, mean(w, right), b, (0, 0), a, mean(w, left)]]
    triangles = [[v, w, left], [v, right, w]]
    notes = {"p": "linear on triangles", "c": "constant on cells", "d": "constant on dual cells"}
    for i, kind in enumerate(("ppp", "pdp", "dpp", "ppd", "pdd", "dpd")):
        picture.frame(135 + 265 * (i % 3), 110 + 245 * (i // 3), 88)
        if kind[1] == "d":
            for t in triangles:
                picture.polygon(t, "#FFFFFF", BLACK, 1.5)
            for kite, fill in zip(kites, (LIGHT_ORANGE, LIGHT_BLUE)):
                picture.polygon(kite, fill)
        else:
            fills = (LIGHT_ORANGE, LIGHT_BLUE) if kind[0] == "d" else (LIGHT_BLUE, LIGHT_BLUE)
            for t, fill in zip(triangles, fills):
                picture.polygon(t, fill)
        for t in triangles:
            picture.path(t, BLACK, 1.5, close=True)
        picture.path(*(([v, w], RED, 4) if kind[2] == "p" else ([a, b], RED, 4)))
        if kind[2] == "p":
            picture.path([a, b], GREY, 1.5, dash="3 4")
        for p, X in (at_cells if kind[0] == "d" else at_vertices).items():
            picture.arrow(p, plus(p, X), BLUE, 2.5)
            picture.dot(p, BLUE, 3.5)
        note = notes["c" if kind == "dpp" or kind == "dpd" else kind[1]]
        picture.text((0, -1), kind, BLACK, 16, shift=(0, 15), weight="bold")
        picture.text((0, -1), note, GREY, 12.5, shift=(0, 33))
    return picture.svg("The six flats: blue where the vectors are, red where the 1-form lives")


def ring():
    picture = Picture(720, 330)
    around = 16
    for x, dual in ((175, False), (545, True)):
        picture.frame(x, 150, 68)
        for i in range(around):
            a, b = 360 / around * i, 360 / around * (i + 1)
            for r in (1.0, 1.5):
                picture.polygon([polar(r, a), polar(r, b), polar(r + 0.5, b), polar(r + 0.5, a)],
                                LIGHT_GREY, GREY, 1)
        for i in range(around):
            angle = 360 / around * (i + 0.5)
            for r in (1.25, 1.75):
                p = polar(r, angle)
                direction = polar(0.5 / r, angle if dual else angle + 90)
                picture.arrow(plus(p, direction, -0.5), plus(p, direction, 0.5), BLUE, 2, head=7)
        if dual:
            picture.path([polar(1, 45), polar(2, 45)], RED, 4)
            picture.text((0, -2), "relative: the generator is an arc", shift=(0, 30), size=14)
        else:
            loop = [polar(1.5, 360 / around * i) for i in range(around)]
            picture.path(loop, RED, 4, close=True)
            picture.text((0, -2), "absolute: the generator is a loop", shift=(0, 30), size=14)
    return picture.svg("A ring, the generator of its homology in red and the harmonic field in "
                       "blue, absolute and relative to the boundary")


PICTURES = {
    "splitting": cells.splitting,
    "kuhn_cubes": cells.kuhn_cubes,
    "maps": cells.maps,
    "joining": cells.joining,
    "shared_square": solids.shared_square,
    "four_dimensions": solids.four_dimensions,
    "integrals": whitney_and_integrals,
    "wedge": wedge,
    "upwind": upwind,
    "flats": flats,
    "ring": ring,
    "operators": overview.operators,
    "geodesics": overview.geodesics,
    "trust": overview.trust,
    "what-is-proved": overview.what_is_proved,
    "widths": overview.widths,
    "endings": overview.endings,
    "way_of_the_data": overview.way_of_the_data,
}


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else \
        Path(__file__).resolve().parent.parent / "docs" / "images"
    for name, draw in PICTURES.items():
        (folder / f"{name}.svg").write_text(draw())


if __name__ == "__main__":
    main()
