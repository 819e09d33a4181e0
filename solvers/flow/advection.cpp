// SPDX-License-Identifier: MIT
#include "solvers/flow/advection.h"

#include "base/checks.h"
#include "base/decompositions.h"
#include "base/errors.h"
#include "dec/metric/exterior_product.h"
#include "dec/metric/permutation_sign.h"
#include "dec/metric/simplex_geometry.h"
#include "dec/metric/subsets.h"
#include "solvers/dual_fluxes.h"
#include "solvers/flow/developed_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polydec {

namespace {

void check_cells(const Discretization& mesh) {
    const int n = mesh.dimension();
    if (n < 2)
        throw InvalidInput(fmt::format("a flow in dimension {} is asked for: expected 2 at least, "
                                       "with less there is no vorticity",
                                       n));
    check_two_sided(mesh.complex(), facet_duals(mesh.complex(), mesh.stars()));
    if (const auto& both = mesh.complex().canceled(n - 1); !both.empty())
        throw InvalidInput(fmt::format("{}-cell {} lies on both sides of facet {}: divide it for "
                                       "flows",
                                       n, both.front().cell, both.front().face),
                           {.degree = n, .cells = {both.front().cell}});
}

/// The coefficients of z ^ e_i ^ e_j, i < j, for what z is in the basis: which one and its sign.
struct Pair {
    int i, j;
    Index coefficient;
    double sign;
};

std::vector<Pair> pairs_of(int n) {
    std::vector<Pair> pairs;
    const auto rests = subsets(n, n - 2);
    for (std::size_t r = 0; r < rests.size(); ++r) {
        auto order = rests[r];
        for (int axis = 0; axis < n; ++axis)
            if (std::find(rests[r].begin(), rests[r].end(), axis) == rests[r].end())
                order.push_back(axis);
        const int i = order[n - 2], j = order[n - 1];
        pairs.push_back({i, j, static_cast<Index>(r), double(permutation_sign(order))});
    }
    return pairs;
}

/// Whitney's (n-2)-forms of the faces of a simplex, at its centroid: a column each.
class Whitney {
public:
    explicit Whitney(int n) : n_(n), faces_(subsets(n + 1, n - 1)), product_(n, n - 2) {}

    const std::vector<std::vector<int>>& faces() const { return faces_; }

    DenseMatrix at_centroid(const DenseMatrix& gradients) const {
        DenseMatrix forms = DenseMatrix::Zero(product_.size(), static_cast<Index>(faces_.size()));
        for (std::size_t f = 0; f < faces_.size(); ++f)
            for (int p = 0; p <= n_ - 2; ++p) {
                auto others = faces_[f];
                others.erase(others.begin() + p);
                const double sign = p % 2 == 0 ? 1 : -1;
                forms.col(static_cast<Index>(f)) += sign * product_(gradients(others, Eigen::all));
            }
        return std::tgamma(n_ - 1.0) / (n_ + 1) * forms;
    }

private:
    int n_;
    std::vector<std::vector<int>> faces_;
    ExteriorProduct product_;
};

} // namespace

struct Advection::Parts {
    int n;
    CellComplex complex;
    Vector volumes;            // of n-cells
    std::vector<Index> begins; // of the facets of each n-cell in what follows
    std::vector<SignedFace> facets;
    Points arms; // from the centroid of the cell to that of the facet
    std::vector<Pair> pairs;
    SparseMatrix vorticity; // in n-cells, a row for each pair: z ^ e_i ^ e_j

    explicit Parts(const Discretization& mesh)
        : n(mesh.dimension()),
          complex(mesh.complex()),
          volumes(mesh.volumes().primal(n)),
          pairs(pairs_of(n)) {
        const Points corners = developed_corners(mesh);
        collect_facets(mesh, corners);
        collect_vorticity(mesh, corners);
    }

    Index cells() const { return static_cast<Index>(volumes.size()); }

