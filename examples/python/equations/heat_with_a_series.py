# SPDX-License-Identifier: MIT
"""Heat diffuses on a sphere, with pictures for ParaView: the height z decays as exp(-2 t)."""
import polydec

sphere = polydec.discretize(polydec.meshes.goldberg(8))
z = sphere.points[:, 2]
heat = polydec.Evolution(sphere, z, diffusion=1.0)
with polydec.Series("heat.pvd", sphere) as film:
    for time, u in heat.frames([0.1, 0.2, 0.3, 0.4, 0.5]):
        film.add(time, {"heat": u})
left = sphere.norm(heat.forms[0], 0) / sphere.norm(z, 0)
print(f"after 0.5 there is {left:g} of it")
