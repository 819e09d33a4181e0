# SPDX-License-Identifier: MIT
import numpy as np
import polydec

torus = polydec.discretize(polydec.meshes.torus(32, 16))
wind = np.cross([0, 0, 1], torus.points) # around the axis, a vector at each vertex
L = polydec.lie_derivative(torus, wind, 0, sampling="upwind") # a scipy matrix
u = (torus.points[:, 0] > 1).astype(float)
for _ in range(50):
    u -= 0.05 * (L @ u)
print(f"largest value {u.max():g}")
# What can go wrong:
try:
    polydec.lie_derivative(torus, wind[:, :2], 0)
except polydec.InvalidInput as error:
    print(error)
