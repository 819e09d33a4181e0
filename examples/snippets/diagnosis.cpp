// SPDX-License-Identifier: MIT
//
// The code on docs/diagnosis.md: the diagnosis, kinds of pairs, verdicts on operators, condition
// numbers.
#include <iostream>
#include <polydec.h>

namespace {

void diagnosis() {
    const auto mesh = polydec::perturbed(polydec::grid(8, 8), 0.02, 1);
    const auto given = polydec::discretize(mesh, {.star = polydec::StarKind::circumcentric});
    const auto told = polydec::diagnose(given);
    std::cout << told.cells.merged[2] << " cells, " << told.stars.merged[1].negative
              << " negative dual edges\n";
    for (const auto& advice : told.advice)
        std::cout << in_words(advice, told.dimension) << '\n';
    const auto options = with(told.advice.back().remedy, given.options());
    const auto better = polydec::diagnose(polydec::discretize(mesh, options));
    std::cout << better.stars.merged[1].negative << " negative dual edges, " << better.advice.size()
              << " pieces of advice\n";
}

void kinds_of_pairs() {
    for (const double noise : {0.0, 0.01}) {
        const auto mesh = polydec::discretize(polydec::perturbed(polydec::hexagons(16), noise, 3),
                                              {.star = polydec::StarKind::circumcentric});
        const auto kinds = polydec::facet_kinds(mesh.input_geometry());
        std::cout << kinds.well_centered << " well-centered, " << kinds.delaunay << " Delaunay, "
                  << kinds.non_delaunay << " non-Delaunay, " << kinds.cospherical << " concyclic\n";
    }
}

void verdicts() {
    const auto mesh =
        polydec::discretize(polydec::torus(24, 12), {.star = polydec::StarKind::circumcentric});
    for (const auto stage : {polydec::Stage::input, polydec::Stage::merged}) {
        std::cout << (stage == polydec::Stage::input ? "input: " : "merged:");
        for (const auto& verdict : polydec::operator_verdicts(mesh, stage))
            if (verdict.verdict != polydec::WellDefined::yes)
                std::cout << ' ' << polydec::name(verdict.side) << ' ' << verdict.name << ' '
                          << verdict.degree << " (" << polydec::name(verdict.verdict) << ')';
        std::cout << '\n';
    }
}

void condition_numbers() {
    const polydec::Mesh torus = polydec::perturbed(polydec::torus(24, 12), 1e-7, 1);
    for (const double tolerance : {1e-10, 1e-4}) {
        const auto mesh = polydec::discretize(
            torus, {.tolerance = tolerance, .star = polydec::StarKind::circumcentric});
        const polydec::Vector star = polydec::star(mesh, 1).diagonal().cwiseAbs();
        std::cout << "tolerance " << tolerance << ": condition of star_1 "
                  << star.maxCoeff() / star.minCoeff() << ", negative entries "
                  << polydec::star(mesh, 1).negatives().size() << '\n';
    }
}

void zero_vertex_dual() {
    // six spokes at 60 degrees, three short and three long by the ratio that makes the dual 0
    polydec::Mesh star;
    star.points = polydec::Points::Zero(7, 2);
    star.simplices.resize(6, 3);
    const double ratio = (1 + std::sqrt(0.75)) / 0.5;
    for (int i = 0; i < 6; ++i) {
        const double angle = i * std::acos(0.5), r = i % 2 == 0 ? 1 : ratio;
        star.points.row(i + 1) << r * std::cos(angle), r * std::sin(angle);
        star.simplices.row(i) << 0, i + 1, (i + 1) % 6 + 1;
    }
    const auto mesh = polydec::discretize(star, {.star = polydec::StarKind::circumcentric});
    std::cout << "ratio " << ratio << ": vertices without dual area";
    for (const auto v : polydec::star(mesh, 0).zeros())
        std::cout << ' ' << v;
    std::cout << '\n';
}

} // namespace

int main() {
    diagnosis();
    kinds_of_pairs();
    verdicts();
    condition_numbers();
    zero_vertex_dual();
}
