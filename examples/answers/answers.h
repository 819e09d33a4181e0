// SPDX-License-Identifier: MIT
#pragma once

#include <exception>
#include <initializer_list>
#include <iostream>

namespace answers {

/// An answer of docs/answers: the name of its page, and its code.
struct Answer {
    const char* name;
    void (*give)();
};

/// Prints each answer behind a line with its name. Returns 1 if one throws, else 0.
inline int print(std::initializer_list<Answer> all) {
    int wrong = 0;
    for (const Answer& answer : all)
        try {
            std::cout << "== " << answer.name << '\n';
            answer.give();
        } catch (const std::exception& error) {
            std::cout << error.what() << '\n';
            wrong = 1;
        }
    return wrong;
}

} // namespace answers
