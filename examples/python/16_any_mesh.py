# SPDX-License-Identifier: MIT
"""Calculus on an arbitrary mesh. Obtuse triangles have negative duals, and diagonal stars are then
no inner products. Automatic stars are positive on every mesh. `16_any_mesh.py MESH` takes your own
mesh of triangles or tetrahedra."""
import sys

import numpy as np

import polydec

given = sys.argv[1] if len(sys.argv) > 1 else polydec.meshes.perturbed(
    polydec.meshes.torus(40, 20), 0.035, 3)
mesh = polydec.discretize(given, star="automatic")
chosen = mesh.report()["star"]
negative = (mesh.dual_volumes(1) / mesh.volumes(1) < 0).sum()
print(f"{negative} of {mesh.size(1)} duals of edges are negative: {chosen['kind']} stars, Galerkin's "
      f"on {100 * chosen['galerkin_share']:g} % of the cells")

holes = mesh.betti_numbers()[1]
found = polydec.spectrum(mesh, degree=1, count=holes + 4)
values = np.where(found.eigenvalues <= found.radii, 0, found.eigenvalues)
print(f"Betti number {holes}, smallest eigenvalues of 1-forms:", *(f"{value:g}" for value in values),
      end=", none is missing\n" if found.certificate.complete else "\n")

wind = mesh.cochain(polydec.de_rham(mesh, 1, lambda p: np.column_stack(
    [-p[:, 1], p[:, 0], 0.5 * p[:, 0].clip(min=0)])), 1)
hodge = polydec.hodge_decomposition(mesh, wind)
parts = [hodge.exact, hodge.coexact, hodge.harmonic]
energies = [mesh.inner_product(part, part) / mesh.inner_product(wind, wind) for part in parts]
mixed = [abs(mesh.inner_product(hodge.exact, part)) for part in parts[1:]]
orthogonal = "yes" if max(mixed) < 1e-10 * wind.norm() ** 2 else "no"
print("of the energy of a wind {:g} is exact, {:g} coexact, {:g} harmonic; ".format(*energies)
      + f"orthogonal to 1e-10: {orthogonal}")
