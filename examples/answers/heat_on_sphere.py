# SPDX-License-Identifier: MIT
import polydec

sphere = polydec.discretize(polydec.meshes.goldberg(8)) # hexagons and 12 pentagons
z = sphere.points[:, 2]
heat = polydec.Evolution(sphere, z, diffusion=1.0)
heat.march(0.5)
print(f"left: {sphere.norm(heat.forms[0], 0) / sphere.norm(z, 0):g}") # exp(-2 * 0.5)
