# SPDX-License-Identifier: MIT
import polydec

square = polydec.meshes.grid(16, 16)
discrete = polydec.spectrum(square, count=1, side="dual") # of the mesh
print(f"mesh {discrete.eigenvalues[0]:g}, radius below 1e-9:",
      "yes" if discrete.radii[0] < 1e-9 else "no")
found = polydec.shape_spectrum(square, count=1, essential=True) # of the square itself
print(f"shape between {found.lower[0]:g} and {found.upper[0]:g}") # 2 pi^2 = 19.7392
