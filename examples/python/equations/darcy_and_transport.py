# SPDX-License-Identifier: MIT
"""Darcy flow from left to right carries salt into a porous rock of hexagons."""
import numpy as np

import polydec

rock = polydec.discretize(polydec.meshes.hexagons(32))
ends = lambda x: (x[:, 0] < 1e-9) | (x[:, 0] > 1 - 1e-9)
flow = polydec.poisson(rock, 0.0, lambda x: 1 - x[:, 0], side="dual", essential=ends).flux
transport = polydec.FluxTransport(rock)
salt, salty = np.zeros(rock.size(2)), np.ones(rock.size(1))
came, time, dt = 0.0, 0.0, 0.9 * transport.stable_step(flow)
while time < 0.5:
    came -= dt * transport.outflow(transport.mass_flux(flow, salt, salty))
    salt += dt * transport.rate(flow, salt, salty)
    time += dt
print(f"salt that came {came:g}, and is there {transport.mass(salt):g}")
