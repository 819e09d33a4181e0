// SPDX-License-Identifier: MIT
#include "solvers/hodge_laplace.h"

#include "base/checks.h"
#include "base/decompositions.h"
#include "base/errors.h"
#include "complex/homology.h"
#include "dec/forms/derivative.h"
#include "dec/forms/operator.h"
#include "solvers/hodge.h"
#include "solvers/saddle_solver.h"
#include "solvers/spectra/positive_mass.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace polydec {

namespace {

double sign(int exponent) {
    return exponent % 2 == 0 ? 1 : -1;
}

/// The columns of some cells: their values to those of all.
SparseMatrix inclusion(const RelativeComplex& relative, int k) {
    std::vector<Eigen::Triplet<double, Index>> entries;
    for (const Index cell : relative.cells[k])
        entries.emplace_back(cell, static_cast<Index>(entries.size()), 1.0);
    SparseMatrix result(relative.whole_sizes[k], static_cast<Index>(entries.size()));
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}

SparseMatrix transpose_of(const SparseMatrix& A) {
    return A.transpose();
}

/// Where the center of an n-cell lies on the boundary and the cell is left out for it: from values
/// at facets to that of the cell.
SparseMatrix centers_on_the_boundary(const CellComplex& complex, const RelativeComplex& relative,
                                     const CellMarks& fixed) {
    const int n = complex.dimension();
    const auto left_out = [&](int k) {
        std::vector<bool> marks(complex.size(k), true);
        for (const Index cell : relative.cells[k])
            marks[cell] = false;
        return marks;
    };
    const auto cells = left_out(n), facets = left_out(n - 1);
    std::vector<Eigen::Triplet<double, Index>> entries;
    for (Index t = 0; t < complex.size(n); ++t) {
        if (!cells[t])
            continue;
        std::vector<Index> touched;
        for (const SignedFace& f : complex.incidences(n - 1)[t])
            if (facets[f.face] && !fixed[n - 1][f.face])
                touched.push_back(f.face);
        for (const Index f : touched)
            entries.emplace_back(t, f, 1.0 / static_cast<double>(touched.size()));
    }
    SparseMatrix result(complex.size(n), complex.size(n - 1));
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}

/// What is known of a primal k-form w on the boundary: w, delta w, and over the duals there star w
/// and star dw. Dual forms are stars of primal ones.
struct PrimalData {
    Vector w, below, star_w, star_dw;
};

PrimalData primal_data(Side side, const BoundaryForms& data, const CellComplex& complex, int k) {
    const int n = complex.dimension();
    const auto values = [&](const Vector& given, int degree, const char* what, double factor) {
        const Index size = degree < 0 ? 0 : complex.size(degree);
        if (given.size() == 0)
            return Vector(Vector::Zero(size));
        check_as_many(what, given.size(), size);
        if (!given.allFinite())
            throw InvalidInput(fmt::format("{} are not finite", what));
        return Vector(factor * given);
    };
    constexpr auto trace = "boundary values of the form",
                   below = "boundary values of the codifferential",
                   flow = "boundary values of the star of the form",
                   derivative_flow = "boundary values of the star of the derivative";
    if (side == Side::primal)
        return {values(data.values, k, trace, 1), values(data.codifferential, k - 1, below, 1),
                values(data.flow, k - 1, flow, 1),
                values(data.derivative_flow, k, derivative_flow, 1)};
    return {values(data.flow, k, flow, sign(k * (n - k))),
            values(data.derivative_flow, k - 1, derivative_flow, sign(k + (k - 1) * (n - k + 1))),
            values(data.values, k - 1, trace, 1),
            values(data.codifferential, k, below, sign(k + 1))};
}

Vector ones_at(const CellMarks& marks, int k) {
    if (k < 0)
        return {};
    Vector result(static_cast<Index>(marks[k].size()));
    for (Index s = 0; s < result.size(); ++s)
        result[s] = marks[k][s] ? 1 : 0;
    return result;
}

/// What data at the duals within the boundary add to d^T of what a k-form has over the duals.
SparseMatrix boundary_part(const CellComplex& complex, int k) {
    const int n = complex.dimension();
    if (k < 0 || k == n)
        return SparseMatrix(k < 0 ? 0 : complex.size(n), k < 0 ? 0 : complex.size(n));
    return sign(k) * dual_boundary_derivative(complex, n - 1 - k);
}

SparseMatrix with_diagonal(const SparseMatrix& A, const Vector& diagonal) {
    if (diagonal.isZero(0))
        return A;
    return A + SparseMatrix(diagonal.asDiagonal());
}

void check_stars(const HodgeStars& stars, Side side, int k) {
    const auto degree = [&](int j) { return side == Side::primal ? j : stars.dimension() - j; };
    check_positive_mass(stars[k], side, degree(k));
    if (k > 0)
        check_positive_mass(stars[k - 1], side, degree(k - 1));
}

} // namespace

