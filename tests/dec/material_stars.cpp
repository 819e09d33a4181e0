// SPDX-License-Identifier: MIT
#include "tests/support/all_sizes.h"
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
    for (const Mesh& given : {mesh_named("obtuse_planar"), shaken(grid(6, 6), 0.2, 1),
                              mesh_named("hex4"), mesh_named("kuhn3"), mesh_named("icosphere3")})
        for (const auto kind : {StarKind::circumcentric, StarKind::galerkin, StarKind::hybrid,
                                StarKind::barycentric, StarKind::automatic}) {
            const auto mesh = circumcentric(given);
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

/// A constant dual (n-k)-form, and what flats, products and vectors make of constants.
Vector of_constants(const Discretization& mesh, int k) {
    const int n = mesh.dimension(), j = n - k;
    const Index N = mesh.ambient_dimension();
    const Cochain form = dual_de_rham(mesh, j, constant_form(random_vector(coefficients(N, j), 3)));
    std::vector<Vector> all{form.values};
    if (mesh.geometric_star(k).zeros().empty()) {
        const Cochain one{Side::dual, 0, Vector::Ones(mesh.complex().size(n))};
        all.push_back(dual_wedge(mesh, one, form).values);
        all.push_back(vectors_at_cells(mesh, form).reshaped());
    }
    if (j == 1) {
        const Vector X = random_vector(N, 4);
        const auto everywhere = [&](int degree) -> DenseMatrix {
            return X.transpose().replicate(mesh.complex().size(degree), 1);
        };
        all.push_back(flat(mesh, Flat::pdd, everywhere(0)).values);
        all.push_back(flat(mesh, Flat::dpd, everywhere(n)).values);
    }
    return joined(all);
}

TEST(Materials, leave_the_forms_and_vectors_of_smooth_fields_alone) {
    for (const Discretization& mesh : of_all_kinds())
        for (int k = 0; k <= mesh.dimension(); ++k) {
            const Vector ones = Vector::Ones(mesh.complex().size(mesh.dimension()));
            const auto empty = with_material(mesh, k, CellData::on_cells(ones)),
                       heavy = with_material(mesh, k, any_weights(mesh, 1));
            SCOPED_TRACE(fmt::format("{} stars, k = {}", name(mesh.chosen_stars().kind), k));
            EXPECT_CLOSE(of_constants(heavy, k), of_constants(empty, k), 1e-10);
            if (mesh.stars()[k].is_diagonal()) {
                EXPECT_EQ(of_constants(heavy, k), of_constants(mesh, k));
            }
        }
}

TEST(Materials, weight_the_energies_of_constant_dual_forms) {
    for (const Discretization& mesh : of_all_kinds()) {
        const int n = mesh.dimension();
        const auto kind = mesh.chosen_stars().kind;
        const bool are_exact = kind == StarKind::galerkin || kind == StarKind::hybrid;
        if (!are_exact || mesh.ambient_dimension() > n)
            continue;
        const double volume = mesh.volumes().primal(n).sum();
        for (int k = 1; k <= n; ++k) {
            const Vector a = random_vector(coefficients(n, n - k), 3),
                         quarters = Vector::Constant(mesh.complex().size(n), 0.25);
            const auto light = with_material(mesh, k, CellData::on_cells(quarters));
            const double length = norm(light, dual_de_rham(light, n - k, constant_form(a)));
            EXPECT_NEAR(length * length / (4 * a.squaredNorm() * volume), 1, 1e-9)
                << name(kind) << " stars, k = " << k;
        }
    }
}

TEST(Materials, of_facets_make_all_cells_galerkins_beside_hybrid_stars) {
    const auto mesh = circumcentric(shaken(grid(6, 6), 0.2, 1)).with_stars(StarKind::hybrid);
    const double share = mesh.chosen_stars().galerkin_share();
    ASSERT_GT(share, 0);
    ASSERT_LT(share, 1);
    const auto of_facets = with_material(mesh, 1, any_weights(mesh, 1)),
               of_vertices = with_material(mesh, 0, any_weights(mesh, 2)),
               both = with_material(of_facets, 0, any_weights(mesh, 2));
    EXPECT_EQ(of_facets.chosen_stars().galerkin_share(), 1);
    EXPECT_EQ(of_vertices.chosen_stars().galerkin_share(), share);
    expect_same_stars(both, of_vertices, 0);
    EXPECT_WITHIN(dual_sites(of_facets), cell_centroids(mesh, 2), 1e-14);
}

} // namespace polydec::test::in_material_stars
