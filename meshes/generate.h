// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/generate_goldberg.h"
#include "meshes/generate_lattices.h"
#include "meshes/generate_planar.h"
#include "meshes/generate_spheres.h"
#include "meshes/generate_surfaces.h"
