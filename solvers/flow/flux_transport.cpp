// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "dec/boundary/two_sided.h"
#include "meshes/unit_of_length.h"
#include "solvers/flow/advection.h"

#include <algorithm>
#include <limits>

namespace polydec {

FluxTransport::FluxTransport(const Cells& cells, Sampling sampling)
    : complex_(cells.complex()),
      volumes_(in_input_units(cells.volumes().primal(cells.dimension()), cells.unit(),
                              cells.dimension(), "volumes of cells")),
      sampling_(sampling),
      sides_(static_cast<std::size_t>(complex_.size(cells.dimension() - 1)), Sides{-1, -1}) {
    check_two_sided(cells);
    const CellComplex& complex = complex_;
    const int n = complex.dimension();
    for (Index cell = 0; cell < complex.size(n); ++cell)
        for (const auto& [f, sign] : complex.incidences(n - 1)[cell])
            (sign > 0 ? sides_[f].back : sides_[f].front) = cell;
}

Vector FluxTransport::mass_flux(const Vector& flux, const Vector& density,
                                const Vector& outside) const {
    const auto facets = static_cast<Index>(sides_.size());
    check_values("fluxes", flux, facets);
    check_values("densities", density, volumes_.size());
    if (outside.size() > 0)
        check_values("densities outside", outside, facets);
    Vector result(facets);
    for (Index f = 0; f < facets; ++f) {
        const auto [back, front] = sides_[f];
        const Index from = flux[f] > 0 ? back : front, to = flux[f] > 0 ? front : back;
        double carried = 0; // of facets that no cell has on a side of its own
        if (from >= 0)
            carried = sampling_ == Sampling::upwind || to < 0 ? density[from]
                                                              : (density[from] + density[to]) / 2;
        else if (outside.size() > 0)
            carried = outside[f];
        result[f] = carried * flux[f];
    }
    return result;
}

Vector FluxTransport::rate(const Vector& flux, const Vector& density, const Vector& outside) const {
    const Vector through = mass_flux(flux, density, outside);
    const Operator d = Operator::derivative(complex_, complex_.dimension() - 1);
    return -(d * through).cwiseQuotient(volumes_);
}

double FluxTransport::stable_step(const Vector& flux) const {
    check_values("fluxes", flux, std::ssize(sides_));
    const int n = complex_.dimension();
    double most = 0;
    for (Index cell = 0; cell < complex_.size(n); ++cell) {
        double out = 0;
        for (const auto& [f, sign] : complex_.incidences(n - 1)[cell])
            out += std::max(sign * flux[f], 0.0);
        most = std::max(most, out / volumes_[cell]);
    }
    return most > 0 ? 1 / most : std::numeric_limits<double>::infinity();
}

double FluxTransport::mass(const Vector& density) const {
    check_values("densities", density, volumes_.size());
    return volumes_.dot(density);
}

double FluxTransport::outflow(const Vector& mass_flux) const {
    check_values("mass fluxes", mass_flux, std::ssize(sides_));
    const auto& cofaces = complex_.coface_counts(complex_.dimension() - 1);
    double sum = 0;
    for (Index f = 0; f < mass_flux.size(); ++f)
        if (cofaces[f] == 1)
            sum += sides_[f].back >= 0 ? mass_flux[f] : -mass_flux[f];
    return sum;
}

} // namespace polydec
