# SPDX-License-Identifier: MIT
import numpy as np
from scipy.sparse import diags
from scipy.sparse.linalg import spsolve
import polydec

torus = polydec.discretize(polydec.meshes.torus(32, 16))
K, M = torus.stiffness(0), diags(torus.star(0)) # csr_matrix; d(k) and laplacian(k) likewise
u = spsolve((M + 0.1 * K).tocsc(), M @ torus.points[:, 2]) # an implicit step of heat
print(f"{K.shape[0]} x {K.shape[1]}, {K.nnz} entries")
print(f"largest value {u.max():g}")
# What can go wrong:
triangles = polydec.discretize(polydec.meshes.torus(32, 16), merge=False, star="circumcentric")
try:
    triangles.laplacian(1)
except polydec.InvalidInput as error:
    print(error)
