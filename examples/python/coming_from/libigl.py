# SPDX-License-Identifier: MIT
"""The right column of docs/coming-from/libigl.md."""
import numpy as np
import scipy.sparse

import polydec

polydec.write_mesh("sphere.off", polydec.meshes.icosphere(8))

mesh = polydec.read_mesh("sphere.off")
v, f = mesh.points, mesh.simplices
c = polydec.discretize((v, f))

L = -c.stiffness(0)
M = scipy.sparse.diags(c.star(0))
consistent = polydec.discretize((v, f), star="galerkin")[0].star
assert abs(L.sum()) < 1e-12 and np.isclose(M.sum(), consistent.sum())

delaunay = polydec.discretize((v, f), delaunay="flips")
assert abs(delaunay.stiffness(0) + L).max() < 1e-12     # it was Delaunay before

edges = c.cells(1)
lengths = c.volumes(1)
areas = c.input.volumes(2)
middles = c.centroids(2)
euler = np.dot(c.betti_numbers(), [1, -1, 1])
rim = polydec.discretize(polydec.meshes.grid(4, 4)).boundary_vertices()
assert len(edges) == len(lengths) == 1920 and len(middles) == 1280 and euler == 2 and len(rim) == 16

z = c.points[:, 2]
slopes = polydec.gradient(c, z)
assert np.linalg.norm(slopes, axis=1).max() < 1.01

exact = polydec.geodesic_distance(c, 0)
heat = polydec.geodesic_distance(c, 0, method="heat")
paths = polydec.SurfacePaths(c, 0)
line = paths.path(5).points
lines, _ = paths.isolines([1.0, 2.0])
assert np.isclose(np.linalg.norm(np.diff(line, axis=0), axis=1).sum(), exact[5])

poles = [0, int(np.argmax(exact))]
held = np.where(exact > 1, 1.0, 0.0)
u = polydec.poisson(c, 0.0, held, fixed=poles).values
smooth = polydec.heat(c, z, 0.01, 5)
modes = polydec.spectrum(c, count=4)

whole = polydec.meshes.weld(mesh)
page = polydec.view(c, u)
page.save("u.html")
print(f"area {areas.sum():.3f}, farthest {exact.max():.3f}, by heat {heat.max():.3f}, "
      f"u from {u.min():.1f} to {u.max():.1f}, z after the flow {smooth.max():.3f}, "
      f"eigenvalue {modes.eigenvalues[1]:.3f}")
