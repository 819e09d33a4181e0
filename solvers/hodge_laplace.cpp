// SPDX-License-Identifier: MIT
#include "solvers/hodge_laplace.h"

#include "base/checks.h"
#include "base/decompositions.h"
#include "base/errors.h"
#include "complex/homology.h"
#include "dec/forms/derivative.h"
#include "meshes/unit_of_length.h"
#include "solvers/hodge.h"
#include "solvers/hodge_laplace_equations.h"
#include "solvers/saddle_solver.h"
#include "solvers/spectra/positive_mass.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace polydec {

namespace {

/// The star below counts with the layer that Robin's condition adds to it.
void check_stars(const FormSpace& space) {
    const HodgeStars stars = relative_stars(space.relative(), space.cells().stars());
    const Side side = space.side();
    const int k = space.cell_degree();
    const auto degree = [&](int j) { return side == Side::primal ? j : stars.dimension() - j; };
    check_positive_mass(stars[k], side, degree(k));
    if (k == 0)
        return;
    HodgeStar below = stars[k - 1];
    if (space.cells().stars()[k - 1].is_diagonal() && space.robin_layer().size() > 0) {
        const CellVolumes& volumes = stars.volumes();
        const Vector layer = space.relative()
                                 .restrict(k - 1, Vector(space.robin_layer().diagonal()))
                                 .cwiseProduct(volumes.primal(k - 1));
        below = HodgeStar(volumes.with_dual(k - 1, volumes.dual(k - 1) + layer,
                                            volumes.terms(k - 1).vector(),
                                            volumes.rounding(k - 1).vector()),
                          k - 1);
    }
    check_positive_mass(below, side, degree(k - 1));
}

} // namespace

/// The equations, and what solves them.
struct HodgeLaplaceSolver::System : HodgeLaplaceEquations {
    DenseMatrix harmonic, weighted; // of free values, orthonormal; M times these
    std::unique_ptr<SaddleSolver> solver;

    using HodgeLaplaceEquations::HodgeLaplaceEquations;

    /// Finds the harmonic forms, which take no work where there are none, and factorizes.
    void prepare(const FormSpace& space, const std::string& engine) {
        const CellComplex complex = space.relative().complex;
        harmonic.resize(kept.cols(), 0);
        if (homology_generators(complex, k).cols() > 0)
            harmonic = polydec::harmonic_forms(
                FormSpace::vanishing_on({complex, space.inside().stars()}, Side::primal, k),
                engine);
        keep_free_of_robin();
        const SparseMatrix P = kept.transpose(), P_below = kept_below.transpose();
        weighted = P * M * kept * harmonic;
        solver = std::make_unique<SaddleSolver>(
            SparseMatrix(P * (upper + robin) * kept), SparseMatrix(P_below * down * kept),
            SparseMatrix(P_below * (M_below + robin_below) * kept_below), engine,
            complex.dimension());
    }

    /// Of primal forms the harmonic ones whose traces on Robin's facets are 0: to all others the
    /// condition adds energy.
    void keep_free_of_robin() {
        if (harmonic.cols() == 0 || robin.nonZeros() == 0)
            return;
        const DenseMatrix whole = kept * harmonic;
        const DenseMatrix energy = whole.transpose() * (robin * whole);
        const Eigen::SelfAdjointEigenSolver<DenseMatrix> parts(energy);
        constexpr double rounding = 1e-12;
        const double largest = robin.diagonal().dot(whole.rowwise().squaredNorm());
        const Index free = static_cast<Index>(
            (parts.eigenvalues().array() <= rounding * std::max(largest, energy.norm())).count());
        harmonic = (harmonic * parts.eigenvectors().leftCols(free)).eval();
    }
};

HodgeLaplaceSolver::HodgeLaplaceSolver(const FormSpace& space, const std::string& linear_solver)
    : space_(space) {
    check_stars(space);
    auto system = std::make_unique<System>(space);
    system->prepare(space, linear_solver);
    system_ = std::move(system);
}

HodgeLaplaceSolver::HodgeLaplaceSolver(HodgeLaplaceSolver&&) noexcept = default;
HodgeLaplaceSolver::~HodgeLaplaceSolver() = default;

FormSolution HodgeLaplaceSolver::solve(const Cochain& given, const BoundaryForms& data,
                                       const Vector& harmonic) const {
    space_.check(given);
    const Side side = space_.side();
    const int n = space_.cells().dimension(), k = space_.cell_degree();
    const double unit = space_.cells().unit();
    const Vector f = in_input_units(given.values, unit, 2, "source");
    const System& of = *system_;
    const bool primal = side == Side::primal;
    if (harmonic.size() != 0)
        check_as_many("coefficients of harmonic forms", harmonic.size(), of.harmonic.cols());
    auto [w, below, b, g, b_terms, g_terms] = of.loads(in_unit(data, unit, n, space_.degree()));
    b += primal ? of.M * f : f;
    b_terms += primal ? Vector(of.M.cwiseAbs() * f.cwiseAbs()) : f.cwiseAbs();
    Vector free = of.kept.transpose() * b;
    const Vector excess = of.harmonic.transpose() * free;
    free -= of.weighted * excess;
    Vector terms(of.kept.cols() + of.kept_below.cols());
    terms << of.kept.transpose() * b_terms, of.kept_below.transpose() * g_terms;
    constexpr double rounding = 1e-14;
    if (free.norm() <= rounding * terms.head(free.size()).norm())
        free.setZero(); // what rounding left of harmonic data has a harmonic part itself
    const auto [x, s, report] = of.solver->solve(free, of.kept_below.transpose() * g, terms);

    w += of.kept * x;
    below += of.kept_below * s;
    Vector coefficients = -(of.harmonic.transpose() * (of.kept.transpose() * (of.M * w)));
    if (harmonic.size() != 0)
        coefficients += harmonic;
    w += of.kept * (of.harmonic * coefficients);

    const Vector removed =
        in_input_units(of.kept * (of.harmonic * excess), unit, -2, "removed part");
    if (primal)
        return {{side, k, std::move(w)},
                {side, k - 1, form_in_input_units(below, unit, -2, "codifferential")},
                {side, k, removed},
                report};
    return {{side, n - k, of.M * w},
            {side, n - k + 1, (k % 2 == 0 ? 1 : -1) * (of.M_below * below)},
            {side, n - k, of.M * removed},
            report};
}

DenseMatrix HodgeLaplaceSolver::harmonic_forms() const {
    const DenseMatrix forms = system_->kept * system_->harmonic;
    return space_.side() == Side::primal ? forms : DenseMatrix(system_->M * forms);
}

CurlCurlSolution solve_curl_curl(const HodgeLaplaceSolver& solver, const Cochain& j,
                                 const BoundaryForms& data) {
    if (j.side != Side::primal)
        throw InvalidInput("a dual form is given as the source of a curl of a curl: expected a "
                           "primal one");
    const auto first = solver.solve(j, data);
    Cochain exact{Side::primal, j.degree, Vector::Zero(j.values.size())};
    if (j.degree > 0)
        exact.values = d(solver.space().cells().complex(), first.beside).values;
    auto second = solver.solve(j - exact, data);
    return {std::move(second.form), exact + first.removed, std::move(second.report)};
}

} // namespace polydec
