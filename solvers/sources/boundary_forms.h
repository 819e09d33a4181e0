// SPDX-License-Identifier: MIT
#pragma once

#include "dec/boundary/form_space.h"
#include "dec/forms/cochain.h"

#include <vector>

namespace polydec {

/// Boundary data of a form u, integrated over boundary cells. An empty member means 0. On essential
/// facets, the data are the traces (tangential parts) of u and of its codifferential. On natural
/// facets, they are the traces of star u and of star du (the normal parts of u and du). For 0-forms
/// these are u and the normal derivative; for n-forms, the density and its derivative. On Robin
/// facets (the impedance condition), derivative_flow is star du plus the coefficient times the
/// boundary star of the trace of u; primal forms also take star u. With Robin facets, values of
/// dual forms cover only the duals within essential facets.
///
/// Let k be the degree of the cells that carry the form: its own degree, or n minus it for dual
/// forms. Each member has one value per k-cell or per (k-1)-cell; values at other cells are
/// ignored. They are integrals over these cells (made by de_rham), or over their duals within the
/// boundary (made by boundary_de_rham; compare dual_boundary_derivative).
struct BoundaryForms {
    Vector values = {};          ///< u: over k-cells; dual forms: over duals of (k-1)-cells
    Vector codifferential = {};  ///< delta u: over (k-1)-cells; dual forms: over duals of k-cells
    Vector flow = {};            ///< star u: over duals of (k-1)-cells; dual forms: over k-cells
    Vector derivative_flow = {}; ///< star du: over duals of k-cells; dual forms: over (k-1)-cells
};

/// The derivative_flow of 0-forms with given outward normal derivatives: each derivative times the
/// area of its facet, signed by the facet's orientation. Takes one derivative per (n-1)-cell, in
/// the units of the input; interior ones are ignored. Size size(0) for primal forms, size(n-1) for
/// dual ones. Throws InvalidInput for a wrong number of derivatives.
Vector outward_flow(const Cells& cells, Side side, const Vector& derivatives);

/// One value for a set of facets.
struct FacetValue {
    std::vector<bool> facets; ///< marks of the (n-1)-cells
    double value;
};

/// Boundary data of functions, the 0-forms of a space, from values on marked facets. A value is u
/// on essential facets, its outward derivative on natural facets, and the derivative plus the
/// coefficient times u on Robin facets. With a material, the inflow replaces the derivative.
/// Unmarked facets get 0; the last value wins where facets are marked twice or meet at a vertex. In
/// the units of the input. Throws InvalidInput for other forms and for a wrong number of marks.
BoundaryForms boundary_data(const FormSpace& space, const std::vector<FacetValue>& values);

/// Converts boundary data from the units of the input to a mesh's unit of length, in dimension n.
/// Throws InvalidInput if a converted value is not a finite number.
BoundaryForms in_unit(const BoundaryForms& data, double unit, int n, int degree);

} // namespace polydec
