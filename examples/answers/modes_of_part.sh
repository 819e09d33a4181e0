# SPDX-License-Identifier: MIT
polydec generate flange -o part.stl # or your own file
polydec spectrum part.stl --side primal --degree 0 --count 4 -o modes.html
# What can go wrong:
! polydec spectrum party.stl --side primal --degree 0
