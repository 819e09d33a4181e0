# SPDX-License-Identifier: MIT
"""A hill of water travels around a rotating planet. Mass and energy are conserved."""
import numpy as np

import polydec

planet = polydec.discretize(polydec.meshes.goldberg(8))
water = polydec.ShallowWater(planet, rotation=2 * planet.points[:, 2])
depth = polydec.de_rham(planet, 0, lambda x: 1 + 0.2 * np.exp(8 * (x[:, 0] - 1)), side="dual")
flux = np.zeros(planet.size(1))
mass, energy = water.mass(depth, flux), water.energy(depth, flux)
start = [planet.cochain(depth, 0, "dual"), planet.cochain(flux, 1)]
run = polydec.Evolution(planet, start, reaction=water, relative_tolerance=1e-8)
run.march(5)
depth, flux = run.forms
print(f"highest {depth.max():g}, of the mass is kept {water.mass(depth, flux) / mass:g}, "
      f"of the energy {water.energy(depth, flux) / energy:g}")
