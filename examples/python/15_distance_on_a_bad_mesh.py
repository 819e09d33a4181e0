# SPDX-License-Identifier: MIT
"""The distance along a badly triangulated surface, exact and by the heat method, without and with
intrinsic Delaunay flips. Only the heat method depends on the triangles. The mesh is the side of a
drill: a square grid around a prism, with helical triangles. Flips recover the squares."""
import numpy as np

import polydec

AROUND, ROWS, STEEP = 256, 80, 8
SIDE = 2 * np.sin(np.pi / AROUND)


def number(i: int, j: int) -> int:
    return i % AROUND * (ROWS + 1) + j


def drill() -> polydec.Mesh:
    """Walks up both rims of each side, the right rim STEEP points ahead where possible."""
    triangles = []
    for i in range(AROUND):
        left = right = 0
        while left + right < 2 * ROWS:
            ahead = right < min(left + STEEP, ROWS)
            triangles.append((number(i, left), number(i + 1, right),
                              number(i + 1, right + 1) if ahead else number(i, left + 1)))
            left, right = (left, right + 1) if ahead else (left + 1, right)
    angles = 2 * np.pi * np.repeat(np.arange(AROUND), ROWS + 1) / AROUND
    heights = SIDE * np.tile(np.arange(ROWS + 1), AROUND)
    return polydec.Mesh(np.column_stack([np.cos(angles), np.sin(angles), heights]), triangles)


i, j = np.divmod(np.arange(AROUND * (ROWS + 1)), ROWS + 1)
unrolled = np.hypot(SIDE * np.minimum(i, AROUND - i), SIDE * (j - ROWS // 2))

before = polydec.discretize(drill())
after = polydec.discretize(drill(), delaunay="flips")
done = after.report()["intrinsic"]
print(f"{done['negative_before']} of {before.input.size(1)} edges have a negative dual; after "
      f"{done['flips']} flips {done['negative']} have")
print(f"{before.input.size(2)} triangles merge into {before.size(2)} polygons, after the flips into "
      f"{after.size(2)}")

for name, surface in (("without", before), ("with", after)):
    exact = polydec.geodesic_distance(surface, number(0, ROWS // 2))
    heat = polydec.geodesic_distance(surface, number(0, ROWS // 2), method="heat")
    print(f"{name} flips: distances up to {exact.max():g}, mean error "
          f"{abs(exact - unrolled).mean():.1g}, of heat {abs(heat - unrolled).mean():g}")
    polydec.view(surface, {"distance": heat}, title=f"Distance by heat {name} flips").save(
        f"distance_{name}.html")
