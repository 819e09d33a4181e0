# SPDX-License-Identifier: MIT
"""What intrinsic flips and splits have to keep and to bring about, and the numbers of an
independent program beside those of the command."""
import collections
import math

from golden_numbers import differs
from mesh_laws import kernel_flaws, topology_flaws
from polyhedra import area_vector


# Laws: each returns what is wrong

def sides_of_edges(d):
    """How many cells each edge has, counted twice where it has the same one on both sides: those
    with one coefficient of +-1 are on the boundary, and an edge has 0 or +-2 of a cell on both."""
    sides = [0] * d.columns
    for (_, edge), coefficient in d.entries.items():
        sides[edge] += abs(int(coefficient))
    return [1 if count == 1 else 2 for count in sides]


def flip_flaws(info):
    """Flips keep Betti numbers and leave no negative star_1 inside."""
    flaws = topology_flaws(info)
    done, stars = info["intrinsic"], info["stars"]
    if done["negative"]:
        flaws.append("negative duals inside are left")
    if stars[1]["negative"] != done["negative_boundary"]:
        flaws.append("negative duals that are not on the boundary")
    if not done["negative_boundary"] and stars[0]["negative"]:
        flaws.append("a negative star_0 away from negative duals")
    return flaws


def split_flaws(info):
    """With splits every star is positive."""
    return flip_flaws(info) + [f"star_{k}" for k, star in enumerate(info["stars"])
                               if star["min"] <= 0 or star["negative"] or star["zero"]]


def positive_entries(laplacian):
    """Off-diagonal entries that are positive, and not by rounding."""
    diagonal = [laplacian.entries.get((i, i), 0) for i in range(laplacian.rows)]
    return [(i, j) for (i, j), value in laplacian.entries.items()
            if i != j and value > 1e-13 * (diagonal[i] + diagonal[j])]


def spectrum_flaws(answer, betti):
    """Certified, as many zeros as the Betti number, and none negative."""
    values = answer["eigenvalues"]
    flaws = kernel_flaws(values, betti)
    if answer["certificate"]["complete"] is not True:
        flaws.append("not certified")
    if values[0] < -1e-9 * values[-1]:
        flaws.append(f"{values[0]} is negative")
    return flaws


def area_of(grid):
    return math.fsum(math.hypot(*area_vector(grid.points, face))
                     for faces in grid.cells for face in faces)


# The independent program

def compare_numbers(values, wanted):
    """Keys of a summary of numbers that these have not; a sum may cancel, and so may a minimum."""
    found = {"size": len(values), "sum": math.fsum(values), "norm": math.hypot(*values),
             "min": min(values), "max": max(values), "negative": sum(x < -1e-8 for x in values)}
    scale = max(1, *map(abs, values))
    return [key for key, value in found.items() if differs(value, wanted[key], 1e-8, 1e-8 * scale)]


def count_below(rows, shift):
    """Number of eigenvalues below the shift, by the signs of the pivots. The rows are symmetric,
    each as {column: value}."""
    rows = [dict(row) for row in rows]
    negative = 0
    for i, row in enumerate(rows):
        pivot = row[i] - shift
        negative += pivot < 0
        below = [(j, value) for j, value in row.items() if j > i]
        for j, value in below:
            for k, other in below:
                rows[j][k] = rows[j].get(k, 0) - value * other / pivot
    return negative


def natural_dual_rows(d, star, areas):
    """Laplacian of dual 0-forms without flux through the boundary, made symmetric by the areas."""
    columns = collections.defaultdict(list)
    for (cell, edge), coefficient in d.entries.items():
        columns[edge].append((cell, coefficient / math.sqrt(areas[cell])))
    rows = [collections.defaultdict(float) for _ in areas]
    for edge, sides in enumerate(sides_of_edges(d)):
        for i, a in columns[edge] if sides == 2 else ():
            for j, b in columns[edge]:
                rows[i][j] += a * b / star[edge]
    return rows


def spectrum_of_rows_differs(rows, wanted, relative=1e-7):
    """Values of the ascending list that are not in the spectrum at their places."""
    widths = [relative * max(1, abs(value)) for value in wanted]
    return [value for i, (value, width) in enumerate(zip(wanted, widths))
            if not count_below(rows, value - width) <= i < count_below(rows, value + width)]
