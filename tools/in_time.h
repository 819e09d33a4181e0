// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/discretization.h"
#include "io/pages/page.h"
#include "solvers/time/run.h"
#include "solvers/time/time_steps.h"
#include "tools/answer.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Common parts of the commands that march in time.
namespace polydec::tools {

struct TimeArguments {
    double until = 0;     ///< in the units of the file
    double time_step = 0; ///< upper bound; 0: the command's default
    Index frames = 20;
    std::filesystem::path out, checkpoint;
    bool resume = false;
};

/// Adds --until, --time-step, --frames, -o, --checkpoint and --resume; `own_step` describes the
/// command's default step.
void add_time(CLI::App& command, TimeArguments& arguments, const std::string& own_step);

/// Checks the output files.
void check_time(const TimeArguments& arguments);

/// Steps of at most the requested length; else of at most `length`, with equally many per frame.
/// Throws InvalidInput for more than 1e9 steps.
TimeSteps time_steps(const TimeArguments& arguments, double length);

/// The presentation of a run.
struct March {
    std::string what; ///< for progress, e.g. heat
    PageText text;
    TimeSteps steps;
    std::function<std::vector<NamedForm>(const Run&)> shown;
};

/// The vectors of a flux through facets: at vertices, or at cells where vertices have none because
/// seams of a glued mesh turn.
NamedForm flux_vectors(const std::string& name, const Discretization& mesh, const Cochain& flux,
                       const std::string& about);

/// How a run went, for answers.
struct Ran {
    TimeSteps steps;
    Index resumed_at; ///< the step of the checkpoint, or 0
    Index frames;

    void write(JsonWriter& json) const;
    std::string in_words() const;
};

/// Marches to the end and writes the requested frames and a checkpoint after each; see march of the
/// library. If there is a checkpoint, it is saved before a stop signal ends the program. Errors
/// name the log's mesh file.
Ran march_to_end(Run& run, const March& march, const TimeArguments& arguments,
                 const Discretization& mesh, const Log& log);

/// A number over its initial value, which has none if that was 0.
std::string in_words(const std::optional<double>& part);

} // namespace polydec::tools
