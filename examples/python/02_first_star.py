# SPDX-License-Identifier: MIT
"""The metric enters through the Hodge star. It maps the integral of a form over a cell to one over
the dual cell. Dual volumes are signed; the sum of |s| |*s| is C(n,k) times the area."""
from math import comb

import polydec

mesh = polydec.discretize(polydec.meshes.well_centered(8))

for k in range(3):
    star = mesh.star(k)
    area = mesh.volumes(k) @ mesh.dual_volumes(k) / comb(2, k)
    print(f"star_{k} from {star.min():g} to {star.max():g}; "
          f"sum |s||*s| / C(2,{k}) = {area:g}")

# the flux of the field (2,1) through dual edges, from its circulation along edges
circulation = mesh.cochain(polydec.de_rham(mesh, 1, lambda p: [2, 1] + 0 * p), 1)
back = circulation.star().star()
print(f"|X|^2 times the area: {mesh.inner_product(circulation, circulation):g}")
print(f"star star = {back.values[0] / circulation.values[0]:g} on 1-forms in the plane")
