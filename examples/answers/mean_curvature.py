# SPDX-License-Identifier: MIT
import numpy as np
import polydec

sphere = polydec.discretize(polydec.meshes.icosphere(16))
normals = sphere.laplacian(0) @ sphere.points # Delta x = 2 H n
curvature = np.linalg.norm(normals, axis=1) / 2
print(f"mean curvature from {curvature.min():g} to {curvature.max():g}") # 1 on a unit sphere
# What can go wrong:
angles, radii = np.radians(60 * np.arange(6)), np.where(np.arange(6) % 2, 2 + 3 ** 0.5, 1.0)
spokes = np.vstack([[0, 0], np.column_stack([radii * np.cos(angles), radii * np.sin(angles)])])
fan = spokes, [[0, i + 1, (i + 1) % 6 + 1] for i in range(6)]
try:
    polydec.discretize(fan, star="circumcentric").laplacian(0)
except polydec.InvalidInput as error:
    print(error)
