// SPDX-License-Identifier: MIT
#include "base/printable.h"
#include "dec/discretization/diagnosis.h"
#include "dec/surfaces/intrinsic_delaunay.h"
#include "io/diagnosis_json.h"
#include "tools/commands.h"
#include "tools/common.h"
#include "tools/messages.h"
#include "tools/outputs.h"
#include "tools/picture.h"

#include <fmt/ranges.h>

#include <utility>

namespace polydec::tools {

namespace {

std::vector<std::string> advice_in_words(const Diagnosis& facts) {
    std::vector<std::string> list;
    for (const auto& advice : facts.advice)
        list.push_back(told(in_words(advice, facts.dimension)));
    return list;
}

void write_cells(Text& text, const Diagnosis& facts) {
    const int n = facts.dimension;
    text("dimension {} {}, volume {}\n", n,
         facts.ambient_dimension ? fmt::format("in {} coordinates", *facts.ambient_dimension)
                                 : "given by edge lengths only",
         in_digits(facts.volume, 10));
    text("cells of degree 0 .. {}\n", n);
    text("  input    {}\n  merged   {}\n", fmt::join(facts.cells.input, ", "),
         fmt::join(facts.cells.merged, ", "));
    std::vector<std::string> sizes;
    for (const auto& [vertices, cells] : facts.vertices_per_cell)
        sizes.push_back(fmt::format("{} with {}", cells, vertices));
    text("  merged {}-cells by vertices: {}\n", n, fmt::join(sizes, ", "));
}

void write_topology(Text& text, const Diagnosis& facts) {
    text("topology\n");
    text("  Euler characteristic {}, Betti numbers {} ({} after merging)\n", facts.euler.input,
         fmt::join(facts.betti.input, ", "),
         facts.betti.merged == facts.betti.input ? "the same" : "changed");
    text("  components {}, of the boundary {}, {}\n", facts.components, facts.boundary_components,
         facts.orientable ? "orientable" : "not orientable");
    const auto& [coincident, hanging, misfits] = facts.unjoined;
    if (!coincident.empty() || !hanging.empty() || misfits > 0)
        text("  not joined on the boundary: {} coincident and {} hanging vertices, {} facets that "
             "lie on others\n",
             coincident.size(), hanging.size(), misfits);
}

void write_flips(Text& text, const IntrinsicStatistics& done) {
    text("intrinsic flips\n  {} negative dual edges before, and {} on the boundary; {} flips, "
         "{} splits\n  {} and {} negative ones are left\n",
         done.negative_before, done.negative_boundary_before, done.flips, done.splits,
         done.negative_interior, done.negative_boundary);
}

void write_duals(Text& text, const Diagnosis& facts) {
    text("degenerate dual edges\n  {} between two cells, {} on the boundary, {} at branching "
         "facets\n",
         facts.degenerate.interior, facts.degenerate.boundary, facts.degenerate.branching);
    if (facts.dimension == 2)
        text("  {} edges removed; {} of the triangles ({:.1f} %) were in a concyclic pair\n",
             facts.merged_pairs.facets, facts.merged_pairs.simplices, percent_of_pairs(facts));
    if (facts.looser)
        text("  {} more pairs of cells would merge with --tolerance {:.0e}\n", facts.looser->pairs,
             facts.looser->tolerance);
    if (facts.flips)
        return write_flips(text, facts.flips->statistics);
    const auto& pairs = *facts.pairs;
    text("pairs of neighbors\n  {} well-centered, {} Delaunay, {} non-Delaunay, {} {}\n",
         pairs.well_centered, pairs.delaunay, pairs.non_delaunay, pairs.cospherical,
         facts.dimension == 2 ? "concyclic" : "cospherical");
}

void write_stars(Text& text, const Diagnosis& facts, const ChosenStars& stars) {
    const bool is_plain = stars.kind == StarKind::circumcentric;
    text("Hodge stars after merging{}\n  {:<7}{:>14}{:>14}{:>14}{:>10}{:>8}{:>12}{:>14}\n",
         is_plain ? "" : ": " + in_words(stars), "degree", "min", "max", "min abs", "negative",
         "zero", "condition", "(before)");
    const auto condition = [](const StarNumbers& star) {
        return star.condition     ? fmt::format("{:.3g}", *star.condition)
               : star.is_diagonal ? std::string("infinite")
                                  : std::string("a matrix");
    };
    for (std::size_t k = 0; k < facts.stars.merged.size(); ++k) {
        const auto& star = facts.stars.merged[k];
        text("  {:<7}{:>14}{:>14}{:>14}{:>10}{:>8}{:>12}{:>14}\n", k, in_digits(star.min, 6),
             in_digits(star.max, 6), in_digits(star.min_abs, 6), star.negative, star.zero,
             condition(star), condition(facts.stars.input[k]));
    }
}

bool everywhere_yes(const OperatorRow& row) {
    for (const auto* stage : {&row.sides.input, &row.sides.merged})
        for (const auto& verdict : *stage)
            if (verdict && verdict->verdict != WellDefined::yes)
                return false;
    return true;
}

/// The verdicts as a table in which what always holds is left out.
void write_operators(Text& text, const Diagnosis& facts) {
    std::vector<std::string> lines;
    const auto cell = [](const OperatorVerdict* verdict) {
        return verdict ? name(verdict->verdict) : "-";
    };
    for (const auto& row : operator_rows(facts)) {
        if (row.name == "laplacian" || everywhere_yes(row))
            continue; // Laplacians have a verdict of their own
        const bool graded = row.name.find(' ') == std::string::npos;
        const auto& [input, merged] = row.sides;
        lines.push_back(fmt::format("  {:<18}{:>14}{:>14}{:>16}{:>14}\n",
                                    graded ? fmt::format("{} {}", row.name, row.degree) : row.name,
                                    cell(input[0]), cell(input[1]), cell(merged[0]),
                                    cell(merged[1])));
    }
    if (lines.empty())
        return text("other operators\n  all are well defined, before and after merging\n");
    text("other operators that are not well defined everywhere\n  "
         "{:<18}{:>14}{:>14}{:>16}{:>14}\n{}",
         "", "input primal", "dual", "merged primal", "dual", fmt::join(lines, ""));
}

/// The one verdict on the Laplacian of a degree and side, with its reason.
std::string verdict(const LaplacianVerdict& facts, Side side, StarKind stars) {
    const bool exists = facts.matrix != WellDefined::no;
    const auto& spectrum = facts.spectrum(side);
    const auto& reason = facts.reason(side);
    const auto better = [&](const char* now) {
        return facts.before == facts.matrix || stars != StarKind::circumcentric
                   ? std::string(now)
                   : fmt::format("{} ({} before merging)", now, name(facts.before));
    };
    if (!exists && !spectrum.exists)
        return fmt::format("no, {}", reason);
    if (!exists)
        return fmt::format("a spectrum only, since {}", facts.matrix_reason);
    if (!spectrum.exists)
        return fmt::format("a matrix only, no spectrum: {}", reason);
    if (!spectrum.reason.empty())
        return fmt::format("yes, but {}", reason);
    return reason.empty() ? better("yes") : fmt::format("restricted, {}", reason);
}

void write_laplacians(Text& text, const Diagnosis& facts, StarKind stars) {
    text("Laplacians and spectra\n");
    for (const auto& each : facts.laplacians) {
        const auto primal = verdict(each, Side::primal, stars),
                   dual = verdict(each, Side::dual, stars);
        const int opposite = facts.dimension - each.degree;
        if (primal == dual)
            text("  primal {}-forms, dual {}-forms: {}\n", each.degree, opposite, primal);
        else
            text("  primal {}-forms: {}\n  dual {}-forms: {}\n", each.degree, primal, opposite,
                 dual);
    }
}

struct Info {
    std::string mesh;
    Diagnosis facts;
    ChosenStars stars;

