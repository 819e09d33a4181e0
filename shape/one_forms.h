// SPDX-License-Identifier: MIT
#pragma once

#include "shape/shape_spectrum.h"

namespace polydec {

/// Those of a shape and of its 2-forms together, without zeros, behind those of 1-forms. Throws
/// like shape_spectrum, and InvalidInput for weights, Robin's condition and three triangles at an
/// edge.
ShapeSpectrum one_form_spectrum(const Shape& shape, const ShapeSpectrumOptions& options);
CountBelow one_form_count(const Shape& shape, double s, const CountOptions& options);

/// Whether forms of this degree are functions or densities (false), or 1-forms of a surface. Throws
/// InvalidInput for others.
bool are_one_forms(const Shape& shape, int degree);

} // namespace polydec
