// SPDX-License-Identifier: MIT
#pragma once

#include "base/printable.h"
#include "tools/answer.h"

#include <cstdint>
#include <string>
#include <utility>

/// The reports on files that several processes write as one does.
namespace polydec::tools {

class Merged : public Answer {
public:
    /// The numbers of n-cells before and after merging.
    Merged(std::string out, int dimension, std::int64_t input, std::int64_t merged)
        : out_(std::move(out)), dimension_(dimension), input_(input), merged_(merged) {}

    void write(JsonWriter& json) const override {
        json.member("out", out_);
        json.member("dimension", dimension_);
        json.object("cells", [&] {
            json.member("input", input_);
            json.member("merged", merged_);
        });
    }
    void write(Text& text) const override {
        text("{}: {} cells of dimension {} merged into {}\n", printable(out_), input_, dimension_,
             merged_);
    }

private:
    std::string out_;
    int dimension_;
    std::int64_t input_, merged_;
};

class Operators : public Answer {
public:
    Operators(std::string out, int dimension) : out_(std::move(out)), dimension_(dimension) {}

    void write(JsonWriter& json) const override {
        json.member("out", out_);
        json.member("dimension", dimension_);
    }
    void write(Text& text) const override {
        text("operators of degrees 0 .. {} written to {}\n", dimension_, printable(out_));
    }

private:
    std::string out_;
    int dimension_;
};

} // namespace polydec::tools
