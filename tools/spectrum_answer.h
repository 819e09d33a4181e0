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
    std::optional<Index> resumed = {}; ///< how many vectors it went on with, of a checkpoint

    Eigenvalues(const Spectrum& found, std::string words, const ChosenStars& chosen, double took)
        : spectrum(found), conditions(std::move(words)), stars(chosen), seconds(took) {}
    void write(JsonWriter& json) const override;
    void write(Text& text) const override;
};

void warn_of_rough_values(const Spectrum& spectrum, Log& log);

/// What is measured in length^-2, in the units of the file. What is rounding beside the largest
/// number may vanish; radii then grow by what is lost there.
void use_input_units(Spectrum& spectrum, double unit);

} // namespace polydec::tools
