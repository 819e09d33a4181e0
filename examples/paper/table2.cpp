// SPDX-License-Identifier: MIT
//
// Table 2: the number of triangles in concyclic pairs in published meshes, by the paper's test and
// by ours.
#include "examples/paper/problems.h"
#include "examples/paper/reproductions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <numbers>

namespace polydec::paper {

namespace {

namespace fs = std::filesystem;

/// The angles opposite the edge sum to pi within 2 pi 1e-4.
const DiscretizeOptions papers_test{.criterion = MergeCriterion::angle,
                                    .tolerance = 2e-4 * std::numbers::pi};

struct Source {
    std::string name;
    std::function<Mesh()> mesh;
};

bool is_mesh_file(const fs::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    // either of TetGen's two files names the mesh
    constexpr std::array known{".off", ".obj", ".ply", ".stl", ".mesh",
                               ".nsc", ".msh", ".ele", ".vtk", ".vtu"};
    return std::find(known.begin(), known.end(), extension) != known.end();
}

/// The mesh files below a folder, sorted.
std::vector<Source> sources_in(const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> files;
    fs::recursive_directory_iterator entry(folder, error);
    for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error))
        if (is_mesh_file(entry->path()))
            files.push_back(entry->path());
    if (error)
        throw IoError(
            fmt::format("cannot read the folder {}: {}", folder.string(), error.message()));
    if (files.empty())
        throw InvalidInput(fmt::format("the folder {} holds no file with the extension of a mesh: "
                                       "expected .off, .obj, .ply, .stl or another that polydec "
                                       "reads",
                                       folder.string()));
    std::sort(files.begin(), files.end());
    std::vector<Source> sources;
    for (const auto& file : files)
        sources.push_back(
            {file.lexically_relative(folder).generic_string(), [file] { return read_mesh(file); }});
    return sources;
}

std::vector<Source> generated_sources() {
    return {{"regular plane", [] { return grid(50, 50); }},
            {"plane in general position", [] { return perturbed(grid(50, 50), 0.005, 1); }},
            {"plane of hexagons", [] { return hexagons(32); }},
            {"plane of acute triangles", [] { return well_centered(25); }},
            {"UV sphere", [] { return uv_sphere(64, 32); }},
            {"sphere of hexagons", [] { return goldberg(12); }},
            {"sphere of triangles", [] { return icosphere(16); }},
            {"torus", [] { return torus(64, 32); }},
            {"Moebius strip", [] { return moebius(128, 8); }},
            {"flange", [] { return flange(48); }}};
}

struct Counts {
    long faces = 0;
    std::array<MergedPairs, 2> pairs = {}; ///< by the paper's test and by ours

    void add(const Counts& other) {
        faces += other.faces;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            pairs[i].facets += other.pairs[i].facets;
            pairs[i].simplices += other.pairs[i].simplices;
        }
    }

    std::vector<Entry> row(const std::string& name) const {
        std::vector<Entry> entries{name, faces};
        for (const auto& pair : pairs) {
            entries.emplace_back(long{pair.facets});
            entries.emplace_back(long{pair.simplices});
            entries.emplace_back(faces > 0 ? 100.0 * pair.simplices / static_cast<double>(faces)
                                           : none);
        }
        entries.emplace_back(std::string());
        return entries;
    }
};

Counts count(const Source& source) {
    Mesh mesh = source.mesh();
    if (mesh.dimension() != 2)
        throw InvalidInput(
            fmt::format("cells of dimension {}; the table is about surfaces", mesh.dimension()));
    const auto ours = discretized(std::move(mesh));
    const auto papers = merge_cospherical(ours.input_geometry(), papers_test);
    return {ours.input().size(2), {merged_pairs(papers.merging), merged_pairs(ours.merging())}};
}

/// An error message without the file, shown beside it, and without the advice.
std::string reason(const std::string& message, const fs::path& folder, const std::string& name) {
    std::string text = message;
    const std::string path = (folder / name).string();
    if (const auto at = text.find(path); at != std::string::npos)
        text.erase(at, path.size());
    text = text.substr(0, text.find_first_of(";\n"));
    text.erase(0, text.find_first_not_of(" :"));
    return text;
}

} // namespace

Report table2(const Request& request) {
    const bool generated = request.meshes.empty();
    const auto sources = generated ? generated_sources() : sources_in(request.meshes);
    Table table{"meshes",
                "triangles that belong to a concyclic pair",
                {"mesh", "faces", "edges (paper)", "faces (paper)", "% (paper)", "edges (ours)",
                 "faces (ours)", "% (ours)", "not counted because"},
                {}};
    Counts totals;
    long left_out = 0;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        if (request.progress)
            request.progress(fmt::format("{} of {}: {}", i + 1, sources.size(), sources[i].name));
        try {
            const auto counts = count(sources[i]);
            totals.add(counts);
            table.rows.push_back(counts.row(sources[i].name));
        } catch (const Error& error) {
            ++left_out;
            std::vector<Entry> row(table.columns.size(), none);
            row.front() = sources[i].name;
            row.back() = reason(error.what(), request.meshes, sources[i].name);
            table.rows.push_back(std::move(row));
        }
    }
    table.rows.push_back(totals.row("all"));

    Report report{.name = "table2",
                  .title = "Prevalence of concyclic triangles (Table 2)",
                  .tables = {std::move(table)}};
    report.remarks.emplace_back(
        "By the paper's test the angles opposite to an edge add up to pi within 2 pi 1e-4; by ours "
        "the dual edge is at most 1e-4 times as long as the edge.");
    report.remarks.emplace_back(
        "Counted are the edges that merging removes and the triangles beside them. Pairs that it "
        "leaves, since they would make no proper cell, are not counted, nor triangles without "
        "area.");
    if (generated)
        report.remarks.emplace_back("No folder of mesh files was given, so these meshes are "
                                    "generated; only the regular plane is one of the paper's.");
    if (left_out > 0)
        report.remarks.push_back(
            fmt::format("{} of {} files are not counted.", left_out, sources.size()));
    return report;
}

} // namespace polydec::paper
