// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/generate_boxes.h"
#include "meshes/generate_clusters.h"
#include "meshes/generate_d4.h"
#include "meshes/generate_goldberg.h"
#include "meshes/generate_lattices.h"
#include "meshes/generate_planar.h"
#include "meshes/generate_spheres.h"
#include "meshes/generate_surfaces.h"