    Info(std::string name, Diagnosis found, ChosenStars chosen)
        : mesh(std::move(name)), facts(std::move(found)), stars(std::move(chosen)) {}

    void write(JsonWriter& json) const {
        write_diagnosis(json, facts, advice_in_words(facts));
        polydec::write_stars(json, stars);
    }

    void write(Text& text) const {
        text("{}\n", printable(mesh));
        write_cells(text, facts);
        write_topology(text, facts);
        write_duals(text, facts);
        write_stars(text, facts, stars);
        write_laplacians(text, facts, stars.kind);
        write_operators(text, facts);
        for (const auto& advice : advice_in_words(facts))
            text("{}\n", advice);
    }
};

struct InfoArguments {
    MeshArguments mesh;
    std::filesystem::path out;
};

/// The cells, with the whole answer beside them.
void draw(const InfoArguments& arguments, const Discretization& mesh, const Info& answer,
          const Log& log) {
    Text text;
    answer.write(text);
    Page page = draw_page(mesh, arguments.mesh.mesh.filename().string());
    page.text.facts = {std::string(text.view())};
    write_page(arguments.out, std::move(page), log);
}

void run(const InfoArguments& arguments) {
    Log log;
    check_page_options(arguments.out);
    if (!arguments.out.empty())
        check_output_file(arguments.out, and_pages({}));
    const Discretization mesh = load(arguments.mesh, log, arguments.out);
    const Info answer(arguments.mesh.mesh.string(),
                      diagnose(mesh, [&](std::string_view stage) { log.timing.begin(stage); }),
                      mesh.chosen_stars());
    log.warn(answer.facts.warnings);
    if (!arguments.out.empty()) {
        log.timing.begin("write");
        draw(arguments, mesh, answer, log);
    }
    tell(answer, log, arguments.mesh.tell);
}

} // namespace

void add_info(CLI::App& app) {
    const auto [command, arguments] = add_command<InfoArguments>(
        app, "info", "describes the mesh and what DEC can do on it", run);
    add_mesh_arguments(*command, arguments->mesh, StarKind::circumcentric);
    command->add_option("-o,--out", arguments->out,
                        "FILE\twrite an .html page, or a .png or .svg picture, of the mesh too");
    add_page_options(*command);
    command->footer("Examples:\n  polydec info fandisk.off\n  polydec info bunny.ply --delaunay\n"
                    "  polydec info hand.mesh --star automatic");
}

} // namespace polydec::tools
