// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_laws {

class Complexes : public OverMeshes {};

std::vector<IncidenceMatrix> tower(const CellComplex& complex) {
    std::vector<IncidenceMatrix> result;
    for (int k = 0; k < complex.dimension(); ++k)
        result.push_back(complex.coboundary(k));
    return result;
}

bool squares_to_zero(const std::vector<IncidenceMatrix>& d) {
    for (std::size_t k = 0; k + 1 < d.size(); ++k)
        if (!is_zero(integers(d[k + 1]) * integers(d[k])))
            return false;
    return true;
}

TEST_P(Complexes, d_d_is_zero) {
    EXPECT_TRUE(squares_to_zero(tower(mesh().K())));
    EXPECT_TRUE(squares_to_zero(tower(mesh().P())));
}

TEST_P(Complexes, d_d_is_not_zero_once_a_sign_is_flipped) {
    auto d = tower(mesh().K());
    if (d.size() < 2)
        return;
    for (std::size_t k = 0; k < d.size(); ++k) {
        auto broken = d;
        broken[k].valuePtr()[broken[k].nonZeros() / 2] *= -1;
        EXPECT_FALSE(squares_to_zero(broken)) << "in d_" << k;
    }
}

/// dia_(k+1) d_k = d^P_k dia_k, in integers.
bool commutes(const IncidenceMatrix& upper, const IncidenceMatrix& d,
              const IncidenceMatrix& d_merged, const IncidenceMatrix& lower) {
    return equal(integers(upper) * integers(d), integers(d_merged) * integers(lower));
}

TEST_P(Complexes, mapping_to_merged_cells_is_a_cochain_map) {
    const auto& m = mesh().merging();
    for (int k = 0; k < mesh().n(); ++k)
        EXPECT_TRUE(commutes(m.diamond(k + 1), mesh().K().coboundary(k), mesh().P().coboundary(k),
                             m.diamond(k)))
            << "k = " << k;
}

TEST_P(Complexes, mapping_to_merged_cells_is_no_cochain_map_if_a_piece_is_turned) {
    const auto& m = mesh().merging();
    for (int k = 0; k < mesh().n(); ++k) {
        IncidenceMatrix turned = m.diamond(k + 1);
        turned.valuePtr()[0] *= -1;
        EXPECT_FALSE(
            commutes(turned, mesh().K().coboundary(k), mesh().P().coboundary(k), m.diamond(k)))
            << "k = " << k;
    }
}

TEST_P(Complexes, the_euler_number_is_the_alternating_sum_of_betti_numbers) {
    for (const auto& [name, complex, volumes] : both(mesh())) {
        Index alternating = 0;
        const auto betti = betti_numbers(complex);
        for (std::size_t k = 0; k < betti.size(); ++k)
            alternating += k % 2 == 0 ? betti[k] : -betti[k];
        EXPECT_EQ(alternating, euler_characteristic(complex)) << name;
    }
}

TEST_P(Complexes, merging_changes_no_betti_and_no_euler_number) {
    EXPECT_EQ(betti_numbers(mesh().K()), betti_numbers(mesh().P()));
    EXPECT_EQ(euler_characteristic(mesh().K()), euler_characteristic(mesh().P()));
}

TEST_P(Complexes, simplices_are_the_distinct_faces_in_lexicographic_order) {
    const auto& K = mesh().K();
    for (int k = 0; k <= mesh().n(); ++k) {
        const auto faces = test::faces({mesh().points, K.simplices(mesh().n()), {}}, k);
        ASSERT_EQ(std::size_t(K.size(k)), faces.size());
        Index s = 0;
        for (const auto& face : faces) {
            const auto row = K.simplices(k).row(s++);
            EXPECT_TRUE(std::equal(face.begin(), face.end(), row.begin(), row.end()));
        }
    }
}

TEST_P(Complexes, face_leaves_out_the_vertex_asked_for) {
    const auto& K = mesh().K();
    for (int k = 1; k <= mesh().n(); ++k)
        for (Index s = 0; s < K.size(k); ++s)
            for (int omitted = 0; omitted <= k; ++omitted) {
                std::vector<Index> rest;
                for (int i = 0; i <= k; ++i)
                    if (i != omitted)
                        rest.push_back(K.simplices(k)(s, i));
                const auto face = K.simplices(k - 1).row(K.face(k, s, omitted));
                ASSERT_TRUE(std::equal(rest.begin(), rest.end(), face.begin(), face.end()));
            }
}

