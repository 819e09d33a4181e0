// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <utility>

namespace polydec {

/// A value computed on first use, and kept. Thread-safe; if the computation throws, the next call
/// tries again.
template <class T>
class Lazy {
public:
    Lazy() = default;

    /// Already computed.
    explicit Lazy(T value) : is_made_(true), value_(std::make_unique<const T>(std::move(value))) {}

    /// make() returns a T.
    template <class Make>
    const T& get(Make make) const {
        if (!is_made_.load(std::memory_order_acquire)) {
            // not call_once, through which glibc cannot unwind when memory is short
            const std::lock_guard lock(making_);
            if (!value_)
                value_ = std::unique_ptr<const T>(new const T(make())); // in place: T may not move
            is_made_.store(true, std::memory_order_release);
        }
        return *value_;
    }

private:
    mutable std::mutex making_;
    mutable std::atomic<bool> is_made_ = false;
    mutable std::unique_ptr<const T> value_;
};

} // namespace polydec
