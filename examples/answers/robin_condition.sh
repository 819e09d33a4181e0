# SPDX-License-Identifier: MIT
polydec generate grid --nx 16 --ny 16 -o square.off
polydec poisson square.off --side primal --rhs 1 --robin 2 --essential-where 'x<1e-9'
# What can go wrong:
! polydec hodge square.off --side primal --form '-y; x; 0' --robin 2
