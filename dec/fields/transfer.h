// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/discretization.h"
#include "dec/forms/cochain.h"

namespace polydec {

/// Primal k-forms from the simplices to the merged cells: dia_k, the sum over the pieces. Size of P
/// times size of K; a cochain map. Source: Schier, section 10.1, extended to every degree.
SparseMatrix primal_to_merged(const Merging& merging, int k);

/// Primal k-forms from the merged cells to the simplices: R_k = diag|s| dia_k^T diag(1/|F|). A
/// value is shared among the pieces by volume; removed simplices have 0. Size of K times size of P.
/// A right inverse of dia_k but no cochain map: to take derivatives afterwards, use commuting_lift.
/// `volumes` are the volumes of the simplices.
SparseMatrix primal_to_input(const Merging& merging, const CellVolumes& volumes, int k);

/// Dual j-forms from the simplices' duals to the merged cells' duals: R_(n-j)^T, the mean over the
/// pieces by volume. For a consistent form it drops copies. Size of P times size of K.
SparseMatrix dual_to_merged(const Merging& merging, const CellVolumes& volumes, int j);

/// Dual j-forms from the merged cells' duals to the simplices' duals: dia_(n-j)^T, which copies
/// values; removed simplices have 0. Size of K times size of P; commutes with the dual derivative,
/// and its values are consistent.
SparseMatrix dual_to_input(const Merging& merging, int j);

/// Side and degree of the forms that an operator takes or returns.
struct FormKind {
    Side side = Side::primal;
    int degree = 0;
};

/// An operator on forms on the merged complex, from kind `from` to kind `to`, as an operator on the
/// input's simplices: O^(T) = R O^P dia for primal forms (Schier, Eq. 15); on a dual side R^T and
/// dia^T replace dia and R. So a simulation may keep its triangle or tet mesh. Size: K's cells of
/// `to` times K's cells of `from`.
/// Throws InvalidInput, naming the shapes, if O does not fit.
SparseMatrix on_input(const Discretization& discretization, const SparseMatrix& O, FormKind from,
                      FormKind to);

/// Maps a form on the input's simplices, primal or dual, to the merged cells. After intrinsic
/// flips, by cochain maps: primal forms by the product of the flips, dual ones by the transpose of
/// lifted. Throws InvalidInput if the form does not live on the pieces.
Cochain to_merged(const Discretization& discretization, const Cochain& form);

/// Maps a primal form on merged cells to the pieces by the lift of the mesh (see commuting_lift);
/// on_cells maps a form on the pieces to merged cells, primal by sums, dual by means by volume.
/// Both commute with d. Throw like check; on_pieces also for dual forms.
Cochain on_pieces(const Discretization& mesh, const Cochain& form);
Cochain on_cells(const Discretization& mesh, const Cochain& form);

/// Maps a form to the cells of placed(mesh), the box of a glued mesh: primal forms by the lift and
/// the pull-back, dual forms by copying values to where their cells lie. No-op for other meshes.
Cochain form_at_places(const Discretization& mesh, const Cochain& form);

/// Maps a primal form on merged cells to the input's simplices by the lift and, after intrinsic
/// flips, the inverse flips: a cochain map. Throws like on_pieces.
Cochain lifted(const Discretization& mesh, const Cochain& form);

/// Maps a form on merged cells to the input's simplices by primal_to_input or dual_to_input. After
/// intrinsic flips, primal forms are mapped by the inverse flips, a cochain map, and dual 0-forms
/// by means over the parts of each triangle (see overlay), which needs points. Throws InvalidInput
/// if the form does not live on the merged cells, and without these points.
Cochain to_input(const Discretization& discretization, const Cochain& form);

/// Deviation of a dual form on the simplices from a form on merged cells.
struct Consistency {
    double worst = 0; ///< largest deviation from the expected value; 0 for a consistent form
    Index cell = -1;  ///< the (n-j)-simplex whose dual deviates most; -1 if none deviates
    double found = 0;
    double expected = 0;
    std::string description = {}; ///< the worst deviation in words; empty if there is none

    /// Whether the worst deviation is at most `tolerance`.
    bool within(double tolerance) const { return worst <= tolerance; }
};

/// Checks whether a dual form on the pieces (the simplices, unless edges were flipped) can be the
/// integrals of a smooth form. Pieces of one merged cell have coinciding duals and must have equal
/// values; removed simplices have duals without extent and must have the value 0. Source: Schier,
/// Definitions 6.1 and 6.2, extended to every degree. Throws InvalidInput if the form is primal,
/// not finite or does not live on the simplices.
Consistency consistency(const Discretization& discretization, const Cochain& form);

} // namespace polydec
