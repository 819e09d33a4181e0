// SPDX-License-Identifier: MIT
#include "dec/metric/whitney.h"

#include "base/checks.h"
#include "dec/metric/simplex_geometry.h"
#include "dec/metric/subsets.h"

#include <Eigen/LU>

#include <cmath>
#include <limits>

namespace polydec {

namespace {

double volume(const DenseMatrix& gradients) {
    // the gradients of all but one vertex span the dual lattice of the edges
    const auto m = gradients.rows() - 1;
    const DenseMatrix gram = gradients.bottomRows(m) * gradients.bottomRows(m).transpose();
    return 1 / (std::sqrt(gram.determinant()) * std::tgamma(double(m) + 1));
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

} // namespace polydec
