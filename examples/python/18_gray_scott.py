# SPDX-License-Identifier: MIT
"""Dividing spots: the Gray-Scott reaction of two diffusing substances on a sphere of hexagons and
12 pentagons, with one value per cell. Diffusion is implicit, so the pattern alone limits the steps,
not the mesh."""
import numpy as np
import numpy.typing as npt

import polydec

Floats = npt.NDArray[np.float64]

feed, kill, fastness = 0.0367, 0.0649, 3.2e-4


def reaction(t: float, u: Floats, v: Floats) -> tuple[Floats, Floats]:
    return -u * v * v + feed * (1 - u), u * v * v - (feed + kill) * v


def spots(mesh: polydec.Cells, v: Floats) -> int:
    """Number of local maxima of a substance above a threshold."""
    beside = (abs(mesh.d(1)) @ abs(mesh.d(1)).T).tocsr()
    highest = np.zeros(len(v))
    for cell in range(len(v)):
        others = beside.indices[beside.indptr[cell]:beside.indptr[cell + 1]]
        highest[cell] = v[others[others != cell]].max()
    return int((v > np.maximum(highest, 0.15)).sum())


mesh = polydec.discretize(polydec.meshes.goldberg(16))
x, y, z = mesh.centers(2).T
seeds = np.sin(9 * x + 1) * np.sin(8 * y + 2) * np.sin(7 * z) > 0.4
u, v = np.where(seeds, 0.5, 1.0), np.where(seeds, 0.25, 0.0)
pattern = polydec.Evolution(mesh, [u, v], side="dual", diffusion=[fastness, fastness / 2],
                            reaction=reaction, relative_tolerance=1e-3, absolute_tolerance=1e-5)
with polydec.Series("gray_scott.pvd", mesh) as series:
    for time, u, v in pattern.frames([150.0 * frame for frame in range(1, 21)]):
        series.add(time, {"v": v}, degree=0, side="dual")
report = pattern.report
print(f"{mesh.size(2)} cells, {report['steps']} steps of {pattern.time / report['steps']:g} in the "
      f"mean, {report['preparations']} factorizations; {spots(mesh, v)} spots")
polydec.view(mesh, {"v": v}, degree=0, side="dual", title="Spots that divide").save(
    "gray_scott.html")
