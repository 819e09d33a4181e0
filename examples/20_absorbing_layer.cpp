// SPDX-License-Identifier: MIT
//
// Light in an open plane. The electric field is perpendicular to the plane, so it is a 0-form, and
// a pulse leaves in all directions. A layer of ten squares surrounds the domain. Its coordinates
// are stretched into the complex plane: a perfectly matched layer, which absorbs incoming waves.
// The reflection is the difference from a plane too large for any reflection. Then a current
// radiates beside a rod of glass, in which light is half as fast.
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <polydec.h>

namespace {

constexpr double layer = 10, step = 0.6; // squares have side 1, light has speed 1
const polydec::BoundaryConditions walls{polydec::BoundaryCondition::essential};

polydec::Discretization plane(int half) {
    auto mesh = polydec::kuhn({2 * half, 2 * half}, {2.0 * half, 2.0 * half});
    mesh.points.array() -= half;
    return polydec::discretize(mesh);
}

polydec::Vector hill(const polydec::Discretization& mesh, double x, double width) {
    const Eigen::RowVector2d top(x, 0);
    return (-(mesh.points().rowwise() - top).rowwise().squaredNorm() / (width * width))
        .array()
        .exp();
}

/// The field in the middle over time, and everywhere at the end.
std::vector<double> run(int half, bool is_open) {
    const auto mesh = plane(half);
    polydec::WaveOptions options{.time_step = step};
    if (is_open)
        options.layer = {mesh, layer};
    polydec::Waves light({mesh, polydec::Side::primal, 0, walls}, hill(mesh, 0, 3), options);
    std::vector<double> seen;
    light.march(60, [&](double) {
        const polydec::Vector E = light.form(0).values;
        for (polydec::Index v = 0; v < E.size(); ++v)
            if (mesh.points().row(v).cwiseAbs().maxCoeff() < 20)
                seen.push_back(E[v]);
    });
    return seen;
}

/// Every second square, at the height of the field.
void draw(const polydec::Discretization& mesh, const polydec::Vector& E) {
    const int side = static_cast<int>(std::lround(std::sqrt(E.size())));
    polydec::SolidFaces faces;
    faces.polygons.points.resize(E.size(), 3);
    faces.polygons.points << mesh.points(), 8 * E;
    std::vector<double> heights;
    for (int i = 0; i + 2 < side; i += 2)
        for (int j = 0; j + 2 < side; j += 2) {
            const int corner = i * side + j;
            faces.polygons.add(
                std::array{corner, corner + 2 * side, corner + 2 * side + 2, corner + 2});
            heights.push_back(E[corner + side + 1]);
        }
    faces.values = Eigen::Map<polydec::Vector>(heights.data(), std::ssize(heights));
    std::ofstream("absorbing_layer.svg") << polydec::to_svg(polydec::draw_solid(
        faces, {.line_width = 0.3, .title = "Light beside a rod of glass in an open plane"}));
}

void rod() {
    auto mesh = plane(30);
    const polydec::Points centers = polydec::cell_centers(mesh, 2);
    const polydec::Vector permittivity =
        centers.rowwise().norm().unaryExpr([](double r) { return r < 8 ? 4.0 : 1.0; });
    mesh = mesh.with_stars(
        polydec::weighted_stars(mesh, 0, polydec::CellData::on_cells(permittivity)));
    const polydec::Vector antenna = hill(mesh, -14, 1.5);
    const auto current = [&](double t) -> polydec::Vector {
        return std::sin(0.5 * t) * std::exp(-std::pow((t - 30) / 15, 2)) * antenna;
    };
    polydec::Waves light(
        {mesh, polydec::Side::primal, 0, walls}, 0 * antenna,
        {.time_step = step, .layer = polydec::AbsorbingLayer{mesh, layer}, .source = current});
    double most = 0;
    const auto look = [&](double) { most = std::max(most, light.energy()); };
    light.march(76 * step, look);
    draw(mesh, light.form(0).values);
    light.march(334 * step, look);
    std::cout << "with a glass rod " << 100 * (1 - light.energy() / most)
              << " % of the energy has left\n";
}

} // namespace

int main() {
    const auto open = run(30, true), wide = run(64, false);
    double difference = 0, largest = 0;
    for (std::size_t i = 0; i < open.size(); ++i) {
        difference = std::max(difference, std::abs(open[i] - wide[i]));
        largest = std::max(largest, std::abs(wide[i]));
    }
    const double back = difference / largest;
    std::cout << back
              << " of the pulse comes back: " << (back < 1e-4 ? "less than 1e-4" : "too much")
              << '\n';
    rod();
}
