// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "base/errors.h"
#include "dec/forms/cochain.h"
#include "dec/forms/gram.h"
#include "solvers/sources/form_equations.h"
#include "solvers/sources/poisson_system.h"
#include "solvers/sources/saddle_solver.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace polydec {

namespace {

Definiteness by_sign(const Vector& weights) {
    return (weights.array() >= 0).all() ? Definiteness::semidefinite : Definiteness::indefinite;
}

/// Functions have one number per cell: the value at a 0-cell, the density on an n-cell. The
/// integrals over the cells or their duals are N times that.
class Functions : public PoissonSystem {
public:
    DenseMatrix harmonic_forms() const override {
        const FreeComponents& free = components();
        DenseMatrix numbers = DenseMatrix::Zero(N_.rows(), free.count());
        const Vector root = volumes_of_components().cwiseSqrt();
        for (Index i = 0; i < N_.rows(); ++i)
            if (const Index c = free.of(i); c >= 0)
                numbers(i, c) = 1 / root[c];
        return are_values_ ? numbers : DenseMatrix(N_ * numbers);
    }

protected:
    Functions(const FormSpace& space, SparseMatrix N)
        : of_(space),
          N_(std::move(N)),
          weights_(N_ * Vector::Ones(N_.cols())),
          are_values_((space.side() == Side::primal) == (space.cell_degree() == 0)) {
        SparseMatrix().swap(of_.down); // of other degrees
    }

    virtual const FreeComponents& components() const = 0;

    /// The integrals of a form of the space.
    Vector integrals(const Vector& form) const { return are_values_ ? Vector(N_ * form) : form; }

    /// The result from one number per cell, and from their right-hand side.
    Found found(Vector numbers, const Vector& right_side, Vector flux, SolveReport report,
                const Compatibility& compatibility, const Vector& harmonic) const {
        const FreeComponents& free = components();
        const Vector volumes = volumes_of_components();
        Vector sums = Vector::Zero(volumes.size());
        for (Index i = 0; i < right_side.size(); ++i)
            if (const Index c = free.of(i); c >= 0)
                sums[c] += right_side[i];
        if (harmonic.size() != 0)
            check_values("coefficients of harmonic forms", harmonic, free.count());
        Vector removed = Vector::Zero(numbers.size());
        for (Index i = 0; i < numbers.size(); ++i)
            if (const Index c = free.of(i); c >= 0) {
                removed[i] = sums[c] / volumes[c];
                if (harmonic.size() != 0)
                    numbers[i] += harmonic[c] / std::sqrt(volumes[c]);
            }
        if (!are_values_) {
            numbers = (N_ * numbers).eval();
            removed = (N_ * removed).eval();
        }
        return {std::move(numbers), std::move(flux), std::move(removed), std::move(report),
                compatibility};
    }

    FormEquations of_;
    SparseMatrix N_;
    Vector weights_; // of the mean
    bool are_values_;

private:
    Vector volumes_of_components() const {
        Vector volumes = Vector::Zero(components().count());
        for (Index i = 0; i < weights_.size(); ++i)
            if (const Index c = components().of(i); c >= 0)
                volumes[c] += weights_[i];
        return volumes;
    }
};

class ValueSystem final : public Functions {
public:
    ValueSystem(const FormSpace& space, const std::string& engine)
        : Functions(space, space.cells().stars()[0].matrix()), solver_(system(space), engine) {}

    Found solve(const Vector& f, const BoundaryForms& data, const Vector& harmonic) const override {
        const BoundaryLoads known = of_.loads(data);
        const Vector right_side = integrals(f) + known.b;
        check_loads("the right-hand side of the system", right_side, 0);
        auto [w, report, compatibility, warnings] = solver_.solve(right_side, known.w);
        return found(std::move(w), right_side, {}, std::move(report), compatibility, harmonic);
    }

private:
    const FreeComponents& components() const override { return solver_.components(); }

    ConstrainedSystem system(const FormSpace& space) {
        const HodgeStars& stars = space.cells().stars();
        const auto size = static_cast<Index>(N_.rows());
        ConstrainedSystem result{.fixed = of_.left_out,
                                 .tied = std::vector<bool>(size, false),
                                 .weights = weights_,
                                 .definiteness = Definiteness::semidefinite,
                                 .domain_dimension = of_.dimension};
        if (of_.dimension > 0 && stars[1].is_diagonal()) {
            Vector weights = stars[1].diagonal();
            weights(stars[1].zeros()).setZero();
            result.definiteness = by_sign(weights);
        }
        result.A.swap(of_.upper);
        if (of_.robin.nonZeros() > 0) {
            const Vector robin = of_.robin.diagonal();
            for (Index v = 0; v < size; ++v)
                result.tied[v] = robin[v] > 0;
            result.A += of_.robin;
        }
        return result;
    }

