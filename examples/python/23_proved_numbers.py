# SPDX-License-Identifier: MIT
"""Numbers of a shape, not of its mesh: two proved bounds of the smallest eigenvalue of an L, on
triangles refined where the bounds are far apart, and the error of a Poisson solution."""
import numpy as np

import polydec

CELLS = 8

# three unit squares around a reentrant corner
square = polydec.meshes.kuhn([2 * CELLS, 2 * CELLS], [2.0, 2.0])
inside = (square.points[square.simplices].mean(axis=1) < 1).any(axis=1)
used, corners = np.unique(square.simplices[inside], return_inverse=True)
mesh = polydec.discretize(polydec.Mesh(square.points[used], corners.reshape(-1, 3)), merge=False)

for width in (1e-2, 1e-4):
    found = polydec.shape_spectrum(mesh, count=1, width=width, max_triangles=3000, essential=True)
    low, high = found.lower[0], found.upper[0]
    does = "it does" if low < 9.63972384 and 9.63972385 < high else "wrong"
    print(f"the first eigenvalue, 9.63972384, is proved to lie between {low:.9g} and {high:.9g}: {does}")

# u with -div grad u = 1, and u = 0 on the boundary
u = polydec.poisson(mesh, 1.0, essential=True).values
error = polydec.poisson_error(mesh, u, 1.0)
print(f"the gradient is off by at most {100 * error.energy / error.size:.3g} %")
