# SPDX-License-Identifier: MIT
"""Delta u = f on a square of hexagons with u = 0 on the boundary, u at the circumcenters. With twice
as many hexagons to a row the error falls by four: order 2."""
import numpy as np

import polydec


def error(columns: int) -> float:
    hexagons = polydec.discretize(polydec.meshes.hexagons(columns))
    solver = polydec.PoissonSolver(hexagons, side="dual")

    exact = np.prod(np.sin(np.pi * solver.sites), axis=1)
    u = solver.solve(2 * np.pi ** 2 * exact).values

    # L2 norm: each value counts with the area of its cell
    return float(np.sqrt(hexagons.volumes(2) @ (u - exact) ** 2))


coarse, fine = error(32), error(64)
print(f"errors {coarse:g} and {fine:g}, order {np.log2(coarse / fine):.2f}")
