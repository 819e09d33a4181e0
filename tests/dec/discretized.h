// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/test.h"

namespace polydec::test {

/// A mesh of the family made ready for calculus, once: merged, or as the simplices that it has;
/// with circumcentric stars.
inline const Discretization& discretized(const std::string& name,
                                         MergeCriterion criterion = MergeCriterion::dual_length) {
    static std::map<std::pair<std::string, MergeCriterion>, std::unique_ptr<Discretization>> made;
    auto& entry = made[{name, criterion}];
    if (!entry)
        entry = std::make_unique<Discretization>(
            circumcentric(mesh_named(name), {criterion, tolerance}));
    return *entry;
}

/// Calls law(mesh) for the merged mesh and for its simplices.
template <class Law>
void for_merged_and_not(const std::string& name, Law law) {
    for (const auto criterion : {MergeCriterion::dual_length, MergeCriterion::none}) {
        SCOPED_TRACE(criterion == MergeCriterion::none ? "simplices" : "merged");
        law(discretized(name, criterion));
    }
}

/// The orientation of each n-simplex of a full-dimensional mesh against that of R^n: 1 or -1.
inline Vector orientations_in_space(const Discretization& mesh) {
    const int n = mesh.dimension();
    const auto& K = mesh.input();
    Vector result(K.size(n));
    for (Index t = 0; t < K.size(n); ++t) {
        DenseMatrix edges(n, n);
        for (int i = 0; i < n; ++i)
            edges.row(i) = mesh.points().row(K.simplices(n)(t, i + 1)) -
                           mesh.points().row(K.simplices(n)(t, 0));
        result[t] = K.orientation(t) * (edges.determinant() > 0 ? 1 : -1);
    }
    return result;
}

/// How many entries of stars of all degrees are not.
inline std::size_t not_positive(const Discretization& mesh) {
    std::size_t count = 0;
    for (int k = 0; k <= mesh.dimension(); ++k)
        count += mesh.stars()[k].negatives().size() + mesh.stars()[k].zeros().size();
    return count;
}

/// Number of coordinates of the points.
inline Index space(const Discretization& mesh) {
    return static_cast<Index>(mesh.points().cols());
}

/// Vector fields: the same one everywhere, and x -> A x + b, at random.
inline SmoothForm random_constant(const Discretization& mesh) {
    return constant_form(random_vector(space(mesh), 6));
}
inline SmoothForm linear_field(Index N, unsigned seed) {
    const DenseMatrix A = random_vector(N * N, seed).reshaped(N, N);
    const Vector b = random_vector(N, seed + 1);
    return [A, b](const Vector& x) { return Vector(A * x + b); };
}

/// Whether a flat takes vectors of n-cells.
inline bool is_at_cells(Flat kind) {
    return kind == Flat::dpp || kind == Flat::dpd;
}

inline DenseMatrix sampled(const Points& places, const SmoothForm& field) {
    DenseMatrix result(places.rows(), places.cols());
    for (Index i = 0; i < places.rows(); ++i)
        result.row(i) = field(places.row(i));
    return result;
}

} // namespace polydec::test
