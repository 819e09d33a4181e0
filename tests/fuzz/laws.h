// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/discretization.h"

namespace polydec::fuzz {

/// d d = 0, and the Betti numbers give the Euler characteristic.
void require_topology(const CellComplex& complex);

/// What `polydec info` tells, and what else holds of every mesh that was accepted.
void require_laws(const Discretization& mesh);

/// Poisson's equation has a finite solution or a refusal that can be read.
void require_poisson(const Discretization& mesh);

} // namespace polydec::fuzz
