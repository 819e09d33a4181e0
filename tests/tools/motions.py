# SPDX-License-Identifier: MIT
"""Meshes as points and cells, as text, and what else they can be given as."""
import itertools
import math

POWERS = [10, 20, 30, 40, 100]


def determinant(rows):
    """Of a matrix without zero pivots, or 0."""
    rows, result = [list(row) for row in rows], 1.0
    for i in range(len(rows)):
        best = max(range(i, len(rows)), key=lambda j: abs(rows[j][i]))
        if rows[best][i] == 0:
            return 0.0
        if best != i:
            rows[i], rows[best], result = rows[best], rows[i], -result
        result *= rows[i][i]
        for row in rows[i + 1:]:
            part = row[i] / rows[i][i]
            row[:] = [x - part * y for x, y in zip(row, rows[i])]
    return result


def off(points, cells):
    """The text of polygons in space."""
    return "".join([f"OFF\n{len(points)} {len(cells)} 0\n",
                    *(" ".join(map(repr, point)) + "\n" for point in points),
                    *(f"{len(cell)} {' '.join(map(str, cell))}\n" for cell in cells)])


def nsc(points, cells):
    """The text of simplices."""
    rows = [[len(points[0]), len(cells[0]) - 1, len(points), len(cells)], *points, *cells]
    return "".join(" ".join(map(repr, row)) + "\n" for row in rows)


def medit(points, **sections):
    """The text of points and of cells, each with its tag behind its corners."""
    rows = {"Vertices": [(*point, 0) for point in points],
            **{name: [(*(v + 1 for v in cell), tag) for *cell, tag in cells]
               for name, cells in sections.items()}}
    return "".join([f"MeshVersionFormatted 2\nDimension {len(points[0])}\n",
                    *(f"{name}\n{len(lines)}\n" + "".join(" ".join(map(str, line)) + "\n"
                                                         for line in lines)
                      for name, lines in rows.items()), "End\n"])


def vtu(points, cells, cell_data=None, **point_data):
    """The text of points, edges and triangles, with a number or a vector for each point or cell."""
    def array(kind, name, values):
        rows = [value if isinstance(value, tuple) else (value,) for value in values]
        return (f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{len(rows[0])}" '
                f'format="ascii">{" ".join(str(x) for row in rows for x in row)}</DataArray>')

    def data(part, arrays):
        return f"<{part}>" + "".join(array("Float64", *each) for each in arrays.items()) + f"</{part}>"

    return ('<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian"><UnstructuredGrid>'
            f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(cells)}">'
            + data("Points", {"Points": points}) + "<Cells>"
            + array("Int32", "connectivity", itertools.chain(*cells))
            + array("Int32", "offsets", itertools.accumulate(map(len, cells)))
            + array("UInt8", "types", ((1, 3, 5)[len(cell) - 1] for cell in cells)) + "</Cells>"
            + data("PointData", point_data) + data("CellData", cell_data or {})
            + "</Piece></UnstructuredGrid></VTKFile>")


def pvd(files):
    """The text of a series of {time: file}."""
    steps = "".join(f'<DataSet timestep="{time}" file="{file}"/>' for time, file in files.items())
    return f'<VTKFile type="Collection"><Collection>{steps}</Collection></VTKFile>'


