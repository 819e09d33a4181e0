// SPDX-License-Identifier: MIT
#pragma once

#include "dec/choose_stars.h"
#include "solvers/spectra/spectrum.h"
#include "tools/answer.h"

#include <optional>
#include <string>

namespace polydec::tools {

/// What is told of a spectrum, wherever it was computed.
struct Eigenvalues : Answer {
    const Spectrum& spectrum;
    std::string conditions; ///< on the boundary, in words
    ChosenStars stars;
    double seconds;
    double coarse = 0;                 ///< see coarseness
    std::string advice = {};           ///< on eigenvalues of the shape; or nothing
    std::optional<Index> resumed = {}; ///< how many vectors it went on with, of a checkpoint

    Eigenvalues(const Spectrum& found, std::string words, const ChosenStars& chosen, double took)
        : spectrum(found), conditions(std::move(words)), stars(chosen), seconds(took) {}
    void write(JsonWriter& json) const override;
    void write(Text& text) const override;
};

} // namespace polydec::tools
