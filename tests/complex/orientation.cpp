// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

#include <rapidcheck.h>

namespace polydec::test::in_orientation {

/// Turns cell s.
void turn(Mesh& mesh, Index s) {
    std::swap(mesh.simplices(s, 0), mesh.simplices(s, 1));
}

/// Whether the two cells at every facet with two cofaces induce opposite orientations there.
bool coherent(const CellComplex& complex, const IncidenceMatrix& d) {
    const int n = complex.dimension();
    const IncidenceMatrix cofaces = d.transpose();
    for (Index f = 0; f < complex.size(n - 1); ++f) {
        int sum = 0;
        for (IncidenceMatrix::InnerIterator t(cofaces, f); t; ++t)
            sum += t.value();
        if (complex.coface_counts(n - 1)[f] == 2 && sum != 0)
            return false;
    }
    return true;
}

class Orientations : public testing::TestWithParam<std::string> {};

TEST_P(Orientations, are_coherent_wherever_that_is_possible) {
    const SimplicialComplex K(mesh_named(GetParam()).simplices);
    EXPECT_EQ(coherent(K, K.coboundary(K.dimension() - 1)), K.orientable());
}

TEST_P(Orientations, are_found_incoherent_once_a_cell_is_turned) {
    const SimplicialComplex K(mesh_named(GetParam()).simplices);
    const int n = K.dimension();
    for (Index s = 0; s < K.size(n); ++s) {
        IncidenceMatrix d = K.coboundary(n - 1);
        bool has_neighbor = false;
        for (IncidenceMatrix::InnerIterator f(d, s); f; ++f) {
            f.valueRef() = static_cast<std::int8_t>(-f.value());
            has_neighbor |= K.coface_counts(n - 1)[f.col()] == 2;
        }
        if (has_neighbor && K.orientable()) {
            EXPECT_FALSE(coherent(K, d)) << "cell " << s;
        }
    }
}

POLYDEC_OVER_MESHES(Orientations);

TEST(Orientation, turns_the_fewest_cells_of_each_part_for_any_choice_of_turned_cells) {
    const Mesh sphere = icosphere(1), ring = mesh_named("torus8x6");
    const Mesh both = united(sphere, ring);
    const Index spheres = static_cast<Index>(sphere.simplices.rows());
    const Index all = static_cast<Index>(both.simplices.rows());
    EXPECT_TRUE(rc::check("fewest are turned", [&] {
        const auto chosen = *rc::gen::container<std::vector<bool>>(static_cast<std::size_t>(all),
                                                                   rc::gen::arbitrary<bool>());
        Mesh mesh = both;
        Index in_sphere = 0, in_ring = 0;
        for (Index s = 0; s < all; ++s)
            if (chosen[s]) {
                turn(mesh, s);
                ++(s < spheres ? in_sphere : in_ring);
            }
        const SimplicialComplex K(mesh.simplices);
        RC_ASSERT(K.orientable());
        RC_ASSERT(coherent(K, K.coboundary(1)));
        RC_ASSERT(K.turned() == std::min(in_sphere, spheres - in_sphere) +
                                    std::min(in_ring, all - spheres - in_ring));
    }));
}

TEST(Orientation, turns_the_fewest_cells_in_any_dimension) {
    for (const char* name :
         {"kuhn1d", "polygon_curve", "kuhn3", "boundary_of_tesseract", "obtuse4"})
        EXPECT_TRUE(rc::check(std::string("fewest are turned in ") + name, [&] {
            Mesh mesh = mesh_named(name);
            const SimplicialComplex before(mesh.simplices);
            Index turned = 0;
            for (Index t = 0; t < before.size(before.dimension()); ++t)
                if (*rc::gen::arbitrary<bool>()) {
                    turn(mesh, before.input_row(t));
                    ++turned;
                }
            const SimplicialComplex after(mesh.simplices);
            const auto all = after.size(after.dimension());
            RC_ASSERT(before.turned() == 0);
            RC_ASSERT(after.turned() == std::min(turned, all - turned));
        }));
}

TEST(Orientation, of_a_one_sided_part_is_that_of_the_input_while_the_others_are_made_coherent) {
    Mesh strip = moebius(7, 1);
    Mesh sphere = icosphere(1);
    turn(sphere, 3);
    const Mesh mesh = united(strip, sphere);
    const SimplicialComplex K(mesh.simplices);
    EXPECT_FALSE(K.orientable());
    EXPECT_EQ(K.turned(), 1);
    for (Index t = 0; t < K.size(2); ++t) {
        if (K.input_row(t) >= static_cast<Index>(strip.simplices.rows()))
            continue;
        const auto given = mesh.simplices.row(K.input_row(t));
        const bool even = (given[0] < given[1]) ^ (given[1] < given[2]) ^ (given[0] < given[2]);
        EXPECT_EQ(K.orientation(t), even ? 1 : -1);
    }
}

TEST(Orientation, knows_the_rows_of_the_input) {
    const Mesh mesh = mesh_named("obtuse_planar");
    const SimplicialComplex K(mesh.simplices);
    for (Index t = 0; t < K.size(2); ++t) {
        Eigen::RowVector3i row = mesh.simplices.row(K.input_row(t));
        std::sort(row.begin(), row.end());
        EXPECT_EQ(row, K.simplices(2).row(t));
    }
}

} // namespace polydec::test::in_orientation
