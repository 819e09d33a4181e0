// SPDX-License-Identifier: MIT
#include "tools/shape_answer.h"

#include <fmt/format.h>

namespace polydec::tools {

namespace {

std::string number_in_words(const CountBelow& count) {
    const auto& [at_least, at_most, too_large, warnings] = count;
    const bool is_one = at_least == 1 && at_most.value_or(1) == 1;
    return (!at_most               ? fmt::format("at least {}", at_least)
            : at_least == *at_most ? fmt::format("exactly {}", at_least)
                                   : fmt::format("{} to {}", at_least, *at_most)) +
           (is_one ? " eigenvalue of the shape lies" : " eigenvalues of the shape lie");
}

std::string count_in_words(const ShapeSpectrum& found, int level) {
    const char* const by = level == 1 ? "linear and Crouzeix-Raviart functions"
                                      : "quadratic functions and the hybrid method of degree 1";
    return fmt::format("proved: {} below {:.8g} ({}, {} count{} of inertia)",
                       number_in_words(found.count), found.count_at, by, found.factorizations,
                       found.factorizations == 1 ? "" : "s");
}

} // namespace

void ShapeEigenvalues::write(JsonWriter& json) const {
    json.member("degree", degree);
    json.object("shape", [&] {
        json.member("lower", spectrum.lower);
        json.member("upper", spectrum.upper);
        json.member("zeros", spectrum.zeros);
        json.object("count_below", [&] {
            json.member("s", spectrum.count_at);
            json.member("at_least", spectrum.count.at_least);
            json.member("at_most", spectrum.count.at_most);
        });
        json.member(kind(), spectrum.simplices);
        json.member("flips", flips);
        json.member("level", level);
        json.member("factorizations", spectrum.factorizations);
    });
    json.member("conditions", conditions);
    json.member("seconds", seconds);
}

void ShapeEigenvalues::write(Text& text) const {
    text("Laplacian of {} on the shape itself, {} smallest eigenvalues\n"
         "{} {} after {} flips\n{}\n\n{:>5}  {:>16}  {:>16}  {:>9}\n",
         degree == 0 ? "functions" : fmt::format("{}-forms", degree), spectrum.upper.size(),
         spectrum.simplices, kind(), flips, conditions, "", "at least", "at most", "width");
    const Vector wide = widths(spectrum);
    for (Index i = 0; i < spectrum.upper.size(); ++i)
        if (i < spectrum.zeros)
            text("{:>5}  {:>16}  {:>16}  {:>9}\n", i, 0, 0, "exact");
        else
            text("{:>5}  {:>16.10g}  {:>16.10g}  {:>9.1e}\n", i, spectrum.lower[i],
                 spectrum.upper[i], wide[i]);
    text("\n{}\n{:.2f} s\n", count_in_words(spectrum, level), seconds);
}

void ShapeCounts::write(JsonWriter& json) const {
    json.member("degree", degree);
    json.object("shape", [&] {
        json.array("counts", [&] {
            for (std::size_t i = 0; i < below.size(); ++i)
                json.object([&] {
                    json.member("s", below[i]);
                    json.member("at_least", counts[i].at_least);
                    json.member("at_most", counts[i].at_most);
                });
        });
        json.member(kind(), simplices);
        json.member("flips", flips);
        json.member("level", level);
    });
    json.member("conditions", conditions);
    json.member("seconds", seconds);
}

void ShapeCounts::write(Text& text) const {
    text("Laplacian of {} on the shape itself\n{} {} after {} flips\n{}\n\n",
         degree == 0 ? "functions" : fmt::format("{}-forms", degree), simplices, kind(), flips,
         conditions);
    for (std::size_t i = 0; i < below.size(); ++i)
        text("proved: {} below {:.8g}\n", number_in_words(counts[i]), below[i]);
    text("{:.2f} s\n", seconds);
}

} // namespace polydec::tools
