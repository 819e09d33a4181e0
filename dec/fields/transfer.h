// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/cochain.h"

namespace polydec {

/// Primal k-forms from the simplices to the merged cells: dia_k, the sum over the pieces. Size of P
/// times size of K; a cochain map. Source: Schier, section 10.1, carried to every degree.
SparseMatrix primal_to_merged(const Merging& merging, int k);

/// Primal k-forms from the merged cells to the simplices: R_k = diag|s| dia_k^T diag(1/|F|), the
/// values shared among the pieces by volume, 0 on removed simplices. Size of K times size of P. A
/// right inverse of dia_k but no cochain map: where derivatives are taken afterwards use
/// commuting_lift. volumes are those of the simplices.
SparseMatrix primal_to_input(const Merging& merging, const CellVolumes& volumes, int k);

/// Dual j-forms from the simplices' duals to those of the merged cells: R_(n-j)^T, the mean over
/// the pieces by volume. For a consistent form it drops copies. Size of P times size of K.
SparseMatrix dual_to_merged(const Merging& merging, const CellVolumes& volumes, int j);

/// Dual j-forms from the merged cells' duals to those of the simplices: dia_(n-j)^T, copies, and 0
/// on removed simplices. Size of K times size of P; commutes with the dual derivative, and its
/// values are consistent.
SparseMatrix dual_to_input(const Merging& merging, int j);

/// Forms of which an operator takes one and gives one.
struct FormKind {
    Side side = Side::primal;
    int degree = 0;
};

/// An operator on forms on the merged complex, from forms of kind `from` to forms of kind `to`, as
/// an operator on the input's simplices: O^(T) = R O^P dia for primal forms (Schier, Eq. 15), with
/// R^T and dia^T in place of dia and R on a dual side. So a simulation may keep its triangle or tet
/// mesh. Size of K's cells of `to` times those of `from`.
/// Throws InvalidInput, naming the shapes, if O does not fit.
SparseMatrix on_input(const Discretization& discretization, const SparseMatrix& O, FormKind from,
                      FormKind to);

/// The form on merged cells of a form on the input's simplices, primal or dual; after intrinsic
/// flips primal ones alone, by the product of the flips, a cochain map.
/// Throws InvalidInput if the form does not live on the pieces.
Cochain to_merged(const Discretization& discretization, const Cochain& form);

/// The primal form on the pieces that a primal form on merged cells has by the lift of the bundle
/// (see commuting_lift), and the form on the merged cells of one on the pieces, primal (sums) or
/// dual (means by volume). Both commute with d. Throw like check; on_pieces for dual forms.
Cochain on_pieces(const Discretization& mesh, const Cochain& form);
Cochain on_cells(const Discretization& mesh, const Cochain& form);

/// A form on the cells of placed(mesh), the box of a glued mesh: primal forms by the lift and the
/// pull-back, values of dual forms copied to where their cells lie. Other meshes have it already.
Cochain form_at_places(const Discretization& mesh, const Cochain& form);

/// The primal form on the input's simplices that a primal form on merged cells has by the lift,
/// and, after intrinsic flips, the inverse flips: a cochain map. Throws like on_pieces.
Cochain lifted(const Discretization& mesh, const Cochain& form);

/// The form on the input's simplices of a form on merged cells, by primal_to_input or
/// dual_to_input. After intrinsic flips primal forms come back by the inverse flips, a cochain map,
/// and dual 0-forms as their means over the parts of each triangle (see overlay). Throws
/// InvalidInput if the form does not live on the merged cells.
Cochain to_input(const Discretization& discretization, const Cochain& form);

/// How far a dual form on the simplices is from being one on merged cells.
struct Consistency {
    double worst = 0; ///< largest deviation from what is expected; 0 for a consistent form
    Index cell = -1;  ///< the (n-j)-simplex whose dual deviates most; -1 if none does
    double found = 0;
    double expected = 0;
    std::string description = {}; ///< the offender in words; empty if there is none

    /// Whether the worst deviation is at most this.
    bool within(double tolerance) const { return worst <= tolerance; }
};

/// Whether a dual form on the pieces (the simplices, unless edges were flipped) could be the
/// integrals of a smooth one: pieces of one merged cell, whose duals coincide, must have one value,
/// and removed simplices, whose duals have no extent, the value 0. Source: Schier, Definitions 6.1
/// and 6.2, carried to every degree. Throws InvalidInput if the form is primal, not finite or does
/// not live on the simplices.
Consistency consistency(const Discretization& discretization, const Cochain& form);

} // namespace polydec
