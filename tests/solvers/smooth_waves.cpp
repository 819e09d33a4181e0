// SPDX-License-Identifier: MIT
#include "tests/solvers/smooth_waves.h"

#include "dec/metric/subsets.h"

namespace polydec::test {

namespace {

/// dx_axis ^ dx_from = sign dx_to.
struct Product {
    Index from, axis, to;
    double sign;
};

/// All products of an axis and a k-form; made once, since quadratures ask for them.
const std::vector<Product>& products(int n, int k) {
    static std::map<std::pair<int, int>, std::vector<Product>> known;
    auto& result = known[{n, k}];
    if (!result.empty() || k >= n)
        return result;
    const auto lower = subsets(n, k), upper = subsets(n, k + 1);
    for (std::size_t to = 0; to < upper.size(); ++to)
        for (int i = 0; i <= k; ++i) {
            auto rest = upper[to];
            rest.erase(rest.begin() + i);
            const auto from = std::find(lower.begin(), lower.end(), rest) - lower.begin();
            result.push_back({static_cast<Index>(from), static_cast<Index>(upper[to][i]),
                              static_cast<Index>(to), i % 2 == 0 ? 1.0 : -1.0});
        }
    return result;
}

/// d of a form from the gradients of its coefficients.
Vector derivative_of(int n, int k, const DenseMatrix& gradients) {
    Vector result = Vector::Zero(coefficients(n, k + 1));
    for (const auto& [from, axis, to, sign] : products(n, k))
        result[to] += sign * gradients(from, axis);
    return result;
}

/// - sum of d_i u_I over i in I, times dx_I without dx_i.
Vector codifferential_of(int n, int k, const DenseMatrix& gradients) {
    Vector result = Vector::Zero(coefficients(n, k - 1));
    for (const auto& [to, axis, from, sign] : products(n, k - 1))
        result[to] -= sign * gradients(from, axis);
    return result;
}

} // namespace

Vector euclidean_star(int n, int k, const Vector& coefficients) {
    // complements of subsets in lexicographic order are in the opposite one
    static std::map<std::pair<int, int>, Vector> signs;
    auto& sign = signs[{n, k}];
    for (const auto& axes : sign.size() == 0 ? subsets(n, k) : std::vector<std::vector<int>>()) {
        const int moved = std::accumulate(axes.begin(), axes.end(), 0) - k * (k - 1) / 2;
        sign.conservativeResize(sign.size() + 1);
        sign[sign.size() - 1] = moved % 2 == 0 ? 1 : -1;
    }
    return sign.cwiseProduct(coefficients).reverse();
}

Vector WaveForm::coefficients(const Vector& x) const {
    Vector result(test::coefficients(n_, k_));
    for (Index I = 0; I < result.size(); ++I)
        result[I] = (frequency_ * x.array() + 0.3 + 0.7 * I).cos().prod();
    return result;
}

DenseMatrix WaveForm::gradients(const Vector& x) const {
    DenseMatrix result(test::coefficients(n_, k_), n_);
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
