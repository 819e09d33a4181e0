# SPDX-License-Identifier: MIT
"""Cells and their incidences, without lengths: two triangles form a square. The boundary of a
boundary is zero, and d is the transpose of the boundary."""
import numpy as np

import polydec

points = [[0, 0], [1, 0], [0, 1], [1, 1]]
square = polydec.discretize((points, [[0, 1, 2], [1, 3, 2]]), merge=False)

for k, cells in enumerate(square.shape):
    print(cells, "cells of degree", k)

# edges run from the smaller vertex number to the larger
edges = square.cells(1)
print("edges:", *(f" {a}-{b}" for a, b in edges.corners.reshape(-1, 2)))
print("d_1, a row for each triangle:")
for row in square.d(1).toarray():
    print(" ".join(f"{value:2g}" for value in row))

# the boundary of the sum of both triangles is the outline of the square
outline = square.boundary(2) @ np.ones(2)
print("boundary of both:", *(f"{value:2g}" for value in outline))
print("boundary of the boundary:", *(f"{value:g}" for value in square.boundary(1) @ outline))

euler = sum((-1) ** k * cells for k, cells in enumerate(square.shape))
print(f"Euler characteristic {euler}, Betti numbers", *square.betti_numbers())
