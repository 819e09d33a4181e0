# SPDX-License-Identifier: MIT
"""A front of u' = u_xx + u (1 - u) (u - 0.1) advances until it reaches the middle: at time 17.678,
with speed 0.8 / sqrt(2)."""
import numpy as np

import polydec

line = polydec.discretize(polydec.meshes.kuhn([400], [40.0]))
front = 1 / (1 + np.exp((line.points[:, 0] - 10) / np.sqrt(2)))
fire = polydec.Evolution(line, front, diffusion=1.0,
                         reaction=lambda t, u: u * (1 - u) * (u - 0.1),
                         event=lambda t, u: u[200] - 0.5)
fire.march(100.0)
print(f"in the middle at {fire.time:g}")
