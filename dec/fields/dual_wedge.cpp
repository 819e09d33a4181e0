// SPDX-License-Identifier: MIT
#include "base/lists.h"
#include "base/permutation_sign.h"
#include "dec/fields/developed_cells.h"
#include "dec/fields/flat_pieces.h"
#include "dec/fields/transfer.h"
#include "dec/fields/wedge.h"
#include "dec/metric/dual_parts.h"
#include "dec/metric/exterior_product.h"
#include "dec/metric/simplex_faces.h"
#include "dec/metric/simplex_geometry.h"
#include "dec/metric/simplex_layout.h"
#include "dec/metric/subsets.h"

#include <algorithm>
#include <cmath>

namespace polydec {

namespace {

using Axes = std::vector<int>;

Axes joined(const Axes& a, const Axes& b) {
    Axes result = a;
    result.insert(result.end(), b.begin(), b.end());
    return result;
}

/// star^-1 (star v ^ star w) of a p-covector v and a q-covector w of R^n, of degree p + q - n.
class Meet {
public:
    Meet(int n, int p, int q) {
        const auto first = subsets(n, p), second = subsets(n, q), both = subsets(n, p + q - n);
        size_ = static_cast<Index>(both.size());
        for (std::size_t i = 0; i < first.size(); ++i)
            for (std::size_t j = 0; j < second.size(); ++j) {
                const Axes I = complement(n, first[i]), J = complement(n, second[j]);
                Axes IJ = joined(I, J);
                const double order = permutation_sign(IJ);
                std::sort(IJ.begin(), IJ.end());
                if (std::adjacent_find(IJ.begin(), IJ.end()) != IJ.end())
                    continue;
                const Axes rest = complement(n, IJ);
                terms_.push_back({static_cast<Index>(i), static_cast<Index>(j),
                                  place_in(both, rest),
                                  order * permutation_sign(joined(first[i], I)) *
                                      permutation_sign(joined(second[j], J)) *
                                      permutation_sign(joined(rest, IJ))});
            }
    }

    Vector operator()(const Vector& v, const Vector& w) const {
        Vector result = Vector::Zero(size_);
        for (const auto& term : terms_)
            result[term.result] += term.sign * v[term.first] * w[term.second];
        return result;
    }

private:
    struct Term {
        Index first, second, result;
        double sign;
    };
    std::vector<Term> terms_;
    Index size_;
};

/// An n-simplex in orthonormal coordinates of its plane.
struct Chart {
    DenseMatrix corners;   // (n+1) x n, the first one 0
    DenseMatrix gradients; // of the barycentric coordinates, (n+1) x n
    double orientation;    // of the axes relative to the simplex

    Chart(const Pieces& complex, SimplexLayout& layout, Index t) {
        const int n = complex.dimension();
        corners = in_own_plane(layout.at(n, t));
        const DenseMatrix R = corners.bottomRows(n).transpose();
        gradients = DenseMatrix::Zero(n + 1, n);
        gradients.bottomRows(n) =
            R.triangularView<Eigen::Upper>().solve(DenseMatrix::Identity(n, n));
        gradients.row(0) = -gradients.bottomRows(n).colwise().sum();
        orientation = complex.orientation(t) * R.diagonal().array().sign().prod();
    }
};

/// Means of Whitney p-forms over n-simplices, as p-covectors in their charts.
class Means {
public:
    Means(const Pieces& complex, const Cochain& form)
        : complex_(complex),
          form_(form),
          faces_(complex, complex.dimension(), form.degree),
          product_(complex.dimension(), form.degree) {}

