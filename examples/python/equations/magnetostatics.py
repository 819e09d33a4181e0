# SPDX-License-Identifier: MIT
"""The field of a coil around an iron core in a box. Its energy is the work of the current."""
import numpy as np

import polydec

box = polydec.discretize(polydec.meshes.kuhn([10, 10, 10]))
iron = box.with_material(2, lambda x: np.where(
    np.linalg.norm(x[:, :2] - 0.5, axis=1) < 0.2, 0.01, 1.0))
turned = np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 0]])
coil = polydec.de_rham(box, 1, lambda x: (x - 0.5) @ turned * np.exp(
    -30 * ((x[:, :2] - 0.5) ** 2).sum(axis=1, keepdims=True)))
A = polydec.PoissonSolver(iron, degree=1).solve_curl_curl(coil).potential
print(f"energy {A.d().norm() ** 2 / 2:g}, work {iron.inner_product(A.values, coil, 1) / 2:g}")
