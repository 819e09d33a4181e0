// SPDX-License-Identifier: MIT
#pragma once

#include "base/errors.h"
#include "tests/support/says.h"

#include <string>

namespace polydec::test {

/// The message of the Error that a call throws; "accepted" if it throws nothing.
template <class Error, class Call>
std::string message_of(Call&& call) {
    try {
        call();
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

/// The message of the InvalidInput that a call throws; "accepted" if it throws nothing.
template <class Call>
std::string refusal(Call&& call) {
    return message_of<InvalidInput>(call);
}

/// Expects a call to throw an Error with these words in its message, in this order.
#define EXPECT_ERROR(Error, call, ...)                                                             \
    EXPECT_SAYS(::polydec::test::message_of<Error>([&] { call; }), __VA_ARGS__)

/// The same for InvalidInput.
#define EXPECT_REFUSED(call, ...) EXPECT_ERROR(::polydec::InvalidInput, call, __VA_ARGS__)

} // namespace polydec::test
