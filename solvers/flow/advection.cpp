// SPDX-License-Identifier: MIT
#include "solvers/flow/advection.h"

#include "base/checks.h"
#include "base/decompositions.h"
#include "base/errors.h"
#include "base/permutation_sign.h"
#include "dec/boundary/two_sided.h"
#include "dec/fields/developed_cells.h"
#include "dec/forms/input_units.h"
#include "dec/metric/exterior_product.h"
#include "dec/metric/simplex_geometry.h"
#include "dec/metric/subsets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace polydec {

namespace {

void check_cells(const Discretization& mesh) {
    const int n = mesh.dimension();
    if (n < 2)
        throw InvalidInput(fmt::format("flows are not defined in dimension {}: expected at least "
                                       "2, since vorticity needs two dimensions",
                                       n));
    check_two_sided(mesh);
    if (const auto& both = mesh.complex().canceled(n - 1); !both.empty())
        throw InvalidInput(
            fmt::format("{}-cell {} lies on both sides of facet {}: divide the cell for flows", n,
                        both.front().cell, both.front().face),
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

/// Whitney's (n-2)-forms of the faces of a simplex, at the centroids of its facets: a column each.
class Whitney {
public:
    explicit Whitney(int n) : n_(n), faces_(subsets(n + 1, n - 1)), product_(n, n - 2) {}

    const std::vector<std::vector<int>>& faces() const { return faces_; }

    /// At that of the facet without a corner.
    DenseMatrix at_facet(int omitted, const DenseMatrix& gradients) const {
        DenseMatrix forms = DenseMatrix::Zero(product_.size(), static_cast<Index>(faces_.size()));
        for (std::size_t f = 0; f < faces_.size(); ++f)
            for (int p = 0; p <= n_ - 2; ++p)
                if (faces_[f][p] != omitted)
                    forms.col(static_cast<Index>(f)) += product_.without(p, faces_[f], gradients);
        return std::tgamma(n_ - 1.0) / n_ * forms;
    }

private:
    int n_;
    std::vector<std::vector<int>> faces_;
    ExteriorProduct product_;
};

} // namespace

struct Advection::Parts {
    int n;
    double unit; // of all lengths that follow
    CellComplex complex;
    Vector volumes;            // of n-cells
    std::vector<Index> begins; // of the facets of each n-cell in what follows
    std::vector<SignedFace> facets;
    Points arms;    // from the centroid of the cell to that of the facet
    Points normals; // of the facet, outwards, divided by its area
    Vector areas;   // of the facet
    Vector cones;   // volumes that the centroid of the cell spans with the facet
    std::vector<Pair> pairs;
    SparseMatrix vorticity; // at facets in cells, a row for each pair: z ^ e_i ^ e_j

    explicit Parts(const Discretization& mesh)
        : n(mesh.dimension()),
          unit(mesh.unit()),
          complex(mesh.complex()),
          volumes(mesh.volumes().primal(n)),
          pairs(pairs_of(n)) {
        const Points corners = developed_corners(mesh);
        collect_facets(mesh, corners);
        collect_vorticity(mesh, corners);
    }

    Index cells() const { return static_cast<Index>(volumes.size()); }

    /// Vorticities at facets, and fluxes, in the unit. Throw InvalidInput for another number.
    Vector at_facets(const Vector& z) const {
        check_values("values of the vorticity", z, vorticity.cols());
        return vorticity * form_in_input_units(z, unit, 2 - n, "vorticities");
    }
    Vector fluxes(const Vector& w) const {
        check_values("fluxes", w, complex.size(n - 1));
        return form_in_input_units(w, unit, -n, "fluxes");
    }

    Eigen::RowVectorXd velocity(Index cell, const Vector& w) const {
        Eigen::RowVectorXd u = Eigen::RowVectorXd::Zero(n);
        for (Index i = begins[cell]; i < begins[cell + 1]; ++i)
            u += facets[i].sign * w[facets[i].face] * arms.row(i);
        return u / volumes[cell];
    }

    /// Velocities in the cones of the facets of a cell, a row each.
    void velocities(Index cell, const Vector& w, Points& u) const {
        const Index first = begins[cell], count = begins[cell + 1] - first;
        const Eigen::RowVectorXd mean = velocity(cell, w);
        u.resize(count, n);
        Eigen::RowVectorXd excess = Eigen::RowVectorXd::Zero(n);
        for (Index i = 0; i < count; ++i) {
            const auto& [facet, sign] = facets[first + i];
            const auto normal = normals.row(first + i);
            u.row(i) = (sign * w[facet] / areas[first + i] - normal.dot(mean)) * normal;
            excess += cones[first + i] / volumes[cell] * u.row(i);
        }
        u.rowwise() += mean - excess;
    }

    /// Adds what forces on these velocities, already times the volumes of cones, are on fluxes:
    /// the transpose of the above.
    void add_forces(Index cell, const Points& forces, Vector& result) const {
        const Index first = begins[cell], count = begins[cell + 1] - first;
        const Eigen::RowVectorXd sum = forces.colwise().sum();
        Eigen::RowVectorXd on_mean = sum;
        Vector along(count);
        for (Index i = 0; i < count; ++i) {
            const auto normal = normals.row(first + i);
            along[i] = normal.dot(forces.row(i) - cones[first + i] / volumes[cell] * sum);
            on_mean -= along[i] * normal;
        }
        for (Index i = 0; i < count; ++i) {
            const auto& [facet, sign] = facets[first + i];
            result[facet] += sign * (arms.row(first + i).dot(on_mean) / volumes[cell] +
                                     along[i] / areas[first + i]);
        }
    }

    /// Of velocities in cones makes forces: z ^ u ^ v = v . force, times the volumes of cones.
    void turn(Index cell, const Vector& z, Points& u) const {
        Eigen::RowVectorXd force(n);
        for (Index i = 0; i < u.rows(); ++i) {
            const Index place = begins[cell] + i;
            force.setZero();
            for (std::size_t p = 0; p < pairs.size(); ++p) {
                const auto& pair = pairs[p];
                const double value =
                    z[place * static_cast<Index>(pairs.size()) + static_cast<Index>(p)];
                force[pair.j] += value * u(i, pair.i);
                force[pair.i] -= value * u(i, pair.j);
            }
            u.row(i) = cones[place] * force;
        }
    }

    /// Where a facet stands among those of a cell.
    Index place_of(Index cell, Index facet) const {
        const auto own = std::span(facets).subspan(begins[cell], begins[cell + 1] - begins[cell]);
        const auto found = std::lower_bound(
            own.begin(), own.end(), facet, [](const SignedFace& a, Index b) { return a.face < b; });
        return begins[cell] + static_cast<Index>(found - own.begin());
    }

private:
    void collect_facets(const Discretization& mesh, const Points& corners);
    void collect_vorticity(const Discretization& mesh, const Points& corners);
};

namespace {

/// Gradients of barycentric coordinates, of corners in R^n: n + 1 rows.
DenseMatrix gradients_of(const DenseMatrix& corners) {
    const auto n = corners.cols();
    const DenseMatrix edges = corners.bottomRows(n).rowwise() - corners.row(0);
    DenseMatrix gradients(n + 1, n);
    gradients.bottomRows(n) = edges.inverse().transpose();
    gradients.row(0) = -gradients.bottomRows(n).colwise().sum();
    return gradients;
}

/// The coordinates of the corners of a piece.
auto corners_of(const Points& corners, Index t) {
    const auto count = corners.cols() + 1;
    return corners.middleRows(t * count, count);
}

} // namespace

/// Sums over the pieces of cells and of facets.
void Advection::Parts::collect_facets(const Discretization& mesh, const Points& corners) {
    begins.push_back(0);
    for (Index cell = 0; cell < cells(); ++cell) {
        for (const auto& facet : complex.incidences(n - 1)[cell])
            facets.push_back(facet);
        begins.push_back(static_cast<Index>(facets.size()));
    }
    const auto count = static_cast<Index>(facets.size());
    arms = normals = Points::Zero(count, n);
    areas = cones = Vector::Zero(count);
    const auto& merging = mesh.merging();
    const Vector& sizes = mesh.geometry().volumes().primal(n);
    const Vector &small = mesh.geometry().volumes().primal(n - 1),
                 &whole = mesh.volumes().primal(n - 1);
    for (Index cell = 0; cell < cells(); ++cell) {
        Eigen::RowVectorXd centroid = Eigen::RowVectorXd::Zero(n);
        for (IncidenceMatrix::InnerIterator piece(merging.diamond(n), cell); piece; ++piece) {
            const auto t = static_cast<Index>(piece.col());
            const auto places = corners_of(corners, t);
            centroid += sizes[t] / volumes[cell] * places.colwise().mean();
            for (int i = 0; i <= n; ++i) {
                const Index side = mesh.pieces().face(n, t, i);
                if (const auto& [dimension, facet] = merging.carriers(n - 1)[side]; dimension < n)
                    arms.row(place_of(cell, facet)) +=
                        small[side] / whole[facet] * (places.colwise().sum() - places.row(i)) / n;
            }
        }
        arms.middleRows(begins[cell], begins[cell + 1] - begins[cell]).rowwise() -= centroid;
    }
}

/// Normals of facets, cones, and the vorticity at facets, from pieces that are not flat.
void Advection::Parts::collect_vorticity(const Discretization& mesh, const Points& corners) {
    const auto& K = mesh.pieces();
    const auto& merging = mesh.merging();
    const Vector& sizes = mesh.geometry().volumes().primal(n);
    const Vector &small = mesh.geometry().volumes().primal(n - 1),
                 &whole = mesh.volumes().primal(n - 1);
    const Whitney whitney(n);
    std::vector<Eigen::Triplet<double, Index>> entries;
    const auto width = static_cast<Index>(pairs.size());
    for (Index cell = 0; cell < cells(); ++cell)
        for (IncidenceMatrix::InnerIterator piece(merging.diamond(n), cell); piece; ++piece) {
            const auto t = static_cast<Index>(piece.col());
            if (mesh.geometry().is_flat(t))
                continue;
            const DenseMatrix places = corners_of(corners, t);
            const DenseMatrix gradients = gradients_of(places);
            const double side = piece.value() * K.orientation(t) *
                                (gradients.bottomRows(n).determinant() > 0 ? 1 : -1);
            for (int i = 0; i <= n; ++i) {
                const Index face = K.face(n, t, i);
                const auto& [dimension, facet] = merging.carriers(n - 1)[face];
                if (dimension == n)
                    continue;
                const Index place = place_of(cell, facet);
                normals.row(place) -= n * sizes[t] / whole[facet] * gradients.row(i);
                const DenseMatrix forms = whitney.at_facet(i, gradients);
                const double share = side * small[face] / whole[facet];
                for (std::size_t f = 0; f < whitney.faces().size(); ++f)
                    for (Index p = 0; p < width; ++p)
                        entries.emplace_back(
                            place * width + p, face_at(K, n, t, whitney.faces()[f]),
                            share * pairs[p].sign *
                                forms(pairs[p].coefficient, static_cast<Index>(f)));
            }
        }
    for (Index i = 0; i < areas.size(); ++i) {
        areas[i] = whole[facets[i].face];
        cones[i] = areas[i] * normals.row(i).dot(arms.row(i)) / n;
    }
    SparseMatrix on_pieces(areas.size() * width, K.size(n - 2));
    on_pieces.setFromTriplets(entries.begin(), entries.end());
    vorticity = on_pieces * mesh.merged().lift()[n - 2];
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
    const Vector at_facets = parts.at_facets(z), flux = parts.fluxes(w);
    Vector force = Vector::Zero(w.size());
    Points u;
    for (Index cell = 0; cell < parts.cells(); ++cell) {
        parts.velocities(cell, flux, u);
        parts.turn(cell, at_facets, u);
        parts.add_forces(cell, u, force);
    }
    return form_in_input_units(force, parts.unit, 2, "forces");
}

SparseMatrix Advection::matrix(const Vector& z) const {
    const Parts& parts = *parts_;
    const Vector at_facets = parts.at_facets(z);
    std::vector<Eigen::Triplet<double, Index>> entries;
    Vector unit = Vector::Zero(parts.complex.size(parts.n - 1)), force = unit;
    Points u;
    for (Index cell = 0; cell < parts.cells(); ++cell)
        for (Index j = parts.begins[cell]; j < parts.begins[cell + 1]; ++j) {
            const Index column = parts.facets[j].face;
            unit[column] = 1;
            parts.velocities(cell, unit, u);
            parts.turn(cell, at_facets, u);
            parts.add_forces(cell, u, force);
            unit[column] = 0;
            for (Index i = parts.begins[cell]; i < parts.begins[cell + 1]; ++i) {
                const Index row = parts.facets[i].face;
                entries.emplace_back(row, column, force[row]);
                force[row] = 0;
            }
        }
    SparseMatrix result(unit.size(), unit.size());
    result.setFromTriplets(entries.begin(), entries.end());
    return in_input_units(std::move(result), parts.unit, 2 - parts.n, "the matrix of advection");
}

Vector Advection::kinetic_energy(const Vector& w) const {
    const Vector flux = parts_->fluxes(w);
    Vector result(parts_->cells());
    for (Index cell = 0; cell < parts_->cells(); ++cell)
        result[cell] = parts_->velocity(cell, flux).squaredNorm() / 2;
    return form_in_input_units(result, parts_->unit, 2, "kinetic energies");
}

double Advection::exchange_rate(const Vector& w) const {
    const Parts& parts = *parts_;
    const Vector flux = parts.fluxes(w);
    double most = 0;
    for (Index cell = 0; cell < parts.cells(); ++cell) {
        double sum = 0;
        for (Index i = parts.begins[cell]; i < parts.begins[cell + 1]; ++i)
            sum += std::abs(flux[parts.facets[i].face]);
        most = std::max(most, sum / 2 / parts.volumes[cell]);
    }
    return most;
}

} // namespace polydec
