# SPDX-License-Identifier: MIT
import polydec

sphere = polydec.meshes.icosphere(4)
mesh = polydec.meshes.tetrahedralize(sphere, quality=1.4)
ball = polydec.discretize(mesh)
print("Betti numbers:", *ball.betti_numbers())
print(f"volume {ball.volumes(3).sum():.6g}")
