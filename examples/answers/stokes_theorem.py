# SPDX-License-Identifier: MIT
import numpy as np
import polydec

mesh = polydec.discretize(polydec.meshes.hexagons(8))
w = polydec.de_rham(mesh, 1, lambda x: np.column_stack([-x[:, 1], x[:, 0]]))
region = np.ones(mesh.size(2)) # a chain: all cells once
rim = mesh.boundary(2) @ region # its boundary, edges with signs
print(f"inside {region @ (mesh.d(1) @ w):g}, around {rim @ w:g}")
print("d d = 0:", "yes" if abs(mesh.d(1) @ mesh.d(0)).max() == 0 else "no")
# What can go wrong:
try:
    mesh.cochain(np.ones(3), 1)
except polydec.InvalidInput as error:
    print(error)
