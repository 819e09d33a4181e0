# SPDX-License-Identifier: MIT
polydec generate kuhn --cells 8 8 8 -o cubes.pdm
mpirun -n 2 polydec-mpi poisson cubes.pdm --side dual --rhs 1
# What can go wrong:
! mpirun -n 2 polydec-mpi poisson cubes.pdm --side dual --rhs 1 --star galerkin
