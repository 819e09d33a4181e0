// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/discretization.h"
#include "dec/forms/cochain.h"
#include "tools/answer.h"
#include "tools/joining.h"
#include "tools/messages.h"
#include "tools/options.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polydec::tools {

/// Arguments of every command that reads a mesh.
struct MeshArguments {
    std::filesystem::path mesh;
    double tolerance = DiscretizeOptions{}.tolerance;
    std::optional<double> angle_tolerance;
    bool merge = true;
    bool keep_groups = false;
    bool peel = false;
    JoiningArguments joining;
    std::optional<double> refine;
    std::vector<std::string> periods; ///< translations, "1,0"
    std::vector<std::string> glue;    ///< isometries, "x+1; 1-y"
    std::string centers = "circumcenters";
    std::string delaunay; ///< empty, flips or split-boundary
    StarKind star = StarKind::circumcentric;
    TellOptions tell;
};

/// Adds MESH and the options of MeshArguments to a subcommand; --star where a default is given.
void add_mesh_arguments(CLI::App& command, MeshArguments& arguments,
                        std::optional<StarKind> star = {});

/// Adds the arguments for merging and output, and MESH with this help; returns --angle-tolerance.
CLI::Option* add_merge_arguments(CLI::App& command, MeshArguments& arguments,
                                 const std::string& mesh_help);

/// The merge options in these arguments.
MergeOptions merge_options(const MeshArguments& arguments);

/// The option --star, with this kind as the default.
void add_star(CLI::App& command, MeshArguments& arguments, StarKind kind);

/// The options --side primal|dual, and --degree, of forms.
void add_side(CLI::App& command, Side& side);
void add_forms(CLI::App& command, Side& side, int& degree);

/// The option --engine, of linear solvers.
void add_engine(CLI::App& command, std::string& engine);

/// "hybrid stars, Galerkin's on 12.3 % of the cells".
std::string in_words(const ChosenStars& stars);

/// What answers about forms have in common.
struct FormFacts {
    Side side = Side::primal;
    int degree = 0;
    std::string conditions; ///< on the boundary, in words
    ChosenStars stars;

    void write_form(JsonWriter& json) const;       ///< side and degree
    void write_conditions(JsonWriter& json) const; ///< and the stars

    /// An equation and these facts, for pages.
    std::vector<std::string> beside(const std::string& equation) const;
};

/// Reads, merges and measures the mesh; reports its warnings. Throws like check_drawable if there
/// is a path of a picture.
Discretization load(const MeshArguments& arguments, Log& log,
                    const std::filesystem::path& picture = {});

/// A progress line on stderr; on a terminal only, and erased at the end.
class ProgressLine {
public:
    explicit ProgressLine(std::string_view what = {});
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;
    void operator()(std::string_view what) const;

private:
    bool visible_;
};

/// The result of work(), which progress names; its errors name the log's mesh file.
template <class Work>
auto computed(const Log& log, std::string_view what, Work work) {
    const ProgressLine progress(what);
    return computed_on(log.mesh, work);
}

} // namespace polydec::tools
