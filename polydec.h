// SPDX-License-Identifier: MIT
#pragma once

#include "base/errors.h"
#include "base/types.h"
#include "meshes/mesh.h"
