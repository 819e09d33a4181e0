// SPDX-License-Identifier: MIT
#include "solvers/spectra/spectrum.h"

#include "backends/linear/auto_solver.h"
#include "base/errors.h"
#include "complex/homology.h"
#include "dec/discretization/advice.h"
#include "dec/discretization/positive_mass.h"
#include "dec/forms/cochain.h"
#include "meshes/unit_of_length.h"
#include "solvers/sources/hodge.h"
#include "solvers/spectra/laplacian_pencil.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace polydec {

namespace {

void check_count(const FormSpace& space, const SpectrumOptions& options) {
    const int k = space.cell_degree();
    if (space.size() == 0)
        throw InvalidInput(fmt::format(
            "{} {}-forms have no eigenvalues here: the conditions make them 0 on all {}-cells",
            name(space.side()), space.degree(), k));
    if (options.count < 1 || options.count > space.size())
        throw InvalidInput(fmt::format(
            "{} eigenvalues requested: {} {}-forms live on {} {}-cells, so expected 1 to {}",
            options.count, name(space.side()), space.degree(), space.size(), k, space.size()));
}

std::vector<std::string> warning_of_negative_values(const Spectrum& spectrum,
                                                    const HodgeStars& stars) {
    const int n = stars.dimension();
    const int k = spectrum.side == Side::primal ? spectrum.degree : n - spectrum.degree;
    const auto negative = ((spectrum.eigenvalues + spectrum.radii).array() < 0).count();
    std::size_t duals = 0;
    for (const int j : {k - 1, k + 1})
        if (j >= 0 && j <= n)
            duals += stars[j].negatives().size();
    if (negative == 0 || duals == 0)
        return {};
    return {
        fmt::format("{} of the eigenvalues {} negative and spurious: {} next to these forms {} "
                    "a negative dual (not Delaunay there, or a center beyond the boundary); use {}",
                    negative, negative == 1 ? "is" : "are",
                    duals == 1 ? "1 cell" : fmt::format("{} cells", duals),
                    duals == 1 ? "has" : "have", positive_stars(n))};
}

/// Linear functions enlarge the mass of a triangle by up to the eigenvalue times the sum of its
/// squared sides over 24.
std::optional<double> coarseness_of(const FormSpace& space, const Vector& eigenvalues) {
    const Cells cells = space.cells();
    const int n = cells.dimension(), degree = space.degree();
    const auto& fixed = space.conditions().fixed_vertices;
    if (!(degree == 0 || degree == n || (degree == 1 && n == 2)) ||
        std::find(fixed.begin(), fixed.end(), true) != fixed.end())
        return std::nullopt;
    if (degree > 0 && degree < n &&
        (space.robin_weights().size() > 0 || space.robin_layer().size() > 0))
        return std::nullopt; // shape_spectrum refuses Robin's condition there
    if (n != 2)
        return 0;
    const CellVolumes& volumes = cells.volumes();
    const Vector squares = cells.complex().boundary(2).cast<double>().cwiseAbs().transpose() *
                           volumes.primal(1).cwiseAbs2();
    return std::max(0.0, eigenvalues.maxCoeff()) * volumes.primal(2).dot(squares) /
           volumes.primal(2).sum() / 24;
}

/// The forms with the eigenvalue 0, if there are so many that a direct method is faster.
DenseMatrix kernel(const Cells& inside, const SpectrumOptions& options, int k, Index zeros,
                   bool is_dual_function) {
    constexpr Index many = 10;
    if (zeros < many)
        return {};
    if (options.progress)
        options.progress("harmonic forms");
    const DenseMatrix forms =
        harmonic_forms(FormSpace::vanishing_on(inside, Side::primal, k), options.linear_solver);
    return is_dual_function ? DenseMatrix(inside.stars()[k].matrix() * forms) : forms;
}

} // namespace

std::vector<std::string> warning_of_rough_values(const std::vector<Index>& rough) {
    if (rough.empty())
        return {};
    return {fmt::format(
        "{} of the eigenvalues, number {} first, {} not known to 1e-6, because of rounding errors "
        "relative to the largest one: check the radii, and improve cells of extreme shape",
        rough.size(), rough.front(), rough.size() == 1 ? "is" : "are")};
}

