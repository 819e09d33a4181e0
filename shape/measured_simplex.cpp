// SPDX-License-Identifier: MIT
#include "shape/measured_simplex.h"

#include "base/errors.h"
#include "dec/metric/simplex_geometry.h"
#include "shape/gluing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace polydec {

namespace {

LongMatrix squares_of(const Shape& shape, Index simplex) {
    const int n = shape.pieces.dimension();
    LongMatrix squares = LongMatrix::Zero(n + 1, n + 1);
    for (int j = 1; j <= n; ++j)
        for (int i = 0; i < j; ++i) {
            const std::array<int, 2> corners{i, j};
            const long double length = shape.lengths[face_at(shape.pieces, n, simplex, corners)];
            squares(i, j) = squares(j, i) = length * length;
        }
    return squares;
}

/// Cholesky's factor of the products of the edges from a corner; empty if there is none.
LongMatrix edge_factor(const LongMatrix& squares, int origin) {
    const auto n = squares.rows() - 1;
    const auto corner = [origin](Eigen::Index i) { return i < origin ? i : i + 1; };
    LongMatrix L = LongMatrix::Zero(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j <= i; ++j) {
            long double rest = (squares(origin, corner(i)) + squares(origin, corner(j)) -
                                squares(corner(i), corner(j))) /
                               2;
            for (Eigen::Index k = 0; k < j; ++k)
                rest -= L(i, k) * L(j, k);
            if (i == j && !(rest > 0))
                return {};
            L(i, j) = i == j ? std::sqrt(rest) : rest / L(j, j);
        }
    return L;
}

/// The corners of the shortest edge, ascending.
std::array<int, 2> shortest_edge(const LongMatrix& squares) {
    std::array<int, 2> ends{0, 1};
    for (int j = 1; j < squares.rows(); ++j)
        for (int i = 0; i < j; ++i)
            if (squares(i, j) < squares(ends[0], ends[1]))
                ends = {i, j};
    return ends;
}

std::string name_of(const Shape& shape, Index simplex) {
    const int n = shape.pieces.dimension();
    return fmt::format("simplex {} (vertices {})", simplex,
                       fmt::join(shape.pieces.vertex_numbers(n, simplex), ", "));
}

} // namespace

long double MeasuredSimplex::facet_volume(int omitted) const {
    return dimension() * volume * std::sqrt(gradients(omitted, omitted));
}

MeasuredSimplex measured_simplex(const Shape& shape, Index simplex) {
    if (auto found = measured_simplex(squares_of(shape, simplex)))
        return std::move(*found);
    throw InvalidInput(
        fmt::format("{} has no volume, or no simplex has its edge lengths: correct the lengths",
                    name_of(shape, simplex)));
}

std::optional<MeasuredSimplex> measured_simplex(LongMatrix squares) {
    MeasuredSimplex result;
    result.squares = std::move(squares);
    const auto [origin, end] = shortest_edge(result.squares);
    result.origin = origin;
    result.shortest_square = static_cast<double>(result.squares(origin, end));
    const LongMatrix L = edge_factor(result.squares, result.origin);
    if (L.size() == 0)
        return std::nullopt;
    const auto n = L.rows();
    const LongMatrix inverse = L.triangularView<Eigen::Lower>().solve(LongMatrix::Identity(n, n));
    LongMatrix all = LongMatrix::Zero(n, n + 1); // gradients, a column each
    for (Eigen::Index i = 0; i < n; ++i) {
        all.col(i < result.origin ? i : i + 1) = inverse.col(i);
        all.col(result.origin) -= inverse.col(i);
    }
    result.gradients = all.transpose() * all;
    result.volume = 1;
    for (Eigen::Index i = 0; i < n; ++i)
        result.volume *= L(i, i) / (i + 1);
    result.longest_square = static_cast<double>(result.squares.maxCoeff());
    long double sensitivity = 0; // |v|^2 = -sum squares_ij v_i v_j, |v_i| <= |v| |grad lambda_i|
    for (Eigen::Index j = 1; j <= n; ++j)
        for (Eigen::Index i = 0; i < j; ++i)
            sensitivity += 2 * result.squares(i, j) *
                           std::sqrt(result.gradients(i, i) * result.gradients(j, j));
    result.sensitivity = static_cast<double>(sensitivity);
    return result;
}

double poincare_square(int n) {
    return n == 2 ? 1 / 14.68 : 1 / 9.8696;
}

namespace {

struct Worst {
    double sensitivity;
    Index simplex;
};

Worst worst_of(const Shape& shape) {
    Worst worst{0, 0};
    for (Index s = 0; s < shape.pieces.size(shape.pieces.dimension()); ++s)
        if (const double here = measured_simplex(shape, s).sensitivity; here > worst.sensitivity)
            worst = {here, s};
    return worst;
}

/// Forms on a simplex, and their factors 1, s and s^2 for eigenvalues s, must be in range.
void check_size(const Shape& shape) {
    constexpr long double most = 1e250L;
    const int n = shape.pieces.dimension();
    for (Index s = 0; s < shape.pieces.size(n); ++s) {
        const auto simplex = measured_simplex(shape, s);
        const long double kappa = conductivity_of(shape, s), rho = density_of(shape, s),
                          mass = rho * simplex.volume,
                          eigenvalue = kappa / rho * simplex.gradients.maxCoeff();
        for (const long double number : {mass, mass * eigenvalue, eigenvalue * eigenvalue,
                                         mass * rho / kappa * simplex.longest_square})
            if (!(number >= 1 / most && number <= most))
                throw InvalidInput(
                    fmt::format("{} with edges of up to {:.3g}, conductivity {:.3g} and density "
                                "{:.3g} gives numbers outside the range of double precision: use "
                                "units in which these are nearer to 1",
                                name_of(shape, s), std::sqrt(simplex.longest_square),
                                static_cast<double>(kappa), static_cast<double>(rho)),
                    {.degree = n, .cells = {s}, .vertices = shape.pieces.vertex_numbers(n, s)});
    }
}

} // namespace

double most_sensitivity(const Shape& shape) {
    return worst_of(shape).sensitivity;
}

double metric_share(const Shape& shape) {
    // lengths are squared, and gradients found, in long numbers
    const double error =
        shape.length_error + 8 * static_cast<double>(std::numeric_limits<long double>::epsilon());
    const Worst worst = worst_of(shape);
    const double share = worst.sensitivity * error * (1 + error) + shape.metric_error;
    if (!(share < 0.5))
        throw InvalidInput(fmt::format("{} is so flat, or refined so far from the origin, that "
                                       "rounding of its edge lengths changes its shape: flip "
                                       "edges, improve or remove flat simplices, or move the mesh",
                                       name_of(shape, worst.simplex)));
    return share;
}

double metric_ratio(const Shape& shape) {
    check_size(shape);
    const double d = metric_share(shape);
    return (1 - d) * std::pow((1 - d) / (1 + d), shape.pieces.dimension() / 2.0);
}

} // namespace polydec
