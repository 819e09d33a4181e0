// SPDX-License-Identifier: MIT
#pragma once

#include "base/errors.h"

#include <string>

namespace polydec::test {

/// The message of the InvalidInput that a call throws; "accepted" if it throws nothing.
template <class Call>
std::string refusal(Call call) {
    try {
        call();
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "accepted";
}

} // namespace polydec::test
