# SPDX-License-Identifier: MIT
polydec generate hexagons --columns 3 -o hexagons.off
polydec draw hexagons.off --duals --numbers --orientations -o hexagons.svg
# What can go wrong:
polydec generate torus -o torus.off
! polydec draw torus.off --numbers -o torus.svg
