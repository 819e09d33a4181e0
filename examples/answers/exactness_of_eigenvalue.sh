# SPDX-License-Identifier: MIT
polydec generate grid --nx 16 --ny 16 -o square.off
polydec spectrum square.off --of-shape --degree 0 --count 3 --essential-where 1
# What can go wrong:
polydec generate grid --nx 2 --ny 2 -o coarse.off
polydec spectrum coarse.off --of-shape --degree 0 --count 1 --essential-where 1 --width 1e-6
