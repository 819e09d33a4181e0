// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/discretization.h"

namespace polydec::fuzz {

/// What `polydec info` tells, and what else holds of every mesh that was accepted.
void require_laws(const Discretization& mesh);

/// Poisson's equation has a finite solution or a refusal that can be read.
void require_poisson(const Discretization& mesh);

} // namespace polydec::fuzz
