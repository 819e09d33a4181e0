# SPDX-License-Identifier: MIT
"""Heat with a time-dependent source and cold walls: u = cos t sin(pi x) sin(pi y)."""
import numpy as np

import polydec

square = polydec.discretize(polydec.meshes.grid(32, 32))
shape = np.prod(np.sin(np.pi * square.points), axis=1)
source = lambda t, u: (2 * np.pi ** 2 * np.cos(t) - np.sin(t)) * shape
heat = polydec.Evolution(square, shape, diffusion=1.0, essential=True, reaction=source)
heat.march(2.0)
error = heat.forms[0] - np.cos(2.0) * shape
print(f"off by {square.norm(error, 0) / square.norm(shape, 0):g}")
