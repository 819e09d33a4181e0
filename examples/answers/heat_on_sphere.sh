# SPDX-License-Identifier: MIT
polydec generate goldberg -o sphere.off
polydec heat sphere.off --side primal --initial z --until .5 --tolerance-in-time 1e-6 -o heat.html
# What can go wrong:
! polydec heat sphere.off --side primal --initial w --until .5