/// The equations of a primal k-form w and s = delta w: with M the stars
///     d^T M_(k+1) d w + M_k d s = b + B star_dw,    d^T M_k w - M_(k-1) s = B star_w.
struct HodgeLaplaceSolver::System {
    SparseMatrix kept, kept_below; // from the values that are free to all
    Vector given, given_below;     // 1 at cells whose values data fix, else 0
    SparseMatrix M, M_below;       // of all cells, as are those behind
    SparseMatrix upper;            // d^T M_(k+1) d, without what is given
    SparseMatrix down;             // d^T M_k
    SparseMatrix B, B_below;
    SparseMatrix fix, load;    // where n-cells have their centers on the boundary: star w, star dw
    Vector robin, robin_below; // what Robin's condition adds to upper, and to M_below
    DenseMatrix harmonic, weighted; // of free values, orthonormal; M times these
    std::unique_ptr<SaddleSolver> solver;

    System(const CellComplex& complex, const HodgeStars& stars, const ConditionedComplex& space,
           const CellMarks& fixed, int k)
        : kept(inclusion(space.relative, k)),
          kept_below(k > 0 ? inclusion(space.relative, k - 1) : SparseMatrix(0, 0)),
          given(ones_at(fixed, k)),
          given_below(ones_at(fixed, k - 1)),
          M(stars[k].matrix()),
          M_below(k > 0 ? stars[k - 1].matrix() : SparseMatrix(0, 0)),
          upper(M.rows(), M.rows()),
          down(transpose_of(derivative(complex, k - 1)) * M),
          B(boundary_part(complex, k)),
          B_below(boundary_part(complex, k - 1)),
          fix(M.rows(), B_below.cols()),
          load(M.rows(), M.rows()),
          robin(Vector::Zero(M.rows())),
          robin_below(Vector::Zero(M_below.rows())) {
        const int n = complex.dimension();
        const SparseMatrix centers = centers_on_the_boundary(complex, space.relative, fixed);
        if (k == n) {
            fix = centers;
            return;
        }
        const SparseMatrix d = derivative(complex, k), above = inclusion(space.relative, k + 1);
        const SparseMatrix free = transpose_of(above) * d;
        upper = transpose_of(free) *
                SparseMatrix(transpose_of(above) * stars[k + 1].matrix() * above) * free;
        if (k == n - 1)
            load = transpose_of(d) * centers;
    }

    /// Finds the harmonic forms, which take no work where there are none, and factorizes.
    void prepare(const ConditionedComplex& space, int k, const std::string& engine) {
        const auto& complex = space.relative.complex;
        harmonic.resize(kept.cols(), 0);
        if (homology_generators(complex, k).cols() > 0)
            harmonic = HodgeSolver(complex, space.stars, Side::primal, k, engine).harmonic_forms();
        keep_free_of_robin();
        const SparseMatrix P = transpose_of(kept), P_below = transpose_of(kept_below);
        weighted = P * M * kept * harmonic;
        solver = std::make_unique<SaddleSolver>(
            SparseMatrix(P * with_diagonal(upper, robin) * kept),
            SparseMatrix(P_below * down * kept),
            SparseMatrix(P_below * with_diagonal(M_below, robin_below) * kept_below), engine,
            complex.dimension());
    }

    /// Of primal forms the harmonic ones whose traces on Robin's facets are 0: to all others the
    /// condition adds energy.
    void keep_free_of_robin() {
        if (harmonic.cols() == 0 || robin.isZero(0))
            return;
        const DenseMatrix whole = kept * harmonic;
        const DenseMatrix energy = whole.transpose() * robin.asDiagonal() * whole;
        const Eigen::SelfAdjointEigenSolver<DenseMatrix> parts(energy);
        constexpr double rounding = 1e-12;
        const double largest = (robin.array() * whole.rowwise().squaredNorm().array()).sum();
        const Index free = static_cast<Index>(
            (parts.eigenvalues().array() <= rounding * std::max(largest, energy.norm())).count());
        harmonic = (harmonic * parts.eigenvectors().leftCols(free)).eval();
    }
};

HodgeLaplaceSolver::HodgeLaplaceSolver(const Discretization& mesh,
                                       const HodgeLaplaceOptions& options)
    : HodgeLaplaceSolver(
          mesh.complex(), mesh.stars(),
          conditioned_but_for_robin(mesh, options.side, options.degree, options.boundary),
          robin_parts(mesh, options.side, options.degree, options.boundary), options) {}

