// SPDX-License-Identifier: MIT
#include "examples/paper/problems.h"

#include "examples/paper/report.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace polydec::paper {

namespace {

/// c exp(-q) with q = (9x - a)^2 s + (9y - b)^2 t.
struct Bump {
    double c, a, b, s, t;
};
constexpr std::array<Bump, 3> bumps{
    {{0.75, 2, 2, 0.25, 0.25}, {0.5, 7, 3, 0.25, 0.25}, {-0.2, 4, 7, 1, 1}}};

int cells(int level) {
    return 8 << level;
}

/// A split grid with inner vertices moved by at most this distance along each axis.
Mesh with_moved_inner_vertices(int cells, double distance) {
    const Mesh regular = grid(cells, cells);
    Mesh mesh = perturbed(regular, distance, 1);
    for (Index v = 0; v < mesh.points.rows(); ++v) {
        const auto p = regular.points.row(v).array();
        if (p.minCoeff() <= 0 || p.maxCoeff() >= 1)
            mesh.points.row(v) = regular.points.row(v);
    }
    return mesh;
}

} // namespace

Discretization discretized(Mesh mesh, DiscretizeOptions options) {
    options.star = StarKind::circumcentric;
    return discretize(std::move(mesh), options);
}

Vector values(const Function& function, const Points& sites) {
    Vector result(sites.rows());
    for (Index i = 0; i < result.size(); ++i)
        result[i] = function(sites.row(i).transpose());
    return result;
}

double franke(const Vector& point) {
    const double x = 9 * point[0], y = 9 * point[1];
    double sum = 0.75 * std::exp(-(x + 1) * (x + 1) / 49 - (y + 1) / 10);
    for (const auto& bump : bumps)
        sum += bump.c * std::exp(-bump.s * (x - bump.a) * (x - bump.a) -
                                 bump.t * (y - bump.b) * (y - bump.b));
    return sum;
}

double franke_laplacian(const Vector& point) {
    // -div grad of c exp(-q) is c exp(-q) (div grad q - |grad q|^2)
    const double x = 9 * point[0], y = 9 * point[1];
    const double gx = 18 * (x + 1) / 49, gy = 0.9;
    double sum =
        0.75 * std::exp(-(x + 1) * (x + 1) / 49 - (y + 1) / 10) * (162.0 / 49 - gx * gx - gy * gy);
    for (const auto& bump : bumps) {
        const double u = x - bump.a, v = y - bump.b;
        const double qx = 18 * bump.s * u, qy = 18 * bump.t * v;
        sum += bump.c * std::exp(-bump.s * u * u - bump.t * v * v) *
               (162 * (bump.s + bump.t) - qx * qx - qy * qy);
    }
    return sum;
}

double harmonic(const Vector& point) {
    const Vector p = point.normalized();
    return (p[0] * p[0] - p[1] * p[1]) * (7 * p[2] * p[2] - 1);
}

std::vector<Family> planar_families() {
    return {{"well-centered", [](int level) { return well_centered(cells(level)); }},
            {"grid", [](int level) { return grid(cells(level), cells(level)); }},
            {"hexagons", [](int level) { return hexagons(cells(level)); }},
            {"general", [](int level) {
                 return with_moved_inner_vertices(cells(level), 0.25 / cells(level));
             }}};
}

std::vector<Family> sphere_families() {
    return {{"quads", [](int level) { return uv_sphere(2 * cells(level), 2 * cells(level)); }},
            {"hexagons", [](int level) { return goldberg(4 << level); }}};
}

Vector inner_edge_lengths(const Discretization& mesh) {
    const auto& counts = mesh.complex().coface_counts(1);
    std::vector<double> inner;
    for (Index e = 0; e < mesh.complex().size(1); ++e)
        if (counts[e] > 1)
            inner.push_back(mesh.volumes().primal(1)[e]);
    return inner.empty() ? mesh.volumes().primal(1)
                         : Vector(Eigen::Map<Vector>(inner.data(), Index(inner.size())));
}

double median(Vector numbers) {
    auto middle = numbers.begin() + numbers.size() / 2;
    std::nth_element(numbers.begin(), middle, numbers.end());
    return *middle;
}

const Vector& masses(const Discretization& mesh, Side side) {
    return side == Side::primal ? mesh.volumes().dual(0) : mesh.volumes().primal(mesh.dimension());
}

double weighted_norm(const Vector& masses, const Vector& values) {
    return std::sqrt(masses.dot(values.cwiseAbs2()));
}

double relative_error(const Vector& masses, const Vector& computed, const Vector& exact) {
    return weighted_norm(masses, computed - exact) / weighted_norm(masses, exact);
}

SphereError sphere_error(const SparseMatrix& mass, const Vector& u, const Vector& Y) {
    const auto norm = [&](const Vector& v) { return std::sqrt(v.dot(mass * v)); };
    return {norm(u - Y) / norm(Y), norm(u / norm(u) - Y / norm(Y))};
}

SphereError sphere_error(const Discretization& sphere, Side side) {
    const Vector Y = values(harmonic, sites(sphere, side));
    const Vector u = PoissonSolver({sphere, side, 0}).solve({side, 0, 20 * Y}).form.values;
    return sphere_error(SparseMatrix(masses(sphere, side).asDiagonal()), u, Y);
}

double order_between(const std::vector<double>& sizes, const std::vector<double>& errors,
                     int level) {
    return observed_order({sizes[level - 1], sizes[level]}, {errors[level - 1], errors[level]});
}

} // namespace polydec::paper
