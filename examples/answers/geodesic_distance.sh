# SPDX-License-Identifier: MIT
polydec generate icosphere --frequency 16 -o sphere.off
polydec distance sphere.off --from 0 5 -o distance.html
# What can go wrong:
! polydec distance sphere.off --from 99999
