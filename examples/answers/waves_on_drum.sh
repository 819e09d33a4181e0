# SPDX-License-Identifier: MIT
polydec generate grid --nx 32 --ny 32 -o drum.off
polydec wave drum.off --side dual --initial 'sin(pi*x)*sin(pi*y)' --until .707107 -o wave.pvd
# What can go wrong:
! polydec wave drum.off --side dual --initial 'sin(pi*x)*sin(pi*y)' --until 1 --time-step .1
