// SPDX-License-Identifier: MIT
#pragma once

#include <string>

/// The modules of the optional engines, NAME.so for the engines NAME and NAME.anything, in the
/// folder POLYDEC_ENGINES; without it, in polydec/ or engines/ beside a shared polydec or the
/// program, in the lib/ beside the program's bin/, in polydec/ in a folder searched by the loader
/// (such as the run path of a program with a static polydec), and in the configured installation
/// folder.
namespace polydec {

/// Loads the module for an engine of this name, if it exists and was not tried before. Skips
/// engines with names already taken. Errors are kept for why_missing().
void load_module_of(const std::string& engine);

/// The same for every module.
void load_all_modules();

/// Why the engine's module could not be loaded; empty if it was loaded, or does not exist.
std::string why_missing(const std::string& engine);

} // namespace polydec
