# SPDX-License-Identifier: MIT
import numpy as np
import polydec
planet = polydec.discretize(polydec.meshes.goldberg(8))
water = polydec.ShallowWater(planet, rotation=2 * planet.points[:, 2])
depth = polydec.de_rham(planet, 0, lambda x: 1 + 0.2 * np.exp(8 * (x[:, 0] - 1)), side="dual")
flux = np.zeros(planet.size(1))
start = [planet.cochain(depth, 0, "dual"), planet.cochain(flux, 1)]
run = polydec.Evolution(planet, start, reaction=water)
run.march(5)
print(f"mass kept {water.mass(*run.forms) / water.mass(depth, flux):g}")
# What can go wrong:
try:
    water.rate(0 * depth, flux)
except polydec.Error as error:
    print(error)
