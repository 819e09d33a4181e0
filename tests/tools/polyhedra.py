# SPDX-License-Identifier: MIT
"""Polyhedra of .vtu files: two readers, ours and meshio where it can be had, and the laws that a
cell has to obey."""
import base64
import collections
import itertools
import json
import math
import os
import struct
import sys
import xml.etree.ElementTree

import command

NUMBERS = {"Float64": "d", "Float32": "f", "Int64": "q", "Int32": "i", "UInt8": "B"}
POLYHEDRON = 42
# of cells without faces of their own: the type by the number of corners, more of which make a polygon
FLAT = {2: 3, 3: 5, 4: 9}
POLYGON = 7
SOLIDS = {10: ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)),
          12: ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))}
ROUNDING = 1e-12

# what a file holds: of each cell its faces, of each face its corners in order
Grid = collections.namedtuple("Grid", "points cells")

MESHIO = """
import json, sys, meshio
mesh = meshio.read(sys.argv[1])
json.dump([mesh.points.tolist(), [[block.type, [
    [list(map(int, face)) for face in cell] if block.type.startswith("polyhedron")
    else [list(map(int, cell))] for cell in block.data]] for block in mesh.cells]], sys.stdout)
"""


# Readers

class Broken(Exception):
    """A file against the rules of VTK."""


def require(condition, text):
    if not condition:
        raise Broken(text)


def array_of(element):
    """The numbers of a DataArray."""
    kind = NUMBERS[element.get("type")]
    if element.get("format") == "ascii":
        return [(float if kind == "d" else int)(word) for word in (element.text or "").split()]
    data = base64.b64decode(element.text.strip(), validate=True)
    size, = struct.unpack_from("<Q", data)
    require(size == len(data) - 8 and size % struct.calcsize(kind) == 0, "size of an array")
    return list(struct.unpack_from(f"<{size // struct.calcsize(kind)}{kind}", data, 8))


def pieces(values, ends, what):
    """The values cut where the ends say, which have to cover all of them."""
    require(all(a < b for a, b in itertools.pairwise([0, *ends])), f"{what} do not ascend")
    require((ends[-1] if ends else 0) == len(values), f"{what} do not end with the array")
    return [values[a:b] for a, b in itertools.pairwise([0, *ends])]


def faces_of(stream):
    """The faces of one polyhedron from VTK's stream: their number, then number and corners of
    each."""
    faces, place = [], 1
    for _ in range(stream[0]):
        require(place < len(stream), "a polyhedron with fewer faces than promised")
        faces.append(stream[place + 1:place + 1 + stream[place]])
        place += 1 + stream[place]
    require(place == len(stream), "a polyhedron with more numbers than its faces take")
    return faces


def cell_of(kind, corners):
    """The faces of a cell of a type with a fixed number of corners, or of a polygon."""
    if kind in SOLIDS:
        require(sorted(set(itertools.chain(*SOLIDS[kind]))) == list(range(len(corners))),
                f"{len(corners)} corners of a cell of type {kind}")
        return [[corners[i] for i in face] for face in SOLIDS[kind]]
    require(kind == FLAT.get(len(corners), POLYGON),
            f"type {kind} of a cell with {len(corners)} corners")
    return [corners]


def read_alone(path):
    """Checks the rules of VTK's format on the way. Throws Broken."""
    root = xml.etree.ElementTree.parse(path).getroot()
    require(root.get("type") == "UnstructuredGrid" and root.get("compressor") is None, "kind")
    require((root.get("byte_order"), root.get("header_type")) == ("LittleEndian", "UInt64"), "head")
    piece = root.find("UnstructuredGrid/Piece")
    arrays = {array.get("Name"): array_of(array) for array in piece.iterfind("Cells/DataArray")}
    flat = array_of(piece.find("Points/DataArray"))
    points = [tuple(flat[i:i + 3]) for i in range(0, len(flat), 3)]
    corners = pieces(arrays["connectivity"], arrays["offsets"], "offsets")
    require((len(points), len(corners), len(arrays["types"])) ==
            (int(piece.get("NumberOfPoints")), int(piece.get("NumberOfCells")), len(corners)),
            "numbers of points or cells")
    if POLYHEDRON not in arrays["types"]:
        require("faces" not in arrays and "faceoffsets" not in arrays, "faces of no polyhedra")
        return Grid(points, [cell_of(kind, cell) for kind, cell in zip(arrays["types"], corners)])
    require(set(arrays["types"]) == {POLYHEDRON}, "polyhedra mixed with others")
    cells = [faces_of(stream)
             for stream in pieces(arrays["faces"], arrays["faceoffsets"], "faceoffsets")]
    require(len(cells) == len(corners), "cells without faces")
    for faces, own in zip(cells, corners):
        require(sorted(own) == sorted(set(itertools.chain(*faces))),
                "the connectivity of a polyhedron is not the list of its points")
    return Grid(points, cells)


def find_python(module):
    """A Python that has the module, or None."""
    for interpreter in (sys.executable, "/usr/bin/python3"):
        if os.path.exists(interpreter) and command.run_program(
                [interpreter, "-c", f"import {module}"]).code == 0:
            return interpreter
    return None


