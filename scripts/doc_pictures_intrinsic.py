#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws the picture of docs/intrinsic.md: a drum in slanted triangles, and the tessellation that
intrinsic flips make of it, whose edges are read from what the command writes.

Usage: doc_pictures_intrinsic.py POLYDEC [FOLDER]; by default docs/images beside the folder of this
script.
"""
import base64
import math
import struct
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from doc_drawing import BLACK, BLUE, RED, Picture

AROUND, ROWS, STEEP = 36, 6, 2
TALL = 2.5
SIDE = 2 * math.sin(math.pi / AROUND)


def drum():
    """Points on the edges of a prism, at heights that are shifted, and triangles that wind around
    it. Each lies in one side of the prism, as in examples/15_distance_on_a_bad_mesh.cpp."""
    points = []
    for i in range(AROUND):
        angle = 2 * math.pi * i / AROUND
        shift = 0.8 * (i * (math.sqrt(5) - 1) / 2 % 1 - 0.5)  # spreads them evenly
        for j in range(ROWS + 1):
            z = (j + shift * (0 < j < ROWS)) * TALL / ROWS
            points.append((math.cos(angle), math.sin(angle), z))
    triangles = []
    for i in range(AROUND):
        left, right = 0, 0
        while left + right < 2 * ROWS:
            a, b = i * (ROWS + 1) + left, (i + 1) % AROUND * (ROWS + 1) + right
            ahead = right < min(left + STEEP, ROWS)
            triangles.append((a, b, b + 1 if ahead else a + 1))
            left, right = left + (not ahead), right + ahead
    return points, triangles


def arrays(path):
    """The arrays of a VTU file by name."""
    formats = {"Float64": "d", "Int32": "i", "Int64": "q", "UInt8": "B"}
    result = {}
    for array in ElementTree.parse(path).iter("DataArray"):
        data = base64.b64decode(array.text)[8:]  # the first 8 bytes say how many follow
        letter = formats[array.get("type")]
        count = len(data) // struct.calcsize(letter)
        result[array.get("Name")] = struct.unpack(f"<{count}{letter}", data)
    return result


def pieces(polydec, points, triangles):
    """The input's triangles cut by the tessellation: points, polygons and the cell of each."""
    with tempfile.TemporaryDirectory() as folder:
        mesh, merged = Path(folder, "drum.obj"), Path(folder, "drum.vtu")
        mesh.write_text("".join("v %.17g %.17g %.17g\n" % p for p in points) +
                        "".join("f %d %d %d\n" % tuple(v + 1 for v in t) for t in triangles))
        subprocess.run([polydec, "merge", mesh, "--delaunay", "-o", merged], check=True,
                       stdout=subprocess.DEVNULL)
        found = arrays(merged)
    numbers = found["Points"]
    ends = found["offsets"]
    polygons = [found["connectivity"][begin:end] for begin, end in zip((0, *ends), ends)]
    return [numbers[i:i + 3] for i in range(0, len(numbers), 3)], polygons, found["cell"]


def sides(polygons):
    """The polygons at every edge, by its ends."""
    result = {}
    for number, polygon in enumerate(polygons):
        for a, b in zip(polygon, (*polygon[1:], polygon[0])):
            result.setdefault((min(a, b), max(a, b)), []).append(number)
    return result


def angle(points, polygon, edge):
    """The angle of a triangle opposite to an edge."""
    apex = points[next(v for v in polygon if v not in edge)]
    u, v = ([p - q for p, q in zip(points[end], apex)] for end in edge)
    product = sum(x * y for x, y in zip(u, v))
    return math.acos(product / (math.hypot(*u) * math.hypot(*v)))


def side_of(points, corners):
    """Which side of the prism has these points."""
    x, y = (sum(points[v][k] for v in corners) for k in (0, 1))
    return math.floor(math.atan2(y, x) % (2 * math.pi) * AROUND / (2 * math.pi) + 1e-9) % AROUND


