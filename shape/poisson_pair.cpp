// SPDX-License-Identifier: MIT
#include "shape/poisson_pair.h"

#include "backends/registry.h"

#include <algorithm>
#include <cmath>

namespace polydec {

Vector PoissonForms::System::solve(Vector b) const {
    // again, as what is left of rounding may itself be nearly constant
    constexpr int often_enough = 3;
    for (int time = 0; time < often_enough; ++time)
        for (const auto constant : kernel.colwise()) // 0 and 1
            b -= constant.dot(b) / constant.sum() * constant;
    // a load of the constant would hide all else in the check of the solution
    const Vector image = K * constant;
    const double energy = constant.dot(image), share = energy > 0 ? constant.dot(b) / energy : 0;
    return solver->solve(b - share * image) + share * constant;
}

namespace {

using LongRow = Eigen::Matrix<long double, 1, Eigen::Dynamic>;

/// The values of a simplex less the first one, which has no gradient: what is left is exact.
template <class Numbers>
LongRow differences(const Numbers& values, Index s) {
    return values.row(s).template cast<long double>().array() -
           static_cast<long double>(values(s, 0));
}

LongRow values(const DenseMatrix& of_all, Index s) {
    return of_all.row(s).cast<long double>();
}

/// The mean of a linear function over the facet opposite corner i.
long double mean_over_facet(LongRow values, int i) {
    values[i] = 0; // it may be much larger than the others
    return values.sum() / (values.size() - 1);
}

} // namespace

PoissonForms::PoissonForms(const Shape& shape, const std::string& engine)
    : shape_(shape),
      n_(shape.pieces.dimension()),
      sides_(facet_sides(shape)),
      components_(free_components(shape)) {
    const Index size = shape.pieces.size(n_);
    volumes_.resize(size), bubbles_.resize(size), poincare_.resize(size);
    areas_.resize(size, n_ + 1);
    for (Index s = 0; s < size; ++s) {
        const MeasuredSimplex simplex = measured_simplex(shape, s);
        const long double kappa = conductivity_of(shape, s);
        volumes_[s] = double(simplex.volume);
        long double squares = 0;
        for (int i = 0; i <= n_; ++i)
            for (int j = 0; j < i; ++j)
                squares += simplex.squares(i, j);
        bubbles_[s] = double(squares / (n_ * n_ * (n_ + 1) * (n_ + 1) * (n_ + 2)) / kappa);
        poincare_[s] = double(simplex.longest_square * poincare_square(n_) / kappa) * (1 + 1e-15);
        gradients_.push_back(kappa * simplex.volume * simplex.gradients);
        for (int i = 0; i <= n_; ++i)
            areas_(s, i) = double(simplex.facet_volume(i));
    }
    facets_ = system(crouzeix_raviart_form(shape), engine);
    vertices_ = system(ConformingForm(shape, 1).family(), engine);
}

PoissonForms::System PoissonForms::system(const FormFamily& family,
                                          const std::string& engine) const {
    const CountedMatrix counted = family.at(0);
    System system{
        *counted.matrix,    family.unknowns().of_simplices, {}, {}, make_linear_solver(engine),
        counted.doubt.share};
    const Index free =
        components_.empty() ? 0 : *std::max_element(components_.begin(), components_.end()) + 1;
    system.kernel = DenseMatrix::Zero(family.size(), free);
    for (std::size_t at = 0; at < system.unknowns.size(); ++at)
        if (const Index component = components_[at / std::size_t(n_ + 1)];
            component >= 0 && system.unknowns[at] >= 0)
            system.kernel(system.unknowns[at], component) = 1;
    system.constant = 1 - system.kernel.rowwise().sum().array();
    MatrixFacts facts;
    facts.symmetry = Symmetry::symmetric;
    facts.definiteness = free > 0 ? Definiteness::semidefinite : Definiteness::positive;
    facts.kernel = system.kernel;
    facts.domain_dimension = n_;
    facts.many_solves = true;
    if (family.size() > 0)
        system.solver->factorize(system.K, facts);
    return system;
}

DenseMatrix PoissonForms::at_corners(const Vector& values) const {
    const Simplices& corners = shape_.pieces.simplices(n_);
    DenseMatrix local(corners.rows(), n_ + 1);
    for (Index s = 0; s < corners.rows(); ++s)
        for (int i = 0; i <= n_; ++i)
            local(s, i) = values[corners(s, i)];
    return local;
}

LocalData PoissonForms::local(const DenseMatrix& source, const Vector& flow) const {
    LocalData data;
    data.corners = source.cols() == 1 ? DenseMatrix(source.replicate(1, n_ + 1)) : source;
    data.facet_flow = DenseMatrix::Zero(simplices(), n_ + 1);
    for (Index s = 0; s < simplices() && flow.size() > 0; ++s)
        for (int i = 0; i <= n_; ++i)
            if (const FacetSide& side = sides_[std::size_t(n_ + 1) * s + i];
                side.is_boundary && !side.is_essential)
                data.facet_flow(s, i) = flow[side.facet] * areas_(s, i);
    data.means = data.corners.rowwise().mean();
    data.oscillation.resize(simplices());
    for (Index s = 0; s < simplices(); ++s) {
        const Eigen::RowVectorXd rest = data.corners.row(s).array() - data.means[s];
        const double square = volumes_[s] * rest.squaredNorm() / ((n_ + 1) * (n_ + 2));
        data.oscillation[s] = std::sqrt(poincare_[s] * square);
    }
    // what a component without given values gains must be nothing
    Vector gains(simplices());
    for (Index s = 0; s < simplices(); ++s)
        gains[s] = data.means[s] * volumes_[s] + data.facet_flow.row(s).sum();
    const Vector means = free_means(gains);
    data.means -= means;
    data.corners.colwise() -= means;
    return data;
}

Vector PoissonForms::free_means(const Vector& integrals) const {
    Vector sums = Vector::Zero(facets_.kernel.cols()), sizes = sums;
    for (Index s = 0; s < simplices(); ++s)
        if (const Index component = components_[s]; component >= 0) {
            sums[component] += integrals[s];
            sizes[component] += volumes_[s];
        }
    Vector result = Vector::Zero(simplices());
    for (Index s = 0; s < simplices(); ++s)
        if (const Index component = components_[s]; component >= 0)
            result[s] = sums[component] / sizes[component];
    return result;
}

Vector PoissonForms::gathered(const System& system, const LongMatrix& local) const {
    Eigen::VectorX<long double> sums = Eigen::VectorX<long double>::Zero(system.K.rows());
    for (Index s = 0; s < simplices(); ++s)
        for (int i = 0; i <= n_; ++i)
            if (const Index u = system.unknowns[std::size_t(n_ + 1) * s + i]; u >= 0)
                sums[u] += local(s, i);
    return sums.cast<double>();
}

DenseMatrix PoissonForms::spread(const System& system, const Vector& values) const {
    DenseMatrix local = DenseMatrix::Zero(simplices(), n_ + 1);
    for (Index s = 0; s < simplices(); ++s)
        for (int i = 0; i <= n_; ++i)
            if (const Index u = system.unknowns[std::size_t(n_ + 1) * s + i]; u >= 0)
                local(s, i) = values[u];
    return local;
}

PoissonForms::Solution
PoissonForms::solution(const System& system,
                       const std::function<LongMatrix(const LongMatrix&)>& residual) const {
    Solution found{LongMatrix::Zero(simplices(), n_ + 1), DenseMatrix::Zero(simplices(), n_ + 1),
                   0};
    for (int step = 0; step < 2 && system.K.rows() > 0; ++step) {
        const Vector right = gathered(system, residual(found.values)), change = system.solve(right);
        found.last_step = spread(system, change);
        found.values += found.last_step.cast<long double>();
        found.size_of_last_step = std::sqrt(std::max(right.dot(change), 0.0));
    }
    return found;
}

PoissonForms::Solution PoissonForms::to_galerkin(const DenseMatrix& corners,
                                                 const LocalData& data) const {
    return solution(vertices_, [&](const LongMatrix& change) {
        LongMatrix residual(simplices(), n_ + 1);
        for (Index s = 0; s < simplices(); ++s) {
            const double share = volumes_[s] / ((n_ + 1) * (n_ + 2)),
                         sum = data.corners.row(s).sum();
            residual.row(s) = (share * (data.corners.row(s).array() + sum)).cast<long double>();
            residual.row(s) -= (differences(corners, s) + differences(change, s)) * gradients_[s];
            const LongRow u = values(corners, s) + change.row(s);
            for (int i = 0; i <= n_; ++i) {
                const double alpha = sides_[std::size_t(n_ + 1) * s + i].robin;
                const double weight = alpha * areas_(s, i) / (n_ * (n_ + 1));
                for (int j = 0; j <= n_; ++j)
                    if (j != i)
                        residual(s, j) += data.facet_flow(s, i) / n_ -
                                          weight * (u[j] + n_ * mean_over_facet(u, i));
            }
        }
        return residual;
    });
}

PoissonPair PoissonForms::pair(const DenseMatrix& corners, const LocalData& data) const {
    // as n times the means of a linear function are minus its values, but for a constant
    Solution found = solution(facets_, [&](const LongMatrix& change) {
        LongMatrix residual(simplices(), n_ + 1);
        for (Index s = 0; s < simplices(); ++s) {
            const double load = data.means[s] * volumes_[s] / (n_ + 1);
            residual.row(s) = (data.facet_flow.row(s).array() + load).cast<long double>();
            residual.row(s) +=
                n_ * (differences(corners, s) - n_ * differences(change, s)) * gradients_[s];
            for (int i = 0; i <= n_; ++i)
                residual(s, i) -= sides_[std::size_t(n_ + 1) * s + i].robin * areas_(s, i) *
                                  (mean_over_facet(values(corners, s), i) + change(s, i));
        }
        return residual;
    });
    constexpr double least = 1e-140; // of norms whose squares do not underflow
    const bool is_exact = found.values.isZero(0) && data.corners.isZero(0);
    const double rounding = found.size_of_last_step + (is_exact ? 0 : least);
    return {corners, std::move(found.values), data.means, rounding};
}

double PoissonForms::over_facet(const DenseMatrix& u, const DenseMatrix& v, Index s,
                                int omitted) const {
    double products = 0, sum_u = 0, sum_v = 0;
    for (int i = 0; i <= n_; ++i)
        if (i != omitted) {
            products += u(s, i) * v(s, i);
            sum_u += u(s, i), sum_v += v(s, i);
        }
    return areas_(s, omitted) * (products + sum_u * sum_v) / (n_ * (n_ + 1));
}

Vector PoissonForms::products(const PoissonPair& a, const PoissonPair& b) const {
    Vector result(simplices());
    for (Index s = 0; s < simplices(); ++s) {
        const LongRow weights = n_ * differences(b.change, s) * gradients_[s];
        result[s] = double(n_ * differences(a.change, s).dot(weights)) +
                    a.source[s] * b.source[s] * bubbles_[s] * volumes_[s];
        for (int i = 0; i <= n_; ++i)
            if (const double alpha = sides_[std::size_t(n_ + 1) * s + i].robin; alpha > 0) {
                const auto on_facet = [&](const PoissonPair& pair) {
                    LongRow x = values(pair.corners, s);
                    x.array() -= mean_over_facet(x, i) + pair.change(s, i);
                    x[i] = 0;
                    return x;
                };
                const LongRow x = on_facet(a), y = on_facet(b);
                result[s] +=
                    alpha * areas_(s, i) * double(x.dot(y) + x.sum() * y.sum()) / (n_ * (n_ + 1));
            }
    }
    return result;
}

double PoissonForms::of_gradients(const DenseMatrix& u, const DenseMatrix& v) const {
    long double sum = 0;
    for (Index s = 0; s < simplices(); ++s)
        sum += differences(u, s).dot(differences(v, s) * gradients_[s]);
    return double(sum);
}

double PoissonForms::energy(const DenseMatrix& u, const DenseMatrix& v) const {
    double sum = of_gradients(u, v);
    for (Index s = 0; s < simplices(); ++s)
        for (int i = 0; i <= n_; ++i)
            if (const double alpha = sides_[std::size_t(n_ + 1) * s + i].robin; alpha > 0)
                sum += alpha * over_facet(u, v, s, i);
    return sum;
}

double PoissonForms::mass(Index s, const DenseMatrix& u, const DenseMatrix& v) const {
    return volumes_[s] * (u.row(s).dot(v.row(s)) + u.row(s).sum() * v.row(s).sum()) /
           ((n_ + 1) * (n_ + 2));
}

double PoissonForms::load(const LocalData& data, const DenseMatrix& v) const {
    double sum = 0;
    for (Index s = 0; s < simplices(); ++s) {
        sum += mass(s, data.corners, v);
        for (int i = 0; i <= n_; ++i)
            if (data.facet_flow(s, i) != 0)
                sum += data.facet_flow(s, i) * double(mean_over_facet(values(v, s), i));
    }
    return sum;
}

} // namespace polydec
