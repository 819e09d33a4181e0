// SPDX-License-Identifier: MIT
#include "dec/boundary/boundary_conditions.h"

#include "base/checks.h"
#include "base/errors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace polydec {

namespace {

void check_facets(const CellComplex& complex, const BoundaryConditions& conditions) {
    const int n = complex.dimension();
    if (!conditions.facets.empty() &&
        static_cast<Index>(conditions.facets.size()) != complex.size(n - 1))
        throw InvalidInput(fmt::format("{} boundary conditions are given: expected one for each of "
                                       "the {} {}-cells, or one for all",
                                       conditions.facets.size(), complex.size(n - 1), n - 1));
}

/// For a form of this degree; `where` is "the boundary" or a number of its facets.
std::string in_words(BoundaryCondition condition, int degree, int n, const BoundaryData& data,
                     const std::string& where) {
    if (condition == BoundaryCondition::robin)
        return fmt::format("{} times a coefficient plus flow {} on {} ({})",
                           degree > 0 && degree < n ? "tangential part" : "values",
                           data.flow ? "given" : "0", where,
                           degree > 0 && degree < n ? "impedance" : "Robin");
    const bool essential = condition == BoundaryCondition::essential;
    if (degree > 0 && degree < n)
        return fmt::format("{} part {} on {}", essential ? "tangential" : "normal",
                           (essential ? data.values : data.flow) ? "given" : "0", where);
    // the star maps an n-form to its density, a 0-form
    if (essential == (degree == 0))
        return fmt::format("values {} on {} (Dirichlet)", data.values ? "given" : "0", where);
    return fmt::format("{} through {} (Neumann)", data.flow ? "flow given" : "no flow", where);
}

} // namespace

BoundaryConditions built_in_conditions(Side side) {
    return {side == Side::primal ? BoundaryCondition::natural : BoundaryCondition::essential};
}

BoundaryConditions exchanged(BoundaryConditions conditions) {
    const auto other = [](BoundaryCondition condition) {
        return condition == BoundaryCondition::essential ? BoundaryCondition::natural
               : condition == BoundaryCondition::natural ? BoundaryCondition::essential
                                                         : condition;
    };
    conditions.everywhere = other(conditions.everywhere);
    std::transform(conditions.facets.begin(), conditions.facets.end(), conditions.facets.begin(),
                   other);
    return conditions;
}

Vector robin_coefficients(const CellComplex& complex, const BoundaryConditions& conditions) {
    check_facets(complex, conditions);
    const int n = complex.dimension();
    const std::vector<double>& given = conditions.coefficients;
    Vector result = Vector::Zero(complex.size(n - 1));
    for (const auto& [f, cell, outward] : boundary_facets(complex)) {
        if (conditions.at(f) != BoundaryCondition::robin)
            continue;
        if (given.size() != 1 && std::ssize(given) != result.size())
            throw InvalidInput(fmt::format("{} Robin coefficients are given: expected one for all "
                                           "facets, or one for each of the {} {}-cells",
                                           given.size(), result.size(), n - 1));
        result[f] = given.size() == 1 ? given[0] : given[f];
        if (!(result[f] > 0) || !std::isfinite(result[f]))
            throw InvalidInput(
                fmt::format("the Robin coefficient at {}-cell {} is {}: expected a positive "
                            "number; instead of 0, use the natural condition",
                            n - 1, f, result[f]),
                {.degree = n - 1, .cells = {f}});
    }
    return result;
}

void refuse_robin(const CellComplex& complex, const BoundaryConditions& conditions,
                  const char* what) {
    check_facets(complex, conditions);
    const int n = complex.dimension();
    for (const auto& [f, cell, outward] : boundary_facets(complex))
        if (conditions.at(f) == BoundaryCondition::robin)
            throw InvalidInput(
                fmt::format("facet {} has a Robin condition, which is not supported for {}: use "
                            "PoissonSolver, Diffusion or spectrum of other forms, or another "
                            "condition",
                            f, what),
                {.degree = n - 1, .cells = {f}});
}

BoundaryCounts boundary_counts(const CellComplex& complex, const BoundaryConditions& conditions) {
    check_facets(complex, conditions);
    BoundaryCounts on;
    on.fixed_vertices =
        std::count(conditions.fixed_vertices.begin(), conditions.fixed_vertices.end(), true);
    for (const auto& [f, cell, outward] : boundary_facets(complex)) {
        ++on.facets;
        on.essential += conditions.at(f) == BoundaryCondition::essential ? 1 : 0;
        on.robin += conditions.at(f) == BoundaryCondition::robin ? 1 : 0;
    }
    return on;
}

std::string in_words(const BoundaryCounts& on, int degree, int n, const BoundaryData& data) {
    std::vector<std::string> parts;
    const auto add = [&](BoundaryCondition condition, std::int64_t count) {
        if (count > 0)
            parts.push_back(in_words(
                condition, degree, n, data,
                count == on.facets ? "the boundary"
                                   : fmt::format("{} of {} boundary facets", count, on.facets)));
    };
    add(BoundaryCondition::essential, on.essential);
    add(BoundaryCondition::natural, on.facets - on.essential - on.robin);
    add(BoundaryCondition::robin, on.robin);
    if (on.facets == 0)
        parts.emplace_back("no boundary");
    if (on.fixed_vertices > 0)
        parts.push_back(fmt::format("values {} at {} vert{}", data.values ? "given" : "0",
                                    on.fixed_vertices, on.fixed_vertices == 1 ? "ex" : "ices"));
    return fmt::format("{}", fmt::join(parts, ", "));
}