    Eigen::RowVectorXd velocity(Index cell, const Vector& w) const {
        Eigen::RowVectorXd u = Eigen::RowVectorXd::Zero(n);
        for (Index i = begins[cell]; i < begins[cell + 1]; ++i)
            u += facets[i].sign * w[facets[i].face] * arms.row(i);
        return u / volumes[cell];
    }

    /// The matrix F with v . F u = z ^ u ^ v.
    void turn(Index cell, const Vector& z, DenseMatrix& F) const {
        const Index first = cell * static_cast<Index>(pairs.size());
        for (std::size_t p = 0; p < pairs.size(); ++p) {
            const double value = z[first + static_cast<Index>(p)];
            F(pairs[p].j, pairs[p].i) = value;
            F(pairs[p].i, pairs[p].j) = -value;
        }
    }

private:
    void collect_facets(const Discretization& mesh, const Points& corners);
    void collect_vorticity(const Discretization& mesh, const Points& corners);
};

/// Sums over the pieces of cells and of facets.
void Advection::Parts::collect_facets(const Discretization& mesh, const Points& corners) {
    begins.push_back(0);
    for (Index cell = 0; cell < cells(); ++cell) {
        for (const auto& facet : complex.incidences(n - 1)[cell])
            facets.push_back(facet);
        begins.push_back(static_cast<Index>(facets.size()));
    }
    arms = Points::Zero(static_cast<Index>(facets.size()), n);

    const auto& K = mesh.pieces();
    const auto& merging = mesh.merging();
    const Vector &sizes = mesh.piece_volumes().primal(n),
                 &areas = mesh.piece_volumes().primal(n - 1);
    const Vector& whole_areas = mesh.volumes().primal(n - 1);
    for (Index cell = 0; cell < cells(); ++cell) {
        Eigen::RowVectorXd centroid = Eigen::RowVectorXd::Zero(n);
        const auto own = std::span(facets).subspan(begins[cell], begins[cell + 1] - begins[cell]);
        for (IncidenceMatrix::InnerIterator piece(merging.diamond(n), cell); piece; ++piece) {
            const Index t = static_cast<Index>(piece.col());
            const auto places = corners.middleRows(Eigen::Index{t} * (n + 1), n + 1);
            centroid += sizes[t] / volumes[cell] * places.colwise().mean();
            for (int i = 0; i <= n; ++i) {
                const Index side = K.face(n, t, i);
                const auto& [dimension, facet] = merging.carriers(n - 1)[side];
                if (dimension == n)
                    continue;
                const auto found =
                    std::lower_bound(own.begin(), own.end(), facet,
                                     [](const SignedFace& a, Index b) { return a.face < b; });
                arms.row(begins[cell] + (found - own.begin())) +=
                    areas[side] / whole_areas[facet] * (places.colwise().sum() - places.row(i)) / n;
            }
        }
        arms.middleRows(begins[cell], begins[cell + 1] - begins[cell]).rowwise() -= centroid;
    }
}

void Advection::Parts::collect_vorticity(const Discretization& mesh, const Points& corners) {
    const auto& K = mesh.pieces();
    const Vector& sizes = mesh.piece_volumes().primal(n);
    const Whitney whitney(n);
    std::vector<Eigen::Triplet<double, Index>> entries;
    for (Index cell = 0; cell < cells(); ++cell)
        for (IncidenceMatrix::InnerIterator piece(mesh.merging().diamond(n), cell); piece;
             ++piece) {
            const Index t = static_cast<Index>(piece.col());
            if (mesh.is_flat(t))
                continue;
            const DenseMatrix places = corners.middleRows(Eigen::Index{t} * (n + 1), n + 1);
            const DenseMatrix edges = places.bottomRows(n).rowwise() - places.row(0);
            DenseMatrix gradients(n + 1, n);
            gradients.bottomRows(n) = edges.inverse().transpose();
            gradients.row(0) = -gradients.bottomRows(n).colwise().sum();
            const double side = piece.value() * K.orientation(t) *
                                (edges.determinant() > 0 ? 1 : -1) * sizes[t] / volumes[cell];
            const DenseMatrix forms = whitney.at_centroid(gradients);
            for (std::size_t f = 0; f < whitney.faces().size(); ++f) {
                const Index face = face_at(K, n, t, whitney.faces()[f]);
                for (std::size_t p = 0; p < pairs.size(); ++p)
                    entries.emplace_back(
                        cell * static_cast<Index>(pairs.size()) + static_cast<Index>(p), face,
                        side * pairs[p].sign * forms(pairs[p].coefficient, static_cast<Index>(f)));
            }
        }
    SparseMatrix on_pieces(cells() * static_cast<Index>(pairs.size()), K.size(n - 2));
    on_pieces.setFromTriplets(entries.begin(), entries.end());
    vorticity = on_pieces * mesh.lift()[n - 2];
}

