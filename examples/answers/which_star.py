# SPDX-License-Identifier: MIT
import polydec

rough = polydec.meshes.perturbed(polydec.meshes.torus(20, 10), 0.05, 1)
mesh = polydec.discretize(rough) # star="automatic"
print("stars:", mesh.star_kind)
print("negative eigenvalues:", (polydec.spectrum(mesh, degree=1, count=4).eigenvalues < -1e-9).sum())
# What can go wrong:
try:
    polydec.spectrum(polydec.discretize(rough, star="circumcentric"), degree=1, count=4)
except polydec.InvalidInput as error:
    print(error)
