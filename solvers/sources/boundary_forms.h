// SPDX-License-Identifier: MIT
#pragma once

#include "dec/form_space.h"
#include "dec/forms/side.h"

#include <vector>

namespace polydec {

/// What is known of a form u of one degree on the boundary, integrated over the cells there; what
/// is empty is 0. On essential facets the traces (tangential parts) of u and of its codifferential
/// are given, on natural ones those of star u and of star du (the normal parts of u and du). Of
/// 0-forms these are u and the normal derivative, of n-forms the density and its derivative. On
/// Robin's facets star du plus the coefficient times the star, within the boundary, of the trace of
/// u is given as derivative_flow, the impedance condition, for primal forms star u as well; values
/// of dual forms are then over the duals within essential facets alone.
///
/// With k the degree of the cells that carry the forms (k, or n-k of dual ones) there is a value
/// for every k-cell or for every (k-1)-cell; those at other cells do not matter. They are integrals
/// over these cells, of which de_rham makes values, or over the duals within the boundary of these
/// cells, which are as dual_boundary_derivative has them and as boundary_de_rham makes them.
struct BoundaryForms {
    Vector values = {};          ///< u: over k-cells; of dual forms over duals of (k-1)-cells
    Vector codifferential = {};  ///< delta u: over (k-1)-cells; of dual forms over duals of k-cells
    Vector flow = {};            ///< star u: over duals of (k-1)-cells; of dual forms over k-cells
    Vector derivative_flow = {}; ///< star du: over duals of k-cells; of dual forms over (k-1)-cells
};

/// The derivative_flow of 0-forms with these outward normal derivatives, one for each (n-1)-cell,
/// of which those of the boundary matter: each times the area of its facet, as that is oriented.
/// Size size(0) for primal forms, size(n-1) for dual ones. In the units of the input. Throws
/// InvalidInput for another number of them.
Vector outward_flow(const Cells& cells, Side side, const Vector& derivatives);

/// What is known of functions on some facets.
struct FacetValue {
    std::vector<bool> facets; ///< marks of the (n-1)-cells
    double value;
};

/// Data of functions, the 0-forms of a space, by what the conditions of marked facets ask for: u
/// where they are essential, its outward derivative where they are natural, with the coefficient
/// times u added where they are Robin's; with a material what flows in, in place of the derivative.
/// 0 on facets that are not marked; the last value holds where facets are marked twice or meet at a
/// vertex. In the units of the input. Throws InvalidInput for other forms and numbers of marks.
BoundaryForms boundary_data(const FormSpace& space, const std::vector<FacetValue>& values);

/// Data of forms of this degree in the units of the input as they are on a mesh of dimension n that
/// is measured in a unit of length. Throws InvalidInput where they are no numbers.
BoundaryForms in_unit(const BoundaryForms& data, double unit, int n, int degree);

} // namespace polydec
