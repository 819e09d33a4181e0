// SPDX-License-Identifier: MIT
//
// The code on docs/forms.md: the de Rham maps, quadrature, Whitney interpolation.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <polydec.h>

namespace {

polydec::Vector vortex(const polydec::Vector& p) {
    return polydec::Vector{{-p[1], p[0]}};
}

void circulation_and_flux() {
    const auto mesh =
        polydec::discretize(polydec::hexagons(8), {.star = polydec::StarKind::circumcentric});
    const auto& P = mesh.complex();
    const auto w = polydec::de_rham(mesh, 1, polydec::circulation_form(vortex));
    const auto flux = polydec::de_rham(mesh, 1, polydec::flux_form(vortex));
    std::cout << "sum of curls " << polydec::d(P, w).values.sum() << ", largest divergence "
              << (polydec::d(P, flux).values.cwiseAbs().maxCoeff() < 1e-14 ? "0" : "not 0") << '\n';
}

void dual_forms_commute() {
    const auto mesh =
        polydec::discretize(polydec::hexagons(8), {.star = polydec::StarKind::circumcentric});
    const auto f = [](const polydec::Vector& p) { return p[0] * p[1]; };
    const auto gradient = [](const polydec::Vector& p) { return polydec::Vector{{p[1], p[0]}}; };
    const auto values = polydec::dual_de_rham(mesh, 0, polydec::function_form(f));
    const auto circulation = polydec::dual_de_rham(mesh, 1, polydec::circulation_form(gradient));
    const auto difference = polydec::d(mesh.complex(), values) - circulation;
    double inside = 0, boundary = 0;
    for (polydec::Index e = 0; e < difference.values.size(); ++e) {
        double& largest = mesh.complex().coface_counts(1)[e] == 2 ? inside : boundary;
        largest = std::max(largest, std::abs(difference.values[e]));
    }
    std::cout << "d f - df: inside " << (inside < 1e-13 ? "0" : "not 0") << ", at the boundary "
              << (boundary < 1e-13 ? "0" : "more") << '\n';
}

void quadrature() {
    for (const int degree : {1, 3, 5, 7}) {
        const auto rule = polydec::grundmann_moeller(1, degree);
        double sum = 0; // the integral of exp over [0, 1]
        for (polydec::Index q = 0; q < rule.weights.size(); ++q)
            sum += rule.weights[q] * std::exp(rule.points(q, 1));
        std::cout << "degree " << degree << ", " << rule.weights.size() << " points, error "
                  << std::abs(sum - (std::exp(1.0) - 1)) << '\n';
    }
}

void whitney() {
    const auto mesh = polydec::discretize(polydec::grid(4, 4));
    const auto w = polydec::de_rham(mesh, 1, polydec::circulation_form([](const auto&) {
                                        return polydec::Vector{{2, 3}};
                                    }));
    const polydec::Vector center = polydec::Vector::Constant(3, 1.0 / 3);
    std::cout << "at the center of triangle 5: "
              << polydec::whitney_form(mesh, w, 5, center).transpose() << '\n';
}

} // namespace

int main() {
    circulation_and_flux();
    dual_forms_commute();
    quadrature();
    whitney();
}
