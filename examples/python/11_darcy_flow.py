# SPDX-License-Identifier: MIT
"""Water flows through a box around a block of clay, from pressure 1 at the left to pressure 0 at
the right. Cells are octahedra and tetrahedra of a lattice; every cell is in exact balance."""
import numpy as np

import polydec

box = polydec.discretize(polydec.meshes.fcc([16, 8, 8], 0.125),  # 2 x 1 x 1
                         star="circumcentric")
places = box.dual_sites()
clay = (abs(places[:, 0] - 1) < 0.3) & (places[:, 2] < 0.6) # a block from the floor upwards
kappa = box.cochain(np.where(clay, 1e-4, 1.0), 0, "dual")

# pressures are given left and right; the other walls are impermeable
solver = polydec.PoissonSolver(box, side="dual", conductivity=kappa, essential=lambda facets: (
    (facets[:, 0] < 1e-9) | (facets[:, 0] > 2 - 1e-9)))
flow = solver.solve(boundary=lambda facets: 1 - facets[:, 0] / 2)

# a flux is outward if the facet is oriented as the boundary of its cell
divergence = box.d(2)
out = (divergence.T @ np.ones(len(places))) * flow.flux.values
left, right = (box.facet_sites()[:, 0] < 1e-9), (box.facet_sites()[:, 0] > 2 - 1e-9)
print(f"inflow {-out[left].sum():g}, outflow {out[right].sum():g}, without the block 0.5")
balance = abs(divergence @ flow.flux.values).max()
print("every cell balances to 1e-12:", "yes" if balance < 1e-12 else "no")

polydec.view(box, {"pressure": flow.form},
             title="Pressure around a block of clay").save("darcy_flow.html")