    ConstrainedSolver solver_;
};

/// The inverse star of n-cells: their volumes, over the weights of a material. Throws InvalidInput
/// for a star with zeros.
SparseMatrix inverse_star(const FormSpace& space) {
    const HodgeStars& stars = space.cells().stars();
    const int n = stars.dimension();
    static_cast<void>(stars[n].inverse()); // refuses zeros
    return SparseMatrix(
        stars.volumes().primal(n).cwiseQuotient(stars.volumes().dual(n)).asDiagonal());
}

/// Balances of densities on n-cells: inflow and outflow.
class Balances : public Functions {
protected:
    explicit Balances(const FormSpace& space)
        : Functions(space, inverse_star(space)),
          divergence_(derivative(space.cells().complex(), of_.dimension - 1)),
          tied_(static_cast<std::size_t>(N_.rows()), false) {
        const CellComplex& complex = space.cells().complex();
        const auto& counts = complex.coface_counts(of_.dimension - 1);
        for (Index cell = 0; cell < complex.size(of_.dimension); ++cell)
            for (const SignedFace& f : complex.incidences(of_.dimension - 1)[cell])
                if (counts[f.face] == 1 && !of_.left_out_below[f.face])
                    tied_[cell] = true;
    }

    /// The sources minus the divergence of the flux.
    Vector left(const Vector& sources, const Vector& flux) const {
        Vector result = sources - divergence_ * flux;
        check_loads("the right-hand side of the balance", result, of_.dimension);
        return result;
    }

    SparseMatrix divergence_;
    std::vector<bool> tied_; // cells beside a boundary facet with unknown flux
};

/// The flux through a facet per difference of the densities beside it, or of one density and the
/// boundary value: |f| over the length of its dual, with Robin's layer; 0 if the flux is given.
/// Throws InvalidInput, naming the facet, if it is not defined.
Vector conductances(const FormSpace& space, const FormEquations& of) {
    const Cells cells = space.cells();
    const int facets = cells.dimension() - 1;
    const Vector &areas = cells.stars().volumes().primal(facets),
                 &lengths = cells.stars().volumes().dual(facets);
    const Vector layer = of.robin_below.diagonal().cwiseProduct(areas);
    for (const Index f : cells.stars()[facets].zeros())
        if (!of.left_out_below[f] && layer[f] == 0)
            throw InvalidInput(
                fmt::format("the dual of {} has no length, or its parts, each divided by its "
                            "conductivity, cancel, so the flux through the facet is not defined: "
                            "merge cospherical cells, or change one of the conductivities",
                            cells.name(facets, f)),
                cells.place(facets, f));
    Vector result = Vector::Zero(areas.size());
    for (Index f = 0; f < result.size(); ++f) {
        if (of.left_out_below[f] || cells.complex().coface_counts(facets)[f] == 0)
            continue;
        const double resistance = lengths[f] + layer[f];
        if (layer[f] > 0 && !(resistance > 0))
            throw InvalidInput(
                fmt::format(
                    "the dual of {} has length {}, and its sum with 1 over the Robin coefficient "
                    "is {}: expected a positive sum; use a smaller coefficient or primal forms",
                    cells.name(facets, f), lengths[f], resistance),
                cells.place(facets, f));
        result[f] = areas[f] / resistance;
    }
    return result;
}

class DensitySystem final : public Balances {
public:
    DensitySystem(const FormSpace& space, const std::string& engine)
        : Balances(space),
          conductances_(conductances(space, of_)),
          closing_(Vector::Zero(conductances_.size())),
          solver_(system(space), engine) {
        const int facets = of_.dimension - 1;
        const Vector& areas = space.cells().stars().volumes().primal(facets);
        for (Index f = 0; f < closing_.size(); ++f)
            if (of_.left_out_below[f] && !space.fixed()[facets][f])
                closing_[f] = areas[f];
    }

