// SPDX-License-Identifier: MIT
#include "dec/metric/whitney.h"

#include "base/checks.h"
#include "dec/metric/simplex_faces.h"
#include "dec/metric/simplex_geometry.h"
#include "dec/metric/subsets.h"

#include <Eigen/LU>
#include <Eigen/QR>

#include <cmath>
#include <limits>

namespace polydec {

namespace {

double volume(const DenseMatrix& gradients) {
    // the gradients of all but one vertex span the dual lattice of the edges; the determinant of
    // their products would lose twice the digits that a flat simplex costs
    const auto m = gradients.rows() - 1;
    const DenseMatrix dual_edges = gradients.bottomRows(m).transpose();
    const double cell = dual_edges.householderQr().matrixQR().diagonal().prod();
    return 1 / (std::abs(cell) * std::tgamma(double(m) + 1));
}

/// Determinant of the products of gradients in I without its p-th and J without its q-th.
double minor_determinant(const DenseMatrix& products, const std::vector<int>& I, std::size_t p,
                         const std::vector<int>& J, std::size_t q) {
    const auto j = static_cast<Index>(I.size()) - 1;
    DenseMatrix minor(j, j);
    for (Index a = 0; a < j; ++a)
        for (Index b = 0; b < j; ++b)
            minor(a, b) = products(I[a < Index(p) ? a : a + 1], J[b < Index(q) ? b : b + 1]);
    return j == 0 ? 1.0 : minor.determinant();
}

} // namespace

DenseMatrix whitney_mass(const Points& points, std::span<const Index> vertices, int j) {
    const auto m = static_cast<int>(vertices.size()) - 1;
    check_number("the mass matrix of Whitney forms of degree", j, 0, m);
    check_number("a simplex between points, of dimension", m, 0, points.cols());
    for (const Index v : vertices)
        check_number("the point", v, 0, points.rows() - 1);
    const DenseMatrix gradients = barycentric_gradients(points, vertices);
    const DenseMatrix products = gradients * gradients.transpose();
    const double factorial = std::tgamma(j + 1.0);
    const double weight = factorial * factorial * volume(gradients) / ((m + 1.0) * (m + 2.0));

    const auto faces = subsets(m + 1, j + 1);
    DenseMatrix mass(faces.size(), faces.size());
    for (std::size_t a = 0; a < faces.size(); ++a)
        for (std::size_t b = 0; b < faces.size(); ++b) {
            double sum = 0;
            for (std::size_t p = 0; p < faces[a].size(); ++p)
                for (std::size_t q = 0; q < faces[b].size(); ++q) {
                    const double sign = (p + q) % 2 == 0 ? 1 : -1;
                    const double moment = faces[a][p] == faces[b][q] ? 2 : 1;
                    sum += sign * moment * minor_determinant(products, faces[a], p, faces[b], q);
                }
            mass(a, b) = weight * sum;
        }
    return mass;
}

SparseMatrix whitney_mass(const Pieces& complex, const SimplexMetric& metric, int k,
                          const Vector& weights) {
    const int n = complex.dimension();
    check_number("the mass of Whitney forms of degree", k, 0, n);
    check_as_many("weights of simplices", weights.size(), complex.size(n));
    std::vector<Eigen::Triplet<double, Index>> entries;
    SimplexFaces faces(complex, n, k);
    SimplexLayout layout(complex, metric);
    for (Index t = 0; t < complex.size(n); ++t) {
        if (weights[t] == 0)
            continue;
        const Corners corners = layout.at(n, t);
        const DenseMatrix mass = weights[t] * whitney_mass(corners.points, corners.vertices, k);
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
