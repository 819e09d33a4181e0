# SPDX-License-Identifier: MIT
polydec generate torus -o torus.off
polydec distance torus.off --from 0 --to 200 -o path.html
# What can go wrong:
! polydec distance torus.off --from 0 --to 99999
