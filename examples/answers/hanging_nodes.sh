# SPDX-License-Identifier: MIT
polydec spectrum hanging.off --side primal --degree 0 --count 2
polydec spectrum hanging.off --side primal --degree 0 --count 2 --join-hanging
