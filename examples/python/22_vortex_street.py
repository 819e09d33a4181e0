# SPDX-License-Identifier: MIT
"""Flow past a cylinder of diameter 1 with speed 1. The wake oscillates at the frequency that
Williamson (J. Fluid Mech. 206, 1989) measured."""
import numpy as np

import polydec

around, far, reynolds, until = 32, 30.0, 100.0, 40.0

# rows of squares between the cylinder and a circle far away
width = 2 * np.pi / around
rows = int(np.ceil(np.log(2 * far) / width))
row, i = np.divmod(np.arange(around * (rows + 1)), around)
radius = 0.5 * np.exp(width * row)
points = np.column_stack([radius * np.cos(width * i), radius * np.sin(width * i)])
here = np.arange(around * rows)
beside = here - i[:len(here)] + (i[:len(here)] + 1) % around
simplices = np.stack([here, here + around, beside, beside, here + around, beside + around], 1)
mesh = polydec.discretize(polydec.Mesh(points, simplices.reshape(-1, 3)))

x, y = mesh.points.T
inflow = mesh.d(0) @ np.where(x * x + y * y > 1, y, 0) # the cylinder is impermeable
flow = polydec.IncompressibleFlow(
    mesh, viscosity=1 / reynolds, boundary_flux=inflow,
    no_slip=lambda at: np.hypot(*at.T) < 0.6,
    open=lambda at: (at[:, 0] > 0) & (np.hypot(*at.T) > 0.6))
w = flow.project(mesh.d(0) @ (y + np.exp(-4 * ((x - 1) ** 2 + (y - 0.5) ** 2)))) # a first push

steps = int(np.ceil(until / (0.6 * flow.exchange_time(w))))
street = polydec.Flow(flow, w, until / steps, scheme="imex")
behind = int(np.argmin(np.linalg.norm(mesh.centroids(2) - [2, 0.1], axis=1)))
across = np.array([polydec.flux_sharp(mesh, mesh.cochain(w, 1))[behind, 1]
                   for _, w in street.frames(street.time_step * np.arange(1, steps + 1))])

rises = np.flatnonzero((across[:-1] < 0) & (across[1:] >= 0)) + 1
times = until / steps * (rises - across[rises] / (across[rises] - across[rises - 1]))
swings = min(len(times) - 1, 5) # the last
frequency = swings / (times[-1] - times[-1 - swings])
measured = 0.1816 - 3.3265 / reynolds + 1.6e-4 * reynolds
print(f"{mesh.size(2)} quads, Reynolds number {reynolds:g}, {steps} steps: Strouhal number "
      f"{frequency:g}, measured {measured:g}")
