# SPDX-License-Identifier: MIT
import polydec

points = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0], [1, 1, 0], [2, 1, 0]]
quads = [[0, 1, 4, 3], [1, 2, 5, 4]]
mesh = polydec.discretize(polydec.split_polygons(points, quads))
print("vertices, edges, cells:", *mesh.shape)
# What can go wrong:
try:
    polydec.discretize((points, quads))
except polydec.InvalidInput as error:
    print(error)
