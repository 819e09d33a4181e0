// SPDX-License-Identifier: MIT
#include "dec/stars/choose_stars.h"

#include "base/block_matrix.h"
#include "base/errors.h"
#include "complex/surfaces/glued_surface.h"
#include "dec/merging/merged_cells.h"
#include "dec/metric/geometry.h"
#include "dec/stars/galerkin_mass.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace polydec {

namespace {

using Marks = std::vector<bool>;
using Entry = SparseMatrix::InnerIterator;

CellVolumes barycentric_volumes(const MergedCells& cells) {
    const Geometry& pieces = cells.geometry();
    return merged_volumes(cells.merging(),
                          dual_volumes(pieces.pieces(), pieces.metric(), Centers::centroids(),
                                       FlatSimplices::passed_over));
}

/// The cells of a surface that get Galerkin's stars: cells beside an edge without positive dual,
/// and all cells with a negative part of the dual of an edge of a bad cell. So every edge between
/// good cells has a positive star. On every other edge, good cells add nothing negative beyond
/// rounding to a definite matrix. Vertices whose dual is not positive make the cells around them
/// bad.
class BadCells {
public:
    explicit BadCells(const MergedCells& cells)
        : cells_(cells), bad_(static_cast<std::size_t>(cells.complex().size(2)), false) {
        for (const int k : {0, 1}) {
            parts_[k] = cells.parts(k, cells.geometry().centers());
            cofaces_[k] = parts_[k].transpose();
            rounding_[k] =
                cells.volumes().rounding(k).vector().cwiseProduct(cells.volumes().primal(k));
        }
        thirds_ = cells.parts(0, Centers::centroids());
        const HodgeStar edges = star(cells.volumes(), 1);
        for (const auto& list : {edges.zeros(), edges.negatives()})
            for (const Index e : list)
                add_cells_at(1, e);
        do
            spread();
        while (add_cells_at_vertices());
    }

    const Marks& marks() const { return bad_; }

    /// |*E| from good cells only, over |E|.
    Vector edge_star() const {
        const Vector& lengths = cells_.volumes().primal(1);
        const SparseMatrix none(parts_[1].rows(), parts_[1].cols());
        return sums(parts_[1], none).cwiseQuotient(lengths).cwiseQuotient(lengths);
    }

    /// For vertices: circumcentric in good cells, a third of each triangle in bad cells.
    Vector vertex_duals() const { return sums(parts_[0], thirds_); }

private:
    Vector sums(const SparseMatrix& of_good, const SparseMatrix& of_bad) const {
        Vector result = Vector::Zero(of_good.cols());
        for (Index t = 0; t < of_good.rows(); ++t)
            for (Entry part(bad_[t] ? of_bad : of_good, t); part; ++part)
                result[part.col()] += part.value();
        return result;
    }

    bool add(Index t) {
        const bool is_new = !bad_[t];
        bad_[t] = true;
        if (is_new)
            latest_.push_back(t);
        return is_new;
    }

    bool add_cells_at(int k, Index face) {
        bool any = false;
        for (Entry cell(cofaces_[k], face); cell; ++cell)
            any = add(static_cast<Index>(cell.col())) || any;
        return any;
    }

    /// Spreads from each bad cell across the edges with a negative part in it.
    void spread() {
        while (!latest_.empty()) {
            const Index t = latest_.back();
            latest_.pop_back();
            for (Entry edge(parts_[1], t); edge; ++edge)
                for (Entry cell(cofaces_[1], edge.col()); cell; ++cell)
                    if (cell.value() < -rounding_[1][edge.col()])
                        add(static_cast<Index>(cell.col()));
        }
    }

    bool add_cells_at_vertices() {
        bool any = false;
        const Vector duals = vertex_duals();
        for (Index v = 0; v < duals.size(); ++v)
            if (!(duals[v] > rounding_[0][v]))
                any = add_cells_at(0, v) || any;
        return any;
    }

    const MergedCells& cells_;
    Marks bad_;
    std::vector<Index> latest_; // bad cells whose neighbors have not been visited
    std::array<SparseMatrix, 2> parts_, cofaces_;
    SparseMatrix thirds_;
    std::array<Vector, 2> rounding_; // of |E||*E|
};

ChosenStars hybrid(const MergedCells& cells) {
    if (cells.dimension() != GluedSurface::dimension)
        throw InvalidInput(fmt::format("hybrid stars do not exist in dimension {}, only in "
                                       "dimension {}: use galerkin or automatic stars",
                                       cells.dimension(), GluedSurface::dimension));
    const BadCells bad(cells);
    if (std::find(bad.marks().begin(), bad.marks().end(), true) == bad.marks().end())
        return ChosenStars(cells.volumes(), StarKind::circumcentric);
    Vector weights(std::ssize(bad.marks()));
    std::copy(bad.marks().begin(), bad.marks().end(), weights.begin());
    const HodgeStars stars = cells.volumes().with_dual(0, bad.vertex_duals());
    return {stars.with(1, diagonal_matrix(bad.edge_star()) + GalerkinMass(cells)(1, weights)),
            StarKind::hybrid, bad.marks()};
}

ChosenStars galerkin(const MergedCells& cells, int lowest) {
    const Index size = cells.complex().size(cells.dimension());
    HodgeStars stars = lowest > 0 ? cells.volumes().with_dual(0, barycentric_volumes(cells).dual(0))
                                  : cells.volumes();
    const GalerkinMass mass(cells);
    for (int k = lowest; k < cells.dimension(); ++k)
        stars = stars.with(k, mass(k, Vector::Ones(size)));
    return {stars, StarKind::galerkin, Marks(size, true)};
}

} // namespace

ChosenStars choose_stars(const MergedCells& cells, StarKind kind) {
    switch (kind) {
    case StarKind::circumcentric:
        return ChosenStars(cells.volumes(), kind);
    case StarKind::galerkin:
        return galerkin(cells, 0);
    case StarKind::hybrid:
        return hybrid(cells);
    case StarKind::barycentric:
        return ChosenStars(barycentric_volumes(cells), kind);
    case StarKind::automatic:
        kind = automatic_kind(cells.dimension(), all_positive(cells.volumes()));
        return kind == StarKind::galerkin ? galerkin(cells, 1) : choose_stars(cells, kind);
    case StarKind::own:
        break;
    }
    throw InvalidInput("choose_stars cannot make stars of the kind own: pass your stars to "
                       "Discretization::with_stars");
}

} // namespace polydec
