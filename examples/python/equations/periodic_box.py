# SPDX-License-Identifier: MIT
"""A periodic box. Its eigenfunctions have frequencies 2 pi (k, l); (0, 1) has multiplicity four, by
signs and permutations."""
import numpy as np

import polydec

box = polydec.periodic(polydec.meshes.grid(40, 40), [[1, 0], [0, 1]])
mesh = polydec.discretize(box)
modes = polydec.spectrum(mesh, count=5).eigenvalues
print(f"{mesh.size(0)} vertices, no boundary; eigenvalues over 4 pi^2:",
      *(f"{value:g}" for value in modes[1:] / (4 * np.pi ** 2)))
