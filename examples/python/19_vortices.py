# SPDX-License-Identifier: MIT
"""Euler's equations on a sphere of hexagons, and on a torus of quads with a flow around its hole.
Vortices meet; energy, circulation and zero divergence are preserved to rounding."""
import numpy as np
import numpy.typing as npt

import polydec

Floats = npt.NDArray[np.float64]


def march(name: str, mesh: polydec.Complex, around: float, steps: int) -> None:
    flow = polydec.IncompressibleFlow(mesh)
    x, y, z = mesh.points.T
    vorticity = 4 * sum(np.exp(-15 * ((x - 1) ** 2 + (y - at) ** 2 + z * z)) for at in (0.3, -0.3))
    r2 = x * x + y * y + 1e-9
    w = polydec.flow_of_vorticity(mesh, vorticity)
    if around != 0:
        w += around * polydec.flow_of_velocity(mesh, np.column_stack([-y / r2, x / r2, 0 * z]))
    w = flow.project(w)

    def harmonic_part(w: Floats) -> float:
        part = polydec.hodge_decomposition(mesh, mesh.cochain(w, 1)).harmonic
        return float(np.sqrt(2 * flow.energy(part)))

    energy, size = flow.energy(w), abs(flow.circulations(w)).sum()
    harmonic = harmonic_part(w) if around != 0 else 0.0
    dt = 0.4 * flow.exchange_time(w)
    drift = 0.0
    for _, w in polydec.Flow(flow, w, dt).frames(dt * np.arange(1, steps + 1)):
        drift = max(drift, abs(flow.energy(w) / energy - 1))
    print(f"{name}, {steps} steps to the time {steps * dt:g}: energy off by {drift:g}, circulation "
          f"by {abs(flow.circulations(w).sum()) / size:g}, divergence {flow.divergence(w):g}", end="")
    if around != 0:
        print(f", harmonic part from {harmonic:g} to {harmonic_part(w):g}", end="")
    print("; kept" if drift < 1e-10 else "; lost")


march("sphere", polydec.discretize(polydec.meshes.goldberg(6)), 0.0, 50)
march("torus", polydec.discretize(polydec.meshes.torus(32, 16)), 0.3, 50)
