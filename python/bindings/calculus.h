// SPDX-License-Identifier: MIT
#pragma once

#include "dec/boundary/form_space.h"

#include <optional>

namespace polydec::python {

/// None: the built-in ones.
using GivenConditions = std::optional<BoundaryConditions>;

/// The forms of a side and degree under these conditions.
FormSpace space_of(const Cells& cells, Side side, int degree, const GivenConditions& conditions);

} // namespace polydec::python
