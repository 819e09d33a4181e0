# SPDX-License-Identifier: MIT
"""Maxwell's equations: a ring of current flashes in the middle of a box, and a layer of five cubes
along the sides absorbs the waves."""
import numpy as np

import polydec

box = polydec.discretize(polydec.meshes.kuhn([20, 20, 20]))
turned = np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 0]])
ring = polydec.de_rham(box, 1, lambda x: (x - 0.5) @ turned * np.exp(
    -60 * ((x - 0.5) ** 2).sum(axis=1, keepdims=True)))
light = polydec.Waves(box, 0 * ring, degree=1, time_step=0.025, essential=True, layer=0.25,
                      source=lambda t: (t - 0.5) * np.exp(-50 * (t - 0.5) ** 2) * ring)
energies = [light.energy for _ in light.frames(np.linspace(0.025, 3, 120))]
print(f"of the energy stays {energies[-1] / max(energies):g}")
