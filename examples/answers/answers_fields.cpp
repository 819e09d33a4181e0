// SPDX-License-Identifier: MIT
//
// The C++ code of docs/answers about equations in time, surfaces and forms: prints each answer
// behind its name.
#include "examples/answers/answers.h"

#include <Eigen/SparseCholesky>

#include <cmath>
#include <iostream>
#include <numbers>
#include <polydec.h>

namespace {

using polydec::BoundaryCondition;
using polydec::Side;

void heat_on_sphere() {
    const auto sphere = polydec::discretize(polydec::goldberg(8)); // hexagons and 12 pentagons
    const polydec::Cochain z{Side::primal, 0, sphere.points().col(2)};
    polydec::Evolution heat(
        {{.space = {sphere, Side::primal, 0}, .start = z.values, .diffusion = 1}});
    heat.march(0.5);
    std::cout << "left: " << polydec::norm(sphere, heat.form(0)) / polydec::norm(sphere, z)
              << '\n'; // exp(-2 * 0.5)
}

void waves_on_drum() {
    const auto drum = polydec::discretize(polydec::grid(32, 32));
    const auto sine = polydec::function_form([](const auto& x) {
        return std::sin(std::numbers::pi * x[0]) * std::sin(std::numbers::pi * x[1]);
    });
    const auto start = polydec::dual_de_rham(drum, 0, sine).values;
    const double half_period = 1 / std::sqrt(2);
    polydec::Waves waves({drum, Side::dual, 0}, start, {.time_step = half_period / 50});
    waves.march(half_period);
    const double overlap = waves.form(0).values.dot(start) / start.squaredNorm();
    std::cout << "after half a period: " << overlap << '\n';
}

void own_equation_in_time() {
    const auto sphere = polydec::discretize(polydec::goldberg(6));
    const polydec::Vector seeds = (sphere.points().col(2).array() > 0.8).cast<double>();
    const auto growth = [](double, const std::vector<polydec::Cochain>& now) {
        const auto u = now[0].values.array(); // du/dt = -0.01 Delta u + u (1 - u)
        return std::vector<polydec::Vector>{u * (1 - u)};
    };
    polydec::Evolution spread({{{sphere, Side::primal, 0}, seeds, 0.01}}, growth);
    const polydec::Vector area = polydec::star(sphere, 0).diagonal();
    polydec::march(spread, {2, 4, 6}, {.show = [&](const polydec::Run& now) {
                       std::cout << "time " << now.time() << ": covered "
                                 << area.dot(now.form(0).values) / area.sum() << '\n';
                   }});
}

void shallow_water_on_planet() {
    const auto planet = polydec::discretize(polydec::goldberg(8));
    const polydec::ShallowWater water(planet, {.rotation = 2 * planet.points().col(2)});
    const auto depth = polydec::dual_de_rham(planet, 0, polydec::function_form([](const auto& x) {
                                                 return 1 + 0.2 * std::exp(8 * (x[0] - 1));
                                             }));
    const polydec::Vector flux = polydec::Vector::Zero(planet.size(1));
    polydec::Evolution run({{{planet, polydec::Side::dual, 0}, depth.values},
                            {{planet, polydec::Side::primal, 1}, flux}},
                           water);
    run.march(5);
    std::cout << "mass kept "
              << water.mass({run.forms()[0].values, run.forms()[1].values}) /
                     water.mass({depth.values, flux})
              << '\n';
}

void light_in_open_space() {
    const auto plane = polydec::discretize(polydec::grid(40, 40));
    const polydec::Vector start =
        (-200 * (plane.points().array() - 0.5).square().rowwise().sum()).exp();
    polydec::Waves light({plane, Side::primal, 0, {BoundaryCondition::essential}}, start,
                         {.time_step = 0.01, .layer = polydec::AbsorbingLayer{plane, 0.25}});
    const double before = light.energy();
    light.march(2);
    std::cout << "less than 1e-4 of the energy stays: "
              << (light.energy() < 1e-4 * before ? "yes" : "no") << '\n';
}

void resume_long_run() {
    const auto sphere = polydec::discretize(polydec::goldberg(8));
    const polydec::Vector z = sphere.points().col(2);
    const auto show = [](const polydec::Run& now) {
        const double largest = now.form(0).values.maxCoeff();
        std::cout << "at " << now.time() << " the largest value is " << largest << '\n';
    };
    for (const std::vector<double>& times : {std::vector{0.1, 0.2}, std::vector{0.1, 0.2, 0.3}}) {
        polydec::Evolution heat({{{sphere, Side::primal, 0}, z, 1}}); // killed, and run again
        polydec::march(heat, times, {.checkpoint = "run.checkpoint", .show = show});
    }
}

void transport_along_field() {
    const auto torus = polydec::discretize(polydec::torus(32, 16));
    polydec::Points wind = polydec::Points::Zero(torus.size(0), 3); // around the axis
    wind.col(0) = -torus.points().col(1);
    wind.col(1) = torus.points().col(0);
    const polydec::SparseMatrix L =
        polydec::lie_derivative(torus, wind, 0, polydec::Sampling::upwind);
    polydec::Vector u = (torus.points().col(0).array() > 1).cast<double>();
    for (int step = 0; step < 50; ++step)
        u -= 0.05 * (L * u);
    std::cout << "largest value " << u.maxCoeff() << '\n';
}

void geodesic_distance() {
    const auto sphere = polydec::discretize(polydec::icosphere(16));
    const std::vector<polydec::Index> sources{0, 5};
    const polydec::Vector distance = polydec::geodesic_distance(sphere, sources);
    std::cout << "farthest " << distance.maxCoeff() << ", mean " << distance.mean() << '\n';
}

void shortest_path() {
    const auto torus = polydec::discretize(polydec::torus(32, 16));
    const std::vector<polydec::Index> source{0};
    const auto path = polydec::SurfacePaths(torus, source).from(200);
    std::cout << "length " << path.length << ", " << path.lines.simplices.rows() << " pieces\n";
}

void parts_of_field() {
    const auto torus = polydec::discretize(polydec::torus(32, 16));
    const auto w = polydec::de_rham(torus, 1, polydec::circulation_form([](const auto& x) {
                                        return polydec::Vector{{-x[1], x[0], x[2]}};
                                    }));
    const auto parts = polydec::hodge_decomposition({torus, Side::primal, 1}, w);
    std::cout << "exact: " << polydec::norm(torus, parts.exact)       // gradient
              << "\ncoexact: " << polydec::norm(torus, parts.coexact) // curl
              << "\nharmonic: " << polydec::norm(torus, parts.harmonic) << '\n';
}

void wedge_with_leibniz() {
    const auto mesh = polydec::discretize(polydec::hexagons(8));
    const auto& P = mesh.complex();
    const auto times = [&](const auto& a, const auto& b) { return polydec::wedge(mesh, a, b); };
    const polydec::Cochain f{Side::primal, 0, polydec::Vector::Random(P.size(0))};
    const polydec::Cochain w{Side::primal, 1, polydec::Vector::Random(P.size(1))};
    const auto defect =
        polydec::d(P, times(f, w)) - times(polydec::d(P, f), w) - times(f, polydec::d(P, w));
    std::cout << "Leibniz to 1e-12: "
              << (defect.values.cwiseAbs().maxCoeff() < 1e-12 ? "yes" : "no") << '\n';
}

void matrices_in_scipy() {
    const auto torus = polydec::discretize(polydec::torus(32, 16));
    const polydec::SparseMatrix K = polydec::symmetric_laplacian(torus, 0);
    const polydec::Vector M = polydec::star(torus, 0).diagonal();
    polydec::write_matrix_market("K.mtx", K); // scipy.io.mmread("K.mtx")
    std::cout << K.rows() << " x " << K.cols() << ", " << K.nonZeros() << " entries\n";
    const Eigen::SparseMatrix<double> A = polydec::SparseMatrix(M.asDiagonal()) + 0.1 * K;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> step(A);
    const polydec::Vector u = step.solve(M.cwiseProduct(torus.points().col(2)));
    std::cout << "largest value " << u.maxCoeff() << '\n';
}

void results_for_paraview() {
    const auto square = polydec::discretize(polydec::grid(16, 16));
    const polydec::Vector f = polydec::Vector::Ones(square.size(2));
    const auto u = polydec::PoissonSolver({square, Side::dual, 0}).solve({Side::dual, 0, f}).form;
    auto picture = polydec::draw_cells(square, 2);
    picture.cell_data.push_back(polydec::vtu_array("u", u.values));
    polydec::write_vtu("u.vtu", picture);
    std::cout << "largest value " << u.values.maxCoeff() << '\n';
}

void forms_from_fields() {
    const auto mesh = polydec::discretize(polydec::hexagons(8));
    const auto field = [](const auto& x) { return polydec::Vector{{-x[1], x[0]}}; };
    const auto w = polydec::de_rham(mesh, 1, polydec::circulation_form(field));
    const polydec::Points arrows = polydec::sharp_pd(mesh, w); // a vector in each hexagon
    const polydec::Points at = polydec::cell_centroids(mesh, 2);
    double error = 0;
    for (polydec::Index c = 0; c < mesh.size(2); ++c)
        error =
            std::max(error, (arrows.row(c).transpose() - field(at.row(c))).cwiseAbs().maxCoeff());
    std::cout << "integral of the curl: " << polydec::d(mesh.complex(), w).values.sum() << '\n';
    std::cout << "largest error: " << error << '\n';
}

void stokes_theorem() {
    const auto mesh = polydec::discretize(polydec::hexagons(8));
    const auto& P = mesh.complex();
    const auto w = polydec::de_rham(mesh, 1, polydec::circulation_form([](const auto& x) {
                                        return polydec::Vector{{-x[1], x[0]}};
                                    }));
    const polydec::Chain region{Side::primal, 2, polydec::Vector::Ones(P.size(2))};
    std::cout << "inside " << polydec::pairing(polydec::d(P, w), region) << ", around "
              << polydec::pairing(w, polydec::boundary(P, region)) << '\n';
    const polydec::SparseMatrix dd = polydec::derivative(P, 1) * polydec::derivative(P, 0);
    std::cout << "d d = 0: " << (dd.norm() == 0 ? "yes" : "no") << '\n';
}

void mean_curvature() {
    const auto sphere = polydec::discretize(polydec::icosphere(16));
    const polydec::SparseMatrix laplacian = polydec::laplacian(sphere, 0);
    const polydec::DenseMatrix normals = laplacian * sphere.points(); // Delta x = 2 H n
    const polydec::Vector curvature = normals.rowwise().norm() / 2;
    std::cout << "mean curvature from " << curvature.minCoeff() << " to " << curvature.maxCoeff()
              << '\n'; // 1 on a unit sphere
}

} // namespace

int main() {
    return answers::print({{"heat_on_sphere", heat_on_sphere},
                           {"waves_on_drum", waves_on_drum},
                           {"own_equation_in_time", own_equation_in_time},
                           {"shallow_water_on_planet", shallow_water_on_planet},
                           {"light_in_open_space", light_in_open_space},
                           {"resume_long_run", resume_long_run},
                           {"transport_along_field", transport_along_field},
                           {"geodesic_distance", geodesic_distance},
                           {"shortest_path", shortest_path},
                           {"parts_of_field", parts_of_field},
                           {"wedge_with_leibniz", wedge_with_leibniz},
                           {"matrices_in_scipy", matrices_in_scipy},
                           {"results_for_paraview", results_for_paraview},
                           {"forms_from_fields", forms_from_fields},
                           {"stokes_theorem", stokes_theorem},
                           {"mean_curvature", mean_curvature}});
}
