#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws docs/images/python.png, with the package for Python and matplotlib:

    PYTHONPATH=build/release/python scripts/python_picture.py docs/images/python.png
"""
import sys

import matplotlib
import numpy as np

import polydec

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


def main():
    figure = plt.figure(figsize=(9, 4))
    sphere = polydec.discretize(polydec.meshes.goldberg(8))
    modes = polydec.spectrum(sphere, count=9, side="dual")
    left = figure.add_subplot(1, 2, 1, projection="3d")
    polydec.plot(sphere, modes.modes[:, 6], degree=0, side="dual", ax=left, linewidth=0.3,
                 bar="eigenfunction, of norm 1")
    left.set_title(f"On hexagons: eigenvalue {modes.eigenvalues[6]:.4f} (exact 6)", fontsize=10)

    square = polydec.discretize(polydec.meshes.grid(14, 14))
    form = square.cochain(polydec.de_rham(square, 1, lambda p: np.column_stack(
        [np.sin(np.pi * p[:, 1]), np.sin(2 * np.pi * p[:, 0])])), 1)
    parts = polydec.hodge_decomposition(square, form)
    right = figure.add_subplot(1, 2, 2)
    polydec.plot(square, parts.potential.values, degree=0, ax=right, linewidth=0.3,
                 bar="its potential, at vertices")
    places, arrows = square.centers(2), polydec.sharp_pd(square, parts.exact)
    right.quiver(*places.T, *arrows.T, color="k")
    right.set_title("Exact part of a 1-form, a vector on each polygon", fontsize=10)
    right.set_aspect("equal")
    for axes in (left, right):
        axes.set_axis_off()
    figure.tight_layout()
    figure.savefig(sys.argv[1], dpi=90)


if __name__ == "__main__":
    main()
