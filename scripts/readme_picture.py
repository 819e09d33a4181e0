#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Takes the picture of README.md, docs/images/fandisk.png, from two pages: the merged fandisk, and a
mode with its eigenvalue and colors.

    scripts/readme_picture.py build/release fandisk.off

`./demo` fetches the fandisk. Needs what gallery.py needs for pictures, and python3-matplotlib.
"""
import sys
import tempfile
from pathlib import Path

import matplotlib.image
import numpy as np

import gallery
from gallery_entries import LEFT, Entry

VIEW = (LEFT,) * 4 + ("+",) * 3
SHOWN = (
    Entry("merged", "", "", ("polydec view {mesh} -o merged.html",), "merged.html",
          {"edges": True}, VIEW),
    Entry("mode", "", "", ("polydec spectrum {mesh} --side dual --degree 0 --count 20 -o mode.html",),
          "mode.html", {"field": "5", "edges": False}, VIEW),
)


def main(build, mesh):
    programs = {"polydec": build.resolve() / "tools"}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        driver = gallery.browser()
        try:
            for entry in SHOWN:
                for line in entry.lines:
                    gallery.run(line.format(mesh=mesh.resolve()), programs, folder)
                gallery.take_picture(driver, folder / entry.page, entry, folder / f"{entry.name}.png")
        finally:
            driver.quit()
        pictures = [matplotlib.image.imread(folder / f"{entry.name}.png") for entry in SHOWN]
    height = max(picture.shape[0] for picture in pictures)
    white = [np.pad(picture, ((0, height - picture.shape[0]), (0, 0), (0, 0)), constant_values=1)
             for picture in pictures]
    matplotlib.image.imsave(gallery.ROOT / "docs/images/fandisk.png", np.hstack(white))


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:3]))
