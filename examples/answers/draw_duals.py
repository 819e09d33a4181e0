# SPDX-License-Identifier: MIT
import polydec

hexagons = polydec.discretize(polydec.meshes.hexagons(3))
polydec.view(hexagons, title="Hexagons and their duals").save("hexagons.html")
print("cells:", hexagons.size(2))
