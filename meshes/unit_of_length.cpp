// SPDX-License-Identifier: MIT
#include "meshes/unit_of_length.h"

#include "base/exponent.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace polydec {

namespace {

/// Of lengths within 2^-40 .. 2^40 six factors make 2^-240 .. 2^240: the square of that, and of
/// a volume in six dimensions, is far from the ends of the range.
constexpr int moderate = 40, moderate_product = 240;

/// The largest exponent that leaves all coordinates finite.
constexpr int finite_exponent = std::numeric_limits<double>::max_exponent - 1;

double unit_for(double half_of_longest, int dimension, int least) {
    if (!(half_of_longest > 0) || !std::isfinite(half_of_longest))
        return 1; // nothing to be measured
    const int exponent = std::ilogb(half_of_longest) + 1;
    if (std::abs(exponent) <= std::min(moderate, moderate_product / std::max(dimension, 1)))
        return 1;
    const int even = exponent - (exponent & 1);
    return std::ldexp(1.0, std::clamp(even, least + (least & 1), finite_exponent - 1));
}

[[noreturn]] void refuse(double value, double unit, double power, std::string_view what) {
    if (!std::isfinite(value))
        throw InvalidInput(fmt::format("{}: {} is not a finite number", what, value));
    throw OutOfRange(fmt::format("{0}: {1:.3g} times {3:.3g}^{2} is outside the range of double "
                                 "precision; scale the mesh to a size nearer to 1",
                                 what, value, power, unit));
}

} // namespace

double half_of_longest_edge(const Points& points, const Simplices& simplices) {
    double longest = 0; // halves, which cannot overflow
    const Eigen::Index N = points.cols(), width = simplices.cols();
    for (Eigen::Index cell = 0; cell < simplices.rows(); ++cell)
        for (Eigen::Index c = 0; c < N; ++c) {
            const Index* const corners = simplices.data() + cell * width;
            double least = 0.5 * points.data()[corners[0] * N + c], most = least;
            for (Eigen::Index i = 1; i < width; ++i) {
                const double half = 0.5 * points.data()[corners[i] * N + c];
                least = std::min(least, half);
                most = std::max(most, half);
            }
            longest = std::max(longest, most - least);
        }
    return longest;
}

double unit_of_length(double half_of_longest, double farthest, int dimension) {
    const int least = farthest > 0 && std::isfinite(farthest)
                          ? std::ilogb(farthest) - finite_exponent
                          : -finite_exponent;
    return unit_for(half_of_longest, dimension, std::max(least, -finite_exponent + 1));
}

double unit_of_length(const Mesh& mesh) {
    // a vertex of no cell may lie far out
    const double farthest = mesh.points.size() > 0 ? mesh.points.cwiseAbs().maxCoeff() : 0;
    return unit_of_length(half_of_longest_edge(mesh.points, mesh.simplices), farthest,
                          mesh.dimension());
}

double unit_of_length(const LengthMesh& mesh) {
    const double longest = mesh.lengths.size() > 0 ? mesh.lengths.maxCoeff() : 0;
    return unit_for(longest / 2, mesh.dimension(), -finite_exponent + 1);
}

Points in_units(Points points, double unit) {
    const int exponent = std::ilogb(unit);
    for (double& coordinate : points.reshaped())
        coordinate = std::ldexp(coordinate, -exponent);
    return points;
}

Mesh in_units(Mesh mesh, double unit) {
    mesh.points = in_units(std::move(mesh.points), unit);
    return mesh;
}

std::optional<double> in_input_units(double value, double unit, double power) {
    if (unit == 1 || value == 0)
        return value;
    const double result = std::ldexp(value, static_cast<int>(power * std::ilogb(unit)));
    if (!std::isnormal(result))
        return std::nullopt;
    return result;
}

Vector in_input_units(const Vector& values, double unit, double power, std::string_view what) {
    Vector result = values;
    const double rounding =
        values.size() > 0 ? std::numeric_limits<double>::epsilon() * values.cwiseAbs().maxCoeff()
                          : 0;
    for (double& value : result) {
        auto scaled = in_input_units(value, unit, power);
        if (!scaled && std::isfinite(value) && std::abs(value) <= rounding)
            scaled = 0;
        if (!scaled)
            refuse(value, unit, power, what);
        value = *scaled;
    }
    return result;
}

SparseMatrix in_input_units(SparseMatrix matrix, double unit, double power, std::string_view what) {
    if (unit == 1)
        return matrix;
    matrix.makeCompressed();
    matrix.coeffs() = in_input_units(Vector(matrix.coeffs()), unit, power, what).array();
    return matrix;
}

Vector form_in_input_units(const Vector& values, double unit, double power, std::string_view what) {
    if (unit == 1 || values.size() == 0)
        return values;
    const double largest = values.cwiseAbs().maxCoeff();
    if (!in_input_units(largest, unit, power))
        refuse(largest, unit, power, what);
    const int exponent = static_cast<int>(power * std::ilogb(unit));
    return values.unaryExpr([&](double value) { return std::ldexp(value, exponent); });
}

} // namespace polydec
