# SPDX-License-Identifier: MIT
"""A pulse of light in a box with conducting walls: Maxwell's equations with the electric field on
edges, the magnetic flux through faces, and leapfrog in time. On cubes this is Yee's scheme."""
import numpy as np
import numpy.typing as npt

import polydec

Floats = npt.NDArray[np.float64]


def run(name: str, mesh: polydec.Mesh) -> None:
    box = polydec.discretize(mesh, star="circumcentric")
    space = polydec.FormSpace(box, 1, essential=True)
    steps = int(np.ceil(0.4 / (0.9 * polydec.stable_step(space.inside, 1))))

    # initially a vertical field in the middle of the box; light has speed 1
    def pulse(p: Floats) -> Floats:
        strength = np.exp(-((p - 0.5) ** 2).sum(axis=1) / 0.01)
        return np.outer(strength, [0, 0, 1])

    E = space.restrict(polydec.de_rham(box, 1, pulse))
    light = polydec.Waves(space.inside, E, degree=1, time_step=0.4 / steps)
    begin, drift = light.energy, 0.0
    for _, E, _ in light.frames(light.time_step * np.arange(1, steps + 1)):
        drift = max(drift, abs(light.energy / begin - 1))
    print(f"{name}: {len(E)} edges, {steps} steps, energy "
          f"{'kept to rounding' if drift < 1e-12 else 'lost'}")

    vertical = polydec.sharp_pd(box, space.extend(E))[:, 2]
    polydec.view(box, {"E_z": vertical}, degree=3,
                 title="A pulse at time 0.4: E upwards").save(f"{name}.html")


run("pulse_on_cubes", polydec.meshes.kuhn([16, 16, 16]))
run("pulse_on_octahedra", polydec.meshes.fcc(10))
