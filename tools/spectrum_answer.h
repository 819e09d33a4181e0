// SPDX-License-Identifier: MIT
#pragma once

#include "solvers/spectra/spectrum.h"
#include "tools/common.h"

#include <optional>
#include <string>

namespace polydec::tools {

/// The reported spectrum, from one process or several.
struct Eigenvalues {
    const Spectrum& spectrum;
    FormFacts facts;
    double seconds;
    std::optional<Index> resumed = {}; ///< number of vectors resumed from a checkpoint

    void write(JsonWriter& json) const;
    void write(Text& text) const;
};

} // namespace polydec::tools