Advection::Advection(const Discretization& mesh) {
    check_cells(mesh);
    parts_ = std::make_shared<Parts>(mesh);
}

int Advection::dimension() const {
    return parts_->n;
}

Vector Advection::operator()(const Vector& z, const Vector& w) const {
    const Parts& parts = *parts_;
    check_as_many("values of the vorticity", z.size(), parts.vorticity.cols());
    check_as_many("fluxes", w.size(), parts.complex.size(parts.n - 1));
    const Vector in_cells = parts.vorticity * z;
    Vector force = Vector::Zero(w.size());
    DenseMatrix F = DenseMatrix::Zero(parts.n, parts.n);
    for (Index cell = 0; cell < parts.cells(); ++cell) {
        parts.turn(cell, in_cells, F);
        const Vector across = F * parts.velocity(cell, w).transpose();
        for (Index i = parts.begins[cell]; i < parts.begins[cell + 1]; ++i)
            force[parts.facets[i].face] += parts.facets[i].sign * parts.arms.row(i).dot(across);
    }
    return force;
}

SparseMatrix Advection::matrix(const Vector& z) const {
    const Parts& parts = *parts_;
    check_as_many("values of the vorticity", z.size(), parts.vorticity.cols());
    const Vector in_cells = parts.vorticity * z;
    std::vector<Eigen::Triplet<double, Index>> entries;
    DenseMatrix F = DenseMatrix::Zero(parts.n, parts.n);
    for (Index cell = 0; cell < parts.cells(); ++cell) {
        parts.turn(cell, in_cells, F);
        for (Index i = parts.begins[cell]; i < parts.begins[cell + 1]; ++i)
            for (Index j = parts.begins[cell]; j < i; ++j) {
                const auto &f = parts.facets[i], &g = parts.facets[j];
                const double value = f.sign * g.sign / parts.volumes[cell] *
                                     (parts.arms.row(i) * F).dot(parts.arms.row(j));
                entries.emplace_back(f.face, g.face, value);
                entries.emplace_back(g.face, f.face, -value);
            }
    }
    SparseMatrix result(parts.complex.size(parts.n - 1), parts.complex.size(parts.n - 1));
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}

Vector Advection::kinetic_energy(const Vector& w) const {
    check_as_many("fluxes", w.size(), parts_->complex.size(parts_->n - 1));
    Vector result(parts_->cells());
    for (Index cell = 0; cell < parts_->cells(); ++cell)
        result[cell] = parts_->velocity(cell, w).squaredNorm() / 2;
    return result;
}

double Advection::exchange_rate(const Vector& w) const {
    const Parts& parts = *parts_;
    check_as_many("fluxes", w.size(), parts.complex.size(parts.n - 1));
    double most = 0;
    for (Index cell = 0; cell < parts.cells(); ++cell) {
        double sum = 0;
        for (Index i = parts.begins[cell]; i < parts.begins[cell + 1]; ++i)
            sum += std::abs(w[parts.facets[i].face]);
        most = std::max(most, sum / 2 / parts.volumes[cell]);
    }
    return most;
}

} // namespace polydec
