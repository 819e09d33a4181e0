// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <vector>

namespace polydec {

/// Exterior products of k vectors (or covectors) of R^N, by minors with precomputed tables.
class ExteriorProduct {
public:
    ExteriorProduct(int N, int k);

    /// Number of coefficients: N over k; 1 for k = 0.
    Index size() const { return static_cast<Index>(degrees_.back().size()); }

    /// v_1 ^ .. ^ v_k of the rows of a k x N matrix: its coefficients, minors at the k-subsets of
    /// the axes in lexicographic order.
    Vector operator()(const DenseMatrix& vectors) const;

    /// (-1)^p times the product of the listed rows but the p-th. Of the gradients of barycentric
    /// coordinates at the corners of a face: 1 / k! of the face's Whitney form at its p-th corner.
    Vector without(int p, std::vector<int> list, const DenseMatrix& rows) const;

private:
    struct Term {
        Index rest; // the subset without this axis
        Index axis;
        double sign;
    };
    std::vector<std::vector<std::vector<Term>>> degrees_; // by degree and subset
};

} // namespace polydec
