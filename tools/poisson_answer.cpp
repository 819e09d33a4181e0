// SPDX-License-Identifier: MIT
#include "tools/poisson_answer.h"

#include "io/diagnosis_json.h"
#include "tools/common.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace polydec::tools {

void Solved::write(JsonWriter& json) const {
    json.member("side", name(side));
    json.member("boundary", boundary);
    json.member("unknowns", unknowns);
    json.member("min", min);
    json.member("max", max);
    json.member("residual", report.residual);
    json.member("engine", report.engine);
    json.member("tried", report.tried);
    json.member("iterations", report.iterations);
    json.member("free_components", free_components);
    json.member("conditions", conditions);
    if (errors)
        json.object("error", [&] {
            json.member("l2", errors->l2);
            json.member("max", errors->max);
        });
    write_stars(json, stars);
}

void Solved::write(Text& text) const {
    text("Poisson problem for {} 0-forms, {} boundary, {} unknowns\n", name(side), boundary,
         unknowns);
    text("  {}\n  {}\n", conditions, in_words(stars));
    text("  solution from {:.10g} to {:.10g}\n", min, max);
    text("  residual {:.2e} with {} (tried: {})\n", report.residual, report.engine,
         fmt::join(report.tried, "; "));
    if (errors)
        text("  error: L2 {}, largest {:.6e}\n",
             errors->l2 ? fmt::format("{:.6e}", *errors->l2) : "out of range", errors->max);
}

} // namespace polydec::tools
