// SPDX-License-Identifier: MIT
#pragma once

#include "solvers/evolution.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace polydec {

/// Marches to each of these times, ascending, like Evolution::march, shows what is there and then
/// keeps it in a checkpoint. Where there is one already it goes on from that, to the times behind
/// it alone, or nowhere if an event had ended it: to the same bits if the integrator resumes
/// exactly. What was killed in between shows a time again. problem is the fingerprint of what the
/// checkpoint belongs to.
/// Throws like read_checkpoint, write_checkpoint, Evolution::resume and Evolution::march.
Arrival kept_march(Evolution& run, const std::vector<double>& times,
                   const std::filesystem::path& checkpoint, std::uint64_t problem,
                   const std::function<void(const Evolution&)>& show = {});

} // namespace polydec
