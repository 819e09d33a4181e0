// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "io/pages/draw_page.h"
#include "solvers/time/run.h"
#include "tools/answer.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// What commands that march in time have in common.
namespace polydec::tools {

struct TimeArguments {
    double until = 0;     ///< in the units of the file
    double time_step = 0; ///< at most; 0: what the command takes by itself
    Index frames = 20;
    std::filesystem::path out, checkpoint;
    bool resume = false;
};

/// Adds --until, --time-step, --frames, -o, --checkpoint and --resume; what the command takes for a
/// step by itself, in words.
void add_time(CLI::App& command, TimeArguments& arguments, const std::string& own_step);

/// Looks at the files that are asked for; inputs are those that are read.
void check_time(const TimeArguments& arguments, std::vector<std::filesystem::path> inputs);

/// Equal steps, of which the last one ends at the time that is asked for.
struct TimeSteps {
    Index count;
    double length; ///< in the units of the file
};

/// Of at most the length that is asked for; else of at most this one, and as many to each frame.
/// Throws InvalidInput for more than 1e9 steps.
TimeSteps time_steps(const TimeArguments& arguments, double length);

/// How a run is told of.
struct March {
    std::string what; ///< heat, say, for progress
    PageText text;
    TimeSteps steps;
    std::function<std::vector<NamedForm>(const Run&)> shown;
};

/// Where a run began: at a checkpoint, or at step 0.
struct Ran {
    Index resumed_at = 0;
    Index frames = 0;
};

/// Marches to the end, with what happens on the way: the frames of the series that is asked for,
/// and a checkpoint after each; see march of the library. A signal that asks for it ends the
/// program, where a checkpoint is kept. Errors name the file of the mesh.
Ran march_to_end(Run& run, const March& march, const TimeArguments& arguments,
                 const std::filesystem::path& file, const Discretization& mesh);

/// A number as a part of that at the beginning; none if there was nothing.
std::optional<double> part_of(double now, double before);

/// A number in the units of the file; none where double precision has no such number.
std::optional<double> in_range(const std::function<double()>& number);
std::string in_words(const std::optional<double>& part);

/// Of the JSON object of an answer, and of its text.
void write_time(JsonWriter& json, const TimeSteps& steps, const Ran& ran);
std::string in_words(const TimeSteps& steps, const Ran& ran);

} // namespace polydec::tools
