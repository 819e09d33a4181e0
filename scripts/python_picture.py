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
    drawn = polydec.plot(sphere, modes.modes[:, 6], degree=0, side="dual", ax=left, cmap="RdBu",
                         linewidth=0.3)
    figure.colorbar(drawn, ax=left, shrink=0.6, label="eigenfunction, of norm 1")
    left.set_title(f"On hexagons: eigenvalue {modes.eigenvalues[6]:.4f} (exact 6)", fontsize=10)

    torus = polydec.discretize(polydec.meshes.torus(24, 12))
    form = torus.cochain(polydec.de_rham(torus, 1, lambda p: np.column_stack(
        [-p[:, 1], p[:, 0], np.sin(3 * p[:, 0])])), 1)
    parts = polydec.hodge_decomposition(torus, form)
    right = figure.add_subplot(1, 2, 2, projection="3d")
    polydec.plot(torus, ax=right, linewidth=0.3)
    places, arrows = torus.centers(2), polydec.sharp_pd(torus, parts.harmonic)
    right.quiver(*places[::2].T, *arrows[::2].T, length=0.25, color="C3", linewidth=0.8)
    right.set_title("On quads: harmonic part of a 1-form", fontsize=10)
    for axes in (left, right):
        axes.set_axis_off()
    figure.tight_layout()
    figure.savefig(sys.argv[1], dpi=90)


if __name__ == "__main__":
    main()
