# SPDX-License-Identifier: MIT
import numpy as np
import polydec

torus = polydec.discretize(polydec.meshes.torus(32, 16))
field = lambda x: np.column_stack([-x[:, 1], x[:, 0], x[:, 2]])
w = torus.cochain(polydec.de_rham(torus, 1, field), 1)
parts = polydec.hodge_decomposition(torus, w)
for name in ("exact", "coexact", "harmonic"): # gradient, curl, around the holes
    print(f"{name}: {getattr(parts, name).norm():g}")
