// SPDX-License-Identifier: MIT
#pragma once

#include "dec/metric/simplex_geometry.h"
#include "dec/metric/simplex_metric.h"

#include <span>
#include <vector>

namespace polydec {

/// Positions of the corners of one simplex: rows of a table of coordinates.
struct Corners {
    const Points& points;
    std::span<const Index> vertices; ///< the rows, in ascending order of the simplex's vertices
    bool by_lengths = false;         ///< the points were computed from known distances, not given
    double error = 0;                ///< see SimplexMetric::error

    const double* place(Index row) const {
        return points.data() + std::ptrdiff_t{row} * points.cols();
    }
};

/// Places the corners of one simplex of a complex at a time. Not thread-safe.
class SimplexLayout {
public:
    /// Keeps a reference to the complex, which must outlive the layout.
    SimplexLayout(const Pieces& complex, const SimplexMetric& metric);

    /// The corners of k-simplex s, valid until the next call. With points: these points. With
    /// lengths: a table of k coordinates per corner, the Cholesky factor of the Gram matrix of the
    /// edges from one corner. A simplex that does not exist is laid out without volume; so is a
    /// simplex of more than three corners with a height below 6e-8 of its edges (the rounding error
    /// of squared lengths).
    Corners at(int k, Index s) {
        if (metric_.points() != nullptr)
            return {*metric_.points(), vertices(complex_.simplices(k), s), false, metric_.error()};
        return lay_out(k, s);
    }

    const Pieces& complex() const { return complex_; }

private:
    Corners lay_out(int k, Index s);
    template <int k_fixed>
    bool place(int k_given, Index s, double* table);
    void measure_edges(int k, Index s);
    int base(int k) const;
    template <class Corner>
    double height(int origin, Corner corner, int a, const double* known) const;
    double length(int i, int j) const { return lengths_[i * rows_.size() + j]; }
    double product(int origin, int i, int j) const;

    const Pieces& complex_;
    SimplexMetric metric_;
    std::vector<FaceTable> faces_; // of degree k at k - 1
    std::vector<Index> rows_;      // 0..n
    std::vector<double> lengths_;  // between corners i and j of one simplex, (n+1) x (n+1)
    std::vector<Points> tables_;   // by degree
};

} // namespace polydec
