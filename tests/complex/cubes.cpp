// SPDX-License-Identifier: MIT
#include "complex/blocks.h"
#include "tests/complex/labels.h"

namespace polydec::test::in_cubes {

using Box = std::vector<std::pair<Index, Index>>; // by axis: least and largest coordinate

/// Kuhn grids of unit cubes, which have to merge to the complex of these cubes.
class KuhnGrids : public testing::TestWithParam<std::vector<int>> {
protected:
    const std::vector<int>& cells() const { return GetParam(); }
    int n() const { return static_cast<int>(cells().size()); }

    Mesh mesh() const { return kuhn(cells(), {cells().begin(), cells().end()}); }

    Box box(const std::vector<Index>& vertices) const {
        Box result(cells().size(), {cells().size() * 100, -1});
        for (Index v : vertices)
            for (std::size_t axis = cells().size(); axis-- > 0; v /= cells()[axis] + 1) {
                const Index x = v % (cells()[axis] + 1);
                result[axis].first = std::min(result[axis].first, x);
                result[axis].second = std::max(result[axis].second, x);
            }
        return result;
    }

    /// Merging by labels: simplices are one if the smallest cubes around them are.
    Merging by_boxes(bool downwards = true) const {
        SimplicialComplex K(mesh().simplices);
        const auto box_of = [&](int k, Index s) {
            const auto row = K.simplices(k).row(s);
            return box({row.begin(), row.end()});
        };
        std::map<Box, Index> label;
        std::vector<Index> labels;
        for (Index t = 0; t < K.size(n()); ++t)
            labels.push_back(
                label.emplace(box_of(n(), t), static_cast<Index>(label.size())).first->second);
        const auto straight = [&](int k, Index, Index f, Index g) {
            return downwards && box_of(k, f) == box_of(k, g);
        };
        const auto blocks = join_blocks(K, facets_within_labels(K, labels), straight);
        return {std::move(K), blocks};
    }

    /// Sum over the choices of k axes of the number of cubes along these and of lattice planes
    /// along the others; C(n,k) m^k (m+1)^(n-k) for equal counts m.
    Index number_of_cubes(int k) const {
        Index sum = 0;
        for (unsigned axes = 0; axes < 1U << n(); ++axes) {
            Index product = 1;
            for (int axis = 0; axis < n(); ++axis)
                product *= (axes >> axis & 1U) ? cells()[axis] : cells()[axis] + 1;
            sum += std::popcount(axes) == k ? product : 0;
        }
        return sum;
    }
};

TEST_P(KuhnGrids, merge_by_labels_to_as_many_cubes_as_a_grid_has) {
    const auto merging = by_boxes();
    for (int k = 0; k <= n(); ++k)
        EXPECT_EQ(merging.merged().size(k), number_of_cubes(k)) << "degree " << k;
}

TEST_P(KuhnGrids, merging_top_cells_alone_leaves_split_faces) {
    const auto merging = by_boxes(false);
    for (int k = 2; k < n(); ++k)
        EXPECT_NE(merging.merged().size(k), number_of_cubes(k)) << "degree " << k;
}

TEST_P(KuhnGrids, merge_by_circumspheres_to_the_same_complex) {
    const auto labels = by_boxes();
    const auto spheres = make_merged(mesh());
    for (int k = 0; k <= n(); ++k) {
        EXPECT_TRUE(equal(integers(labels.diamond(k)), integers(spheres.merging().diamond(k))));
        EXPECT_TRUE(
            equal(integers(labels.merged().coboundary(k)), integers(spheres.P().coboundary(k))));
        EXPECT_EQ(labels.merged().coface_counts(k), spheres.P().coface_counts(k));
    }
}

TEST_P(KuhnGrids, every_cube_has_its_faces_corners_and_pieces) {
    const auto merging = by_boxes();
    for (int k = 0; k <= n(); ++k)
        for (Index F = 0; F < merging.merged().size(k); ++F) {
            const auto corners = merging.vertices(k, F);
            EXPECT_EQ(corners.size(), 1U << k);
            EXPECT_EQ(IncidenceMatrix(merging.diamond(k).row(F)).nonZeros(),
                      std::lround(std::tgamma(k + 1.0)));

            // faces are what one axis shrunk to either end leaves
            const auto own = box(corners);
            std::set<Box> expected, found;
            for (std::size_t axis = 0; axis < own.size(); ++axis)
                for (const Index end : {own[axis].first, own[axis].second}) {
                    auto face = own;
                    face[axis] = {end, end};
                    if (face != own)
                        expected.insert(face);
                }
            for (IncidenceMatrix::InnerIterator f(merging.merged().coboundary(k - 1), F); f; ++f) {
                EXPECT_EQ(std::abs(int(f.value())), 1);
                found.insert(box(merging.vertices(k - 1, static_cast<Index>(f.col()))));
            }
            EXPECT_EQ(found.size(), 2U * k);
            EXPECT_EQ(found, expected);
        }
}

TEST_P(KuhnGrids, no_block_of_a_cube_is_inadmissible) {
    const auto K = SimplicialComplex(mesh().simplices);
    const auto merged = make_merged(mesh());
    EXPECT_EQ(merged.result.rounds, 0);
    EXPECT_TRUE(merged.K().orientable());
    EXPECT_EQ(merged.K().turned(), 0);
}

INSTANTIATE_TEST_SUITE_P(Sizes, KuhnGrids,
                         testing::Values(std::vector<int>{6}, std::vector<int>{4, 4},
                                         std::vector<int>{3, 5}, std::vector<int>{3, 3, 3},
                                         std::vector<int>{1, 2, 4}, std::vector<int>{2, 2, 2, 2},
                                         std::vector<int>{1, 3, 1, 2},
                                         std::vector<int>{1, 1, 1, 1, 1},
                                         std::vector<int>{2, 1, 1, 1, 1}),
                         [](const auto& instance) {
                             std::string name = "cells";
                             for (const int count : instance.param)
                                 name += fmt::format("_{}", count);
                             return name;
                         });

TEST(Tesseract, has_a_boundary_of_eight_cubes) {
    EXPECT_EQ(sizes(merged("boundary_of_tesseract").P()), (std::vector<Index>{16, 32, 24, 8}));
}

TEST(CubicalTori, have_as_many_cubes_of_each_degree_as_binomials_say) {
    EXPECT_EQ(sizes(merged("cubical_torus2").P()), (std::vector<Index>{16, 32, 16}));
    EXPECT_EQ(sizes(merged("cubical_torus3").P()), (std::vector<Index>{64, 192, 192, 64}));
}

} // namespace polydec::test::in_cubes
