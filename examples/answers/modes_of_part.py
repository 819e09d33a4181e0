# SPDX-License-Identifier: MIT
import polydec

polydec.write_mesh("part.stl", polydec.meshes.flange(48)) # or your own file
part = polydec.discretize("part.stl")
modes = polydec.spectrum(part, count=4)
print("eigenvalues:", *(f"{value:g}" for value in modes.eigenvalues[1:]))
print("none is missing:", "proved" if modes.certificate.complete else "not proved")
polydec.view(part, modes).save("modes.html")
