// SPDX-License-Identifier: MIT
#include "tools/spectrum_answer.h"

#include "io/diagnosis_json.h"
#include "io/pages/draw_page.h"
#include "meshes/unit_of_length.h"
#include "tools/common.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace polydec::tools {

void Eigenvalues::write(JsonWriter& json) const {
    const auto& certificate = spectrum.certificate;
    json.member("side", name(spectrum.side));
    json.member("degree", spectrum.degree);
    json.member("eigenvalues", spectrum.eigenvalues);
    json.member("radii", spectrum.radii);
    json.member("residuals", spectrum.residuals);
    json.object("certificate", [&] {
        json.member("shift", certificate.shift);
        json.member("below_shift", certificate.below_shift);
        json.member("returned_below_shift", certificate.returned_below_shift);
        json.member("complete", certificate.complete);
    });
    json.member("linear_solver", spectrum.linear_solver);
    json.member("eigen_solver", spectrum.eigen_solver);
    json.member("seconds", seconds);
    if (resumed)
        json.member("resumed_with", *resumed);
    json.member("conditions", conditions);
    write_stars(json, stars);
}

void Eigenvalues::write(Text& text) const {
    text("Laplace-de Rham operator on {} {}-forms, {} smallest eigenvalues\n{}\n{}\n\n"
         "{:>5}  {:>20}  {:>10}  {:>10}\n",
         name(spectrum.side), spectrum.degree, spectrum.eigenvalues.size(), conditions,
         in_words(stars), "", "eigenvalue", "radius", "residual");
    for (Index i = 0; i < spectrum.eigenvalues.size(); ++i)
        text("{:>5}  {:>20.12g}  {:>10.2e}  {:>10.2e}\n", i, spectrum.eigenvalues[i],
             spectrum.radii[i], spectrum.residuals[i]);
    text("\n{}\n", in_words(spectrum.certificate));
    text("{} with {}, {:.2f} s\n", spectrum.eigen_solver, spectrum.linear_solver, seconds);
    if (resumed && *resumed > 0)
        text("gone on with {} vectors of a checkpoint\n", *resumed);
}

void warn_of_rough_values(const Spectrum& spectrum, Log& log) {
    if (!spectrum.rough.empty())
        log.warn(
            fmt::format("{} of the eigenvalues, number {} first, {} not known to 1e-6: rounding "
                        "beside the largest one hides the rest; mind the radii, and improve "
                        "cells of extreme shape",
                        spectrum.rough.size(), spectrum.rough.front(),
                        spectrum.rough.size() == 1 ? "is" : "are"));
}

void use_input_units(Spectrum& spectrum, double unit) {
    if (unit == 1)
        return;
    auto& shift = spectrum.certificate.shift; // behind them all, where they are rounding alone
    const double largest = std::max(spectrum.eigenvalues.cwiseAbs().maxCoeff(), std::abs(shift));
    in_input_units(Vector::Constant(1, largest), unit, -2, "eigenvalues");
    const auto convert = [&](double& value) { value = std::ldexp(value, -2 * std::ilogb(unit)); };
    std::for_each(spectrum.eigenvalues.begin(), spectrum.eigenvalues.end(), convert);
    std::for_each(spectrum.residuals.begin(), spectrum.residuals.end(), convert);
    std::for_each(spectrum.radii.begin(), spectrum.radii.end(), convert);
    convert(shift);
    // the value and the radius are each off by half of the least number there is
    for (double& radius : spectrum.radii)
        if (radius < std::numeric_limits<double>::min())
            radius += std::numeric_limits<double>::denorm_min();
}

} // namespace polydec::tools
