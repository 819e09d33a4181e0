# SPDX-License-Identifier: MIT
import numpy as np
import polydec

sphere = polydec.discretize(polydec.meshes.goldberg(6))
seeds = np.where(sphere.points[:, 2] > 0.8, 1.0, 0.0)
growth = lambda t, u: u * (1 - u) # du/dt = -0.01 Delta u + u (1 - u)
spread = polydec.Evolution(sphere, seeds, diffusion=0.01, reaction=growth)
for time, u in spread.frames([2.0, 4.0, 6.0]):
    print(f"time {time:g}: covered {sphere.star(0) @ u / sphere.star(0).sum():g}")
# What can go wrong:
try:
    wrong = polydec.Evolution(sphere, seeds, diffusion=0.01, reaction=lambda t, u: u[1:])
    wrong.march(1.0)
except polydec.Error as error:
    print(error)
