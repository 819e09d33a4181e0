# SPDX-License-Identifier: MIT
import numpy as np
from scipy.sparse import diags
import polydec

A = diags([-np.ones(99), 2 * np.ones(100), -np.ones(99)], [-1, 0, 1])
found = polydec.smallest_eigenpairs(A, count=3)
print("eigenvalues:", *(f"{value:g}" for value in found.eigenvalues))
print("none is missing:", "proved" if found.certificate.complete else "not proved")
# What can go wrong:
try:
    polydec.smallest_eigenpairs(A, diags(-np.ones(100)))
except polydec.Error as error:
    print(error)
