// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

/// The modules of the optional engines, NAME.so for the engines NAME and NAME.anything, in the
/// folder that POLYDEC_ENGINES names; without it, in polydec/ beside a shared polydec or in the
/// lib/ beside the program's bin/, and where polydec was to be installed.
namespace polydec {

/// Loads the module that an engine of that name would be in, if there is one that was not tried
/// yet. Engines of names that are taken are passed over. Whatever fails is kept for why_missing().
void load_module_of(const std::string& engine);

/// The same for every module there is.
void load_all_modules();

/// Why the module of that engine could not be loaded; empty if it could, or if there is none.
std::string why_missing(const std::string& engine);

} // namespace polydec
