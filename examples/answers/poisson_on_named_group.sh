# SPDX-License-Identifier: MIT
polydec poisson plate.msh --side primal --rhs 0 --keep-groups \
    --essential-on hot cold --boundary 'x<.5 ? 100 : 20' -o plate.vtu
# What can go wrong:
! polydec poisson plate.msh --side primal --rhs 0 --essential-on hott cold
