# SPDX-License-Identifier: MIT
import polydec

sphere = polydec.discretize(polydec.meshes.icosphere(16))
distance = polydec.geodesic_distance(sphere, [0, 5])
print(f"farthest {distance.max():g}, mean {distance.mean():g}")
