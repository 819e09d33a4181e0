// SPDX-License-Identifier: MIT
#pragma once

#include "solvers/time/waves.h"
#include "tools/common.h"
#include "tools/in_time.h"

#include <string>

/// What the commands wave and maxwell have in common.
namespace polydec::tools {

/// What a wave is called.
struct WaveWords {
    std::string what; ///< wave or maxwell
    std::string title, equation;
    std::string form, form_words; ///< of the form
};

/// Marches a wave of a space on a mesh, and answers. Of the options all but the step are given.
void answer_waves(const WaveWords& words, const Discretization& mesh, const FormSpace& space,
                  const Vector& start, WaveOptions options, const MeshArguments& arguments,
                  const TimeArguments& time, Log& log);

} // namespace polydec::tools
