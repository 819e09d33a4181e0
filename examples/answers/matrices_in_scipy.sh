# SPDX-License-Identifier: MIT
polydec generate torus -o torus.off
polydec operators torus.off --out operators
ls operators
# What can go wrong:
! polydec operators torus.off --out torus.off
