// SPDX-License-Identifier: MIT
#pragma once

#include "dec/boundary/form_space.h"

#include <optional>
#include <string>

namespace polydec::python {

/// None: the built-in ones.
using GivenConditions = std::optional<BoundaryConditions>;

/// The forms of a side, by its name, and degree under these conditions.
FormSpace space_of(const Cells& cells, const std::string& side, int degree,
                   const GivenConditions& conditions);

} // namespace polydec::python
