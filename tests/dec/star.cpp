// SPDX-License-Identifier: MIT
#include "dec/forms/star.h"

#include "base/errors.h"
#include "tests/support/matrices.h"
#include "tests/support/over_meshes.h"
#include "tests/support/refusal.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace polydec::test {
namespace {

class Stars : public OverMeshes {};

double sign(int n, int k) {
    return k * (n - k) % 2 == 0 ? 1 : -1;
}

bool invertible(const CellVolumes& volumes, int k) {
    return zero_star_cells(volumes, k).empty();
}

TEST_P(Stars, twice_is_a_sign) {
    for (const auto& [name, complex, volumes] : both(mesh()))
        for (int k = 0; k <= mesh().n(); ++k) {
            if (!invertible(volumes, k))
                continue;
            const Vector twice = dual_star(volumes, k).cwiseProduct(star(volumes, k));
            const Vector expected = Vector::Constant(complex.size(k), sign(mesh().n(), k));
            EXPECT_LE(relative_difference(twice, expected), 1e-14) << name << ", k = " << k;
        }
}

TEST_P(Stars, and_their_inverses_are_no_dual_stars_where_the_sign_is_negative) {
    for (int k = 0; k <= mesh().n(); ++k)
        if (invertible(mesh().volumes, k)) {
            const bool same = relative_difference(inverse_star(mesh().volumes, k),
                                                  dual_star(mesh().volumes, k)) == 0;
            EXPECT_EQ(same, sign(mesh().n(), k) > 0) << "k = " << k;
        }
}

TEST_P(Stars, refuse_to_be_inverted_where_they_are_zero) {
    for (const auto& [name, complex, volumes] : both(mesh()))
        for (int k = 0; k <= mesh().n(); ++k)
            if (!invertible(volumes, k)) {
                EXPECT_THROW(inverse_star(volumes, k), InvalidInput) << name << ", k = " << k;
                EXPECT_THROW(dual_star(volumes, k), InvalidInput) << name << ", k = " << k;
            }
}

TEST_P(Stars, are_zero_positive_or_negative) {
    for (const auto& [name, complex, volumes] : both(mesh()))
        for (int k = 0; k <= mesh().n(); ++k) {
            const Vector values = star(volumes, k);
            const auto zero = zero_star_cells(volumes, k),
                       negative = negative_star_cells(volumes, k);
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
    const SparseMatrix areas = dia * inverse_star(mesh.input_volumes, mesh.n()).asDiagonal() *
                               SparseMatrix(dia.transpose());
    return Vector(areas.diagonal()).cwiseInverse();
}

/// dia star_n dia^T, as printed in Schier's paper.
Vector star_of_tops_as_a_sum(const Merged& mesh) {
    const SparseMatrix dia = mesh.merging().diamond(mesh.n()).cast<double>();
    const SparseMatrix sum =
        dia * star(mesh.input_volumes, mesh.n()).asDiagonal() * SparseMatrix(dia.transpose());
    return sum.diagonal();
}

TEST_P(Stars, of_merged_top_cells_come_from_areas_that_add) {
    const Vector expected = star(mesh().volumes, mesh().n());
    EXPECT_LE(relative_difference(star_of_tops(mesh()), expected), 1e-12);
    const bool merges = mesh().K().size(mesh().n()) > mesh().P().size(mesh().n());
    EXPECT_EQ(relative_difference(star_of_tops_as_a_sum(mesh()), expected) > 0.1, merges);
}

POLYDEC_OVER_MESHES(Stars);

TEST(StarErrors, name_the_cells_whose_duals_are_zero) {
    // each square of the cube's boundary is four triangles around its middle
    const auto& mesh = merged("fcc1");
    std::vector<Index> boundary;
    for (Index f = 0; f < mesh.P().size(2); ++f)
        if (mesh.P().coface_counts(2)[f] == 1)
            boundary.push_back(f);
    EXPECT_EQ(zero_star_cells(mesh.volumes, 2), boundary);
    ASSERT_EQ(boundary.size(), 24U);
    EXPECT_EQ(refusal([&] { inverse_star(mesh.volumes, 2); }),
              fmt::format("the inverse star of degree 2 divides by zero: the duals of 24 2-cells "
                          "have no volume (cells {}, {}, {}, {}, {}, ..)",
                          boundary[0], boundary[1], boundary[2], boundary[3], boundary[4]));
}

TEST(StarErrors, negative_stars_are_counted_where_they_are) {
    const auto& mesh = merged("star_negative");
    EXPECT_EQ(negative_star_cells(mesh.volumes, 0), (std::vector<Index>{0}));
    EXPECT_TRUE(negative_star_cells(merged("wellcentred4").volumes, 1).empty());
    EXPECT_FALSE(negative_star_cells(merged("obtuse_planar").volumes, 1).empty());
}

} // namespace
} // namespace polydec::test
