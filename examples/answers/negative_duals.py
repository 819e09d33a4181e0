# SPDX-License-Identifier: MIT
import polydec

rough = polydec.meshes.perturbed(polydec.meshes.torus(20, 10), 0.05, 1)
mesh = polydec.discretize(rough, star="circumcentric")
print("negative dual edges:", len(mesh.negatives(1)))
flipped = polydec.discretize(rough, star="circumcentric", delaunay="flips")
print("after flips:", len(flipped.negatives(1)))
