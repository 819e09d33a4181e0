# SPDX-License-Identifier: MIT
import numpy as np
import polydec

box = polydec.discretize(polydec.meshes.kuhn([3, 3, 3, 3])) # 24 * 81 simplices
print("cells of each degree:", *box.shape)
first = polydec.spectrum(box, side="dual", count=1).eigenvalues[0]
print(f"first eigenvalue over 4 pi^2: {first / (4 * np.pi ** 2):g}")
