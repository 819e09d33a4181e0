// SPDX-License-Identifier: MIT
#pragma once

#include "base/printable.h"
#include "tools/answer.h"

#include <cstdint>
#include <string>

/// The reports on files that several processes write as one does.
namespace polydec::tools {

/// With the numbers of n-cells before and after merging.
inline Answer merged(const std::string& out, int dimension, std::int64_t input,
                     std::int64_t merged) {
    return {[=](JsonWriter& json) {
                json.member("out", out);
                json.member("dimension", dimension);
                json.object("cells", [&] {
                    json.member("input", input);
                    json.member("merged", merged);
                });
            },
            [=](Text& text) {
                text("{}: {} cells of dimension {} merged into {}\n", printable(out), input,
                     dimension, merged);
            }};
}

inline Answer operators(const std::string& out, int dimension) {
    return {[=](JsonWriter& json) {
                json.member("out", out);
                json.member("dimension", dimension);
            },
            [=](Text& text) {
                text("operators of degrees 0 .. {} written to {}\n", dimension, printable(out));
            }};
}

} // namespace polydec::tools
