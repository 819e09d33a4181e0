// SPDX-License-Identifier: MIT
#pragma once

#include "dec/boundary/form_space.h"
#include "solvers/sources/boundary_forms.h"

namespace polydec {

/// Boundary data as they enter the equations: fixed values, 0 elsewhere, and right-hand sides. Each
/// vector has one entry per cell.
struct BoundaryLoads {
    Vector w, below, b, g;
    Vector b_terms, g_terms; // magnitudes of the terms summed in b and g
};

/// The equations of a primal k-form w and of s = delta w; a dual form is the star of w. With M the
/// stars:
///     d^T M_(k+1) d w + M_k d s = B star_dw,    d^T M_k w - M_(k-1) s = B_below star_w,
/// where star_w and star_dw are integrals over the duals within the boundary. With conditions, only
/// the rows of kept cells remain, and the values at all other cells are known.
struct FormEquations {
    explicit FormEquations(const FormSpace& space);

    /// In the unit of the cells. Throws InvalidInput for a wrong number of values, and for values
    /// that are not finite.
    BoundaryLoads loads(const BoundaryForms& data) const;

    /// The same, with the fixed values moved to the right-hand sides.
    BoundaryLoads loads_of_free_values(const BoundaryForms& data) const;

    /// Map free values to all cells, except those left out.
    SparseMatrix kept() const;
    SparseMatrix kept_below() const;

    Side side;
    int dimension, k;
    std::vector<bool> left_out, left_out_below;
    std::vector<bool> given, given_below; // cells with values fixed by data
    std::vector<bool> asked;              // cells where star w is needed
    SparseMatrix M, M_below;              // on all cells, as are the matrices below
    SparseMatrix upper;                   // d^T M_(k+1) d, without the dw given by data
    SparseMatrix down;                    // d^T M_k
    SparseMatrix B, B_below;
    SparseMatrix fix, load;          // for n-cells with centers on the boundary: star w, star dw
    SparseMatrix robin, robin_below; // Robin terms of upper, and of M_below

private:
    FormEquations(const FormSpace& space, const CellComplex& complex, const HodgeStars& stars);
};

} // namespace polydec
