// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

namespace polydec {

/// Torus around the z axis: `major` times `minor` planar trapezoids, each split by a diagonal.
/// Outward orientation. Vertex (i, j), i around the axis, has the number i minor + j.
/// Throws InvalidInput unless major, minor >= 3, 0 < minor_radius < major_radius.
Mesh torus(int major, int minor, double major_radius = 1.0, double minor_radius = 0.4);

/// Moebius strip in R^3 with the center line of radius 1: `around` times `across` quads, split;
/// not orientable. Throws InvalidInput unless around >= 3, across >= 1, 0 < width < 2.
Mesh moebius(int around, int across, double width = 0.6);

/// A machine part, closed, genus 1, oriented outward: a round flange (radius 1, 0.2 thick) with a
/// hub, beveled by a cone, and a bore of radius 0.3 along the z axis. A stepped profile is
/// revolved in `segments` steps, so that every face is a rectangle or an isosceles trapezoid,
/// nearly square, split by a diagonal. Throws InvalidInput unless segments >= 3.
Mesh flange(int segments);

} // namespace polydec
