# SPDX-License-Identifier: MIT
import numpy as np
import polydec

rock = polydec.discretize("plate.msh", materials="keep_apart")
kappa = rock.cochain(np.where(rock.tags == 4, 10.0, 1.0), 0, "dual")
flow = polydec.poisson(rock, 0.0, {"hot": 1.0}, side="dual", essential=["hot", "cold"],
                       conductivity=kappa)
through = abs(flow.flux.values[rock.facets_in("cold")]).sum()
print(f"through the right side: {through:g}") # 1 / (1/2 / 10 + 1/2 / 1)
