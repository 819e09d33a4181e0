# SPDX-License-Identifier: MIT
import numpy as np
import polydec

box = polydec.discretize(polydec.meshes.kuhn([8, 8, 8]))
cavity = polydec.FormSpace(box, 1, essential=True) # E is normal to the walls
modes = polydec.spectrum(cavity.inside, degree=1, count=5, coexact=True)
print("over pi^2:", *(f"{value:g}" for value in modes.eigenvalues / np.pi ** 2)) # 2 2 2 3 3
