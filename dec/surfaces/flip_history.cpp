// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "dec/surfaces/intrinsic_delaunay.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

namespace polydec {

namespace {

using SignedEdge = GluedSurface::SignedEdge;

struct Term {
    double weight;
    Index cell;
};

Term signed_term(double weight, SignedEdge side) {
    return {weight * side.sign, side.edge};
}

/// A linear combination of values, which are numbers or rows of a matrix.
double combine(const std::vector<double>& values, std::span<const Term> terms) {
    double sum = 0;
    for (const auto& [weight, cell] : terms)
        sum += weight * values[cell];
    return sum;
}

using SparseRow = std::vector<std::pair<Index, double>>; // ascending columns

SparseRow combine(const std::vector<SparseRow>& rows, std::span<const Term> terms) {
    SparseRow all;
    for (const auto& [weight, cell] : terms)
        if (weight != 0)
            for (const auto& [column, value] : rows[cell])
                all.emplace_back(column, weight * value);
    std::sort(all.begin(), all.end());
    std::size_t kept = 0;
    for (std::size_t i = 0, j = 0; i < all.size(); i = j) {
        std::pair<Index, double> sum{all[i].first, 0.0};
        for (; j < all.size() && all[j].first == sum.first; ++j)
            sum.second += all[j].second;
        if (sum.second != 0)
            all[kept++] = sum;
    }
    all.resize(kept);
    return all;
}

template <class Value>
void turn(std::vector<Value>& values, Index triangle) {
    const Term turned{-1, triangle};
    values[triangle] = combine(values, {&turned, 1});
}

template <class Value>
void share(std::vector<Value>& values, Index first, Index second, double part) {
    const Term both[] = {{1, first}, {1, second}}, rest{1 - part, first};
    values[first] = combine(values, both);
    values[second] = combine(values, {&rest, 1});
    const Term own{part, first};
    values[first] = combine(values, {&own, 1});
}

} // namespace

FlipHistory::FlipHistory(const GluedSurface& surface)
    : first_sizes_{surface.vertices(), surface.edges(), surface.triangles()},
      last_sizes_(first_sizes_) {}

void FlipHistory::flip(const GluedSurface& surface, Index edge, double share_before,
                       double share_after) {
    const auto [h, g] = surface.halfedges(edge);
    steps_.push_back({Kind::flip,
                      surface[h].sign,
                      edge,
                      GluedSurface::triangle(h),
                      GluedSurface::triangle(g),
                      {surface[GluedSurface::next(h)], surface[GluedSurface::previous(h)],
                       surface[GluedSurface::next(g)], surface[GluedSurface::previous(g)]},
                      {},
                      share_before,
                      share_after});
}

void FlipHistory::split_boundary(const GluedSurface& surface, Index edge, double fraction) {
    const Index h = surface.halfedges(edge)[0];
    const Index h1 = GluedSurface::next(h), h2 = GluedSurface::previous(h);
    steps_.push_back({Kind::split,
                      surface[h].sign,
                      edge,
                      GluedSurface::triangle(h),
                      surface.triangles(),
                      {surface[h1], surface[h2], SignedEdge{surface.edges(), 1},
                       SignedEdge{surface.edges() + 1, 1}},
                      {surface.tail(h), surface.tail(h1), surface.vertices()},
                      fraction,
                      fraction});
    last_sizes_[0] += 1;
    last_sizes_[1] += 2;
    last_sizes_[2] += 1;
}

void FlipHistory::reverse(Index triangle) {
    steps_.push_back({Kind::reverse, 1, -1, triangle, -1, {}, {}, 0, 0});
}

template <class Values>
void FlipHistory::take(const Step& step, bool back, int k, Values& values) const {
    const double part = back ? step.before : step.after;
    const auto& [jk, ki, il, lj] = step.around;
    if (step.kind == Kind::reverse) {
        if (k == 2)
            turn(values, step.first);
    } else if (step.kind == Kind::flip) {
        // klj gets its part of the circulation: kl = part (jk + ki + il + lj) - lj - jk; back, ijk
        // gets it: ij = part (jk + ki + il + lj) - jk - ki
        const double more = step.sign * part, less = step.sign * (part - 1);
        const Term edge[] = {signed_term(less, jk), signed_term(back ? less : more, ki),
                             signed_term(more, il), signed_term(back ? more : less, lj)};
        if (k == 1)
            values[step.edge] = combine(values, edge);
        else if (k == 2)
            share(values, step.first, step.second, part);
    } else if (back) {
        const Term ij[] = {{1, step.edge}, {1, il.edge}};
        if (k == 1)
            values[step.edge] = combine(values, ij);
        const Term ijk[] = {{1, step.first}, {1, step.second}};
        if (k == 2)
            values[step.first] = combine(values, ijk);
        values.resize(values.size() - (k == 1 ? 2 : 1));
    } else if (k == 0) {
        const Term m[] = {{1 - part, step.vertices[0]}, {part, step.vertices[1]}};
        values.push_back(combine(values, m));
    } else if (k == 1) {
        // imk gets its part of the circulation: mk = part (ij + jk + ki) - part ij - ki
        const Term im{part, step.edge}, mj{1 - part, step.edge};
        const Term mk[] = {signed_term(part, jk), signed_term(part - 1, ki)};
        values.push_back(combine(values, {&mj, 1}));
        values.push_back(combine(values, mk));
        values[step.edge] = combine(values, {&im, 1});
    } else {
        values.push_back({});
        share(values, step.first, step.second, part);
    }
}

namespace {

void check_size(int k, Eigen::Index given, const std::array<Index, 3>& sizes, const char* which) {
    if (k < 0 || k > 2 || given != sizes[k])
        throw InvalidInput(fmt::format("{} values are given for a {}-form: the {} surface has {} "
                                       "vertices, {} edges and {} triangles",
                                       given, k, which, sizes[0], sizes[1], sizes[2]));
}

Vector as_vector(const std::vector<double>& values) {
    return Eigen::Map<const Vector>(values.data(), static_cast<Eigen::Index>(values.size()));
}

} // namespace

Vector FlipHistory::carry(int k, const Vector& values) const {
    check_size(k, values.size(), first_sizes_, "first");
    std::vector<double> current(values.begin(), values.end());
    for (const Step& step : steps_)
        take(step, false, k, current);
    return as_vector(current);
}

Vector FlipHistory::carry_back(int k, const Vector& values) const {
    check_size(k, values.size(), last_sizes_, "last");
    std::vector<double> current(values.begin(), values.end());
    for (auto step = steps_.rbegin(); step != steps_.rend(); ++step)
        take(*step, true, k, current);
    return as_vector(current);
}

std::vector<std::array<Index, 2>> FlipHistory::edges_of_new_vertices() const {
    std::vector<std::array<Index, 2>> ends;
    // of two neighbors on an edge, a new one knows both ends
    const auto known = [&](Index v) { return v < first_sizes_[0]; };
    for (const Step& step : steps_)
        if (step.kind == Kind::split) {
            const auto [i, j, m] = step.vertices;
            if (known(i) && known(j))
                ends.push_back({i, j});
            else
                ends.push_back(ends[(known(i) ? j : i) - first_sizes_[0]]);
        }
    return ends;
}

namespace {

std::vector<SparseRow> identity(Index size) {
    std::vector<SparseRow> rows;
    for (Index s = 0; s < size; ++s)
        rows.push_back({{s, 1.0}});
    return rows;
}

SparseMatrix as_matrix(const std::vector<SparseRow>& rows, Index columns) {
    SparseMatrix result(static_cast<Index>(rows.size()), columns);
    for (Index row = 0; row < result.rows(); ++row) {
        result.startVec(row);
        for (const auto& [column, value] : rows[row])
            result.insertBack(row, column) = value;
    }
    result.finalize();
    return result;
}

} // namespace

SparseMatrix FlipHistory::matrix(int k) const {
    check_size(k, k < 0 || k > 2 ? 0 : first_sizes_[k], first_sizes_, "first");
    auto rows = identity(first_sizes_[k]);
    for (const Step& step : steps_)
        take(step, false, k, rows);
    return as_matrix(rows, first_sizes_[k]);
}

SparseMatrix FlipHistory::matrix_back(int k) const {
    check_size(k, k < 0 || k > 2 ? 0 : last_sizes_[k], last_sizes_, "last");
    auto rows = identity(last_sizes_[k]);
    for (auto step = steps_.rbegin(); step != steps_.rend(); ++step)
        take(*step, true, k, rows);
    return as_matrix(rows, last_sizes_[k]);
}

} // namespace polydec
