// SPDX-License-Identifier: MIT
#pragma once

#include "shape/shape_spectrum.h"
#include "tools/answer.h"

#include <string>
#include <vector>

namespace polydec::tools {

/// The reported spectrum of a shape.
struct ShapeEigenvalues : Answer {
    const ShapeSpectrum& spectrum;
    int degree, level;
    Index flips;
    int dimension;
    std::string conditions; ///< on the boundary, in words
    double seconds;

    ShapeEigenvalues(const ShapeSpectrum& found, const ShapeSpectrumOptions& options,
                     const Shape& shape, Index flipped, std::string words, double took)
        : spectrum(found),
          degree(options.degree),
          level(options.level),
          flips(flipped),
          dimension(shape.pieces.dimension()),
          conditions(std::move(words)),
          seconds(took) {}
    void write(JsonWriter& json) const override;
    void write(Text& text) const override;
};

/// The reported counts of a shape's eigenvalues.
struct ShapeCounts : Answer {
    std::vector<double> below;
    std::vector<CountBelow> counts; ///< one per bound
    CountOptions options = {};
    Index simplices = 0, flips = 0;
    int dimension = 0;
    std::string conditions; ///< on the boundary, in words
    double seconds = 0;

    void write(JsonWriter& json) const override;
    void write(Text& text) const override;
};

} // namespace polydec::tools
