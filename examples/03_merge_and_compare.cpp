// SPDX-License-Identifier: MIT
//
// A grid of squares, each split by a diagonal, is the simplest mesh on which discrete exterior
// calculus breaks. The two triangles of a square share a circumcircle, so the dual of the diagonal
// has length zero, and the Hodge star of 1-forms is singular. Merging removes the diagonals.
#include <algorithm>
#include <iostream>
#include <polydec.h>

int main() {
    const polydec::Mesh mesh = polydec::grid(4, 4);
    const auto before = polydec::discretize(mesh, {.criterion = polydec::MergeCriterion::none,
                                                   .star = polydec::StarKind::circumcentric});
    const auto after = polydec::discretize(mesh);

    std::cout << "2-cells before: " << before.complex().size(2)
              << ", after: " << after.complex().size(2) << '\n';
    std::cout << "degenerate edges: " << after.degenerate().interior << '\n';

    // boundary edges of the square keep half a dual edge, with star 1/2
    const auto smallest_inside = [](const polydec::Discretization& grid) {
        const polydec::Vector star = polydec::star(grid, 1).diagonal();
        double smallest = star.maxCoeff();
        for (polydec::Index e = 0; e < star.size(); ++e)
            if (grid.complex().coface_counts(1)[e] == 2)
                smallest = std::min(smallest, star[e]);
        return smallest;
    };
    std::cout << "smallest interior star_1 before: " << smallest_inside(before)
              << ", after: " << smallest_inside(after) << '\n';

    // merging preserves topology, area and vertices
    std::cout << "Euler characteristic: " << polydec::euler_characteristic(after.complex())
              << ", area: " << after.volumes().primal(2).sum() << '\n';
}
