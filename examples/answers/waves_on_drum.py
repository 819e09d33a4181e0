# SPDX-License-Identifier: MIT
import numpy as np
import polydec

drum = polydec.discretize(polydec.meshes.grid(32, 32))
start = polydec.de_rham(drum, 0, lambda x: np.prod(np.sin(np.pi * x), axis=1), side="dual")
half_period = 1 / np.sqrt(2)
waves = polydec.Waves(drum, start, side="dual", time_step=half_period / 50)
waves.march(half_period)
print(f"after half a period: {waves.forms[0] @ start / (start @ start):g}")
