# SPDX-License-Identifier: MIT
import numpy as np
import polydec

box = polydec.periodic(polydec.meshes.grid(32, 32), [[1, 0], [0, 1]])
mesh = polydec.discretize(box)
first = polydec.spectrum(mesh, count=2).eigenvalues[1] / (4 * np.pi ** 2)
print("Betti numbers:", *mesh.betti_numbers())
print(f"first eigenvalue over 4 pi^2: {first:g}")
