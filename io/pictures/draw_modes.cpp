// SPDX-License-Identifier: MIT
#include "io/pictures/draw_cells.h"
#include "io/pictures/draw_fields.h"

#include <fmt/format.h>

#include <cmath>

namespace polydec {

namespace {

/// 1 or -1, by the first value that is, but for rounding, the largest.
double sign_of(const Vector& values) {
    const double most = values.size() == 0 ? 0 : values.cwiseAbs().maxCoeff();
    for (const double value : values)
        if (std::abs(value) >= (1 - 1e-6) * most)
            return value < 0 ? -1 : 1;
    return 1;
}

} // namespace

std::vector<NamedForm> shown_modes(const Spectrum& spectrum) {
    std::vector<NamedForm> modes;
    for (Index i = 0; i < spectrum.modes.cols(); ++i) {
        const Vector mode = spectrum.modes.col(i);
        modes.emplace_back(fmt::format("mode_{}", i),
                           Cochain{spectrum.side, spectrum.degree, sign_of(mode) * mode},
                           fmt::format("{} {}-form, eigenvalue {:.10g}", name(spectrum.side),
                                       spectrum.degree, spectrum.eigenvalues[i]));
    }
    return modes;
}

void add_spectrum(VtuData& picture, const Spectrum& spectrum) {
    const Certificate& certificate = spectrum.certificate;
    const auto number = [](Index value) { return std::vector<Index>{value}; };
    auto& field = picture.field_data;
    field.push_back(vtu_array("eigenvalues", spectrum.eigenvalues));
    field.push_back(vtu_array("radii", spectrum.radii));
    field.push_back(vtu_array("residuals", spectrum.residuals));
    field.push_back({"shift", std::vector<double>{certificate.shift}});
    field.push_back({"below_shift", number(certificate.below_shift)});
    field.push_back({"returned_below_shift", number(certificate.returned_below_shift)});
    field.push_back({"complete", number(certificate.complete ? 1 : 0)});
    field.push_back({"degree", number(spectrum.degree)});
    field.push_back({"is_dual", number(spectrum.side == Side::dual ? 1 : 0)});
}

VtuGrid draw_modes(const Discretization& discretization, const Spectrum& spectrum) {
    VtuGrid grid = draw_cells(
        discretization, cell_degree(discretization.complex(), spectrum.side, spectrum.degree));
    add_fields(grid, discretization, shown_modes(spectrum));
    add_spectrum(grid, spectrum);
    return grid;
}

} // namespace polydec