std::string advice_of_shape(const Spectrum& spectrum) {
    constexpr double much = 0.05;
    if (!spectrum.coarseness)
        return {};
    std::string advice = "shape_spectrum encloses the eigenvalues of the shape itself";
    if (*spectrum.coarseness > much)
        advice += fmt::format("; this mesh is coarse for the last ones, which may be {:.0f} % off",
                              100 * std::min(*spectrum.coarseness, 1.0));
    return advice;
}

void use_input_units(Spectrum& spectrum, int n, double unit) {
    if (unit == 1)
        return;
    auto& shift = spectrum.certificate.shift; // above all values, which are rounding only
    const double largest = std::max(spectrum.eigenvalues.cwiseAbs().maxCoeff(), std::abs(shift));
    in_input_units(Vector::Constant(1, largest), unit, -2, "eigenvalues");
    const auto convert = [&](double& value) { value = std::ldexp(value, -2 * std::ilogb(unit)); };
    std::for_each(spectrum.eigenvalues.begin(), spectrum.eigenvalues.end(), convert);
    std::for_each(spectrum.residuals.begin(), spectrum.residuals.end(), convert);
    std::for_each(spectrum.radii.begin(), spectrum.radii.end(), convert);
    convert(shift);
    try {
        spectrum.modes =
            in_input_units(spectrum.modes, unit, spectrum.degree - n / 2.0, "modes of norm 1");
    } catch (const InvalidInput& beyond) { // their eigenvalues are in range
        spectrum.modes.resize(spectrum.modes.rows(), 0);
        spectrum.warnings.emplace_back(beyond.what());
    }
    // the value and the radius each have an error of half the least positive number
    for (double& radius : spectrum.radii)
        if (radius < std::numeric_limits<double>::min())
            radius += std::numeric_limits<double>::denorm_min();
}

Spectrum spectrum(const FormSpace& space, const SpectrumOptions& options) {
    const int k = space.cell_degree();
    const Cells inside = space.inside();
    const CellComplex& complex = inside.complex();
    const HodgeStars& stars = inside.stars();
    check_count(space, options);
    check_positive_mass(stars[k], space.side(), space.degree());

    const bool is_dual_function = k == complex.dimension() && stars[k].is_diagonal();
    const SparseMatrix weights = space.free_robin_weights();
    const Index zeros = weights.size() > 0 ? 0 : betti_numbers(complex)[k];
    const auto pencil = [&] {
        Pencil of_laplacian = is_dual_function ? dual_function_pencil(complex, stars, k)
                                               : laplacian_pencil(complex, stars, k);
        of_laplacian.C = weights;
        return of_laplacian;
    };
    CertifiedEigensolver solver(pencil(), // which the solver copies
                                {.linear_solver = options.linear_solver,
                                 .eigen_solver = options.eigen_solver,
                                 .certification = options.certification,
                                 .domain_dimension = complex.dimension(),
                                 .definiteness = laplacian_definiteness(stars, k),
                                 .zeros = zeros,
                                 .kernel = kernel(inside, options, k, zeros, is_dual_function),
                                 .progress = options.progress,
                                 .found = options.found,
                                 .start = options.start});
    auto pairs = solver.smallest(options.count);
    pairs.vectors = space.extend(pairs.vectors);
    const HodgeStar star = space.cells().stars()[k];
    if (space.side() == Side::dual && !is_dual_function)
        pairs.vectors = SparseMatrix(star.matrix()) * pairs.vectors;
    if (space.side() == Side::primal && is_dual_function)
        pairs.vectors = star.inverse().asDiagonal() * pairs.vectors;
    Spectrum result{space.side(),
                    space.degree(),
                    std::move(pairs.values),
                    std::move(pairs.radii),
                    std::move(pairs.vectors),
                    std::move(pairs.residuals),
                    pairs.certificate,
                    std::move(pairs.linear_solver),
                    std::move(pairs.eigen_solver),
                    std::move(pairs.rough)};
    result.coarseness = coarseness_of(space, result.eigenvalues);
    result.warnings = warning_of_negative_values(result, stars);
    for (auto& warning : warning_of_rough_values(result.rough))
        result.warnings.push_back(std::move(warning));
    if (auto missed = take_missed_engines(); !missed.empty())
        result.warnings.push_back(std::move(missed));
    use_input_units(result, complex.dimension(), inside.unit());
    return result;
}

} // namespace polydec