TEST_P(Complexes, incidences_of_ascending_simplices_alternate) {
    const auto& K = mesh().K();
    for (int k = 1; k <= mesh().n(); ++k)
        for (Index s = 0; s < K.size(k); ++s)
            for (int omitted = 0; omitted <= k; ++omitted) {
                const int turned = k == mesh().n() ? K.orientation(s) : 1;
                ASSERT_EQ(K.coboundary(k - 1).coeff(s, K.face(k, s, omitted)),
                          omitted % 2 == 0 ? turned : -turned);
            }
}

TEST_P(Complexes, coface_counts_are_those_of_the_simplices_around) {
    const auto& K = mesh().K();
    for (int k = 0; k <= mesh().n(); ++k) {
        std::vector<Index> counts(K.size(k), 0);
        for (Index t = 0; t < K.size(k + 1); ++t)
            for (int omitted = 0; omitted <= k + 1; ++omitted)
                ++counts[K.face(k + 1, t, omitted)];
        EXPECT_EQ(K.coface_counts(k), counts);
    }
}

TEST_P(Complexes, merged_cells_have_the_coface_counts_of_their_pieces) {
    const auto& m = mesh().merging();
    for (int k = 0; k < mesh().n(); ++k) {
        // around every piece there are as many active simplices as cells around the merged cell
        std::vector<Index> active(mesh().K().size(k), 0);
        for (Index t = 0; t < mesh().K().size(k + 1); ++t)
            if (m.carriers(k + 1)[t].dimension == k + 1)
                for (int omitted = 0; omitted <= k + 1; ++omitted)
                    ++active[mesh().K().face(k + 1, t, omitted)];
        for (Index s = 0; s < mesh().K().size(k); ++s) {
            const auto& carrier = m.carriers(k)[s];
            if (carrier.dimension == k) {
                ASSERT_EQ(active[s], mesh().P().coface_counts(k)[carrier.cell]);
            }
        }
    }
}

TEST_P(Complexes, merged_cells_are_numbered_and_oriented_by_their_first_pieces) {
    for (int k = 0; k <= mesh().n(); ++k) {
        const auto& dia = mesh().merging().diamond(k);
        Index previous = -1;
        for (Index F = 0; F < mesh().P().size(k); ++F) {
            const IncidenceMatrix::InnerIterator first(dia, F);
            ASSERT_TRUE(first);
            EXPECT_GT(first.col(), previous);
            EXPECT_EQ(first.value(), 1);
            previous = static_cast<Index>(first.col());
        }
    }
}

TEST_P(Complexes, a_simplex_lies_in_one_carrier_whose_vertices_include_its_own) {
    const auto& m = mesh().merging();
    for (int k = 0; k <= mesh().n(); ++k) {
        ASSERT_EQ(m.carriers(k).size(), std::size_t(mesh().K().size(k)));
        for (Index s = 0; s < mesh().K().size(k); ++s) {
            const auto& carrier = m.carriers(k)[s];
            ASSERT_GE(carrier.dimension, k);
            const auto corners = m.vertices(carrier.dimension, carrier.cell);
            for (const Index v : mesh().K().simplices(k).row(s))
                ASSERT_TRUE(std::binary_search(corners.begin(), corners.end(), v));
        }
    }
}

TEST_P(Complexes, the_ends_of_the_tower_are_empty_matrices) {
    for (const auto& [name, complex, volumes] : both(mesh())) {
        const int n = complex.dimension();
        EXPECT_EQ(complex.coboundary(-1).rows(), complex.size(0)) << name;
        EXPECT_EQ(complex.coboundary(-1).cols(), 0) << name;
        EXPECT_EQ(complex.coboundary(n).rows(), 0) << name;
        EXPECT_EQ(complex.coboundary(n).cols(), complex.size(n)) << name;
        EXPECT_EQ(complex.size(-1), 0) << name;
        EXPECT_EQ(complex.size(n + 1), 0) << name;
    }
}

TEST_P(Complexes, boundary_is_the_transposed_coboundary) {
    for (int k = 0; k <= mesh().n(); ++k)
        EXPECT_TRUE(equal(integers(mesh().P().boundary(k)),
                          integers(mesh().P().coboundary(k - 1)).transpose()));
}

POLYDEC_OVER_MESHES(Complexes);

} // namespace polydec::test::in_laws
