// SPDX-License-Identifier: MIT
#include "tools/poisson_answer.h"

#include "io/diagnosis_json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace polydec::tools {

void Solved::write(JsonWriter& json) const {
    json.member("side", name(facts.side));
    json.member("boundary", boundary);
    json.member("unknowns", unknowns);
    json.member("min", min);
    json.member("max", max);
    json.member("residual", report.residual);
    json.member("engine", report.engine);
    json.member("tried", report.tried);
    json.member("iterations", report.iterations);
    json.member("free_components", free_components);
    json.member("conditions", facts.conditions);
    if (errors)
        json.object("error", [&] {
            json.member("l2", errors->l2);
            json.member("max", errors->max);
        });
    if (bound)
        json.object("error_bound", [&] {
            json.member("energy", bound->energy);
            json.member("averaged_gradient", bound->averaged_gradient);
            json.member("size", bound->size);
            json.member("oscillation", bound->oscillation);
            json.member("l2", bound->l2);
        });
    if (!without_bound.empty())
        json.member("without_error_bound", without_bound);
    write_stars(json, facts.stars);
}

namespace {

std::string bound_in_words(const PoissonError& bound) {
    const std::string share =
        bound.size > 0 ? fmt::format(", {:.2g} % of its size", 100 * bound.energy / bound.size)
                       : "";
    const std::string l2 = bound.l2 ? fmt::format(", of u in L2 at most {:.3g}", *bound.l2) : "";
    return fmt::format("error of the gradient at most {:.3g}{}{}\n"
                       "  (proved for u and f linear on triangles, boundary values linear and flow "
                       "constant on edges)",
                       bound.energy, share, l2);
}

} // namespace

void Solved::write(Text& text) const {
    text("Poisson problem for {} 0-forms, {} boundary, {} unknowns\n", name(facts.side), boundary,
         unknowns);
    text("  {}\n  {}\n", facts.conditions, in_words(facts.stars));
    text("  solution from {:.10g} to {:.10g}\n", min, max);
    text("  residual {:.2e} with {} (tried: {})\n", report.residual, report.engine,
         fmt::join(report.tried, "; "));
    if (errors)
        text("  error: L2 {}, largest {:.6e}\n",
             errors->l2 ? fmt::format("{:.6e}", *errors->l2) : "out of range", errors->max);
    if (bound)
        text("  {}\n", bound_in_words(*bound));
    if (!without_bound.empty())
        text("  no bound of the {}error: {}\n", bound ? "L2 " : "", without_bound);
}

} // namespace polydec::tools
