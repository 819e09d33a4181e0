// SPDX-License-Identifier: MIT
#pragma once

#include <csignal>

namespace polydec {

/// During its lifetime, signals that request the program's end (ending_signals) wait, so that work
/// in progress can be undone in plain code instead of in a handler. The destructor delivers a
/// pending signal; ignored signals stay ignored. May be nested. It blocks signals for its own
/// thread only: other threads should block them too, or end in order.
class HeldSignals {
public:
    HeldSignals() noexcept;
    ~HeldSignals();
    HeldSignals(const HeldSignals&) = delete;
    HeldSignals& operator=(const HeldSignals&) = delete;

    /// Whether a signal is pending: the work should be abandoned.
    bool arrived() const noexcept;

private:
    sigset_t held_;
    sigset_t before_;
};

} // namespace polydec
