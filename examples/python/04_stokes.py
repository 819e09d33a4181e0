# SPDX-License-Identifier: MIT
"""Stokes' theorem, to the last digit: the integral of dw over a region equals the integral of w
over its boundary, on any mesh, before and after merging."""
import numpy as np

import polydec

sphere = polydec.discretize(polydec.meshes.uv_sphere(24, 12))

# the circulation of (-y, x, 0), with curl 2 along the axis
w = polydec.de_rham(sphere, 1, lambda p: np.column_stack([-p[:, 1], p[:, 0], 0 * p[:, 2]]))

# the northern hemisphere as a chain of merged cells
north = (sphere.centers(2)[:, 2] > 0).astype(float)

inside = (sphere.d(1) @ w) @ north
along = w @ (sphere.boundary(2) @ north)
print(f"integral of dw over the north: {inside:g}")
print(f"integral of w along the equator: {along:g}")
print(f"difference {'0' if abs(inside - along) < 1e-13 else 'not 0'}, "
      f"on the round sphere both are {2 * np.pi:g}")
