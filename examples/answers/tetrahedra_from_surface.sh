# SPDX-License-Identifier: MIT
polydec generate icosphere --frequency 4 -o sphere.off
polydec generate --mesher tetgen --quality 1.4 sphere.off -o ball.mesh
polydec info ball.mesh
# What can go wrong:
polydec generate moebius -o strip.off
! polydec generate --mesher tetgen strip.off -o strip.mesh
