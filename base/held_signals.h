// SPDX-License-Identifier: MIT
#pragma once

#include <csignal>

namespace polydec {

/// While it lives, the signals that ask the program to end (ending_signals) wait, so that what was
/// begun can be undone in plain code instead of in a handler. One that came is delivered when the
/// object goes; signals that are ignored go on being ignored. May be nested. It holds them back
/// from its own thread alone: in a program of several threads the others should block them too, or
/// end in order.
class HeldSignals {
public:
    HeldSignals() noexcept;
    ~HeldSignals();
    HeldSignals(const HeldSignals&) = delete;
    HeldSignals& operator=(const HeldSignals&) = delete;

    /// Whether one waits: the work should be given up.
    bool arrived() const noexcept;

private:
    sigset_t held_;
    sigset_t before_;
};

} // namespace polydec
