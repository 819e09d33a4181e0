# SPDX-License-Identifier: MIT
"""Standing waves of the electric field in a box with conducting walls: curl curl E = lambda E, with
a 1-form E that vanishes on the walls, on cubes merged from six tetrahedra each. The eigenvalues are
pi^2 (i^2 + j^2 + k^2), at most one of i, j, k being 0: multiplicity two if none is, else one."""
import numpy as np

import polydec

box = polydec.discretize(polydec.meshes.kuhn([8, 8, 8]))
cavity = polydec.FormSpace(box, 1, essential=True)
modes = polydec.spectrum(cavity.inside, degree=1, count=17, coexact=True)

print("eigenvalues / pi^2, to tell from 2, 3, 5 and 6:",
      *(f"{value / np.pi ** 2:.3f}" for value in modes.eigenvalues))
print("proved: none is missing" if modes.certificate.complete else "not proved")

# Six modes with eigenvalues near 5 pi^2 are some basis of this eigenspace. Combines them to the
# wave sin(2 pi x) sin(pi y) along z.
wave = polydec.de_rham(box, 1, lambda p: np.column_stack(
    [0 * p[:, 0], 0 * p[:, 0], np.sin(2 * np.pi * p[:, 0]) * np.sin(np.pi * p[:, 1])]))
wanted, six, mass = cavity.restrict(wave), modes.modes[:, 5:11], cavity.inside.star(1)
found = six @ (six.T @ (mass * wanted))
print(f"of a wave of 5 pi^2 found: {np.sqrt(found @ (mass * found) / (wanted @ (mass * wanted))):.3f}")
vertical = polydec.sharp_pd(box, cavity.extend(found))[:, 2]
polydec.view(box, {"E_z": vertical}, degree=0, side="dual",
             title="A standing wave in a box, of eigenvalue 5 pi^2").save("maxwell_cavity.html")
