# SPDX-License-Identifier: MIT
import polydec

triangles = polydec.meshes.torus(32, 16)
for merge in (False, True):
    mesh = polydec.discretize(triangles, merge=merge, star="circumcentric")
    print(f"cells {mesh.size(2)}, edges with zero dual {len(mesh.zeros(1))}")
# What can go wrong:
try:
    polydec.discretize(triangles, merge=False, star="circumcentric").inverse_star(1)
except polydec.InvalidInput as error:
    print(error)