def seen(p, _side):
    """From the front, which is where y is negative, and somewhat above."""
    return (p[0], 0.97 * p[2] + 0.2 * p[1])


def unrolled(p, side):
    """On the plane, the sides one beside the other."""
    angle = 2 * math.pi * (side + 0.5) / AROUND
    along = p[1] * math.cos(angle) - p[0] * math.sin(angle)
    return ((side - 0.75 * AROUND + 0.5) * SIDE + along, p[2])


def in_front(side):
    return AROUND / 2 <= side < AROUND


def strokes(picture, points, edges, place, color, width):
    """Edges in front as one path, which keeps the file small."""
    lines = []
    for edge, side in sorted(edges):
        a, b = (picture.at(place(points[v], side)) for v in edge)
        lines.append("M %.1f %.1f L %.1f %.1f" % (*a, *b))
    picture.shapes.append(f'<path d="{" ".join(lines)}" fill="none" stroke="{color}" '
                          f'stroke-width="{width}" stroke-linecap="round"/>')


def ground(picture, place):
    """The sides of the prism, and in space the inside of those behind."""
    for side in sorted(range(AROUND), key=in_front):
        rim = [(math.cos(2 * math.pi * i / AROUND), math.sin(2 * math.pi * i / AROUND))
               for i in (side, side + 1)]
        corners = [(*rim[0], 0), (*rim[1], 0), (*rim[1], TALL), (*rim[0], TALL)]
        light = math.cos(2 * math.pi * (side + 0.5) / AROUND - math.radians(235))
        grey = round(226 + 26 * light) if in_front(side) else 178
        fill = f"#{grey:02X}{grey + 2:02X}{min(grey + 3, 255):02X}"
        if in_front(side) or place is seen:
            picture.polygon([place(p, side) for p in corners], fill, fill, 0.6)


def front(points, polygons):
    """The edges of polygons in front, each with the polygons there and a side that has it."""
    found = {}
    for edge, around in sides(polygons).items():
        where = [side_of(points, polygons[p]) for p in around]
        shown = [side for side in where if in_front(side)]
        if shown:
            found[edge] = (around, shown[0])
    return found


def intrinsic_flips(polydec):
    points, triangles = drum()
    cut, polygons, cell = pieces(polydec, points, triangles)
    before, after = front(points, triangles), front(cut, polygons)
    black = [(edge, side) for edge, (_, side) in before.items()]
    red = [(edge, side) for edge, (around, side) in before.items() if len(around) == 2 and
           sum(angle(points, triangles[t], edge) for t in around) > math.pi + 1e-9]
    blue = [(edge, side) for edge, (around, side) in after.items()
            if len(around) == 1 or cell[around[0]] != cell[around[1]]]
    ends = {(v, side) for edge, side in black for v in edge}

    picture = Picture(960, 390)
    for x, place, flipped, words in (
            (130, seen, False, "negative duals in red"),
            (400, seen, True, "after flips"),
            (735, unrolled, True, "unrolled: all edges are straight")):
        picture.frame(x, 340, 118)
        ground(picture, place)
        if flipped:
            strokes(picture, points, black, place, "#A9B0B7", 0.7)
            strokes(picture, cut, blue, place, BLUE, 1.9)
        else:
            strokes(picture, points, black, place, BLACK, 0.9)
            strokes(picture, points, red, place, RED, 1.6)
        for v, side in sorted(ends):
            picture.dot(place(points[v], side), radius=1.8)
        picture.text((0, 0), words, size=15, shift=(0, 42))
    return picture.svg("A drum in slanted triangles, and the edges that intrinsic flips make of "
                       "them: they follow the surface, and are straight where it is unrolled")


def main():
    folder = Path(sys.argv[2]) if len(sys.argv) > 2 else \
        Path(__file__).resolve().parent.parent / "docs" / "images"
    (folder / "intrinsic_flips.svg").write_text(intrinsic_flips(sys.argv[1]))


if __name__ == "__main__":
    main()
