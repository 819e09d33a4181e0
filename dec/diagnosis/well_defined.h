// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/side.h"

namespace polydec {

/// Whether an operator is well defined on a mesh.
enum class WellDefined {
    yes,
    restricted, ///< only on forms with one density on all pieces of a cell (Schier, Eq. 4)
    no,         ///< it divides by duals of zero volume
};

inline const char* name(WellDefined verdict) {
    return verdict == WellDefined::yes ? "yes" : verdict == WellDefined::no ? "no" : "restricted";
}

/// The verdict on one operator, as in Table 1 of Schier's paper for triangle meshes.
struct OperatorVerdict {
    std::string name = {};    ///< d, star, codifferential, laplacian, wedge, flat ppp, sharp pp ..
    int degree = 0;           ///< of the forms it takes; for a star, of the primal cells
    Side side = Side::primal; ///< of the forms it takes (sharp: of the form; flat: of the field)
    WellDefined verdict = WellDefined::yes;
    int cell_degree = -1; ///< of the cells that make it ill defined; -1 if none do
    Index cells = 0;      ///< number of such cells
};

/// Reason for a verdict other than yes: "24 of the 2-cells have a dual without extent, by which it
/// divides"; empty for yes.
std::string reason(const OperatorVerdict& verdict);

/// Whether the Laplacian has a spectrum on the forms that live on cells of one degree.
struct SpectrumVerdict {
    int cell_degree = 0;     ///< k: primal k-forms and dual (n-k)-forms
    bool exists = true;      ///< whether there is a norm and no division by zero
    std::string reason = {}; ///< why not, or a reservation; empty if there is nothing to say
};

/// The complex that a verdict applies to.
enum class Stage { input, merged };

/// Verdicts on all operators, in the order of Table 1, from the duals of this mesh, not from
/// theory. A dual has zero volume if merging removed its cell, if its facet is degenerate within
/// the tolerance, or if the star entry is zero in the sense of HodgeStar::zeros. With other stars,
/// operators built from them are judged by the zeros of these stars. Flats and sharps, and
/// everything on the input, are always judged by duals.
std::vector<OperatorVerdict> operator_verdicts(const Discretization& discretization, Stage stage);

/// One verdict per degree 0..n of cells, by the same zeros as the stars and the solvers. A
/// Laplacian may be well defined without a spectrum: a negative dual leaves no norm.
std::vector<SpectrumVerdict> spectrum_verdicts(const HodgeStars& stars);

/// The same for forms of one side under the default conditions, on the cells and volumes that
/// spectrum() uses. So boundary facets without dual do no harm to dual 0-forms.
std::vector<SpectrumVerdict> spectrum_verdicts(const Discretization& discretization, Side side);

} // namespace polydec
