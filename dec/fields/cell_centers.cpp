// SPDX-License-Identifier: MIT
#include "dec/fields/cell_centers.h"

#include "base/decompositions.h"
#include "dec/discretization/glued_box.h"
#include "dec/fields/developed_cells.h"
#include "dec/forms/cochain.h"
#include "dec/metric/simplex_faces.h"
#include "dec/surfaces/places.h"

namespace polydec {

namespace {

/// Places in the cells of a glued mesh. An n-cell is laid flat, and a place in it is expressed by
/// the corners of one of its pieces, at this piece's position in the box. So means over cells
/// across a seam are in one place.
class PlacesInBox {
public:
    PlacesInBox(const Discretization& mesh, int k)
        : mesh_(mesh),
          n_(mesh.dimension()),
          k_(k),
          corners_(developed_corners(mesh)),
          faces_(mesh.pieces(), n_, k),
          seen_(static_cast<std::size_t>(mesh.pieces().size(k)), false),
          sums_(static_cast<std::size_t>(mesh.complex().size(k))) {}

    /// Mean by volume of a place in each k-piece.
    Points means(const Points& coordinates) {
        Points result(std::ssize(sums_), mesh_.ambient_dimension());
        for (Index cell = 0; cell < mesh_.complex().size(n_); ++cell) {
            std::vector<Index> begun;
            for (const Index t : mesh_.merging().pieces_of(n_, cell))
                add(cell, t, coordinates, begun);
            for (const Index c : begun)
                result.row(c) = in_space(sums_[c]);
        }
        return result;
    }

private:
    /// Sum over places in the first n-cell, laid flat, that contains the k-cell.
    struct Sum {
        Index cell = -1, anchor = -1; ///< and its piece whose corners express places
        Vector places = {};
        double volume = 0;
    };

    void add(Index cell, Index t, const Points& coordinates, std::vector<Index>& begun) {
        const auto& list = faces_.of(t);
        for (std::size_t f = 0; f < list.size(); ++f) {
            const Index s = list[f];
            const auto& [dimension, c] = mesh_.merging().carriers(k_)[s];
            if (dimension != k_ || seen_[s])
                continue;
            Sum& sum = sums_[c];
            if (sum.cell < 0) {
                sum = {cell, t, Vector::Zero(n_)};
                begun.push_back(c);
            }
            if (sum.cell != cell)
                continue;
            seen_[s] = true;
            const double volume = mesh_.geometry().volumes().primal(k_)[s];
            sum.volume += volume;
            const auto& positions = faces_.positions()[f];
            for (std::size_t i = 0; i < positions.size(); ++i)
                sum.places += volume * coordinates(s, static_cast<Index>(i)) *
                              corners_.row(row(t) + positions[i]).transpose();
        }
    }

    Eigen::RowVectorXd in_space(const Sum& sum) const {
        DenseMatrix system = DenseMatrix::Ones(n_ + 1, n_ + 1);
        system.topRows(n_) = corners_.middleRows(row(sum.anchor), n_ + 1).transpose();
        Vector right_side = Vector::Ones(n_ + 1);
        right_side.head(n_) = sum.places / sum.volume;
        const Vector weights = system.fullPivLu().solve(right_side);
        const auto [points, corners] = mesh_.places();
        Eigen::RowVectorXd place = Eigen::RowVectorXd::Zero(points.cols());
        for (int i = 0; i <= n_; ++i)
            place += weights[i] * points.row(corners(sum.anchor, i));
        return place;
    }

    Eigen::Index row(Index t) const { return Eigen::Index{t} * (n_ + 1); }

