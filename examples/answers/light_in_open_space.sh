# SPDX-License-Identifier: MIT
polydec generate grid --nx 40 --ny 40 -o plane.off
polydec maxwell plane.off --degree 0 --initial 'exp(-200*((x-.5)^2+(y-.5)^2))' --absorb .25 \
    --until 2 -o light.html
# What can go wrong:
polydec generate well-centered -o acute.off
! polydec maxwell acute.off --degree 0 --initial x --absorb .2 --layer stretched --until 1
