// SPDX-License-Identifier: MIT
#include "dec/metric/dual_parts.h"

#include "base/checks.h"
#include "base/lists.h"
#include "dec/metric/center_heights.h"
#include "dec/metric/simplex_faces.h"
#include "dec/metric/subsets.h"

#include <utility>
#include <vector>

namespace polydec {

namespace {

/// A k-face of an m-simplex that is also a face of its facet without corner `omitted`.
struct SharedFace {
    Eigen::Index face; ///< number of the k-face within the simplex
    int omitted;
    Eigen::Index below; ///< and within the facet
};

std::vector<SharedFace> shared_faces(int k, int m) {
    const auto faces = subsets(m + 1, k + 1), below = subsets(m, k + 1);
    std::vector<SharedFace> result;
    for (std::size_t i = 0; i < faces.size(); ++i)
        for (const int omitted : complement(m + 1, faces[i])) {
            auto corners = faces[i];
            for (int& corner : corners)
                corner -= corner > omitted ? 1 : 0;
            result.push_back({static_cast<Eigen::Index>(i), omitted, place_in(below, corners)});
        }
    return result;
}

} // namespace

Points parts_of_duals(const Geometry& geometry, const Centers& centers, int k, int m) {
    const Pieces& complex = geometry.pieces();
    check_number("parts of duals in simplices of degree", m, 0, complex.dimension());
    check_number("parts of the duals of simplices of degree", k, 0, m);
    centers.check_fit(complex);
    SimplexLayout layout(complex, geometry.metric());
    const CenterHeights from(centers);
    Circumsphere sphere;
    Points parts = Points::Ones(complex.size(k), 1);
    for (int j = k + 1; j <= m; ++j) {
        const auto steps = shared_faces(k, j);
        const Vector& facets = geometry.volumes().primal(j - 1);
        std::vector<double> heights(static_cast<std::size_t>(j) + 1);
        Points next = Points::Zero(complex.size(j), steps.back().face + 1);
        for (Index t = 0; t < complex.size(j); ++t) {
            if (!from.know(j))
                sphere.look_at(layout, j, t);
            const auto [moments, factor] = from.moments(j, t, sphere);
            for (int i = 0; i <= j; ++i)
                heights[i] = moments[i] * factor / facets[complex.face(j, t, i)];
            for (const auto& [face, omitted, below] : steps)
                next(t, face) +=
                    heights[omitted] * parts(complex.face(j, t, omitted), below) / (j - k);
        }
        parts = std::move(next);
    }
    return parts;
}

SparseMatrix dual_parts(const Geometry& geometry, const Centers& centers, int k, int m) {
    const Pieces& complex = geometry.pieces();
    const Points parts = parts_of_duals(geometry, centers, k, m);
    SimplexFaces faces(complex, m, k);
    std::vector<Eigen::Triplet<double, Index>> entries;
    entries.reserve(static_cast<std::size_t>(parts.size()));
    for (Index t = 0; t < complex.size(m); ++t) {
        const auto& of_simplex = faces.of(t);
        for (std::size_t i = 0; i < of_simplex.size(); ++i)
            entries.emplace_back(t, of_simplex[i], parts(t, static_cast<Eigen::Index>(i)));
    }
    SparseMatrix matrix(complex.size(m), complex.size(k));
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

} // namespace polydec
