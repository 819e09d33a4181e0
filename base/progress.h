// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string_view>

namespace polydec {

/// Called with a description of each step, or from time to time; it may be empty. An exception from
/// it ends the computation.
using Progress = std::function<void(std::string_view)>;

} // namespace polydec
