// SPDX-License-Identifier: MIT
//
// A pulse of light in a box with conducting walls: Maxwell's equations with the electric field on
// edges, the magnetic flux through faces, and leapfrog in time. On cubes of merged tetrahedra this
// is Yee's scheme of 1966. The same three lines run on octahedra and tetrahedra; energy is again
// conserved to rounding.
#include <cmath>
#include <fstream>
#include <iostream>
#include <polydec.h>

namespace {

void run(const std::string& name, const polydec::Mesh& mesh) {
    const auto box = polydec::discretize(mesh, {.star = polydec::StarKind::circumcentric});
    const polydec::FormSpace field(box, polydec::Side::primal, 1,
                                   {polydec::BoundaryCondition::essential});
    const int steps = static_cast<int>(std::ceil(0.4 / (0.9 * polydec::stable_step(field))));

    // initially a vertical field in the middle of the box; light has speed 1
    const auto pulse =
        polydec::de_rham(box, 1, polydec::circulation_form([](const auto& x) {
                             const double r2 = (x - Eigen::Vector3d::Constant(0.5)).squaredNorm();
                             return polydec::Vector(Eigen::Vector3d(0, 0, std::exp(-r2 / 0.01)));
                         }));
    polydec::Waves light(field, pulse.values, {.time_step = 0.4 / steps});
    double drift = 0;
    polydec::Series film(name + ".html", box,
                         {.title = "A pulse of light: the electric field upwards"});
    polydec::Vector vertical; // component of the field in each cell
    light.march(0.4, [&](double time) {
        vertical = polydec::sharp_pd(box, light.form(0)).col(2);
        film.add(time, {{"E_z", {polydec::Side::dual, 0, vertical}}});
        drift = std::max(drift, std::abs(light.relative_energy().value() - 1));
    });
    std::cout << name << ": " << field.size() << " edges, " << steps << " steps, energy "
              << (drift < 1e-12 ? "kept to rounding" : "lost") << '\n';

    // the rear half at the end
    const auto solid = polydec::kept_faces(
        box, [](const auto& x) { return x[1] > 0.5 + 1e-9; }, vertical);
    std::ofstream(name + ".svg") << polydec::to_svg(
        polydec::draw_solid(solid, {.eye = Eigen::Vector3d(0.5, -1.2, 0.6),
                                    .title = "A pulse at time 0.4: E upwards"}));
}

} // namespace

int main() {
    run("pulse_on_cubes", polydec::kuhn(3, 16));
    run("pulse_on_octahedra", polydec::fcc(10));
}
