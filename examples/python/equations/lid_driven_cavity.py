# SPDX-License-Identifier: MIT
"""Water in a square box with a moving lid, Re = 100. The backflow on the vertical center line
reaches 0.2109 (Ghia, Ghia, Shin 1982)."""
import numpy as np

import polydec

square = polydec.discretize(polydec.meshes.grid(32, 32))
lid = lambda x: np.outer(x[:, 1] > 0.999, [1.0, 0.0])
flow = polydec.IncompressibleFlow(square, viscosity=0.01, no_slip=True, wall_velocity=lid)
water = polydec.Flow(flow, np.zeros(square.size(1)), 0.02, scheme="imex")
water.march(8.0)
u = polydec.flux_sharp(square, square.cochain(water.forms[0], 1))
middle = abs(square.centers(2)[:, 0] - 0.5) < 0.02
print(f"back with {-u[middle, 0].min():g}")
