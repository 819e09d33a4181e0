# SPDX-License-Identifier: MIT
import numpy as np
import polydec

mesh = polydec.discretize(polydec.meshes.hexagons(8))
field = lambda x: np.column_stack([-x[:, 1], x[:, 0]])
w = mesh.cochain(polydec.de_rham(mesh, 1, field), 1) # circulation along each edge
arrows = polydec.sharp_pd(mesh, w) # back again: a vector in each hexagon
print(f"integral of the curl: {w.d().values.sum():g}")
print(f"largest error: {abs(arrows - field(mesh.centroids(2))).max():g}")
# What can go wrong:
try:
    polydec.de_rham(mesh, 1, lambda x: x[:, 0])
except polydec.Error as error:
    print(error)
