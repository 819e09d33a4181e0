# SPDX-License-Identifier: MIT
"""Two vortices on a sphere of hexagons orbit each other. Without viscosity, energy is conserved."""
import numpy as np

import polydec

sphere = polydec.discretize(polydec.meshes.goldberg(8))
_, y, z = sphere.points.T
vorticity = np.exp(-8 * (y - 0.4) ** 2 - 8 * z * z) - np.exp(-8 * (y + 0.4) ** 2 - 8 * z * z)
flow = polydec.IncompressibleFlow(sphere)
w = flow.project(polydec.flow_of_vorticity(sphere, vorticity))
before = flow.energy(w)
step = 0.5 * flow.exchange_time(w)
vortices = polydec.Flow(flow, w, step)
vortices.march(100 * step)
kept = abs(flow.energy(vortices.forms[0]) / before - 1) < 1e-10
print(f"energy {before:g}, kept to 1e-10: {'yes' if kept else 'no'}")
