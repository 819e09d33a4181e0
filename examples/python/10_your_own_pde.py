# SPDX-License-Identifier: MIT
"""A PDE without a solver in the library: heat diffuses on a sphere while a wind carries it around,
du/dt = - L_X u - nu Delta u. A step is explicit in transport and implicit in diffusion."""
import numpy as np
from scipy.sparse import diags
from scipy.sparse.linalg import splu

import polydec

sphere = polydec.discretize(polydec.meshes.uv_sphere(32, 16))
nu, dt = 0.05, 0.02

# a wind around the axis, given at the vertices
x, y, z = sphere.points.T
wind = np.column_stack([-y, x, 0 * z])
transport = polydec.lie_derivative(sphere, wind, 0, sampling="upwind")

# (star_0 + dt nu d^T star_1 d) u_new = star_0 (u - dt L_X u), factorized once
mass = sphere.star(0)
implicit = splu((diags(mass) + dt * nu * sphere.stiffness(0)).tocsc())

u = (x > 0.8).astype(float) # a hot spot
begin = mass @ u / mass.sum()
times, film = [], []
for step in range(101):
    if step % 4 == 0:
        times.append(dt * step)
        film.append(u)
    u = implicit.solve(mass * (u - dt * (transport @ u)))
print(f"temperature from {u.min():g} to {u.max():g}, mean {mass @ u / mass.sum():g} "
      f"after {begin:g}")
print("still between 0 and 1:", "yes" if u.min() > 0 and u.max() < 1 else "no")

polydec.view(sphere, {"temperature": np.column_stack(film)}, times=times,
             title="A hot spot, blown around a sphere").save("temperature.html")
