# SPDX-License-Identifier: MIT
import polydec

box = polydec.read_mesh("box.off") # six squares, each with corners of its own
apart = polydec.meshes.unjoined_boundary(box)
print(len(apart.coincident), "vertices coincide with others")
for mesh in (box, polydec.meshes.weld(box)):
    print("Betti numbers:", *polydec.discretize(mesh).betti_numbers())
