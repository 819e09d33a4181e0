// SPDX-License-Identifier: MIT
#include "shape/poisson_error.h"

#include "base/checks.h"
#include "base/errors.h"
#include "shape/measured_simplex.h"
#include "shape/poisson_pair.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace polydec {

namespace {

void check_source(const char* what, const Shape& shape, const DenseMatrix& source) {
    const int n = shape.pieces.dimension();
    if (source.rows() != shape.pieces.size(n) || (source.cols() != 1 && source.cols() != n + 1))
        throw InvalidInput(fmt::format("{}: {} x {} numbers; expected one row for each of the {} "
                                       "simplices, of 1 number or of {}, one for each corner",
                                       what, source.rows(), source.cols(), shape.pieces.size(n),
                                       n + 1));
    for (Eigen::Index i = 0; i < source.rows(); ++i)
        if (!source.row(i).allFinite())
            throw InvalidInput(fmt::format("{} of row {} is not a finite number", what, i));
}

void check(const PoissonProblem& problem, const Vector& values) {
    const Shape& shape = problem.shape;
    polydec::check(shape);
    if (shape.functions != ShapeFunctions::ordinary)
        throw InvalidInput("the error is known only for ordinary functions, not for twisted ones");
    check_source("source", shape, problem.source);
    if (problem.flow.size() != 0)
        check_values("flows through facets", problem.flow,
                     shape.pieces.size(shape.pieces.dimension() - 1));
    check_values("values at vertices", values, shape.pieces.size(0));
}

/// A problem in units in which its numbers are near 1: powers of 2, those of lengths and kappa
/// even.
struct InUnits {
    PoissonProblem problem;
    int length = 0, value = 0, kappa = 0;

