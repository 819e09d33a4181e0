// SPDX-License-Identifier: MIT
//
// Dividing spots: the Gray-Scott reaction of two diffusing substances on a sphere of hexagons and
// 12 pentagons, with one value per cell. Diffusion is implicit, so the pattern alone limits the
// steps, not the mesh. A mesh file as argument replaces the sphere.
#include <cmath>
#include <fstream>
#include <iostream>
#include <polydec.h>

namespace {

constexpr double feed = 0.0367, kill = 0.0649, fastness = 3.2e-4;

std::vector<polydec::Vector> reaction(double, const std::vector<polydec::Cochain>& now) {
    const auto u = now[0].values.array(), v = now[1].values.array();
    return {-u * v * v + feed * (1 - u), u * v * v - (feed + kill) * v};
}

/// Number of local maxima of a substance above a threshold.
int spots(const polydec::CellComplex& complex, const polydec::Vector& v) {
    polydec::Vector highest = polydec::Vector::Zero(v.size());
    const polydec::SparseMatrix d = polydec::derivative(complex, complex.dimension() - 1);
    const polydec::SparseMatrix beside = d.cwiseAbs() * d.cwiseAbs().transpose();
    for (polydec::Index cell = 0; cell < v.size(); ++cell)
        for (polydec::SparseMatrix::InnerIterator other(beside, cell); other; ++other)
            if (other.col() != cell)
                highest[cell] = std::max(highest[cell], v[other.col()]);
    return static_cast<int>((v.array() > highest.array().max(0.15)).count());
}

} // namespace

int main(int count, char** arguments) {
    const auto mesh =
        polydec::discretize(count > 1 ? polydec::read_mesh(arguments[1]) : polydec::goldberg(16));
    const polydec::Points sites = polydec::cell_centers(mesh, mesh.dimension());
    polydec::Vector u = polydec::Vector::Ones(sites.rows()), v = u;
    for (polydec::Index cell = 0; cell < sites.rows(); ++cell) {
        const auto x = sites.row(cell);
        const double waves = std::sin(9 * x[0] + 1) * std::sin(8 * x[1] + 2) * std::sin(7 * x[2]);
        v[cell] = waves > 0.4 ? 0.25 : 0;
        u[cell] = waves > 0.4 ? 0.5 : 1;
    }

    const polydec::FormSpace cells(mesh, polydec::Side::dual, 0);
    polydec::Evolution pattern({{cells, u, fastness}, {cells, v, fastness / 2}}, reaction,
                               {.steps = {.relative_tolerance = 1e-3, .absolute_tolerance = 1e-5}});
    polydec::Series series("gray_scott.pvd", mesh);
    std::vector<double> times;
    for (int frame = 1; frame <= 20; ++frame)
        times.push_back(150 * frame);
    polydec::march(pattern, times, {.show = [&](const polydec::Run& now) {
                       series.add(now.time(), {{"v", now.form(1)}});
                   }});

    std::cout << mesh.complex().size(2) << " cells, " << pattern.report().steps << " steps of "
              << pattern.time() / pattern.report().steps << " in the mean, "
              << pattern.report().preparations << " factorizations; "
              << spots(mesh.complex(), pattern.form(1).values) << " spots\n";
    polydec::write_page("gray_scott.html",
                        polydec::draw_page(mesh, {{"v", pattern.form(1)}}, "Spots that divide"));
}
