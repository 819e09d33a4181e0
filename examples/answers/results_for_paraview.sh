# SPDX-License-Identifier: MIT
polydec generate grid --nx 16 --ny 16 -o square.off
polydec poisson square.off --side dual --rhs 1 -o u.vtu
polydec heat square.off --side dual --initial 1 --until .1 -o heat.pvd
# What can go wrong:
! polydec poisson square.off --side dual --rhs 1 -o u.vtk
