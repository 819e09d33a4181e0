# SPDX-License-Identifier: MIT
import polydec

points = [[0, 0], [1, 0], [1, 1], [0, 1]]
triangles = [[0, 1, 2], [0, 2, 3]]
mesh = polydec.discretize((points, triangles))
print("vertices, edges, cells:", *mesh.shape)
print(f"area: {mesh.volumes(2).sum():g}")
