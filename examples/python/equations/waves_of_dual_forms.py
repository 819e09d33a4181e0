# SPDX-License-Identifier: MIT
"""Waves with a value in each hexagon of a sphere: z swings as cos(sqrt(2) t)."""
import numpy as np

import polydec

sphere = polydec.discretize(polydec.meshes.goldberg(8))
z = polydec.de_rham(sphere, 0, lambda x: x[:, 2], side="dual")
dt = np.pi / np.sqrt(2) / 50
waves = polydec.Leapfrog(sphere, 0, dt, side="dual")
E, B = z, dt / 2 * (sphere.d(0, "dual") @ z)
before = waves.energy(E, B)
E, B = waves.step(E, B, 50)
kept = abs(waves.energy(E, B) / before - 1) < 1e-12
print(f"after half a period {E @ z / (z @ z):g}, energy kept to 1e-12: {'yes' if kept else 'no'}")