    const Discretization& mesh_;
    int n_, k_;
    Points corners_; // n + 1 rows for each n-piece
    SimplexFaces faces_;
    std::vector<bool> seen_; // k-pieces
    std::vector<Sum> sums_;  // per k-cell
};

/// Mean by volume over each k-cell of a place in each k-piece.
Points mean_over_cells(const Discretization& mesh, int k, const Points& coordinates) {
    if (mesh.box())
        return k == 0 ? mesh.box()->vertices() : PlacesInBox(mesh, k).means(coordinates);
    const Points places =
        Places(mesh.passage(), mesh.measured_points()).at(k, coordinates, mesh.measured_points());
    const Vector& volumes = mesh.geometry().volumes().primal(k);
    Points result = Points::Zero(mesh.complex().size(k), places.cols());
    for (Index cell = 0; cell < result.rows(); ++cell) {
        double volume = 0;
        for (const Index piece : mesh.merging().pieces_of(k, cell)) {
            result.row(cell) += volumes[piece] * places.row(piece);
            volume += volumes[piece];
        }
        result.row(cell) *= 1 / volume;
    }
    return result;
}

/// False if only lengths are known.
bool has_places(const Discretization& mesh) {
    return mesh.ambient_dimension() > 0;
}

/// Whether a star has an entry between two facets of a cell.
bool couples_facets_of(const SparseMatrix& M, const IncidenceRow& faces) {
    for (const SignedFace& f : faces)
        for (const SignedFace& g : faces)
            if (f.face != g.face && M.coeff(f.face, g.face) != 0)
                return true;
    return false;
}

/// Barycentric coordinates of the sites of the n-pieces, n + 1 in a row.
Points site_coordinates(const Discretization& discretization) {
    const int n = discretization.dimension();
    Points result = center_coordinates(discretization.pieces(), discretization.geometry().metric(),
                                       discretization.geometry().centers(), n);
    if (n == 0 || discretization.stars()[n - 1].is_diagonal())
        return result;
    const SparseMatrix M = discretization.stars()[n - 1].matrix();
    const Incidences& faces = discretization.complex().incidences(n - 1);
    for (Index cell = 0; cell < faces.rows(); ++cell)
        if (couples_facets_of(M, faces[cell]))
            for (const Index piece : discretization.merging().pieces_of(n, cell))
                result.row(piece).setConstant(1.0 / (n + 1));
    return result;
}

} // namespace

Points cell_centers(const Discretization& discretization, int k) {
    cell_degree(discretization.complex(), Side::primal, k);
    if (!has_places(discretization))
        return Points(discretization.complex().size(k), 0);
    return discretization.unit() *
           mean_over_cells(discretization, k,
                           center_coordinates(discretization.pieces(),
                                              discretization.geometry().metric(),
                                              discretization.geometry().centers(), k));
}

Points cell_centroids(const Discretization& discretization, int k) {
    require_points(discretization.ambient_dimension(), "a cell's centroid");
    cell_degree(discretization.pieces(), Side::primal, k);
    const Index count = discretization.pieces().size(k);
    return discretization.unit() *
           mean_over_cells(discretization, k, Points::Constant(count, k + 1, 1.0 / (k + 1)));
}

Points sites_of_pieces(const Discretization& discretization) {
    const int n = discretization.dimension();
    const Points coordinates = site_coordinates(discretization);
    if (!discretization.box())
        return Places(discretization.passage(), discretization.measured_points())
            .at(n, coordinates, discretization.measured_points());
    const auto [points, corners] = discretization.places();
    Points result = Points::Zero(coordinates.rows(), points.cols());
    for (Index t = 0; t < result.rows(); ++t)
        for (int i = 0; i <= n; ++i)
            result.row(t) += coordinates(t, i) * points.row(corners(t, i));
    return result;
}

Points dual_sites(const Discretization& discretization) {
    const int n = discretization.dimension();
    if (!has_places(discretization))
        return cell_centers(discretization, n);
    return discretization.unit() *
           mean_over_cells(discretization, n, site_coordinates(discretization));
}

Points facet_sites(const Discretization& discretization) {
    const int n = discretization.dimension();
    return discretization.stars()[n - 1].is_diagonal() || !has_places(discretization)
               ? cell_centers(discretization, n - 1)
               : cell_centroids(discretization, n - 1);
}

Points sites(const Discretization& discretization, Side side) {
    return side == Side::primal ? cell_centers(discretization, 0) : dual_sites(discretization);
}

Points boundary_sites(const Discretization& discretization, Side side) {
    return side == Side::primal ? cell_centers(discretization, 0) : facet_sites(discretization);
}

} // namespace polydec
