// SPDX-License-Identifier: MIT
#include "tools/mesh_facts.h"

#include "complex/components.h"
#include "complex/homology.h"
#include "dec/forms/star.h"
#include "meshes/unit_of_length.h"
#include "tools/common.h"

#include <algorithm>
#include <utility>

namespace polydec::tools {

namespace {

std::vector<Index> cell_counts(const CellComplex& complex) {
    std::vector<Index> counts;
    for (int k = 0; k <= complex.dimension(); ++k)
        counts.push_back(complex.size(k));
    return counts;
}

StarNumbers star_numbers(const CellVolumes& volumes, double unit, int k) {
    const Vector values = star(volumes, k);
    const int power = volumes.dimension() - 2 * k;
    StarNumbers numbers{in_input_units(values.minCoeff(), unit, power),
                        in_input_units(values.maxCoeff(), unit, power),
                        in_input_units(values.cwiseAbs().minCoeff(), unit, power),
                        negative_star_cells(volumes, k).size(),
                        zero_star_cells(volumes, k).size(),
                        {}};
    if (numbers.zero == 0)
        numbers.condition = values.cwiseAbs().maxCoeff() / values.cwiseAbs().minCoeff();
    return numbers;
}

std::vector<StarNumbers> star_numbers(const CellVolumes& volumes, double unit) {
    std::vector<StarNumbers> list;
    for (int k = 0; k <= volumes.dimension(); ++k)
        list.push_back(star_numbers(volumes, unit, k));
    return list;
}

std::vector<OperatorFacts> operators(const Discretization& mesh) {
    std::vector<OperatorFacts> rows;
    for (const Stage stage : {Stage::input, Stage::merged})
        for (auto& verdict : operator_verdicts(mesh, stage)) {
            const auto same = [&](const OperatorFacts& row) {
                return row.name == verdict.name && row.degree == verdict.degree;
            };
            auto row = std::find_if(rows.begin(), rows.end(), same);
            if (row == rows.end())
                row = rows.insert(row, {verdict.name, verdict.degree, {}});
            auto& sides = stage == Stage::input ? row->sides.input : row->sides.merged;
            sides[verdict.side == Side::primal ? 0 : 1] = std::move(verdict);
        }
    return rows;
}

/// Why the operator has no verdict better than this.
std::string reason_of(const OperatorVerdict& verdict) {
    if (verdict.verdict == WellDefined::yes)
        return "";
    const auto cells = fmt::format("{} of the {}-cells {}", verdict.cells, verdict.cell_degree,
                                   verdict.cells == 1 ? "has" : "have");
    return verdict.verdict == WellDefined::no
               ? fmt::format("{} a dual without extent, by which it divides", cells)
               : fmt::format("{} the dual of another one", cells);
}

/// One for each degree: primal k-forms and dual (n-k)-forms have the same matrix.
std::vector<LaplacianFacts> laplacians(const Discretization& mesh,
                                       const std::vector<OperatorFacts>& operators) {
    const auto primal = spectrum_verdicts(mesh, Side::primal);
    const auto dual = spectrum_verdicts(mesh, Side::dual);
    std::vector<LaplacianFacts> list;
    for (const auto& row : operators) {
        if (row.name != "laplacian" || !row.sides.merged[0])
            continue;
        const auto& verdict = *row.sides.merged[0];
        list.push_back({row.degree,
                        row.sides.input[0]->verdict,
                        verdict.verdict,
                        reason_of(verdict),
                        {primal[row.degree], dual[row.degree]}});
    }
    return list;
}

std::map<std::size_t, Index> vertices_per_cell(const Discretization& mesh) {
    const int n = mesh.dimension();
    std::map<std::size_t, Index> histogram;
    for (Index cell = 0; cell < mesh.complex().size(n); ++cell)
        ++histogram[cell_vertices(mesh, n, cell).size()];
    return histogram;
}

FlipNumbers flip_numbers(const Discretization& mesh) {
    FlipNumbers numbers{mesh.passage().flips().statistics, cell_counts(mesh.pieces())};
    numbers.statistics.added_length *= mesh.unit();
    return numbers;
}

/// What would make negative duals positive, if there are any and something would.
std::vector<std::string> advice(const Discretization& mesh) {
    std::vector<std::string> list;
    if (!is_flippable(mesh) || mesh.options().delaunay == Delaunay::flips_and_splits)
        return list;
    Index inside = 0, boundary = 0;
    for (const Index e : negative_star_cells(mesh.volumes(), 1))
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

void examine_topology(const Discretization& mesh, MeshFacts& facts) {
    const auto& K = mesh.input();
    const auto& P = mesh.complex();
    facts.cells = {cell_counts(K), cell_counts(P)};
    facts.euler = {euler_characteristic(K), euler_characteristic(P)};
    facts.betti = {betti_numbers(K), betti_numbers(P)};
    facts.components = components(K).count;
    facts.boundary_components = boundary_components(K).count;
    facts.orientable = K.orientable();
    facts.vertices_per_cell = vertices_per_cell(mesh);
}

void examine_metric(const Discretization& mesh, MeshFacts& facts) {
    facts.volume = in_input_units(mesh.volumes().primal(mesh.dimension()).sum(), mesh.unit(),
                                  mesh.dimension());
    facts.facets = mesh.degenerate();
    if (!mesh.passage().is_identity())
        facts.flips = flip_numbers(mesh);
    else
        facts.pairs =
            facet_kinds(mesh.input(), mesh.metric(), mesh.input_volumes(), mesh.options());
    facts.stars = star_numbers(mesh.volumes(), mesh.unit());
    facts.input_stars = star_numbers(mesh.input_volumes(), mesh.unit());
    facts.operators = operators(mesh);
    facts.laplacians = laplacians(mesh, facts.operators);
    if (mesh.dimension() == 2)
        facts.concyclic = merged_pairs(mesh.merging());
    facts.advice = advice(mesh);
}

} // namespace

bool MeshFacts::lacks_numbers() const {
    const auto lacks = [](const StarNumbers& star) {
        return !star.min || !star.max || !star.min_abs;
    };
    return !volume || std::any_of(stars.begin(), stars.end(), lacks) ||
           std::any_of(input_stars.begin(), input_stars.end(), lacks);
}

MeshFacts examine(const Discretization& mesh, Timing& timing) {
    MeshFacts facts;
    facts.dimension = mesh.dimension();
    if (mesh.points().cols() > 0)
        facts.ambient_dimension = static_cast<int>(mesh.points().cols());
    timing.begin("topology");
    examine_topology(mesh, facts);
    timing.begin("operators");
    examine_metric(mesh, facts);
    return facts;
}

} // namespace polydec::tools
