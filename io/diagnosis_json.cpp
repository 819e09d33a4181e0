// SPDX-License-Identifier: MIT
#include "io/diagnosis_json.h"

namespace polydec {

namespace {

template <class Value>
void write(JsonWriter& json, const char* name, const BeforeAndAfter<Value>& both) {
    json.object(name, [&] {
        json.member("input", both.input);
        json.member("merged", both.merged);
    });
}

void write(JsonWriter& json, const DegenerateFacets& facets) {
    json.member("degenerate", facets.interior);
    json.member("boundary_degenerate", facets.boundary);
    json.member("branching_degenerate", facets.branching);
}

void write(JsonWriter& json, const FlipNumbers& flips) {
    const auto& done = flips.statistics;
    json.member("negative_before", done.negative_before);
    json.member("negative_boundary_before", done.negative_boundary_before);
    json.member("flips", done.flips);
    json.member("splits", done.splits);
    json.member("negative", done.negative_interior);
    json.member("negative_boundary", done.negative_boundary);
    json.member("added_length", done.added_length);
    json.member("cells", flips.cells);
}

void write(JsonWriter& json, const FacetKinds& pairs) {
    json.member("well_centered", pairs.well_centered);
    json.member("delaunay", pairs.delaunay);
    json.member("non_delaunay", pairs.non_delaunay);
    json.member("cospherical", pairs.cospherical);
}

void write(JsonWriter& json, const char* stage, const OperatorRow::Sides& verdicts) {
    json.object(stage, [&] {
        for (const OperatorVerdict* verdict : verdicts)
            if (verdict != nullptr)
                json.member(name(verdict->side), name(verdict->verdict));
    });
}

void write(JsonWriter& json, const OperatorRow& row) {
    json.member("operator", row.name);
    json.member("degree", row.degree);
    write(json, "input", row.sides.input);
    write(json, "merged", row.sides.merged);
}

/// Indefinite: with negative eigenvalues.
const char* word(const SpectrumVerdict& verdict) {
    return !verdict.exists ? "no" : verdict.reason.empty() ? "yes" : "indefinite";
}

void write(JsonWriter& json, const LaplacianVerdict& facts) {
    json.member("degree", facts.degree);
    json.member("matrix", name(facts.matrix));
    json.member("spectrum", word(facts.spectrum(Side::primal)));
    json.member("reason", facts.reason(Side::primal));
    json.member("dual_spectrum", word(facts.spectrum(Side::dual)));
    json.member("dual_reason", facts.reason(Side::dual));
}

} // namespace

void write_star_numbers(JsonWriter& json, const char* name, const std::vector<StarNumbers>& stars) {
    json.objects(name, stars, [&](const StarNumbers& star) {
        json.member("min", star.min);
        json.member("max", star.max);
        json.member("min_abs", star.min_abs);
        json.member("negative", star.negative);
        json.member("zero", star.zero);
        json.member("condition", star.condition);
        json.member("diagonal", star.is_diagonal);
    });
}

std::vector<OperatorRow> operator_rows(const Diagnosis& facts) {
    std::vector<OperatorRow> rows;
    for (std::size_t i = 0; i < facts.operators.merged.size(); ++i) {
        const auto& merged = facts.operators.merged[i];
        if (rows.empty() || rows.back().name != merged.name || rows.back().degree != merged.degree)
            rows.push_back({merged.name, merged.degree});
        const int side = merged.side == Side::primal ? 0 : 1;
        rows.back().sides.input[side] = &facts.operators.input[i];
        rows.back().sides.merged[side] = &merged;
    }
    return rows;
}

double percent_of_pairs(const Diagnosis& facts) {
    const Index triangles = facts.flips ? facts.flips->cells[2] : facts.cells.input[2];
    return 100.0 * facts.merged_pairs.simplices / triangles;
}

void write_diagnosis(JsonWriter& json, const Diagnosis& facts,
                     const std::vector<std::string>& advice) {
    json.member("dimension", facts.dimension);
    json.member("ambient_dimension", facts.ambient_dimension);
    write(json, "cells", facts.cells);
    write(json, "euler", facts.euler);
    write(json, "betti", facts.betti);
    json.member("components", facts.components);
    json.member("boundary_components", facts.boundary_components);
    json.member("orientable", facts.orientable);
    json.object("unjoined", [&] {
        json.member("coincident", facts.unjoined.coincident.size());
        json.member("hanging", facts.unjoined.hanging.size());
        json.member("misfits", facts.unjoined.misfits);
    });
    json.member("volume", facts.volume);
    json.object("facets", [&] { write(json, facts.degenerate); });
    if (facts.flips)
        json.object("intrinsic", [&] { write(json, *facts.flips); });
    else
        json.object("pairs", [&] { write(json, *facts.pairs); });
    write_star_numbers(json, "stars", facts.stars.merged);
    write_star_numbers(json, "input_stars", facts.stars.input);
    const auto write_entry = [&](const auto& entry) { write(json, entry); };
    json.objects("operators", operator_rows(facts), write_entry);
    json.objects("laplacians", facts.laplacians, write_entry);
    json.object("vertices_per_cell", [&] {
        for (const auto& [vertices, cells] : facts.vertices_per_cell)
            json.member(std::to_string(vertices), cells);
    });
    if (facts.dimension == 2)
        json.object("concyclic", [&] {
            json.member("edges", facts.merged_pairs.facets);
            json.member("faces", facts.merged_pairs.simplices);
            json.member("percent", percent_of_pairs(facts));
        });
    if (facts.looser)
        json.object("looser_tolerance", [&] {
            json.member("tolerance", facts.looser->tolerance);
            json.member("pairs", facts.looser->pairs);
        });
    json.member("advice", advice);
}

void write_stars(JsonWriter& json, const ChosenStars& stars) {
    json.object("star", [&] {
        json.member("kind", name(stars.kind));
        json.member("galerkin_share", stars.galerkin_share());
    });
}

} // namespace polydec
