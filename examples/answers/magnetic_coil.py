# SPDX-License-Identifier: MIT
import numpy as np
import polydec

box = polydec.discretize(polydec.meshes.kuhn([8, 8, 8]))
iron = box.with_material(2, lambda x: np.where(
    np.linalg.norm(x[:, :2] - 0.5, axis=1) < 0.2, 0.01, 1.0))
turned = np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 0]])
coil = polydec.de_rham(box, 1, lambda x: (x - 0.5) @ turned)
A = polydec.PoissonSolver(iron, degree=1).solve_curl_curl(coil).potential
energy, work = A.d().norm() ** 2 / 2, iron.inner_product(A.values, coil, 1) / 2
print(f"energy {energy:g}, work {work:g}")
# What can go wrong:
outwards = box.cochain(polydec.de_rham(box, 1, lambda x: x - 0.5), 1) # has sources
removed = polydec.PoissonSolver(box, degree=1).solve_curl_curl(outwards).removed
print(f"removed {removed.norm() / outwards.norm():.2f}")
