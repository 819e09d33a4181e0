# SPDX-License-Identifier: MIT
"""A complex is a sequence of signed incidence matrices, so cells may have any shape. This example
builds a torus of n x n unit squares by hand. Everything else works as on a mesh."""
import numpy as np
import scipy.sparse as sp

import polydec

n = 16
step = sp.eye(n, format="csr")[np.roll(np.arange(n), -1)] - sp.eye(n) # to the next one
x, y = sp.kron(step, sp.eye(n)), sp.kron(sp.eye(n), step)
d0, d1 = sp.vstack([x, y]), sp.hstack([-y, x])

ones = [np.ones(n * n), np.ones(2 * n * n), np.ones(n * n)]
torus = polydec.Cells.of([d0, d1], ones, ones) # checks that d d = 0

modes = polydec.spectrum(torus, degree=1, count=4)
print("smallest eigenvalues of the Laplacian of 1-forms:",
      *(f"{0 if abs(value) < 1e-12 else value:g}" for value in modes.eigenvalues))
# two harmonic forms, then 4 sin^2(pi/16) with multiplicity eight
print("harmonic 1-forms:", polydec.harmonic_forms(torus, 1).shape[1])

heat = np.eye(1, n * n)[0] # the solver makes its mean 0
print(f"above the mean at the source: {polydec.poisson(torus, heat).values[0]:g}")
