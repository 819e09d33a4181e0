// SPDX-License-Identifier: MIT
//
// The code on docs/fields.md: flats and sharps, and the orders measured for both.
#include <cmath>
#include <iomanip>
#include <iostream>
#include <polydec.h>
#include <vector>

namespace {

/// A field at given points.
polydec::DenseMatrix sample(const polydec::SmoothForm& field, const polydec::Points& places) {
    polydec::DenseMatrix rows(places.rows(), places.cols());
    for (polydec::Index i = 0; i < rows.rows(); ++i)
        rows.row(i) = field(places.row(i));
    return rows;
}

void there_and_back() {
    const auto mesh =
        polydec::discretize(polydec::hexagons(8), {.star = polydec::StarKind::circumcentric});
    const polydec::DenseMatrix X =
        polydec::Vector{{2, 3}}.transpose().replicate(mesh.points().rows(), 1);
    const polydec::Cochain w = polydec::flat(mesh, polydec::Flat::ppp, X);
    std::cout << "sharp pp " << polydec::sharp_pp(mesh, w).row(7) << ", sharp pd "
              << polydec::sharp_pd(mesh, w).row(7) << '\n';
}

void velocity_from_fluxes() {
    const auto mesh =
        polydec::discretize(polydec::hexagons(8), {.star = polydec::StarKind::circumcentric});
    const auto flux = polydec::de_rham(mesh, 1, polydec::flux_form([](const auto&) {
                                           return polydec::Vector{{2, 3}};
                                       }));
    std::cout << "from fluxes: " << polydec::flux_sharp(mesh, flux).row(7) << '\n';
}

double f(const polydec::Vector& p) {
    return std::sin(3 * p[0] + p[1]) * std::cos(2 * p[1]);
}

polydec::Vector gradient(const polydec::Vector& p) {
    const double a = 3 * p[0] + p[1], b = 2 * p[1];
    return polydec::Vector{
        {3 * std::cos(a) * std::cos(b), std::cos(a) * std::cos(b) - 2 * std::sin(a) * std::sin(b)}};
}

/// Cells of degree k that do not touch the boundary.
std::vector<bool> inner_cells(const polydec::CellComplex& P, int k) {
    const auto on_boundary = polydec::boundary_cells(P);
    std::vector<bool> inner(P.size(k), true);
    const int n = P.dimension();
    for (polydec::Index s = 0; s < P.size(k); ++s)
        inner[s] = !on_boundary[k][s];
    if (k == n)
        for (polydec::Index s = 0; s < P.size(n); ++s)
            for (polydec::IncidenceMatrix::InnerIterator e(P.coboundary(n - 1), s); e; ++e)
                if (on_boundary[n - 1][e.col()])
                    inner[s] = false;
    return inner;
}

/// Mean size over inner cells.
double mean(const polydec::DenseMatrix& rows, const std::vector<bool>& inner) {
    double sum = 0;
    int count = 0;
    for (polydec::Index i = 0; i < rows.rows(); ++i)
        if (inner[i]) {
            sum += rows.row(i).norm();
            ++count;
        }
    return sum / count;
}

/// Errors of the six flats (mean component along the edge), then of the three sharps.
std::vector<double> errors(const polydec::Mesh& input) {
    const auto mesh = polydec::discretize(input, {.tolerance = 1e-8});
    const auto& P = mesh.complex();
    const polydec::Points centers = polydec::cell_centers(mesh, 2);
    const auto smooth = polydec::circulation_form(gradient);
    const auto primal = polydec::de_rham(mesh, 1, smooth);
    const auto dual = polydec::dual_de_rham(mesh, 1, smooth);
    std::vector<double> result;
    using polydec::Flat;
    // where an edge of the boundary has no dual length, there is no dpp
    const bool has_dpp = polydec::star(mesh.volumes(), 1).zeros().empty();
    for (const Flat kind : {Flat::ppp, Flat::pdp, Flat::dpp, Flat::ppd, Flat::pdd, Flat::dpd}) {
        if (kind == Flat::dpp && !has_dpp) {
            result.push_back(std::nan(""));
            continue;
        }
        const bool at_cells = kind == Flat::dpp || kind == Flat::dpd;
        const auto form =
            polydec::flat(mesh, kind, sample(gradient, at_cells ? centers : mesh.points()));
        const bool on_edges = form.side == polydec::Side::primal;
        const auto& exact = on_edges ? primal : dual;
        const double length = 1 / std::sqrt(double(P.size(2)));
        result.push_back(mean((form.values - exact.values) / length, inner_cells(P, 1)));
    }
    const auto df = polydec::d(P, polydec::de_rham(mesh, 0, polydec::function_form(f)));
    const auto flux = polydec::de_rham(mesh, 1, polydec::flux_form(gradient));
    const polydec::Points centroids = polydec::cell_centroids(mesh, 2);
    // Pages show the orders of these three: vectors at vertices, at centroids, from fluxes.
    const polydec::DenseMatrix pp = polydec::sharp_pp(mesh, df);
    const polydec::DenseMatrix pd = polydec::sharp_pd(mesh, df);
    const polydec::DenseMatrix fluxes = polydec::flux_sharp(mesh, flux);
    result.push_back(mean(pp - sample(gradient, mesh.points()), inner_cells(P, 0)));
    result.push_back(mean(pd - sample(gradient, centroids), inner_cells(P, 2)));
    result.push_back(mean(fluxes - sample(gradient, centroids), inner_cells(P, 2)));
    return result;
}

void orders(const char* name, const polydec::Mesh& coarse, const polydec::Mesh& fine) {
    const auto first = errors(coarse), second = errors(fine);
    std::cout << std::left << std::setw(10) << name << std::fixed << std::setprecision(2);
    for (std::size_t i = 0; i < first.size(); ++i) {
        const bool exact = second[i] < 1e-12;
        if (exact)
            std::cout << "exact ";
        else if (std::isnan(second[i]))
            std::cout << "none  ";
        else
            std::cout << std::log2(first[i] / second[i]) << "  ";
    }
    std::cout << std::defaultfloat << '\n';
}

} // namespace

int main() {
    there_and_back();
    velocity_from_fluxes();
    std::cout << "orders    ppp   pdp   dpp   ppd   pdd   dpd   pp    pd    flux\n";
    orders("quads", polydec::grid(32, 32), polydec::grid(64, 64));
    orders("hexagons", polydec::hexagons(32), polydec::hexagons(64));
    orders("irregular", polydec::perturbed(polydec::grid(32, 32), 0.2 / 32, 5),
           polydec::perturbed(polydec::grid(64, 64), 0.2 / 64, 5));
}
