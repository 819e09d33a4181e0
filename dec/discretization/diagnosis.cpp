// SPDX-License-Identifier: MIT
#include "dec/discretization/diagnosis.h"

#include "complex/components.h"
#include "complex/homology.h"
#include "dec/stars/star.h"
#include "meshes/unit_of_length.h"

#include <algorithm>

namespace polydec {

namespace {

std::vector<Index> cell_counts(const CellComplex& complex) {
    std::vector<Index> counts;
    for (int k = 0; k <= complex.dimension(); ++k)
        counts.push_back(complex.size(k));
    return counts;
}

StarNumbers star_numbers(const HodgeStar& star, double unit) {
    const Vector values = star.is_diagonal() ? star.diagonal() : Vector(star.matrix().diagonal());
    const int power = star.dimension() - 2 * star.degree();
    StarNumbers numbers{star.is_diagonal(),
                        in_input_units(values.minCoeff(), unit, power),
                        in_input_units(values.maxCoeff(), unit, power),
                        in_input_units(values.cwiseAbs().minCoeff(), unit, power),
                        star.negatives().size(),
                        star.zeros().size(),
                        {}};
    if (star.is_diagonal() && numbers.zero == 0)
        numbers.condition = values.cwiseAbs().maxCoeff() / values.cwiseAbs().minCoeff();
    return numbers;
}

std::vector<StarNumbers> star_numbers(const HodgeStars& stars, double unit) {
    std::vector<StarNumbers> list;
    for (int k = 0; k <= stars.dimension(); ++k)
        list.push_back(star_numbers(stars[k], unit));
    return list;
}

/// One per degree: primal k-forms and dual (n-k)-forms have the same matrix.
std::vector<LaplacianVerdict>
laplacian_verdicts(const Discretization& mesh,
                   const BeforeAndAfter<std::vector<OperatorVerdict>>& operators) {
    const auto primal = spectrum_verdicts(mesh, Side::primal);
    const auto dual = spectrum_verdicts(mesh, Side::dual);
    std::vector<LaplacianVerdict> list;
    for (std::size_t i = 0; i < operators.merged.size(); ++i) {
        const auto& merged = operators.merged[i];
        const int k = merged.degree;
        if (merged.name == "laplacian" && merged.side == Side::primal)
            list.push_back({k,
                            operators.input[i].verdict,
                            merged.verdict,
                            reason(merged),
                            {primal[k], dual[k]}});
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

void examine_topology(const Discretization& mesh, Diagnosis& found) {
    const auto& K = mesh.input();
    const auto& P = mesh.complex();
    found.cells = {cell_counts(K), cell_counts(P)};
    found.euler = {euler_characteristic(K), euler_characteristic(P)};
    const auto betti = betti_numbers(K);
    found.betti = {betti, mesh.merging().is_identity() ? betti : betti_numbers(P)};
    found.components = components(K).count;
    found.boundary_components = boundary_components(K).count;
    found.orientable = K.orientable();
    if (mesh.measured_input_points().cols() > 0)
        found.unjoined = unjoined_boundary(K, mesh.measured_input_points());
    found.vertices_per_cell = vertices_per_cell(mesh);
}

void examine_metric(const Discretization& mesh, Diagnosis& found) {
    found.volume = in_input_units(mesh.volumes().primal(mesh.dimension()).sum(), mesh.unit(),
                                  mesh.dimension());
    found.degenerate = mesh.degenerate();
    found.merged_pairs = merged_pairs(mesh.merging());
    if (mesh.options().centers.are_circumcenters())
        found.looser = looser_tolerance(mesh.geometry(), mesh.options());
    if (mesh.options().delaunay != Delaunay::off)
        found.flips = flip_numbers(mesh);
    else
        found.pairs = facet_kinds(mesh.input_geometry(), mesh.options());
    found.stars = {star_numbers(mesh.input_geometry().volumes(), mesh.unit()),
                   star_numbers(mesh.stars(), mesh.unit())};
    found.operators = {operator_verdicts(mesh, Stage::input),
                       operator_verdicts(mesh, Stage::merged)};
    found.laplacians = laplacian_verdicts(mesh, found.operators);
    found.advice = advice(mesh);
}

/// Whether numbers are missing because doubles cannot hold them.
bool lacks_numbers(const Diagnosis& found) {
    const auto lacks = [](const StarNumbers& star) {
        return !star.min || !star.max || !star.min_abs;
    };
    const auto& [input, merged] = found.stars;
    return !found.volume || std::any_of(merged.begin(), merged.end(), lacks) ||
           std::any_of(input.begin(), input.end(), lacks);
}

} // namespace

Diagnosis diagnose(const Discretization& discretization, const Progress& stage) {
    Diagnosis found;
    found.dimension = discretization.dimension();
    if (discretization.ambient_dimension() > 0)
        found.ambient_dimension = discretization.ambient_dimension();
    if (stage)
        stage("topology");
    examine_topology(discretization, found);
    if (stage)
        stage("operators");
    examine_metric(discretization, found);
    if (lacks_numbers(found))
        found.warnings.emplace_back("left out volumes that are outside the range of double "
                                    "precision in the units of the file");
    return found;
}

} // namespace polydec
