// SPDX-License-Identifier: MIT
#include "shape/poisson_pair.h"

#include "backends/registry.h"

#include <algorithm>
#include <cmath>

namespace polydec {

Vector PoissonForms::System::solve(Vector b) const {
    for (const auto constant : kernel.colwise()) // 0 and 1
        b -= constant.dot(b) / constant.sum() * constant;
    return solver->solve(b);
}

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
        gradients_.push_back((kappa * simplex.volume * simplex.gradients).cast<double>());
        for (int i = 0; i <= n_; ++i)
            areas_(s, i) = double(simplex.facet_volume(i));
    }
    facets_ = system(crouzeix_raviart_form(shape), engine);
    vertices_ = system(ConformingForm(shape, 1).family(), engine);
}

PoissonForms::System PoissonForms::system(const FormFamily& family,
                                          const std::string& engine) const {
    const CountedMatrix counted = family.at(0);
    System system{*counted.matrix,
                  family.unknowns().of_simplices,
                  {},
                  make_linear_solver(engine),
                  counted.doubt.share};
    const Index free =
        components_.empty() ? 0 : *std::max_element(components_.begin(), components_.end()) + 1;
    system.kernel = DenseMatrix::Zero(family.size(), free);
    for (std::size_t at = 0; at < system.unknowns.size(); ++at)
        if (const Index component = components_[at / std::size_t(n_ + 1)];
            component >= 0 && system.unknowns[at] >= 0)
            system.kernel(system.unknowns[at], component) = 1;
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

Vector PoissonForms::gathered(const System& system, const DenseMatrix& local) const {
    Vector sums = Vector::Zero(system.K.rows());
    for (Index s = 0; s < simplices(); ++s)
        for (int i = 0; i <= n_; ++i)
            if (const Index u = system.unknowns[std::size_t(n_ + 1) * s + i]; u >= 0)
                sums[u] += local(s, i);
    return sums;
}

DenseMatrix PoissonForms::spread(const System& system, const Vector& values) const {
    DenseMatrix local = DenseMatrix::Zero(simplices(), n_ + 1);
    for (Index s = 0; s < simplices(); ++s)
        for (int i = 0; i <= n_; ++i)
            if (const Index u = system.unknowns[std::size_t(n_ + 1) * s + i]; u >= 0)
                local(s, i) = values[u];
    return local;
}

DenseMatrix PoissonForms::to_galerkin(const DenseMatrix& corners, const LocalData& data) const {
    DenseMatrix residual(simplices(), n_ + 1);
    for (Index s = 0; s < simplices(); ++s) {
        const double share = volumes_[s] / ((n_ + 1) * (n_ + 2)), sum = data.corners.row(s).sum();
        residual.row(s) =
            (share * (data.corners.row(s).array() + sum)).matrix() - corners.row(s) * gradients_[s];
        for (int i = 0; i <= n_; ++i) {
            const double alpha = sides_[std::size_t(n_ + 1) * s + i].robin;
            const double on_facet = corners.row(s).sum() - corners(s, i);
            const double weight = alpha * areas_(s, i) / (n_ * (n_ + 1));
            for (int j = 0; j <= n_; ++j)
                if (j != i)
                    residual(s, j) +=
                        data.facet_flow(s, i) / n_ - weight * (corners(s, j) + on_facet);
        }
    }
    return spread(vertices_, vertices_.K.rows() > 0 ? vertices_.solve(gathered(vertices_, residual))
                                                    : Vector());
}

PoissonPair PoissonForms::pair(const DenseMatrix& corners, const LocalData& data) const {
    PoissonPair pair{corners, DenseMatrix(simplices(), n_ + 1), data.means, 0};
    for (int i = 0; i <= n_; ++i)
        pair.means.col(i) = (corners.rowwise().sum() - corners.col(i)) / n_;
    if (facets_.K.rows() == 0)
        return pair;
    // the second solve finds what rounding has left of the first one
    for (int step = 0; step < 2; ++step) {
        DenseMatrix residual(simplices(), n_ + 1);
        for (Index s = 0; s < simplices(); ++s) {
            const double load = data.means[s] * volumes_[s] / (n_ + 1);
            residual.row(s) = data.facet_flow.row(s).array() + load;
            residual.row(s) -= n_ * n_ * (pair.means.row(s) * gradients_[s]);
            for (int i = 0; i <= n_; ++i)
                residual(s, i) -=
                    sides_[std::size_t(n_ + 1) * s + i].robin * areas_(s, i) * pair.means(s, i);
        }
        const Vector right = gathered(facets_, residual), change = facets_.solve(right);
        pair.means += spread(facets_, change);
        pair.rounding = std::sqrt(std::max(right.dot(change), 0.0));
    }
    return pair;
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
    const auto weights = [&](const PoissonPair& pair, Index s) {
        const Eigen::RowVectorXd sum = n_ * pair.means.row(s) + pair.corners.row(s);
        return Eigen::RowVectorXd(sum.array() - sum.mean()); // constants have no gradient
    };
    Vector result(simplices());
    for (Index s = 0; s < simplices(); ++s) {
        result[s] = weights(a, s).dot(weights(b, s) * gradients_[s]) +
                    a.source[s] * b.source[s] * bubbles_[s] * volumes_[s];
        for (int i = 0; i <= n_; ++i)
            if (const double alpha = sides_[std::size_t(n_ + 1) * s + i].robin; alpha > 0) {
                DenseMatrix x = a.corners.row(s).array() - a.means(s, i),
                            y = b.corners.row(s).array() - b.means(s, i);
                x(0, i) = y(0, i) = 0;
                result[s] += alpha * areas_(s, i) * (x.row(0).dot(y.row(0)) + x.sum() * y.sum()) /
                             (n_ * (n_ + 1));
            }
    }
    return result;
}

double PoissonForms::of_gradients(const DenseMatrix& u, const DenseMatrix& v) const {
    double sum = 0;
    for (Index s = 0; s < simplices(); ++s)
        sum += u.row(s).dot(v.row(s) * gradients_[s]);
    return sum;
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
            sum += data.facet_flow(s, i) * (v.row(s).sum() - v(s, i)) / n_;
    }
    return sum;
}

} // namespace polydec
