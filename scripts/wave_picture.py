#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws the moving picture of README.md, docs/images/wave.gif: a wave that starts as a bump on a torus
of split quads, which are merged first. With the package for Python, matplotlib and Pillow:

    PYTHONPATH=build/release/python scripts/wave_picture.py docs/images/wave.gif
"""
import io
import sys

import matplotlib
import numpy as np
from PIL import Image

import polydec

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

FRAMES, UNTIL = 36, 4.4
COLORS = plt.get_cmap("RdBu_r", 31)  # few, and no smooth lines: small files


def picture(figure):
    data = io.BytesIO()
    figure.savefig(data, format="png")
    return Image.open(data).convert("RGB")


def frames():
    torus = polydec.discretize(polydec.meshes.torus(56, 28))
    bump = np.exp(-12 * np.sum((torus.points - [0.6, -0.8, 0.4]) ** 2, axis=1))
    waves = polydec.Waves(torus, bump)
    figure = plt.figure(figsize=(4.2, 2.8), dpi=100)
    axes = figure.add_axes([-0.1, -0.37, 1.2, 1.74], projection="3d")
    drawn = polydec.plot(torus, bump, ax=axes, cmap=COLORS, edgecolor="#7a828c", linewidth=0.5,
                         antialiased=False, clim=(-0.3, 0.3), bar=None).collections[-1]
    axes.view_init(48, -60)
    axes.set_axis_off()
    corners = torus.cells(2)
    for _, u, _ in waves.frames(np.linspace(0, UNTIL, FRAMES + 1)[:-1]):
        means = np.add.reduceat(u[corners.corners], corners.offsets[:-1])
        drawn.set_array(means / np.diff(corners.offsets))
        yield picture(figure)


def main():
    shown = list(frames())
    palette = Image.fromarray(np.vstack([np.asarray(frame) for frame in shown])).quantize(36)
    first, *rest = (frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in shown)
    first.save(sys.argv[1], save_all=True, append_images=rest, duration=90, loop=0, optimize=True)


if __name__ == "__main__":
    main()
