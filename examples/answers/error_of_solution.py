# SPDX-License-Identifier: MIT
import polydec

square = polydec.discretize(polydec.meshes.grid(32, 32), merge=False)
u = polydec.poisson(square, 1.0).values
error = polydec.poisson_error(square, u, 1.0)
print(f"gradient off by at most {100 * error.energy / error.size:g} %")
low, _, high = polydec.goal_interval(square, u, 1.0)
print(f"the integral of u lies between {low:g} and {high:g}")
# What can go wrong:
try:
    polydec.goal_interval(square, u, 1.0, essential=False)
except polydec.InvalidInput as error:
    print(error)
