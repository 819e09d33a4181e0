# SPDX-License-Identifier: MIT
"""Standing waves of the electric field in a box with conducting walls: curl curl E = lambda E with
E a 1-form that vanishes on the walls, on cubes that are merged of six tetrahedra each. The exact
eigenvalues are pi^2 (i^2 + j^2 + k^2) with at most one 0: twice if none is, else once."""
import numpy as np

import polydec

box = polydec.discretize(polydec.meshes.kuhn([8, 8, 8]))
cavity = box.conditioned(degree=1)
modes = polydec.spectrum(cavity, degree=1, count=17, coexact=True)

print("eigenvalues / pi^2, to tell from 2, 3, 5 and 6:",
      *(f"{value / np.pi ** 2:.3f}" for value in modes.eigenvalues))
print("proved: none is missing" if modes.certificate.complete else "not proved")

# how strong the field of the six modes near 5 pi^2 is together, which does not depend on how they
# are told from each other
fields = cavity.extend(1, modes.modes[:, 5:11])
energy = sum((polydec.sharp_pd(box, E) ** 2).sum(axis=1) for E in fields.T)
polydec.view(box, {"energy": energy}, degree=3,
             title="Energy of six standing waves").save("maxwell_cavity.html")
