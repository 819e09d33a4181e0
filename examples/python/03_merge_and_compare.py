# SPDX-License-Identifier: MIT
"""On a grid of squares, each split by a diagonal, discrete exterior calculus breaks: the dual of the
diagonal has length zero. Merging takes the diagonals out."""
import polydec

mesh = polydec.meshes.grid(4, 4)
before = polydec.discretize(mesh, merge=False, star="circumcentric")
after = polydec.discretize(mesh)

print(f"2-cells before: {before.size(2)}, after: {after.size(2)}")
print(f"degenerate edges: {after.report()['facets']['degenerate']}")


def smallest_inside(grid: polydec.Complex) -> float:
    """The boundary of the square keeps its half dual edges, of star 1/2."""
    smallest: float = grid.star(1)[~grid.boundary_facets()].min()
    return smallest


print(f"smallest interior star_1 before: {smallest_inside(before):g}, "
      f"after: {smallest_inside(after):g}")

# all that was between cells is still there: topology, area, vertices
euler = sum((-1) ** k * cells for k, cells in enumerate(after.shape))
print(f"Euler characteristic: {euler}, area: {after.volumes(2).sum():g}")
