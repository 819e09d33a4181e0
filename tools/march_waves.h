// SPDX-License-Identifier: MIT
#pragma once

#include "solvers/leapfrog.h"
#include "tools/common.h"
#include "tools/in_time.h"
#include "tools/messages.h"

#include <functional>
#include <string>

/// What the commands wave and maxwell have in common.
namespace polydec::tools {

/// A wave from rest, in the units of the file but for the stars of the mesh.
struct WaveProblem {
    std::string what; ///< wave or maxwell
    std::string title = {}, equation = {};
    std::string form, form_words; ///< what the form is called
    Side side = Side::primal;
    int degree = 0;
    BoundaryConditions conditions = {};
    LeapfrogOptions options = {}; ///< all but the step
    Vector start = {};            ///< at the time 0
    Vector source = {};           ///< of the rate of E, times the pulse; or nothing
    std::function<double(double time)> pulse = {};
    std::string pulse_text = {};
};

/// Marches it, and answers.
void march_waves(WaveProblem problem, const Discretization& mesh, const MeshArguments& arguments,
                 const TimeArguments& time, Log& log);

} // namespace polydec::tools
