# SPDX-License-Identifier: MIT
polydec generate kuhn --cells 3 3 3 3 -o tesseracts.nsc
polydec info tesseracts.nsc
polydec spectrum tesseracts.nsc --side dual --degree 0 --count 1
# What can go wrong:
! polydec merge tesseracts.nsc -o tesseracts.vtu
