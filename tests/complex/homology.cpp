// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_homology {

/// K, P and P relative to its boundary.
std::vector<CellComplex> complexes(const Merged& mesh) {
    return {mesh.K(), mesh.P(), relative_to_boundary(mesh.P()).complex};
}

SparseMatrix boundary_matrix(const CellComplex& complex, int k) {
    return SparseMatrix(complex.coboundary(k - 1).cast<double>().transpose());
}

Index dense_rank(const DenseMatrix& A) {
    return A.size() == 0 ? 0 : static_cast<Index>(A.colPivHouseholderQr().rank());
}

DenseMatrix beside(const DenseMatrix& A, const DenseMatrix& B) {
    DenseMatrix both(A.rows(), A.cols() + B.cols());
    both << A, B;
    return both;
}

class Generators : public OverMeshes {};

TEST_P(Generators, are_cycles_of_integers_as_many_as_betti_numbers_say) {
    for (const auto& complex : complexes(mesh())) {
        const auto betti = betti_numbers(complex);
        for (int k = 0; k <= mesh().n(); ++k) {
            const SparseMatrix G = homology_generators(complex, k);
            ASSERT_EQ(G.rows(), complex.size(k));
            EXPECT_EQ(G.cols(), betti[k]) << "k = " << k;
            EXPECT_EQ(largest(boundary_matrix(complex, k) * G), 0) << "k = " << k;
            for (const double value : Vector(G.coeffs()))
                EXPECT_EQ(value, std::round(value));
        }
    }
}

TEST_P(Generators, are_independent_of_each_other_and_of_boundaries) {
    for (const auto& complex : complexes(mesh())) {
        const auto betti = betti_numbers(complex);
        for (int k = 0; k <= mesh().n(); ++k) {
            if (betti[k] == 0)
                continue;
            const DenseMatrix boundaries(boundary_matrix(complex, k + 1));
            const DenseMatrix G(homology_generators(complex, k));
            EXPECT_EQ(dense_rank(beside(boundaries, G)), dense_rank(boundaries) + betti[k])
                << "k = " << k;
        }
    }
}

TEST_P(Generators, regular_minors_have_the_rank_of_the_coboundary) {
    for (const auto& complex : complexes(mesh())) {
        const auto betti = betti_numbers(complex);
        Index rank = 0; // of d_(k-1)
        for (int k = 0; k <= mesh().n(); ++k) {
            const auto [columns, rows] = regular_minor(complex, k);
            rank = complex.size(k) - rank - betti[k];
            EXPECT_EQ(static_cast<Index>(columns.size()), rank) << "k = " << k;
            ASSERT_EQ(columns.size(), rows.size());
            const DenseMatrix D(complex.coboundary(k).cast<double>());
            EXPECT_EQ(dense_rank(D(rows, columns)), rank) << "k = " << k;
        }
    }
}

POLYDEC_OVER_MESHES(Generators);

TEST(GeneratorsBroken, boundaries_and_doubled_cycles_are_not_independent) {
    const auto& P = merged("torus8x6").P();
    const DenseMatrix boundaries(boundary_matrix(P, 2));
    DenseMatrix G(homology_generators(P, 1));
    G.col(1) = G.col(0) + boundaries.col(3);
    EXPECT_EQ(dense_rank(beside(boundaries, G)), dense_rank(boundaries) + 1);
}

TEST(GeneratorsBroken, the_first_cells_are_no_regular_minor) {
    const auto& P = merged("torus8x6").P();
    const auto [columns, rows] = regular_minor(P, 1);
    std::vector<Index> first(columns.size());
    for (std::size_t i = 0; i < first.size(); ++i)
        first[i] = static_cast<Index>(i);
    const DenseMatrix D(P.coboundary(1).cast<double>());
    EXPECT_LT(dense_rank(D(rows, first)), static_cast<Index>(rows.size()));
}

TEST(Generators, of_a_ring_run_once_around_the_hole) {
    const auto& mesh = merged("annulus9");
    const SparseMatrix G = homology_generators(mesh.P(), 1);
    // the angle around the axis gains one full turn, up to sign
    double angle = 0;
    for (Index e = 0; e < G.rows(); ++e) {
        const auto ends = mesh.merging().vertices(1, e);
        const auto at = [&](Index v) { return std::atan2(mesh.points(v, 1), mesh.points(v, 0)); };
        angle += G.coeff(e, 0) * std::remainder(at(ends[1]) - at(ends[0]), 2 * std::acos(-1.0));
    }
    EXPECT_NEAR(std::abs(angle), 2 * std::acos(-1.0), 1e-12);
}

