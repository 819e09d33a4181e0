// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/side.h"

namespace polydec {

/// Whether an operator makes sense on a mesh.
enum class WellDefined {
    yes,
    restricted, ///< on forms alone that have one density on all pieces of a cell (Schier, Eq. 4)
    no,         ///< it divides by duals without extent
};

inline const char* name(WellDefined verdict) {
    return verdict == WellDefined::yes ? "yes" : verdict == WellDefined::no ? "no" : "restricted";
}

/// The verdict on one operator, as Table 1 of Schier's paper has it for triangle meshes.
struct OperatorVerdict {
    std::string name = {};    ///< d, star, codifferential, laplacian, wedge, flat ppp, sharp pp ..
    int degree = 0;           ///< of the forms it takes; of a star that of the primal cells
    Side side = Side::primal; ///< of the forms (sharp: of the form; flat: of the field) it takes
    WellDefined verdict = WellDefined::yes;
    int cell_degree = -1; ///< of the cells that spoil it; -1 if none do
    Index cells = 0;      ///< how many they are
};

/// Why it is no better: "24 of the 2-cells have a dual without extent, by which it divides"; empty
/// if it is yes.
std::string reason(const OperatorVerdict& verdict);

/// Whether the Laplacian has a spectrum on the forms that live on cells of one degree.
struct SpectrumVerdict {
    int cell_degree = 0;     ///< k: primal k-forms and dual (n-k)-forms
    bool exists = true;      ///< whether there is a norm, and nothing is divided by zero
    std::string reason = {}; ///< why not, or what spoils it; empty if there is nothing to say
};

/// Which complex a question is about.
enum class Stage { input, merged };

/// All operators in the order of the table, judged by the duals that the mesh has, not by theory:
/// a dual has no extent where the merging removed its cell, where a facet is degenerate within the
/// tolerance, or where the star entry is zero in the sense of HodgeStar::zeros. Where other stars
/// are chosen, what is made of them is judged by their zeros; flats and sharps are made of duals
/// still, and on the input all is.
std::vector<OperatorVerdict> operator_verdicts(const Discretization& discretization, Stage stage);

/// One for each degree 0..n of cells, by the same zeros as the stars and the solvers. A Laplacian
/// can be well defined where there is no spectrum: with a negative dual there is no norm.
std::vector<SpectrumVerdict> spectrum_verdicts(const HodgeStars& stars);

/// The same for the forms of one side under the conditions that are built in: the judgment is on
/// the cells and volumes that spectrum() solves on, so facets of the boundary without dual do no
/// harm to dual 0-forms.
std::vector<SpectrumVerdict> spectrum_verdicts(const Discretization& discretization, Side side);

} // namespace polydec
