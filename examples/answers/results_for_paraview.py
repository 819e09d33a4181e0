# SPDX-License-Identifier: MIT
import polydec

square = polydec.discretize(polydec.meshes.grid(16, 16))
u = polydec.poisson(square, 1.0, side="dual")
polydec.write_vtu("u.vtu", square, {"u": u.form})
print(f"largest value {u.values.max():g}")
