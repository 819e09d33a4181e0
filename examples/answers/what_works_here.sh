# SPDX-License-Identifier: MIT
polydec generate torus -o torus.off
polydec info torus.off --no-merge
polydec info torus.off
