# SPDX-License-Identifier: MIT
polydec generate kuhn --cells 8 8 8 -o cavity.nsc
polydec spectrum cavity.nsc --side primal --degree 1 --essential-where 1 --count 6
# What can go wrong:
polydec spectrum cavity.nsc --side primal --degree 1 --count 3
