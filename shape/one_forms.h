// SPDX-License-Identifier: MIT
#pragma once

#include "shape/shape_spectrum.h"

namespace polydec {

/// The spectrum of 1-forms: the nonzero eigenvalues of functions and of 2-forms together, after the
/// zeros of 1-forms. Throws like shape_spectrum, and InvalidInput for weights, a Robin condition
/// and three triangles at an edge.
ShapeSpectrum one_form_spectrum(const Shape& shape, const ShapeSpectrumOptions& options);
CountBelow one_form_count(const Shape& shape, double s, const CountOptions& options);

/// True for 1-forms of a surface, false for functions and densities. Throws InvalidInput for other
/// degrees.
bool are_one_forms(const Shape& shape, int degree);

} // namespace polydec
