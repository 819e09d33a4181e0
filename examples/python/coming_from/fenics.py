# SPDX-License-Identifier: MIT
"""The right column of docs/coming-from/fenics.md."""
import numpy as np

import polydec

msh = polydec.meshes.grid(32, 32)
c = polydec.discretize(msh)
box = polydec.discretize(polydec.meshes.kuhn([4, 4, 4]))

A = c.stiffness(0)
M = c.star(0)
consistent = polydec.discretize(msh, star="galerkin", merge=False)[0].star
assert np.isclose(M.sum(), 1.0) and np.isclose(consistent.sum(), 1.0)

left = lambda x: x[:, 0] < 1e-9
g = lambda x: 1 + x[:, 1] ** 2
f = polydec.de_rham(c, 0, lambda x: x[:, 0] * x[:, 1])
u = polydec.poisson(c, 1.0, essential=True)
mixed = polydec.poisson(c, 1.0, g, essential=left)
cooled = polydec.poisson(c, 1.0, essential=left, robin=2.0)
assert np.isclose(u.values.max(), 0.0737, atol=1e-3) and cooled.values.max() < 1

darcy = polydec.poisson(c, 1.0, side="dual", conductivity=10.0)
p, flux = darcy.values, darcy.flux
assert np.allclose(c.d(1) @ flux, c.volumes(2))         # exact in every cell

total = c.star(0) @ u.values
size = c.norm(u.values, 0)
slope = polydec.gradient(c, u.values)
error = polydec.poisson_error(msh, u.values, 1.0)

modes = polydec.spectrum(c, essential=True, count=3)
cavity = polydec.spectrum(box, degree=1, essential=True, count=3)
assert modes.certificate.complete

heat = polydec.Evolution(c, u.values, diffusion=1.0, essential=True)
with polydec.Series("heat.pvd", c) as film:
    for t, now in heat.frames([0.01, 0.02]):
        film.add(t, {"u": now})
stokes = polydec.StokesSolver(c, viscosity=1.0, no_slip=True)
polydec.write_vtu("u.vtu", c, {"u": u.values})
ring = polydec.discretize(polydec.periodic(msh, [[1.0, 0.0]]))
assert ring.betti_numbers() == [1, 1, 0] and error.energy < 0.05 and f.shape == u.values.shape
assert slope.shape == (1024, 2) and p.shape == (1024,) and stokes is not None
print(f"integral {total:.4f}, eigenvalue {modes.eigenvalues[0]:.2f}, of the cavity "
      f"{cavity.eigenvalues[0]:.2f}, heat left {c.norm(now, 0) / size:.3f}")
