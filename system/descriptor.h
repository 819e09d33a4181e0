// SPDX-License-Identifier: MIT
#pragma once

#include <unistd.h>
#include <utility>

namespace polydec {

/// The descriptor of an open file, closed by the destructor; -1: none.
class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    ~Descriptor() { close(); }
    int number() const { return number_; }
    void close() {
        if (number_ >= 0)
            ::close(number_);
        number_ = -1;
    }

private:
    int number_;
};

} // namespace polydec
