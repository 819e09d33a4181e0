# SPDX-License-Identifier: MIT
"""Every 1-form on a torus is the sum of a gradient, a curl and a harmonic form. Periods, integrals
along the generators of the homology, determine the harmonic part."""
import numpy as np

import polydec

torus = polydec.discretize(polydec.meshes.torus(48, 24))

# a wind around the axis that blows slightly upwards in front
wind = torus.cochain(polydec.de_rham(torus, 1, lambda p: np.column_stack(
    [-p[:, 1], p[:, 0], 0.5 * p[:, 0].clip(min=0)])), 1)
parts = polydec.hodge_decomposition(torus, wind)

energies = [form.norm() ** 2 for form in (wind, parts.exact, parts.coexact, parts.harmonic)]
print("energy of the wind {:g} = exact {:g} + coexact {:g} + harmonic {:g}".format(*energies))

loops = torus.homology_generators(1)
exact = "none" if abs(loops.T @ parts.exact.values).max() < 1e-10 else "some"
print(f"Betti number {loops.shape[1]}, periods of the wind's exact part: {exact}, "
      "of the harmonic part:", *(f"{value:g}" for value in loops.T @ parts.harmonic.values))
