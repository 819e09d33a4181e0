# SPDX-License-Identifier: MIT
import numpy as np
import polydec

d0 = np.array([[-1, 1, 0], [0, -1, 1], [1, 0, -1]]) # a ring of three edges of length 2
ones, twos = np.ones(3), np.full(3, 2.0)
ring = polydec.Cells.of([d0], [ones, twos], [twos, ones]) # volumes, volumes of the duals
print("Betti numbers:", *ring.betti_numbers())
print(f"largest eigenvalue: {polydec.spectrum(ring, count=3).eigenvalues[2]:g}")
# What can go wrong:
try:
    polydec.Cells.of([d0, np.array([[1, 1, -1]])], [ones, ones, [1.0]], [ones, ones, [1.0]])
except polydec.InvalidInput as error:
    print(error)
