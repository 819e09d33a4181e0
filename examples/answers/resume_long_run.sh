# SPDX-License-Identifier: MIT
polydec generate goldberg -o sphere.off
polydec heat sphere.off --side primal --initial z --until .5 -o heat.pvd \
    --checkpoint heat.checkpoint --resume
# What can go wrong:
! polydec heat sphere.off --side primal --initial x --until .5 -o heat.pvd \
    --checkpoint heat.checkpoint --resume
