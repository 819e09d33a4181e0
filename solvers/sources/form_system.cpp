// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "complex/homology.h"
#include "dec/discretization/positive_mass.h"
#include "solvers/sources/form_equations.h"
#include "solvers/sources/hodge.h"
#include "solvers/sources/poisson_system.h"
#include "solvers/sources/saddle_solver.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <memory>

namespace polydec {

namespace {

/// The star below includes the layer from Robin's condition.
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

class Forms final : public PoissonSystem {
public:
    Forms(const FormSpace& space, const std::string& engine)
        : of_(space), kept_(of_.kept()), kept_below_(of_.kept_below()), side_(space.side()) {
        const CellComplex complex = space.relative().complex;
        harmonic_.resize(kept_.cols(), 0);
        if (homology_generators(complex, of_.k).cols() > 0) // cheap if there are none
            harmonic_ = polydec::harmonic_forms(
                FormSpace::vanishing_on({complex, space.inside().stars()}, Side::primal, of_.k),
                engine);
        keep_free_of_robin();
        const SparseMatrix P = kept_.transpose(), P_below = kept_below_.transpose();
        weighted_ = P * of_.M * kept_ * harmonic_;
        solver_ = std::make_unique<SaddleSolver>(
            SparseMatrix(P * (of_.upper + of_.robin) * kept_),
            SparseMatrix(P_below * of_.down * kept_),
            SparseMatrix(P_below * (of_.M_below + of_.robin_below) * kept_below_), engine,
            complex.dimension());
    }

    DenseMatrix harmonic_forms() const override { return form(DenseMatrix(kept_ * harmonic_)); }

    Found solve(const Vector& f, const BoundaryForms& data, const Vector& harmonic) const override {
        if (harmonic.size() != 0)
            check_values("coefficients of harmonic forms", harmonic, harmonic_.cols());
        auto [w, below, b, g, b_terms, g_terms] = of_.loads_of_free_values(data);
        const bool primal = side_ == Side::primal;
        b += primal ? of_.M * f : f;
        b_terms += primal ? Vector(of_.M.cwiseAbs() * f.cwiseAbs()) : f.cwiseAbs();
        check_loads("the right-hand side of the system", b, of_.k);
        const SparseMatrix P = kept_.transpose(), P_below = kept_below_.transpose();
        Vector free = P * b;
        const Vector excess = harmonic_.transpose() * free;
        free -= weighted_ * excess;
        Vector terms(P.rows() + P_below.rows());
        terms << P * b_terms, P_below * g_terms;
        constexpr double rounding = 1e-14;
        if (free.norm() <= rounding * terms.head(free.size()).norm())
            free.setZero(); // the rounding error of harmonic data has a harmonic part itself
        const auto [x, s, report] = solver_->solve(free, P_below * g, terms);

        w += kept_ * x;
        below += kept_below_ * s;
        Vector coefficients = -(harmonic_.transpose() * (P * (of_.M * w)));
        if (harmonic.size() != 0)
            coefficients += harmonic;
        w += kept_ * (harmonic_ * coefficients);
        return {form(w), std::move(below), form(Vector(kept_ * (harmonic_ * excess))), report};
    }

private:
    /// Form values of the space from primal ones: equal to them, or their stars.
    template <class Values>
    Values form(Values w) const {
        return side_ == Side::primal ? w : Values(of_.M * w);
    }

    /// Keeps the harmonic primal forms with zero traces on Robin facets; the condition adds energy
    /// to all others.
    void keep_free_of_robin() {
        if (harmonic_.cols() == 0 || of_.robin.nonZeros() == 0)
            return;
        const DenseMatrix whole = kept_ * harmonic_;
        const DenseMatrix energy = whole.transpose() * (of_.robin * whole);
        const Eigen::SelfAdjointEigenSolver<DenseMatrix> parts(energy);
        constexpr double rounding = 1e-12;
        const double largest = of_.robin.diagonal().dot(whole.rowwise().squaredNorm());
        const Index free = static_cast<Index>(
            (parts.eigenvalues().array() <= rounding * std::max(largest, energy.norm())).count());
        harmonic_ = (harmonic_ * parts.eigenvectors().leftCols(free)).eval();
    }

    FormEquations of_;
    SparseMatrix kept_, kept_below_; // free values to all cells
    Side side_;
    DenseMatrix harmonic_, weighted_; // of free values, orthonormal; M times these
    std::unique_ptr<SaddleSolver> solver_;
};

} // namespace

std::unique_ptr<const PoissonSystem> system_of_forms(const FormSpace& space,
                                                     const std::string& engine) {
    check_stars(space);
    return std::make_unique<Forms>(space, engine);
}

} // namespace polydec
