#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws docs/images/vortex_street.png: the vorticity behind the cylinder of
examples/python/22_vortex_street.py, on finer quads, with the package for Python and matplotlib:

    PYTHONPATH=build/release/python scripts/vortex_street_picture.py docs/images/vortex_street.png
"""
import sys
from pathlib import Path

import matplotlib

import polydec

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

EXAMPLE = Path(__file__).resolve().parents[1] / "examples" / "python" / "22_vortex_street.py"
COARSE, FINE = "around, far, reynolds, until = 32, 30.0, 100.0, 40.0", (96, 30.0, 100.0, 60.0)


def main():
    code = EXAMPLE.read_text(encoding="utf-8")
    if COARSE not in code:
        sys.exit(f"{EXAMPLE}: the line `{COARSE}` is not there any more")
    names = {}
    exec(code.replace(COARSE, f"around, far, reynolds, until = {FINE}"), names)
    mesh, flow, w = names["mesh"], names["flow"], names["w"]
    figure, axes = plt.subplots(figsize=(10, 3.2))
    polydec.plot(mesh, flow.vorticity(w), degree=0, ax=axes, cmap="RdBu", linewidth=0.1,
                 bar=None, clim=(-2, 2))
    axes.add_patch(plt.Circle((0, 0), 0.5, color="0.3"))
    axes.set(xlim=(-1.5, 11), ylim=(-2, 2), aspect="equal")
    axes.set_axis_off()
    figure.subplots_adjust(0, 0, 1, 1)
    figure.savefig(sys.argv[1], dpi=90)


if __name__ == "__main__":
    main()