    Vector operator()(const Chart& chart, Index t) {
        const int p = form_.degree;
        const auto& faces = faces_.of(t);
        Vector sum = Vector::Zero(product_.size());
        for (std::size_t i = 0; i < faces.size(); ++i) {
            const double value = orientation(complex_, p, faces[i]) * form_.values[faces[i]];
            for (int omitted = 0; omitted <= p; ++omitted)
                sum += value * product_.without(omitted, faces_.positions()[i], chart.gradients);
        }
        return std::tgamma(p + 1.0) / (complex_.dimension() + 1) * sum;
    }

private:
    const Pieces& complex_;
    const Cochain& form_;
    SimplexFaces faces_;
    ExteriorProduct product_;
};

/// Weights of n-simplices in means over those around each m-simplex, by volume, times its volume: a
/// row for each n-simplex.
Points parts_of_means(const Geometry& geometry, int m) {
    const Pieces& complex = geometry.pieces();
    const int n = complex.dimension();
    const Vector &of = geometry.volumes().primal(m), &around = geometry.volumes().primal(n);
    SimplexFaces faces(complex, n, m);
    Vector sums = Vector::Zero(complex.size(m));
    Points parts(complex.size(n), faces.positions().size());
    for (Index t = 0; t < complex.size(n); ++t)
        for (const Index s : faces.of(t))
            sums[s] += around[t];
    for (Index t = 0; t < complex.size(n); ++t)
        for (std::size_t i = 0; i < faces.of(t).size(); ++i) {
            const Index s = faces.of(t)[i];
            parts(t, static_cast<Eigen::Index>(i)) = of[s] * around[t] / sums[s];
        }
    return parts;
}

/// The covector star^-1 (star a ^ star b) at the unit m-vector of s, summed over n-simplices with
/// the weights `parts`. If they are volumes of the parts of *s, this is the integral of star a ^
/// star b, because s and *s are orthogonal.
Vector product_of_stars(const Geometry& geometry, const Cochain& a, const Cochain& b,
                        const Points& parts) {
    const Pieces& complex = geometry.pieces();
    const int n = complex.dimension(), m = a.degree + b.degree - n;
    const Meet meet(n, a.degree, b.degree);
    const ExteriorProduct edges_of(n, m);
    Means first(complex, a), second(complex, b);
    SimplexFaces faces(complex, n, m);
    SimplexLayout layout(complex, geometry.metric());
    const Vector& volumes = geometry.volumes().primal(m);

    Vector values = Vector::Zero(complex.size(m));
    for (Index t = 0; t < complex.size(n); ++t) {
        const Chart chart(complex, layout, t);
        const Vector covector = chart.orientation * meet(first(chart, t), second(chart, t));
        const auto& of_simplex = faces.of(t);
        for (std::size_t i = 0; i < of_simplex.size(); ++i) {
            const Index s = of_simplex[i];
            auto corners = faces.positions()[i];
            const DenseMatrix origin = chart.corners.row(corners[0]);
            corners.erase(corners.begin());
            const DenseMatrix edges =
                chart.corners(corners, Eigen::indexing::all) - origin.replicate(corners.size(), 1);
            const double size = std::tgamma(m + 1.0) * volumes[s];
            values[s] += parts(t, static_cast<Eigen::Index>(i)) * orientation(complex, m, s) *
                         covector.dot(edges_of(edges)) / size;
        }
    }
    return values;
}

} // namespace

Cochain dual_wedge(const Discretization& mesh, const Cochain& a, const Cochain& b) {
    check_factors(mesh.complex(), Side::dual, a, b);
    refuse_flat_pieces(mesh, "the product of dual forms");
    const int n = mesh.dimension(), j = a.degree + b.degree, m = n - j;
    const Geometry& geometry = mesh.geometry();
    const auto lifted = [&](const Cochain& form) {
        const int p = n - form.degree;
        return on_pieces(mesh, {Side::primal, p, mesh.geometric_star(p).solve(form.values)});
    };
    const auto product = [&](const Points& parts) {
        return product_of_stars(geometry, lifted(a), lifted(b), parts);
    };
    if (mesh.chosen_stars().is_over_duals(m))
        return on_cells(
            mesh, {Side::dual, j, product(parts_of_duals(geometry, geometry.centers(), m, n))});
    const Vector means = product(parts_of_means(geometry, m));
    return {Side::dual, j,
            mesh.geometric_star(m) * on_cells(mesh, {Side::primal, m, means}).values};
}

} // namespace polydec
