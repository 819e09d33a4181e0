// SPDX-License-Identifier: MIT
#include "tests/solvers/smooth_waves.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace polydec::test {

namespace {

using Subset = std::vector<int>;

/// The k-subsets of 0..n-1 in lexicographic order; made once, since quadratures ask for them.
const std::vector<Subset>& subsets_of(int n, int k) {
    static std::map<std::pair<int, int>, std::vector<Subset>> known;
    auto& result = known[{n, k}];
    if (!result.empty())
        return result;
    std::vector<bool> chosen(n, false);
    std::fill(chosen.begin(), chosen.begin() + k, true);
    do {
        Subset subset;
        for (int i = 0; i < n; ++i)
            if (chosen[i])
                subset.push_back(i);
        result.push_back(subset);
    } while (std::prev_permutation(chosen.begin(), chosen.end()));
    return result;
}

/// The place of a subset, and the sign of sorting it; 0 if an axis is there twice.
std::pair<Index, double> sorted(int n, Subset axes) {
    double sign = 1;
    for (std::size_t i = 0; i < axes.size(); ++i)
        for (std::size_t j = i + 1; j < axes.size(); ++j) {
            if (axes[i] == axes[j])
                return {0, 0.0};
            sign = axes[i] > axes[j] ? -sign : sign;
        }
    std::sort(axes.begin(), axes.end());
    const auto& all = subsets_of(n, static_cast<int>(axes.size()));
    return {static_cast<Index>(std::find(all.begin(), all.end(), axes) - all.begin()), sign};
}

/// d of a form from the gradients of its coefficients.
Vector derivative_of(int n, int k, const DenseMatrix& gradients) {
    Vector result = Vector::Zero(static_cast<Index>(subsets_of(n, k + 1).size()));
    const auto& all = subsets_of(n, k);
    for (Index I = 0; I < gradients.rows() && k < n; ++I)
        for (int axis = 0; axis < n; ++axis) {
            Subset axes{axis};
            axes.insert(axes.end(), all[I].begin(), all[I].end());
            const auto [place, sign] = sorted(n, axes);
            if (sign != 0)
                result[place] += sign * gradients(I, axis);
        }
    return result;
}

/// - sum of d_i u_I over i in I, times dx_I without dx_i.
Vector codifferential_of(int n, int k, const DenseMatrix& gradients) {
    Vector result = Vector::Zero(static_cast<Index>(subsets_of(n, k - 1).size()));
    const auto& all = subsets_of(n, k);
    for (Index I = 0; I < gradients.rows(); ++I)
        for (int i = 0; i < k; ++i) {
            Subset others = all[I];
            others.erase(others.begin() + i);
            result[sorted(n, others).first] -= (i % 2 == 0 ? 1 : -1) * gradients(I, all[I][i]);
        }
    return result;
}

} // namespace

Vector euclidean_star(int n, int k, const Vector& coefficients) {
    Vector result(coefficients.size());
    const auto& all = subsets_of(n, k);
    for (Index I = 0; I < coefficients.size(); ++I) {
        Subset axes = all[I], complement;
        for (int i = 0; i < n; ++i)
            if (std::find(axes.begin(), axes.end(), i) == axes.end())
                complement.push_back(i);
        axes.insert(axes.end(), complement.begin(), complement.end());
        result[sorted(n, complement).first] = sorted(n, axes).second * coefficients[I];
    }
    return result;
}

Vector WaveForm::coefficients(const Vector& x) const {
    Vector result(static_cast<Index>(subsets_of(n_, k_).size()));
    for (Index I = 0; I < result.size(); ++I)
        result[I] = (frequency_ * x.array() + 0.3 + 0.7 * I).cos().prod();
    return result;
}

DenseMatrix WaveForm::gradients(const Vector& x) const {
    DenseMatrix result(static_cast<Index>(subsets_of(n_, k_).size()), n_);
    for (Index I = 0; I < result.rows(); ++I)
        for (int axis = 0; axis < n_; ++axis) {
            Vector factors = (frequency_ * x.array() + 0.3 + 0.7 * I).cos();
            factors[axis] = -frequency_ * std::sin(frequency_ * x[axis] + 0.3 + 0.7 * I);
            result(I, axis) = factors.prod();
        }
    return result;
}

SmoothForm WaveForm::form() const {
    return [u = *this](const Vector& x) { return u.coefficients(x); };
}

SmoothForm WaveForm::derivative() const {
    return [u = *this](const Vector& x) { return derivative_of(u.n_, u.k_, u.gradients(x)); };
}

SmoothForm WaveForm::codifferential() const {
    return [u = *this](const Vector& x) { return codifferential_of(u.n_, u.k_, u.gradients(x)); };
}

SmoothForm WaveForm::star() const {
    return [u = *this](const Vector& x) { return euclidean_star(u.n_, u.k_, u.coefficients(x)); };
}

SmoothForm WaveForm::star_derivative() const {
    return [u = *this](const Vector& x) {
        return euclidean_star(u.n_, u.k_ + 1, derivative_of(u.n_, u.k_, u.gradients(x)));
    };
}

Cochain WaveForm::on(const Discretization& mesh, Side side) const {
    return side == Side::primal ? de_rham(mesh, k_, form()) : dual_de_rham(mesh, k_, form());
}

BoundaryForms WaveForm::boundary(const Discretization& mesh, Side side) const {
    const bool primal = side == Side::primal;
    const auto trace = [&](int k, const SmoothForm& w, bool over_cells) -> Vector {
        if (k < 0 || k >= n_ + (over_cells ? 1 : 0))
            return {};
        return over_cells ? de_rham(mesh, k, w).values : boundary_de_rham(mesh, k, w);
    };
    return {trace(k_, form(), primal), trace(k_ - 1, codifferential(), primal),
            trace(n_ - k_, star(), !primal), trace(n_ - k_ - 1, star_derivative(), !primal)};
}

Vector WaveForm::boundary_star(const Discretization& mesh, Side side) const {
    // with (nu, tangents) oriented, the star within the boundary of dx_I is the dx_J for which
    // nu ^ dx_I ^ dx_J is positive, so that of u is the star of nu ^ u
    const SmoothForm trace = [u = *this](const Vector& x) -> Vector {
        Vector normal = Vector::Zero(u.n_);
        for (int axis = 0; axis < u.n_; ++axis)
            normal[axis] = x[axis] < 1e-9 ? (axis == 0 ? 0 : -1) : x[axis] > 1 - 1e-9 ? 1 : 0;
        normal /= std::max(1.0, normal.cwiseAbs().sum());
        const Vector c = u.coefficients(x);
        const Vector wedge = derivative_of(u.n_, u.k_, c * normal.transpose());
        return euclidean_star(u.n_, u.k_ + 1, wedge);
    };
    const int degree = n_ - k_ - 1;
    return side == Side::primal ? boundary_de_rham(mesh, degree, trace)
                                : de_rham(mesh, degree, trace).values;
}

} // namespace polydec::test
