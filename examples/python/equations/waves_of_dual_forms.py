# SPDX-License-Identifier: MIT
"""Waves with one value per hexagon of a sphere: z oscillates as cos(sqrt(2) t)."""
import numpy as np

import polydec

sphere = polydec.discretize(polydec.meshes.goldberg(8))
z = polydec.de_rham(sphere, 0, lambda x: x[:, 2], side="dual")
half = np.pi / np.sqrt(2)
waves = polydec.Waves(sphere, z, side="dual", time_step=half / 50)
before = waves.energy
waves.march(half)
kept = abs(waves.energy / before - 1) < 1e-12
print(f"after half a period {waves.forms[0] @ z / (z @ z):g}, energy kept to 1e-12: {'yes' if kept else 'no'}")
