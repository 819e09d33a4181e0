// SPDX-License-Identifier: MIT
#include "dec/overlay.h"

#include "dec/strand_places.h"
#include "dec/transfer.h"
#include "meshes/generate.h"
#include "tests/support/families.h"
#include "tests/support/glued.h"
#include "tests/support/matrices.h"
#include "tests/support/over_meshes.h"
#include "tests/support/refusal.h"

#include <gtest/gtest.h>

namespace polydec::test {
namespace {

class Overlays : public testing::TestWithParam<std::string> {
protected:
    Discretization mesh(Delaunay delaunay = Delaunay::flips_and_splits) const {
        return discretize(shaken(mesh_named(GetParam()), 0.25, 7), {.delaunay = delaunay});
    }
};

Vector sums(const std::vector<Index>& groups, const Vector& values, Eigen::Index size) {
    Vector result = Vector::Zero(size);
    for (std::size_t i = 0; i < groups.size(); ++i)
        result[groups[i]] += values[static_cast<Eigen::Index>(i)];
    return result;
}

TEST_P(Overlays, cut_both_triangulations_into_the_same_pieces) {
    for (const auto delaunay : {Delaunay::flips, Delaunay::flips_and_splits}) {
        const auto mesh = this->mesh(delaunay);
        const Overlay pieces = overlay(mesh);
        const Vector& input = mesh.input_volumes.primal[2];
        const Vector& flipped = mesh.intrinsic->triangle_volumes.primal[2];
        EXPECT_LT(relative_difference(sums(pieces.input, pieces.areas, input.size()), input), 1e-9);
        EXPECT_LT(relative_difference(sums(pieces.triangle, pieces.areas, flipped.size()), flipped),
                  1e-9);
    }
}

TEST_P(Overlays, have_strands_whose_crossings_ascend) {
    const auto mesh = this->mesh();
    const auto& T = mesh.intrinsic->delaunay;
    const Strands strands = trace(T.surface, T.crossings);
    const auto places = strand_places(T.surface, T.lengths, strands);
    for (std::size_t s = 0; s < strands.ends.size(); ++s)
        for (std::size_t c = strands.offsets[s]; c < strands.offsets[s + 1]; ++c) {
            EXPECT_GT(places[c], c == strands.offsets[s] ? 0 : places[c - 1]);
            EXPECT_LT(places[c], 1);
        }
}

TEST_P(Overlays, bring_functions_of_cells_back_as_means) {
    const auto mesh = this->mesh();
    const Index cells = mesh.complex().size(2);
    const Cochain ones{Side::dual, 0, Vector::Ones(cells)};
    EXPECT_LT(relative_difference(to_input(mesh, ones).values, Vector::Ones(mesh.input().size(2))),
              1e-12);
    const Vector u = random_vector(cells, 2);
    const Vector means = to_input(mesh, {Side::dual, 0, u}).values;
    EXPECT_LE(means.maxCoeff(), u.maxCoeff() + 1e-12);
    EXPECT_NEAR(means.dot(mesh.input_volumes.primal[2]), u.dot(mesh.volumes.primal[2]),
                1e-9 * mesh.volumes.primal[2].sum());
}

TEST_P(Overlays, know_what_crosses_by_integers_that_one_missed_flip_spoils) {
    const auto mesh = this->mesh(Delaunay::flips);
    const auto& T = mesh.intrinsic->delaunay;
    if (T.statistics.flips == 0)
        return;
    const NormalCoordinates ignorant(T.surface);
    EXPECT_LT(trace(T.surface, ignorant).ends.size(), trace(T.surface, T.crossings).ends.size());
}

INSTANTIATE_TEST_SUITE_P(Family, Overlays, testing::ValuesIn(names_of_surfaces()), parameter_name);

TEST(Overlay, is_refused_without_flips) {
    EXPECT_EQ(refusal([] { overlay(discretize(grid(2, 2))); }),
              "an overlay is of the input's triangles and those after flips, but no edges were "
              "flipped: ask for it by MergeOptions::delaunay");
}

} // namespace
} // namespace polydec::test
