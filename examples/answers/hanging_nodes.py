# SPDX-License-Identifier: MIT
import polydec

coarse_and_fine = polydec.read_mesh("hanging.off") # a large square beside four small ones
for mesh in (coarse_and_fine, polydec.meshes.join_hanging(coarse_and_fine)):
    complex = polydec.discretize(mesh)
    first = polydec.spectrum(complex, count=2).eigenvalues[1]
    print(f"loops {complex.betti_numbers()[1]}, first eigenvalue {first:g}")
