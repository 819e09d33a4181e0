// SPDX-License-Identifier: MIT
#include "tests/dec/discretized.h"

namespace polydec::test::in_diagnosis {

FacetKinds kinds(const Mesh& mesh) {
    const auto bundle = circumcentric(mesh);
    return facet_kinds(bundle.input_geometry(), bundle.options());
}

TEST(Kinds, of_a_pair_go_by_its_angles) {
    EXPECT_EQ(counts(kinds(kite(2, 2))), (std::vector<Index>{1, 0, 0, 0}));
    EXPECT_EQ(counts(kinds(kite(2, 0.9))), (std::vector<Index>{0, 1, 0, 0}));
    EXPECT_EQ(counts(kinds(kite(2, 1))), (std::vector<Index>{1, 0, 0, 0})) << "on the edge";
    EXPECT_EQ(counts(kinds(kite(0.8, 0.9))), (std::vector<Index>{0, 0, 1, 0}));
    EXPECT_EQ(counts(kinds(kite(2, 0.5))), (std::vector<Index>{0, 0, 0, 1}));
}

TEST(Kinds, of_generated_meshes_are_what_they_were_made_for) {
    EXPECT_EQ(kinds(well_centered(4)).well_centered,
              kinds(well_centered(4)).well_centered + kinds(well_centered(4)).cospherical);
    EXPECT_EQ(counts(kinds(grid(4, 4))), (std::vector<Index>{24, 0, 0, 16}));
    EXPECT_GT(kinds(perturbed(grid(8, 8), 0.25, 1)).non_delaunay, 0);
}

class KindsOf : public OverMeshes {};

TEST_P(KindsOf, all_pairs_are_one_of_four) {
    const auto& m = mesh();
    const auto all = counts(facet_kinds(m.geometry(), {.tolerance = tolerance}));
    const auto& cofaces = m.K().coface_counts(m.n() - 1);
    EXPECT_EQ(std::accumulate(all.begin(), all.end(), Index{0}),
              std::count(cofaces.begin(), cofaces.end(), 2));
}

TEST_P(KindsOf, cospherical_pairs_are_those_that_merge_unless_a_guard_forbids) {
    const auto& m = mesh();
    const auto before = facet_kinds(m.geometry(), {.tolerance = tolerance});
    const auto merged = merged_pairs(m.merging());
    EXPECT_LE(merged.facets, before.cospherical);
    EXPECT_LE(merged.simplices, 2 * merged.facets);
    // each cell of P that has m pieces takes at least m - 1 facets away
    EXPECT_GE(merged.facets, m.K().size(m.n()) - m.P().size(m.n()));
    EXPECT_GE(merged.simplices, 2 * (merged.facets > 0));
    const auto none = merged_pairs(Merging(m.K()));
    EXPECT_EQ(none.facets, 0);
    EXPECT_EQ(none.simplices, 0);
}

POLYDEC_OVER_MESHES(KindsOf);

TEST(MergedPairs, count_removed_edges_and_the_triangles_beside_them) {
    const auto squares = merged_pairs(circumcentric(grid(4, 3)).merging());
    EXPECT_EQ(squares.facets, 12);
    EXPECT_EQ(squares.simplices, 24);
    // a hexagon of four triangles has three diagonals
    const double r = std::sqrt(5.0);
    const auto fans =
        merged_pairs(circumcentric(made_of({{r, 0}, {1, 2}, {-1, 2}, {-r, 0}, {-1, -2}, {1, -2}},
                                           {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}))
                         .merging());
    EXPECT_EQ(fans.facets, 3);
    EXPECT_EQ(fans.simplices, 4);
}

using Verdicts = std::map<std::string, std::string>;

/// "star 1 dual" -> "no", for what is not well defined.
Verdicts failures(const Discretization& bundle, Stage stage) {
    Verdicts result;
    for (const auto& verdict : operator_verdicts(bundle, stage))
        if (verdict.verdict != WellDefined::yes)
            result[fmt::format("{} {} {}", verdict.name, verdict.degree, name(verdict.side))] =
                name(verdict.verdict);
    return result;
}

/// Table 1 of the paper, and what its section 5 says of the Laplacians. The sharps, which the paper
/// leaves open on polygons, are there.
const Verdicts table_1 = {{"star 1 dual", "no"},           {"star 2 primal", "restricted"},
                          {"codifferential 1 dual", "no"}, {"codifferential 2 primal", "no"},
                          {"laplacian 0 dual", "no"},      {"laplacian 1 dual", "no"},
                          {"laplacian 1 primal", "no"},    {"laplacian 2 primal", "no"},
                          {"flat dpp 1 dual", "no"}};

TEST(Table1, comes_out_on_every_surface_with_concyclic_triangles) {
    for (const auto& mesh : {grid(4, 4), uv_sphere(12, 6), torus(9, 5), goldberg(2)}) {
        const auto bundle = circumcentric(mesh);
        EXPECT_EQ(failures(bundle, Stage::input), table_1);
        EXPECT_EQ(failures(bundle, Stage::merged), Verdicts{});
        const auto plain = circumcentric(mesh, {.criterion = MergeCriterion::none});
        EXPECT_EQ(failures(plain, Stage::input), table_1);
        EXPECT_EQ(failures(plain, Stage::merged), table_1) << "nothing is merged";
    }
}

TEST(Table1, has_no_failures_where_nothing_is_concyclic) {
    for (const auto& mesh : {well_centered(4), icosphere(4)})
        for (const Stage stage : {Stage::input, Stage::merged})
            EXPECT_EQ(failures(circumcentric(mesh), stage), Verdicts{});
}

TEST(Table1, does_not_forget_vertices_whose_dual_area_vanishes) {
    const auto found = failures(circumcentric(fan_without_dual()), Stage::merged);
    EXPECT_EQ(found.count("star 0 dual"), 1U);
    EXPECT_EQ(found.count("laplacian 0 primal"), 1U);
    EXPECT_EQ(found.count("sharp pp 1 primal"), 1U);
}

TEST(Table1, in_space_is_cured_down_to_the_edges) {
    const auto bundle = circumcentric(kuhn(3, 2));
    EXPECT_EQ(failures(bundle, Stage::input).count("star 1 dual"), 1U);
    EXPECT_EQ(failures(bundle, Stage::input).count("star 2 dual"), 1U);
    EXPECT_EQ(failures(bundle, Stage::merged), Verdicts{});
}

TEST(Verdicts, tell_their_reason) {
    for (const auto& verdict : operator_verdicts(circumcentric(grid(4, 4)), Stage::input)) {
        if (verdict.name == "star" && verdict.side == Side::dual && verdict.degree == 1) {
            EXPECT_EQ(verdict.cell_degree, 1);
            EXPECT_EQ(verdict.cells, 16);
            EXPECT_SAYS(reason(verdict), "divides", "16", "1-cells", "dual without volume");
        }
        if (verdict.name == "star" && verdict.side == Side::primal && verdict.degree == 2) {
            EXPECT_SAYS(reason(verdict), "32", "2-cells", "dual");
        }
        if (verdict.name == "d") {
            EXPECT_EQ(reason(verdict), "");
        }
    }
}

TEST(SpectrumVerdicts, name_what_spoils_a_spectrum) {
    const auto mesh = circumcentric(grid(4, 4));
    const auto before = spectrum_verdicts(mesh.input_geometry().volumes());
    ASSERT_EQ(before.size(), 3U);
    EXPECT_TRUE(before[0].exists);
    EXPECT_FALSE(before[1].exists);
    EXPECT_SAYS(before[1].reason, "mass", "16 1-cells", "dual", "volume");
    EXPECT_FALSE(before[2].exists);
    EXPECT_SAYS(before[2].reason, "inverse star", "zero", "16 1-cells", "volume");
    for (const auto& verdict : spectrum_verdicts(mesh.volumes())) {
        EXPECT_TRUE(verdict.exists);
        EXPECT_EQ(verdict.reason, "");
    }
    const auto flat =
        circumcentric(made_of({{-1, 0}, {1, 0}, {0, 0.5}, {0, -0.5}}, {{0, 1, 2}, {0, 3, 1}}));
    const auto verdicts = spectrum_verdicts(flat.volumes());
    EXPECT_FALSE(verdicts[1].exists);
    EXPECT_SAYS(verdicts[1].reason, "mass", "1 1-cell", "negative");
    EXPECT_TRUE(verdicts[2].exists);
    EXPECT_SAYS(verdicts[2].reason, "1 negative", "eigenvalue");
}

Index alternating(const std::vector<Index>& numbers) {
    Index sum = 0;
    for (std::size_t k = numbers.size(); k-- > 0;)
        sum = numbers[k] - sum;
    return sum;
}

/// The first fact of a diagnosis that is not what is counted otherwise; empty if all are right.
std::string wrong_fact(const Diagnosis& told, const Mesh& mesh, const Discretization& bundle) {
    const int n = told.dimension;
    for (int k = 0; k <= n; ++k) {
        if (told.cells.input[k] != static_cast<Index>(faces(mesh, k).size()) ||
            told.cells.merged[k] != bundle.volumes().primal(k).size())
            return "cells";
        const Vector stars = star(bundle.volumes(), k).diagonal();
        if (told.stars.merged[k].min != stars.minCoeff() ||
            told.stars.merged[k].negative + told.stars.merged[k].zero <
                static_cast<std::size_t>((stars.array() < 0).count()))
            return "stars";
    }
    if (told.euler.input != alternating(told.cells.input) ||
        told.euler.merged != alternating(told.betti.merged) ||
        told.betti.input != told.betti.merged)
        return "topology";
    if (told.components != told.betti.input[0])
        return "components";
    if (!(std::abs(*told.volume - total_volume(mesh)) < 1e-12 * total_volume(mesh)))
        return "volume";
    Index cells = 0;
    for (const auto& [vertices, count] : told.vertices_per_cell)
        cells += vertices > static_cast<std::size_t>(n) ? count : 0;
    if (cells != told.cells.merged[n])
        return "vertices of cells";
    const auto kinds = counts(*told.pairs);
    const auto& cofaces = bundle.input().coface_counts(n - 1);
    if (std::accumulate(kinds.begin(), kinds.end(), Index{0}) !=
        std::count(cofaces.begin(), cofaces.end(), 2))
        return "pairs";
    for (const auto& laplacian : told.laplacians)
        for (const auto& verdict : told.operators.merged)
            if (verdict.name == "laplacian" && verdict.side == Side::primal &&
                verdict.degree == laplacian.degree && verdict.verdict != laplacian.matrix)
                return "laplacians";
    return static_cast<int>(told.laplacians.size()) == n + 1 ? "" : "laplacians";
}

class DiagnosisOf : public OverMeshes {
protected:
    const Mesh& given() const { return mesh_named(GetParam()); }
};

TEST_P(DiagnosisOf, tells_what_is_counted_otherwise) {
    const auto bundle = circumcentric(given());
    EXPECT_EQ(wrong_fact(diagnose(bundle), given(), bundle), "");
}

TEST_P(DiagnosisOf, is_found_wrong_by_any_fact_that_is) {
    const auto bundle = circumcentric(given());
    const auto broken = [&](const std::function<void(Diagnosis&)>& spoil) {
        auto told = diagnose(bundle);
        spoil(told);
        return wrong_fact(told, given(), bundle);
    };
    EXPECT_EQ(broken([](auto& told) { ++told.cells.input.back(); }), "cells");
    EXPECT_EQ(broken([](auto& told) { *told.stars.merged[0].min *= 2; }), "stars");
    EXPECT_EQ(broken([](auto& told) { ++told.betti.merged[0]; }), "topology");
    EXPECT_EQ(broken([](auto& told) { ++told.components; }), "components");
    EXPECT_EQ(broken([](auto& told) { *told.volume *= 1 + 1e-9; }), "volume");
    EXPECT_EQ(broken([](auto& told) { ++told.vertices_per_cell[99]; }), "vertices of cells");
    EXPECT_EQ(broken([](auto& told) { ++told.pairs->delaunay; }), "pairs");
    EXPECT_EQ(broken([](auto& told) { told.laplacians.pop_back(); }), "laplacians");
}

TEST_P(DiagnosisOf, advises_where_duals_are_not_positive_what_makes_stars_so) {
    const auto plain = circumcentric(given());
    const auto list = diagnose(plain).advice;
    ASSERT_EQ(list.size(), not_positive(plain) == 0 ? 0U : 1U);
    if (list.empty())
        return;
    // who does nothing is told the same again
    const auto idle = discretize(given(), with(Remedy::none, plain.options()));
    EXPECT_EQ(diagnose(idle).advice.front().remedy, list.front().remedy);
    const auto better = discretize(given(), with(list.front().remedy, plain.options()));
    EXPECT_EQ(not_positive(better), 0U) << option(list.front().remedy);
    EXPECT_TRUE(diagnose(better).advice.empty());
}

TEST_P(DiagnosisOf, warns_of_hybrid_stars_where_duals_can_be_made_positive) {
    const auto plain = circumcentric(given());
    const auto chosen = discretize(given());
    const auto cure = remedy(plain);
    const bool is_hybrid = chosen.chosen_stars().kind == StarKind::hybrid;
    const bool has_cure = (cure == Remedy::flips || cure == Remedy::splits) &&
                          !star(plain.volumes(), 1).negatives().empty();
    std::size_t told = 0;
    for (const auto& warning : chosen.warnings())
        told += says(warning, {"hybrid", option(cure)}) ? 1 : 0;
    EXPECT_EQ(told, is_hybrid && has_cure ? 1U : 0U);
    EXPECT_EQ(remedy(chosen), is_hybrid && has_cure ? cure : Remedy::none);
}

/// Degrees and sides whose Laplacian has no spectrum, or one with negative eigenvalues.
int number_spoiled(const Diagnosis& told) {
    int count = 0;
    for (const auto& laplacian : told.laplacians)
        for (const auto& spectrum : laplacian.spectra)
            count += !spectrum.exists || !spectrum.reason.empty();
    return count;
}

TEST_P(DiagnosisOf, finds_nothing_spoiled_by_stars_that_are_positive) {
    const auto plain = circumcentric(given());
    const bool is_cut = branches(plain.complex());
    EXPECT_LE(number_spoiled(diagnose(plain)) > 0, not_positive(plain) > 0 || is_cut);
    for (const StarKind kind : {StarKind::automatic, StarKind::galerkin, StarKind::barycentric}) {
        const auto told = diagnose(discretize(given(), {.star = kind}));
        EXPECT_EQ(number_spoiled(told), is_cut ? 1 : 0) << name(kind);
        EXPECT_TRUE(told.advice.empty()) << name(kind);
        for (const auto& laplacian : told.laplacians)
            EXPECT_EQ(laplacian.matrix, WellDefined::yes) << name(kind);
        for (const auto& star : told.stars.merged) {
            EXPECT_GT(*star.min, 0) << name(kind);
            EXPECT_EQ(star.is_diagonal, star.condition.has_value()) << name(kind);
        }
    }
}

POLYDEC_OVER_MESHES(DiagnosisOf);

} // namespace polydec::test::in_diagnosis