def read_with_meshio(path):
    """meshio gathers polyhedra by their number of points. Throws Broken."""
    done = command.run_program([INTERPRETER, "-c", MESHIO, path])
    require(done.code == 0, done.err)
    points, blocks = json.loads(done.out)
    for kind, cells in blocks:
        for faces in cells:
            size = len(set(itertools.chain(*faces)))
            require(kind in (f"polyhedron{size}", f"polygon{size}", "polygon", "line", "triangle",
                             "quad", "tetra", "hexahedron"), f"{kind} of {size} points")
    number = {"tetra": 10, "hexahedron": 12}
    return Grid([tuple(point) for point in points], [
        cell_of(number[kind], *c) if kind in number else c for kind, cells in blocks for c in cells])


INTERPRETER = find_python("meshio")
READERS = [read_alone] + [read_with_meshio] * (INTERPRETER is not None)


# Laws

def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return math.fsum(x * y for x, y in zip(a, b))


def area_vector(points, face):
    """Half the sum of the triangles' cross products: area times normal."""
    first = points[face[0]]
    fans = [cross(minus(points[a], first), minus(points[b], first))
            for a, b in itertools.pairwise(face[1:])]
    return tuple(math.fsum(parts) / 2 for parts in zip(*fans))


def volume(points, faces):
    """By the divergence theorem: a third of the sum of x . normal over the faces."""
    origin = points[faces[0][0]]
    return math.fsum(dot(minus(points[face[0]], origin), area_vector(points, face))
                     for face in faces) / 3


def bend(points, face):
    """How far the corners lie from the face's plane, over its diameter."""
    normal = area_vector(points, face)
    size = max(math.dist(points[a], points[b]) for a in face for b in face)
    area = math.hypot(*normal)
    if area == 0:
        return math.inf
    return max(abs(dot(minus(points[p], points[face[0]]), normal)) for p in face) / (area * size)


def directed_edges(faces):
    return collections.Counter((face[i - 1], face[i]) for face in faces for i in range(len(face)))


def flaws(points, faces):
    """What keeps a cell from being a polyhedron as VTK wants it: closed, of one piece like a ball,
    planar faces, all of them turned outward."""
    found = []
    if any(len(set(face)) < max(3, len(face)) for face in faces):
        return ["a face with too few or repeated corners"]
    runs = directed_edges(faces)
    both = collections.Counter()
    for (a, b), times in runs.items():
        both[min(a, b), max(a, b)] += times
    if any(times != 2 for times in both.values()):
        found.append("an edge that is not in two faces")
    if any(times != 1 or runs[b, a] != 1 for (a, b), times in list(runs.items())):
        found.append("two faces that run along an edge in the same direction")
    if len(set(itertools.chain(*faces))) - len(both) + len(faces) != 2:
        found.append("not Euler's number of a sphere")
    if max(bend(points, face) for face in faces) > ROUNDING:
        found.append("a face that is not planar")
    if not found and volume(points, faces) <= 0:
        found.append("the faces are turned inward")
    return found


def turned(face):
    """A face as a cycle that starts with its smallest corner."""
    start = face.index(min(face))
    return tuple(face[start:] + face[:start])


def unmatched_faces(cells):
    """Faces that two cells have in the same direction, or that are in three."""
    times = collections.Counter(turned(face) for faces in cells for face in faces)
    return [face for face, count in times.items() if count > 1]


def count_faces(cells):
    return len({frozenset(face) for faces in cells for face in faces})


def vertices_of(faces):
    return tuple(sorted(set(itertools.chain(*faces))))


def differences(grid, wanted):
    """Cells whose volume by the divergence theorem is not the wanted one; {vertices: volume}."""
    found = {vertices_of(faces): volume(grid.points, faces) for faces in grid.cells}
    if len(found) != len(wanted) or set(found) != set(wanted):
        return ["the cells"]
    largest = max(wanted.values())
    return [cell for cell, value in wanted.items() if abs(found[cell] - value) > ROUNDING * largest]


def write_plain(path, grid):
    """A file of polyhedra in text, with whatever flaws they have."""
    corners = [vertices_of(faces) for faces in grid.cells]
    streams = [[len(faces), *itertools.chain(*([len(f), *f] for f in faces))]
               for faces in grid.cells]

    def array(kind, name, values, more=""):
        text = " ".join(map(repr, values))
        return f'<DataArray type="{kind}" Name="{name}"{more} format="ascii">{text}</DataArray>\n'

    def ends(lists):
        return itertools.accumulate(map(len, lists))

    with open(path, "w", encoding="ascii") as file:
        file.write('<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" '
                   'header_type="UInt64"><UnstructuredGrid>\n'
                   f'<Piece NumberOfPoints="{len(grid.points)}" NumberOfCells="{len(corners)}">\n'
                   "<Points>" + array("Float64", "Points", itertools.chain(*grid.points),
                                      ' NumberOfComponents="3"') + "</Points>\n<Cells>"
                   + array("Int32", "connectivity", itertools.chain(*corners))
                   + array("Int64", "offsets", ends(corners))
                   + array("UInt8", "types", [POLYHEDRON] * len(corners))
                   + array("Int32", "faces", itertools.chain(*streams))
                   + array("Int64", "faceoffsets", ends(streams))
                   + "</Cells></Piece></UnstructuredGrid></VTKFile>\n")
