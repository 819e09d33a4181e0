# SPDX-License-Identifier: MIT
"""Discrete exterior calculus breaks on a grid of squares, each split by a diagonal: the dual of the
diagonal has length zero. Merging removes the diagonals."""
import polydec

mesh = polydec.meshes.grid(4, 4)
before = polydec.discretize(mesh, merge=False, star="circumcentric")
after = polydec.discretize(mesh)

print(f"2-cells before: {before.size(2)}, after: {after.size(2)}")
print(f"degenerate edges: {after.report()['facets']['degenerate']}")


def smallest_inside(grid: polydec.Complex) -> float:
    """Boundary edges of the square keep half a dual edge, with star 1/2."""
    smallest: float = grid.star(1)[~grid.boundary_facets()].min()
    return smallest


print(f"smallest interior star_1 before: {smallest_inside(before):g}, "
      f"after: {smallest_inside(after):g}")

# merging preserves topology, area and vertices
euler = sum((-1) ** k * cells for k, cells in enumerate(after.shape))
print(f"Euler characteristic: {euler}, area: {after.volumes(2).sum():g}")
