// SPDX-License-Identifier: MIT
#include "complex/components.h"
#include "complex/homology.h"
#include "dec/facet_kinds.h"
#include "dec/star.h"
#include "dec/well_defined.h"
#include "tools/commands.h"
#include "tools/common.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <memory>

namespace polydec::tools {

namespace {

Json cell_counts(const CellComplex& complex) {
    Json counts = Json::array();
    for (int k = 0; k <= complex.dimension(); ++k)
        counts.push_back(complex.size(k));
    return counts;
}

Json star_numbers(const CellVolumes& volumes, int k) {
    const Vector values = star(volumes, k);
    const auto zero = zero_star_cells(volumes, k).size();
    Json numbers{{"min", values.minCoeff()},
                 {"max", values.maxCoeff()},
                 {"min_abs", values.cwiseAbs().minCoeff()},
                 {"negative", negative_star_cells(volumes, k).size()},
                 {"zero", zero}};
    // of a diagonal matrix; there is none if an entry is zero
    numbers["condition"] = nullptr;
    if (zero == 0)
        numbers["condition"] = values.cwiseAbs().maxCoeff() / values.cwiseAbs().minCoeff();
    return numbers;
}

Json stars(const CellVolumes& volumes) {
    Json list = Json::array();
    for (int k = 0; k <= volumes.dimension(); ++k)
        list.push_back(star_numbers(volumes, k));
    return list;
}

Json kinds(const Discretization& mesh) {
    const auto count = facet_kinds(mesh.input(), mesh.metric(), mesh.input_volumes, mesh.options);
    return {{"well_centered", count.well_centered},
            {"delaunay", count.delaunay},
            {"non_delaunay", count.non_delaunay},
            {"cospherical", count.cospherical}};
}

/// A row for each operator: the verdicts on it for primal and dual forms, before and after merging.
Json operators(const Discretization& mesh) {
    Json rows = Json::array();
    for (const auto& [stage, label] : {std::pair{Stage::input, "input"}, {Stage::merged, "merged"}})
        for (const auto& verdict : operator_verdicts(mesh, stage)) {
            const auto same = [&](const Json& row) {
                return row["operator"] == verdict.name && row["degree"] == verdict.degree;
            };
            auto row = std::find_if(rows.begin(), rows.end(), same);
            if (row == rows.end()) {
                rows.push_back({{"operator", verdict.name}, {"degree", verdict.degree}});
                row = rows.end() - 1;
            }
            (*row)[label][name(verdict.side)] = name(verdict.verdict);
        }
    return rows;
}

Json vertices_per_cell(const Discretization& mesh) {
    const int n = mesh.dimension();
    std::map<std::size_t, Index> histogram;
    for (Index cell = 0; cell < mesh.complex().size(n); ++cell)
        ++histogram[cell_vertices(mesh, n, cell).size()];
    Json result = Json::object();
    for (const auto& [vertices, cells] : histogram)
        result[std::to_string(vertices)] = cells;
    return result;
}

Json concyclic(const Discretization& mesh) {
    const auto pairs =
        mesh.intrinsic ? merged_pairs(mesh.intrinsic->merging) : merged_pairs(mesh.merging);
    return {{"edges", pairs.facets},
            {"faces", pairs.simplices},
            {"percent", 100.0 * pairs.simplices / mesh.input().size(2)}};
}

/// What flips have done.
Json flips(const IntrinsicTessellation& tessellation) {
    const auto& done = tessellation.delaunay.statistics;
    return {{"negative_before", done.negative_before},
            {"negative_boundary_before", done.negative_boundary_before},
            {"flips", done.flips},
            {"splits", done.splits},
            {"negative", done.negative_interior},
            {"negative_boundary", done.negative_boundary},
            {"added_length", done.added_length},
            {"cells",
             {tessellation.surface().vertices(), tessellation.surface().edges(),
              tessellation.surface().triangles()}}};
}

/// What would make negative duals positive, if there are any and something would.
Json advice(const Discretization& mesh) {
    Json list = Json::array();
    if (!is_flippable(mesh) || mesh.options.delaunay == Delaunay::flips_and_splits)
        return list;
    Index inside = 0, boundary = 0;
    for (const Index e : negative_star_cells(mesh.volumes, 1))
        ++(mesh.complex().coface_counts(1)[e] == 1 ? boundary : inside);
    const auto edges = [](Index count) {
        return fmt::format("{} negative dual edge{}", count, count == 1 ? "" : "s");
    };
    if (inside > 0)
        list.push_back(fmt::format("{}: add --delaunay", edges(inside)));
    if (boundary > 0)
        list.push_back(
            fmt::format("{} on the boundary: add --delaunay=split-boundary", edges(boundary)));
    return list;
}

Json describe(const Discretization& mesh, Timing& timing) {
    const auto& K = mesh.input();
    const auto& P = mesh.complex();
    Json answer;
    answer["dimension"] = mesh.dimension();
    answer["ambient_dimension"] = nullptr; // only lengths are known
    if (mesh.points.cols() > 0)
        answer["ambient_dimension"] = mesh.points.cols();
    answer["cells"] = {{"input", cell_counts(K)}, {"merged", cell_counts(P)}};
    answer["euler"] = {{"input", euler_characteristic(K)}, {"merged", euler_characteristic(P)}};
    timing.begin("topology");
    answer["betti"] = {{"input", betti_numbers(K)}, {"merged", betti_numbers(P)}};
    answer["components"] = components(K).count;
    answer["boundary_components"] = boundary_components(K).count;
    answer["orientable"] = K.orientable();
    timing.begin("operators");
    answer["volume"] = mesh.volumes.primal(mesh.dimension()).sum();
    answer["facets"] = {{"degenerate", mesh.degenerate.interior},
                        {"boundary_degenerate", mesh.degenerate.boundary},
                        {"branching_degenerate", mesh.degenerate.branching}};
    if (mesh.intrinsic)
        answer["intrinsic"] = flips(*mesh.intrinsic);
    else
        answer["pairs"] = kinds(mesh);
    answer["stars"] = stars(mesh.volumes);
    answer["input_stars"] = stars(mesh.input_volumes);
    answer["operators"] = operators(mesh);
    answer["vertices_per_cell"] = vertices_per_cell(mesh);
    if (mesh.dimension() == 2)
        answer["concyclic"] = concyclic(mesh);
    answer["advice"] = advice(mesh);
    answer["warnings"] = mesh.warnings;
    return answer;
}

std::string join(const Json& list) {
    std::vector<std::string> texts;
    for (const auto& entry : list)
        texts.push_back(entry.dump());
    return fmt::format("{}", fmt::join(texts, ", "));
}

void print_cells(const Json& answer) {
    const auto count = [&](const char* which) { return join(answer["cells"][which]); };
    const int n = answer["dimension"];
    const Json& coordinates = answer["ambient_dimension"];
    fmt::print("dimension {} {}, volume {:.10g}\n", n,
               coordinates.is_null() ? "by lengths of edges alone"
                                     : fmt::format("in {} coordinates", coordinates.get<int>()),
               answer["volume"].get<double>());
    fmt::print("cells of degree 0 .. {}\n", n);
    fmt::print("  input    {}\n  merged   {}\n", count("input"), count("merged"));
    std::vector<std::string> sizes;
    for (const auto& [vertices, cells] : answer["vertices_per_cell"].items())
        sizes.push_back(fmt::format("{} with {}", cells.get<Index>(), vertices));
    fmt::print("  merged {}-cells by vertices: {}\n", n, fmt::join(sizes, ", "));
}

void print_topology(const Json& answer) {
    fmt::print("topology\n");
    fmt::print("  Euler characteristic {}, Betti numbers {} ({} after merging)\n",
               answer["euler"]["input"].get<Index>(), join(answer["betti"]["input"]),
               answer["betti"]["merged"] == answer["betti"]["input"] ? "the same" : "changed");
    fmt::print("  components {}, of the boundary {}, {}\n", answer["components"].get<Index>(),
               answer["boundary_components"].get<Index>(),
               answer["orientable"].get<bool>() ? "orientable" : "not orientable");
}

void print_flips(const Json& done) {
    fmt::print(
        "intrinsic flips\n  {} negative dual edges before, and {} on the boundary; {} flips, "
        "{} splits\n  {} and {} negative ones are left\n",
        done["negative_before"].get<Index>(), done["negative_boundary_before"].get<Index>(),
        done["flips"].get<Index>(), done["splits"].get<Index>(), done["negative"].get<Index>(),
        done["negative_boundary"].get<Index>());
}

void print_duals(const Json& answer) {
    const auto& facets = answer["facets"];
    fmt::print("degenerate dual edges\n  {} between two cells, {} on the boundary, {} at branching "
               "facets\n",
               facets["degenerate"].get<Index>(), facets["boundary_degenerate"].get<Index>(),
               facets["branching_degenerate"].get<Index>());
    if (answer.contains("concyclic"))
        fmt::print("  {} edges removed; {} of the triangles ({:.1f} %) were in a concyclic pair\n",
                   answer["concyclic"]["edges"].get<Index>(),
                   answer["concyclic"]["faces"].get<Index>(),
                   answer["concyclic"]["percent"].get<double>());
    if (answer.contains("intrinsic"))
        return print_flips(answer["intrinsic"]);
    const auto& pairs = answer["pairs"];
    fmt::print("pairs of neighbors\n  {} well-centered, {} Delaunay, {} non-Delaunay, {} "
               "{}\n",
               pairs["well_centered"].get<Index>(), pairs["delaunay"].get<Index>(),
               pairs["non_delaunay"].get<Index>(), pairs["cospherical"].get<Index>(),
               answer["dimension"] == 2 ? "concyclic" : "cospherical");
}

void print_stars(const Json& answer) {
    fmt::print("Hodge stars after merging\n  {:<7}{:>14}{:>14}{:>14}{:>10}{:>8}{:>12}{:>14}\n",
               "degree", "min", "max", "min abs", "negative", "zero", "condition", "(before)");
    const auto condition = [](const Json& star) {
        return star["condition"].is_null() ? std::string("infinite")
                                           : fmt::format("{:.3g}", star["condition"].get<double>());
    };
    for (std::size_t k = 0; k < answer["stars"].size(); ++k) {
        const auto& star = answer["stars"][k];
        fmt::print("  {:<7}{:>14.6g}{:>14.6g}{:>14.6g}{:>10}{:>8}{:>12}{:>14}\n", k,
                   star["min"].get<double>(), star["max"].get<double>(),
                   star["min_abs"].get<double>(), star["negative"].get<Index>(),
                   star["zero"].get<Index>(), condition(star), condition(answer["input_stars"][k]));
    }
}

bool everywhere_yes(const Json& row) {
    for (const char* stage : {"input", "merged"})
        for (const auto& verdict : row[stage])
            if (verdict != "yes")
                return false;
    return true;
}

/// The verdicts as a table in which what always holds is left out.
void print_operators(const Json& answer) {
    std::vector<std::string> lines;
    const auto cell = [](const Json& verdicts, const char* side) {
        return verdicts.contains(side) ? verdicts[side].get<std::string>() : std::string("-");
    };
    for (const auto& row : answer["operators"]) {
        if (everywhere_yes(row))
            continue;
        const auto name = row["operator"].get<std::string>();
        const bool graded = name.find(' ') == std::string::npos;
        lines.push_back(
            fmt::format("  {:<18}{:>14}{:>14}{:>16}{:>14}\n",
                        graded ? fmt::format("{} {}", name, row["degree"].get<int>()) : name,
                        cell(row["input"], "primal"), cell(row["input"], "dual"),
                        cell(row["merged"], "primal"), cell(row["merged"], "dual")));
    }
    if (lines.empty()) {
        fmt::print("operators\n  all are well defined, before and after merging\n");
        return;
    }
    fmt::print("operators that are not well defined everywhere\n  {:<18}{:>14}{:>14}{:>16}{:>14}\n"
               "{}",
               "", "input primal", "dual", "merged primal", "dual", fmt::join(lines, ""));
}

/// What the stars allow for the Laplacian on forms that live on the k-cells.
std::string verdict(const Json& stars, int k) {
    const auto negative = [&](int j) {
        return j >= 0 && j < static_cast<int>(stars.size()) ? stars[j]["negative"].get<Index>() : 0;
    };
    if (negative(k) > 0 || stars[k]["zero"] > 0)
        return "no, the mass is not positive";
    if (k > 0 && stars[k - 1]["zero"] > 0)
        return "no, an inverse star divides by zero";
    const Index spurious = negative(k - 1) + (k == 0 ? 0 : negative(k + 1));
    if (spurious > 0)
        return fmt::format("yes, but {} negative duals make about as many spurious negative "
                           "eigenvalues",
                           spurious);
    return "yes";
}

void print_advice(const Json& answer) {
    const int n = answer["dimension"];
    fmt::print("spectra\n");
    for (int k = 0; k <= n; ++k)
        fmt::print("  primal {}-forms, dual {}-forms: {}\n", k, n - k, verdict(answer["stars"], k));
    for (const auto& text : answer["advice"])
        fmt::print("{}\n", text.get<std::string>());
}

void run(const MeshArguments& arguments) {
    Timing timing;
    const Discretization mesh = load(arguments, timing);
    Json answer = describe(mesh, timing);
    add_timing(answer, arguments, timing);
    if (arguments.json) {
        fmt::print("{}\n", answer.dump());
        return;
    }
    fmt::print("{}\n", arguments.mesh.string());
    print_cells(answer);
    print_topology(answer);
    print_duals(answer);
    print_stars(answer);
    print_operators(answer);
    print_advice(answer);
    print_timing(arguments, timing);
}

} // namespace

void add_info(CLI::App& app) {
    auto* command = app.add_subcommand("info", "what the mesh is and what DEC can do on it");
    const auto arguments = std::make_shared<MeshArguments>();
    add_mesh_arguments(*command, *arguments, JsonOption::offered);
    command->footer("Examples:\n  polydec info fandisk.off\n  polydec info bunny.ply --delaunay");
    command->callback([arguments] { run(*arguments); });
}

} // namespace polydec::tools
