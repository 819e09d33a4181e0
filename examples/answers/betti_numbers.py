# SPDX-License-Identifier: MIT
import polydec

torus = polydec.discretize(polydec.meshes.torus(32, 16))
print("Betti numbers:", *torus.betti_numbers())
loops = torus.homology_generators(1) # a column of edges, with signs, for each loop
print("edges of the loops:", *sorted(abs(loops).sum(axis=0).A1.astype(int)))
