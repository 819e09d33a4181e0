# SPDX-License-Identifier: MIT
"""An engine is a function that takes a matrix and returns a function from right-hand sides to
solutions. Registered under a name, it serves every solver of polydec, which checks its results."""
from typing import Any, Callable

import numpy as np
import scipy.sparse as sp
from scipy.sparse.linalg import splu

import polydec


def gauss_seidel(A: Any) -> Callable[[Any], Any]:
    lower = splu(sp.tril(A, format="csc"), permc_spec="NATURAL", diag_pivot_thresh=0)

    def solve(B: Any) -> Any:
        X, sweeps = np.zeros_like(B), 0
        while np.linalg.norm(B - A @ X) > 1e-11 * np.linalg.norm(B):
            X += lower.solve(B - A @ X)
            sweeps += 1
        print(f"{sweeps} sweeps")
        return X

    return solve


polydec.register_linear_solver("gauss-seidel", gauss_seidel)

mesh = polydec.discretize(polydec.meshes.grid(24, 24))
found = []
for engine in ("gauss-seidel", "eigen.ldlt"):
    u = polydec.poisson(mesh, 1.0, engine=engine)
    found.append(u.values)
    print(f"{u.report['engine']}: largest value {u.values.max():g}")
print("they agree to 1e-9:", "yes" if np.linalg.norm(found[0] - found[1]) < 1e-9 else "no")
