# SPDX-License-Identifier: MIT
import polydec

sphere = polydec.discretize(polydec.meshes.goldberg(8))
for times in ([0.1, 0.2], [0.1, 0.2, 0.3]): # is killed, and run again: does what is missing
    heat = polydec.Evolution(sphere, sphere.points[:, 2], diffusion=1.0)
    for time, u in heat.frames(times, checkpoint="run.checkpoint"):
        print(f"at {time:g} the largest value is {u.max():g}")
