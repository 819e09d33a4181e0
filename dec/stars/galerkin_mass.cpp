// SPDX-License-Identifier: MIT
#include "dec/stars/galerkin_mass.h"

#include "base/errors.h"
#include "base/lists.h"
#include "complex/simplicial_complex.h"
#include "dec/metric/simplex_geometry.h"
#include "dec/metric/whitney.h"
#include "system/memory.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace polydec {

namespace {

/// The new pieces, and their cells.
class Cones {
public:
    explicit Cones(const MergedCells& cells)
        : cells_(cells),
          merging_(cells.merging()),
          n_(cells.dimension()),
          center_of_(cells.complex().size(n_), -1) {
        find_centers(*old_metric().points(), cells.geometry().flat());
        pieces_ = std::make_unique<SimplicialComplex>(top_simplices());
        for (int k = 0; k <= n_; ++k)
            find_carriers(k);
        require_seen();
    }

    MergedCells cells() && {
        return {Merging(*pieces_, merging_.merged(), std::move(carriers_), std::move(diamonds_)),
                Geometry(*pieces_,
                         {std::make_shared<const Points>(std::move(points_)), old_metric().error()},
                         Centers::centroids()),
                cells_.volumes()};
    }

private:
    const Pieces& old() const { return merging_.pieces(); }
    const SimplexMetric& old_metric() const { return cells_.geometry().metric(); }

    void find_centers(const Points& points, const std::vector<bool>& flat) {
        for (std::size_t t = 0; t < flat.size(); ++t)
            if (flat[t])
                center_of_[merging_.carriers(n_)[t].cell] = 0;
        Index next = old().size(0);
        for (Index& center : center_of_)
            if (center == 0)
                center = next++;
        points_.resize(next, points.cols());
        points_.topRows(points.rows()) = points;
        for (Index cell = 0; cell < std::ssize(center_of_); ++cell)
            if (const Index center = center_of_[cell]; center >= 0) {
                const auto corners = merging_.vertices(n_, cell);
                cell_of_center_.push_back(cell);
                points_.row(center) = points(corners, Eigen::indexing::all).colwise().mean();
            }
    }

    Simplices top_simplices() const {
        std::vector<Index> corners; // of one after the other
        const auto add = [&](std::span<const Index> more) {
            corners.insert(corners.end(), more.begin(), more.end());
        };
        for (Index cell = 0; cell < std::ssize(center_of_); ++cell) {
            if (center_of_[cell] < 0) {
                for (const Index t : merging_.pieces_of(n_, cell))
                    add(vertices(old().simplices(n_), t));
                continue;
            }
            for (const SignedFace& facet : merging_.merged().incidences(n_ - 1)[cell])
                for (const Index f : merging_.pieces_of(n_ - 1, facet.face)) {
                    add(vertices(old().simplices(n_ - 1), f));
                    corners.push_back(center_of_[cell]);
                }
        }
        return Eigen::Map<const Simplices>(corners.data(), std::ssize(corners) / (n_ + 1), n_ + 1);
    }

    /// The old numbers of the new k-simplices; -1 if a center is the last corner.
    std::vector<Index> old_numbers(int k) const {
        const Simplices &simplices = pieces_->simplices(k), &before = old().simplices(k);
        std::vector<Index> result(simplices.rows(), -1);
        Index s = 0; // both are in lexicographic order
        for (Index t = 0; t < simplices.rows(); ++t)
            if (simplices(t, k) < old().size(0)) {
                while (!std::ranges::equal(vertices(before, s), vertices(simplices, t)))
                    ++s;
                result[t] = s;
            }
        return result;
    }

    void find_carriers(int k) {
        const auto numbers = old_numbers(k);
        auto& carriers = carriers_.emplace_back();
        std::vector<Eigen::Triplet<IncidenceMatrix::Scalar, Index>> signs;
        for (Index t = 0; t < std::ssize(numbers); ++t) {
            if (const Index s = numbers[t]; s >= 0)
                carriers.push_back(merging_.carriers(k)[s]);
            else
                carriers.push_back(
                    {n_, cell_of_center_[pieces_->simplices(k)(t, k) - old().size(0)]});
            const auto [dimension, cell] = carriers.back();
            if (dimension == k)
                signs.emplace_back(cell, t,
                                   numbers[t] < 0 ? sign_of_cone(cell, t)
                                                  : merging_.diamond(k).coeff(cell, numbers[t]) *
                                                        turned(k, numbers[t], t));
        }
        diamonds_.emplace_back(merging_.merged().size(k), std::ssize(carriers))
            .setFromTriplets(signs.begin(), signs.end());
    }

    int turned(int k, Index before, Index now) const {
        return k < n_ ? 1 : old().orientation(before) * pieces_->orientation(now);
    }

