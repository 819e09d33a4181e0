// SPDX-License-Identifier: MIT
#pragma once

#include "shape/shape_spectrum.h"
#include "tools/answer.h"

#include <string>
#include <vector>

namespace polydec::tools {

/// What answers about a shape have in common.
struct ShapeFacts {
    int degree, level, dimension;
    Index flips;
    std::string conditions; ///< on the boundary, in words
    double seconds = 0;

    const char* kind() const { return dimension == 2 ? "triangles" : "simplices"; }
};

/// The reported spectrum of a shape.
struct ShapeEigenvalues : ShapeFacts {
    const ShapeSpectrum& spectrum;

    void write(JsonWriter& json) const;
    void write(Text& text) const;
};

/// The reported counts of a shape's eigenvalues.
struct ShapeCounts : ShapeFacts {
    std::vector<double> below;
    std::vector<CountBelow> counts; ///< one per bound
    Index simplices;

    void write(JsonWriter& json) const;
    void write(Text& text) const;
};

} // namespace polydec::tools
