# SPDX-License-Identifier: MIT
import polydec

torus = polydec.discretize(polydec.meshes.torus(32, 16))
path = polydec.SurfacePaths(torus, [0]).path(200)
print(f"length {path.length:g}, {len(path.points) - 1} pieces")