    Found solve(const Vector& f, const BoundaryForms& data, const Vector& harmonic) const override {
        const BoundaryLoads known = of_.loads(data);
        const Vector sources = integrals(f);
        const Vector right_side = left(sources, known.below - conductances_.cwiseProduct(known.g));
        auto [u, report, compatibility, warnings] = solver_.solve(right_side, of_.M * known.w);
        Vector flux =
            known.below + conductances_.cwiseProduct(Vector(divergence_.transpose() * u) - known.g);
        close(flux, sources);
        return found(std::move(u), right_side, std::move(flux), std::move(report), compatibility,
                     harmonic);
    }

private:
    const FreeComponents& components() const override { return solver_.components(); }

    ConstrainedSystem system(const FormSpace& space) const {
        ConstrainedSystem result{.fixed = of_.left_out,
                                 .tied = tied_,
                                 .weights = weights_,
                                 .definiteness = by_sign(conductances_),
                                 .domain_dimension = of_.dimension,
                                 .degree = of_.dimension};
        result.A =
            gram_of_rows(space.cells().complex().incidences(of_.dimension - 1), conductances_);
        result.A.prune([](Index t, Index s, double a) { return a != 0 || t == s; });
        return result;
    }

    /// Sets fluxes through facets without dual by the balance of the cell beside them, shared by
    /// area.
    void close(Vector& flux, const Vector& sources) const {
        if (closing_.isZero(0))
            return;
        const Vector missing = sources - divergence_ * flux;
        const Vector room = divergence_.cwiseAbs() * closing_;
        const SparseMatrix cofaces = divergence_.transpose();
        for (Index f = 0; f < flux.size(); ++f)
            if (closing_[f] > 0) {
                const SparseMatrix::InnerIterator cell(cofaces, f);
                flux[f] = cell.value() * missing[cell.col()] * closing_[f] / room[cell.col()];
            }
    }

    Vector conductances_, closing_; // of facets; the second: areas, 0 where there is a dual
    ConstrainedSolver solver_;
};

/// The star of fluxes with Robin's layer, a resistance to the flux.
SparseMatrix resistances(const FormEquations& of) {
    return of.robin_below.nonZeros() > 0 ? SparseMatrix(of.M_below + of.robin_below) : of.M_below;
}

/// M flux - divergence^T u = -g, divergence flux = the sources; for the free fluxes.
class FluxSystem final : public Balances {
public:
    FluxSystem(const FormSpace& space, const std::string& engine)
        : Balances(space),
          M_(resistances(of_)),
          kept_(of_.kept_below()),
          solver_(SparseMatrix(kept_.transpose()) * M_ * kept_, divergence_ * kept_, engine,
                  of_.dimension),
          components_(connections(), of_.left_out, tied_, weights_) {}

    Found solve(const Vector& f, const BoundaryForms& data, const Vector& harmonic) const override {
        BoundaryLoads known = of_.loads(data);
        Vector& flux = known.below;
        const Vector sources = integrals(f), drops = -known.g - M_ * flux;
        check_loads("the right-hand side of a flux", drops, of_.dimension - 1);
        const Vector right_side = left(sources, flux);
        const SparseMatrix P = kept_.transpose();
        Vector terms(P.rows() + sources.size());
        terms << P * Vector(known.g_terms + M_.cwiseAbs() * flux.cwiseAbs()),
            sources.cwiseAbs() + divergence_.cwiseAbs() * flux.cwiseAbs();
        Vector balanced = right_side;
        const Compatibility compatibility = components_.balance(balanced);
        auto [x, c, report] = solver_.solve(P * drops, balanced, terms);
        flux += kept_ * x;
        Vector u = -c;
        components_.remove_means(u);
        return found(std::move(u), right_side, std::move(flux), std::move(report), compatibility,
                     harmonic);
    }

private:
    const FreeComponents& components() const override { return components_; }

    SparseMatrix connections() const { return SparseMatrix(divergence_ * kept_).transpose(); }

    SparseMatrix M_, kept_; // kept: free fluxes to all
    SaddleSolver solver_;
    FreeComponents components_;
};

} // namespace

std::unique_ptr<const PoissonSystem> system_of_values(const FormSpace& space,
                                                      const std::string& engine) {
    return std::make_unique<ValueSystem>(space, engine);
}

std::unique_ptr<const PoissonSystem> system_of_densities(const FormSpace& space,
                                                         const std::string& engine) {
    return std::make_unique<DensitySystem>(space, engine);
}

std::unique_ptr<const PoissonSystem> system_of_fluxes(const FormSpace& space,
                                                      const std::string& engine) {
    return std::make_unique<FluxSystem>(space, engine);
}

} // namespace polydec
