# SPDX-License-Identifier: MIT
import numpy as np
import polydec

planet = polydec.discretize(polydec.meshes.goldberg(8))
water = polydec.ShallowWater(planet, rotation=2 * planet.points[:, 2])
depth = polydec.de_rham(planet, 0, lambda x: 1 + 0.2 * np.exp(8 * (x[:, 0] - 1)), side="dual")
flux = np.zeros(planet.size(1))
mass = water.mass(depth, flux)
depth, flux = water.step(depth, flux, 0.5 * water.stable_step(depth, flux), 200)
print(f"highest {depth.max():g}, mass kept {water.mass(depth, flux) / mass:g}")
# What can go wrong:
try:
    water.step(depth, flux, 50 * water.stable_step(depth, flux), 20)
except polydec.Error as error:
    print(error)
