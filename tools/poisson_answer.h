// SPDX-License-Identifier: MIT
#pragma once

#include "shape/poisson_error.h"
#include "solvers/sources/poisson.h"
#include "tools/common.h"

#include <optional>
#include <string>

namespace polydec::tools {

/// Errors against the exact solution: L2 norm weighted by cell volumes, and maximum.
struct Errors {
    std::optional<double> l2; ///< none if it overflows in the units of the file
    double max;
};

/// The reported solution of a Poisson problem, from one process or several.
struct Solved {
    FormFacts facts;
    const char* boundary = "";
    std::int64_t unknowns = 0;
    double min = 0, max = 0;
    SolveReport report = {};
    Index free_components = 0;
    std::optional<Errors> errors = {};
    std::optional<PoissonError> bound = {};
    std::string without_bound = {}; ///< why there is no bound, or none in L2

    void write(JsonWriter& json) const;
    void write(Text& text) const;
};

} // namespace polydec::tools
