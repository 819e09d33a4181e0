// SPDX-License-Identifier: MIT
#pragma once

#include "dec/fields/de_rham.h"
#include "meshes/periodic.h"

namespace polydec {

/// The de Rham map on a periodic box, discretize(periodic.quotient): integrals of a form with these
/// periods over the cells, each where it lies in the box, so that cells across a seam are straight.
/// Throws like de_rham, and InvalidInput unless the discretization is of this quotient.
Cochain de_rham(const PeriodicMesh& periodic, const Discretization& mesh, int k,
                const SmoothForm& form, int quadrature_degree = 5);

} // namespace polydec
