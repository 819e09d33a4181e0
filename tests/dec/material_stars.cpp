// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_material_stars {

TEST(MaterialStars, of_1_are_those_of_galerkin) {
    for (const char* title : {"obtuse_planar", "hex4", "kuhn3", "split_cubes", "segments4"}) {
        const auto mesh = circumcentric(mesh_named(title));
        const int n = mesh.dimension();
        const auto stars = mesh.with_stars(StarKind::galerkin).stars();
        const Vector ones = Vector::Ones(mesh.complex().size(n));
        for (int k = 0; k < n; ++k)
            EXPECT_CLOSE(material_star(mesh, k, CellData::on_cells(ones)), stars[k].matrix(), 1e-13)
                << title;
        const std::vector<DenseMatrix> tensors(mesh.input().size(n),
                                               2 * DenseMatrix::Identity(n, n));
        EXPECT_CLOSE(material_star(mesh, tensors), SparseMatrix(stars[n - 1].matrix() / 2), 1e-12)
            << title;
    }
}

TEST(MaterialStars, refuse_what_is_no_conductivity) {
    const auto mesh = circumcentric(grid(2, 2));
    std::vector<DenseMatrix> tensors(8, DenseMatrix::Identity(2, 2));
    tensors[2](0, 1) = 1;
    EXPECT_REFUSED(material_star(mesh, tensors), "conductivity", "2-cell 2", "2 x 2", "symmetric");
    EXPECT_REFUSED(material_star(mesh, 1, CellData::on_cells(Eigen::Vector4d(1, 0, 1, 1))),
                   "weight", "2-cell 1", "0");
    const auto sphere = circumcentric(icosphere(1));
    EXPECT_REFUSED(material_star(sphere, std::vector<DenseMatrix>(sphere.complex().size(2),
                                                                  DenseMatrix::Identity(2, 2))),
                   "number", "cell");
}

void expect_same_stars(const Discretization& found, const Discretization& expected, int k) {
    EXPECT_CLOSE(found.stars()[k].matrix(), expected.stars()[k].matrix(), 0);
    EXPECT_EQ(found.stars()[k].zeros(), expected.stars()[k].zeros());
    const CellVolumes &a = found.stars().volumes(), &b = expected.stars().volumes();
    EXPECT_EQ(a.terms(k).vector(), b.terms(k).vector());
    EXPECT_EQ(a.rounding(k).vector(), b.rounding(k).vector());
}

/// Meshes with stars of each kind that there is in their dimension.
std::vector<Discretization> of_all_kinds() {
    std::vector<Discretization> result;
    for (const char* title : {"obtuse_planar", "hex4", "kuhn3", "icosphere3"})
        for (const auto kind : {StarKind::circumcentric, StarKind::galerkin, StarKind::hybrid,
                                StarKind::barycentric, StarKind::automatic}) {
            const auto mesh = circumcentric(mesh_named(title));
            if (kind != StarKind::hybrid || mesh.dimension() == 2)
                result.push_back(mesh.with_stars(kind));
        }
    return result;
}

CellData any_weights(const Discretization& mesh, unsigned seed) {
    const Vector random = random_vector(mesh.complex().size(mesh.dimension()), seed);
    return CellData::on_cells(1.1 + random.array());
}

TEST(Materials, replace_the_former_one_of_their_degree_alone) {
    for (const Discretization& mesh : of_all_kinds())
        for (int k = 0; k <= mesh.dimension(); ++k) {
            const auto first = with_material(mesh, k, any_weights(mesh, 1)),
                       second = with_material(first, k, any_weights(mesh, 2)),
                       only = with_material(mesh, k, any_weights(mesh, 2));
            for (int j = 0; j <= mesh.dimension(); ++j) {
                expect_same_stars(second, only, j);
                if (j != k)
                    expect_same_stars(second, mesh, j);
            }
            EXPECT_GT(relative_difference(first.stars()[k].matrix(), only.stars()[k].matrix()), 0.1)
                << k;
        }
}

TEST(Materials, near_1_have_stars_near_those_of_1) {
    for (const Discretization& mesh : of_all_kinds())
        for (const Side side : {Side::primal, Side::dual}) {
            const int n = mesh.dimension(), degree = side == Side::primal ? n - 1 : n - 2;
            const int k = cell_degree(mesh.complex(), side, degree),
                      of_B = side == Side::primal ? k + 1 : k - 1;
            const auto heavy = with_material(with_material(mesh, k, any_weights(mesh, 1)), of_B,
                                             any_weights(mesh, 2));
            const auto filled = [&](double weight) {
                const Vector weights = Vector::Constant(mesh.complex().size(n), weight);
                return with_electric_material(heavy, side, degree, CellData::on_cells(weights));
            };
            const auto one = filled(1), near = filled(1 + 1e-9), half = filled(0.5);
            EXPECT_CLOSE(near.stars()[k].matrix(), one.stars()[k].matrix(), 1e-8);
            EXPECT_GT(relative_difference(half.stars()[k].matrix(), one.stars()[k].matrix()), 0.1);
            expect_same_stars(one, heavy, of_B); // no permeability is given
        }
}

TEST(Materials, multiply_diagonal_stars_of_ones_own_and_refuse_matrices) {
    const auto mesh = circumcentric(kuhn(3, 2));
    const auto own = mesh.with_stars(mesh.stars());
    const auto of = [&](double weight) {
        return CellData::on_cells(Vector::Constant(mesh.complex().size(3), weight));
    };
    for (int k = 0; k <= 3; ++k) {
        const auto six = with_material(with_material(own, k, of(2)), k, of(3));
        EXPECT_CLOSE(six.stars()[k].matrix(), SparseMatrix(6 * mesh.stars()[k].matrix()), 1e-14);
        const auto by_matrix = mesh.with_star(k, mesh.stars()[k].matrix());
        EXPECT_REFUSED(with_material(by_matrix, k, of(2)), "your own", "matrix", "material_star");
    }
}

} // namespace polydec::test::in_material_stars
