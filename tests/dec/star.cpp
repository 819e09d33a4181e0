// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_star {

class Stars : public OverMeshes {};

double sign(int n, int k) {
    return k * (n - k) % 2 == 0 ? 1 : -1;
}

bool invertible(const CellVolumes& volumes, int k) {
    return star(volumes, k).zeros().empty();
}

TEST_P(Stars, and_their_inverses_alone_are_the_identity) {
    for (int k = 0; k <= mesh().n(); ++k)
        if (invertible(mesh().volumes, k)) {
            const auto all = star(mesh().volumes, k);
            const Vector ones = Vector::Ones(all.size());
            EXPECT_CLOSE(all.solve(all * ones), ones, 1e-14) << "k = " << k;
            EXPECT_EQ(all.solve(ones), all.inverse()) << "k = " << k;
            const auto dual =
                star({mesh().P(), mesh().volumes}, Cochain{Side::dual, mesh().n() - k, ones});
            EXPECT_EQ(relative_difference(dual.values, all.inverse()) == 0, sign(mesh().n(), k) > 0)
                << "k = " << k;
        }
}

TEST_P(Stars, are_matrices_and_what_they_do_to_values) {
    for (const auto& [name, complex, volumes] : both(mesh()))
        for (int k = 0; k <= mesh().n(); ++k) {
            const auto all = star(volumes, k);
            const Vector x = Vector::LinSpaced(all.size(), -1, 2);
            EXPECT_EQ(all.degree(), k);
            EXPECT_EQ(all.size(), complex.size(k));
            EXPECT_EQ(Vector(all.matrix() * x), all * x) << name << ", k = " << k;
            EXPECT_EQ(Vector(all.matrix().diagonal()), all.diagonal()) << name << ", k = " << k;
            if (all.size() > 1) { // or it may be the identity
                EXPECT_NE(Vector(all.matrix() * (2 * x)), all * x) << name << ", k = " << k;
            }
            EXPECT_THROW(all * Vector::Ones(all.size() + 1), InvalidInput);
            EXPECT_THROW(all.solve(Vector::Ones(all.size() + 1)), InvalidInput);
            EXPECT_TRUE((all.uncertainty().array() >= 0).all());
        }
    EXPECT_THROW(star(mesh().volumes, -1), InvalidInput);
    EXPECT_THROW(star(mesh().volumes, mesh().n() + 1), InvalidInput);
}

TEST_P(Stars, refuse_to_be_inverted_where_they_are_zero) {
    for (const auto& [name, complex, volumes] : both(mesh()))
        for (int k = 0; k <= mesh().n(); ++k)
            if (!invertible(volumes, k)) {
                EXPECT_THROW(star(volumes, k).inverse(), InvalidInput) << name << ", k = " << k;
                EXPECT_THROW(star(volumes, k).solve(Vector::Ones(complex.size(k))), InvalidInput);
            }
}

TEST_P(Stars, are_zero_positive_or_negative) {
    for (const auto& [name, complex, volumes] : both(mesh()))
        for (int k = 0; k <= mesh().n(); ++k) {
            const Vector values = star(volumes, k).diagonal();
            const auto zero = star(volumes, k).zeros(), negative = star(volumes, k).negatives();
            for (Index s = 0; s < values.size(); ++s) {
                const bool is_zero = std::binary_search(zero.begin(), zero.end(), s);
                const bool is_negative = std::binary_search(negative.begin(), negative.end(), s);
                EXPECT_FALSE(is_zero && is_negative);
                EXPECT_TRUE(is_zero || (values[s] < 0) == is_negative);
            }
        }
}

/// (dia star_n^-1 dia^T)^-1: areas add.
Vector star_of_tops(const Merged& mesh) {
    const SparseMatrix dia = mesh.merging().diamond(mesh.n()).cast<double>();
    const SparseMatrix areas = dia * star(mesh.input_volumes, mesh.n()).inverse().asDiagonal() *
                               SparseMatrix(dia.transpose());
    return Vector(areas.diagonal()).cwiseInverse();
}

/// dia star_n dia^T, as printed in Schier's paper.
Vector star_of_tops_as_a_sum(const Merged& mesh) {
    const SparseMatrix dia = mesh.merging().diamond(mesh.n()).cast<double>();
    const SparseMatrix sum = dia * star(mesh.input_volumes, mesh.n()).diagonal().asDiagonal() *
                             SparseMatrix(dia.transpose());
    return sum.diagonal();
}

