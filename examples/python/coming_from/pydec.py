# SPDX-License-Identifier: MIT
"""The right column of docs/coming-from/pydec.md."""
import numpy as np

import polydec

given = polydec.meshes.grid(3, 3)
V, T = given.points, given.simplices
k = 1

c = polydec.discretize(polydec.Mesh(V, T))
plain = polydec.discretize((V, T), merge=False, star="circumcentric")
assert c.shape == (16, 24, 9) and plain.shape == (16, 33, 18)

assert abs(c[k].d - c.d(k)).max() == 0
assert abs(c[k].boundary - c.boundary(k)).max() == 0
assert np.allclose(c[k].star.diagonal(), c.star(k))
assert np.allclose(c[k].star_inv.diagonal(), c.inverse_star(k))
assert c[k].num_simplices == c.size(k)
assert np.allclose(c[k].primal_volume, c.volumes(k))
assert np.allclose(c[k].dual_volume, c.dual_volumes(k))

values = np.cos(np.arange(c.size(k)))
x = c.cochain(values, k)
y = x.d(), x.star(), x.delta(), x.laplacian()
assert [form.degree for form in y] == [2, 1, 0, 1]
assert np.allclose(y[3], c.laplacian(k) @ x)

w = polydec.whitney_at_centroids(c, x)
assert w.shape == (18, 2)
assert not c.boundary_facets()[c.coface_counts(1) == 2].any()
pair = c.inner_product(x, x)
modes = polydec.spectrum(c, degree=k, count=3)
parts = polydec.hodge_decomposition(c, x)
assert np.isclose(parts.exact.norm() ** 2 + parts.coexact.norm() ** 2 + parts.harmonic.norm() ** 2,
                  pair)
betti = c.betti_numbers()
print(f"{c.shape[2]} squares, Betti numbers {betti}, first eigenvalue {modes.eigenvalues[0]:.3f}")
