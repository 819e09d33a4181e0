#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws docs/images/distances.png, with the package for Python and matplotlib:

    PYTHONPATH=build/release/python scripts/distance_picture.py docs/images/distances.png

Distances from a vertex of a prism whose triangles wind around it in helices, exact and by heat, on the
prism unrolled. The truth there is known: circles.
"""
import sys

import matplotlib
import numpy as np
from matplotlib.collections import LineCollection

import polydec

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

AROUND, ROWS, STEEP = 24, 24, 6
SIDE = 2 * np.sin(np.pi / AROUND)


def drill():
    """Points of a square grid around a prism; triangles eight steps up for one to the side."""
    angles = 2 * np.pi * np.repeat(np.arange(AROUND), ROWS + 1) / AROUND
    heights = SIDE * np.tile(np.arange(ROWS + 1), AROUND)
    triangles = []
    for i in range(AROUND):
        left, right = 0, 0
        low, high = i * (ROWS + 1), (i + 1) % AROUND * (ROWS + 1)
        while left + right < 2 * ROWS:
            ahead = right < min(left + STEEP, ROWS)
            triangles.append((low + left, high + right, high + right + 1 if ahead else low + left + 1))
            left, right = (left, right + 1) if ahead else (left + 1, right)
    return np.column_stack([np.cos(angles), np.sin(angles), heights]), np.array(triangles)


def unrolled(places):
    """On the side between two edges of the prism, as far along as across."""
    side = np.arctan2(places[..., 1], places[..., 0]).mean(axis=-1, keepdims=True)
    edge = np.floor(side / (2 * np.pi) * AROUND)
    corner = 2 * np.pi * edge / AROUND
    start = np.stack([np.cos(corner), np.sin(corner)], axis=-1)
    along = np.linalg.norm(places[..., :2] - start, axis=-1)
    return np.stack([SIDE * (edge % AROUND - AROUND // 2) + along, places[..., 2]], axis=-1)


def main():
    points, triangles = drill()
    source = AROUND // 2 * (ROWS + 1) + ROWS // 2
    mesh = polydec.discretize((points, triangles))
    across = SIDE * np.repeat(np.arange(AROUND) - AROUND // 2, ROWS + 1)
    up = points[:, 2] - points[source, 2]
    truth = np.hypot(across, up)
    near = truth < 0.9 * SIDE * AROUND / 2
    whole = np.ptp(across[triangles], axis=1) < SIDE * AROUND / 2
    levels = np.linspace(0, truth[near].max(), 8)[1:]
    figure, both = plt.subplots(1, 2, figsize=(9, 4.4), layout="constrained")
    for axes, method in zip(both, ("exact", "heat")):
        found = polydec.geodesic_distance(mesh, [source], method=method)
        error = np.abs(found - truth)[near].max() / truth[near].max()
        axes.triplot(across, up, triangles[whole], color="0.8", linewidth=0.4, antialiased=False)
        if method == "exact":
            lines, _ = polydec.SurfacePaths(mesh, [source]).isolines(levels)
            axes.add_collection(LineCollection(unrolled(lines) - (0, points[source, 2])))
        else:
            axes.tricontour(across, up, triangles[whole], found, levels=levels, colors="C0")
        for radius in levels:
            axes.add_patch(plt.Circle((0, 0), radius, fill=False, color="C1", linestyle=":"))
        axes.set_title(f"{method}: at most {100 * error:.2g} % off", fontsize=10)
        axes.set(aspect="equal", xlim=(across.min(), across.max()), ylim=(up.min(), up.max()))
        axes.set_axis_off()
    figure.savefig(sys.argv[1], dpi=100, metadata={"Software": None})


if __name__ == "__main__":
    main()
