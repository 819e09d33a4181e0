// SPDX-License-Identifier: MIT
#include "dec/discretization/material_stars.h"

#include "base/checks.h"
#include "base/decompositions.h"
#include "base/errors.h"
#include "dec/metric/rounding.h"
#include "dec/metric/simplex_geometry.h"
#include "dec/stars/choose_stars.h"
#include "dec/stars/galerkin_mass.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polydec {

namespace {

DenseMatrix inverse(const DenseMatrix& tensor, int n, Index cell) {
    if (tensor.rows() == n && tensor.cols() == n && tensor.allFinite() &&
        (tensor - tensor.transpose()).norm() <= 1e-12 * tensor.norm())
        if (const Eigen::LLT<DenseMatrix> factors(tensor); factors.info() == Eigen::Success)
            return pseudo_inverse(tensor);
    throw InvalidInput(
        fmt::format("the conductivity of the input's {1}-cell {2} is a {3} x {4} matrix: "
                    "expected a symmetric positive definite one of {0} x {0}",
                    n, n, cell, tensor.rows(), tensor.cols()),
        {.degree = n, .cells = {cell}});
}

void check_in_place(const Discretization& mesh) {
    if (!mesh.passage().is_identity() || mesh.measured_points().cols() != mesh.dimension())
        throw InvalidInput(fmt::format("conductivities that depend on the direction need a flat "
                                       "mesh of {0}-cells in {0} coordinates, without flips: give "
                                       "a number for each cell",
                                       mesh.dimension()));
}

/// Inner products by G of the fluxes (x - a_i) / (n |t|) of a simplex with corners a_i: the
/// products at the centroid g, plus the second moments of the corners about it.
DenseMatrix flux_products(const Points& corners, const DenseMatrix& G, double volume) {
    const auto n = static_cast<double>(corners.cols());
    const DenseMatrix out = corners.rowwise() - corners.colwise().mean();
    const double moments = (out * G * out.transpose()).trace() / ((n + 1) * (n + 2));
    return (out * G * out.transpose() + DenseMatrix::Constant(out.rows(), out.rows(), moments)) /
           (n * n * volume);
}

/// The parts in the n-cells of |E||*E|, which makes up the diagonal star of k-cells.
SparseMatrix parts_of_star(const Discretization& mesh, int k) {
    const ChosenStars& chosen = mesh.chosen_stars();
    if (chosen.is_over_duals(k))
        return mesh.merged().parts(k, mesh.geometry().centers());
    SparseMatrix thirds = mesh.merged().parts(k, Centers::centroids());
    if (chosen.kind != StarKind::hybrid || !chosen.stars[k].is_diagonal())
        return thirds;
    // materials make all cells Galerkin's in their degree alone
    const auto marks = choose_stars(mesh.merged(), chosen.kind).galerkin;
    SparseMatrix parts = mesh.merged().parts(k, mesh.geometry().centers());
    const auto of = [&](SparseMatrix& matrix, bool galerkin) {
        matrix.prune([&](Eigen::Index t, Eigen::Index, double) { return marks[t] == galerkin; });
        return matrix;
    };
    return of(parts, false) + of(thirds, true);
}

/// The same entries, all set to 1.
SparseMatrix pattern(SparseMatrix matrix) {
    matrix.coeffs().setOnes();
    return matrix;
}

} // namespace

SparseMatrix material_star(const Discretization& mesh, int k, const CellData& weights) {
    check_number("a star of degree", k, 0, mesh.dimension());
    return GalerkinMass(mesh.merged())(k, weights.on(mesh, "weight", Range::positive));
}

SparseMatrix material_star(const Discretization& mesh, const std::vector<DenseMatrix>& tensors) {
    const int n = mesh.dimension();
    check_in_place(mesh);
    check_as_many(fmt::format("conductivities of the input's {}-cells", n), std::ssize(tensors),
                  count_input_cells(mesh));
    std::vector<DenseMatrix> inverses;
    for (Index cell = 0; cell < std::ssize(tensors); ++cell)
        inverses.push_back(inverse(tensors[cell], n, cell));
    const auto numbers = cells_of_input(mesh, "conductivities", [&](Index a, Index b) {
        return (tensors[a] - tensors[b]).norm() > 1e-12 * tensors[a].norm();
    });
    const GalerkinMass mass(mesh.merged());
    const Pieces& K = mass.pieces();
    const Points& points = *mass.metric().points();
    std::vector<Eigen::Triplet<double, Index>> entries;
    entries.reserve(K.size(n) * (n + 1) * (n + 1));
    for (Index t = 0; t < K.size(n); ++t) {
        const Index cell = numbers[mass.cell(t)];
        const Points corners = points(vertices(K.simplices(n), t), Eigen::indexing::all);
        const DenseMatrix edges = corners.bottomRows(n).rowwise() - corners.row(0);
        const DenseMatrix M = flux_products(corners, inverses[cell],
                                            std::abs(edges.determinant()) / std::tgamma(n + 1));
        // face i, without corner i, has the sign (-1)^i if flux leaves
        for (int i = 0; i <= n; ++i)
            for (int j = 0; j <= n; ++j)
                entries.emplace_back(K.face(n, t, i), K.face(n, t, j),
                                     ((i + j) % 2 == 0 ? 1 : -1) * M(i, j));
    }
    SparseMatrix W(K.size(n - 1), K.size(n - 1));
    W.setFromTriplets(entries.begin(), entries.end());
    return mass.lifted(n - 1, W);
}

