// SPDX-License-Identifier: MIT
#pragma once

#include "solvers/time/waves.h"
#include "tools/common.h"
#include "tools/in_time.h"

#include <string>

/// Common parts of the commands wave and maxwell.
namespace polydec::tools {

/// The names of a wave in output.
struct WaveWords {
    std::string what; ///< wave or maxwell
    std::string title, equation;
    std::string form, form_words;   ///< of the form E
    std::string upper, upper_words; ///< of the form B, half a step earlier
    bool upper_is_flux = false;     ///< whether a 1-form B holds fluxes
};

/// Marches a wave of a space on a mesh, and answers. Sets only the step of the options.
void answer_waves(const WaveWords& words, const Discretization& mesh, const FormSpace& space,
                  const Vector& start, WaveOptions options, const TellOptions& tell_options,
                  const TimeArguments& time, Log& log);

} // namespace polydec::tools
