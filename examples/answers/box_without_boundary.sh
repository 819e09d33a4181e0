# SPDX-License-Identifier: MIT
polydec generate grid --nx 32 --ny 32 -o square.off
polydec spectrum square.off --side primal --degree 0 --count 5 --periodic 1,0 --periodic 0,1
# What can go wrong:
! polydec info square.off --periodic 1,0.01
