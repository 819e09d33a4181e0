// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/test.h"

namespace polydec::test {

/// A mesh of the family made ready for calculus, once: merged, or as the simplices that it has;
/// with circumcentric stars. Surfaces whose edges are to flip are shaken first.
inline const Discretization& discretized(const std::string& name,
                                         MergeCriterion criterion = MergeCriterion::dual_length,
                                         Delaunay delaunay = Delaunay::off) {
    static std::map<std::tuple<std::string, MergeCriterion, Delaunay>,
                    std::unique_ptr<Discretization>>
        made;
    auto& entry = made[{name, criterion, delaunay}];
    if (!entry)
        entry = std::make_unique<Discretization>(
            delaunay == Delaunay::off
                ? circumcentric(mesh_named(name), {criterion, tolerance})
                : circumcentric(shaken(mesh_named(name), 0.25, 7),
                                {.criterion = criterion, .delaunay = delaunay}));
    return *entry;
}

/// Calls law(mesh) for the merged mesh and for its simplices.
template <class Law>
void for_merged_and_not(const std::string& name, Law law, Delaunay delaunay = Delaunay::off) {
    for (const auto criterion : {MergeCriterion::dual_length, MergeCriterion::none}) {
        SCOPED_TRACE(criterion == MergeCriterion::none ? "simplices" : "merged");
        law(discretized(name, criterion, delaunay));
    }
}

/// The same with edges that are flipped, and split or not, if the mesh is a surface.
template <class Law>
void for_flipped(const std::string& name, Law law) {
    const auto surfaces = names_of_surfaces();
    if (std::find(surfaces.begin(), surfaces.end(), name) == surfaces.end())
        return;
    for (const auto delaunay : {Delaunay::flips, Delaunay::flips_and_splits}) {
        SCOPED_TRACE(delaunay == Delaunay::flips ? "flips" : "splits");
        for_merged_and_not(name, law, delaunay);
    }
}

template <class Law>
void for_flipped_and_not(const std::string& name, Law law) {
    for_merged_and_not(name, law);
    for_flipped(name, law);
}

/// The error that rounding may leave: flips carry it on.
inline double allowed_rounding(const Discretization& mesh) {
    return mesh.passage().is_identity() ? 1e-12 : 1e-9;
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

/// 1 or -1 as all simplices of a flat mesh are oriented against its coordinates; 0 if it is folded.
inline int turn(const Discretization& mesh) {
    const Vector turns = orientations_in_space(mesh);
    return std::abs(turns.sum()) == turns.size() ? static_cast<int>(turns[0]) : 0;
}

/// Numbers of cells of each degree in a grid of m boxes along each of n axes.
inline std::vector<Index> sizes_of_boxes(int n, Index m) {
    std::vector<Index> result;
    for (int k = 0; k <= n; ++k)
        result.push_back(static_cast<Index>(
            std::lround(binomial(n, k) * std::pow(m, k) * std::pow(m + 1, n - k))));
    return result;
}

/// Steps of length 1 along the first axes.
inline std::vector<Vector> unit_translations(int n, int axes) {
    std::vector<Vector> result;
    for (int axis = 0; axis < axes; ++axis)
        result.push_back(Vector::Unit(n, axis));
    return result;
}

/// Three near and three far spokes in the ratio at which the negative parts of the dual in the
/// middle cancel the positive.
inline Mesh fan_without_dual() {
    const double far = 2 + std::sqrt(3.0), third = std::numbers::pi / 3;
    std::vector<std::vector<double>> points{{0, 0}};
    std::vector<std::vector<Index>> triangles;
    for (Index i = 0; i < 6; ++i) {
        const double r = i % 2 == 0 ? 1 : far;
        points.push_back({r * std::cos(i * third), r * std::sin(i * third)});
        triangles.push_back({0, i + 1, (i + 1) % 6 + 1});
    }
    return made_of(points, triangles);
}

/// Whether facets have a cell on each side at most, and orientations of cells agree across them.
inline bool is_two_sided(const Discretization& mesh) {
    return mesh.input().orientable() && !branches(mesh.complex());
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

inline DenseMatrix random_matrix(Index rows, Index columns, unsigned seed) {
    return random_vector(rows * columns, seed).reshaped(rows, columns);
}

/// A vector at each point.
inline Points random_field(const Discretization& mesh, unsigned seed) {
    return random_matrix(static_cast<Index>(mesh.points().rows()), space(mesh), seed);
}

/// Well-centered, Delaunay, not Delaunay, cospherical.
inline std::vector<Index> counts(const FacetKinds& kinds) {
    return {kinds.well_centered, kinds.delaunay, kinds.non_delaunay, kinds.cospherical};
}

/// Vector fields: the same one everywhere, and x -> A x + b, at random.
inline SmoothForm random_constant(const Discretization& mesh) {
    return constant_form(random_vector(space(mesh), 6));
}
inline SmoothForm linear_field(Index N, unsigned seed) {
    const DenseMatrix A = random_matrix(N, N, seed);
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
