# SPDX-License-Identifier: MIT
"""A rod heated along its length, cold at one end, with heat loss u' + 2 u = 0 at the other: u = x
(2/3 - x/2)."""
import polydec

rod = polydec.discretize(polydec.meshes.kuhn([50]))
x = rod.points[:, 0]
u = polydec.poisson(rod, 1.0, essential=lambda at: at[:, 0] < 0.5, robin=2.0).values
exact = abs(u - x * (2 / 3 - x / 2)).max() < 1e-12
print(f"at the end {u[-1]:g}, exact to 1e-12: {'yes' if exact else 'no'}")