    /// From the facet without the center, the last corner.
    int sign_of_cone(Index cell, Index t) const {
        const Index f = pieces_->face(n_, t, n_), facet = carriers_[n_ - 1][f].cell;
        return merging_.merged().coboundary(n_ - 1).coeff(cell, facet) *
               diamonds_[n_ - 1].coeff(facet, f) * pieces_->sign(n_, t, n_);
    }

    /// Throws unless all determinants agree with the signs of the pieces in a cell.
    void require_seen() const {
        for (Index cell = 0; cell < std::ssize(center_of_); ++cell) {
            if (center_of_[cell] < 0)
                continue;
            double least = std::numeric_limits<double>::infinity(), most = -least;
            for (IncidenceMatrix::InnerIterator t(diamonds_[n_], cell); t; ++t) {
                const auto corners =
                    points_(vertices(pieces_->simplices(n_), static_cast<Index>(t.col())),
                            Eigen::indexing::all);
                const DenseMatrix edges = corners.bottomRows(n_).rowwise() - corners.row(0);
                const double signed_volume = t.value() *
                                             pieces_->orientation(static_cast<Index>(t.col())) *
                                             edges.determinant();
                least = std::min(least, signed_volume);
                most = std::max(most, signed_volume);
            }
            if (least <= 0 && most >= 0)
                throw InvalidInput(
                    fmt::format("{}-cell {} with vertices {} has flat pieces and is not "
                                "star-shaped around the mean of its vertices, so it has no "
                                "Galerkin star: choose another merge tolerance",
                                n_, cell,
                                fmt::join(old().vertex_numbers(merging_.vertices(n_, cell)), ", ")),
                    {.degree = n_, .cells = {cell}});
        }
    }

    const MergedCells& cells_;
    const Merging& merging_;
    int n_;
    std::vector<Index> center_of_, cell_of_center_; // -1: none
    Points points_;
    std::unique_ptr<SimplicialComplex> pieces_;
    std::vector<std::vector<Merging::Carrier>> carriers_;
    std::vector<IncidenceMatrix> diamonds_;
};

/// Replaces the pieces of cells that have flat pieces, on which forms have no bound. The new pieces
/// are cones from the mean of a cell's vertices, a new vertex numbered last, over the pieces of its
/// facets. Facets belong to the cells on both sides, so the new pieces fit together where flat ones
/// would leave a crack, whichever cell took these. Independent of numbering, position and scale.
/// For solids, whose points have as many coordinates as the dimension. Throws InvalidInput, naming
/// the cell, unless the whole cell is visible from that mean.
MergedCells cone_flat_cells(const MergedCells& cells) {
    return Cones(cells).cells();
}

/// Number of pairs of k-cells below a common n-cell with several pieces: the lift to k-simplices
/// inside couples all of them.
double count_pairs(const Merging& merging, int k) {
    const CellComplex& complex = merging.merged();
    const int n = complex.dimension();
    const auto& pieces = merging.diamond(n);
    double pairs = 0;
    std::vector<Index> cells, faces;
    for (Index top = 0; k > 0 && top < complex.size(n); ++top) {
        if (pieces.outerIndexPtr()[top + 1] - pieces.outerIndexPtr()[top] < 2)
            continue;
        cells.assign(1, top);
        for (int j = n - 1; j >= k; --j) {
            faces.clear();
            for (const Index cell : cells)
                for (const SignedFace& face : complex.incidences(j)[cell])
                    faces.push_back(face.face);
            sort_unique(faces);
            cells.swap(faces);
        }
        pairs += std::pow(static_cast<double>(cells.size()), 2);
    }
    return pairs;
}

} // namespace

GalerkinMass::GalerkinMass(const MergedCells& cells)
    : cells_(cells.geometry().flat().empty() ? cells : cone_flat_cells(cells)) {}

SparseMatrix GalerkinMass::operator()(int k, const Vector& weights) const {
    Vector of_pieces(pieces().size(pieces().dimension()));
    for (Index t = 0; t < of_pieces.size(); ++t)
        of_pieces[t] = weights[cell(t)];
    return lifted(k, whitney_mass(pieces(), metric(), pieces().dimension(), k, of_pieces));
}

SparseMatrix GalerkinMass::lifted(int k, const SparseMatrix& of_pieces) const {
    // of the intermediate product, the result, its transpose and their sum
    constexpr double bytes_each = 5 * (sizeof(double) + sizeof(Index));
    const double entries = count_pairs(cells_.merging(), k);
    check_memory(bytes_each * entries,
                 fmt::format("Galerkin's star of {}-forms with {:.3g} entries", k, entries));
    const SparseMatrix& S = cells_.lift()[k];
    const SparseMatrix result = SparseMatrix(S.transpose()) * of_pieces * S;
    return 0.5 *
           (result + SparseMatrix(result.transpose())); // removes rounding across the diagonal
}

} // namespace polydec
