# SPDX-License-Identifier: MIT
import numpy as np
import polydec

plane = polydec.discretize(polydec.meshes.grid(40, 40))
start = np.exp(-200 * ((plane.points - 0.5) ** 2).sum(axis=1))
light = polydec.Waves(plane, start, essential=True, time_step=0.01, layer=0.25)
before = light.energy
light.march(2.0)
print("less than 1e-4 of the energy stays:", "yes" if light.energy < 1e-4 * before else "no")
