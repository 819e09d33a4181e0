# SPDX-License-Identifier: MIT
"""Light in an open plane. The electric field is perpendicular to the plane, so it is a 0-form, and
a pulse leaves in all directions. A layer of ten squares around the domain absorbs it. The
reflection is the difference from a plane too large for any reflection. Then a current radiates
beside a rod of glass, in which light is half as fast."""
import numpy as np
import numpy.typing as npt

import polydec

Floats = npt.NDArray[np.float64]

layer, step = 10.0, 0.6 # squares have side 1, light has speed 1


def plane(half: int) -> polydec.Complex:
    mesh = polydec.meshes.kuhn([2 * half, 2 * half], [2.0 * half, 2.0 * half])
    return polydec.discretize((mesh.points - half, mesh.simplices))


def hill(mesh: polydec.Complex, x: float, width: float) -> Floats:
    far = ((mesh.points - [x, 0]) ** 2).sum(axis=1)
    return np.asarray(np.exp(-far / width ** 2))


def run(half: int, width: float) -> Floats:
    """The field in the middle over time, and everywhere at the end."""
    mesh = plane(half)
    light = polydec.Waves(mesh, hill(mesh, 0, 3), time_step=step, essential=True, layer=width)
    middle = abs(mesh.points).max(axis=1) < 20
    return np.concatenate([E[middle] for _, E, _ in light.frames(step * np.arange(1, 101))])


def rod() -> None:
    mesh = plane(30)
    mesh = mesh.with_material(0, lambda x: np.where(np.linalg.norm(x, axis=1) < 8, 4.0, 1.0))
    antenna = hill(mesh, -14, 1.5)
    light = polydec.Waves(
        mesh, 0 * antenna, time_step=step, essential=True, layer=layer,
        source=lambda t: np.sin(0.5 * t) * np.exp(-((t - 30) / 15) ** 2) * antenna)
    energies = [light.energy for _ in light.frames(step * np.arange(1, 335))]
    left = 100 * (1 - energies[-1] / max(energies))
    print(f"with a glass rod {left:g} % of the energy has left")


open_plane, wide = run(30, layer), run(64, 0.0)
back = abs(open_plane - wide).max() / abs(wide).max()
print(f"{back:g} of the pulse comes back: {'less than 1e-4' if back < 1e-4 else 'too much'}")
rod()
