# SPDX-License-Identifier: MIT
import polydec

hexagons = polydec.discretize(polydec.meshes.hexagons(3))
polydec.draw(hexagons, duals=True, numbers=True, orientations=True).save("hexagons.svg")
print("cells:", hexagons.size(2))
