# SPDX-License-Identifier: MIT
polydec generate grid --nx 16 --ny 16 -o square.off
polydec poisson square.off --side primal --rhs 0 --essential-where 'x<1e-9' \
    --flux '(x>1-1e-9)*3' --exact '3*x'
# What can go wrong:
polydec poisson square.off --side primal --rhs 1 --natural
