// SPDX-License-Identifier: MIT
#pragma once

#include "dec/stars/choose_stars.h"
#include "solvers/spectra/spectrum.h"
#include "tools/answer.h"

#include <optional>
#include <string>

namespace polydec::tools {

/// The reported spectrum, from one process or several.
struct Eigenvalues {
    const Spectrum& spectrum;
    std::string conditions; ///< on the boundary, in words
    ChosenStars stars;
    double seconds;
    std::optional<Index> resumed = {}; ///< number of vectors resumed from a checkpoint

    Eigenvalues(const Spectrum& found, std::string words, const ChosenStars& chosen, double took)
        : spectrum(found), conditions(std::move(words)), stars(chosen), seconds(took) {}
    void write(JsonWriter& json) const;
    void write(Text& text) const;
};

} // namespace polydec::tools