HodgeLaplaceSolver::HodgeLaplaceSolver(const CellComplex& complex, const HodgeStars& stars,
                                       const HodgeLaplaceOptions& options)
    : HodgeLaplaceSolver(
          complex, stars,
          conditioned_but_for_robin(complex, stars, options.side, options.degree, options.boundary),
          robin_parts(complex, stars, options.side, options.degree, options.boundary), options) {}

HodgeLaplaceSolver::HodgeLaplaceSolver(const CellComplex& complex, const HodgeStars& stars,
                                       const ConditionedComplex& space, const RobinParts& robin,
                                       const HodgeLaplaceOptions& options)
    : complex_(complex),
      side_(options.side),
      degree_(options.degree),
      k_(cell_degree(complex, options.side, options.degree)) {
    check_stars(space.stars, side_, k_);
    const auto fixed = essential_cells(
        complex, side_ == Side::primal ? options.boundary : exchanged(options.boundary));
    auto system = std::make_unique<System>(complex, stars, space, fixed, k_);
    if (robin.weights.size() > 0)
        system->robin = robin.weights;
    if (robin.layer.size() > 0)
        system->robin_below = robin.layer;
    system->prepare(space, k_, options.linear_solver);
    system_ = std::move(system);
}

HodgeLaplaceSolver::HodgeLaplaceSolver(HodgeLaplaceSolver&&) noexcept = default;
HodgeLaplaceSolver::~HodgeLaplaceSolver() = default;

FormSolution HodgeLaplaceSolver::solve(const Cochain& f, const BoundaryForms& data,
                                       const Vector& harmonic) const {
    check(complex_, f);
    if (f.side != side_ || f.degree != degree_)
        throw InvalidInput(fmt::format("a {} {}-form is given: this solver is for {} {}-forms",
                                       name(f.side), f.degree, name(side_), degree_));
    const System& of = *system_;
    const bool primal = side_ == Side::primal;
    if (harmonic.size() != 0)
        check_as_many("coefficients of harmonic forms", harmonic.size(), of.harmonic.cols());
    const PrimalData known = primal_data(side_, data, complex_, k_);

    // what is fixed, and 0 elsewhere
    Vector w = known.w.cwiseProduct(of.given), below = known.below.cwiseProduct(of.given_below);
    if (of.fix.nonZeros() > 0)
        w += (of.fix * known.star_w).cwiseQuotient(of.M.diagonal());

    Vector b = primal ? of.M * f.values : f.values;
    b +=
        of.B * known.star_dw - of.load * known.star_dw - of.upper * w - of.down.transpose() * below;
    const Vector g = of.M_below * below - of.down * w + of.B_below * known.star_w -
                     of.robin_below.cwiseProduct(known.below);
    Vector free = of.kept.transpose() * b;
    const double size = free.norm();
    const Vector excess = of.harmonic.transpose() * free;
    free -= of.weighted * excess;
    constexpr double rounding = 1e-14;
    if (free.norm() <= rounding * size)
        free.setZero(); // what rounding left of harmonic data has a harmonic part itself
    const auto [x, s, report] = of.solver->solve(free, of.kept_below.transpose() * g);

    w += of.kept * x;
    below += of.kept_below * s;
    Vector coefficients = -(of.harmonic.transpose() * (of.kept.transpose() * (of.M * w)));
    if (harmonic.size() != 0)
        coefficients += harmonic;
    w += of.kept * (of.harmonic * coefficients);

    const Vector removed = of.kept * (of.harmonic * excess);
    const int n = complex_.dimension();
    if (primal)
        return {{side_, k_, std::move(w)},
                {side_, k_ - 1, std::move(below)},
                {side_, k_, removed},
                report};
    return {{side_, degree_, of.M * w},
            {side_, n - k_ + 1, sign(k_) * (of.M_below * below)},
            {side_, degree_, of.M * removed},
            report};
}

DenseMatrix HodgeLaplaceSolver::harmonic_forms() const {
    const DenseMatrix forms = system_->kept * system_->harmonic;
    return side_ == Side::primal ? forms : DenseMatrix(system_->M * forms);
}

CurlCurlSolution solve_curl_curl(const HodgeLaplaceSolver& solver, const CellComplex& complex,
                                 const Cochain& j, const BoundaryForms& data) {
    if (j.side != Side::primal)
        throw InvalidInput("a dual form is given as the source of a curl of a curl: expected a "
                           "primal one");
    const auto first = solver.solve(j, data);
    Cochain exact{Side::primal, j.degree, Vector::Zero(j.values.size())};
    if (j.degree > 0)
        exact = d(complex, first.beside);
    auto second = solver.solve(j - exact, data);
    return {std::move(second.form), exact + first.removed, std::move(second.report)};
}

} // namespace polydec