TEST_P(Stars, of_merged_top_cells_come_from_areas_that_add) {
    const Vector expected = star(mesh().volumes, mesh().n()).diagonal();
    EXPECT_CLOSE(star_of_tops(mesh()), expected, 1e-12);
    const bool merges = mesh().K().size(mesh().n()) > mesh().P().size(mesh().n());
    EXPECT_EQ(relative_difference(star_of_tops_as_a_sum(mesh()), expected) > 0.1, merges);
}

POLYDEC_OVER_MESHES(Stars);

TEST(StarsOfNoCells, are_empty_matrices) {
    const CellVolumes none(std::vector<Vector>(2), std::vector<Vector>(2));
    const HodgeStar empty = star(none, 1);
    EXPECT_EQ(empty.size(), 0);
    EXPECT_EQ(empty.matrix().rows(), 0);
    EXPECT_EQ(empty.matrix().cols(), 0);
    EXPECT_EQ((empty * Vector()).size(), 0);
    EXPECT_EQ(empty.solve(Vector()).size(), 0);
}

TEST(StarErrors, name_the_cells_whose_duals_are_zero) {
    // each square of the cube's boundary is four triangles around its middle
    const auto& mesh = merged("fcc1");
    std::vector<Index> boundary;
    for (Index f = 0; f < mesh.P().size(2); ++f)
        if (mesh.P().coface_counts(2)[f] == 1)
            boundary.push_back(f);
    EXPECT_EQ(star(mesh.volumes, 2).zeros(), boundary);
    ASSERT_EQ(boundary.size(), 24U);
    EXPECT_REFUSED(star(mesh.volumes, 2).inverse(), "inverse star", "degree 2", "zero",
                   "24 2-cells",
                   fmt::format("{}, {}, {}, {}, {}", boundary[0], boundary[1], boundary[2],
                               boundary[3], boundary[4]));
}

TEST(StarErrors, matrices_fit_their_cells_and_are_symmetric_and_definite) {
    const CellVolumes volumes = merged("wellcentred4").volumes;
    const CellComplex complex = merged("wellcentred4").P();
    const Index size = star(volumes, 1).size();
    SparseMatrix M(size, size);
    M.setIdentity();
    M.coeffs() *= 2;
    const HodgeStar twice(volumes, 1, M);
    const Vector x = Vector::LinSpaced(size, -1, 3);
    EXPECT_EQ(twice * x, 2 * x);
    EXPECT_CLOSE(twice.solve(2 * x), x, 1e-14);
    EXPECT_TRUE(twice.zeros().empty() && twice.negatives().empty());
    EXPECT_REFUSED(twice.diagonal(), "star", "1-cells", "matrix", "diagonal star");
    EXPECT_THROW(twice.uncertainty(), InvalidInput);
    EXPECT_THROW(twice.inverse(), InvalidInput);
    const HodgeStars stars = HodgeStars(volumes).with(1, M);
    EXPECT_FALSE(stars[1].is_diagonal());
    EXPECT_TRUE(stars[0].is_diagonal() && stars[2].is_diagonal());

    EXPECT_REFUSED(HodgeStar(volumes, 2, M), "rows", "star", "2-cells");
    M.coeffRef(0, 1) = 0.5;
    EXPECT_REFUSED(HodgeStar(volumes, 1, M), "star", "1-cells", "row 0", "column 1", "0.5", "0",
                   "symmetric");
    M.coeffRef(1, 0) = 0.5;
    EXPECT_NO_THROW(HodgeStar(volumes, 1, M));
    for (const double entry : {std::nan(""), -1.0, 0.0}) {
        M.coeffRef(0, 0) = entry;
        const auto on_diagonal = fmt::format("entry 0 on the diagonal is {}", entry);
        const auto made = [&] { Cells(complex, HodgeStars(volumes).with(1, M)); };
        EXPECT_REFUSED(made(), "star", "1-cells", "definite");
        if (entry == 0)
            EXPECT_REFUSED(made(), on_diagonal);
    }
    M.coeffRef(0, 0) = 0.01; // indefinite with the entries beside it
    EXPECT_REFUSED(HodgeStar(volumes, 1, M).solve(x), "star", "1-cells", "1 negative");
}

TEST(StarErrors, negative_stars_are_counted_where_they_are) {
    const auto& mesh = merged("star_negative");
    EXPECT_EQ(star(mesh.volumes, 0).negatives(), (std::vector<Index>{0}));
    EXPECT_TRUE(star(merged("wellcentred4").volumes, 1).negatives().empty());
    EXPECT_FALSE(star(merged("obtuse_planar").volumes, 1).negatives().empty());
}

} // namespace polydec::test::in_star
