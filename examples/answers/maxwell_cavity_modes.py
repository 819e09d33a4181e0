# SPDX-License-Identifier: MIT
import numpy as np
import polydec

box = polydec.discretize(polydec.meshes.kuhn([8, 8, 8]))
cavity = box.conditioned(degree=1) # E is normal to the walls
modes = polydec.spectrum(cavity, degree=1, count=5, coexact=True)
print("over pi^2:", *(f"{value:g}" for value in modes.eigenvalues / np.pi ** 2)) # 2 2 2 3 3
