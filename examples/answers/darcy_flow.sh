# SPDX-License-Identifier: MIT
polydec poisson plate.msh --side dual --rhs 0 --keep-groups --essential-on hot cold \
    --boundary '1-x' --conductivity 'group==4 ? 10 : 1' -o pressure.vtu
# What can go wrong:
! polydec poisson plate.msh --side dual --rhs 0 --conductivity 'group==4 ? 10 : 0'
