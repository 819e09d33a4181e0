// SPDX-License-Identifier: MIT
#pragma once

#include "dec/conditioned_complex.h"

#include <optional>

namespace polydec::python {

/// None: the built-in ones.
using GivenConditions = std::optional<BoundaryConditions>;

} // namespace polydec::python
