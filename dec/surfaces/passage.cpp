// SPDX-License-Identifier: MIT
#include "dec/surfaces/passage.h"

#include "base/block_matrix.h"
#include "base/checks.h"
#include "base/errors.h"
#include "complex/surfaces/ordered_surface.h"
#include "dec/surfaces/intrinsic_delaunay.h"

#include <fmt/format.h>

#include <numeric>
#include <utility>
#include <vector>

namespace polydec {

namespace {

/// Vertices added by splits are numbered after the input's points.
OrderedSurface ordered(const SimplicialComplex& input, const GluedSurface& surface,
                       Index first_new_vertex) {
    std::vector<Index> names(static_cast<std::size_t>(surface.vertices()));
    std::iota(names.begin(), names.end(), first_new_vertex - input.size(0));
    for (Index v = 0; v < input.size(0); ++v)
        names[v] = input.vertex_number(v);
    return in_order(surface, std::move(names));
}

} // namespace

struct Passage::Flipped {
    IntrinsicDelaunay flips;
    Vector directions; // of the edges, none for the identity
};

Passage::Passage(SimplicialComplex input) : input_(input), pieces_(input) {}

Passage::Passage(SimplicialComplex input, IntrinsicDelaunay flips, Index first_new_vertex)
    : Passage(std::move(input)) {
    const auto& done = flips.statistics;
    Vector directions;
    if (done.flips > 0 || done.splits > 0 || done.added_length > 0) {
        OrderedSurface surface = ordered(input_, flips.surface, first_new_vertex);
        pieces_ = surface.pieces;
        directions = std::move(surface.directions);
    }
    flipped_ = std::make_shared<const Flipped>(Flipped{std::move(flips), std::move(directions)});
}

bool Passage::is_identity() const {
    return !flipped_ || flipped_->directions.size() == 0;
}

const IntrinsicDelaunay& Passage::flips(std::string_view what) const& {
    if (!flipped_)
        throw InvalidInput(
            fmt::format("{}: no edges were flipped; set DiscretizeOptions::delaunay", what));
    return flipped_->flips;
}

IntrinsicDelaunay Passage::flips(std::string_view what) && {
    return flips(what);
}

Vector Passage::turned(int k, Vector values) const {
    return k == 1 ? Vector(flipped_->directions.cwiseProduct(values)) : values;
}

namespace {

void check_values(const Pieces& cells, int k, Eigen::Index given) {
    check_number("a cochain of degree", k, 0, cells.dimension());
    check_as_many(fmt::format("values on {}-cells", k), given, cells.size(k));
}

} // namespace

DenseMatrix Passage::forth(int k, const DenseMatrix& values) const {
    check_values(input_, k, values.rows());
    if (is_identity())
        return values;
    DenseMatrix result(pieces_.size(k), values.cols());
    for (Eigen::Index c = 0; c < values.cols(); ++c)
        result.col(c) = turned(k, flipped_->flips.history.carry(k, values.col(c)));
    return result;
}

DenseMatrix Passage::back(int k, const DenseMatrix& values) const {
    check_values(pieces_, k, values.rows());
    if (is_identity())
        return values;
    DenseMatrix result(input_.size(k), values.cols());
    for (Eigen::Index c = 0; c < values.cols(); ++c)
        result.col(c) = flipped_->flips.history.carry_back(k, turned(k, values.col(c)));
    return result;
}

SparseMatrix Passage::matrix(int k) const {
    check_number("the passage of cochains of degree", k, 0, pieces_.dimension());
    if (!is_identity())
        return turned(k, Vector::Ones(pieces_.size(k))).asDiagonal() *
               flipped_->flips.history.matrix(k);
    return diagonal_matrix(Vector::Ones(input_.size(k)));
}

SparseMatrix Passage::matrix_back(int k) const {
    check_number("the passage of cochains of degree", k, 0, pieces_.dimension());
    if (!is_identity())
        return flipped_->flips.history.matrix_back(k) *
               turned(k, Vector::Ones(pieces_.size(k))).asDiagonal();
    return matrix(k);
}

} // namespace polydec
