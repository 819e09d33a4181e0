// SPDX-License-Identifier: MIT
#include "dec/fields/developed_cells.h"

#include "base/decompositions.h"
#include "dec/metric/simplex_geometry.h"
#include "dec/metric/subsets.h"

namespace polydec {

namespace {

/// Lays out one cell at a time, from piece to piece across the facets inside it.
class Developing {
public:
    explicit Developing(const Discretization& mesh)
        : mesh_(mesh),
          K_(mesh.pieces()),
          n_(mesh.dimension()),
          metric_(mesh.geometry().metric()),
          layout_(K_, metric_),
          cofaces_(K_, n_),
          placed_(static_cast<std::size_t>(K_.size(n_)), false),
          corners_(Eigen::Index{K_.size(n_)} * (n_ + 1), n_) {}

    Points corners() {
        for (Index t = 0; t < K_.size(n_); ++t)
            if (!placed_[t]) {
                place(t, in_own_plane(layout_.at(n_, t)));
                develop_from(t);
            }
        return std::move(corners_);
    }

private:
    void place(Index t, const DenseMatrix& corners) {
        corners_.middleRows(Eigen::Index{t} * (n_ + 1), n_ + 1) = corners;
        placed_[t] = true;
    }

    void develop_from(Index first) {
        std::vector<Index> open{first};
        while (!open.empty()) {
            const Index t = open.back();
            open.pop_back();
            for (int i = 0; i <= n_; ++i) {
                const Index facet = K_.face(n_, t, i);
                if (mesh_.merging().carriers(n_ - 1)[facet].dimension < n_)
                    continue;
                for (const auto& [other, omitted] : cofaces_.of(facet))
                    if (!placed_[other]) {
                        place_beside(t, i, other, omitted);
                        open.push_back(other);
                    }
            }
        }
    }

    void place_beside(Index t, int i, Index other, int omitted) {
        const DenseMatrix here = corners_.middleRows(Eigen::Index{t} * (n_ + 1), n_ + 1);
        const DenseMatrix own = in_own_plane(layout_.at(n_, other));
        const DenseMatrix facet = here(complement(n_ + 1, {i}), Eigen::indexing::all);
        const DenseMatrix own_facet = own(complement(n_ + 1, {omitted}), Eigen::indexing::all);
        DenseMatrix basis = basis_at(facet, here.row(i));
        basis.row(n_ - 1) *= -1; // on the other side
        const DenseMatrix turn =
            least_squares(basis_at(own_facet, own.row(omitted)), basis).shortest;
        DenseMatrix moved = (own.rowwise() - own_facet.row(0)) * turn;
        moved.rowwise() += facet.row(0);
        place(other, moved);
    }

    const Discretization& mesh_;
    const Pieces& K_;
    int n_;
    SimplexMetric metric_;
    SimplexLayout layout_;
    Cofaces cofaces_;
    std::vector<bool> placed_;
    Points corners_;
};

} // namespace

DenseMatrix basis_at(const DenseMatrix& facet, const Eigen::RowVectorXd& beside) {
    const auto n = facet.rows();
    const DenseMatrix edges = facet.bottomRows(n - 1).rowwise() - facet.row(0);
    Eigen::RowVectorXd normal = beside - facet.row(0);
    if (n > 1)
        normal -= least_squares(edges.transpose(), normal.transpose()).shortest.transpose() * edges;
    const double length = normal.norm();
    DenseMatrix basis(n, facet.cols());
    basis.topRows(n - 1) = edges;
    basis.row(n - 1) = length > 0 ? Eigen::RowVectorXd(normal / length) : 0 * normal;
    return basis;
}

DenseMatrix in_own_plane(const Corners& corners) {
    const auto n = static_cast<Index>(corners.vertices.size()) - 1;
    const Points rows = corners.points(corners.vertices, Eigen::indexing::all);
    const DenseMatrix edges = rows.bottomRows(n).rowwise() - rows.row(0);
    DenseMatrix result = DenseMatrix::Zero(n + 1, n);
    result.bottomRows(n) = triangular_factor(edges.transpose()).transpose();
    return result;
}

Points developed_corners(const Discretization& mesh) {
    const int n = mesh.dimension();
    if (mesh.measured_points().cols() != n || !mesh.passage().is_identity())
        return Developing(mesh).corners();
    const auto& tops = mesh.pieces().simplices(n);
    Points corners(Eigen::Index{tops.rows()} * (n + 1), n);
    for (Index t = 0; t < tops.rows(); ++t)
        corners.middleRows(Eigen::Index{t} * (n + 1), n + 1) =
            mesh.measured_points()(vertices(tops, t), Eigen::indexing::all);
    return corners;
}

} // namespace polydec
