# SPDX-License-Identifier: MIT
"""The right column of docs/coming-from/combinatorialspaces.md."""
import numpy as np

import polydec

polydec.write_mesh("sphere.obj", polydec.meshes.icosphere(8))

s = polydec.read_mesh("sphere.obj")
c = polydec.discretize(s, star="circumcentric")
b = polydec.discretize(s, centers="centroids")
assert np.isclose(b.star(0).sum(), c.star(0).sum())

vertices, edges, faces = c.shape
f = c.cochain(c.points[:, 2], 0)
a = f.d()
assert np.allclose(a, c.d(0) @ f)
assert abs(c.d(1) @ c.d(0)).max() == 0

star1 = c.star(1)
inverse = c.inverse_star(1)
dual = c.d(1, side="dual")
assert np.allclose(star1 * inverse, 1.0)
assert abs(abs(dual) - abs(c.boundary(1))).max() == 0

delta = c.codifferential(1)
positive = c.laplacian(0)
negative = -c.laplacian(0)
assert np.allclose(delta @ a, positive @ f)

w = polydec.wedge(c, f, a)
pairing = polydec.primal_dual_wedge(c, a, a.star())
assert np.isclose(pairing.sum(), a.norm() ** 2)

X = np.cross([0.0, 0.0, 1.0], c.points)
flat = polydec.flat(c, "ppp", X)
sharp = polydec.sharp_pp(c, a)
contracted = polydec.interior_product(c, X, 1) @ a
carried = polydec.lie_derivative(c, X, 0) @ f
assert abs(contracted).max() < 0.05 and abs(carried).max() < 0.05   # X turns around z

lengths = c.volumes(1)
dual_lengths = c.dual_volumes(1)
assert np.allclose(dual_lengths / lengths, star1)

heat = polydec.Evolution(c, f, diffusion=0.5)
heat.march(1.0)
left = c.norm(heat.forms[0], 0) / f.norm()
parts = polydec.hodge_decomposition(c, flat)
print(f"{vertices} {edges} {faces}, left of z {left:.3f}, coexact part of a turn "
      f"{parts.coexact.norm() / flat.norm():.3f}, sharp {np.linalg.norm(sharp, axis=1).max():.2f}, "
      f"degree of the product {w.degree}")