TEST(Generators, of_one_sided_cells_may_run_twice) {
    // relative to nothing, the edge of this projective plane has the boundary 0 and bounds twice
    IncidenceMatrix d0(1, 1), d1(1, 1);
    d1.insert(0, 0) = 2;
    const CellComplex plane({d0, d1});
    EXPECT_EQ(betti_numbers(plane), (std::vector<Index>{1, 0, 0}));
    EXPECT_EQ(homology_generators(plane, 0).cols(), 1);
    EXPECT_EQ(homology_generators(plane, 1).cols(), 0);
    EXPECT_EQ(homology_generators(plane, 2).cols(), 0);
}

TEST(Generators, refuse_degrees_that_are_not_there) {
    const auto& P = merged("grid4").P();
    EXPECT_REFUSED(homology_generators(P, 3), "homology", "degree 3", "dimension 2", "0", "2");
    EXPECT_REFUSED(regular_minor(P, -1), "homology", "degree -1", "dimension 2", "0", "2");
}

class RelativeComplexes : public OverMeshes {};

TEST_P(RelativeComplexes, are_complexes_and_keep_values_apart) {
    const auto relative = relative_to_boundary(mesh().P());
    const auto marks = boundary_cells(mesh().P());
    for (int k = 0; k + 1 < mesh().n(); ++k)
        EXPECT_TRUE(is_zero(integers(relative.complex.coboundary(k + 1)) *
                            integers(relative.complex.coboundary(k))));
    for (int k = 0; k <= mesh().n(); ++k) {
        const Vector kept = random_vector(relative.complex.size(k), 1);
        const Vector whole = relative.extend(k, kept);
        EXPECT_EQ(relative.restrict(k, whole), kept);
        for (Index s = 0; s < mesh().P().size(k); ++s)
            EXPECT_EQ(whole[s] == 0, static_cast<bool>(marks[k][s]));
    }
}

TEST_P(RelativeComplexes, derivative_commutes_with_extending_by_zero) {
    const auto relative = relative_to_boundary(mesh().P());
    for (int k = 0; k < mesh().n(); ++k) {
        const Vector w = random_vector(relative.complex.size(k), 2);
        const Vector below = relative.complex.coboundary(k).cast<double>() * w;
        const Vector above = mesh().P().coboundary(k).cast<double>() * relative.extend(k, w);
        EXPECT_EQ(relative.extend(k + 1, below), above) << "k = " << k;
    }
}

POLYDEC_OVER_MESHES(RelativeComplexes);

TEST(RelativeComplexes, refuse_a_set_that_is_not_closed) {
    const auto& P = merged("grid4").P();
    CellMarks marks = boundary_cells(P);
    marks[0][0] = false;
    EXPECT_REFUSED(relative_complex(P, marks), "1-cell 0", "face", "0-cell 0");
    marks[2].pop_back();
    const Words too_few{"15 marks", "2-cells", "16"};
    EXPECT_REFUSED(relative_complex(P, marks), too_few);
    EXPECT_REFUSED(mark_faces(P, marks), too_few);
    marks.pop_back();
    EXPECT_REFUSED(mark_faces(P, marks), "2 lists", "cells", "3");
}

/// Everything that touches a vertex.
CellMarks star_of_vertex(const CellComplex& complex, Index vertex) {
    CellMarks marks = no_marks(complex);
    marks[0][vertex] = true;
    for (int k = 0; k < complex.dimension(); ++k)
        for (Index t = 0; t < complex.size(k + 1); ++t)
            for (IncidenceMatrix::InnerIterator s(complex.coboundary(k), t); s; ++s)
                if (marks[k][s.col()])
                    marks[k + 1][t] = true;
    return marks;
}

TEST(RelativeComplexes, without_a_closed_and_an_open_set_have_dd_0) {
    for (const char* name : {"grid4", "kuhn3", "bcc2", "kuhn4"}) {
        const auto& P = merged(name).P();
        const auto relative =
            relative_complex(P, boundary_cells(P), star_of_vertex(P, P.size(0) / 2));
        for (int k = 0; k + 2 <= P.dimension(); ++k)
            EXPECT_TRUE(is_zero(integers(relative.complex.coboundary(k + 1)) *
                                integers(relative.complex.coboundary(k))))
                << name;
        EXPECT_LT(relative.complex.size(P.dimension()), P.size(P.dimension()));
    }
}

TEST(RelativeComplexes, refuse_a_set_that_is_not_open) {
    const auto& P = merged("grid4").P();
    const auto closed = boundary_cells(P);
    auto marks = star_of_vertex(P, 12);
    std::fill(marks[2].begin(), marks[2].end(), false);
    EXPECT_REFUSED(relative_complex(P, closed, marks), "1-cell", "open set");
}

} // namespace polydec::test::in_homology