Vector cell_means(const Discretization& mesh, int k, const CellData& given) {
    check_number("means around cells of degree", k, 0, mesh.dimension());
    const Vector weights = given.on(mesh, "weight", Range::not_negative);
    const SparseMatrix parts = parts_of_star(mesh, k);
    const Vector sums = parts.transpose() * Vector::Ones(parts.rows());
    Vector means = (parts.transpose() * weights).cwiseQuotient(sums);
    // cells without dual: mean over the n-cells that they touch
    const SparseMatrix where = pattern(parts);
    const Vector plain =
        (where.transpose() * weights).cwiseQuotient(where.transpose() * Vector::Ones(parts.rows()));
    const auto& volumes = mesh.volumes();
    for (Index cell = 0; cell < means.size(); ++cell)
        if (is_zero(sums[cell] / volumes.primal(k)[cell], volumes.terms(k)[cell]))
            means[cell] = plain[cell];
    return means;
}

HodgeStars weighted_stars(const Discretization& mesh, int k, const CellData& given) {
    const int n = mesh.dimension();
    check_number("a star of degree", k, 0, n);
    const HodgeStars& stars = mesh.stars();
    const ChosenStars& chosen = mesh.chosen_stars();
    const bool is_own = chosen.kind == StarKind::own;
    if (is_own && !stars[k].is_diagonal())
        throw InvalidInput(
            fmt::format("weights of cells cannot be combined with your own star of {}-cells, a "
                        "matrix, because the shares of the cells are unknown: compute that star "
                        "from the weights (material_star)",
                        k),
            {.degree = k});
    if (!stars[k].is_diagonal())
        return stars.with(k, material_star(mesh, k, given));
    const Vector weights = given.on(mesh, "weight", Range::positive);
    const CellVolumes &volumes = stars.volumes(), &none = is_own ? volumes : mesh.volumes();
    const SparseMatrix parts = parts_of_star(mesh, k);
    const Vector dual =
        is_own
            ? Vector(volumes.dual(k).cwiseProduct(cell_means(mesh, k, CellData::on_cells(weights))))
            : Vector((parts.transpose() * weights).cwiseQuotient(volumes.primal(k)));
    const Vector around = pattern(parts).transpose() * weights;
    HodgeStars result(chosen.is_over_duals(k)
                          ? volumes.with_dual(k, dual, around.cwiseProduct(none.terms(k).vector()),
                                              around.cwiseProduct(none.rounding(k).vector()))
                          : volumes.with_dual(k, dual));
    for (int j = 0; j <= n; ++j)
        if (!stars[j].is_diagonal())
            result = result.with(j, stars[j].matrix());
    return result;
}

Discretization with_material(const Discretization& mesh, int k, const CellData& weights) {
    ChosenStars result = mesh.chosen_stars();
    result.stars = weighted_stars(mesh, k, weights);
    if (!result.stars[k].is_diagonal()) {
        const Vector ones = Vector::Ones(mesh.complex().size(mesh.dimension()));
        result.geometric =
            result.geometric.with(k, material_star(mesh, k, CellData::on_cells(ones)));
        result.galerkin.assign(result.galerkin.size(), true);
    }
    return mesh.with_stars(result);
}

Discretization with_conductivity(const Discretization& mesh, Side side, const CellData& kappa) {
    const int k = side == Side::primal ? std::min(1, mesh.dimension()) : mesh.dimension() - 1;
    const Vector values = kappa.on(mesh, "conductivity", Range::positive);
    return with_material(
        mesh, k, CellData::on_cells(side == Side::primal ? values : Vector(values.cwiseInverse())));
}

Discretization with_electric_material(const Discretization& mesh, Side side, int degree,
                                      const CellData& permittivity, const CellData& permeability) {
    const bool is_primal = side == Side::primal;
    const int k = cell_degree(mesh.complex(), side, degree);
    Discretization result = mesh;
    const auto put = [&](int j, const char* name, const CellData& given, bool inverted) {
        if (given.is_empty())
            return;
        const Vector weights = given.on(mesh, name, Range::positive);
        result = with_material(
            result, j, CellData::on_cells(inverted ? Vector(weights.cwiseInverse()) : weights));
    };
    put(k, "permittivity", permittivity, !is_primal);
    put(is_primal ? k + 1 : k - 1, "permeability", permeability, is_primal);
    return result;
}

} // namespace polydec
