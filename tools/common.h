// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/side.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polydec::tools {

using Json = nlohmann::ordered_json;

/// Seconds per stage, in the order the stages began. A stage lasts until the next one begins; one
/// that begins again goes on.
class Timing {
public:
    void begin(std::string_view stage);
    void end();
    Json json() const;

private:
    using Clock = std::chrono::steady_clock;
    std::vector<std::pair<std::string, double>> seconds_;
    std::optional<std::size_t> running_;
    Clock::time_point since_;
};

/// What every command that reads a mesh is told.
struct MeshArguments {
    std::filesystem::path mesh;
    double tolerance = MergeOptions{}.tolerance;
    std::optional<double> angle_tolerance;
    bool merge = true;
    std::string delaunay; ///< empty, flips or split-boundary
    bool json = false;
    bool timing = false;
};

/// Adds MESH and the options of MeshArguments to a subcommand; json is left out where there is
/// none.
enum class JsonOption { offered, none };
void add_mesh_arguments(CLI::App& command, MeshArguments& arguments, JsonOption json);

/// The option --side primal|dual.
CLI::Option* add_side(CLI::App& command, Side& side);

/// Whether edges can be flipped: a surface with two triangles at an edge, at most.
bool is_flippable(const Discretization& mesh);

/// "; add --delaunay" or what else would help against negative duals; empty if nothing would.
std::string flip_advice(const Discretization& mesh);

/// Reads, merges and measures the mesh; tells its warnings on stderr.
Discretization load(const MeshArguments& arguments, Timing& timing);

/// The last words of a command: timing where asked for, as a member of the JSON object or a table.
void add_timing(Json& answer, const MeshArguments& arguments, Timing& timing);
void print_timing(const MeshArguments& arguments, Timing& timing);

/// Writes "polydec: warning: ..." to stderr.
void warn(const std::string& text);

/// A line on stderr that tells what is being done; on a terminal only, and wiped at the end.
class Progress {
public:
    Progress();
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    void operator()(std::string_view what) const;

private:
    bool visible_;
};

} // namespace polydec::tools