void require_facets(const std::string& what, bool is_used, std::int64_t facets,
                    const char* expected) {
    if (!what.empty() && !is_used && facets > 0)
        throw InvalidInput(fmt::format("{} would apply at none of the {} boundary facets: "
                                       "expected {}; else omit it",
                                       what, facets, expected));
}

void require_use(const BoundaryCounts& on, const NamedData& data) {
    const char* other = "a facet that is not essential (see BoundaryConditions::essential)";
    require_facets(data.values, on.essential + on.fixed_vertices > 0, on.facets,
                   "an essential facet or a fixed vertex (see BoundaryConditions::essential)");
    require_facets(data.flow, on.essential < on.facets, on.facets, other);
    require_facets(data.robin, on.robin > 0, on.facets, other);
}

BoundaryConditions BoundaryConditions::essential(const std::vector<bool>& marks) const {
    BoundaryConditions result = *this;
    result.facets.resize(marks.size(), everywhere);
    for (std::size_t f = 0; f < marks.size(); ++f)
        if (marks[f])
            result.facets[f] = BoundaryCondition::essential;
    return result;
}

BoundaryConditions BoundaryConditions::robin(const std::vector<bool>& marks,
                                             double coefficient) const {
    BoundaryConditions result = essential(marks);
    const double others = coefficients.size() == 1 ? coefficients[0] : 0;
    if (coefficients.size() <= 1)
        result.coefficients.assign(marks.size(), others);
    for (std::size_t f = 0; f < std::min(marks.size(), result.coefficients.size()); ++f)
        if (marks[f]) {
            result.facets[f] = BoundaryCondition::robin;
            result.coefficients[f] = coefficient;
        }
    return result;
}

BoundaryConditions essential_where(const Points& sites,
                                   const std::function<bool(const Vector& site)>& predicate) {
    check_callable("the predicate of facets", predicate);
    std::vector<bool> marks;
    for (Index f = 0; f < sites.rows(); ++f)
        marks.push_back(predicate(sites.row(f).transpose()));
    return BoundaryConditions(BoundaryCondition::natural).essential(marks);
}

BoundaryConditions robin_elsewhere(BoundaryConditions conditions, double coefficient) {
    const auto replace = [](BoundaryCondition& condition) {
        if (condition == BoundaryCondition::natural)
            condition = BoundaryCondition::robin;
    };
    replace(conditions.everywhere);
    std::for_each(conditions.facets.begin(), conditions.facets.end(), replace);
    conditions.coefficients = {coefficient};
    return conditions;
}

CellMarks essential_cells(const CellComplex& complex, const BoundaryConditions& conditions,
                          Side side, int degree) {
    check_facets(complex, conditions);
    const auto vertices = static_cast<Index>(conditions.fixed_vertices.size());
    if (vertices > 0 && (side == Side::dual || degree > 0))
        throw InvalidInput("values are given at vertices, which only primal 0-forms support: give "
                           "values of other forms on boundary facets");
    const BoundaryConditions on_facets = side == Side::primal ? conditions : exchanged(conditions);
    CellMarks marks = no_marks(complex);
    for (const BoundaryFacet& on : boundary_facets(complex))
        marks[complex.dimension() - 1][on.facet] =
            on_facets.at(on.facet) == BoundaryCondition::essential;
    mark_faces(complex, marks);
    if (vertices > 0)
        check_as_many("marks of fixed vertices", vertices, complex.size(0));
    for (Index v = 0; v < vertices; ++v)
        marks[0][v] = marks[0][v] || conditions.fixed_vertices[v];
    return marks;
}

CellVolumes relative_volumes(const RelativeComplex& relative, const CellVolumes& volumes) {
    bool whole = true;
    for (int k = 0; k <= relative.complex.dimension(); ++k)
        whole = whole && relative.complex.size(k) == relative.whole_sizes[k];
    if (whole) {
        check_fit(relative.complex, volumes);
        return volumes;
    }
    const CellVolumes kept =
        volumes.mapped([&](int k, const Vector& numbers) { return relative.restrict(k, numbers); });
    auto numbers = relative.cells;
    for (int k = 0; k <= relative.complex.dimension(); ++k)
        numbers[k] = volumes.numbers(k, std::move(numbers[k]));
    return kept.numbered(std::move(numbers));
}

HodgeStars relative_stars(const RelativeComplex& relative, const HodgeStars& stars) {
    HodgeStars result = relative_volumes(relative, stars.volumes());
    for (int k = 0; k <= stars.dimension(); ++k)
        if (!stars[k].is_diagonal())
            result = result.with(k, relative.block(k, stars[k].matrix()));
    return result;
}

SparseMatrix dual_boundary_derivative(const CellComplex& complex, int j) {
    const int n = complex.dimension(), k = n - j - 1;
    check_number("boundary data of dual forms of degree", j, 0, n);
    const auto marks = boundary_cells(complex);
    const IncidenceMatrix cofaces = complex.boundary(n);
    SparseMatrix B(complex.size(k), complex.size(k));
    if (B.rows() == 0)
        return B; // Eigen could not compress it
    B.reserve(Eigen::VectorXi::Ones(complex.size(k)));
    for (Index s = 0; s < complex.size(k); ++s) {
        if (!marks[k][s])
            continue;
        // within the boundary, the dual of a facet is a point without orientation
        const double facet_sign =
            k == n - 1 ? IncidenceMatrix::InnerIterator(cofaces, s).value() : 1;
        B.insert(s, s) = (k % 2 == 0 ? 1 : -1) * facet_sign;
    }
    B.makeCompressed();
    return B;
}

} // namespace polydec
