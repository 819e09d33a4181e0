# SPDX-License-Identifier: MIT
"""Dividing spots: the Gray-Scott reaction of two substances on a sphere of hexagons."""
import numpy as np

import polydec

sphere = polydec.discretize(polydec.meshes.goldberg(10))
seeds = np.where(np.prod(np.sin(8 * sphere.points), axis=1) > 0.3, 1.0, 0.0)
reaction = lambda t, u, v: (0.037 * (1 - u) - u * v * v, u * v * v - 0.1 * v)
pattern = polydec.Evolution(sphere, [1 - seeds / 2, seeds / 4], diffusion=[6e-4, 3e-4],
                            reaction=reaction)
pattern.march(1000.0)
fed, grown = pattern.forms
print(f"food from {fed.min():g} to {fed.max():g}, spots up to {grown.max():g}")
