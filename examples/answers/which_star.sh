# SPDX-License-Identifier: MIT
printf 'v 0 0\nv 4 0\nv 2 .5\nv 2 -.5\nf 1 2 3\nf 2 1 4\n' > kite.obj
polydec info kite.obj --star automatic
# What can go wrong:
! polydec hodge kite.obj --side primal --form '-y; x' --star circumcentric
