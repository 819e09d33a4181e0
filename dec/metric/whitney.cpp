// SPDX-License-Identifier: MIT
#include "dec/metric/whitney.h"

#include "base/checks.h"
#include "base/decompositions.h"
#include "dec/metric/exterior_product.h"
#include "dec/metric/simplex_faces.h"
#include "dec/metric/simplex_geometry.h"
#include "dec/metric/subsets.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace polydec {

namespace {

/// Mass matrices of the j-forms of m-simplices.
class WhitneyMass {
public:
    WhitneyMass(int m, int j) : m_(m), j_(j), faces_(subsets(m + 1, j + 1)), wedge_(m, j) {}

    /// At vertex v the form of a face has as value the wedge of the gradients of the other
    /// vertices; in between it is linear. Integrals of products of barycentric coordinates for v =
    /// w and v != w are in the ratio 2 : 1. Uses squares of values, not of products of gradients,
    /// so flat simplices lose no more digits than necessary.
    DenseMatrix operator()(const Points& points, std::span<const Index> vertices) const {
        // in coordinates of the simplex's own space; all gradients but one span the dual lattice of
        // the edges
        const DenseMatrix given = barycentric_gradients(points, vertices);
        const DenseMatrix gradients = given * orthonormal_columns(given.bottomRows(m_).transpose());
        const double volume = // all gradients but one are triangular in these axes
            1 / (std::abs(gradients.bottomRows(m_).diagonal().prod()) * std::tgamma(m_ + 1.0));
        const auto size = static_cast<Index>(faces_.size());
        DenseMatrix mass = DenseMatrix::Zero(size, size);
        DenseMatrix sum = DenseMatrix::Zero(size, wedge_.size());
        for (int v = 0; v <= m_; ++v) {
            const DenseMatrix values = values_at(v, gradients);
            mass.selfadjointView<Eigen::Lower>().rankUpdate(values);
            sum += values;
        }
        mass.selfadjointView<Eigen::Lower>().rankUpdate(sum);
        const double factorial = std::tgamma(j_ + 1.0);
        const double weight = factorial * factorial * volume / ((m_ + 1.0) * (m_ + 2.0));
        return weight * DenseMatrix(mass.selfadjointView<Eigen::Lower>());
    }

private:
    /// Values of each face, divided by j!.
    DenseMatrix values_at(int v, const DenseMatrix& gradients) const {
        DenseMatrix values = DenseMatrix::Zero(static_cast<Index>(faces_.size()), wedge_.size());
        for (std::size_t a = 0; a < faces_.size(); ++a) {
            const auto place = std::find(faces_[a].begin(), faces_[a].end(), v);
            if (place == faces_[a].end())
                continue;
            const auto p = static_cast<int>(place - faces_[a].begin());
            values.row(static_cast<Index>(a)) = wedge_.without(p, faces_[a], gradients).transpose();
        }
        return values;
    }

    int m_, j_;
    std::vector<std::vector<int>> faces_;
    ExteriorProduct wedge_;
};

} // namespace

DenseMatrix whitney_mass(const Points& points, std::span<const Index> vertices, int j) {
    const auto m = static_cast<int>(vertices.size()) - 1;
    check_number("the mass matrix of Whitney forms of degree", j, 0, m);
    check_number("a simplex between points, of dimension", m, 0, points.cols());
    for (const Index v : vertices)
        check_number("the point", v, 0, points.rows() - 1);
    return WhitneyMass(m, j)(points, vertices);
}

SparseMatrix whitney_mass(const Pieces& complex, const SimplexMetric& metric, int m, int k,
                          const Vector& weights) {
    check_number("the mass of Whitney forms of degree", k, 0, m);
    check_as_many("weights of simplices", weights.size(), complex.size(m));
    std::vector<Eigen::Triplet<double, Index>> entries;
    SimplexFaces faces(complex, m, k);
    SimplexLayout layout(complex, metric);
    const WhitneyMass of_simplex(m, k);
    for (Index t = 0; t < complex.size(m); ++t) {
        if (weights[t] == 0)
            continue;
        const Corners corners = layout.at(m, t);
        const DenseMatrix mass = weights[t] * of_simplex(corners.points, corners.vertices);
        const auto& of_t = faces.of(t);
        for (std::size_t a = 0; a < of_t.size(); ++a)
            for (std::size_t b = 0; b < of_t.size(); ++b)
                entries.emplace_back(of_t[a], of_t[b], mass(a, b));
    }
    SparseMatrix M(complex.size(k), complex.size(k));
    M.setFromTriplets(entries.begin(), entries.end());
    return M;
}

} // namespace polydec
