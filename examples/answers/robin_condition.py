# SPDX-License-Identifier: MIT
import polydec

square = polydec.discretize(polydec.meshes.grid(16, 16))
cold = lambda x: x[:, 0] < 1e-9 # u = 0 there, du/dnu + 2 u = 0 elsewhere
u = polydec.poisson(square, 1.0, essential=cold, robin=2.0).values
print(f"largest value: {u.max():g}")
