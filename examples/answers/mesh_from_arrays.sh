# SPDX-License-Identifier: MIT
printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n' > square.off
polydec info square.off
# What can go wrong:
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 3\n' > wrong.off
! polydec info wrong.off
