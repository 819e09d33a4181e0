# SPDX-License-Identifier: MIT
"""A box without walls, whose opposite sides are one: functions swing there with the frequencies 2 pi
(k, l), for (0, 1) as many as there are signs and places."""
import numpy as np

import polydec

box = polydec.periodic(polydec.meshes.grid(40, 40), [[1, 0], [0, 1]])
mesh = polydec.discretize(box)
modes = polydec.spectrum(mesh, count=5).eigenvalues
print(f"{mesh.size(0)} vertices, no boundary; eigenvalues over 4 pi^2:",
      *(f"{value:g}" for value in modes[1:] / (4 * np.pi ** 2)))
