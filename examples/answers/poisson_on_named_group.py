# SPDX-License-Identifier: MIT
import numpy as np
import polydec

plate = polydec.discretize("plate.msh", materials="keep_apart")
values = lambda x: np.where(x[:, 0] < 0.5, 100.0, 20.0)
u = polydec.poisson(plate, 0.0, values, essential=["hot", "cold"]).values
middle = np.isclose(plate.points[:, 0], 0.5)
print(f"in the middle: {u[middle].mean():g}")