def squares(columns, rows, place, keep=lambda i, j: True):
    """Points and triangles of the squares that are kept, two for each: place(i, j) of each corner,
    in the order of (i, j)."""
    kept = [(i, j) for i, j in itertools.product(range(columns), range(rows)) if keep(i, j)]
    corners = sorted({(i + a, j + b) for i, j in kept for a in (0, 1) for b in (0, 1)})
    number = {corner: v for v, corner in enumerate(corners)}
    faces = []
    for i, j in kept:
        a, b, c, d = (number[at] for at in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
        faces += [(a, b, c), (a, c, d)]
    return [place(i, j) for i, j in corners], faces


def cubes(n, side=1):
    """Corners and simplices of side^n unit n-cubes, each split at its diagonal."""
    corners = list(itertools.product(range(side + 1), repeat=n))
    number = {corner: i for i, corner in enumerate(corners)}
    cells = []
    for corner in itertools.product(range(side), repeat=n):
        for order in itertools.permutations(range(n)):
            at = list(corner)
            cell = [number[corner]]
            for axis in order:
                at[axis] += 1
                cell.append(number[tuple(at)])
            cells.append(cell)
    return corners, cells


class Mesh:
    """Points and cells of a mesh of n-simplices in N coordinates."""

    def __init__(self, points, cells):
        self.points, self.cells = points, cells
        self.N, self.n = len(points[0]), len(cells[0]) - 1

    @classmethod
    def of_text(cls, text):
        rows = [line.split() for line in text.splitlines() if line]
        vertices = int(rows[0][2])
        return cls([list(map(float, row)) for row in rows[1:vertices + 1]],
                   [list(map(int, row)) for row in rows[vertices + 1:]])

    @classmethod
    def read(cls, path):
        with open(path, encoding="ascii") as file:
            return cls.of_text(file.read())

    def times(self, size):
        return Mesh([[size * x for x in point] for point in self.points], self.cells)

    def oriented(self):
        """With cells oriented as space is, where they fill it: an order of cells that are oriented
        differently would make a difference."""
        if self.n == self.N:
            for cell in self.cells:
                first, *others = (self.points[v] for v in cell)
                if determinant([[x - y for x, y in zip(p, first)] for p in others]) < 0:
                    cell[:2] = cell[1::-1]
        return self

    def text(self):
        return nsc(self.points, self.cells)


class Motion:
    """What a mesh is given as in another way, and what becomes of expressions and forms then.

    Coordinate axes[j] of the mesh, times signs[j] and the scale, becomes coordinate j; where that
    is None, the constant signs[j] does."""

    def __init__(self, mesh, draw=None):
        self.axes, self.signs, self.scale = list(range(mesh.N)), [1] * mesh.N, 1.0
        self.vertices = list(range(len(mesh.points)))
        self.cells = list(range(len(mesh.cells)))
        self.corners = list(range(mesh.n + 1))
        self.name = "rest"
        if draw is not None:
            self.move(mesh, draw)

    def move(self, mesh, draw):
        self.name = draw.choice(["numbers", "reflection", "axes", "scale", "coordinate"])
        if self.name == "numbers":
            for each in (self.vertices, self.cells):
                draw.shuffle(each)
            turns = draw.randrange(mesh.n + 1) # an odd permutation would turn the cells over
            if mesh.n % 2 == 0:
                self.corners = self.corners[turns:] + self.corners[:turns]
        elif self.name == "reflection":
            self.signs = [draw.choice([-1, 1]) for _ in self.axes]
        elif self.name == "axes":
            draw.shuffle(self.axes)
        elif self.name == "scale":
            self.scale = 2.0**(draw.choice([-1, 1]) * draw.choice(POWERS))
        else:
            at = draw.randrange(mesh.N + 1)
            self.axes.insert(at, None)
            self.signs.insert(at, draw.choice([0, 0, 1, -3.7]))

    def __str__(self):
        return f"{self.name} {self.axes} {self.signs} {self.scale}"

    def mesh(self, mesh):
        points = [None] * len(mesh.points)
        for v, point in enumerate(mesh.points):
            points[self.vertices[v]] = [
                sign if axis is None else sign * point[axis] * self.scale
                for axis, sign in zip(self.axes, self.signs)]
        cells = [[self.vertices[mesh.cells[c][i]] for i in self.corners] for c in self.cells]
        return Mesh(points, cells)

    def reaches(self, axis):
        """Whether expressions can name this coordinate."""
        return axis < 3 and axis in self.axes[:3]

    def expression(self, template):
        """The value of an expression in the coordinates {0}, {1}, .. of the mesh."""
        names = {}
        for j, (axis, sign) in enumerate(zip(self.axes, self.signs)):
            if axis is not None and j < 3:
                names[axis] = f"({sign}*{'xyz'[j]}/{self.scale!r})"
        return template.format(*(names.get(axis) for axis in range(max(names) + 1)))

    def form(self, templates, degree):
        """The coefficients of the form whose values on cells are scale^0 times those."""
        old = {chosen: template for chosen, template in zip(
            itertools.combinations(range(len(self.axes) - (None in self.axes)), degree), templates)}
        result = []
        for chosen in itertools.combinations(range(len(self.axes)), degree):
            axes = [self.axes[j] for j in chosen]
            if None in axes:
                result.append("0")
                continue
            turned = sum(a > b for a, b in itertools.combinations(axes, 2)) % 2
            factor = math.prod(self.signs[j] for j in chosen) * (-1)**turned / self.scale**degree
            result.append(f"{factor!r}*({self.expression(old[tuple(sorted(axes))])})")
        return ";".join(result)
