// SPDX-License-Identifier: MIT
//
// A PDE without a solver in the library: heat diffuses on a sphere while a wind carries it around,
// du/dt = - L_X u - nu Delta u, on the quads of a UV sphere. The Laplacian is built from d and
// stars; transport is the Lie derivative with upwind sampling. A step is explicit in transport and
// implicit in diffusion. Both keep the temperature between its extremes. Diffusion preserves the
// mean to rounding, transport in this form to first order.
#include <iostream>
#include <polydec.h>

int main() {
    const auto sphere = polydec::discretize(polydec::uv_sphere(32, 16));
    const double nu = 0.05, dt = 0.02;

    // a wind around the axis, given at the vertices
    polydec::Points wind = polydec::Points::Zero(sphere.points().rows(), 3);
    wind.col(0) = -sphere.points().col(1);
    wind.col(1) = sphere.points().col(0);
    const polydec::SparseMatrix transport =
        polydec::lie_derivative(sphere, wind, 0, polydec::Sampling::upwind);

    // (star_0 + dt nu d^T star_1 d) u_new = star_0 (u - dt L_X u), factorized once
    const polydec::Vector mass = polydec::star(sphere, 0).diagonal();
    polydec::SparseMatrix A = dt * nu * polydec::symmetric_laplacian(sphere, 0).matrix();
    A.diagonal() += mass;
    const auto solver = polydec::make_linear_solver("auto");
    solver->factorize(A, {.symmetry = polydec::Symmetry::symmetric,
                          .definiteness = polydec::Definiteness::positive,
                          .domain_dimension = 2});

    const auto x = sphere.points().col(0);
    polydec::Vector u = (x.array() > 0.8).cast<double>(); // a hot spot
    const double begin = mass.dot(u) / mass.sum();
    polydec::Series film("temperature.html", sphere,
                         {.title = "A hot spot, blown around a sphere"});
    for (int step = 0; step <= 100; ++step) {
        if (step % 4 == 0)
            film.add(dt * step, {{"temperature", {polydec::Side::primal, 0, u}}});
        const polydec::Vector moved = u - dt * (transport * u);
        u = solver->solve(mass.cwiseProduct(moved));
    }
    film.close();
    std::cout << "temperature from " << u.minCoeff() << " to " << u.maxCoeff() << ", mean "
              << mass.dot(u) / mass.sum() << " after " << begin << '\n';
    std::cout << "still between 0 and 1: " << (u.minCoeff() > 0 && u.maxCoeff() < 1 ? "yes" : "no")
              << '\n';
}
