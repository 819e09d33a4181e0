# SPDX-License-Identifier: MIT
"""A long run that may be killed at any time. After a restart it resumes from its last checkpoint,
with bitwise identical results."""
import polydec


def run(times: list[float]) -> None:
    sphere = polydec.discretize(polydec.meshes.goldberg(8))
    z = sphere.points[:, 2]
    heat = polydec.Evolution(sphere, z, diffusion=1.0)
    for time, u in heat.frames(times, checkpoint="run.checkpoint"):
        print(f"at {time:g} there is {sphere.norm(u, 0) / sphere.norm(z, 0):g}")


run([0.1, 0.2]) # and is killed
run([0.1, 0.2, 0.3, 0.4])
