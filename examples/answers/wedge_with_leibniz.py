# SPDX-License-Identifier: MIT
import numpy as np
import polydec

mesh = polydec.discretize(polydec.meshes.hexagons(8))
f = mesh.cochain(np.sin(np.arange(mesh.size(0))), 0)
w = mesh.cochain(np.cos(np.arange(mesh.size(1))), 1)
defect = f.wedge(w).d() - f.d().wedge(w) - f.wedge(w.d())
print("Leibniz to 1e-12:", "yes" if abs(defect.values).max() < 1e-12 else "no")
# What can go wrong:
try:
    w.wedge(w).wedge(w)
except polydec.InvalidInput as error:
    print(error)
