// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_fingerprint {

TEST(Fingerprint, KnowsEveryStarOfAMesh) {
    const auto of = [](const Discretization& mesh) { return Fingerprint().add(mesh).value(); };
    const auto mesh = discretize(kuhn(3, 2));
    const Index cells = mesh.complex().size(3);
    EXPECT_EQ(of(mesh), of(discretize(kuhn(3, 2))));
    for (int k = 0; k <= 3; ++k) {
        Vector weights = Vector::Ones(cells);
        const auto same = of(with_material(mesh, k, CellData::on_cells(weights)));
        EXPECT_EQ(of(with_material(mesh, k, CellData::on_cells(weights))), same) << k;
        weights[cells / 2] += 1e-15;
        EXPECT_NE(of(with_material(mesh, k, CellData::on_cells(weights))), same) << k;
    }
    const auto galerkin = discretize(kuhn(3, 2), {.star = StarKind::galerkin});
    EXPECT_NE(of(galerkin), of(mesh));
    EXPECT_NE(of(with_material(galerkin, 1, CellData::on_cells(Vector::Constant(cells, 2)))),
              of(galerkin));
}

TEST(Fingerprint, TellsMeshesApart) {
    const auto of = [](const Mesh& mesh, const DiscretizeOptions& options = {}) {
        return Fingerprint().add(discretize(mesh, options)).value();
    };
    const Mesh mesh = grid(3, 2);
    Mesh moved = mesh;
    moved.points(4, 0) += 1e-15;
    EXPECT_EQ(of(mesh), of(grid(3, 2)));
    for (const auto other : {of(moved), of(grid(2, 3)), of(mesh, {.centers = Centers::centroids()}),
                             of(mesh, {.star = StarKind::galerkin})})
        EXPECT_NE(other, of(mesh));
    EXPECT_NE(Fingerprint().add("ab").add("c").value(), Fingerprint().add("a").add("bc").value());
    EXPECT_NE(Fingerprint().add(0.0).value(), Fingerprint().add(-0.0).value());
}

} // namespace polydec::test::in_fingerprint
