# SPDX-License-Identifier: MIT
polydec generate torus -o torus.off
polydec info torus.off
# What can go wrong:
polydec info box.off
