# SPDX-License-Identifier: MIT
polydec generate torus -o torus.off
polydec hodge torus.off --side primal --form '-y; x; z' -o parts.html
# What can go wrong:
! polydec hodge torus.off --side primal --form '-y; x'
