# SPDX-License-Identifier: MIT
"""Heat and waves in 1, 2, 3 and 4 dimensions; no line depends on the dimension. With u = 0 at the
walls, the product of sin(pi x_i) cools as exp(-n pi^2 t), and has wave period 2 / sqrt(n)."""
import numpy as np
import numpy.typing as npt

import polydec

Floats = npt.NDArray[np.float64]


def run(n: int, cells: int) -> None:
    box = polydec.discretize(polydec.meshes.kuhn([cells] * n))
    space = polydec.FormSpace(box, essential=True)
    inside = space.inside
    start = space.restrict(np.prod(np.sin(np.pi * box.points), axis=1))

    def amplitude(u: Floats) -> float:
        return inside.inner_product(start, u, 0) / inside.inner_product(start, start, 0)

    cooled = polydec.heat(inside, start, 0.001, 50, integrator="implicit-midpoint")
    rate = -np.log(amplitude(cooled)) / 0.05 / (n * np.pi ** 2)

    # half a period reverses the sign of the wave
    half = 1 / np.sqrt(n)
    swing, _ = polydec.wave(inside, start, half)

    print(f"n = {n}: {box.input.size(n)} simplices, {box.size(n)} cells; rate of cooling {rate:g} "
          f"of the exact one; after half a period {amplitude(swing):g}")


for n, cells in enumerate([64, 32, 16, 8], start=1):
    run(n, cells)
