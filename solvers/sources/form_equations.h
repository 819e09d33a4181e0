// SPDX-License-Identifier: MIT
#pragma once

#include "dec/form_space.h"
#include "solvers/sources/boundary_forms.h"

namespace polydec {

/// What data on the boundary make of the equations: the values that they fix, 0 elsewhere, and the
/// right sides. All have an entry for every cell.
struct BoundaryLoads {
    Vector w, below, b, g;
    Vector b_terms, g_terms; // the sizes of what b and g are sums of
};

/// The equations of a primal k-form w, of which a dual form is the star, and of s = delta w, with M
/// the stars:
///     d^T M_(k+1) d w + M_k d s = B star_dw,    d^T M_k w - M_(k-1) s = B_below star_w,
/// star_w and star_dw over the duals within the boundary. Under conditions these are the rows of
/// the kept cells, and the values at all others are known.
struct FormEquations {
    explicit FormEquations(const FormSpace& space);

    /// In the unit of the cells. Throws InvalidInput for other numbers of values than there are
    /// cells, and what is not finite.
    BoundaryLoads loads(const BoundaryForms& data) const;

    /// The same with the fixed values taken to the right sides.
    BoundaryLoads loads_of_free_values(const BoundaryForms& data) const;

    Side side;
    int dimension, k;
    std::vector<bool> left_out, left_out_below;
    SparseMatrix kept, kept_below; // from the values that are free to all, which are not left out
    Vector given, given_below;     // 1 at cells whose values data fix, else 0
    Vector asked;                  // 1 where star w is asked for, else 0
    SparseMatrix M, M_below;       // of all cells, as are those behind
    SparseMatrix upper;            // d^T M_(k+1) d, but for dw that data give
    SparseMatrix down;             // d^T M_k
    SparseMatrix B, B_below;
    SparseMatrix fix, load; // where n-cells have their centers on the boundary: star w, star dw
    SparseMatrix robin, robin_below; // what Robin's condition adds to upper, and to M_below

private:
    FormEquations(const FormSpace& space, const CellComplex& complex, const HodgeStars& stars);
};

} // namespace polydec