    InUnits(const PoissonProblem& given, double largest_value) : problem(given) {
        const auto exponent = [](double x) { return x > 0 ? std::ilogb(x) : -100'000; };
        const auto largest = [](const auto& x) {
            return x.size() > 0 ? double(x.cwiseAbs().maxCoeff()) : 0.0;
        };
        const auto even = [](int x) { return 2 * (x / 2); };
        Shape& shape = problem.shape;
        length = shape.lengths.size() > 0 ? even(exponent(shape.lengths.maxCoeff())) : 0;
        kappa = shape.conductivity.size() > 0 ? even(exponent(shape.conductivity.maxCoeff())) : 0;
        value = std::max({exponent(largest_value),
                          exponent(largest(problem.source)) + 2 * length - kappa,
                          exponent(largest(problem.flow)) + length - kappa});
        if (value < -90'000)
            value = 0;
        scale(shape.lengths, -length);
        scale(shape.conductivity, -kappa);
        for (double& coefficient : shape.conditions.coefficients)
            coefficient = std::ldexp(coefficient, length - kappa);
        scale(problem.source, 2 * length - kappa - value);
        scale(problem.flow, length - kappa - value);
    }

    template <class Numbers>
    static void scale(Numbers& numbers, int exponent) {
        numbers = numbers.unaryExpr([&](double x) { return std::ldexp(x, exponent); }).eval();
    }

    Vector in_unit(Vector values) const {
        scale(values, -value);
        return values;
    }

    /// Of norms of a value times lengths to the power n / 2 - derivatives.
    double norm(double number, int derivatives, bool has_kappa) const {
        const int n = problem.shape.pieces.dimension();
        return std::ldexp(number, value + (n - 2 * derivatives) * (length / 2) +
                                      (has_kappa ? kappa / 2 : 0));
    }

    /// Whether a number in these units is still known to all digits in the units given.
    static bool is_in_range(double in_units, double given) {
        return std::isfinite(given) &&
               (in_units == 0 || std::abs(given) >= std::numeric_limits<double>::min());
    }

    /// Back to those of the problem given. Throws InvalidInput for errors out of range.
    void restore(PoissonError& error) const {
        const double energy = error.energy, l2 = error.l2.value_or(0);
        for (double* number :
             {&error.energy, &error.averaged_gradient, &error.size, &error.oscillation})
            *number = norm(*number, 1, true);
        scale(error.gradients, value);
        const auto last = error.gradients.cols() - 1;
        Vector slopes = error.gradients.col(last);
        scale(slopes, -2 * length);
        error.gradients.col(last) = slopes;
        if (!is_in_range(energy, error.energy) || !std::isfinite(error.size) ||
            !error.gradients.allFinite())
            throw InvalidInput(
                "the error is outside the range of double precision: use other units");
        if (error.l2)
            error.l2 = norm(*error.l2, 0, false);
        if (error.l2 && !is_in_range(l2, *error.l2)) {
            error.l2 = std::nullopt;
            error.warnings.push_back(
                "the L2 error is outside the range of double precision: use other units");
        }
    }
};

/// What each simplex adds to the square of the distance of flux and gradient, and of the rest of
/// f; the first without that rest.
struct Squares {
    Vector distance, all;

    Squares(const PoissonForms& forms, const PoissonPair& pair, const LocalData& data)
        : distance(forms.products(pair, pair).cwiseMax(0)), all(distance) {
        const double share =
            pair.rounding * pair.rounding / double(std::max<Index>(distance.size(), 1));
        for (Eigen::Index s = 0; s < all.size(); ++s)
            all[s] = std::pow(std::sqrt(distance[s]) + data.oscillation[s], 2) + share;
    }
};

/// Sums of many positive numbers, with what they are off by.
double root_of_sum(const Vector& squares, double rounding) {
    return std::sqrt(squares.sum()) * (1 + 1e-12) + rounding;
}

/// The share by which a(v, v) may be off, as lengths may be by rounding. Throws InvalidInput,
/// naming the simplex, where that says nothing.
double energy_share(const Shape& shape) {
    const double d = metric_share(shape);
    const double share = std::pow((1 + d) / (1 - d), shape.pieces.dimension() / 2.0 + 1) - 1;
    if (!(share < 0.5))
        throw InvalidInput("rounding of lengths hides the error: flip edges, or improve or remove "
                           "flat simplices");
    return share;
}

/// The gradient of u_h and the flux over kappa, averaged.
DenseMatrix averaged_gradients(const PoissonForms& forms, const PoissonPair& pair) {
    const int n = forms.dimension();
    DenseMatrix result(forms.simplices(), n + 2);
    result.leftCols(n + 1) = pair.corners - n / 2.0 * pair.change.cast<double>();
    for (Index s = 0; s < forms.simplices(); ++s)
        result(s, n + 1) = -pair.source[s] / (2 * n * conductivity_of(forms.shape(), s));
    return result;
}

std::optional<double> l2_error(const PoissonForms& forms, const DenseMatrix& corners,
                               const LocalData& data, const std::string& engine) {
    const auto constant = l2_constant_squared(forms, engine);
    if (!constant)
        return std::nullopt;
    const PoissonForms::Solution found = forms.to_galerkin(corners, data);
    const auto norm = [&](DenseMatrix change) {
        Vector integrals(forms.simplices());
        for (Index s = 0; s < forms.simplices(); ++s)
            integrals[s] = forms.volumes()[s] * change.row(s).mean();
        change.colwise() -= forms.free_means(integrals);
        double square = 0;
        for (Index s = 0; s < forms.simplices(); ++s)
            square += forms.mass(s, change, change);
        return std::sqrt(square) * (1 + 1e-12);
    };
    const DenseMatrix change = found.values.cast<double>();
    const PoissonPair galerkin = forms.pair(corners + change, data);
    const double energy = root_of_sum(Squares(forms, galerkin, data).all, galerkin.rounding);
    return std::sqrt(*constant) * energy + norm(change) + norm(found.last_step);
}

/// The norm of S in docs/what-is-proved.md.
double distance(const PoissonForms& forms, const PoissonPair& pair) {
    return root_of_sum(forms.products(pair, pair).cwiseMax(0), pair.rounding);
}

/// A bound on F(v) over the energy norm of v, for any v that vanishes on essential facets, however
/// the signs of simplices and facets in F may be changed.
double load_of_any_signs(const PoissonForms& forms, const DenseMatrix& source, const Vector& flow) {
    const LocalData sizes = forms.local(source.cwiseAbs(), flow.cwiseAbs());
    const DenseMatrix zero = DenseMatrix::Zero(forms.simplices(), forms.dimension() + 1);
    return distance(forms, forms.pair(zero, sizes)) + sizes.oscillation.norm();
}

/// By how much a goal may differ on shapes of the lengths allowed, where energies and loads of
/// simplices and facets differ by a share. The error of u is known.
double change_of_goal(const PoissonForms& forms, const PoissonProblem& problem,
                      const DenseMatrix& goal, const DenseMatrix& u, double error, double share) {
    const double of_f = load_of_any_signs(forms, problem.source, problem.flow),
                 of_goal = load_of_any_signs(forms, goal, {}),
                 on_u = forms.load(forms.local(goal.cwiseAbs(), {}), u.cwiseAbs()),
                 size = std::sqrt(std::max(forms.energy(u, u), 0.0)) + error;
    return share * (on_u + of_goal * (error + (1 + 2 * share / (1 - share)) * (of_f + size)));
}

} // namespace

PoissonError poisson_error(const PoissonProblem& given, const Vector& values,
                           const PoissonErrorOptions& options) {
    check(given, values);
    const InUnits units(given, values.cwiseAbs().maxCoeff());
    const PoissonProblem& problem = units.problem;
    const PoissonForms forms(problem.shape, options.linear_solver);
    const LocalData data = forms.local(problem.source, problem.flow);
    const DenseMatrix corners = forms.at_corners(units.in_unit(values));
    const PoissonPair pair = forms.pair(corners, data);
    const Squares squares(forms, pair, data);
    PoissonError error;
    const double sum = squares.all.sum();
    error.shares = sum > 0 ? Vector(squares.all / sum) : squares.all;
    error.energy = root_of_sum(squares.all, pair.rounding);
    error.oscillation = data.oscillation.norm();
    error.averaged_gradient =
        root_of_sum(squares.distance, pair.rounding) / 2 + error.oscillation + pair.rounding;
    error.size = std::sqrt(std::max(forms.of_gradients(corners, corners), 0.0));
    error.gradients = averaged_gradients(forms, pair);
    const double rounding = energy_share(problem.shape),
                 size = std::sqrt(std::max(forms.energy(corners, corners), 0.0));
    for (double* number : {&error.energy, &error.averaged_gradient})
        *number = (1 + rounding) * (*number + rounding / (1 - rounding) * (size + error.energy));
    if (options.l2_limit > 0 && forms.simplices() > options.l2_limit) {
        error.warnings.push_back(fmt::format(
            "the bound of the L2 error takes too long above {} simplices", options.l2_limit));
    } else if (options.l2_limit > 0 && rounding > 1e-9) {
        error.warnings.push_back("rounding of lengths hides the L2 error: flip edges, or improve "
                                 "or remove flat simplices");
    } else if (options.l2_limit > 0) {
        error.l2 = l2_error(forms, corners, data, options.linear_solver);
        if (!error.l2)
            error.warnings.push_back(
                "the bound of the L2 error needs a count of eigenvalues, which failed; flip edges, "
                "or improve cells that are much smaller or flatter than others");
    }
    units.restore(error);
    return error;
}

Enclosed goal_interval(const PoissonProblem& given, const Vector& values, const DenseMatrix& goal,
                       const PoissonErrorOptions& options) {
    check(given, values);
    check_source("goal", given.shape, goal);
    const InUnits units(given, values.cwiseAbs().maxCoeff());
    const PoissonForms forms(units.problem.shape, options.linear_solver);
    if (forms.vertices().kernel.cols() > 0)
        throw InvalidInput(
            "a goal needs a unique solution, but this one is known up to constants: give values or "
            "Robin conditions on a part of the boundary of every component");
    const double largest = goal.cwiseAbs().maxCoeff();
    const int unit = largest > 0 ? std::ilogb(largest) : 0;
    DenseMatrix scaled = goal;
    InUnits::scale(scaled, -unit);

    const LocalData data = forms.local(units.problem.source, units.problem.flow),
                    wanted = forms.local(scaled, {});
    const DenseMatrix u = forms.at_corners(units.in_unit(values));
    const DenseMatrix z =
        forms.to_galerkin(DenseMatrix::Zero(u.rows(), u.cols()), wanted).values.cast<double>();
    const PoissonPair first = forms.pair(u, data), second = forms.pair(z, wanted);
    const double value = forms.load(wanted, u) + forms.load(data, z) - forms.energy(u, z) +
                         forms.products(first, second).sum() / 2;
    const double a = distance(forms, first), b = distance(forms, second),
                 rest = data.oscillation.norm(), rest_of_goal = wanted.oscillation.norm();
    constexpr double rounding = 1e-13; // of sums
    const double half = a * b / 2 + rest * b + a * rest_of_goal + rest * rest_of_goal +
                        first.rounding * b + a * second.rounding +
                        change_of_goal(forms, units.problem, scaled, u, a + rest,
                                       energy_share(units.problem.shape) + rounding);
    const auto restored = [&](double number) {
        const int n = forms.dimension();
        return std::ldexp(number, unit + units.value + n * units.length);
    };
    const Enclosed found{restored(value - half), restored(value), restored(value + half)};
    if (!std::isfinite(found.lower) || !std::isfinite(found.upper) ||
        !InUnits::is_in_range(half, restored(half)))
        throw InvalidInput("the goal is outside the range of double precision: use other units");
    return found;
}

PoissonProblem poisson_problem(const Discretization& mesh, const BoundaryConditions& conditions,
                               const CellData& conductivity, const Vector& f, const Vector& flow) {
    PoissonProblem problem{.shape = shape_of(mesh, conditions, conductivity), .source = {}};
    const Pieces& pieces = mesh.pieces();
    const int n = pieces.dimension();
    if (mesh.complex().size(0) != pieces.size(0))
        throw InvalidInput("vertices inside merged cells have no values: discretize the mesh with "
                           "the criterion none");
    const Simplices& corners = pieces.simplices(n);
    check_values("values of f", f, mesh.complex().size(0));
    if (flow.size() > 0)
        check_values("flow", flow, mesh.complex().size(n - 1));
    problem.source.resize(corners.rows(), n + 1);
    for (Index s = 0; s < corners.rows(); ++s)
        for (int i = 0; i <= n; ++i)
            problem.source(s, i) = f[corners(s, i)];
    const auto& facets = mesh.merging().carriers(n - 1);
    problem.flow = Vector::Zero(flow.size() > 0 ? pieces.size(n - 1) : 0);
    for (Index e = 0; e < problem.flow.size(); ++e)
        if (facets[e].dimension == n - 1)
            problem.flow[e] = flow[facets[e].cell];
    return problem;
}

} // namespace polydec
