# SPDX-License-Identifier: MIT
polydec generate grid --nx 32 --ny 32 -o square.off
polydec poisson square.off --side primal --rhs 1
