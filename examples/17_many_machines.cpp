// SPDX-License-Identifier: MIT
//
// A user-defined PDE over many machines: du/dt = - Delta u for the amounts u of heat in the cells
// of a cube of cubes with its surface held at 0. polydec returns Mat and Vec of PETSc, with the
// same numbers on any number of ranks; PETSc does the rest. Start it by
// `mpirun -n 4 17_many_machines`, with solver options such as `-ksp_monitor`.
#include <cmath>
#include <distributed/petsc.h>
#include <distributed/poisson.h>
#include <distributed/shared_picture.h>
#include <iostream>
#include <numbers>
#include <petscksp.h>
#include <polydec.h>

int main() {
    const auto ranks = polydec::Ranks::all();

    // each rank has a stretch of the mesh; read_slice(ranks, "cubes.pdm") takes one from a file
    const auto slice = polydec::slice_of(ranks, polydec::kuhn(3, 12));
    const auto owners = polydec::vertex_owners(ranks, slice, polydec::Ownership::morton);
    const auto mesh = polydec::discretize(ranks, slice, owners); // tetrahedra merge into cubes

    // (star + dt star Delta) u_new = star u for 3-forms, the amounts in cells
    const double dt = 0.002;
    const int n = mesh.dimension(), steps = 10;
    const polydec::OwnedVec star = polydec::star(ranks, mesh.cells, n);
    const polydec::OwnedMat A = polydec::symmetric_laplacian(ranks, mesh.cells, n);
    MatScale(A.get(), dt);
    MatDiagonalSet(A.get(), star.get(), ADD_VALUES);
    KSP solver = nullptr;
    KSPCreate(PETSC_COMM_WORLD, &solver);
    KSPSetOperators(solver, A.get(), A.get());
    KSPSetType(solver, KSPCG);
    KSPSetTolerances(solver, 1e-12, PETSC_DEFAULT, PETSC_DEFAULT, PETSC_DEFAULT);
    KSPSetFromOptions(solver);

    // own cells, their centers and volumes, are Eigen types
    const auto centers = polydec::cell_centers(ranks, mesh, n);
    polydec::Vector u = mesh.cells.volumes.primal(n);
    for (polydec::Index cell = 0; cell < u.size(); ++cell)
        for (const double x : centers.row(cell))
            u[cell] *= std::sin(std::numbers::pi * x);

    const polydec::OwnedVec heat = polydec::vector_of(ranks, u),
                            load = polydec::vector_of(ranks, u);
    double begin = 0, end = 0;
    VecSum(heat.get(), &begin);
    for (int step = 0; step < steps; ++step) {
        VecPointwiseMult(load.get(), star.get(), heat.get());
        KSPSolve(solver, load.get(), heat.get());
    }
    VecSum(heat.get(), &end);
    KSPDestroy(&solver);
    polydec::write_pvtu(ranks, "cubes.pvtu", mesh, {{"heat", n, polydec::own_entries(heat.get())}});
    if (ranks.rank() == 0)
        std::cout << mesh.cells.degree(n).count << " cubes, heat left " << end / begin
                  << ", of a continuum "
                  << std::exp(-3 * std::pow(std::numbers::pi, 2) * dt * steps) << '\n';
}
