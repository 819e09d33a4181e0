# SPDX-License-Identifier: MIT
"""Delta u = f on a square of hexagons, with u at the circumcenters and u = 0 on the boundary.
Doubling the number of hexagons per row divides the error by four: order 2."""
import numpy as np

import polydec


def error(columns: int) -> float:
    hexagons = polydec.discretize(polydec.meshes.hexagons(columns))
    solver = polydec.PoissonSolver(hexagons, side="dual")

    exact = np.prod(np.sin(np.pi * solver.sites), axis=1)
    u = solver.solve(2 * np.pi ** 2 * exact).values

    # L2 norm: each value is weighted by the area of its cell
    return float(np.sqrt(hexagons.volumes(2) @ (u - exact) ** 2))


coarse, fine = error(32), error(64)
print(f"errors {coarse:g} and {fine:g}, order {np.log2(coarse / fine):.2f}")
