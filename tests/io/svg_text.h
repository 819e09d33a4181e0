// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/test.h"

namespace polydec::test {

/// What is wrong with the tags of an XML text; "" if each that opens closes, attributes are quoted
/// and & begins an entity.
std::string flaw(const std::string& text);

/// How often a part stands in a text.
std::size_t count(const std::string& text, const std::string& part);

/// The numbers of the first attribute of this name behind a mark.
std::vector<double> numbers_behind(const std::string& text, const std::string& mark,
                                   const std::string& attribute);

} // namespace polydec::test
