// SPDX-License-Identifier: MIT
#include "tests/distributed/compare.h"

namespace polydec::test::in_warnings {

/// Warnings about cells that lie over each other, and about slits.
std::vector<std::string> about_places(std::vector<std::string> warnings) {
    std::erase_if(warnings, [](const std::string& text) {
        return text.find("the mesh is folded") == text.npos &&
               text.find("overlaps itself") == text.npos && text.find("is slit") == text.npos;
    });
    return warnings;
}

/// Returns how many there are.
std::size_t expect_warnings_of_one_process(const Ranks& ranks, const NamedMesh& given) {
    const auto expected = about_places(circumcentric(given.mesh).warnings());
    for (const Ownership by : some_ownerships(ranks, given.name)) {
        const auto found = about_places(discretized(ranks, given.mesh, by).warnings);
        if (ranks.rank() == 0)
            EXPECT_EQ(found, expected) << given.name;
    }
    return expected.size();
}

Mesh moved(Mesh mesh, double along_first_axis) {
    mesh.points.col(0).array() += along_first_axis;
    return mesh;
}

/// The boundary of one is on the boundary of the other, whose cells are larger.
Mesh side_by_side(int n, int coarse, int fine) {
    return united(kuhn(n, coarse), moved(kuhn(n, fine), 1));
}

/// A disk whose triangles run around vertex 0 twice.
Mesh wound() {
    Mesh mesh{Points::Zero(11, 2), Simplices(10, 3), {}};
    for (Index i = 0; i < 10; ++i) {
        mesh.points.row(1 + i) << std::cos(2 * std::numbers::pi * i / 5),
            std::sin(2 * std::numbers::pi * i / 5);
        mesh.simplices.row(i) << 0, 1 + i, 1 + (i + 1) % 10;
    }
    return mesh;
}

Mesh turned(Mesh mesh) {
    mesh.simplices.col(0).swap(mesh.simplices.col(1));
    return mesh;
}

TEST(DistributedWarnings, of_folds_and_slits_are_those_of_one_process) {
    const auto ranks = Ranks::all();
    constexpr Index most_cells = 4000;
    for (const NamedMesh& mesh : swept(ranks, most_cells))
        expect_warnings_of_one_process(ranks, mesh);

    const Mesh crumpled = perturbed(grid(9, 7), 0.9, 3);
    Mesh lifted = crumpled;
    lifted.points.conservativeResize(Eigen::NoChange, 3);
    lifted.points.col(2).setConstant(-3.5);
    Mesh mirrored = turned(kuhn(3, 1));
    mirrored.points.col(1) = (1 - mirrored.points.col(1).array()).matrix();
    const std::vector<NamedMesh> faulty = {
        {"half of a line", made_of({{0}, {1}, {0.5}}, {{0, 1}, {1, 2}})},
        {"crumpled", crumpled},
        {"crumpled in space", lifted},
        {"crumpled cubes", perturbed(kuhn(3, 3), 0.4, 5)},
        {"crumpled tesseracts", perturbed(kuhn(4, 1), 0.9, 7)},
        {"two crumpled parts",
         united(perturbed(grid(6, 6), 0.6, 2), turned(moved(perturbed(grid(5, 5), 0.6, 4), 40)))},
        {"very large", transformed(crumpled, DenseMatrix::Identity(2, 2), 1e90)},
        {"wound", wound()},
        {"three at an edge", made_of({{0, 0}, {1, 0}, {0.5, 1}, {0.5, -1}, {0.5, 2}},
                                     {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}})},
        {"slit", side_by_side(2, 4, 4)},
        {"slit cubes", side_by_side(3, 2, 2)},
        {"slit sphere", united(uv_sphere(8, 6), uv_sphere(8, 6))},
        {"hanging", side_by_side(2, 2, 4)},
        {"hanging in cubes", side_by_side(3, 1, 2)},
        {"hanging, far away", moved(side_by_side(2, 2, 4), 1e4)},
        {"other diagonals", united(kuhn(3, 1), moved(mirrored, 1))},
    };
    std::size_t count = 0;
    for (const NamedMesh& mesh : faulty)
        count += expect_warnings_of_one_process(ranks, mesh);
    EXPECT_GE(count, faulty.size());
}

} // namespace polydec::test::in_warnings
