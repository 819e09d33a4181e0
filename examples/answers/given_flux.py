# SPDX-License-Identifier: MIT
import polydec

square = polydec.discretize(polydec.meshes.grid(16, 16))
left = lambda x: x[:, 0] < 1e-9
inflow = lambda x: 3.0 * (x[:, 0] > 1 - 1e-9) # du/dnu = 3 on the right, 0 above and below
u = polydec.poisson(square, 0.0, flux=inflow, essential=left).values
print(f"largest value: {u.max():g}") # u = 3 x
