# SPDX-License-Identifier: MIT
"""Laplacian eigenvalues on the unit sphere are l (l + 1), with multiplicity 2 l + 1. Every spectrum
is proved complete, for values at vertices and for values in hexagons and pentagons."""
import polydec

sphere = polydec.discretize(polydec.meshes.goldberg(8))
for side in ("primal", "dual"):
    modes = polydec.spectrum(sphere, side=side, count=16)
    proof = modes.certificate
    print(f"{side} 0-forms, {proof.below_shift} eigenvalues below {proof.shift:g} by inertia, "
          f"{proof.returned_below_shift} computed")
    for l in range(4):
        band = modes.eigenvalues[l * l:(l + 1) ** 2]
        print(f"  l = {l}: {2 * l + 1} eigenvalues from {band[0]:g} to {band[-1]:g}, "
              f"exact {l * (l + 1)}")
