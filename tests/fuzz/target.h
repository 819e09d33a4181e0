// SPDX-License-Identifier: MIT
#pragma once

#include "base/errors.h"

#include <stdexcept>
#include <string>
#include <string_view>

namespace polydec::fuzz {

/// Something that eats bytes from anywhere. It returns, whatever they are, unless a promise of
/// polydec does not hold: then it throws, or a sanitizer ends the program.
struct Target {
    std::string_view name;
    void (*run)(std::string_view bytes);
};

/// A promise that does not hold.
class Finding : public std::logic_error {
public:
    using std::logic_error::logic_error;
};

/// Throws a Finding that says `promise` unless it holds.
inline void require(bool holds, const std::string& promise) {
    if (!holds)
        throw Finding(promise);
}

/// Whether `text` can be shown to a person: printable, a few lines, of bounded length.
void require_message(std::string_view text);

/// Whether a call takes what it is given; the only other way out is a Refusal with a message.
template <class Refusal = InvalidInput, class Call>
bool accepts(Call call) {
    try {
        call();
        return true;
    } catch (const Refusal& error) {
        require_message(error.what());
        return false;
    }
}

} // namespace polydec::fuzz
