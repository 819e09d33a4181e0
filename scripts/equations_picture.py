#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws docs/images/equations.png: what three of the equations on docs/equations.md look like, on finer
meshes, with the package for Python and matplotlib:

    PYTHONPATH=build/release/python scripts/equations_picture.py docs/images/equations.png
"""
import sys

import matplotlib
import numpy as np

import polydec

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


def spots():
    """Gray and Scott's second substance on hexagons."""
    sphere = polydec.discretize(polydec.meshes.goldberg(24))
    seeds = np.where(np.prod(np.sin(8 * sphere.points), axis=1) > 0.3, 1.0, 0.0)
    run = polydec.Evolution(
        sphere, [1 - seeds / 2, seeds / 4], diffusion=[3.2e-4, 1.6e-4], relative_tolerance=1e-3,
        absolute_tolerance=1e-5,
        reaction=lambda t, u, v: (0.0367 * (1 - u) - u * v * v, u * v * v - 0.1016 * v))
    run.march(1500.0)
    return sphere, run.forms[1]


def vortices():
    """The vorticity of two vortices of one sign that wind around each other."""
    sphere = polydec.discretize(polydec.meshes.goldberg(24))
    x, y, z = sphere.points.T
    vorticity = sum(np.exp(-30 * ((y - at) ** 2 + z * z)) * (x > 0) for at in (0.25, -0.25))
    flow = polydec.IncompressibleFlow(sphere, viscosity=3e-4)
    w = flow.project(polydec.flow_of_vorticity(sphere, 10 * vorticity))
    vortices = polydec.Flow(flow, w, 0.02, scheme="imex")
    vortices.march(2.0)
    return sphere, flow.vorticity(vortices.forms[0])


def light():
    """The current's magnetic flux through squares, in the plane, as it runs into the layer."""
    square = polydec.discretize(polydec.meshes.grid(80, 80))
    ring = polydec.de_rham(square, 1, lambda x: (x - 0.5) @ [[0, 1], [-1, 0]] * np.exp(
        -400 * ((x - 0.5) ** 2).sum(axis=1, keepdims=True)))
    waves = polydec.Waves(square, 0 * ring, time_step=0.008, essential=True, layer=0.15,
                          source=lambda t: np.sin(60 * t) * ring)
    waves.march(70 * 0.008)
    return square, waves.forms[1]


def main():
    figure = plt.figure(figsize=(10.5, 3.8))
    panels = [("Spots that divide", "3d", spots, 0, "magma"),
              ("Two vortices that merge", "3d", vortices, 0, "RdBu"),
              ("Light on its way into an absorbing layer", None, light, 2, "RdBu")]
    for i, (title, kind, made, degree, colors) in enumerate(panels):
        axes = figure.add_subplot(1, 3, i + 1, projection=kind)
        mesh, values = made()
        bounds = {"clim": (-abs(values).max(), abs(values).max())} if colors == "RdBu" else {}
        polydec.plot(mesh, values, degree=degree, ax=axes, cmap=colors, linewidth=0.1, bar=None,
                     **bounds)
        figure.text((2 * i + 1) / 6, 0.95, title, ha="center", fontsize=10)
        axes.set_axis_off()
        if kind:
            axes.view_init(0, 0)
            axes.set_box_aspect((1, 1, 1), zoom=1.5)
        else:
            axes.set_aspect("equal")
    figure.subplots_adjust(0.01, 0.01, 0.99, 0.9, wspace=0.05)
    figure.savefig(sys.argv[1], dpi=90)


if __name__ == "__main__":
    main()
