// SPDX-License-Identifier: MIT
#include "tools/spectrum_answer.h"

#include "io/diagnosis_json.h"
#include "io/pages/page.h"
#include "tools/messages.h"

namespace polydec::tools {

void Eigenvalues::write(JsonWriter& json) const {
    const auto& certificate = spectrum.certificate;
    const bool is_solved = !spectrum.linear_solver.empty();
    facts.write_form(json);
    json.member("eigenvalues", spectrum.eigenvalues);
    json.member("radii", spectrum.radii);
    json.member("residuals", spectrum.residuals);
    json.object("certificate", [&] {
        json.member("shift", certificate.shift);
        json.member("below_shift", certificate.below_shift);
        json.member("returned_below_shift", certificate.returned_below_shift);
        json.member("complete", certificate.complete);
    });
    json.member("linear_solver", is_solved ? spectrum.linear_solver : "none");
    json.member("eigen_solver", spectrum.eigen_solver);
    json.member("seconds", seconds);
    if (resumed)
        json.member("resumed_with", *resumed);
    json.member("conditions", facts.conditions);
    if (spectrum.coarseness)
        json.member("coarseness", *spectrum.coarseness);
    write_stars(json, facts.stars);
}

void Eigenvalues::write(Text& text) const {
    text("Laplace-de Rham operator on {} {}-forms, {} smallest eigenvalues\n{}\n{}\n\n"
         "{:>5}  {:>20}  {:>10}  {:>10}\n",
         name(facts.side), facts.degree, spectrum.eigenvalues.size(), facts.conditions,
         in_words(facts.stars), "", "eigenvalue", "radius", "residual");
    for (Index i = 0; i < spectrum.eigenvalues.size(); ++i)
        text("{:>5}  {:>20.12g}  {:>10.2e}  {:>10.2e}\n", i, spectrum.eigenvalues[i],
             spectrum.radii[i], spectrum.residuals[i]);
    text("\n{}\n", in_words(spectrum.certificate));
    if (spectrum.coarseness)
        text("{}\n", told(advice_of_shape(spectrum)));
    if (spectrum.linear_solver.empty())
        text("no system was solved: the checkpoint has all vectors, {:.2f} s\n", seconds);
    else
        text("{} with {}, {:.2f} s\n", spectrum.eigen_solver, spectrum.linear_solver, seconds);
    if (resumed && *resumed > 0)
        text("resumed from {} vectors of a checkpoint\n", *resumed);
}

} // namespace polydec::tools
